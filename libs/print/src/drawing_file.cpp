// SPDX-License-Identifier: Apache-2.0
#include "nazori/print/drawing_file.h"

#include <fmt/format.h>

#include <cassert>
#include <cstddef>

#include "canvas.h"
#include "pdf_writer.h"

namespace nazori::print {
namespace {

constexpr double kPoints = 72 / 25.4;

std::string content_of(const PageDrawing& page) {
  const auto at = [&page](PaperPoint p) {
    return number(p.x * kPoints) + ' ' + number((page.height_mm - p.y) * kPoints) + ' ';
  };
  std::string content;
  for (const PageMark& mark : page.marks) {
    const std::string grey = number(mark.grey);
    if (mark.filled) {
      content += grey + " g ";
    } else {
      const std::string dash = mark.dash_mm > 0 ? number(mark.dash_mm * kPoints) : "";
      content += fmt::format("{} G {} w {} J {} j [{}] 0 d ", grey, number(mark.width_mm * kPoints),
                             mark.round ? 1 : 0, mark.round ? 1 : 0, dash);
    }
    for (const PathStep& step : mark.path) {
      switch (step.kind) {
        case PathStep::Kind::move:
          content += at(step.points[0]) + "m ";
          break;
        case PathStep::Kind::line:
          content += at(step.points[0]) + "l ";
          break;
        case PathStep::Kind::curve:
          content += at(step.points[0]) + at(step.points[1]) + at(step.points[2]) + "c ";
          break;
        case PathStep::Kind::close:
          content += "h ";
          break;
      }
    }
    content += mark.filled ? "f\n" : "S\n";
  }
  return content;
}

}  // namespace

std::string drawing_pdf(std::span<const PageDrawing> pages, std::string_view title) {
  assert(!pages.empty());
  PdfWriter pdf;
  const int catalogue = pdf.reserve();
  const int tree = pdf.reserve();
  const int information = pdf.reserve();
  std::string kids;
  for (const PageDrawing& page : pages) {
    const int stream = pdf.reserve();
    const int sheet = pdf.reserve();
    pdf.write_stream(stream, "", content_of(page));
    pdf.write(sheet,
              fmt::format(
                  "<< /Type /Page /Parent {} 0 R /MediaBox [0 0 {} {}] /Resources << >> /Contents {} 0 R >>",
                  tree, number(page.width_mm * kPoints), number(page.height_mm * kPoints), stream));
    kids += fmt::format("{} 0 R ", sheet);
  }
  pdf.write(tree, fmt::format("<< /Type /Pages /Kids [{}] /Count {} >>", kids, pages.size()));
  pdf.write(catalogue, fmt::format("<< /Type /Catalog /Pages {} 0 R >>", tree));
  pdf.write(information, fmt::format("<< /Title {} /Producer (Nazori) >>", pdf_text(title)));
  return pdf.finish(catalogue, information);
}

}  // namespace nazori::print
