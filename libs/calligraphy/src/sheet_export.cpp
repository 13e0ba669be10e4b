// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/sheet_export.h"

#include <fmt/format.h>

#include "nazori/base/file.h"
#include "nazori/paint/sheet_picture.h"
#include "nazori/print/picture_page.h"

namespace nazori::calligraphy {
namespace {

constexpr double kMillimetres = 1000;

}  // namespace

std::string to_svg(std::span<const BrushStroke> strokes) {
  constexpr double kSide_mm = paint::Sheet::kSide_m * kMillimetres;
  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.1f}mm\" height=\"{0:.1f}mm\" "
      "viewBox=\"0 0 {0:.1f} {0:.1f}\" fill=\"#1c1a19\" fill-rule=\"evenodd\">\n",
      kSide_mm);
  int number = 0;
  for (const BrushStroke& stroke : strokes) {
    ++number;
    const auto outline = outline_of(shape_of(stroke));
    if (outline.empty()) continue;
    svg += fmt::format("<path id=\"stroke-{}\" d=\"", number);
    for (const auto& loop : outline) {
      char step = 'M';
      for (const geometry::PaperPoint at : loop) {
        svg += fmt::format("{}{:.3f},{:.3f}", step, at.x * kMillimetres + kSide_mm / 2,
                           kSide_mm / 2 - at.y * kMillimetres);
        step = 'L';
      }
      svg += 'Z';
    }
    svg += "\"/>\n";
  }
  return svg + "</svg>\n";
}

base::Result<void> save_svg(std::span<const BrushStroke> strokes, const std::filesystem::path& path) {
  if (strokes.empty())
    return base::fail(base::Errc::not_found, "there are no strokes; those of an opened sheet are not known",
                      path.filename().string());
  return base::write_file(path, to_svg(strokes));
}

base::Result<void> save_pdf(const paint::Sheet& sheet, std::string_view title,
                            const std::filesystem::path& path) {
  paint::SheetPicture drawn;
  drawn.update(sheet);
  const auto& picture = drawn.picture();
  const auto pdf = print::picture_page(
      {picture.width, picture.height, picture.rgb, paint::Sheet::kSide_m * kMillimetres}, title);
  if (!pdf) return tl::unexpected(pdf.error());
  return base::write_file(path, *pdf);
}

}  // namespace nazori::calligraphy
