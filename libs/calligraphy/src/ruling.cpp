// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/ruling.h"

#include <algorithm>
#include <cmath>

#include "nazori/geometry/polyline.h"

namespace nazori::calligraphy {
namespace {

constexpr double kOneSide_m = 0.085;
constexpr double kSpacing_m = 0.0005;

struct Layout {
  int characters, columns, rows;
  double side_m;
};
constexpr std::array kLayouts{Layout{1, 1, 1, kOneSide_m}, Layout{2, 1, 2, 0.047}, Layout{4, 2, 2, 0.047},
                              Layout{6, 2, 3, 0.0315}};

bool is_space(char32_t c) { return c == U' ' || c == U'\u3000' || c == U'\t' || c == U'\n'; }

std::u32string written(std::u32string_view text) {
  std::u32string kept;
  for (const char32_t c : text)
    if (!is_space(c)) kept.push_back(c);
  return kept;
}

/// Half of the width at `along` of a stroke, 0..1, over the side of the square.
double half_width_at(double along, kanji::StrokeEnding ending) {
  constexpr double kBody = 0.030, kEntry = 0.034, kStop = 0.035, kThin = 0.003;
  constexpr double kEnters = 0.12, kSweeps = 0.40, kHooks = 0.86, kStops = 0.86;
  const auto between = [](double a, double b, double share) { return a + (b - a) * share; };
  const auto thins_from = [&](double from) {
    return along < from ? kBody : between(kBody, kThin, (along - from) / (1 - from));
  };
  if (along < kEnters) return between(kEntry, kBody, along / kEnters);
  if (ending == kanji::StrokeEnding::taper) return thins_from(kSweeps);
  if (ending == kanji::StrokeEnding::hook) return thins_from(kHooks);
  return along < kStops ? kBody : between(kBody, kStop, (along - kStops) / (1 - kStops));
}

geometry::PaperPoint placed(geometry::GlyphPoint p, const RuledSquare& square) {
  return {square.middle.x + (p.x / geometry::kGlyphSide - 0.5) * square.side_m,
          square.middle.y + (0.5 - p.y / geometry::kGlyphSide) * square.side_m};
}

/// A stroke through corners with points at most kSpacing_m apart.
/// @param half_width_m  at a share of the way from a corner to the next one, so far along the stroke.
template <class HalfWidth>
ModelStroke closely(const geometry::Polyline<geometry::PaperFrame>& corners, HalfWidth half_width_m) {
  ModelStroke stroke{{corners.front()}, {half_width_m(0, 0.0, 0.0)}};
  double along = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double way = geometry::distance(corners[i - 1], corners[i]);
    if (way <= 0) continue;
    const int parts = std::max(1, static_cast<int>(std::ceil(way / kSpacing_m)));
    for (int k = 1; k <= parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      stroke.points.push_back(corners[i - 1] + (corners[i] - corners[i - 1]) * share);
      stroke.half_width_m.push_back(half_width_m(i - 1, share, along + share * way));
    }
    along += way;
  }
  return stroke;
}

}  // namespace

std::vector<RuledSquare> ruled_squares(int characters) {
  const auto* layout = std::find_if(kLayouts.begin(), kLayouts.end(),
                                    [&](const Layout& one) { return one.characters == characters; });
  if (layout == kLayouts.end()) return {};
  std::vector<RuledSquare> squares;
  for (int column = layout->columns - 1; column >= 0; --column)
    for (int row = 0; row < layout->rows; ++row)
      squares.push_back({{(column - (layout->columns - 1) / 2.0) * layout->side_m,
                          ((layout->rows - 1) / 2.0 - row) * layout->side_m},
                         layout->side_m});
  return squares;
}

RuledSquare only_square() { return {{}, kOneSide_m}; }

BrushSize size_for(int characters) {
  if (characters <= 1) return BrushSize::medium;
  return characters < 6 ? BrushSize::small : BrushSize::fine;
}

std::vector<ModelStroke> model_strokes(std::span<const kanji::StrokeLine> lines, const RuledSquare& square) {
  std::vector<ModelStroke> strokes;
  for (const kanji::StrokeLine& line : lines) {
    geometry::Polyline<geometry::PaperFrame> corners;
    for (const auto& p : line.points) corners.push_back(placed(p, square));
    if (corners.empty()) continue;
    const double length = geometry::arc_length<geometry::PaperFrame>(corners);
    strokes.push_back(closely(corners, [&](std::size_t /*corner*/, double /*share*/, double along) {
      return square.side_m * half_width_at(length > 0 ? along / length : 0, line.ending);
    }));
  }
  return strokes;
}

std::vector<ModelStroke> model_strokes(std::span<const carving::Groove> strokes, const RuledSquare& square) {
  std::vector<ModelStroke> all;
  for (const carving::Groove& stroke : strokes) {
    geometry::Polyline<geometry::PaperFrame> corners;
    for (const auto& point : stroke) corners.push_back(placed(point.at, square));
    if (corners.empty()) continue;
    all.push_back(closely(corners, [&](std::size_t corner, double share, double /*along*/) {
      const double from = stroke[corner].half_width;
      const double to = stroke[std::min(corner + 1, stroke.size() - 1)].half_width;
      return (from + (to - from) * share) / geometry::kGlyphSide * square.side_m;
    }));
  }
  return all;
}

int sheets_of(std::u32string_view text, int squares) {
  const auto count = static_cast<int>(written(text).size());
  const int each = std::max(squares, 1);
  return std::max(1, (count + each - 1) / each);
}

std::vector<char32_t> models_on_sheet(std::u32string_view text, int squares, int sheet) {
  const std::u32string all = written(text);
  if (all.empty() || squares <= 0) return {};
  const int sheets = sheets_of(text, squares);
  const int at = ((sheet % sheets) + sheets) % sheets;
  const std::u32string part = all.substr(static_cast<std::size_t>(at) * static_cast<std::size_t>(squares),
                                         static_cast<std::size_t>(squares));
  std::vector<char32_t> models;
  for (std::size_t i = 0; i < static_cast<std::size_t>(squares); ++i) models.push_back(part[i % part.size()]);
  return models;
}

}  // namespace nazori::calligraphy
