// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "nazori/base/result.h"
#include "nazori/calligraphy/brush_stroke.h"
#include "nazori/paint/sheet.h"

namespace nazori::calligraphy {

/// The strokes as SVG, in millimetres on a sheet of paint::Sheet::kSide_m: one filled path for each stroke,
/// in their order, its outline with the width of the brush. Without paper, texture and bleeding.
[[nodiscard]] std::string to_svg(std::span<const BrushStroke> strokes);
/// Written beside and renamed. @return Errc::not_found where there are no strokes.
[[nodiscard]] base::Result<void> save_svg(std::span<const BrushStroke> strokes,
                                          const std::filesystem::path& path);
/// The sheet as it looks, at its real size in the middle of a page of A4. Written beside and renamed.
[[nodiscard]] base::Result<void> save_pdf(const paint::Sheet& sheet, std::string_view title,
                                          const std::filesystem::path& path);

}  // namespace nazori::calligraphy
