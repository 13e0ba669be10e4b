// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/character_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "nazori/archive/zip.h"
#include "nazori/base/file.h"
#include "own_forms.h"

namespace nazori::author {
namespace {

using namespace test;

/// A character in which everything is there, with numbers that need all their digits.
OwnCharacter full_character() {
  OwnCharacter character = cross();
  character.facts.name = "a <sign> & \"more\"";
  character.facts.parts = {{"一", {0}}, {"二", {0, 1}}, {"split", {0, 2}}, {"none", {}}};
  character.facts.rights = {"CC-BY-4.0", "A. Teacher", "a photograph"};
  OwnStroke stroke = even_stroke({{0.1, 1.0 / 3}, {1e-7, -0.0}, {70, 1e2}}, 2.0 / 3, 0.1);
  stroke.ending = StrokeEnding::hook;
  stroke.number_position = GlyphPoint{1.0 / 7, 12};
  character.strokes.push_back(stroke);
  character.strokes.push_back(even_stroke({{50, 50}}));
  character.strokes.back().ending = StrokeEnding::either;
  character.hand = {3, {0, -1, 1, 1e-30F, 0.1F, -0.0F, 0.3F, 0.5F, -0.25F}};
  return character;
}

std::vector<std::uint8_t> bytes_of(const OwnCharacter& character) {
  auto bytes = to_bytes(character);
  EXPECT_TRUE(bytes) << base::to_line(bytes.error());
  return bytes.value_or(std::vector<std::uint8_t>{});
}

/// The document with one member replaced, or left out where `content` is empty.
std::vector<std::uint8_t> with_member(const OwnCharacter& character, const std::string& name,
                                      const std::string& content) {
  archive::ZipWriter zip;
  bool found = false;
  const auto members = archive::read_zip(bytes_of(character));
  for (const archive::ZipMember& member : *members) {
    if (member.name != name) {
      zip.add(member.name, member.content);
    } else if (!content.empty()) {
      zip.add(name, content);
    }
    found = found || member.name == name;
  }
  if (!found) zip.add(name, content);
  return *zip.finish();
}

std::string refusal(std::span<const std::uint8_t> bytes) {
  const auto character = parse_character(bytes);
  return character ? std::string() : base::to_line(character.error());
}

TEST(CharacterFile, GivesTheSameCharacterAndTheSameBytes) {
  for (const OwnCharacter& character : {full_character(), cross(), OwnCharacter{}}) {
    const auto bytes = bytes_of(character);
    const auto read = parse_character(bytes);
    ASSERT_TRUE(read) << base::to_line(read.error());
    EXPECT_EQ(*read, character);
    EXPECT_EQ(bytes_of(*read), bytes);
  }
  EXPECT_TRUE(std::signbit(parse_character(bytes_of(full_character()))->hand.heights[5]));
}

TEST(CharacterFile, ContainsWhatIsDocumented) {
  const auto members = archive::read_zip(bytes_of(full_character()));
  ASSERT_EQ(members->size(), 4U);
  EXPECT_EQ((*members)[0].name, "meta.json");
  EXPECT_EQ((*members)[1].name, "strokes.svg");
  EXPECT_EQ((*members)[2].name, "relief.f32");
  EXPECT_EQ((*members)[2].content.size(), 36U);
  EXPECT_EQ((*members)[2].content[7], 0xBF);  // -1, little-endian
  EXPECT_EQ((*members)[3].name, "LICENCE.txt");
  const std::string licence((*members)[3].content.begin(), (*members)[3].content.end());
  EXPECT_EQ(licence, "Licence: CC-BY-4.0\nAuthor: A. Teacher\nSource: a photograph\n");
  EXPECT_EQ(archive::read_zip(bytes_of({}))->size(), 2U);
}

TEST(CharacterFile, NamesTheAuthorsOfKanjiVg) {
  OwnCharacter character = cross();
  character.facts.rights = kanjivg_rights();
  const auto members = archive::read_zip(bytes_of(character));
  const std::string licence(members->back().content.begin(), members->back().content.end());
  EXPECT_NE(licence.find("CC-BY-SA-3.0"), std::string::npos);
  EXPECT_NE(licence.find("Ulrich Apel"), std::string::npos);
  EXPECT_NE(licence.find("creativecommons.org/licenses/by-sa/3.0"), std::string::npos);
}

TEST(CharacterFile, UnknownMembersArePassedOver) {
  EXPECT_EQ(*parse_character(with_member(cross(), "thumbnail.png", "x")), cross());
  const std::string meta = R"({"nazori_character": 1, "name": "b", "colour": [1, 2]})";
  EXPECT_EQ(parse_character(with_member(cross(), "meta.json", meta))->facts.name, "b");
}

TEST(CharacterFile, KnowsInWhosePlaceItIsUsed) {
  OwnCharacter character = cross();
  const auto meta_of = [&character] {
    const auto members = archive::read_zip(bytes_of(character));
    return std::string((*members)[0].content.begin(), (*members)[0].content.end());
  };
  EXPECT_EQ(meta_of().find("instead_of"), std::string::npos) << "the bytes of files without it stay";
  character.facts.instead_of = U'永';
  EXPECT_NE(meta_of().find(R"("instead_of": "永")"), std::string::npos) << meta_of();
  EXPECT_EQ(parse_character(bytes_of(character))->facts.instead_of, U'永');
  for (const char* const wrong :
       {R"("")", R"("永遠")", "27704", R"("\u0001")", R"(" ")", R"("\udb80\udc01")"})
    EXPECT_NE(refusal(with_member(cross(), "meta.json",
                                  R"({"nazori_character": 1, "instead_of": )" + std::string(wrong) + "}")),
              "")
        << wrong;
  for (const char32_t wrong : {0xF0000U, 0xFFFFDU, 0xD800U, 0xDFFFU, 0x110000U, 0x20U, 0x7FU, 0x9FU}) {
    character.facts.instead_of = wrong;
    EXPECT_EQ(place_of_error(validate(character)), "instead_of") << static_cast<std::uint32_t>(wrong);
  }
  for (const char32_t right : {0x21U, 0x7EU, 0xA0U, 0xD7FFU, 0xE000U, 0xEFFFFU, 0xFFFFEU, 0x10FFFFU}) {
    character.facts.instead_of = right;
    EXPECT_TRUE(validate(character)) << static_cast<std::uint32_t>(right);
  }
}

TEST(CharacterFile, ANewerVersionIsRefusedClearly) {
  const auto bytes = with_member(cross(), "meta.json", R"({"nazori_character": 2})");
  EXPECT_EQ(refusal(bytes), "meta.json: was made by a newer version of this program (update this program)");
  EXPECT_EQ(parse_character(bytes).error().code, base::Errc::schema);
}

TEST(CharacterFile, WhatIsDamagedIsRefusedWithItsPlace) {
  EXPECT_EQ(refusal({}), "is not a ZIP");
  EXPECT_EQ(refusal(with_member(cross(), "meta.json", "")),
            "is not a character of Nazori: it has no meta.json");
  const auto meta = [](const std::string& text) { return refusal(with_member(cross(), "meta.json", text)); };
  EXPECT_NE(meta("{"), "");
  EXPECT_NE(meta("{}"), "");
  EXPECT_NE(meta(R"({"nazori_character": 0})"), "");
  EXPECT_NE(meta(R"({"nazori_character": 1, "readings": ["a", 1]})"), "");
  EXPECT_NE(meta(R"({"nazori_character": 1, "readings": "a"})"), "");
  EXPECT_NE(meta(R"({"nazori_character": 1, "radical": 215})"), "");
  EXPECT_NE(meta(R"({"nazori_character": 1, "parts": [{"name": "a", "strokes": [0]}]})"), "");
  EXPECT_NE(meta(R"({"nazori_character": 1, "parts": [{"name": "a", "strokes": [3]}]})"), "");
  EXPECT_NE(meta(R"({"nazori_character": 1, "parts": [{"name": "a", "strokes": [1.5]}]})"), "");
  EXPECT_EQ(meta(R"({"nazori_character": 1, "parts": [{"name": "a", "strokes": [2]}], "radical": null})"),
            "");
  const auto relief = [](std::size_t size) {
    return refusal(with_member(cross(), "relief.f32", std::string(size, '\0')));
  };
  EXPECT_EQ(relief(36), "");
  EXPECT_EQ(relief(35), "relief.f32: is not a square of samples");
  EXPECT_EQ(relief(40), "relief.f32: is not a square of samples");
  EXPECT_EQ(relief(4), "relief.f32: is not a square of samples");
  EXPECT_NE(refusal(with_member(cross(), "relief.f32", std::string(16, '\x7F'))), "");
  EXPECT_NE(refusal(with_member(cross(), "strokes.svg", "<svg/>")), "");
}

TEST(CharacterFile, IsSavedAndLoaded) {
  const auto path = std::filesystem::path(testing::TempDir()) / "own.nazori";
  ASSERT_TRUE(save_character(full_character(), path));
  EXPECT_EQ(*load_character(path), full_character());
  ASSERT_TRUE(base::write_file(path, std::string_view("x")));
  EXPECT_EQ(load_character(path).error().where, path.string());
  EXPECT_EQ(load_character(path.string() + "x").error().code, base::Errc::not_found);
  OwnCharacter wrong = cross();
  wrong.facts.radical = 0;
  EXPECT_EQ(place_of_error(save_character(wrong, path)), "radical");
}

TEST(StrokesSvg, GivesTheSameStrokesAndTheSameText) {
  const OwnCharacter character = full_character();
  const std::string svg = to_strokes_svg(character);
  const auto read = parse_strokes_svg(svg);
  ASSERT_TRUE(read) << base::to_line(read.error());
  EXPECT_EQ(read->strokes, character.strokes);
  EXPECT_EQ(read->facts.name, character.facts.name);
  EXPECT_EQ(read->facts.rights, character.facts.rights);
  // Parts whose strokes are not in a row cannot be groups.
  EXPECT_EQ(read->facts.parts, (std::vector<OwnPart>{{"二", {0, 1}}, {"一", {0}}}));
  EXPECT_EQ(to_strokes_svg(*read), svg);
}

TEST(StrokesSvg, PartsThatCrossOneAnotherAreNotBothGroups) {
  OwnCharacter character = full_character();
  character.facts.parts = {{"a", {0, 1}}, {"b", {1, 2}}, {"c", {2, 3}}};
  EXPECT_EQ(parse_strokes_svg(to_strokes_svg(character))->facts.parts,
            (std::vector<OwnPart>{{"a", {0, 1}}, {"c", {2, 3}}}));
}

constexpr const char* kKanjiVg = R"svg(<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" width="109" height="109" viewBox="0 0 109 109">
<g id="kvg:StrokePaths_05341"><g id="kvg:05341" kvg:element="十">
<path id="kvg:05341-s1" kvg:type="㇒" d="M80,10c-10,30-30,60-60,80"/>
<g kvg:element="丨"><path kvg:type="㇚" d="M55,10L55,90L48,84"/></g><path kvg:type="㇔" d="M80,70L90,80"/></g></g>
<g id="kvg:StrokeNumbers_05341"><text transform="matrix(1 0 0 1 72.5 9.25)">1</text><text>7</text></g></svg>)svg";

TEST(StrokesSvg, ReadsTheFilesOfKanjiVg) {
  const auto read = parse_strokes_svg(kKanjiVg);
  ASSERT_TRUE(read) << base::to_line(read.error());
  ASSERT_EQ(read->strokes.size(), 3U);
  EXPECT_EQ(read->facts.name, "十");
  EXPECT_EQ(read->facts.parts, (std::vector<OwnPart>{{"丨", {1}}}));
  EXPECT_EQ(read->facts.rights, kanjivg_rights());
  EXPECT_EQ(read->strokes[0].ending, StrokeEnding::taper);
  EXPECT_EQ(read->strokes[1].ending, StrokeEnding::hook);
  EXPECT_EQ(read->strokes[2].ending, StrokeEnding::stop);
  EXPECT_EQ(read->strokes[0].number_position, (GlyphPoint{72.5, 9.25}));
  EXPECT_EQ(read->strokes[0].points.front().at, (GlyphPoint{80, 10}));
  EXPECT_EQ(read->strokes[0].points.back().at, (GlyphPoint{20, 90}));
  EXPECT_EQ(read->strokes[0].points.back().half_width, 0);
  EXPECT_GT(read->strokes[2].points.back().half_width, 3.5);
}

TEST(StrokesSvg, RefusesWhatIsNone) {
  const auto why = [](const std::string& from, const std::string& to) {
    std::string svg = to_strokes_svg(cross());
    const auto at = svg.find(from);
    EXPECT_NE(at, std::string::npos);
    svg.replace(at, from.size(), to);
    const auto read = parse_strokes_svg(svg);
    return read ? std::string() : base::to_line(read.error());
  };
  EXPECT_NE(why("<svg", "<sv"), "");
  EXPECT_NE(why("kvg:StrokePaths", "kvg:Paths"), "");
  EXPECT_EQ(why("nazori:half-width=\"3 3\"", "nazori:half-width=\"3\""),
            "stroke 1: does not give a half width and a depth for each of its 2 points");
  EXPECT_EQ(why("nazori:depth=\"1 1\"", ""),
            "stroke 1: does not give a half width and a depth for each of its 2 points");
  EXPECT_NE(why("nazori:half-width=\"3 3\"", "nazori:half-width=\"3 x\""), "");
  EXPECT_EQ(why("nazori:ending=\"stop\"", "nazori:ending=\"none\""), "stroke 1: has no ending that is known");
  EXPECT_NE(why("M15,50", "M1500,50"), "");
  EXPECT_NE(why("M15,50", "15,50"), "");
  EXPECT_EQ(base::to_line(parse_strokes_svg("<svg><g id='kvg:StrokePaths'><g/></g></svg>").error()),
            "has no strokes");
}

TEST(StrokesSvg, LimitsHold) {
  const auto nested = [](int depth) {
    std::string svg = "<svg><g id='kvg:StrokePaths'>";
    for (int i = 0; i < depth; ++i) svg += "<g>";
    svg += "<path d='M1,1L9,9'/>";
    for (int i = 0; i < depth; ++i) svg += "</g>";
    return svg + "</g></svg>";
  };
  EXPECT_TRUE(parse_strokes_svg(nested(51)));
  EXPECT_FALSE(parse_strokes_svg(nested(52)));
  const auto many = [](int strokes) {
    std::string svg = "<svg><g id='kvg:StrokePaths'><g>";
    for (int i = 0; i < strokes; ++i) svg += "<path d='M1,1L9,9'/>";
    return svg + "</g></g></svg>";
  };
  EXPECT_TRUE(parse_strokes_svg(many(200)));
  EXPECT_FALSE(parse_strokes_svg(many(201)));
}

TEST(CharacterFormats, AreKnownByTheirEndings) {
  EXPECT_EQ(format_of("a.nazori"), CharacterFormat::document);
  EXPECT_EQ(format_of("a.b.SVG"), CharacterFormat::svg);
  EXPECT_EQ(format_of("a.str"), CharacterFormat::strokes);
  EXPECT_EQ(format_of("x/永.raw"), CharacterFormat::raw);
  EXPECT_EQ(format_of("a.Png"), CharacterFormat::png);
  EXPECT_FALSE(format_of("a.txt"));
  EXPECT_FALSE(format_of("nazori"));
}

TEST(CharacterFormats, EachOpensAgainToTheSameBytes) {
  OwnCharacter character = full_character();
  character.strokes.push_back(own_strokes({{{{80, 10}, {70, 50}, {20, 95}}, StrokeEnding::taper, {}}})[0]);
  for (const auto format : {CharacterFormat::document, CharacterFormat::svg, CharacterFormat::strokes,
                            CharacterFormat::raw, CharacterFormat::png}) {
    const auto bytes = export_character(character, format, 150);
    ASSERT_TRUE(bytes) << base::to_line(bytes.error());
    const bool has_grid = format == CharacterFormat::strokes || format == CharacterFormat::raw;
    const auto read = import_character(*bytes, format, has_grid ? std::optional<int>(150) : std::nullopt);
    ASSERT_TRUE(read) << base::to_line(read.error());
    EXPECT_EQ(*export_character(*read, format, 150), *bytes) << static_cast<int>(format);
  }
}

TEST(CharacterFormats, StrokesOfAStrHaveOneWidthAndAHookThatThinsOut) {
  const std::vector<std::uint8_t> bytes = [] {
    std::vector<std::uint8_t> out;
    for (const int value : {1, 3, 60, 10, 60, 110, 52, 102})
      for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
    return out;
  }();
  const auto read = import_character(bytes, CharacterFormat::strokes);
  ASSERT_TRUE(read) << base::to_line(read.error());
  ASSERT_EQ(read->strokes.size(), 1U);
  const OwnStroke& stroke = read->strokes[0];
  EXPECT_EQ(stroke.ending, StrokeEnding::hook);
  ASSERT_EQ(stroke.points.size(), 3U);
  EXPECT_EQ(stroke.points[0], (GroovePoint{{60.0 * 109 / 127, 10.0 * 109 / 127}, 3.5, 1}));
  EXPECT_EQ(stroke.points[1].half_width, 3.5);
  EXPECT_EQ(stroke.points[2].half_width, 0);
  EXPECT_EQ(stroke.points[2].depth, 0);
}

TEST(CharacterFormats, TheGridOfAStrIsGuessedAsAPowerOfTwo) {
  const auto grid_of = [](int x) {
    std::vector<std::uint8_t> out;
    for (const int value : {1, 2, 0, 0, x, 5})
      for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
    const auto read = import_character(out, CharacterFormat::strokes);
    return std::lround(x * geometry::kGlyphSide / read->strokes[0].points[1].at.x) + 1;
  };
  EXPECT_EQ(grid_of(127), 128);
  EXPECT_EQ(grid_of(128), 256);
  EXPECT_EQ(grid_of(600), 1024);
}

TEST(CharacterFormats, WhatAFormatCannotHoldIsRefused) {
  const OwnCharacter relief = from_height_map(*surface::HeightMap::create(16, 0.5F));
  EXPECT_FALSE(export_character(relief, CharacterFormat::svg, 16));
  EXPECT_FALSE(export_character(relief, CharacterFormat::strokes, 16));
  EXPECT_TRUE(export_character(relief, CharacterFormat::raw, 16));
  EXPECT_EQ(place_of_error(export_character(cross(), CharacterFormat::strokes, 8193)), "size");
  EXPECT_FALSE(export_character(cross(), CharacterFormat::raw, 1));
  EXPECT_FALSE(import_character(std::vector<std::uint8_t>(15), CharacterFormat::raw));
  EXPECT_FALSE(import_character({}, CharacterFormat::png));
  EXPECT_FALSE(import_character({}, CharacterFormat::strokes));
}

TEST(StrokesSvg, OfPartsThatBeginTogetherTheLargerOneIsAround) {
  OwnCharacter character = cross();
  character.strokes.push_back(even_stroke({{20, 80}, {40, 90}}));
  character.facts.parts = {{"a", {1}}, {"b", {1, 2}}, {"c", {0}}, {"d", {0, 1, 2}}};
  const auto read = parse_strokes_svg(to_strokes_svg(character));
  ASSERT_TRUE(read) << base::to_line(read.error());
  EXPECT_EQ(read->facts.parts,
            (std::vector<OwnPart>{{"d", {0, 1, 2}}, {"c", {0}}, {"b", {1, 2}}, {"a", {1}}}));
}

TEST(StrokesSvg, PartsInPiecesWithoutStrokesOrWithoutANameAreNoGroups) {
  OwnCharacter character = cross();
  character.strokes.push_back(even_stroke({{20, 80}, {40, 90}}));
  character.facts.parts = {{"a", {0, 2}}, {"b", {}}, {"", {0}}, {"c", {2}}};
  EXPECT_EQ(parse_strokes_svg(to_strokes_svg(character))->facts.parts, (std::vector<OwnPart>{{"c", {2}}}));
}

}  // namespace
}  // namespace nazori::author
