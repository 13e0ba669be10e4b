// SPDX-License-Identifier: Apache-2.0
#include "characters/stroke_words.h"

#include "words/kanji_text.h"

namespace nazori::ui {

QString StrokeWords::name(const std::string& type) {
  const QString text = to_text(type);
  if (text.isEmpty()) return {};
  switch (text.front().unicode()) {
    case 0x31D0:
      return tr("horizontal stroke");
    case 0x31D1:
      return tr("vertical stroke");
    case 0x31D2:
    case 0x31D3:
      return tr("sweep to the left");
    case 0x31CF:
    case 0x31DD:
      return tr("sweep to the right");
    case 0x31D4:
      return tr("dot");
    case 0x31C0:
      return tr("rising stroke");
    case 0x31D6:
      return tr("horizontal stroke with a hook");
    case 0x31DA:
      return tr("vertical stroke with a hook");
    case 0x31D5:
      return tr("horizontal stroke that turns down");
    case 0x31C6:
      return tr("horizontal stroke that turns down, with a hook");
    case 0x31D7:
    case 0x31C4:
      return tr("vertical stroke that turns right");
    case 0x31DF:
      return tr("vertical stroke that bends right, with a hook");
    case 0x31D9:
      return tr("vertical stroke that rises at the end");
    case 0x31C7:
      return tr("horizontal stroke that turns into a left sweep");
    case 0x31C1:
      return tr("curved stroke with a hook");
    case 0x31C2:
      return tr("slanting stroke with a hook");
    case 0x31C3:
      return tr("flat curve with a hook");
    case 0x31C8:
    case 0x31E0:
      return tr("horizontal stroke that bends, with a hook");
    case 0x31CA:
      return tr("horizontal stroke that turns down, then rises");
    case 0x31DC:
      return tr("sweep to the left that turns right");
    case 0x31DB:
      return tr("sweep to the left that turns into a dot");
    case 0x31DE:
    case 0x31C5:
    case 0x31CE:
      return tr("stroke with three turns");
    case 0x31C9:
    case 0x31E1:
      return tr("stroke with several turns and a hook");
    case 0x31CB:
      return tr("stroke with two turns and a sweep to the left");
    case 0x31CC:
      return tr("stroke that turns and curves, with a hook");
    default:
      return {};
  }
}

QString StrokeWords::ending(kanji::StrokeEnding ending) {
  switch (ending) {
    case kanji::StrokeEnding::stop:
      return tr("It ends with a stop.");
    case kanji::StrokeEnding::hook:
      return tr("It ends with a hook.");
    case kanji::StrokeEnding::taper:
      return tr("It ends with a sweep: lift the pen while it is still moving.");
    case kanji::StrokeEnding::either:
      return tr("It may end with a stop or a sweep.");
  }
  return {};
}

}  // namespace nazori::ui
