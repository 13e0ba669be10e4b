// SPDX-License-Identifier: Apache-2.0
#include "sheets.h"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "pdf_writer.h"

namespace nazori::print {
namespace {

constexpr double kPoints = 72 / 25.4;

}  // namespace

std::string Sheets::file() {
  PdfWriter pdf;
  const int catalogue = pdf.reserve();
  const int tree = pdf.reserve();
  const int information = pdf.reserve();
  const int resources = pdf.reserve();
  std::string fonts;
  for (std::size_t i = 0; i < fonts_.count(); ++i) {
    if (fonts_.at(i).used().empty()) continue;
    const int number = pdf.reserve();
    fonts += fmt::format("/F{} {} 0 R ", i, number);
    pdf.write_font(number, fonts_.at(i));
  }
  const auto box = [](double width, double height) {
    return fmt::format("[0 0 {} {}]", number(width * kPoints), number(height * kPoints));
  };
  std::string objects;
  for (const auto& [kind, name] : cells_) {
    const double side = static_cast<double>(kind.first) / 1000;
    constexpr double kRoom_mm = 1;  // for the width of its lines
    Canvas canvas(fonts_, side);
    if (kind.second) {
      draw_cell(canvas, {0, 0, side, side}, s_.guide);
    } else {
      canvas.rectangle({0, 0, side, side}, {0.7, 0.15, 0});
    }
    const int number_of = pdf.reserve();
    objects += fmt::format("/{} {} 0 R ", name, number_of);
    const std::string low = number(-kRoom_mm * kPoints);
    const std::string high = number((side + kRoom_mm) * kPoints);
    pdf.write_stream(number_of,
                     fmt::format("/Type /XObject /Subtype /Form /BBox [{0} {0} {1} {1}]", low, high),
                     canvas.content());
  }
  for (const std::size_t i : used_) {
    const int number = pdf.reserve();
    objects += fmt::format("/C{} {} 0 R ", i, number);
    const kanji::Character& character = characters_[i].character;
    pdf.write_stream(number, "/Type /XObject /Subtype /Form /BBox [-3 -3 112 112]",
                     strokes_content(character, 0, character.strokes.size()));
  }
  std::vector<int> sheets;
  const auto add_sheet = [&](double width, double height, const std::string& content) {
    const int stream = pdf.reserve();
    const int sheet = pdf.reserve();
    pdf.write_stream(stream, "", content);
    pdf.write(sheet,
              fmt::format("<< /Type /Page /Parent {} 0 R /MediaBox {} /Resources {} 0 R /Contents {} 0 R >>",
                          tree, box(width, height), resources, stream));
    sheets.push_back(sheet);
  };
  if (s_.booklet) {
    std::vector<int> halves;
    for (const auto& page : pages_) {
      const int number = pdf.reserve();
      halves.push_back(number);
      pdf.write_stream(number,
                       fmt::format("/Type /XObject /Subtype /Form /BBox {} /Resources {} 0 R",
                                   box(size_.width, size_.height), resources),
                       page->content());
      objects += fmt::format("/P{} {} 0 R ", halves.size() - 1, number);
    }
    const std::size_t count = (halves.size() + 3) / 4 * 4;
    // A vertical text is read from right to left, so the booklet opens at its other side.
    const auto side = [&](std::size_t left, std::size_t right) {
      if (s_.vertical) std::swap(left, right);
      std::string content;
      if (left < halves.size()) content += fmt::format("/P{} Do\n", left);
      if (right < halves.size())
        content += fmt::format("q 1 0 0 1 {} 0 cm /P{} Do Q\n", number(size_.width * kPoints), right);
      add_sheet(2 * size_.width, size_.height, content);
    };
    for (std::size_t i = 0; i < count / 4; ++i) {
      side(count - 1 - 2 * i, 2 * i);
      side(2 * i + 1, count - 2 - 2 * i);
    }
  } else {
    for (const auto& page : pages_) add_sheet(size_.width, size_.height, page->content());
  }
  pdf.write(resources, fmt::format("<< /Font << {}>> /XObject << {}>> >>", fonts, objects));
  std::string kids;
  for (const int sheet : sheets) kids += fmt::format("{} 0 R ", sheet);
  pdf.write(tree, fmt::format("<< /Type /Pages /Kids [{}] /Count {} >>", kids, sheets.size()));
  pdf.write(catalogue, fmt::format("<< /Type /Catalog /Pages {} 0 R /Lang ({}) >>", tree,
                                   s_.language == Language::japanese ? "ja" : "en"));
  pdf.write(information, fmt::format("<< /Title {} /Producer (Nazori) >>", pdf_text(s_.title)));
  return pdf.finish(catalogue, information);
}

}  // namespace nazori::print
