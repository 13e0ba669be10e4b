// SPDX-License-Identifier: Apache-2.0
#include "stroke_bytes.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "nazori/base/bytes.h"
#include "nazori/paint/sheet_file.h"

namespace nazori::calligraphy {
namespace {

using base::ByteReader;
using base::ByteWriter;

constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kPointBytes = 8 * 8 + 2;
/// Sheets are a few decimetres large, and a pen may slip off.
constexpr double kFurthest_m = 10;

void append(ByteWriter& out, const BrushPoint& point) {
  for (const double value : {point.time_s, point.pen.x, point.pen.y, point.at.x, point.at.y,
                             point.half_width_m, point.lean_rad, point.lean_to_rad})
    out.f64(value);
  out.u8(static_cast<std::uint8_t>(point.width_from));
  out.u8(point.pressure ? 1 : 0);
  if (point.pressure) out.f64(*point.pressure);
}

bool is_possible(const BrushPoint& point) {
  for (const double value : {point.time_s, point.lean_rad, point.lean_to_rad})
    if (!std::isfinite(value)) return false;
  for (const double value : {point.pen.x, point.pen.y, point.at.x, point.at.y})
    if (!(std::abs(value) <= kFurthest_m)) return false;
  const double pressure = point.pressure.value_or(0);
  return point.half_width_m >= 0 && point.half_width_m <= kFurthest_m && pressure >= 0 && pressure <= 1;
}

/// @return nothing for a point that no brush has.
std::optional<BrushPoint> next_point(ByteReader& in) {
  BrushPoint point;
  for (double* value : {&point.time_s, &point.pen.x, &point.pen.y, &point.at.x, &point.at.y,
                        &point.half_width_m, &point.lean_rad, &point.lean_to_rad})
    *value = in.f64();
  const std::uint8_t from = in.u8(), has_pressure = in.u8();
  if (from > static_cast<std::uint8_t>(WidthFrom::nothing) || has_pressure > 1) return std::nullopt;
  point.width_from = static_cast<WidthFrom>(from);
  if (has_pressure == 1) point.pressure = in.f64();
  if (!in.ok() || !is_possible(point)) return std::nullopt;
  return point;
}

}  // namespace

std::vector<std::uint8_t> to_bytes(const std::vector<BrushStroke>& strokes) {
  if (strokes.empty()) return {};
  ByteWriter out;
  out.u32(kVersion);
  out.count(strokes.size());
  for (const BrushStroke& stroke : strokes) {
    out.count(stroke.size());
    for (const BrushPoint& point : stroke) append(out, point);
  }
  if (out.bytes().size() > paint::kMostAttached) return {};
  return std::move(out.bytes());
}

base::Result<std::vector<BrushStroke>> parse_strokes(std::span<const std::uint8_t> bytes) {
  const auto impossible = [] { return base::fail(base::Errc::parse, "has strokes that no brush writes"); };
  std::vector<BrushStroke> strokes;
  if (bytes.empty()) return strokes;
  ByteReader in(bytes);
  const std::uint32_t version = in.u32();
  if (version != kVersion)
    return base::fail(base::Errc::schema, "has strokes of version " + std::to_string(version), {},
                      "open it with a newer Nazori");
  strokes.resize(in.count(sizeof(std::uint32_t)));
  for (BrushStroke& stroke : strokes) {
    const std::size_t points = in.count(kPointBytes);
    stroke.reserve(points);
    for (std::size_t i = 0; i < points; ++i) {
      const auto point = next_point(in);
      if (!point || (i > 0 && point->time_s < stroke.back().time_s)) return impossible();
      stroke.push_back(*point);
    }
  }
  if (!in.ok() || in.left() != 0) return impossible();
  return strokes;
}

}  // namespace nazori::calligraphy
