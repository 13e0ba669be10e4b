// SPDX-License-Identifier: Apache-2.0
#include "sheets.h"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "content_reader.h"
#include "pdf_writer.h"

namespace nazori::print {
namespace {

constexpr double kPoints = 72 / 25.4;

}  // namespace

std::size_t Sheets::side_count() const { return s_.booklet ? (pages_.size() + 3) / 4 * 2 : pages_.size(); }

Sheets::Side Sheets::content_of_side(std::size_t index) const {
  if (!s_.booklet) return {size_, pages_[index]->content()};
  // Of each sheet the front has the outer pages, the back the inner ones.
  const std::size_t count = (pages_.size() + 3) / 4 * 4;
  std::size_t left = index % 2 == 0 ? count - 1 - index : index;
  std::size_t right = index % 2 == 0 ? index : count - 1 - index;
  // A vertical text is read from right to left, so the booklet opens at its other side.
  if (s_.vertical) std::swap(left, right);
  Side side{{2 * size_.width, size_.height}, {}};
  if (left < pages_.size()) side.content += fmt::format("/P{} Do\n", left);
  if (right < pages_.size())
    side.content += fmt::format("q 1 0 0 1 {} 0 cm /P{} Do Q\n", number(size_.width * kPoints), right);
  return side;
}

std::string Sheets::content_of_object(std::string_view name) {
  std::size_t index = 0;
  std::from_chars(name.data() + 1, name.data() + name.size(), index);
  switch (name.front()) {
    case 'G':
      for (const auto& [kind, cell] : cells_) {
        if (cell != name) continue;
        const double side = static_cast<double>(kind.first) / 1000;
        Canvas canvas(fonts_, side);
        if (kind.second) {
          draw_cell(canvas, {0, 0, side, side}, s_.guide);
        } else {
          canvas.rectangle({0, 0, side, side}, {0.7, 0.15, 0});
        }
        return canvas.content();
      }
      return {};
    case 'C': {
      const kanji::Character& character = characters_[index].character;
      return s_.layout == Layout::brush ? brush_content(character)
                                        : strokes_content(character, 0, character.strokes.size());
    }
    default:
      return pages_[index]->content();
  }
}

PageDrawing Sheets::side(std::size_t index) {
  const Side side = content_of_side(index);
  PageDrawing drawing;
  drawing.width_mm = side.size.width;
  drawing.height_mm = side.size.height;
  read_content(
      side.content, side.size.height, fonts_,
      [this](std::string_view name) { return content_of_object(name); }, drawing);
  return drawing;
}

base::Result<std::string> Sheets::file(const base::Progress& progress) {
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
  const auto add_object = [&](const std::string& name, const std::string& about) {
    const int number_of = pdf.reserve();
    objects += fmt::format("/{} {} 0 R ", name, number_of);
    pdf.write_stream(number_of, "/Type /XObject /Subtype /Form /BBox " + about, content_of_object(name));
  };
  for (const auto& [kind, name] : cells_) {
    const double side = static_cast<double>(kind.first) / 1000;
    constexpr double kRoom_mm = 1;  // for the width of its lines
    const std::string low = number(-kRoom_mm * kPoints);
    const std::string high = number((side + kRoom_mm) * kPoints);
    add_object(name, fmt::format("[{0} {0} {1} {1}]", low, high));
  }
  for (const std::size_t i : used_) add_object(fmt::format("C{}", i), "[-3 -3 112 112]");
  const std::size_t halves = s_.booklet ? pages_.size() : 0;
  for (std::size_t i = 0; i < halves; ++i)
    add_object(fmt::format("P{}", i),
               fmt::format("{} /Resources {} 0 R", box(size_.width, size_.height), resources));
  std::string kids;
  for (std::size_t i = 0; i < side_count(); ++i) {
    if (progress &&
        !progress(static_cast<double>(i) / static_cast<double>(side_count()), "writing the pages"))
      return base::fail(base::Errc::cancelled, "stopped", "worksheet");
    const Side side = content_of_side(i);
    const int stream = pdf.reserve();
    const int sheet = pdf.reserve();
    pdf.write_stream(stream, "", side.content);
    pdf.write(sheet,
              fmt::format("<< /Type /Page /Parent {} 0 R /MediaBox {} /Resources {} 0 R /Contents {} 0 R >>",
                          tree, box(side.size.width, side.size.height), resources, stream));
    kids += fmt::format("{} 0 R ", sheet);
  }
  pdf.write(resources, fmt::format("<< /Font << {}>> /XObject << {}>> >>", fonts, objects));
  pdf.write(tree, fmt::format("<< /Type /Pages /Kids [{}] /Count {} >>", kids, side_count()));
  pdf.write(catalogue, fmt::format("<< /Type /Catalog /Pages {} 0 R /Lang ({}) >>", tree,
                                   s_.language == Language::japanese ? "ja" : "en"));
  pdf.write(information, fmt::format("<< /Title {} /Producer (Nazori) >>", pdf_text(s_.title)));
  return pdf.finish(catalogue, information);
}

}  // namespace nazori::print
