// SPDX-License-Identifier: Apache-2.0
#include "nazori/surface/height_map_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "nazori/base/file.h"

namespace nazori::surface {
namespace {

// 16 bits a sample, none of it compressible, plus the overhead of the format.
constexpr std::size_t kMaxBytes =
    std::size_t{HeightMap::kMaxSize} * HeightMap::kMaxSize * 2 + (std::size_t{16} << 20);

/// @source PNG specification, third edition, section 5.2.
bool begins_as_png(const std::vector<std::uint8_t>& bytes) {
  constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  return bytes.size() >= kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), bytes.begin());
}

}  // namespace

base::Result<HeightMap> load_height_map(const std::filesystem::path& path, std::optional<int> size) {
  const auto bytes = base::read_file(path, kMaxBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  const bool png = begins_as_png(*bytes);
  auto map = png ? parse_png(*bytes) : parse_raw(*bytes, size);
  if (!map) {
    base::Error error = std::move(map).error();
    error.where = path.string() + (error.where.empty() ? "" : ": " + error.where);
    return tl::unexpected(std::move(error));
  }
  if (png && size && *size != map->size()) {
    const std::string own = std::to_string(map->size());
    const std::string asked = std::to_string(*size);
    return base::fail(base::Errc::bad_argument,
                      "is a picture " + own + " x " + own + ", not " + asked + " x " + asked, path.string(),
                      "give no size: a PNG says its own");
  }
  return map;
}

}  // namespace nazori::surface
