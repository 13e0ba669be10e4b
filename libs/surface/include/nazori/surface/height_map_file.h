// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "nazori/base/result.h"
#include "nazori/surface/height_map.h"

namespace nazori::surface {

/// A height map of one's own, as both programs read it: a PNG where the file begins as one, whatever its name
/// is, else an 8-bit RAW.
/// @param size  side in samples; without it a PNG says it, and the length of a RAW.
/// @return the errors of parse_png() and parse_raw(); Errc::bad_argument for a PNG of another size.
[[nodiscard]] base::Result<HeightMap> load_height_map(const std::filesystem::path& path,
                                                      std::optional<int> size = {});

}  // namespace nazori::surface
