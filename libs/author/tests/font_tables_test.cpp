// SPDX-License-Identifier: Apache-2.0
// The tables of a font of own characters, and what it refuses.
#include <gtest/gtest.h>

#include <algorithm>

#include "font_reader.h"
#include "nazori/author/character_font.h"
#include "nazori/base/utf8.h"
#include "own_forms.h"

namespace nazori::author {
namespace {

using test::Bytes;
using test::even_stroke;
using test::font_of;
using test::i16_at;
using test::ReadFont;
using test::tables_of;
using test::u16_at;
using test::u32_at;

constexpr char32_t kPrivate = 0xF0000;

TEST(CharacterFont, EveryCodePointIsMappedToItsOwnGlyph) {
  const std::vector<char32_t> codes = {0x20,    0x21,    U'永',   U'亜',   0xE000,  0xFFFE,  0xFFFF,
                                       0x10000, 0xF0000, 0xF0001, 0xF0003, 0xFFFFD, 0x10FFFD};
  std::vector<FontGlyph> glyphs;
  for (std::size_t i = 0; i < codes.size(); ++i)
    glyphs.push_back({codes[i], {even_stroke({{10.0 + static_cast<double>(i), 20}}, 2)}});
  std::ranges::reverse(glyphs);
  const Bytes bytes = font_of(glyphs);
  const ReadFont font(bytes);
  EXPECT_EQ(font.face()->num_glyphs, static_cast<FT_Long>(codes.size() + 1));
  for (int map = 0; map < font.face()->num_charmaps; ++map) {
    ASSERT_EQ(FT_Set_Charmap(font.face(), font.face()->charmaps[map]), 0);
    const int encoding = font.face()->charmap->encoding_id;
    const bool is_short = encoding == 1 || encoding == 3;
    for (std::size_t i = 0; i < codes.size(); ++i) {
      if (is_short && codes[i] > 0xFFFF) continue;
      ASSERT_TRUE(font.load(codes[i])) << std::hex << static_cast<unsigned>(codes[i]);
      EXPECT_EQ(font.face()->glyph->metrics.horiAdvance, 1000);
      const double left = (8.0 + static_cast<double>(i)) * 1000 / 109;
      EXPECT_NEAR(static_cast<double>(font.face()->glyph->metrics.horiBearingX), left, 4.5);
    }
    for (const char32_t missing : {0x1FU, 0x22U, 0xE001U, 0xFFFDU, 0x10001U, 0xF0002U, 0xF0004U, 0x10FFFCU})
      EXPECT_EQ(FT_Get_Char_Index(font.face(), missing), 0U) << std::hex << static_cast<unsigned>(missing);
  }
}

TEST(CharacterFont, MapsAreThoseThatReadersLookFor) {
  const Bytes bytes = font_of({{U'永', {}}, {kPrivate, {}}, {kPrivate + 1, {}}});
  const auto cmap = tables_of(bytes).at("cmap");
  ASSERT_EQ(u16_at(cmap, 2), 4U);
  const unsigned expected[][3] = {{0, 3, 4}, {0, 4, 12}, {3, 1, 4}, {3, 10, 12}};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t record = 4 + 8 * i;
    EXPECT_EQ(u16_at(cmap, record), expected[i][0]);
    EXPECT_EQ(u16_at(cmap, record + 2), expected[i][1]);
    EXPECT_EQ(u16_at(cmap, u32_at(cmap, record + 4)), expected[i][2]);
  }
  const auto narrow = cmap.subspan(u32_at(cmap, 4 + 4));
  EXPECT_EQ(u16_at(narrow, 2), 32U);  // two segments: 永 and the last
  EXPECT_EQ(u16_at(narrow, 6), 4U);
  EXPECT_EQ(u16_at(narrow, 8), 4U);   // the largest power of two, doubled
  EXPECT_EQ(u16_at(narrow, 10), 1U);  // its logarithm
  EXPECT_EQ(u16_at(narrow, 12), 0U);
  EXPECT_EQ(u16_at(narrow, 14), unsigned{U'永'});
  EXPECT_EQ(u16_at(narrow, 16), 0xFFFFU);
  const auto wide = cmap.subspan(u32_at(cmap, 4 + 8 + 4));
  EXPECT_EQ(u32_at(wide, 4), 16U + 2 * 12);
  EXPECT_EQ(u32_at(wide, 12), 2U);  // 永, and both private ones as one run
  EXPECT_EQ(u32_at(wide, 16 + 12), 0xF0000U);
  EXPECT_EQ(u32_at(wide, 16 + 16), 0xF0001U);
  EXPECT_EQ(u32_at(wide, 16 + 20), 2U);
}

/// @source OpenType specification, "Calculating checksums": big-endian numbers of 32 bits, padded with zeros;
/// that of head, and of the whole file, with checkSumAdjustment as 0.
TEST(CharacterFont, ChecksumsHoldByOpenTypesDefinition) {
  const Bytes bytes = font_of({{kPrivate, {even_stroke({{10, 20}, {90, 33}})}}, {kPrivate + 5, {}}});
  ASSERT_EQ(bytes.size() % 4, 0U);
  const auto sum_of = [](const Bytes& part) {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i + 3 < part.size(); i += 4) sum += u32_at(part, i);
    return sum;
  };
  EXPECT_EQ(sum_of(bytes), 0xB1B0AFBAU);
  EXPECT_EQ(u32_at(bytes, 0), 0x00010000U);
  ASSERT_EQ(u16_at(bytes, 4), 10U);
  EXPECT_EQ(u16_at(bytes, 6), 128U);
  EXPECT_EQ(u16_at(bytes, 8), 3U);
  EXPECT_EQ(u16_at(bytes, 10), 32U);
  std::vector<std::string> tags;
  std::size_t end = 12 + 10 * 16;
  for (std::size_t i = 0; i < 10; ++i) {
    const std::size_t record = 12 + 16 * i;
    tags.emplace_back(bytes.begin() + static_cast<std::ptrdiff_t>(record),
                      bytes.begin() + static_cast<std::ptrdiff_t>(record + 4));
    const std::size_t offset = u32_at(bytes, record + 8);
    const std::size_t size = u32_at(bytes, record + 12);
    EXPECT_EQ(offset, end) << tags.back();
    Bytes table(bytes.begin() + static_cast<std::ptrdiff_t>(offset),
                bytes.begin() + static_cast<std::ptrdiff_t>(offset + size));
    table.resize((size + 3) / 4 * 4);
    end = offset + table.size();
    if (tags.back() == "head") std::fill_n(table.begin() + 8, 4, std::uint8_t{0});
    EXPECT_EQ(u32_at(bytes, record + 4), sum_of(table)) << tags.back();
  }
  EXPECT_EQ(end, bytes.size());
  EXPECT_EQ(tags, (std::vector<std::string>{"OS/2", "cmap", "glyf", "head", "hhea", "hmtx", "loca", "maxp",
                                            "name", "post"}));
}

TEST(CharacterFont, ItsMeasuresAreThoseOfAFullWidthFont) {
  const std::vector<OwnStroke> strokes = {even_stroke({{-50, 54}, {160, 54}}, 5), even_stroke({{54, -20}}, 5),
                                          even_stroke({{54, 180}}, 5)};
  const Bytes bytes = font_of({{0xE000, {}}, {kPrivate, strokes}});
  const auto tables = tables_of(bytes);
  const int left = -505;  // (-50 - 5) * 1000 / 109, rounded
  const int right = 1514;
  const int top = 1109;
  const int bottom = -817;
  const auto loca = tables.at("loca");
  ASSERT_EQ(loca.size(), 4U * 4);
  EXPECT_EQ(u32_at(loca, 4), u32_at(loca, 8));  // blank
  EXPECT_EQ(u32_at(loca, 12), tables.at("glyf").size());
  const auto glyf = tables.at("glyf").subspan(u32_at(loca, 8));
  EXPECT_EQ(u16_at(glyf, 0), 3U);
  // Control points of round ends may lie a little farther out than the curve.
  const int box[] = {i16_at(glyf, 2), i16_at(glyf, 4), i16_at(glyf, 6), i16_at(glyf, 8)};
  EXPECT_NEAR(box[0], left, 8);
  EXPECT_NEAR(box[1], bottom, 8);
  EXPECT_NEAR(box[2], right, 8);
  EXPECT_NEAR(box[3], top, 8);
  const auto head = tables.at("head");
  EXPECT_EQ(u32_at(head, 12), 0x5F0F3CF5U);
  EXPECT_EQ(u16_at(head, 16), 3U);
  EXPECT_EQ(u16_at(head, 18), 1000U);
  EXPECT_EQ(i16_at(head, 36), box[0]);
  EXPECT_EQ(i16_at(head, 38), box[1]);
  EXPECT_EQ(i16_at(head, 40), box[2]);
  EXPECT_EQ(i16_at(head, 42), box[3]);
  EXPECT_EQ(i16_at(head, 50), 1);
  const auto hhea = tables.at("hhea");
  EXPECT_EQ(i16_at(hhea, 4), 880);
  EXPECT_EQ(i16_at(hhea, 6), -120);
  EXPECT_EQ(i16_at(hhea, 8), 0);
  EXPECT_EQ(u16_at(hhea, 10), 1000U);
  EXPECT_EQ(i16_at(hhea, 12), box[0]);
  EXPECT_EQ(i16_at(hhea, 14), 1000 - box[2]);
  EXPECT_EQ(i16_at(hhea, 16), box[2]);
  EXPECT_EQ(u16_at(hhea, 34), 1U);
  const auto hmtx = tables.at("hmtx");
  ASSERT_EQ(hmtx.size(), 4U + 2 * 2);
  EXPECT_EQ(u16_at(hmtx, 0), 1000U);
  EXPECT_EQ(i16_at(hmtx, 4), 0);  // blank
  EXPECT_EQ(i16_at(hmtx, 6), box[0]);
  const auto os2 = tables.at("OS/2");
  ASSERT_EQ(os2.size(), 96U);
  EXPECT_EQ(u16_at(os2, 0), 4U);
  EXPECT_EQ(i16_at(os2, 2), 1000);
  EXPECT_EQ(u16_at(os2, 4), 400U);
  EXPECT_EQ(u16_at(os2, 6), 5U);
  EXPECT_EQ(u16_at(os2, 8), 0U);                      // installable embedding
  EXPECT_EQ(u32_at(os2, 46), 1U << 28U | 1U << 25U);  // bits 60 and 57
  EXPECT_EQ(u32_at(os2, 50), 1U << 26U);              // bit 90
  EXPECT_EQ(u16_at(os2, 62), 0xC0U);                  // regular, its own measures of lines
  EXPECT_EQ(u16_at(os2, 64), 0xE000U);
  EXPECT_EQ(u16_at(os2, 66), 0xFFFFU);
  EXPECT_EQ(i16_at(os2, 68), 880);
  EXPECT_EQ(i16_at(os2, 70), -120);
  EXPECT_EQ(i16_at(os2, 72), 0);
  EXPECT_EQ(i16_at(os2, 74), box[3]);  // nothing is cut off
  EXPECT_EQ(i16_at(os2, 76), -box[1]);
  const auto post = tables.at("post");
  ASSERT_EQ(post.size(), 32U);
  EXPECT_EQ(u32_at(post, 0), 0x00030000U);
  EXPECT_EQ(u32_at(post, 12), 1U);
  const auto maxp = tables.at("maxp");
  ASSERT_EQ(maxp.size(), 32U);
  EXPECT_EQ(u16_at(maxp, 4), 3U);
  EXPECT_EQ(u16_at(maxp, 6), u16_at(glyf, 10 + 2 * 2) + 1U);  // all points of the glyph with three contours
  EXPECT_EQ(u16_at(maxp, 8), 3U);
  EXPECT_EQ(u16_at(maxp, 14), 2U);
}

TEST(CharacterFont, ItsFamilyIsReadBack) {
  for (const std::string family : {"Aiko's signs", "愛子の字 𠮷"}) {
    const Bytes bytes = font_of({{kPrivate, {}}}, family);
    const auto name = tables_of(bytes).at("name");
    std::map<unsigned, std::u32string> texts;
    for (std::size_t i = 0; i < u16_at(name, 2); ++i) {
      const std::size_t record = 6 + 12 * i;
      EXPECT_EQ(u16_at(name, record), 3U);
      EXPECT_EQ(u16_at(name, record + 2), 1U);
      EXPECT_EQ(u16_at(name, record + 4), 0x409U);
      const std::size_t start = u16_at(name, 4) + u16_at(name, record + 10);
      std::u32string text;
      for (std::size_t at = start; at < start + u16_at(name, record + 8); at += 2) {
        const unsigned unit = u16_at(name, at);
        if (unit >= 0xDC00 && unit < 0xE000)
          text.back() = 0x10000 + ((text.back() - 0xD800) << 10U) + (unit - 0xDC00);
        else
          text.push_back(unit);
      }
      texts[u16_at(name, record + 6)] = text;
    }
    EXPECT_EQ(base::encode_utf8(texts[1]), family);
    EXPECT_EQ(texts[2], U"Regular");
    EXPECT_NE(texts[3].find(texts[1]), std::u32string::npos);
    EXPECT_EQ(texts[4], texts[1]);
    EXPECT_EQ(texts[5].find(U"Version "), 0U);
    EXPECT_EQ(texts[6], family[0] == 'A' ? U"Aikossigns-Regular" : U"OwnCharacters-Regular");
    EXPECT_EQ(texts.count(13), 0U);  // no licence
  }
  const Bytes bytes = font_of({}, "Aiko");
  const ReadFont font(bytes);
  EXPECT_STREQ(font.face()->family_name, "Aiko");
  EXPECT_STREQ(font.face()->style_name, "Regular");
  EXPECT_EQ(FT_Get_FSType_Flags(font.face()), FT_FSTYPE_INSTALLABLE_EMBEDDING);
  EXPECT_STREQ(FT_Get_Postscript_Name(font.face()), "Aiko-Regular");
}

TEST(CharacterFont, TheNameForPostScriptHasFiftyLettersAtMost) {
  const auto name_of = [](std::size_t letters) {
    const Bytes bytes = font_of({}, std::string(letters, 'k'));
    return std::string(FT_Get_Postscript_Name(ReadFont(bytes).face()));
  };
  EXPECT_EQ(name_of(49), std::string(49, 'k') + "-Regular");
  EXPECT_EQ(name_of(50), std::string(50, 'k') + "-Regular");
  EXPECT_EQ(name_of(51), std::string(50, 'k') + "-Regular");
}

TEST(CharacterFont, ManyCodePointsWithGapsAreAllMapped) {
  std::vector<FontGlyph> glyphs;
  for (char32_t code = 0; code <= 0xFFFF; code += 2)
    if (code < 0xD800 || code > 0xDFFF) glyphs.push_back({code, {}});
  const Bytes bytes = font_of(glyphs);
  const ReadFont font(bytes);
  for (std::size_t i = 0; i < glyphs.size(); ++i)
    ASSERT_EQ(FT_Get_Char_Index(font.face(), glyphs[i].code_point), i + 1);
  // Readers that know only the short map get as many as it can hold.
  const auto cmap = tables_of(bytes).at("cmap");
  const auto narrow = cmap.subspan(u32_at(cmap, 8));
  EXPECT_EQ(u32_at(cmap, 8) + u16_at(narrow, 2), u32_at(cmap, 16));
  EXPECT_EQ(16U + 4 * u16_at(narrow, 6), u16_at(narrow, 2));
  EXPECT_GT(u16_at(narrow, 2), 65'000U);
  ASSERT_EQ(FT_Set_Charmap(font.face(), font.face()->charmaps[0]), 0);
  EXPECT_EQ(FT_Get_Char_Index(font.face(), 2 * 8'187), 8'188U);
  EXPECT_EQ(FT_Get_Char_Index(font.face(), 2 * 8'188), 0U);
}

TEST(CharacterFont, AsManyGlyphsAsAFontCanHoldFit) {
  std::vector<FontGlyph> glyphs;
  for (std::size_t i = 0; i < kMostFontGlyphs; ++i)
    glyphs.push_back({kPrivate + static_cast<char32_t>(i), {}});
  const Bytes bytes = font_of(glyphs);
  const ReadFont font(bytes);
  EXPECT_EQ(font.face()->num_glyphs, 65'535);
  EXPECT_EQ(FT_Get_Char_Index(font.face(), 0xFFFFD), 65'534U);
  glyphs.push_back({U'永', {}});
  const auto refused = character_font(glyphs, "Own");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::Errc::bad_argument);
  EXPECT_EQ(refused.error().where, "glyphs");
}

TEST(CharacterFont, WhatDoesNotFitIsRefusedByName) {
  const auto place = [](const std::vector<FontGlyph>& glyphs, const std::string& family = "Own") {
    const auto font = character_font(glyphs, family);
    if (font) return std::string("none");
    EXPECT_EQ(font.error().code, base::Errc::bad_argument);
    return font.error().where;
  };
  EXPECT_EQ(place({{0xD7FF, {}}, {0xE000, {}}, {0x10FFFF, {}}}), "none");
  EXPECT_EQ(place({{0xD800, {}}}), "U+D800");
  EXPECT_EQ(place({{0xDFFF, {}, "sign"}}), "sign (U+DFFF)");
  EXPECT_EQ(place({{0x110000, {}}}), "U+110000");
  EXPECT_EQ(place({{0xF0000, {}, "first"}, {0xF0001, {}}, {0xF0000, {}, "second"}}), "second (U+F0000)");
  EXPECT_EQ(place({{0xF0000, {even_stroke({{1, 1}}), even_stroke({{1, 1}, {1000, 1}})}, "far"}}),
            "far (U+F0000), stroke 2, point 2");
  EXPECT_EQ(place({{0xF0000, {OwnStroke{}}}}), "U+F0000, stroke 1");
  EXPECT_EQ(place({}, ""), "family");
  EXPECT_EQ(place({}, "a\nb"), "family");
  EXPECT_EQ(place({}, "\x7F"), "family");
  EXPECT_EQ(place({}, "\xFF"), "family");
  EXPECT_EQ(place({}, std::string(200, 'a')), "none");
  EXPECT_EQ(place({}, std::string(201, 'a')), "family");
}

}  // namespace
}  // namespace nazori::author
