// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/embosser.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "embossed_dots.h"

namespace nazori::model {
namespace {

constexpr int kFarthestNumber = 3;               // cells from the start
constexpr std::size_t kEndGaps = 3;              // dots left out where a stroke sinks
constexpr std::size_t kWholeShare_percent = 60;  // of a stroke, which has no gaps
constexpr BrailleCell kFullCell = 0b111111;      // no digit, so it is told from the number of a stroke
// ASCII braille, by the value of the cell: bit 0 is dot 1.
constexpr std::string_view kAscii = " A1B'K2L@CIF/MSP\"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\\0Z7(_?W]#Y)=";
static_assert(kAscii.size() == 64);

/// Sets the dots of a stroke.
void add_stroke(EmbosserPage& page, std::span<const Dot> dots, LineEnd end) {
  for (std::size_t i = 0; i < dots.size(); ++i) {
    const std::size_t to_end = dots.size() - 1 - i;
    const bool is_gap = end == LineEnd::sinks && to_end % 2 == 1 && to_end < 2 * kEndGaps &&
                        i >= dots.size() * kWholeShare_percent / 100;
    if (!is_gap) set_dot(page, dots[i]);
  }
}

/// The nearest cell for a number beside a start; around it nothing is raised.
std::optional<std::pair<int, int>> cell_beside(const EmbosserPage& page, const Dot& start, int cells,
                                               int lines) {
  const int column = start.column / 2;
  const int line = start.row / 3;
  const auto is_free = [&](int c, int l) {
    for (int y = l - 1; y <= l + 1; ++y)
      for (int x = c - 1; x <= c + cells; ++x)
        if (x >= 0 && y >= 0 && x < page.columns() && y < lines && page.at(x, y) != 0) return false;
    return c >= 0 && l >= 0 && c + cells <= page.columns() && l < lines;
  };
  std::optional<std::pair<int, int>> best;
  double nearest = 1e9;
  for (int l = line - kFarthestNumber; l <= line + kFarthestNumber; ++l) {
    for (int c = column - kFarthestNumber - cells + 1; c <= column + kFarthestNumber; ++c) {
      const double dx = (c + (cells - 1) / 2.0 - column) * kCell_mm;
      const double dy = (l - line) * kLine_mm;
      const double away = std::hypot(dx, dy);
      if (away >= nearest || !is_free(c, l)) continue;
      nearest = away;
      best = std::pair{c, l};
    }
  }
  return best;
}

}  // namespace

EmbosserPage::EmbosserPage(const EmbosserPaper& paper)
    : columns_(paper.columns),
      lines_(paper.lines),
      cells_(static_cast<std::size_t>(paper.columns) * static_cast<std::size_t>(paper.lines)) {}

double dot_x_mm(int dot_column) { return dot_column / 2 * kCell_mm + dot_column % 2 * kDot_mm; }
double dot_y_mm(int dot_row) { return dot_row / 3 * kLine_mm + dot_row % 3 * kDot_mm; }

base::Result<EmbossedCharacter> embossed(std::span<const RaisedStroke> strokes,
                                         std::span<const std::vector<BrailleCell>> text,
                                         const EmbossedMarks& marks, const EmbosserPaper& paper) {
  if (auto good = check_paper(paper); !good) return tl::unexpected(std::move(good.error()));
  if (strokes.empty())
    return base::fail(base::Errc::bad_argument, "there is no stroke to emboss", "embosser", "give strokes");
  auto below = wrapped(text, static_cast<std::size_t>(paper.columns));
  below.resize(std::min(below.size(), static_cast<std::size_t>(paper.lines / 2)));
  // One empty line between the character and its text.
  const int lines = paper.lines - (below.empty() ? 0 : static_cast<int>(below.size()) + 1);
  EmbossedCharacter made{EmbosserPage(paper), {}};
  const double side =
      std::min(dot_x_mm(2 * paper.columns - 1), dot_y_mm(3 * lines - 1));  // from the first dot to the last
  const double left = std::floor((dot_x_mm(2 * paper.columns - 1) - side) / 2 / kCell_mm) * kCell_mm;
  std::vector<Dot> starts;
  for (const RaisedStroke& stroke : strokes) {
    PlateLine line;
    for (const PlatePoint p : stroke.line)
      line.push_back({left + std::clamp(p.x, 0.0, 1.0) * side, (1 - std::clamp(p.y, 0.0, 1.0)) * side});
    const auto dots = dots_along(line);
    starts.push_back(dots.front());
    add_stroke(made.page, dots, stroke.end);
  }
  // Starts come last: a cell that is full hides nothing of a stroke.
  for (const Dot& start : starts)
    if (marks.start_dots) made.page.set(start.column / 2, start.row / 3, kFullCell);
  for (std::size_t i = 0; marks.numbers && i < strokes.size(); ++i) {
    auto cells = braille_cells(std::to_string(i + 1)).value_or(std::vector<BrailleCell>());
    cells.erase(cells.begin());
    const auto place = cell_beside(made.page, starts[i], static_cast<int>(cells.size()), lines);
    if (!place) {
      made.without_number.push_back(static_cast<int>(i) + 1);
      continue;
    }
    for (std::size_t k = 0; k < cells.size(); ++k)
      made.page.set(place->first + static_cast<int>(k), place->second, cells[k]);
  }
  put_text(made.page, below, lines + 1);
  return made;
}

std::string to_brf(std::span<const EmbosserPage> pages) {
  std::string file;
  for (const EmbosserPage& page : pages) {
    std::string text;
    std::size_t end = 0;
    for (int line = 0; line < page.lines(); ++line) {
      std::string cells;
      for (int column = 0; column < page.columns(); ++column) cells += kAscii[page.at(column, line) & 63U];
      cells.erase(cells.find_last_not_of(' ') + 1);
      text += cells + "\r\n";
      if (!cells.empty()) end = text.size();
    }
    text.resize(end);
    file += text + '\f';
  }
  return file;
}

}  // namespace nazori::model
