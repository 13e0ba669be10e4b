// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "font.h"

namespace nazori::print {

/// The objects of a PDF file, numbered from 1. Thread rules: one thread.
/// @source ISO 32000-1.
class PdfWriter {
 public:
  PdfWriter();
  /// A number for an object that is written later.
  [[nodiscard]] int reserve();
  void write(int number, std::string_view content);
  /// A stream, compressed. @param entries  of its dictionary besides Length and Filter: "/Type /XObject".
  void write_stream(int number, std::string_view entries, std::string_view content);
  /// The objects of an embedded font. @param number  of the font.
  void write_font(int number, const Font& font);
  /// The whole file. Call it once.
  [[nodiscard]] std::string finish(int catalogue, int information);

 private:
  void begin(int number);
  std::string bytes_;
  std::vector<std::size_t> places_;
};

/// UTF-8 as a string of PDF: UTF-16 in hexadecimal.
[[nodiscard]] std::string pdf_text(std::string_view utf8);

}  // namespace nazori::print
