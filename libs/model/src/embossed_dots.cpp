// SPDX-License-Identifier: Apache-2.0
#include "embossed_dots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "nazori/geometry/polyline.h"

namespace nazori::model {
namespace {

constexpr double kSample_mm = 0.2;

bool are_diagonal(const Dot& a, const Dot& b) {
  return std::abs(a.column - b.column) == 1 && std::abs(a.row - b.row) == 1;
}

unsigned bit_of(const Dot& dot) { return static_cast<unsigned>(dot.column % 2 * 3 + dot.row % 3); }

}  // namespace

Dot nearest_dot(double x_mm, double y_mm) {
  const auto nearest = [](double at, double pitch, int in_one) {
    const int cell = std::max(0, static_cast<int>(std::floor(at / pitch)));
    int best = cell * in_one;
    double least = 1e9;
    for (int k = 0; k <= in_one; ++k) {  // the first dot of the next cell, too
      const double place = cell * pitch + (k == in_one ? pitch : k * kDot_mm);
      if (std::abs(place - at) >= least) continue;
      least = std::abs(place - at);
      best = cell * in_one + k;
    }
    return best;
  };
  return {nearest(x_mm, kCell_mm, 2), nearest(y_mm, kLine_mm, 3)};
}

std::vector<Dot> dots_along(const PlateLine& line) {
  std::vector<Dot> dots;
  const double length = geometry::arc_length(std::span<const PlatePoint>(line));
  const auto count = static_cast<std::size_t>(length / kSample_mm) + 2;
  for (const PlatePoint p : geometry::resample(std::span<const PlatePoint>(line), count)) {
    const Dot dot = nearest_dot(p.x, p.y);
    if (!dots.empty() && dots.back() == dot) continue;
    if (dots.size() >= 2 && are_diagonal(dots[dots.size() - 2], dot)) dots.pop_back();
    dots.push_back(dot);
  }
  return dots;
}

void set_dot(EmbosserPage& page, const Dot& dot) {
  const int column = dot.column / 2;
  const int line = dot.row / 3;
  page.set(column, line, static_cast<BrailleCell>(page.at(column, line) | 1U << bit_of(dot)));
}

bool has_dot(const EmbosserPage& page, const Dot& dot) {
  return (page.at(dot.column / 2, dot.row / 3) >> bit_of(dot) & 1U) != 0;
}

std::vector<std::vector<BrailleCell>> wrapped(std::span<const std::vector<BrailleCell>> text,
                                              std::size_t columns) {
  std::vector<std::vector<BrailleCell>> lines;
  for (const auto& paragraph : text) {
    auto rest = paragraph.begin();
    while (static_cast<std::size_t>(paragraph.end() - rest) > columns) {
      auto end = rest + static_cast<std::ptrdiff_t>(columns);
      auto blank = end;
      while (blank != rest && *blank != 0) --blank;
      if (blank != rest) end = blank;
      lines.emplace_back(rest, end);
      rest = end;
      while (rest != paragraph.end() && *rest == 0) ++rest;
    }
    lines.emplace_back(rest, paragraph.end());
  }
  return lines;
}

void put_text(EmbosserPage& page, std::span<const std::vector<BrailleCell>> text, int line) {
  for (std::size_t l = 0; l < text.size(); ++l)
    for (std::size_t c = 0; c < text[l].size(); ++c)
      page.set(static_cast<int>(c), line + static_cast<int>(l), text[l][c]);
}

base::Result<void> check_paper(const EmbosserPaper& paper) {
  const auto within = [](int value) { return value >= 12 && value <= 100; };
  if (within(paper.columns) && within(paper.lines)) return {};
  return base::fail(base::Errc::bad_argument,
                    fmt::format("a page cannot have {} lines of {} cells", paper.lines, paper.columns),
                    "embosser", "give 12 to 100 of each");
}

}  // namespace nazori::model
