// SPDX-License-Identifier: Apache-2.0
#include "characters/stroke_words.h"

#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

namespace {

struct Named {
  char16_t stroke;
  const char* name;
};

/// CJK strokes of Unicode, by the kinds that a learner tells apart.
constexpr Named kNames[] = {
    {0x31D0, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "horizontal stroke")},
    {0x31D1, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "vertical stroke")},
    {0x31D2, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "sweep to the left")},
    {0x31D3, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "sweep to the left")},
    {0x31CF, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "sweep to the right")},
    {0x31DD, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "sweep to the right")},
    {0x31D4, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "dot")},
    {0x31C0, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "rising stroke")},
    {0x31D6, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "horizontal stroke with a hook")},
    {0x31DA, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "vertical stroke with a hook")},
    {0x31D5, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "horizontal stroke that turns down")},
    {0x31C6, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "horizontal stroke that turns down, with a hook")},
    {0x31D7, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "vertical stroke that turns right")},
    {0x31C4, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "vertical stroke that turns right")},
    {0x31DF, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "vertical stroke that bends right, with a hook")},
    {0x31D9, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "vertical stroke that rises at the end")},
    {0x31C7, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "horizontal stroke that turns into a left sweep")},
    {0x31C1, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "curved stroke with a hook")},
    {0x31C2, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "slanting stroke with a hook")},
    {0x31C3, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "flat curve with a hook")},
    {0x31C8, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "horizontal stroke that bends, with a hook")},
    {0x31E0, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "horizontal stroke that bends, with a hook")},
    {0x31CA, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "horizontal stroke that turns down, then rises")},
    {0x31DC, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "sweep to the left that turns right")},
    {0x31DB, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "sweep to the left that turns into a dot")},
    {0x31DE, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "stroke with three turns")},
    {0x31C5, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "stroke with three turns")},
    {0x31CE, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "stroke with three turns")},
    {0x31C9, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "stroke with several turns and a hook")},
    {0x31E1, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "stroke with several turns and a hook")},
    {0x31CB, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "stroke with two turns and a sweep to the left")},
    {0x31CC, QT_TRANSLATE_NOOP("nazori::ui::StrokeWords", "stroke that turns and curves, with a hook")},
};

}  // namespace

QString StrokeWords::name(const std::string& type) {
  const QString text = to_text(type);
  for (const auto& one : kNames)
    if (text.startsWith(QChar(one.stroke))) return tr(one.name);
  return {};
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
