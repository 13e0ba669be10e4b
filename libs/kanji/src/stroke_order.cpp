// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/stroke_order.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "nazori/base/file.h"
#include "nazori/geometry/frames.h"
#include "nazori/geometry/needed_points.h"
#include "nazori/geometry/polyline.h"

namespace nazori::kanji {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{64} << 20U;

/// Reads consecutive little-endian int32 values and tracks the offset.
class Int32Reader {
 public:
  explicit Int32Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - offset_; }
  /// @pre left() >= 4.
  std::int32_t next() {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < 4; ++i) value |= std::uint32_t{bytes_[offset_ + i]} << (8U * i);
    offset_ += 4;
    return static_cast<std::int32_t>(value);
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t offset_ = 0;
};

std::string at_byte(std::size_t offset) { return "byte " + std::to_string(offset); }

base::Result<std::int32_t> read_count(Int32Reader& reader, const std::string& what, int least, int most) {
  const std::size_t offset = reader.offset();
  if (reader.left() < 4)
    return base::fail(base::Errc::parse, "the file ends before the number of " + what, at_byte(offset));
  const std::int32_t count = reader.next();
  if (count < least || count > most) {
    return base::fail(base::Errc::parse, "the number of " + what + " is " + std::to_string(count),
                      at_byte(offset),
                      std::to_string(least) + " to " + std::to_string(most) + " are allowed");
  }
  return count;
}

void append(std::vector<std::uint8_t>& bytes, std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  for (unsigned i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(bits >> (8U * i)));
}

/// True where the last segment is a hook: short compared with the rest and turned by more than 60 degrees.
bool ends_with_kick(const geometry::Polyline<geometry::GlyphFrame>& points) {
  if (points.size() < 3) return false;
  const auto last = points[points.size() - 1] - points[points.size() - 2];
  const auto before = points[points.size() - 2] - points[points.size() - 3];
  double rest = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) rest += geometry::distance(points[i - 1], points[i]);
  const double lengths = geometry::length(last) * geometry::length(before);
  constexpr double kShort = 0.4;  // of the rest of the stroke
  return geometry::length(last) <= kShort * rest && geometry::dot(last, before) < 0.5 * lengths;
}

}  // namespace

base::Result<StrokeOrder> StrokeOrder::parse(std::span<const std::uint8_t> bytes, int grid_size) {
  if (grid_size < 2 || grid_size > kMaxGrid) {
    return base::fail(base::Errc::bad_argument,
                      "a grid cannot have " + std::to_string(grid_size) + " samples a side", "grid_size",
                      "give 2 to " + std::to_string(kMaxGrid));
  }
  Int32Reader reader(bytes);
  const auto stroke_count = read_count(reader, "strokes", 0, kMaxStrokes);
  if (!stroke_count) return tl::unexpected(stroke_count.error());
  std::vector<Points> strokes;
  for (std::int32_t i = 0; i < *stroke_count; ++i) {
    const std::string stroke_name = "stroke " + std::to_string(i + 1);
    const auto point_count = read_count(reader, "points of " + stroke_name, 1, kMaxPointsPerStroke);
    if (!point_count) return tl::unexpected(point_count.error());
    const auto count = static_cast<std::size_t>(*point_count);
    if (reader.left() < 8 * count) {
      return base::fail(
          base::Errc::parse,
          "the file ends within " + stroke_name + ", which should have " + std::to_string(count) + " points",
          at_byte(bytes.size()));
    }
    Points points(count);
    for (StrokeOrderPoint& point : points) {
      const std::size_t offset = reader.offset();
      point.x = reader.next();
      point.y = reader.next();
      if (point.x < 0 || point.y < 0 || point.x >= grid_size || point.y >= grid_size) {
        return base::fail(base::Errc::parse,
                          "a point of " + stroke_name + " is at (" + std::to_string(point.x) + ", " +
                              std::to_string(point.y) + ")",
                          at_byte(offset), "columns and rows go from 0 to " + std::to_string(grid_size - 1));
      }
    }
    strokes.push_back(std::move(points));
  }
  if (reader.left() != 0) {
    return base::fail(base::Errc::parse,
                      std::to_string(reader.left()) + " bytes are left over after the last stroke",
                      at_byte(reader.offset()));
  }
  return StrokeOrder(std::move(strokes));
}

std::vector<std::uint8_t> StrokeOrder::to_bytes() const {
  std::vector<std::uint8_t> bytes;
  std::size_t points = 0;
  for (const Points& stroke : strokes_) points += stroke.size();
  bytes.reserve(4 + 4 * strokes_.size() + 8 * points);
  append(bytes, static_cast<std::int32_t>(strokes_.size()));
  for (const Points& stroke : strokes_) {
    append(bytes, static_cast<std::int32_t>(stroke.size()));
    for (const StrokeOrderPoint point : stroke) {
      append(bytes, point.x);
      append(bytes, point.y);
    }
  }
  return bytes;
}

base::Result<StrokeOrder> StrokeOrder::load(const std::filesystem::path& path, int grid_size) {
  const auto bytes = base::read_file(path, kMaxFileBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto order = parse(*bytes, grid_size);
  if (!order && order.error().code == base::Errc::parse) {
    base::Error error = std::move(order).error();
    error.where = path.string() + ": " + error.where;
    return tl::unexpected(std::move(error));
  }
  return order;
}

base::Result<void> StrokeOrder::save(const std::filesystem::path& path) const {
  return base::write_file(path, to_bytes());
}

StrokeOrder StrokeOrder::from_lines(std::span<const geometry::Polyline<geometry::GlyphFrame>> lines,
                                    int grid_size) {
  // Leaving out points and rounding the rest may together move the line by at most one sample.
  constexpr double kTolerance = 0.25;
  StrokeOrder order;
  const double last = grid_size - 1;
  for (const auto& line : lines) {
    std::vector<geometry::GridPoint> grid;
    grid.reserve(line.size());
    for (const geometry::GlyphPoint p : line) grid.push_back(geometry::glyph_to_grid(p, grid_size));
    Points points;
    for (const std::size_t i :
         geometry::needed_points(std::span<const geometry::GridPoint>(grid), kTolerance)) {
      const geometry::GridPoint p = grid[i];
      const auto whole = [last](double v) {
        return static_cast<std::int32_t>(std::lround(std::isfinite(v) ? std::clamp(v, 0.0, last) : 0.0));
      };
      const StrokeOrderPoint rounded{whole(p.x), whole(p.y)};
      if (points.empty() || !(points.back() == rounded)) points.push_back(rounded);
    }
    if (!points.empty()) order.add_stroke(std::move(points));
  }
  return order;
}

std::vector<StrokeLine> StrokeOrder::to_lines(int grid_size) const {
  std::vector<StrokeLine> lines;
  lines.reserve(strokes_.size());
  for (const Points& stroke : strokes_) {
    StrokeLine line;
    line.points.reserve(stroke.size());
    for (const StrokeOrderPoint point : stroke) {
      line.points.push_back(geometry::grid_to_glyph(
          geometry::GridPoint{static_cast<double>(point.x), static_cast<double>(point.y)}, grid_size));
    }
    line.ending = ends_with_kick(line.points) ? StrokeEnding::hook : StrokeEnding::either;
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace nazori::kanji
