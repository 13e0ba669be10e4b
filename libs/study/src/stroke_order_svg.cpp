// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "nazori/study/exchange.h"

namespace nazori::study {

std::string stroke_order_svg(const kanji::Character& character) {
  constexpr int kColumns = 6;
  constexpr int kSide = 109;
  const int count = static_cast<int>(character.strokes.size());
  const int columns = std::clamp(count, 1, kColumns);
  const int rows = std::max(1, (count + kColumns - 1) / kColumns);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\" height=\"{}\">\n"
      "<!-- Strokes: KanjiVG, (c) Ulrich Apel, CC BY-SA 3.0 -->\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
      "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
      columns * kSide, rows * kSide, columns * kSide, rows * kSide);
  for (int panel = 0; panel < count; ++panel) {
    svg += fmt::format(
        "<g transform=\"translate({} {})\"><path d=\"M0.5 0.5H108.5V108.5H0.5Z\" stroke=\"#bbb\"/>"
        "<path d=\"M54.5 0V109M0 54.5H109\" stroke=\"#ddd\" stroke-dasharray=\"4 4\"/>\n",
        panel % kColumns * kSide, panel / kColumns * kSide);
    for (int i = 0; i <= panel; ++i) {
      svg += fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"4\"/>\n",
                         character.strokes[static_cast<std::size_t>(i)].path, i == panel ? "#000" : "#999");
    }
    const kanji::StrokeLine& line = character.strokes[static_cast<std::size_t>(panel)].line;
    if (!line.points.empty()) {
      svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\" fill=\"#c22\"/>\n", line.points[0].x,
                         line.points[0].y);
    }
    svg += fmt::format(
        "<text x=\"6\" y=\"14\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#c22\">{}</text></g>\n",
        panel + 1);
  }
  return svg + "</g></svg>\n";
}

}  // namespace nazori::study
