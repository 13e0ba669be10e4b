// SPDX-License-Identifier: Apache-2.0
// Models of characters, what ink may be compared with them, and characters that look alike.
#include "nazori/writing/model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "drawing.h"
#include "lookalike_contrast.h"
#include "model_inside.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/writing/lookalikes.h"
#include "nazori/writing/model_library.h"

namespace nazori::writing::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A model of one stroke "type|path".
Shape shape_of(const std::string& stroke) {
  return model_of(character(U'一', {stroke})).inside().main.shapes.front();
}

TEST(Model, NeedsStrokesWithPoints) {
  EXPECT_EQ(Model::make(kanji::Character{}).error(),
            (base::Error{base::Errc::bad_argument, "the character has no strokes", "",
                         "choose a character that has strokes"}));
  auto c = three();
  c.strokes[1].line.points.clear();
  EXPECT_EQ(Model::make(c).error().what, "a stroke of the character has no points");
  const auto model = model_of(three());
  EXPECT_EQ(model.stroke_count(), 3);
  EXPECT_EQ(model.code_point(), U'三');
  EXPECT_EQ(model.inside().main.pairs.size(), 2U);
  EXPECT_EQ(model_of(character(U'一', {"㇐|M10,50L90,50"})).inside().main.pairs.size(), 0U);
}

TEST(Model, ADotMayBeATouchWhereItIsLonger) {
  EXPECT_GT(shape_of("㇔|M10,50L30,70").touch, shape_of("㇏|M10,50L30,70").touch + 5);
  EXPECT_EQ(shape_of("㇔/㇏|M10,50L30,70").touch, shape_of("㇔|M10,50L30,70").touch);
  EXPECT_EQ(shape_of("㇏/㇔|M10,50L30,70").touch, shape_of("㇏|M10,50L30,70").touch);
}

TEST(Model, ShortStrokesAreHeldToTheirShapeUnlessTheySlant) {
  const auto freedom = [](const std::string& path) { return shape_of("㇐|" + path).freedom; };
  EXPECT_NEAR(freedom("M10,50L100,50"), 1, 1e-4) << "long";
  EXPECT_NEAR(freedom("M10,10L90,90"), 1, 1e-4);
  const float bar = freedom("M50,50L55,50");
  EXPECT_LT(bar, 0.8F);
  EXPECT_NEAR(freedom("M50,50L50,55"), bar, 1e-4);
  EXPECT_NEAR(freedom("M50,50L45,50"), bar, 1e-4);
  const float dot = freedom("M50,50L53.54,53.54");
  EXPECT_GT(dot, 1.1F);
  EXPECT_NEAR(freedom("M50,50L46.46,53.54"), dot, 1e-3);
  // In between by the sine of twice the angle: 0.5 at 15 degrees.
  EXPECT_NEAR(freedom("M50,50L54.83,51.294"), (bar + dot) / 2, 0.01);
  // The longer the nearer to 1.
  EXPECT_GT(freedom("M50,50L70,50"), bar + 0.05F);
  EXPECT_LT(freedom("M50,50L70,50"), 0.95F);
  EXPECT_EQ(freedom("M50,50L60,50L50,50"), 1) << "where it starts and ends in one place it has no slant";
}

TEST(Model, TypesWithTwoReadingsAndKanaAreFreer) {
  const float plain = shape_of("㇐|M10,50L100,50").freedom;
  EXPECT_GT(shape_of("㇐/㇀|M10,50L100,50").freedom, 1.4F * plain);
  EXPECT_GT(shape_of("|M10,50L100,50").freedom, 1.05F * plain);
  EXPECT_LT(shape_of("|M10,50L100,50").freedom, 1.4F * plain);
}

TEST(Model, OnlyWhatTheSourceCallsAKickMayBeMissing) {
  for (const auto ending :
       {kanji::StrokeEnding::stop, kanji::StrokeEnding::hook, kanji::StrokeEnding::either}) {
    auto c = character(U'一', {"㇚|M50,10L50,90L40,80"});
    c.strokes[0].line.ending = ending;
    const auto model = model_of(c);
    const auto& form = model.inside().main;
    EXPECT_TRUE(form.shapes[0].kicked);
    EXPECT_EQ(form.shapes[0].body.has_value(), ending != kanji::StrokeEnding::stop);
    EXPECT_EQ(form.endings[0], ending);
    EXPECT_EQ(form.free_ending[0] != 0, ending == kanji::StrokeEnding::either);
  }
  EXPECT_NE(model_of(character(U'一', {"㇔/㇏|M10,50L100,50"})).inside().main.free_ending[0], 0);
}

TEST(Model, KeepsOrdersOfAllItsStrokesAndVariantsInItsOwnOrder) {
  auto c = three();
  c.alternative_orders = {{{2, 1, 3}, "a"}, {{2, 1}, "too short"}, {{1, 2, 3, 4}, "too long"}};
  auto variant = three();
  variant.variant = "Other";
  auto exchanged = three();
  exchanged.variant = "Exchanged";
  std::swap(exchanged.strokes[0], exchanged.strokes[2]);
  auto backwards = three();
  backwards.variant = "Backwards";
  auto& line = backwards.strokes[1].line.points;
  std::reverse(line.begin(), line.end());
  auto empty = three();
  empty.strokes.clear();
  const auto model = Model::make(c, std::vector{exchanged, variant, backwards, empty});
  ASSERT_TRUE(model);
  ASSERT_EQ(model->inside().orders.size(), 1U);
  EXPECT_EQ(model->inside().orders[0].source, "a");
  ASSERT_EQ(model->inside().variants.size(), 1U);
  EXPECT_EQ(model->inside().variants[0].variant, "Other");
  EXPECT_EQ(model->inside().main.variant, "");
}

TEST(Model, AVariantIsAcceptedAndNamed) {
  // A soil whose upper bar is a long slant.
  auto variant = soil();
  variant.variant = "Slant";
  for (auto& p : variant.strokes[0].line.points) p = {p.x, p.y - 0.9 * (p.x - 54)};
  const auto plain = model_of(soil());
  const auto both = Model::make(soil(), std::vector{variant});
  ASSERT_TRUE(both);
  EXPECT_FALSE(graded(trace(variant), plain).accepted);
  const auto g = graded(trace(variant), *both);
  EXPECT_TRUE(g.accepted);
  EXPECT_EQ(g.variant, "Slant");
  EXPECT_EQ(graded(trace(soil()), *both).variant, "");
  auto other = trace(variant);
  other.strokes.pop_back();
  EXPECT_FALSE(graded(other, *both).accepted);
}

/// Writing of so many strokes of so many points each.
WrittenCharacter ink_of(std::size_t strokes, std::size_t points) {
  WrittenCharacter ink;
  for (std::size_t i = 0; i < strokes; ++i) {
    WrittenStroke s;
    for (std::size_t k = 0; k < points; ++k) s.push_back({{static_cast<double>(k), static_cast<double>(i)}});
    ink.strokes.push_back(std::move(s));
  }
  return ink;
}

TEST(WrittenCharacter, HasAtMostAHundredStrokesAndFiftyThousandPoints) {
  EXPECT_TRUE(check(ink_of(100, 2)));
  EXPECT_EQ(check(ink_of(101, 2)).error(),
            (base::Error{base::Errc::bad_argument, "there are too many strokes", "101", "give at most 100"}));
  EXPECT_TRUE(check(ink_of(50, 1000)));
  auto more = ink_of(50, 1000);
  more.strokes[20].push_back({{1, 1}});
  EXPECT_EQ(check(more).error(), (base::Error{base::Errc::bad_argument, "has too many points", "stroke 50",
                                              "give at most 50000"}));
}

TEST(WrittenCharacter, IsCalledBadByWhatIsWrongWithIt) {
  const auto wrong = [](auto spoil) {
    auto ink = ink_of(3, 3);
    ink.box = WritingBox{{0, 0}, 100};
    spoil(ink);
    const auto good = check(ink);
    return good ? std::string() : base::to_line(good.error());
  };
  EXPECT_EQ(wrong([](WrittenCharacter&) {}), "");
  EXPECT_EQ(wrong([](WrittenCharacter& i) { i.strokes.clear(); }), "there are no strokes");
  EXPECT_EQ(wrong([](WrittenCharacter& i) { i.strokes[1].clear(); }), "stroke 2: has no points");
  EXPECT_EQ(wrong([](WrittenCharacter& i) {
              i.strokes[2][0].time_s = 1;
              i.strokes[2][1].time_s = 2;
            }),
            "stroke 3: must have as many times as points");
  EXPECT_EQ(wrong([](WrittenCharacter& i) {
              for (auto& p : i.strokes[2]) p.time_s = 1;
            }),
            "");
  EXPECT_EQ(wrong([](WrittenCharacter& i) { i.strokes[0].back().pressure = 1; }),
            "stroke 1: must have as many pressures as points");
  EXPECT_EQ(wrong([](WrittenCharacter& i) {
              for (auto& p : i.strokes[0]) p.pressure = 1;
            }),
            "");
  const double largest = 1e9, beyond = std::nextafter(largest, 2e9);
  for (const double v : {largest, -largest}) {
    EXPECT_EQ(wrong([v](WrittenCharacter& i) { i.strokes[0][1].at.x = v; }), "");
    EXPECT_EQ(wrong([v](WrittenCharacter& i) { i.strokes[0][1].at.y = v; }), "");
    EXPECT_EQ(wrong([v](WrittenCharacter& i) { i.box->corner = {v, v}; }), "");
  }
  for (const double v : {beyond, -beyond, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(wrong([v](WrittenCharacter& i) { i.strokes[1][1].at.x = v; }),
              "stroke 2: has an invalid coordinate");
    EXPECT_EQ(wrong([v](WrittenCharacter& i) { i.strokes[2][2].at.y = v; }),
              "stroke 3: has an invalid coordinate");
    EXPECT_EQ(wrong([v](WrittenCharacter& i) { i.box->corner.x = v; }),
              "the writing box must be a square larger than zero");
    EXPECT_EQ(wrong([v](WrittenCharacter& i) { i.box->corner.y = v; }),
              "the writing box must be a square larger than zero");
    EXPECT_EQ(wrong([v](WrittenCharacter& i) { i.box->side = v; }),
              "the writing box must be a square larger than zero");
  }
  EXPECT_EQ(wrong([](WrittenCharacter& i) { i.box->side = -1; }),
            "the writing box must be a square larger than zero");
  EXPECT_EQ(wrong([](WrittenCharacter& i) {
              for (auto& s : i.strokes)
                for (auto& p : s) p.at = {4, 5};
            }),
            "all points are the same");
  EXPECT_EQ(wrong([](WrittenCharacter& i) {
              for (auto& s : i.strokes)
                for (auto& p : s) p.at = {4, 5};
              i.strokes[2][2].at.y = 6;
            }),
            "");
}

const kanji::KanjiDatabase& database() {
  static const auto kOpened = [] {
    const char* folder = std::getenv("NAZORI_DATA");  // NOLINT(concurrency-mt-unsafe): one thread
    auto opened =
        kanji::KanjiDatabase::open(std::filesystem::path(folder == nullptr ? "." : folder) / "kanji.db");
    if (!opened) std::abort();
    return std::move(*opened);
  }();
  return kOpened;
}

TEST(ModelLibrary, KeepsWhatItMadeWithTheCharactersItIsMistakenFor) {
  ModelLibrary library(database());
  const auto soil = library.find(U'土');
  ASSERT_TRUE(soil);
  EXPECT_EQ((*soil)->model.code_point(), U'土');
  std::vector<char32_t> lookalikes;
  for (const auto& m : (*soil)->lookalikes) lookalikes.push_back(m.code_point());
  EXPECT_EQ(lookalikes, lookalikes_of(U'土'));
  EXPECT_THAT(lookalikes, testing::Contains(U'士'));
  for (const char32_t c : U"休日本人大小") (void)library.find(c);
  EXPECT_EQ(*library.find(U'土'), *soil) << "it stays where it is";
  EXPECT_FALSE((*library.find(U'休'))->model.inside().variants.empty());
  const auto none = library.find(U'\U0001F600');
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, base::Errc::not_found);
  EXPECT_EQ(none.error().where, "\xF0\x9F\x98\x80");
}

TEST(Lookalikes, AreMutualAndAscend) {
  for (const char32_t a : U"土士うらラし丿亅巳已己人入八") {
    if (a == 0) continue;
    const auto others = lookalikes_of(a);
    EXPECT_FALSE(others.empty());
    EXPECT_TRUE(std::is_sorted(others.begin(), others.end()));
    EXPECT_EQ(std::set<char32_t>(others.begin(), others.end()).size(), others.size());
    for (const char32_t b : others) EXPECT_THAT(lookalikes_of(b), testing::Contains(a));
  }
  EXPECT_THAT(lookalikes_of(U'口'), ElementsAre(U'囗'));
  EXPECT_THAT(lookalikes_of(U'土'), ElementsAre(U'士', U'工'));
  EXPECT_THAT(lookalikes_of(U'鬱'), IsEmpty());
}

/// Three bars, the middle one of this length.
Model bars(char32_t code_point, double middle, double size = 1) {
  const auto line = [size](double x0, double y0, double x1, double y1) {
    return "M" + std::to_string(size * x0) + "," + std::to_string(size * y0) + "L" +
           std::to_string(size * x1) + "," + std::to_string(size * y1);
  };
  return model_of(character(
      code_point, {"㇐|" + line(20, 10, 90, 10), "㇐|" + line(55 - middle / 2, 50, 55 + middle / 2, 50),
                   "㇐|" + line(10, 90, 100, 90), "㇑|" + line(55, 5, 55, 105)}));
}
std::vector<Shape> drawn_with(double middle) { return bars(U'一', middle).inside().main.shapes; }

TEST(LookalikeContrast, IsNoneOfAFormFromItselfAndGrowsWithTheSquare) {
  const auto distance = [](double a, double b) {
    return distance_of_forms(bars(U'一', a).inside().main, bars(U'二', b).inside().main);
  };
  EXPECT_NEAR(distance(40, 40), 0, 1e-4);
  EXPECT_NEAR(distance(40, 42) * 4, distance(40, 44), 0.06 * distance(40, 44));
  EXPECT_TRUE(std::isinf(distance_of_forms(model_of(soil()).inside().main, model_of(eye()).inside().main)));
  // Both ends 2 off, in units of 5: that much at least, less what the laying over takes.
  EXPECT_NEAR(distance(60, 64), 2 * 4 / 25.0, 0.12);
}

TEST(LookalikeContrast, IsMeasuredInTheUnitsOfTheSecondForm) {
  const auto distance = [](double size_a, double size_b) {
    return distance_of_forms(bars(U'一', 40, size_a).inside().main, bars(U'二', 46, size_b).inside().main);
  };
  const double equal = distance(1, 1);
  EXPECT_NEAR(distance(0.5, 1), equal, 0.05 * equal) << "the first is laid over the second";
  EXPECT_NEAR(distance(1, 0.5), equal / 4, 0.05 * equal) << "half as far apart, and it grows with the square";
}

TEST(LookalikeContrast, TheBorderLiesOnTheOthersSideOfTheMiddle) {
  const auto asked = bars(U'一', 30);
  const std::vector<Model> others{bars(U'二', 70)};
  const auto mistaken = [&](double middle) {
    return mistaken_for(drawn_with(middle), asked.inside().main, others);
  };
  EXPECT_FALSE(mistaken(30));
  EXPECT_FALSE(mistaken(50)) << "in the middle";
  EXPECT_FALSE(mistaken(51));
  const auto m = mistaken(57);
  ASSERT_TRUE(m);
  EXPECT_EQ(m->character, U'二');
  EXPECT_EQ(m->stroke, 1) << "the one that shows it";
  EXPECT_TRUE(mistaken(70));
}

TEST(LookalikeContrast, TheStrokeThatShowsItMayBeTheFirst) {
  const auto first_bar = [](char32_t code_point, double length) {
    const std::string left = std::to_string(55 - length / 2), right = std::to_string(55 + length / 2);
    return model_of(character(code_point, {"㇐|M" + left + ",10L" + right + ",10", "㇐|M20,50L90,50",
                                           "㇐|M10,90L100,90", "㇑|M55,5L55,105"}));
  };
  const auto asked = first_bar(U'一', 30);
  const std::vector<Model> others{first_bar(U'二', 70)};
  const auto drawn = first_bar(U'一', 70);
  const auto mistaken = mistaken_for(drawn.inside().main.shapes, asked.inside().main, others);
  ASSERT_TRUE(mistaken);
  EXPECT_EQ(mistaken->stroke, 0);
}

TEST(LookalikeContrast, OfSeveralTheNearestIsNamedAndThoseOfOtherCountsAreNot) {
  const auto asked = bars(U'一', 30);
  const std::vector<Model> others{model_of(soil()), bars(U'二', 50), bars(U'三', 85), bars(U'四', 30)};
  const auto mistaken = mistaken_for(drawn_with(85), asked.inside().main, others);
  ASSERT_TRUE(mistaken);
  EXPECT_THAT(mistaken->character, testing::AnyOf(U'二', U'三'));
  EXPECT_FALSE(mistaken_for(drawn_with(30), asked.inside().main, others));
  EXPECT_FALSE(mistaken_for(drawn_with(85), asked.inside().main, {}));
}

}  // namespace
}  // namespace nazori::writing::test
