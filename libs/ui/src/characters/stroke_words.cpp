// SPDX-License-Identifier: Apache-2.0
#include "characters/stroke_words.h"

#include "kanji_text.h"

namespace nazori::ui {

QString StrokeWords::name(const std::string& type) {
  const QString text = to_text(type);
  if (text.isEmpty()) return {};
  switch (text.front().unicode()) {
    case 0x31D0:
      return tr("horizontal line");
    case 0x31D1:
      return tr("vertical line");
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
      return tr("horizontal line with a hook");
    case 0x31DA:
      return tr("vertical line with a hook");
    case 0x31D5:
      return tr("horizontal line that turns down");
    case 0x31C6:
      return tr("horizontal line that turns down, with a hook");
    case 0x31D7:
    case 0x31C4:
      return tr("vertical line that turns right");
    case 0x31DF:
      return tr("vertical line that bends right, with a hook");
    case 0x31D9:
      return tr("vertical line with a rise");
    case 0x31C7:
      return tr("horizontal line that sweeps to the left");
    case 0x31C1:
      return tr("curved line with a hook");
    case 0x31C2:
      return tr("slanting line with a hook");
    case 0x31C3:
      return tr("flat curve with a hook");
    case 0x31C8:
    case 0x31E0:
      return tr("horizontal line that bends, with a hook");
    case 0x31CA:
      return tr("horizontal line that turns down, then rises");
    case 0x31DC:
      return tr("sweep to the left that turns right");
    case 0x31DB:
      return tr("sweep to the left that turns to a dot");
    case 0x31DE:
    case 0x31C5:
    case 0x31CE:
      return tr("line with three turns");
    case 0x31C9:
    case 0x31E1:
      return tr("line with several turns and a hook");
    case 0x31CB:
      return tr("line with two turns that sweeps to the left");
    case 0x31CC:
      return tr("line that turns and curves, with a hook");
    default:
      return {};
  }
}

QString StrokeWords::ending(kanji::StrokeEnding ending) {
  switch (ending) {
    case kanji::StrokeEnding::stop:
      return tr("It stops at the end.");
    case kanji::StrokeEnding::hook:
      return tr("It stops, then kicks.");
    case kanji::StrokeEnding::taper:
      return tr("It is lifted while it moves, and thins out.");
    case kanji::StrokeEnding::either:
      return tr("It may stop or thin out.");
  }
  return {};
}

}  // namespace nazori::ui
