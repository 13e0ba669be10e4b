// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/trouble_words.h"

#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

QString TroubleWords::often(const practice::HardCharacter& hard) {
  using Kind = kanji::MistakeKind;
  const QString character = to_text(hard.character);
  if (!hard.stroke) return tr("%1 is often forgotten.").arg(character);
  const auto sentence = [&](const QString& words) {
    return words.arg(hard.stroke->stroke + 1).arg(character);
  };
  switch (hard.stroke->kind) {
    case Kind::order:
      return sentence(tr("Stroke %1 of %2 is often out of order."));
    case Kind::reversed:
      return sentence(tr("Stroke %1 of %2 is often written backwards."));
    case Kind::missing:
      return sentence(tr("Stroke %1 of %2 is often left out."));
    case Kind::joined:
      return sentence(tr("Stroke %1 of %2 is often joined to another one."));
    case Kind::split:
      return sentence(tr("Stroke %1 of %2 is often written in pieces."));
    case Kind::extra:
      return tr("%1 often gets one stroke too many.").arg(character);
    case Kind::other:
      return tr("%1 is often mistaken for another character.").arg(character);
    case Kind::wrong:
    case Kind::ending:
      break;
  }
  return sentence(tr("Stroke %1 of %2 often has the wrong shape or position."));
}

QString TroubleWords::counted(const practice::StrokeTrouble& trouble) {
  using Kind = kanji::MistakeKind;
  const auto sentence = [&](const QString& words) {
    return words.arg(trouble.stroke + 1).arg(trouble.times).arg(trouble.writings);
  };
  switch (trouble.kind) {
    case Kind::order:
      return sentence(tr("Stroke %1 was out of order in %2 of %3 writings."));
    case Kind::reversed:
      return sentence(tr("Stroke %1 was written backwards in %2 of %3 writings."));
    case Kind::missing:
      return sentence(tr("Stroke %1 was left out in %2 of %3 writings."));
    case Kind::joined:
      return sentence(tr("Stroke %1 was joined to another one in %2 of %3 writings."));
    case Kind::split:
      return sentence(tr("Stroke %1 was written in pieces in %2 of %3 writings."));
    case Kind::extra:
      return sentence(tr("Stroke %1 was one too many in %2 of %3 writings."));
    case Kind::other:
      return sentence(tr("Stroke %1 belonged to another character in %2 of %3 writings."));
    case Kind::ending:
      return sentence(tr("Stroke %1 ended wrongly in %2 of %3 writings."));
    case Kind::wrong:
      break;
  }
  return sentence(tr("Stroke %1 had the wrong shape or position in %2 of %3 writings."));
}

}  // namespace nazori::ui
