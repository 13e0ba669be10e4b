// SPDX-License-Identifier: Apache-2.0
#include "sheets.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace nazori::print {

Size size_of(const SheetSettings& s) {
  const Size paper = s.paper == Paper::a4   ? Size{210, 297}
                     : s.paper == Paper::b5 ? Size{182, 257}
                                            : Size{215.9, 279.4};
  if (s.booklet) return {paper.height / 2, paper.width};
  if (s.layout == Layout::manuscript) return {paper.height, paper.width};
  return paper;
}

Canvas& Sheets::new_page(bool with_header) {
  pages_.push_back(std::make_unique<Canvas>(fonts_, size_.height));
  used_depth_ = 0;
  Canvas& canvas = *pages_.back();
  if (with_header) draw_header(canvas);
  // The licence of the strokes asks to name their source.
  canvas.text(kMargin_mm, size_.height - kMargin_mm - 0.6,
              U"Strokes: KanjiVG, CC BY-SA 3.0. Made with Nazori.", 1.9, 0.5);
  const std::u32string page = wide(std::to_string(pages_.size()));
  canvas.text(size_.width - kMargin_mm - fonts_.width(page) * 2.6, size_.height - kMargin_mm - 0.6, page, 2.6,
              0.3);
  return canvas;
}

void Sheets::draw_header(Canvas& canvas) {
  const double y = kMargin_mm + 4.5;
  const double right = size_.width - kMargin_mm;
  double x = right;
  const auto field = [&](const std::u32string& name, double line_mm) {
    x -= line_mm;
    canvas.line(x, y + 0.8, x + line_mm - 2, y + 0.8, {0.4, 0.2, 0});
    x -= fonts_.width(name) * 3.2 + 1;
    canvas.text(x, y, name, 3.2, 0.2);
  };
  const double scale = std::min(1.0, (size_.width - 2 * kMargin_mm) / 186);
  if (s_.name_line) {
    field(label("Date", "日付"), 24 * scale);
    field(label("Class", "組"), 20 * scale);
    field(label("Name", "名前"), 46 * scale);
  }
  const std::u32string title = cut(fonts_, wide(s_.title), (x - kMargin_mm - 3) / 4);
  canvas.text(kMargin_mm, y, title, 4);
}

void Sheets::place_cell(Canvas& canvas, const Rect& rect, std::optional<Guide> guide) {
  const auto [at, is_new] = cells_.try_emplace({std::lround(rect.width * 1000), guide.has_value()});
  if (is_new) at->second = fmt::format("G{}", cells_.size() - 1);
  canvas.object(at->second, rect);
}

base::Result<void> Sheets::draw(const base::Progress& progress) {
  if (s_.layout == Layout::manuscript) {
    manuscript();
  } else if (s_.layout == Layout::cards) {
    cards();
  } else if (s_.layout == Layout::quiz) {
    quiz();
    if (pages_.empty())
      return base::fail(base::Errc::bad_argument, "none of the characters has a word to ask", "quiz",
                        "choose other characters");
  } else {
    for (std::size_t i = 0; i < characters_.size(); ++i) {
      if (i % 64 == 0 && progress &&
          !progress(static_cast<double>(i) / static_cast<double>(characters_.size()), "drawing the sheets"))
        return base::fail(base::Errc::cancelled, "stopped", "worksheet");
      practice(i);
    }
  }
  return {};
}

}  // namespace nazori::print
