// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "nazori/base/result.h"
#include "nazori/surface/height_map.h"

namespace nazori::surface {

/// A height map from a file, as both programs read it: as a PNG where the content begins as one, whatever its
/// name is, else as an 8-bit RAW.
/// @param size  side in samples; without it the size comes from the PNG header or the length of the RAW.
/// @return the errors of parse_png() and parse_raw(); Errc::bad_argument for a PNG of another size.
[[nodiscard]] base::Result<HeightMap> load_height_map(const std::filesystem::path& path,
                                                      std::optional<int> size = {});

}  // namespace nazori::surface
