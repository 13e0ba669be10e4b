// SPDX-License-Identifier: Apache-2.0
#include "font_tables.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

#include "nazori/author/character_font.h"
#include "nazori/base/utf8.h"

namespace nazori::author {
namespace {

constexpr std::size_t kLastInBmp = 0xFFFF;  // of the Basic Multilingual Plane

/// Code points without a gap whose glyphs follow one another.
struct CodeRun {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t glyph = 0;  // of the first
};

/// @param shapes  the first is the glyph for what is missing, the others are in the order of code points.
std::vector<CodeRun> code_runs(std::span<const FontShape> shapes) {
  std::vector<CodeRun> runs;
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    const std::size_t code = shapes[i].code_point;
    // The older of the two maps ends between these.
    if (!runs.empty() && runs.back().last + 1 == code && code != kLastInBmp + 1)
      runs.back().last = code;
    else
      runs.push_back({code, code, i});
  }
  return runs;
}

/// Format 4, for readers that know only 16 bits.
std::vector<std::uint8_t> short_map(std::span<const CodeRun> runs) {
  // Its length is written in 16 bits; further runs are only in the other map.
  constexpr std::size_t kMostRuns = 8'188;
  std::vector<CodeRun> segments;
  for (const CodeRun& run : runs)
    if (run.last <= kLastInBmp && segments.size() < kMostRuns) segments.push_back(run);
  // The last segment must end with U+FFFF.
  if (segments.empty() || segments.back().last != kLastInBmp) segments.push_back({kLastInBmp, kLastInBmp, 0});
  const SearchRange search = search_range(segments.size(), 2);
  FontBytes out;
  out.u16(4);
  out.u16(16 + 8 * segments.size());
  out.u16(0);  // of no language
  out.u16(2 * segments.size());
  out.u16(search.range);
  out.u16(search.selector);
  out.u16(search.shift);
  for (const CodeRun& segment : segments) out.u16(segment.last);
  out.u16(0);
  for (const CodeRun& segment : segments) out.u16(segment.first);
  for (const CodeRun& segment : segments) out.u16((segment.glyph - segment.first) & 0xFFFFU);
  out.zeros(2 * segments.size());
  return std::move(out.bytes());
}

/// Format 12.
std::vector<std::uint8_t> long_map(std::span<const CodeRun> runs) {
  FontBytes out;
  out.u16(12);
  out.u16(0);
  out.u32(16 + 12 * runs.size());
  out.u32(0);  // of no language
  out.u32(runs.size());
  for (const CodeRun& run : runs) {
    out.u32(run.first);
    out.u32(run.last);
    out.u32(run.glyph);
  }
  return std::move(out.bytes());
}

std::vector<std::uint8_t> cmap_table(std::span<const FontShape> shapes) {
  const std::vector<CodeRun> runs = code_runs(shapes);
  std::vector<std::uint8_t> narrow = short_map(runs);
  constexpr std::size_t kHeader = 4 + 4 * 8;
  FontBytes out;
  out.u16(0);
  out.u16(4);
  const auto record = [&](unsigned platform, unsigned encoding, std::size_t offset) {
    out.u16(platform);
    out.u16(encoding);
    out.u32(offset);
  };
  record(0, 3, kHeader);                   // Unicode, the BMP
  record(0, 4, kHeader + narrow.size());   // Unicode, all
  record(3, 1, kHeader);                   // Windows, the BMP
  record(3, 10, kHeader + narrow.size());  // Windows, all
  out.raw(narrow);
  out.raw(long_map(runs));
  return std::move(out.bytes());
}

/// Letters and digits of the family, as names in PostScript may have.
std::string postscript_name(std::string_view family) {
  constexpr std::size_t kMost = 50;
  std::string name;
  for (const char c : family) {
    const bool fits = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (fits && name.size() < kMost) name.push_back(c);
  }
  return (name.empty() ? "OwnCharacters" : name) + "-Regular";
}

std::vector<std::uint8_t> name_table(std::string_view family) {
  const std::pair<unsigned, std::string> texts[] = {
      {1, std::string(family)}, {2, "Regular"},       {3, "Nazori: " + std::string(family)},
      {4, std::string(family)}, {5, "Version 1.000"}, {6, postscript_name(family)},
  };
  FontBytes records;
  FontBytes strings;
  for (const auto& [number, text] : texts) {
    const std::size_t start = strings.size();
    // UTF-16. The family was checked.
    for (const char32_t c : base::decode_utf8(text).value_or(U"")) {
      if (c > kLastInBmp) {
        strings.u16(0xD800 + ((c - 0x10000) >> 10U));
        strings.u16(0xDC00 + (c & 0x3FFU));
      } else {
        strings.u16(c);
      }
    }
    for (const unsigned value : {3U, 1U, 0x0409U, number}) records.u16(value);  // Windows, Unicode, English
    records.u16(strings.size() - start);
    records.u16(start);
  }
  FontBytes out;
  out.u16(0);
  out.u16(std::size(texts));
  out.u16(6 + records.size());
  out.raw(records.bytes());
  out.raw(strings.bytes());
  return std::move(out.bytes());
}

/// The box of all glyphs.
FontBox box_of_font(std::span<const FontShape> shapes) {
  FontBox all = shapes.front().box;
  for (const FontShape& shape : shapes)
    if (shape.contours > 0)
      all = {std::min(all.left, shape.box.left), std::min(all.bottom, shape.box.bottom),
             std::max(all.right, shape.box.right), std::max(all.top, shape.box.top)};
  return all;
}

std::vector<std::uint8_t> head_table(const FontBox& box) {
  FontBytes out;
  out.u32(0x00010000);  // version of the table
  out.u32(0x00010000);  // of the font
  out.u32(0);           // the adjustment, filled in later
  out.u32(0x5F0F3CF5);
  out.u16(0x0003);  // the base line is at 0, and so is the left side bearing
  out.u16(kFontEm);
  out.zeros(16);  // no dates: the same characters give the same bytes
  out.i16(box.left);
  out.i16(box.bottom);
  out.i16(box.right);
  out.i16(box.top);
  out.u16(0);  // regular
  out.u16(8);  // smallest size that can be read [pixels]
  out.i16(2);  // from left to right
  out.u16(1);  // offsets of 32 bits
  out.u16(0);
  return std::move(out.bytes());
}

std::vector<std::uint8_t> hhea_table(const FontBox& box) {
  FontBytes out;
  out.u32(0x00010000);
  out.i16(kFontAscent);
  out.i16(kFontAscent - kFontEm);
  out.i16(0);  // no gap between lines
  out.u16(kFontEm);
  out.i16(box.left);
  out.i16(kFontEm - box.right);
  out.i16(box.right);
  out.i16(1);  // an upright cursor
  out.zeros(14);
  out.u16(1);  // all are equally wide
  return std::move(out.bytes());
}

std::vector<std::uint8_t> hmtx_table(std::span<const FontShape> shapes) {
  FontBytes out;
  out.u16(kFontEm);
  for (const FontShape& shape : shapes) out.i16(shape.box.left);
  return std::move(out.bytes());
}

std::vector<std::uint8_t> maxp_table(std::span<const FontShape> shapes) {
  FontBytes out;
  out.u32(0x00010000);
  out.u16(shapes.size());
  out.u16(std::ranges::max(shapes, {}, &FontShape::points).points);
  out.u16(std::ranges::max(shapes, {}, &FontShape::contours).contours);
  out.u16(0);
  out.u16(0);
  out.u16(2);     // zones
  out.zeros(16);  // no instructions, no composites
  return std::move(out.bytes());
}

std::vector<std::uint8_t> os2_table(std::span<const FontShape> shapes, const FontBox& box) {
  std::size_t first = shapes.size() > 1 ? shapes[1].code_point : 0U;
  std::size_t last = shapes.back().code_point;
  std::uint32_t ranges[4] = {};
  const auto has = [&ranges](unsigned bit) { ranges[bit / 32] |= 1U << (bit % 32); };
  for (const FontShape& shape : shapes.subspan(1)) {
    const char32_t code = shape.code_point;
    if (code >= 0xE000 && code <= 0xF8FF) has(60);  // private use
    if (code > kLastInBmp) has(57);
    if (code >= 0xF0000) has(90);  // private use, planes 15 and 16
  }
  FontBytes out;
  out.u16(4);
  out.i16(kFontEm);  // average width
  out.u16(400);      // weight: regular
  out.u16(5);        // width: normal
  out.u16(0);        // fsType: may be embedded and installed
  for (const int v : {650, 600, 0, 75, 650, 600, 0, 350}) out.i16(v);  // subscripts and superscripts
  out.i16(50);                                                         // width and place of the line that
  out.i16(300);                                                        // strikes out
  out.i16(0);                                                          // no class of families
  out.zeros(10);                                                       // no PANOSE
  for (const std::uint32_t range : ranges) out.u32(range);
  out.text("    ");  // no vendor
  out.u16(0x00C0);   // regular; the lines are as high as the next three say
  out.u16(std::min(first, kLastInBmp));
  out.u16(std::min(last, kLastInBmp));
  out.i16(kFontAscent);
  out.i16(kFontAscent - kFontEm);
  out.i16(0);
  out.u16(static_cast<std::size_t>(std::max(kFontAscent, box.top)));
  out.u16(static_cast<std::size_t>(std::max(kFontEm - kFontAscent, -box.bottom)));
  out.zeros(8);  // no code pages
  out.i16(500);  // height of small letters
  out.i16(700);  // and of capitals, of which there are none
  out.u16(0);
  out.u16(' ');
  out.u16(1);
  return std::move(out.bytes());
}

std::vector<std::uint8_t> post_table() {
  FontBytes out;
  out.u32(0x00030000);  // no names of glyphs
  out.u32(0);           // upright
  out.i16(-100);        // place and width of the line under text
  out.i16(50);
  out.u32(1);  // all are equally wide
  out.zeros(16);
  return std::move(out.bytes());
}

}  // namespace

std::vector<FontTable> font_tables(std::span<const FontShape> shapes, std::string_view family) {
  const FontBox box = box_of_font(shapes);
  std::vector<FontTable> tables;
  tables.push_back({"OS/2", os2_table(shapes, box)});
  tables.push_back({"cmap", cmap_table(shapes)});
  tables.push_back({"head", head_table(box)});
  tables.push_back({"hhea", hhea_table(box)});
  tables.push_back({"hmtx", hmtx_table(shapes)});
  tables.push_back({"maxp", maxp_table(shapes)});
  tables.push_back({"name", name_table(family)});
  tables.push_back({"post", post_table()});
  return tables;
}

}  // namespace nazori::author
