// SPDX-License-Identifier: Apache-2.0
#include "pdf_writer.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "nazori/base/utf8.h"

namespace nazori::print {
namespace {

std::string compressed(std::string_view content) {
  uLongf length = compressBound(static_cast<uLong>(content.size()));
  std::string bytes(length, '\0');
  [[maybe_unused]] const int done =
      compress2(reinterpret_cast<Bytef*>(bytes.data()), &length,
                reinterpret_cast<const Bytef*>(content.data()), static_cast<uLong>(content.size()), 6);
  assert(done == Z_OK);
  bytes.resize(length);
  return bytes;
}

std::string utf16_hex(char32_t c) {
  if (c < 0x10000) return fmt::format("{:04X}", static_cast<unsigned>(c));
  const auto rest = static_cast<unsigned>(c - 0x10000);
  return fmt::format("{:04X}{:04X}", 0xD800U + (rest >> 10U), 0xDC00U + (rest & 0x3FFU));
}

/// Which text the glyphs stand for.
std::string to_unicode(const Font& font) {
  std::string map =
      "/CIDInit /ProcSet findresource begin\n12 dict begin\nbegincmap\n"
      "/CIDSystemInfo << /Registry (Adobe) /Ordering (UCS) /Supplement 0 >> def\n"
      "/CMapName /Adobe-Identity-UCS def\n/CMapType 2 def\n"
      "1 begincodespacerange\n<0000> <FFFF>\nendcodespacerange\n";
  constexpr std::size_t kMost = 100;  // in one block
  auto at = font.used().begin();
  for (std::size_t left = font.used().size(); left > 0;) {
    const std::size_t count = std::min(left, kMost);
    map += fmt::format("{} beginbfchar\n", count);
    for (std::size_t i = 0; i < count; ++i, ++at)
      map += fmt::format("<{:04X}> <{}>\n", at->first, utf16_hex(at->second));
    map += "endbfchar\n";
    left -= count;
  }
  return map + "endcmap\nCMapName currentdict /CMap defineresource pop\nend\nend\n";
}

}  // namespace

PdfWriter::PdfWriter() : bytes_("%PDF-1.5\n%\xE2\xE3\xCF\xD3\n") {}

int PdfWriter::reserve() {
  places_.push_back(0);
  return static_cast<int>(places_.size());
}

void PdfWriter::begin(int number) {
  std::size_t& place = places_[static_cast<std::size_t>(number - 1)];
  assert(place == 0);
  place = bytes_.size();
  bytes_ += fmt::format("{} 0 obj\n", number);
}

void PdfWriter::write(int number, std::string_view content) {
  begin(number);
  bytes_ += content;
  bytes_ += "\nendobj\n";
}

void PdfWriter::write_stream(int number, std::string_view entries, std::string_view content) {
  const std::string packed = compressed(content);
  begin(number);
  bytes_ += fmt::format("<< {} /Filter /FlateDecode /Length {} >>\nstream\n", entries, packed.size());
  bytes_ += packed;
  bytes_ += "\nendstream\nendobj\n";
}

void PdfWriter::write_font(int number, const Font& font) {
  const int descriptor = reserve();
  const int file = reserve();
  const int descendant = reserve();
  const int unicode = reserve();
  // Six letters before the name say that it is a subset; any will do.
  const std::string name = "NAZORI+" + font.name();
  std::string widths;
  for (const auto& [glyph, code_point] : font.used())
    widths += fmt::format("{} [{}] ", glyph, std::lround(font.advance(glyph) * 1000));
  write(number,
        fmt::format(
            "<< /Type /Font /Subtype /Type0 /BaseFont /{} /Encoding /Identity-H /DescendantFonts [{} 0 R] "
            "/ToUnicode {} 0 R >>",
            name, descendant, unicode));
  write(descendant,
        fmt::format(
            "<< /Type /Font /Subtype /CIDFontType2 /BaseFont /{} /CIDSystemInfo << /Registry (Adobe) "
            "/Ordering (Identity) /Supplement 0 >> /FontDescriptor {} 0 R /CIDToGIDMap /Identity /DW 1000 "
            "/W [{}] >>",
            name, descriptor, widths));
  write(descriptor,
        fmt::format(
            "<< /Type /FontDescriptor /FontName /{} /Flags 4 /FontBBox [-200 -300 1200 1100] /ItalicAngle "
            "0 /Ascent {} /Descent {} /CapHeight 700 /StemV 80 /FontFile2 {} 0 R >>",
            name, std::lround(font.ascent() * 1000), std::lround(font.descent() * 1000), file));
  const std::string outlines = font.subset();
  write_stream(file, fmt::format("/Length1 {}", outlines.size()), outlines);
  write_stream(unicode, "", to_unicode(font));
}

std::string PdfWriter::finish(int catalogue, int information) {
  const std::size_t table = bytes_.size();
  bytes_ += fmt::format("xref\n0 {}\n0000000000 65535 f \n", places_.size() + 1);
  for (const std::size_t place : places_) {
    assert(place != 0);
    bytes_ += fmt::format("{:010} 00000 n \n", place);
  }
  bytes_ += fmt::format("trailer\n<< /Size {} /Root {} 0 R /Info {} 0 R >>\nstartxref\n{}\n%%EOF\n",
                        places_.size() + 1, catalogue, information, table);
  return std::move(bytes_);
}

std::string pdf_text(std::string_view utf8) {
  std::string text = "<FEFF";
  for (const char32_t c : base::decode_utf8(utf8).value_or(U"")) text += utf16_hex(c);
  return text + ">";
}

}  // namespace nazori::print
