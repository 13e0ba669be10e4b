// SPDX-License-Identifier: Apache-2.0
#include "strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace nazori::scan {
namespace {

using print::kMarkRows;
using print::kModule_mm;

/// How far the strip lies from where the discs say: paper is not quite flat.
struct Slip {
  double x_mm = 0;
  double y_mm = 0;
};

class Strip {
 public:
  Strip(const Photo& photo, const PageMap& map, double height_mm)
      : photo_(&photo), map_(&map), height_mm_(height_mm) {}

  /// Mean brightness of the middle of a module.
  [[nodiscard]] float module(int column, int row, Slip slip) const {
    const print::PaperPoint centre = print::module_centre(height_mm_, column, row);
    float sum = 0;
    for (const double v : {-0.2, 0.0, 0.2})
      for (const double u : {-0.2, 0.0, 0.2}) {
        const PhotoPoint p =
            map_->at({centre.x + slip.x_mm + u * kModule_mm, centre.y + slip.y_mm + v * kModule_mm});
        sum += photo_->sample(p.x, p.y);
      }
    return sum / 9;
  }

  /// How much brighter the bright modules of the alternating row are, between two columns: 0 to 1.
  [[nodiscard]] float contrast(int first, int last, Slip slip) const {
    float dark = 0;
    float bright = 0;
    for (int column = first; column < last; ++column)
      (column % 2 == 0 ? dark : bright) += module(column, 0, slip);
    return bright > 0 ? (bright - dark) / bright : 0;
  }

  /// The slip near `from` with the greatest contrast.
  [[nodiscard]] std::pair<float, Slip> best(int first, int last, Slip from, double reach_mm) const {
    std::pair<float, Slip> found{-1.0F, from};
    constexpr double kStep_mm = 0.12;
    for (double y = -reach_mm; y <= reach_mm + 1e-9; y += kStep_mm)
      for (double x = -reach_mm; x <= reach_mm + 1e-9; x += kStep_mm) {
        const Slip slip{from.x_mm + x, from.y_mm + y};
        const float c = contrast(first, last, slip) - static_cast<float>(0.02 * std::hypot(x, y));
        if (c > found.first) found = {c, slip};
      }
    return found;
  }

 private:
  const Photo* photo_;
  const PageMap* map_;
  double height_mm_;
};

constexpr int kPiece = 8;  // columns that are laid straight together
constexpr float kFaintest = 0.13F;

}  // namespace

std::optional<base::Result<print::SheetMark>> read_strip(const Photo& photo, const PageMap& map,
                                                         double width_mm, double height_mm) {
  constexpr int kShort = print::mark_columns(print::kFewestMarkBytes);
  const Strip strip(photo, map, height_mm);
  // Most places that are tried are none: a quick look first.
  auto [seen, slip] = strip.best(0, kPiece * 2, {}, 0.36);
  if (seen < kFaintest) return std::nullopt;
  const std::size_t room = print::mark_room(width_mm);
  const int columns = print::mark_columns(room);
  std::vector<std::uint8_t> bits;
  int read = 0;
  while (read < columns) {
    const int last = std::min(read + kPiece, columns);
    const auto [contrast, found] = strip.best(read, last, slip, 0.24);
    if (contrast < kFaintest && read >= kShort) break;
    if (contrast >= kFaintest) slip = found;
    float dark = 0;
    float bright = 0;
    for (int column = read; column < last; ++column)
      (column % 2 == 0 ? dark : bright) += strip.module(column, 0, slip);
    const int pairs = (last - read) / 2;
    if (pairs == 0) break;
    const float limit =
        (dark / static_cast<float>(last - read - pairs) + bright / static_cast<float>(pairs)) / 2;
    for (int column = read; column < last; ++column)
      for (int row = 1; row <= kMarkRows; ++row)
        bits.push_back(strip.module(column, row, slip) < limit ? 1 : 0);
    read = last;
  }
  std::vector<std::uint8_t> bytes(bits.size() / 8);
  for (std::size_t i = 0; i < bytes.size() * 8; ++i)
    bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] << 1U | bits[i]);
  // The number of bytes is not written down: the checksum tells the right one.
  base::Result<print::SheetMark> result = base::fail(base::Errc::parse, "");
  for (std::size_t length = print::kFewestMarkBytes; length <= bytes.size(); length += print::kMarkStep) {
    auto mark = print::read_mark(std::span(bytes).first(length));
    if (mark) return mark;
    if (length == print::kFewestMarkBytes || mark.error().code == base::Errc::schema)
      result = std::move(mark);
  }
  return result;
}

}  // namespace nazori::scan
