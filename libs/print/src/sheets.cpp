// SPDX-License-Identifier: Apache-2.0
#include "sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace nazori::print {

namespace {

constexpr double kPageNumber_mm = 2.6;
constexpr double kCredits_mm = 1.9;

}  // namespace

Size size_of(const SheetSettings& s) {
  const PaperSize paper = paper_size(s.paper);
  if (s.booklet) return {paper.height / 2, paper.width};
  if (s.layout == Layout::manuscript) return {paper.height, paper.width};
  return {paper.width, paper.height};
}

Canvas& Sheets::new_page(bool with_header) {
  draw_mark();
  pages_.push_back(std::make_unique<Canvas>(fonts_, size_.height));
  used_depth_ = 0;
  Canvas& canvas = *pages_.back();
  if (with_header) {
    draw_header(canvas);
    begin_mark();
  }
  const std::u32string page = wide(std::to_string(pages_.size()));
  const double number_left = size_.width - kMargin_mm - fonts_.width(page) * kPageNumber_mm;
  const double base_line = size_.height - kMargin_mm - 0.6;
  canvas.text(number_left, base_line, page, kPageNumber_mm, 0.3);
  // The licence of the strokes asks to name their source. Many makers stand in smaller letters.
  const double room = number_left - kMargin_mm - kPageNumber_mm;
  canvas.text(kMargin_mm, base_line, credits_, std::min(kCredits_mm, room / fonts_.width(credits_)), 0.5);
  return canvas;
}

void Sheets::begin_mark() {
  mark_.emplace();
  mark_->layout = s_.layout;
  mark_->vertical = s_.vertical;
  mark_->guide = s_.guide;
  mark_->width_mm = size_.width;
  mark_->height_mm = size_.height;
  mark_->cell_mm = s_.cell_mm;
  mark_->copies = s_.copies;
  mark_->page = static_cast<int>((pages_.size() - 1) % 1023) + 1;
}

void Sheets::draw_mark() {
  if (!mark_) return;
  const auto bytes = mark_bytes(*mark_, mark_room(size_.width));
  mark_.reset();
  if (!bytes) return;
  Canvas& canvas = *pages_.back();
  for (const PaperPoint centre : disc_centres(size_.width, size_.height))
    canvas.disc(centre.x, centre.y, kDisc_mm / 2);
  const auto is_dark = [&](int column, int row) {
    if (row == 0) return column % 2 == 0;
    const auto bit = static_cast<std::size_t>(column * kMarkRows + row - 1);
    return bit / 8 < bytes->size() && ((*bytes)[bit / 8] & 0x80U >> bit % 8) != 0;
  };
  std::vector<Rect> dark;
  for (int column = 0; column < mark_columns(bytes->size()); ++column) {
    for (int row = 0; row <= kMarkRows; ++row) {
      if (!is_dark(column, row)) continue;
      const int first = row;
      while (row < kMarkRows && is_dark(column, row + 1)) ++row;
      const PaperPoint at = module_centre(size_.height, column, first);
      dark.push_back(
          {at.x - kModule_mm / 2, at.y - kModule_mm / 2, kModule_mm, (row - first + 1) * kModule_mm});
    }
  }
  canvas.fill(dark);
}

void Sheets::draw_header(Canvas& canvas) {
  constexpr double kBesideDisc_mm = kDisc_mm + 2;
  const double y = kMargin_mm + 4.5;
  const double left = kMargin_mm + kBesideDisc_mm;
  const double right = size_.width - kMargin_mm - kBesideDisc_mm;
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
  const std::u32string title = cut(fonts_, wide(s_.title), (x - left - 3) / 4);
  canvas.text(left, y, title, 4);
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
  } else if (s_.layout == Layout::brush) {
    return brush(progress);
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
  draw_mark();
  return {};
}

}  // namespace nazori::print
