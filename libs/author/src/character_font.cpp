// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/character_font.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "font_tables.h"
#include "nazori/author/own_character.h"
#include "nazori/base/utf8.h"
#include "sfnt.h"
#include "stroke_outline.h"

namespace nazori::author {
namespace {

/// Most points of a glyph. @source measured: FreeType 2.12 draws 20,000 points whose edges cross everywhere
/// up to 200 pixels high; it cannot read more than 32,763.
constexpr std::size_t kMostGlyphPoints = 20'000;
/// Longest edge of a glyph in all [em]: it decides how long drawing takes. @source a little more than 200
/// strokes without bends can have: twice the diagonal and twice the widest end.
constexpr double kLongestEdge = 2'200;
constexpr std::size_t kMostOutlineBytes = std::size_t{1} << 31U;
constexpr char32_t kLastCodePoint = 0x10FFFF;

base::Result<void> check_family(std::string_view family) {
  const auto refuse = [](std::string what) {
    return base::fail(base::Errc::bad_argument, std::move(what), "family", "give one line of UTF-8");
  };
  if (family.empty()) return refuse("is empty");
  if (family.size() > kLongestName) return refuse(fmt::format("is longer than {} bytes", kLongestName));
  const auto letters = base::decode_utf8(family);
  if (!letters) return refuse("is not UTF-8");
  const auto is_control = [](char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); };
  if (std::ranges::any_of(*letters, is_control)) return refuse("has a control character");
  return {};
}

std::string label_of(const FontGlyph& glyph) {
  const std::string code = fmt::format("U+{:04X}", static_cast<std::uint32_t>(glyph.code_point));
  return glyph.name.empty() ? code : glyph.name + " (" + code + ")";
}

base::Result<void> check_glyph(const FontGlyph& glyph) {
  const char32_t code = glyph.code_point;
  if (code > kLastCodePoint || (code >= 0xD800 && code <= 0xDFFF))
    return base::fail(base::Errc::bad_argument, "is not a code point", label_of(glyph),
                      "give U+0000 to U+D7FF or U+E000 to U+10FFFF");
  if (auto fit = validate(glyph.strokes); !fit) {
    base::Error error = std::move(fit).error();
    error.where = label_of(glyph) + ", " + error.where;
    return tl::unexpected(std::move(error));
  }
  return {};
}

FontPoint in_font(const OutlinePoint& point) {
  constexpr double kScale = kFontEm / geometry::kGlyphSide;
  return {static_cast<int>(std::lround(point.at.x * kScale)),
          static_cast<int>(std::lround(kFontAscent - point.at.y * kScale)), point.on_curve};
}

/// The contour on the grid of the font, without points that say nothing.
FontContour on_grid(const OutlineContour& contour) {
  FontContour placed;
  for (const OutlinePoint& point : contour) {
    const FontPoint p = in_font(point);
    if (placed.empty() || !(p == placed.back())) placed.push_back(p);
  }
  while (placed.size() > 1 && placed.back() == placed.front()) placed.pop_back();
  FontContour out;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const FontPoint& p = placed[i];
    const FontPoint& before = placed[(i + placed.size() - 1) % placed.size()];
    const FontPoint& after = placed[(i + 1) % placed.size()];
    const bool follows = i > 0 && p.on_curve && !before.on_curve && !after.on_curve &&
                         std::abs(2 * p.x - before.x - after.x) <= 1 &&
                         std::abs(2 * p.y - before.y - after.y) <= 1;
    if (!follows) out.push_back(p);
  }
  return out;
}

/// Length of the edge [em].
double edge_length(std::span<const FontContour> contours) {
  double sum = 0;
  for (const FontContour& contour : contours)
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const FontPoint& next = contour[(i + 1) % contour.size()];
      sum += std::hypot(next.x - contour[i].x, next.y - contour[i].y);
    }
  return sum / kFontEm;
}

std::vector<FontContour> outlined(const std::vector<OwnStroke>& strokes) {
  // A part of the tolerance is for the grid, whose points are 0.11 units apart.
  double tolerance = kFontTolerance * 0.4;
  std::vector<std::vector<Disc>> lines;
  lines.reserve(strokes.size());
  for (const OwnStroke& stroke : strokes)
    lines.push_back(discs_of(stroke.points, {kThinnestInFont, kTipInFont, kTipRun}, tolerance));
  // At the latest it ends when every line has only its two ends.
  for (std::size_t block = 1024;; block *= 2) {
    std::vector<OutlineContour> contours;
    for (const std::vector<Disc>& line : lines)
      append_outline(block > 1024 ? thinned_discs(line, tolerance, block) : line, tolerance, contours);
    std::vector<FontContour> placed;
    placed.reserve(contours.size());
    for (const OutlineContour& contour : contours) placed.push_back(on_grid(contour));
    if (count_points(placed) <= kMostGlyphPoints && edge_length(placed) <= kLongestEdge) return placed;
    tolerance *= 1.5;
  }
}

/// The glyph for what is missing: a frame.
std::vector<FontContour> missing_glyph() {
  const auto frame = [](int left, int bottom, int right, int top) {
    return FontContour{{left, bottom}, {left, top}, {right, top}, {right, bottom}};
  };
  FontContour hole = frame(140, -20, 860, 780);
  std::ranges::reverse(hole);
  return {frame(100, -60, 900, 820), std::move(hole)};
}

}  // namespace

base::Result<std::vector<std::uint8_t>> character_font(std::span<const FontGlyph> glyphs,
                                                       std::string_view family) {
  if (auto fit = check_family(family); !fit) return tl::unexpected(std::move(fit).error());
  if (glyphs.size() > kMostFontGlyphs)
    return base::fail(base::Errc::bad_argument, fmt::format("{} are too many", glyphs.size()), "glyphs",
                      fmt::format("give at most {}", kMostFontGlyphs));
  std::vector<const FontGlyph*> ordered;
  ordered.reserve(glyphs.size());
  for (const FontGlyph& glyph : glyphs) {
    if (auto fit = check_glyph(glyph); !fit) return tl::unexpected(std::move(fit).error());
    ordered.push_back(&glyph);
  }
  std::ranges::stable_sort(ordered, {}, &FontGlyph::code_point);
  const auto twice = std::ranges::adjacent_find(ordered, {}, &FontGlyph::code_point);
  if (twice != ordered.end())
    return base::fail(base::Errc::bad_argument, "its code point comes twice", label_of(**std::next(twice)));

  FontBytes outlines;
  FontBytes offsets;
  std::vector<FontShape> shapes;
  const auto add = [&](char32_t code_point, const std::vector<FontContour>& contours) {
    offsets.u32(outlines.size());
    outlines.raw(glyph_bytes(contours));
    shapes.push_back({code_point, box_of_points(contours), count_points(contours), contours.size()});
  };
  shapes.reserve(glyphs.size() + 1);
  add(0, missing_glyph());
  for (const FontGlyph* glyph : ordered) {
    add(glyph->code_point, outlined(glyph->strokes));
    if (outlines.size() > kMostOutlineBytes)
      return base::fail(base::Errc::bad_argument, "the outlines exceed 2 GiB", label_of(*glyph),
                        "give fewer glyphs");
  }
  offsets.u32(outlines.size());

  std::vector<FontTable> tables = font_tables(shapes, family);
  tables.push_back({"glyf", std::move(outlines.bytes())});
  tables.push_back({"loca", std::move(offsets.bytes())});
  return font_file(std::move(tables));
}

}  // namespace nazori::author
