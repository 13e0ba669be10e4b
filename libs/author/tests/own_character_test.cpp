// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/own_character.h"

#include <gtest/gtest.h>

#include <cmath>

#include "own_forms.h"

namespace nazori::author {
namespace {

using namespace test;

kanji::Character two_strokes() {
  kanji::Character character;
  character.code_point = U'二';
  character.strokes.resize(2);
  character.strokes[0].line = {{{20, 30}, {90, 30}}, StrokeEnding::stop, GlyphPoint{12, 28}};
  character.strokes[1].line = {{{15, 80}, {60, 82}, {95, 70}}, StrokeEnding::taper, {}};
  character.entry.on_readings = {"ニ", "ジ"};
  character.entry.kun_readings = {"ふた"};
  character.entry.meanings = {{"en", "two"}, {"fr", "deux"}};
  character.entry.radical = 7;
  character.components.element = "二";
  character.components.strokes = {0, 1};
  kanji::Component upper;
  upper.element = "一";
  upper.strokes = {0};
  kanji::Component split;
  split.element = "冂";
  split.part = 1;
  split.strokes = {0};
  kanji::Component rest = split;
  rest.part = 2;
  rest.strokes = {1};
  character.components.children = {upper, split, rest};
  return character;
}

TEST(CopyOfACharacter, HasWhatTheDatabaseSays) {
  const OwnCharacter copy = copy_of(two_strokes());
  EXPECT_EQ(copy.facts.name, "二");
  EXPECT_EQ(copy.facts.readings, (std::vector<std::string>{"ニ", "ジ", "ふた"}));
  EXPECT_EQ(copy.facts.meanings, (std::vector<std::string>{"two"}));
  EXPECT_EQ(copy.facts.parts, (std::vector<OwnPart>{{"一", {0}}, {"冂", {0, 1}}}));
  EXPECT_EQ(copy.facts.radical, 7);
  EXPECT_EQ(copy.facts.rights.licence, "CC-BY-SA-3.0");
  EXPECT_EQ(copy.facts.rights.source, "KanjiVG");
  EXPECT_NE(copy.facts.rights.author.find("Ulrich Apel"), std::string::npos);
  ASSERT_EQ(copy.strokes.size(), 2U);
  EXPECT_EQ(copy.strokes[0].number_position, (GlyphPoint{12, 28}));
  EXPECT_FALSE(copy.strokes[1].number_position);
  EXPECT_EQ(copy.strokes[1].ending, StrokeEnding::taper);
  EXPECT_TRUE(copy.hand.is_untouched());
  EXPECT_TRUE(validate(copy));
}

TEST(CopyOfACharacter, IsCarvedLikeIt) {
  const kanji::Character character = two_strokes();
  const auto map = carved(copy_of(character), 512);
  const auto original = carving::carve(character.lines(), 512);
  ASSERT_TRUE(original);
  for (std::size_t i = 0; i < map.samples().size(); ++i)
    ASSERT_NEAR(map.samples()[i], original->samples()[i], 0.01) << i;
}

TEST(FromHeightMap, CarvesTheSameMap) {
  auto map = surface::HeightMap::create(64);
  for (int i = 0; i < 64; ++i) map->set(i, 63 - i, static_cast<float>(i) / 63.0F);
  const OwnCharacter character = from_height_map(*map);
  EXPECT_TRUE(character.strokes.empty());
  EXPECT_EQ(character.hand.size, 64);
  EXPECT_EQ(surface::to_raw(carved(character, 64)), surface::to_raw(*map));
  EXPECT_EQ(surface::to_png(carved(character, 64), surface::PngDepth::bits_16),
            surface::to_png(*map, surface::PngDepth::bits_16));
}

TEST(OwnCarving, AddsTheHandsLayerToTheStrokesAndStaysWithinTheTablet) {
  OwnCharacter character = cross();
  const auto strokes = carved(character, 64);
  character.hand = layer_with(64, {10, 10, 50, 40}, -0.25F);
  const auto map = carved(character, 64);
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 64; ++column) {
      const bool inside = column >= 10 && column < 50 && row >= 10 && row < 40;
      const float height = strokes.at(column, row) - (inside ? 0.25F : 0.0F);
      ASSERT_EQ(map.at(column, row), std::max(height, 0.0F)) << column << ", " << row;
    }
  }
  character.hand = layer_with(64, {0, 0, 64, 64}, 1.0F);
  const auto level = carved(character, 64);
  for (const float height : level.samples()) ASSERT_EQ(height, 1.0F);
}

TEST(OwnCarving, ALayerOfAnotherSizeIsInterpolated) {
  OwnCharacter character;
  character.hand = {3, {0, -0.5F, -1, 0, -0.5F, -1, 0, -0.5F, -1}};
  const auto map = carved(character, 9);
  for (int row = 0; row < 9; ++row)
    for (int column = 0; column < 9; ++column)
      EXPECT_FLOAT_EQ(map.at(column, row), 1.0F - static_cast<float>(column) / 8.0F);
  character.hand = {2, {0, 0, -0.5F, -1}};
  const auto other = carved(character, 5);
  EXPECT_FLOAT_EQ(other.at(4, 2), 0.5F);
  EXPECT_FLOAT_EQ(other.at(2, 4), 0.25F);
  EXPECT_FLOAT_EQ(other.at(2, 2), 1 - 0.375F);
  EXPECT_FLOAT_EQ(other.at(1, 3), 1 - 0.75F * 0.625F);
}

TEST(OwnCarving, ABoxIsTheSamePartOfTheWholeToTheLastBit) {
  OwnCharacter character = cross();
  character.hand = layer_with(40, {3, 5, 30, 33}, -0.3F);
  const auto whole = carved(character, 128);
  auto map = surface::HeightMap::create(128, 0.5F);
  const carving::GridBox box{30, 20, 90, 77};
  ASSERT_TRUE(carve_box(character, box, *map));
  for (int row = 0; row < 128; ++row) {
    for (int column = 0; column < 128; ++column) {
      const bool inside = column >= 30 && column < 90 && row >= 20 && row < 77;
      ASSERT_EQ(map->at(column, row), inside ? whole.at(column, row) : 0.5F);
    }
  }
}

TEST(OwnTablet, HasTheStrokesAsLinesAtTheDepthOfTheRelief) {
  const auto tablet = carved_tablet(cross(), 1024);
  ASSERT_TRUE(tablet);
  ASSERT_EQ((*tablet)->lines().size(), 2U);
  EXPECT_EQ((*tablet)->lines()[0].points, (geometry::Polyline<geometry::GlyphFrame>{{15, 50}, {95, 50}}));
  EXPECT_EQ((*tablet)->height_map(), carved(cross(), 1024));
  // The vertical stroke is 0.75 deep; the tablet 10 mm.
  const auto& path = (*tablet)->paths()[1].points;
  EXPECT_NEAR(path[path.size() / 4].z, -0.0075, 1e-5);
}

TEST(Validate, NamesWhatIsOutOfRange) {
  const auto why = [](auto change) {
    OwnCharacter character = cross();
    change(character);
    return place_of_error(validate(character));
  };
  using Own = OwnCharacter;
  EXPECT_EQ(why([](Own&) {}), "");
  EXPECT_EQ(why([](Own& c) { c.facts.name = std::string(200, 'a'); }), "");
  EXPECT_EQ(why([](Own& c) { c.facts.name = std::string(201, 'a'); }), "name");
  EXPECT_EQ(why([](Own& c) { c.facts.name = "a\nb"; }), "name");
  EXPECT_EQ(why([](Own& c) { c.facts.name = "\xff"; }), "name");
  EXPECT_EQ(why([](Own& c) { c.facts.name = "\xC2\x9F"; }), "name");
  EXPECT_EQ(why([](Own& c) { c.facts.name = "\xC2\xA0"; }), "");
  EXPECT_EQ(why([](Own& c) { c.facts.readings[1] = ""; }), "reading 2");
  EXPECT_EQ(why([](Own& c) { c.facts.readings[1] = std::string(1000, 'x'); }), "");
  EXPECT_EQ(why([](Own& c) { c.facts.readings[1] = std::string(1001, 'x'); }), "reading 2");
  EXPECT_EQ(why([](Own& c) { c.facts.meanings.assign(100, "x"); }), "");
  EXPECT_EQ(why([](Own& c) { c.facts.meanings.assign(101, "x"); }), "meanings");
  EXPECT_EQ(why([](Own& c) { c.facts.parts[1].strokes = {0, 1}; }), "");
  EXPECT_EQ(why([](Own& c) { c.facts.parts[1].strokes = {0, 2}; }), "part 2");
  EXPECT_EQ(why([](Own& c) { c.facts.parts[1].strokes = {-1}; }), "part 2");
  EXPECT_EQ(why([](Own& c) { c.facts.parts[1].strokes = {1, 1}; }), "part 2");
  EXPECT_EQ(why([](Own& c) { c.facts.parts.assign(101, {}); }), "parts");
  EXPECT_EQ(why([](Own& c) { c.facts.radical = 214; }), "");
  EXPECT_EQ(why([](Own& c) { c.facts.radical = 215; }), "radical");
  EXPECT_EQ(why([](Own& c) { c.facts.radical = 0; }), "radical");
  EXPECT_EQ(why([](Own& c) { c.facts.rights.licence = "\x01"; }), "licence");
  EXPECT_EQ(why([](Own& c) { c.facts.rights.author = "\x01"; }), "author");
  EXPECT_EQ(why([](Own& c) { c.facts.rights.source = "\x01"; }), "source");
  EXPECT_EQ(why([](Own& c) { c.strokes.assign(200, c.strokes[0]); }), "");
  EXPECT_EQ(why([](Own& c) { c.strokes.assign(201, c.strokes[0]); }), "strokes");
  EXPECT_EQ(why([](Own& c) { c.strokes[1].points.clear(); }), "stroke 2");
  EXPECT_EQ(why([](Own& c) { c.strokes[1].points.assign(1000, {{1, 1}, 1, 1}); }), "");
  EXPECT_EQ(why([](Own& c) { c.strokes[1].points.assign(1001, {{1, 1}, 1, 1}); }), "stroke 2");
  EXPECT_EQ(why([](Own& c) {
              c.strokes.assign(20, c.strokes[0]);
              for (OwnStroke& s : c.strokes) s.points.assign(1000, {{1, 1}, 1, 1});
            }),
            "");
  EXPECT_EQ(why([](Own& c) {
              c.strokes.assign(21, c.strokes[0]);
              for (OwnStroke& s : c.strokes) s.points.assign(1000, {{1, 1}, 1, 1});
            }),
            "strokes");
  EXPECT_EQ(why([](Own& c) { c.strokes[0].points[1].at.x = NAN; }), "stroke 1, point 2");
  EXPECT_EQ(why([](Own& c) { c.strokes[0].points[1].at.y = -109; }), "");
  EXPECT_EQ(why([](Own& c) { c.strokes[0].points[1].at.y = -109.1; }), "stroke 1, point 2");
  EXPECT_EQ(why([](Own& c) { c.strokes[0].points[1].at.x = 218.1; }), "stroke 1, point 2");
  EXPECT_EQ(why([](Own& c) { c.strokes[0].points[1].half_width = 20.1; }), "stroke 1, point 2");
  EXPECT_EQ(why([](Own& c) { c.strokes[0].points[1].half_width = -0.1; }), "stroke 1, point 2");
  EXPECT_EQ(why([](Own& c) { c.strokes[0].points[1].depth = 1.1; }), "stroke 1, point 2");
  EXPECT_EQ(why([](Own& c) { c.strokes[0].points[1].depth = -0.1; }), "stroke 1, point 2");
  EXPECT_EQ(why([](Own& c) { c.strokes[0].ending = static_cast<StrokeEnding>(4); }), "stroke 1");
  EXPECT_EQ(why([](Own& c) { c.strokes[0].number_position = GlyphPoint{0, INFINITY}; }), "stroke 1");
  EXPECT_EQ(why([](Own& c) { c.hand = {2, {0, 1, -1, 0}}; }), "");
  EXPECT_EQ(why([](Own& c) { c.hand = {2, {0, 1.1F, -1, 0}}; }), "hand");
  EXPECT_EQ(why([](Own& c) { c.hand = {2, {0, 1, NAN, 0}}; }), "hand");
  EXPECT_EQ(why([](Own& c) { c.hand = {2, {0, 1, -1}}; }), "hand");
  EXPECT_EQ(why([](Own& c) { c.hand = {1, {0}}; }), "hand");
  EXPECT_EQ(why([](Own& c) { c.hand = {-2, {0, 0, 0, 0}}; }), "hand");
}

}  // namespace
}  // namespace nazori::author
