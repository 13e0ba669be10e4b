// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/geometry/svg_path.h"

/// Any text is either refused or gives finite pieces and a line from its first to its last point without
/// repeated points.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using nazori::geometry::GlyphPoint;
  const auto path =
      nazori::geometry::parse_svg_path(std::string_view(reinterpret_cast<const char*>(data), size));
  if (!path) return path.error().where.empty() ? std::abort(), 0 : 0;
  double reach = 1;
  for (const auto& piece : path->pieces) {
    for (const GlyphPoint p : piece) reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
  }
  if (!std::isfinite(reach)) std::abort();
  const auto line = nazori::geometry::flatten(*path, reach / 1000);
  const GlyphPoint end = path->pieces.empty() ? path->start : path->pieces.back()[2];
  if (line.empty() || line.front() != path->start || line.back() != end) std::abort();
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == line[i - 1]) std::abort();
  }
  return 0;
}
