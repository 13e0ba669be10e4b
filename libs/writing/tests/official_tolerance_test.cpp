// SPDX-License-Identifier: Apache-2.0
// What handwriting may do by the guideline of the Council for Cultural Affairs on the glyph forms of the Jōyō
// kanji table (常用漢字表の字体・字形に関する指針, 29 February 2016) and by the note of the table itself
// (付・字体についての解説, 2010). Each kind of freedom has examples from those texts, drawn here by changing
// the model's lines.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "drawing.h"
#include "judgement.h"
#include "model_inside.h"
#include "nazori/base/utf8.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/writing/model_library.h"

namespace nazori::writing::test {
namespace {

using Change = std::function<void(WrittenCharacter&)>;

/// Longer or shorter about its middle.
Change stretched(std::size_t stroke, double by) {
  return [=](WrittenCharacter& ink) {
    auto& points = ink.strokes.at(stroke);
    const auto middle = (points.front().at + points.back().at) * 0.5;
    for (auto& p : points) p.at = middle + (p.at - middle) * by;
  };
}

/// A straight line from the model's start to a point.
Change straight(std::size_t stroke, double to_x, double to_y) {
  return [=](WrittenCharacter& ink) {
    auto& points = ink.strokes.at(stroke);
    const auto from = points.front().at;
    points = along({from, {to_x, to_y}});
  };
}

Change line(std::size_t stroke, const geometry::Polyline<WritingFrame>& points) {
  return [=](WrittenCharacter& ink) { ink.strokes.at(stroke) = along(points); };
}

/// Ends before it touches.
Change ends_early(std::size_t stroke, double share) {
  return [=](WrittenCharacter& ink) { ink.strokes.at(stroke) = shortened(ink.strokes.at(stroke), share); };
}

/// A hook to the left at the end.
Change hooked(std::size_t stroke) {
  return [=](WrittenCharacter& ink) {
    auto& points = ink.strokes.at(stroke);
    const auto end = points.back().at;
    points.push_back({{end.x - 7, end.y - 6}});
  };
}

/// From its start straight to the lowest point: without the hook.
Change unhooked(std::size_t stroke) {
  return [=](WrittenCharacter& ink) {
    auto& points = ink.strokes.at(stroke);
    std::size_t lowest = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      if (points[k].at.y > points[lowest].at.y) lowest = k;
    points.resize(lowest + 1);
  };
}

struct Example {
  std::string kind;
  char32_t character;
  std::vector<Change> changes;
};

TEST(OfficialTolerance, EachKindOfFreedomPassesAtNormalStrictness) {
  const char* folder = std::getenv("NAZORI_DATA");  // NOLINT(concurrency-mt-unsafe): one thread
  ASSERT_NE(folder, nullptr);
  const auto database = kanji::KanjiDatabase::open(std::filesystem::path(folder) / "kanji.db");
  ASSERT_TRUE(database);
  ModelLibrary library(*database);
  const std::vector<Example> examples{
      {"long or short: either bar of 天", U'天', {stretched(0, 0.85), stretched(1, 1.25)}},
      {"long or short: the bars of 雨", U'雨', {stretched(0, 0.8)}},
      {"long or short: the first bar of 戸", U'戸', {stretched(0, 1.2)}},
      {"direction: the first stroke of 言 level", U'言', {line(0, {{46, 19}, {61, 19}})}},
      {"direction: the first stroke of 言 upright", U'言', {line(0, {{54, 11}, {54, 22}})}},
      {"direction: the first stroke of 主 level", U'主', {line(0, {{45, 18}, {62, 18}})}},
      {"direction: the first stroke of 主 upright", U'主', {line(0, {{53, 10}, {53, 24}})}},
      {"touching or apart: the bars of 日", U'日', {ends_early(2, 0.85), ends_early(3, 0.85)}},
      {"touching or apart: the bars of 目", U'目', {ends_early(2, 0.85), ends_early(3, 0.85)}},
      {"touching or apart: the bars of 月", U'月', {ends_early(2, 0.85), ends_early(3, 0.85)}},
      {"touching or apart: the bars of 田", U'田', {ends_early(3, 0.88)}},
      {"touching or apart: the sweep of 文", U'文', {ends_early(2, 0.9)}},
      {"stop or hook: the stem of 木", U'木', {hooked(1)}},
      {"stop or hook: the stem of 来", U'来', {hooked(4)}},
      {"stop or hook: the stem of 林", U'林', {hooked(1)}},
      {"stop or hook: the stem of 寸", U'寸', {unhooked(1)}},
      {"stop or hook: the stem of 手", U'手', {unhooked(3)}},
      {"stop or hook: the stem of 打", U'打', {unhooked(1)}},
      {"stop or hook: the frame of 月", U'月', {unhooked(1)}},
      {"stop or sweep: the last stroke of 因", U'因', {ends_early(4, 0.85)}},
      {"stop or sweep: the last stroke of 困", U'困', {ends_early(5, 0.85)}},
      {"stop or sweep: the stem of 十", U'十', {stretched(1, 1.1)}},
      {"bent or straight: the stem of 子", U'子', {straight(1, 54, 92)}},
      {"bent or straight: the stem of 了", U'了', {straight(1, 54, 92)}},
  };
  for (const auto& example : examples) {
    const auto main = database->find(example.character);
    ASSERT_TRUE(main);
    auto ink = trace(*main);
    for (const auto& change : example.changes) change(ink);
    const auto entry = library.find(example.character);
    ASSERT_TRUE(entry);
    const auto grade = writing::grade(ink, (*entry)->model, {}, (*entry)->lookalikes);
    ASSERT_TRUE(grade);
    EXPECT_TRUE(grade->accepted) << example.kind << ": " << testing::PrintToString(mistake_names(*grade));
    for (const auto& advice : grade->advice)
      EXPECT_NE(advice.deviation, Deviation::direction) << example.kind << ", stroke " << advice.stroke;
  }
}

TEST(OfficialTolerance, ADotThatLeansToTheOtherSideIsRefused) {
  const char* folder = std::getenv("NAZORI_DATA");  // NOLINT(concurrency-mt-unsafe): one thread
  ASSERT_NE(folder, nullptr);
  const auto database = kanji::KanjiDatabase::open(std::filesystem::path(folder) / "kanji.db");
  ASSERT_TRUE(database);
  ModelLibrary library(*database);
  for (const char32_t c : {U'言', U'主'}) {
    auto ink = trace(*database->find(c));
    line(0, {{61, 11}, {46, 24}})(ink);
    const auto grade = writing::grade(ink, (*library.find(c))->model, {});
    ASSERT_TRUE(grade);
    EXPECT_FALSE(grade->accepted);
  }
}

std::vector<bool> free_slants(const std::vector<std::string>& strokes) {
  std::vector<bool> free;
  const Model model = model_of(character(U'言', strokes));
  for (const auto& shape : model.inside().main.shapes) free.push_back(shape.free_slant);
  return free;
}

TEST(OfficialTolerance, OnlyADotAboveABarThatReachesFurtherOnBothSidesHasAFreeSlant) {
  EXPECT_EQ(free_slants({"㇔|M45,12L58,22", "㇐|M20,35L90,35"}), (std::vector<bool>{true, false}));
  EXPECT_EQ(free_slants({"㇐|M45,12L58,22", "㇐|M20,35L90,35"}), (std::vector<bool>{false, false}))
      << "no dot";
  EXPECT_EQ(free_slants({"㇔|M45,12L58,22", "㇐|M20,16L90,16"}), (std::vector<bool>{false, false}))
      << "the bar is not below";
  EXPECT_EQ(free_slants({"㇔|M45,12L58,22", "㇐|M46,35L90,35"}), (std::vector<bool>{false, false}))
      << "not further left";
  EXPECT_EQ(free_slants({"㇔|M45,12L58,22", "㇐|M20,35L57,35"}), (std::vector<bool>{false, false}))
      << "not further right";
  EXPECT_EQ(free_slants({"㇔|M22,12L36,24", "㇔|M14,36L28,48"}), (std::vector<bool>{false, false}))
      << "the water radical";
}

TEST(OfficialTolerance, OnlyTheSlantOfAStraightDotThatIsLevelOrUprightIsIgnored) {
  Samples slanted{};
  slanted.x.back() = 10;
  slanted.y.back() = 10;
  const auto freed = [&slanted](Residue left) {
    StrokeDifference d;
    d.proportion = 0.2F;
    Course way{0.5F, 0.1F};
    const bool is_free = ignore_slant(slanted, left, d, way);
    EXPECT_EQ(way.chord_turn, is_free ? 0 : 0.5F);
    EXPECT_EQ(way.along, is_free ? 0 : 0.1F);
    return std::pair{d.proportion, left.turn_rad};
  };
  const float half = 0.7854F;  // 45 degrees
  EXPECT_EQ(freed({half, 0.04F, 0}), std::pair(0.04F, 0.0F)) << "upright";
  EXPECT_EQ(freed({-half, 0.04F, 0}), std::pair(0.04F, 0.0F)) << "level";
  EXPECT_EQ(freed({half + 0.12F, 0.04F, 0}), std::pair(0.04F, 0.0F)) << "nearly upright";
  EXPECT_EQ(freed({half - 0.12F, 0.04F, 0}), std::pair(0.04F, 0.0F)) << "nearly upright";
  EXPECT_EQ(freed({0.6F, 0.04F, 0}), std::pair(0.2F, 0.6F)) << "neither";
  EXPECT_EQ(freed({3 * half, 0.04F, 0}), std::pair(0.2F, 3 * half)) << "backwards";
  EXPECT_EQ(freed({half, 0.06F, 0}), std::pair(0.2F, half)) << "bent";
}

}  // namespace
}  // namespace nazori::writing::test
