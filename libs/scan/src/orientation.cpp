// SPDX-License-Identifier: Apache-2.0
#include "orientation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace nazori::scan {
namespace {

/// Numbers of a file in either order of bytes; 0 outside it.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes, bool big_endian = true)
      : bytes_(bytes), big_endian_(big_endian) {}
  [[nodiscard]] std::size_t u16(std::size_t at) const {
    return big_endian_ ? byte(at) << 8U | byte(at + 1) : byte(at + 1) << 8U | byte(at);
  }
  [[nodiscard]] std::size_t u32(std::size_t at) const {
    return big_endian_ ? u16(at) << 16U | u16(at + 2) : u16(at + 2) << 16U | u16(at);
  }

 private:
  [[nodiscard]] std::size_t byte(std::size_t at) const { return at < bytes_.size() ? bytes_[at] : 0; }
  std::span<const std::uint8_t> bytes_;
  bool big_endian_;
};

/// @param tiff  what follows "Exif\0\0".
int orientation_of(std::span<const std::uint8_t> tiff) {
  constexpr std::size_t kEntry = 12;
  constexpr std::size_t kOrientation = 0x0112;
  constexpr std::size_t kShort = 3;
  if (tiff.size() < 8 || tiff[0] != tiff[1] || (tiff[0] != 'M' && tiff[0] != 'I')) return 1;
  const Bytes numbers(tiff, tiff[0] == 'M');
  const std::size_t directory = numbers.u32(4);
  const std::size_t entries = numbers.u16(directory);
  for (std::size_t i = 0; i < entries && directory + 2 + (i + 1) * kEntry <= tiff.size(); ++i) {
    const std::size_t entry = directory + 2 + i * kEntry;
    if (numbers.u16(entry) != kOrientation || numbers.u16(entry + 2) != kShort) continue;
    const auto orientation = static_cast<int>(numbers.u16(entry + 8));
    return orientation >= 1 && orientation <= 8 ? orientation : 1;
  }
  return 1;
}

}  // namespace

int exif_orientation(std::span<const std::uint8_t> jpeg) {
  constexpr std::array<std::uint8_t, 6> kExif{'E', 'x', 'i', 'f', 0, 0};
  constexpr std::uint8_t kMarker = 0xFF;
  constexpr std::uint8_t kApplication1 = 0xE1;
  constexpr std::uint8_t kStartOfScan = 0xDA;
  std::size_t at = 2;
  while (at + 4 <= jpeg.size() && jpeg[at] == kMarker && jpeg[at + 1] != kStartOfScan) {
    const std::size_t length = Bytes(jpeg).u16(at + 2);
    if (length < 2) return 1;
    if (jpeg[at + 1] == kApplication1) {
      auto content = jpeg.subspan(at + 4);
      content = content.first(std::min(content.size(), length - 2));
      if (content.size() > kExif.size() && std::ranges::equal(content.first(kExif.size()), kExif))
        return orientation_of(content.subspan(kExif.size()));
    }
    at += 2 + length;
  }
  return 1;
}

Photo upright(Photo photo, int orientation) {
  if (orientation <= 1) return photo;
  const bool is_turned = orientation >= 5;
  const int right = photo.width - 1;
  const int bottom = photo.height - 1;
  Photo out;
  out.width = is_turned ? photo.height : photo.width;
  out.height = is_turned ? photo.width : photo.height;
  out.grey.reserve(photo.grey.size());
  const auto stored = [&](int x, int y) -> std::pair<int, int> {
    switch (orientation) {
      case 2:
        return {right - x, y};
      case 3:
        return {right - x, bottom - y};
      case 4:
        return {x, bottom - y};
      case 5:
        return {y, x};
      case 6:
        return {y, bottom - x};
      case 7:
        return {right - y, bottom - x};
      default:
        return {right - y, x};
    }
  };
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const auto [column, row] = stored(x, y);
      out.grey.push_back(photo.at(column, row));
    }
  }
  return out;
}

}  // namespace nazori::scan
