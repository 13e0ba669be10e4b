// SPDX-License-Identifier: Apache-2.0
#include "nazori/print/picture_page.h"

#include <fmt/format.h>

#include "pdf_writer.h"

namespace nazori::print {
namespace {

constexpr double kPoints = 72 / 25.4;
constexpr double kPageWidth_mm = 210, kPageHeight_mm = 297;

}  // namespace

base::Result<std::string> picture_page(const PagePicture& picture, std::string_view title) {
  if (picture.width <= 0 || picture.height <= 0 ||
      picture.rgb.size() !=
          std::size_t{3} * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height))
    return base::fail(base::Errc::bad_argument, "the picture has no pixels, or too few bytes", "PDF");
  const double height_mm = picture.width_mm * picture.height / picture.width;
  if (!(picture.width_mm > 0 && picture.width_mm <= kPageWidth_mm && height_mm <= kPageHeight_mm))
    return base::fail(
        base::Errc::bad_argument,
        fmt::format("a picture of {:.1f} x {:.1f} mm does not fit on A4", picture.width_mm, height_mm),
        "PDF");
  PdfWriter pdf;
  const int catalogue = pdf.reserve();
  const int tree = pdf.reserve();
  const int information = pdf.reserve();
  const int page = pdf.reserve();
  const int image = pdf.reserve();
  const int content = pdf.reserve();
  pdf.write_stream(image,
                   fmt::format("/Type /XObject /Subtype /Image /Width {} /Height {} /ColorSpace /DeviceRGB "
                               "/BitsPerComponent 8",
                               picture.width, picture.height),
                   {reinterpret_cast<const char*>(picture.rgb.data()), picture.rgb.size()});
  pdf.write_stream(content, "",
                   fmt::format("q {:.4f} 0 0 {:.4f} {:.4f} {:.4f} cm /S Do Q\n", picture.width_mm * kPoints,
                               height_mm * kPoints, (kPageWidth_mm - picture.width_mm) / 2 * kPoints,
                               (kPageHeight_mm - height_mm) / 2 * kPoints));
  pdf.write(page, fmt::format("<< /Type /Page /Parent {} 0 R /MediaBox [0 0 {:.4f} {:.4f}] /Resources << "
                              "/XObject << /S {} 0 R >> >> /Contents {} 0 R >>",
                              tree, kPageWidth_mm * kPoints, kPageHeight_mm * kPoints, image, content));
  pdf.write(tree, fmt::format("<< /Type /Pages /Kids [{} 0 R] /Count 1 >>", page));
  pdf.write(
      catalogue,
      fmt::format("<< /Type /Catalog /Pages {} 0 R /ViewerPreferences << /PrintScaling /None >> >>", tree));
  pdf.write(information, fmt::format("<< /Title {} /Producer (Nazori) >>", pdf_text(title)));
  return pdf.finish(catalogue, information);
}

}  // namespace nazori::print
