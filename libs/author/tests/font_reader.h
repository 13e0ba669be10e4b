// SPDX-License-Identifier: Apache-2.0
// Reads fonts: the tables by OpenType's definition, and glyphs with FreeType.
#pragma once

#include <ft2build.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "nazori/author/character_font.h"

namespace nazori::author::test {

using Bytes = std::vector<std::uint8_t>;

inline std::uint32_t number_at(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value = value << 8U | bytes[at + i];
  return value;
}
inline unsigned u16_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  return number_at(bytes, at, 2);
}
inline int i16_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::int16_t>(u16_at(bytes, at));
}
inline std::uint32_t u32_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  return number_at(bytes, at, 4);
}

/// The tables of a font by their tags.
inline std::map<std::string, std::span<const std::uint8_t>> tables_of(const Bytes& font) {
  std::map<std::string, std::span<const std::uint8_t>> tables;
  for (std::size_t i = 0; i < u16_at(font, 4); ++i) {
    const std::size_t at = 12 + 16 * i;
    tables[std::string(font.begin() + static_cast<std::ptrdiff_t>(at),
                       font.begin() + static_cast<std::ptrdiff_t>(at + 4))] =
        std::span(font).subspan(u32_at(font, at + 8), u32_at(font, at + 12));
  }
  return tables;
}

inline Bytes font_of(const std::vector<FontGlyph>& glyphs, const std::string& family = "Own characters") {
  auto font = character_font(glyphs, family);
  if (!font) {
    ADD_FAILURE() << base::to_line(font.error());
    return {};
  }
  return *std::move(font);
}

/// A font that FreeType has opened.
class ReadFont {
 public:
  explicit ReadFont(const Bytes& font) {
    EXPECT_EQ(FT_Init_FreeType(&library_), 0);
    EXPECT_EQ(FT_New_Memory_Face(library_, font.data(), static_cast<FT_Long>(font.size()), 0, &face_), 0);
  }
  ~ReadFont() {
    FT_Done_Face(face_);
    FT_Done_FreeType(library_);
  }
  ReadFont(const ReadFont&) = delete;
  ReadFont& operator=(const ReadFont&) = delete;
  [[nodiscard]] FT_Face face() const { return face_; }

  /// Loads a glyph, in units of the font. @return false where the font lacks it.
  [[nodiscard]] bool load(char32_t code_point) const {
    const FT_UInt glyph = FT_Get_Char_Index(face_, code_point);
    return glyph != 0 && FT_Load_Glyph(face_, glyph, FT_LOAD_NO_SCALE) == 0;
  }

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

/// An outline as straight pieces in glyph units.
class FlatOutline {
 public:
  using Point = geometry::GlyphPoint;

  explicit FlatOutline(FT_Outline outline) {
    FT_Outline_Funcs calls{};
    calls.move_to = [](const FT_Vector* to, void* self) {
      static_cast<FlatOutline*>(self)->at_ = in_glyph(*to);
      return 0;
    };
    calls.line_to = [](const FT_Vector* to, void* self) {
      static_cast<FlatOutline*>(self)->line(in_glyph(*to));
      return 0;
    };
    calls.conic_to = [](const FT_Vector* control, const FT_Vector* to, void* self) {
      auto& flat = *static_cast<FlatOutline*>(self);
      const Point a = flat.at_;
      const Point b = in_glyph(*control);
      const Point c = in_glyph(*to);
      constexpr int kPieces = 16;
      for (int i = 1; i <= kPieces; ++i) {
        const double t = static_cast<double>(i) / kPieces;
        flat.line(a * ((1 - t) * (1 - t)) + b * (2 * t * (1 - t)) + c * (t * t));
      }
      return 0;
    };
    calls.cubic_to = [](const FT_Vector*, const FT_Vector*, const FT_Vector*, void*) { return 1; };
    EXPECT_EQ(FT_Outline_Decompose(&outline, &calls, this), 0);
  }

  /// How often the outline goes round a point, clockwise on the screen.
  [[nodiscard]] int winding(Point p) const {
    int turns = 0;
    for (const auto& [a, b] : lines_) {
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      const double x = a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
      if (x > p.x) turns += b.y > a.y ? 1 : -1;
    }
    return turns;
  }

  [[nodiscard]] static Point in_glyph(const FT_Vector& v) {
    return {static_cast<double>(v.x) * 109 / 1000, static_cast<double>(880 - v.y) * 109 / 1000};
  }

 private:
  void line(Point to) {
    lines_.push_back({at_, to});
    at_ = to;
  }
  std::vector<std::array<Point, 2>> lines_;
  Point at_;
};

/// How far a point is from the area that a disc sweeps from one place to another, growing evenly; below 0 in
/// it. The distance to the disc at t is convex in t, so its least value is in closed form.
inline double distance_to_sweep(geometry::GlyphPoint p, geometry::GlyphPoint a, double ra,
                                geometry::GlyphPoint b, double rb) {
  const double far = distance(a, b);
  if (far <= std::abs(ra - rb)) return ra > rb ? distance(p, a) - ra : distance(p, b) - rb;
  const geometry::GlyphPoint forward = (b - a) * (1 / far);
  const double along = dot(p - a, forward);
  const double beside = std::abs(dot(p - a, geometry::GlyphPoint{forward.y, -forward.x}));
  const double lean = (ra - rb) / far;
  const double t = std::clamp(along - beside * lean / std::sqrt(1 - lean * lean), 0.0, far);
  return distance(p, a + forward * t) - (ra + (rb - ra) * t / far);
}

/// The same for all strokes. Lines are at least 1 unit wide, but for their tips: there 0.2, and in between
/// over the last 2 units, or a quarter of the line.
class GrooveDistance {
 public:
  explicit GrooveDistance(std::span<const OwnStroke> strokes) {
    for (const OwnStroke& stroke : strokes) lines_.push_back(carving::smooth_line(stroke.points));
    for (auto& line : lines_)
      for (auto& point : line) {
        const double length = line.back().arc_length;
        const double left = std::min(point.arc_length, length - point.arc_length);
        const double run = std::min(2.0, length / 4);
        point.half_width = std::max(point.half_width, left < run ? 0.1 + 0.4 * left / run : 0.5);
      }
  }
  [[nodiscard]] double to(geometry::GlyphPoint p) const {
    double least = 1e9;
    for (const auto& line : lines_) {
      least = std::min(least, distance(p, line[0].at) - line[0].half_width);
      for (std::size_t i = 1; i < line.size(); ++i)
        least = std::min(least, distance_to_sweep(p, line[i - 1].at, line[i - 1].half_width, line[i].at,
                                                  line[i].half_width));
    }
    return least;
  }
  [[nodiscard]] const std::vector<std::vector<carving::SmoothPoint>>& lines() const { return lines_; }

 private:
  std::vector<std::vector<carving::SmoothPoint>> lines_;
};

}  // namespace nazori::author::test
