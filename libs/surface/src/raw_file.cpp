// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "levels.h"
#include "nazori/base/file.h"
#include "nazori/surface/height_map.h"

namespace nazori::surface {
namespace {

constexpr std::size_t kMaxBytes =
    static_cast<std::size_t>(HeightMap::kMaxSize) * static_cast<std::size_t>(HeightMap::kMaxSize);

std::size_t square(int side) { return static_cast<std::size_t>(side) * static_cast<std::size_t>(side); }

std::string bytes_of(int side) {
  return std::to_string(square(side)) + " (" + std::to_string(side) + " x " + std::to_string(side) + ")";
}

/// The side of the square of `length` bytes, or an error that names a valid length.
base::Result<int> side_of(std::size_t length) {
  if (length > kMaxBytes) {
    return base::fail(base::Errc::parse, "has " + std::to_string(length) + " bytes; the limit is " +
                                             bytes_of(HeightMap::kMaxSize));
  }
  const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(length))));
  if (side >= HeightMap::kMinSize && square(side) == length) return side;
  const int below = std::max(HeightMap::kMinSize, square(side) > length ? side - 1 : side);
  return base::fail(base::Errc::parse,
                    "has " + std::to_string(length) + " bytes, which is no square of " +
                        std::to_string(HeightMap::kMinSize) + " or more a side",
                    {}, "a whole file has " + bytes_of(below) + " or " + bytes_of(below + 1) + " bytes");
}

}  // namespace

base::Result<HeightMap> parse_raw(std::span<const std::uint8_t> bytes, std::optional<int> size) {
  if (size && (*size < HeightMap::kMinSize || *size > HeightMap::kMaxSize)) {
    auto refused = HeightMap::create(*size);
    return refused;
  }
  if (bytes.empty()) {
    return base::fail(base::Errc::parse, "is empty", {},
                      size ? "a map of that size has " + bytes_of(*size) + " bytes"
                           : "a height map has at least " + bytes_of(HeightMap::kMinSize) + " bytes");
  }
  if (size && square(*size) != bytes.size()) {
    return base::fail(base::Errc::parse, "has " + std::to_string(bytes.size()) + " bytes", {},
                      "a map of that size has " + bytes_of(*size) + " bytes");
  }
  const base::Result<int> side = size ? base::Result<int>(*size) : side_of(bytes.size());
  if (!side) return tl::unexpected(side.error());
  auto map = HeightMap::create(*side);
  if (!map) return map;
  std::transform(bytes.begin(), bytes.end(), map->samples().begin(),
                 [](std::uint8_t level) { return static_cast<float>(level) / 255.0F; });
  return map;
}

std::vector<std::uint8_t> to_raw(const HeightMap& map) {
  std::vector<std::uint8_t> bytes(map.samples().size());
  std::transform(map.samples().begin(), map.samples().end(), bytes.begin(),
                 [](float height) { return static_cast<std::uint8_t>(level_of(height, 255.0F)); });
  return bytes;
}

base::Result<HeightMap> load_raw(const std::filesystem::path& path, std::optional<int> size) {
  const auto bytes = base::read_file(path, kMaxBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto map = parse_raw(*bytes, size);
  if (!map && map.error().code == base::Errc::parse) {
    base::Error error = std::move(map).error();
    error.where = path.string();
    return tl::unexpected(std::move(error));
  }
  return map;
}

base::Result<void> save_raw(const HeightMap& map, const std::filesystem::path& path) {
  if (!map.is_loaded())
    return base::fail(base::Errc::bad_argument, "there is no height map to save", path.string());
  return base::write_file(path, to_raw(map));
}

}  // namespace nazori::surface
