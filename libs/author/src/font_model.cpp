// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/font_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ink_map.h"
#include "model_fit.h"
#include "nazori/author/font_picture.h"
#include "nazori/geometry/frames.h"
#include "nazori/geometry/polyline.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;
using geometry::GridPoint;

constexpr int kGlyphPicture = 512;  // pixels
constexpr std::array kFonts{BrushFont{"KouzanBrushFont", "fonts-kouzan-mouhitsu"},
                            BrushFont{"KouzanBrushFontGyousyo", "fonts-kouzan-mouhitsu"},
                            BrushFont{"KouzanBrushFontSousyo", "fonts-kouzan-mouhitsu"},
                            BrushFont{"AoyagiKouzanFontT", "fonts-aoyagi-kouzan-t"}};

/// The samples within a disc that moves and grows from each point to the next: 1, others 0.
std::vector<std::uint8_t> samples_in(const OwnStroke& stroke) {
  std::vector<std::uint8_t> samples(std::size_t{kInkSide} * kInkSide);
  const auto add = [&samples](GridPoint from, double r0, GridPoint to, double r1) {
    const double room = std::max(r0, r1);
    const auto sample = [](double v) { return std::clamp(static_cast<int>(v), 0, kInkSide - 1); };
    const int right = sample(std::max(from.x, to.x) + room + 1);
    const int bottom = sample(std::max(from.y, to.y) + room + 1);
    for (int y = sample(std::min(from.y, to.y) - room); y <= bottom; ++y)
      for (int x = sample(std::min(from.x, to.x) - room); x <= right; ++x) {
        const GridPoint p{static_cast<double>(x), static_cast<double>(y)};
        const double share = geometry::nearest_share(p, from, to);
        if (geometry::distance(p, from + (to - from) * share) <= r0 + (r1 - r0) * share)
          samples[static_cast<std::size_t>(y) * kInkSide + static_cast<std::size_t>(x)] = 1;
      }
  };
  const auto at = [&stroke](std::size_t i) { return geometry::glyph_to_grid(stroke.points[i].at, kInkSide); };
  const auto radius = [&stroke](std::size_t i) { return stroke.points[i].half_width * kInkPerUnit; };
  add(at(0), radius(0), at(0), radius(0));
  for (std::size_t i = 1; i < stroke.points.size(); ++i) add(at(i - 1), radius(i - 1), at(i), radius(i));
  return samples;
}

/// The share of a middle line that lies in ink.
double share_in_ink(const OwnStroke& stroke, const InkMap& map) {
  constexpr double kSpacing = 0.5;  // glyph units
  geometry::Polyline<geometry::GlyphFrame> line;
  for (const GroovePoint& point : stroke.points) line.push_back(point.at);
  const double length = geometry::arc_length<geometry::GlyphFrame>(line);
  const auto count = static_cast<std::size_t>(length / kSpacing) + 2;
  const auto even = geometry::resample<geometry::GlyphFrame>(line, count);
  const auto inside = std::count_if(even.begin(), even.end(), [&map](GlyphPoint p) {
    return between(map.level, geometry::glyph_to_grid(p, kInkSide)) > 1;
  });
  return static_cast<double>(inside) / static_cast<double>(even.size());
}

/// Takes away what lies before the first and after the last point in ink: the known character may be larger.
void end_in_ink(OwnStroke& stroke, const InkMap& map) {
  const auto has_ink = [&map](const GroovePoint& point) {
    return between(map.level, geometry::glyph_to_grid(point.at, kInkSide)) > 1;
  };
  const auto first = std::ranges::find_if(stroke.points, has_ink);
  const auto last = std::find_if(stroke.points.rbegin(), stroke.points.rend(), has_ink).base();
  if (std::distance(first, last) < 2) return;
  stroke.points.erase(last, stroke.points.end());
  stroke.points.erase(stroke.points.begin(), first);
}

FontFit fit_of(const std::vector<FittedStroke>& found, const InkMap& map) {
  FontFit fit{.on_ink = 1, .alone = 1};
  std::vector<std::vector<std::uint8_t>> strokes;
  std::vector<std::uint8_t> count(map.ink.size());
  for (const FittedStroke& one : found) {
    strokes.push_back(samples_in(one.stroke));
    for (std::size_t i = 0; i < count.size(); ++i)
      count[i] = static_cast<std::uint8_t>(count[i] + strokes.back()[i]);
    fit.on_ink = std::min(fit.on_ink, share_in_ink(one.stroke, map));
    fit.moved = std::max(fit.moved, one.moved);
  }
  for (const auto& stroke : strokes) {
    double area = 0, alone = 0;
    for (std::size_t i = 0; i < count.size(); ++i) {
      area += stroke[i];
      alone += stroke[i] != 0 && count[i] == 1 ? 1 : 0;
    }
    fit.alone = std::min(fit.alone, alone / std::max(area, 1.0));
  }
  double ink = 0, all = 0, both = 0;
  for (std::size_t i = 0; i < count.size(); ++i) {
    ink += map.ink[i];
    all += count[i] != 0 ? 1 : 0;
    both += count[i] != 0 ? map.ink[i] : 0;
  }
  fit.covered = both / std::max(ink, 1.0);
  fit.outside = 1 - both / std::max(all, 1.0);
  return fit;
}

/// From the glyph box of the ink to the square of the font.
void place_in_square(OwnStroke& stroke, const PicturePlace& place) {
  const double unit = geometry::kGlyphSide / kGlyphPicture;
  for (GroovePoint& point : stroke.points) {
    point.at = GlyphPoint{(place.left + 0.5 + point.at.x * place.pixels_per_unit) * unit,
                          (place.top + 0.5 + point.at.y * place.pixels_per_unit) * unit};
    point.half_width *= place.pixels_per_unit * unit;
  }
}

base::Error without(char32_t character, const std::string& family, const char* what) {
  return {base::Errc::not_found, fmt::format("U+{:04X} {}", static_cast<unsigned>(character), what),
          "font " + family, "choose another font"};
}

}  // namespace

std::span<const BrushFont> brush_fonts() { return kFonts; }

std::vector<BrushFont> installed_brush_fonts() {
  const std::vector<std::string> families = font_families(U'一');
  std::vector<BrushFont> installed;
  for (const BrushFont& font : kFonts)
    if (std::binary_search(families.begin(), families.end(), font.family)) installed.push_back(font);
  return installed;
}

bool is_good_fit(const FontFit& fit) {
  constexpr double kLeastCovered = 0.83, kMostOutside = 0.12, kLeastOnInk = 0.8, kLeastAlone = 0.3;
  constexpr double kMostMoved = 9;
  return fit.covered >= kLeastCovered && fit.outside <= kMostOutside && fit.on_ink >= kLeastOnInk &&
         fit.alone >= kLeastAlone && fit.moved <= kMostMoved;
}

base::Result<FontStrokes> font_strokes(char32_t character, std::span<const kanji::StrokeLine> known,
                                       const std::string& family) {
  if (auto fine = check_known(known); !fine) return tl::unexpected(fine.error());
  const auto picture = font_picture(character, family, kGlyphPicture);
  if (!picture) return tl::unexpected(picture.error());
  const auto ink = ink_of(*picture);
  if (!ink) return tl::unexpected(without(character, family, "is empty"));
  std::vector<FittedStroke> found = fitted(*ink, known);
  for (FittedStroke& one : found) end_in_ink(one.stroke, *ink);
  FontStrokes strokes{.strokes = {}, .fit = fit_of(found, *ink)};
  for (FittedStroke& one : found) {
    place_in_square(one.stroke, ink->place);
    strokes.strokes.push_back(std::move(one.stroke));
  }
  return strokes;
}

base::Result<FontStrokes> font_model(char32_t character, std::span<const kanji::StrokeLine> known,
                                     const std::string& family) {
  auto strokes = font_strokes(character, known, family);
  if (strokes && !is_good_fit(strokes->fit))
    return tl::unexpected(without(character, family, "has other strokes"));
  return strokes;
}

}  // namespace nazori::author
