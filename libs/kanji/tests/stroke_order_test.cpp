// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/stroke_order.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "nazori/base/file.h"
#include "nazori/geometry/frames.h"
#include "nazori/geometry/polyline.h"
#include "nazori/kanji/centre_lines.h"

namespace nazori::kanji {
namespace {

using Bytes = std::vector<std::uint8_t>;
using geometry::GlyphPoint;

/// Little-endian int32, the only data type in a .str file.
Bytes file_of(std::initializer_list<std::int32_t> numbers) {
  Bytes bytes;
  for (const std::int32_t number : numbers) {
    for (unsigned i = 0; i < 4; ++i)
      bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint32_t>(number) >> (8 * i)));
  }
  return bytes;
}

/// Character 0018, 休, as the 2005 program had it: numbers in the order of its file, built here byte by byte.
Bytes kyuu_of_2005() {
  return file_of({6,  2,  50, 21, 19, 53, 2,  40, 40, 38, 99, 2,  63, 32,  109, 31,  2, 85,
                  20, 86, 97, 3,  83, 41, 72, 59, 57, 74, 3,  90, 41, 103, 58,  125, 70});
}

TEST(StrokeOrder, ReadsThe休Of2005) {
  const auto order = StrokeOrder::parse(kyuu_of_2005(), 128);
  ASSERT_TRUE(order) << base::to_line(order.error());
  EXPECT_EQ(order->count(), 6U);
  EXPECT_EQ(order->stroke(1), (StrokeOrder::Points{{50, 21}, {19, 53}}));
  EXPECT_EQ(order->stroke(6), (StrokeOrder::Points{{90, 41}, {103, 58}, {125, 70}}));
  EXPECT_EQ(order->all().size(), 6U);
}

TEST(StrokeOrder, WritesTheVeryBytesItRead) {
  const Bytes bytes = kyuu_of_2005();
  EXPECT_EQ(StrokeOrder::parse(bytes, 128)->to_bytes(), bytes);
  EXPECT_EQ(bytes[0], 6) << "least significant byte first";
  EXPECT_EQ(bytes.size(), 4U + 6 * 4 + 14 * 8);
}

TEST(StrokeOrder, IsBuiltInCode) {
  StrokeOrder order;
  EXPECT_EQ(order.count(), 0U);
  EXPECT_EQ(order.to_bytes(), file_of({0}));
  order.add_stroke({{1, 2}, {3, 4}});
  order.add_stroke({{5, 6}});
  EXPECT_EQ(order.count(), 2U);
  EXPECT_EQ(order.stroke(2), (StrokeOrder::Points{{5, 6}}));
  EXPECT_EQ(order.to_bytes(), file_of({2, 2, 1, 2, 3, 4, 1, 5, 6}));
  EXPECT_EQ(StrokeOrder::parse(order.to_bytes(), 7).value(), order);
}

TEST(StrokeOrder, EveryTruncationIsAnErrorWithAPlace) {
  const Bytes bytes = kyuu_of_2005();
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const auto order = StrokeOrder::parse(std::span(bytes).first(length), 128);
    ASSERT_FALSE(order) << length;
    EXPECT_EQ(order.error().code, base::Errc::parse);
    EXPECT_NE(order.error().where.find("byte "), std::string::npos);
  }
}

TEST(StrokeOrder, LeftOverBytesAreAnError) {
  Bytes bytes = kyuu_of_2005();
  bytes.push_back(0);
  const auto order = StrokeOrder::parse(bytes, 128);
  ASSERT_FALSE(order);
  EXPECT_NE(order.error().what.find("left over"), std::string::npos);
}

TEST(StrokeOrder, NegativeAndAbsurdCountsAreErrorsWithoutSettingMemoryAside) {
  constexpr std::int32_t kHuge = std::numeric_limits<std::int32_t>::max();
  for (const Bytes& bytes :
       {file_of({-1}), file_of({kHuge}), file_of({1025}), file_of({1, -1}), file_of({1, 0}),
        file_of({1, kHuge}), file_of({1, 65537}), file_of({1, 65536, 1, 1}),
        file_of({1, std::numeric_limits<std::int32_t>::min()})}) {
    const auto order = StrokeOrder::parse(bytes, 8192);
    ASSERT_FALSE(order);
    EXPECT_EQ(order.error().code, base::Errc::parse);
  }
}

TEST(StrokeOrder, AnErrorSaysWhatIsWrongAndWhere) {
  const auto error = [](const Bytes& bytes) {
    const auto order = StrokeOrder::parse(bytes, 128);
    return order ? base::Error{} : order.error();
  };
  const auto parse = [](std::string what, std::string where, std::string remedy = {}) {
    return base::Error{base::Errc::parse, std::move(what), std::move(where), std::move(remedy)};
  };
  EXPECT_EQ(error({1, 0, 0}), parse("the file ends before the number of strokes", "byte 0"));
  EXPECT_EQ(error(file_of({1})), parse("the file ends before the number of points of stroke 1", "byte 4"));
  EXPECT_EQ(error(file_of({2, 1, 5, 5})),
            parse("the file ends before the number of points of stroke 2", "byte 16"));
  EXPECT_EQ(error(file_of({1, 2, 5, 5, 6})),
            parse("the file ends within stroke 1, which should have 2 points", "byte 20"));
  EXPECT_EQ(error(file_of({-1})), parse("the number of strokes is -1", "byte 0", "0 to 1024 are allowed"));
  EXPECT_EQ(error(file_of({1025})),
            parse("the number of strokes is 1025", "byte 0", "0 to 1024 are allowed"));
  EXPECT_EQ(error(file_of({1024})).what, "the file ends before the number of points of stroke 1");
  EXPECT_EQ(error(file_of({1, 0})),
            parse("the number of points of stroke 1 is 0", "byte 4", "1 to 65536 are allowed"));
  EXPECT_EQ(error(file_of({1, 65537})).what, "the number of points of stroke 1 is 65537");
  EXPECT_EQ(error(file_of({1, 65536})).what, "the file ends within stroke 1, which should have 65536 points");
  EXPECT_EQ(error(file_of({1, 2, 5, 5, 7, 128})),
            parse("a point of stroke 1 is at (7, 128)", "byte 16", "columns and rows go from 0 to 127"));
  EXPECT_EQ(error(file_of({1, 1, 5, 5, 9})), parse("4 bytes are left over after the last stroke", "byte 16"));
  EXPECT_EQ(StrokeOrder::parse(file_of({0}), 1).error(),
            (base::Error{base::Errc::bad_argument, "a grid cannot have 1 samples a side", "grid_size",
                         "give 2 to 8192"}));
}

TEST(StrokeOrder, PointsOutsideTheGridAreErrors) {
  for (const auto& [x, y] : {std::pair{128, 0}, std::pair{0, 128}, std::pair{-1, 5}, std::pair{5, -1},
                             std::pair{std::numeric_limits<std::int32_t>::min(), 0}}) {
    const auto order = StrokeOrder::parse(file_of({1, 2, 3, 3, x, y}), 128);
    ASSERT_FALSE(order) << x << ' ' << y;
    EXPECT_NE(order.error().remedy.find("127"), std::string::npos);
    EXPECT_EQ(order.error().where, "byte 16");
  }
  EXPECT_TRUE(StrokeOrder::parse(file_of({1, 1, 127, 127}), 128));
  EXPECT_TRUE(StrokeOrder::parse(file_of({1, 1, 0, 0}), 128));
  EXPECT_TRUE(StrokeOrder::parse(file_of({1, 1, 8191, 8191}), 8192)) << "the largest grid";
  EXPECT_TRUE(StrokeOrder::parse(file_of({1, 1, 1, 1}), 2)) << "the smallest";
  EXPECT_FALSE(StrokeOrder::parse(file_of({1, 1, 127, 127}), 127));
}

TEST(StrokeOrder, RefusesGridsThatNoHeightMapHas) {
  for (const int size : {0, 1, -128, 8193}) {
    const auto order = StrokeOrder::parse(file_of({0}), size);
    ASSERT_FALSE(order) << size;
    EXPECT_EQ(order.error().code, base::Errc::bad_argument);
  }
}

TEST(StrokeOrder, LoadsWhatItSavedAndNamesTheFileThatFails) {
  std::string folder = (std::filesystem::temp_directory_path() / "nazori-str-XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const std::filesystem::path path = std::filesystem::path(folder) / "休.str";
  const auto order = StrokeOrder::parse(kyuu_of_2005(), 128).value();
  ASSERT_TRUE(order.save(path));
  EXPECT_EQ(base::read_file(path, 1000).value(), kyuu_of_2005());
  EXPECT_EQ(StrokeOrder::load(path, 128).value(), order);
  const auto too_small = StrokeOrder::load(path, 100);
  ASSERT_FALSE(too_small);
  EXPECT_EQ(too_small.error().where, path.string() + ": byte 56") << "the first point beyond 99";
  EXPECT_EQ(StrokeOrder::load(path, 1).error().where, "grid_size") << "which is no fault of the file";
  // A file of 64 MiB is read, a longer one is not.
  std::filesystem::resize_file(path, (64U << 20U) + 1);
  EXPECT_EQ(StrokeOrder::load(path, 128).error().code, base::Errc::io);
  EXPECT_EQ(StrokeOrder::load(folder, 128).error().code, base::Errc::io);
  EXPECT_EQ(StrokeOrder::load(path.string() + "x", 128).error().code, base::Errc::not_found);
  std::filesystem::remove_all(folder);
}

/// Largest distance, in samples, from points along `line` to the stroke of the file.
double farthest(const StrokeLine& line, const StrokeOrder::Points& points, int size) {
  std::vector<geometry::GridPoint> kept;
  for (const StrokeOrderPoint p : points)
    kept.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  double worst = 0;
  for (const GlyphPoint p : geometry::resample(std::span<const GlyphPoint>(line.points), 500)) {
    worst = std::max(worst, geometry::nearest_point(std::span<const geometry::GridPoint>(kept),
                                                    geometry::glyph_to_grid(p, size))
                                .distance);
  }
  return worst;
}

TEST(StrokeOrder, FromLinesKeepsBendsWithinOneSampleWithFewPoints) {
  StrokeLine arc;
  for (int i = 0; i <= 200; ++i)
    arc.points.push_back({54.5 + 40 * std::cos(i * 0.02), 54.5 + 40 * std::sin(i * 0.02)});
  StrokeLine corner{{{10, 10}, {90, 10}, {90, 95}, {84, 89}}, StrokeEnding::hook, {}};
  for (const int size : {64, 128, 1024}) {
    const std::vector<StrokeLine> lines{arc, corner};
    const StrokeOrder order = StrokeOrder::from_lines(centre_lines(lines), size);
    ASSERT_EQ(order.count(), 2U);
    EXPECT_LE(farthest(arc, order.stroke(1), size), 1.0) << size;
    EXPECT_LE(farthest(corner, order.stroke(2), size), 1.0) << size;
    EXPECT_EQ(order.stroke(2).size(), 4U) << "corners and kick, nothing between";
    EXPECT_LT(order.stroke(1).size(), 80U);
    EXPECT_TRUE(StrokeOrder::parse(order.to_bytes(), size));
  }
  EXPECT_LT(StrokeOrder::from_lines(centre_lines(std::vector{arc}), 128).stroke(1).size(), 40U);
}

TEST(StrokeOrder, LinesComeBackFromAFileAsTheyWere) {
  const auto order = StrokeOrder::parse(kyuu_of_2005(), 128).value();
  EXPECT_EQ(StrokeOrder::from_lines(centre_lines(order.to_lines(128)), 128), order);
}

TEST(StrokeOrder, PointsBeyondTheBoxAreHeldAtItsEdge) {
  const StrokeLine line{{{-20, 50}, {130, 50}}, StrokeEnding::stop, {}};
  EXPECT_EQ(StrokeOrder::from_lines(centre_lines(std::vector{line}), 110).stroke(1),
            (StrokeOrder::Points{{0, 50}, {109, 50}}));
}

TEST(StrokeOrder, ALineThatIsOnePointStaysAStroke) {
  const StrokeLine dot{{{54.5, 54.5}, {54.6, 54.5}}, StrokeEnding::stop, {}};
  const auto order = StrokeOrder::from_lines(centre_lines(std::vector{dot}), 110);
  ASSERT_EQ(order.count(), 1U);
  EXPECT_EQ(order.stroke(1).size(), 1U);
}

StrokeLine on_grid(const std::vector<geometry::GridPoint>& points, int size) {
  StrokeLine line;
  for (const geometry::GridPoint p : points) line.points.push_back(geometry::grid_to_glyph(p, size));
  return line;
}

TEST(StrokeOrder, ABendOfMoreThanAQuarterOfASampleIsKept) {
  constexpr int kSize = 128;
  const auto points = [](std::vector<geometry::GridPoint> line) {
    return StrokeOrder::from_lines(centre_lines(std::vector{on_grid(line, kSize)}), kSize).stroke(1);
  };
  // Both bends are rounded to the next row.
  EXPECT_EQ(points({{0, 10.4}, {50, 10.64}, {100, 10.4}}), (StrokeOrder::Points{{0, 10}, {100, 10}}));
  EXPECT_EQ(points({{0, 10.4}, {50, 10.66}, {100, 10.4}}),
            (StrokeOrder::Points{{0, 10}, {50, 11}, {100, 10}}));
  EXPECT_EQ(points({{10.4, 0}, {10.1, 50}, {10.4, 100}}),
            (StrokeOrder::Points{{10, 0}, {10, 50}, {10, 100}}));
  // A line that goes beyond the end of the chord and comes back is a bend, too.
  EXPECT_EQ(points({{10, 10}, {60, 10}, {40, 10}}), (StrokeOrder::Points{{10, 10}, {60, 10}, {40, 10}}));
  EXPECT_EQ(points({{30, 10}, {10, 10}, {60, 10}}), (StrokeOrder::Points{{30, 10}, {10, 10}, {60, 10}}));
  // A line that ends where it began.
  EXPECT_EQ(points({{10, 10}, {60, 10}, {10, 10}}), (StrokeOrder::Points{{10, 10}, {60, 10}, {10, 10}}));
  EXPECT_EQ(points({{10, 10}, {20, 60}, {80, 60}, {90, 10}}),
            (StrokeOrder::Points{{10, 10}, {20, 60}, {80, 60}, {90, 10}}));
}

TEST(StrokeOrder, LinesWithoutPointsAreNoStrokesAndNumbersThatAreNoneStandAtTheEdge) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::vector<StrokeLine> lines{StrokeLine{}, {{{kNone, 109}, {109, kNone}}, StrokeEnding::stop, {}}};
  const StrokeOrder order = StrokeOrder::from_lines(centre_lines(lines), 110);
  ASSERT_EQ(order.count(), 1U);
  EXPECT_EQ(order.stroke(1), (StrokeOrder::Points{{0, 109}, {109, 0}}));
}

TEST(StrokeOrder, AHookIsAtMostTwoFifthsOfTheRestAndTurnsByMoreThanSixtyDegrees) {
  const auto ending = [](StrokeOrder::Points points) {
    return StrokeOrder({std::move(points)}).to_lines(200)[0].ending;
  };
  using enum StrokeEnding;
  EXPECT_EQ(ending({{20, 50}, {120, 50}, {81, 50}}), hook) << "39 of 100";
  EXPECT_EQ(ending({{20, 50}, {120, 50}, {79, 50}}), either) << "41 of 100";
  EXPECT_EQ(ending({{20, 50}, {70, 50}, {120, 50}, {81, 50}}), hook) << "39 of 50 and 50";
  EXPECT_EQ(ending({{20, 50}, {70, 50}, {120, 50}, {79, 50}}), either);
  EXPECT_EQ(ending({{20, 50}, {120, 50}, {130, 67}}), either) << "59.5 degrees";
  EXPECT_EQ(ending({{20, 50}, {120, 50}, {130, 68}}), hook) << "60.9 degrees";
  EXPECT_EQ(ending({{20, 50}, {20, 150}, {37, 160}}), either) << "59.5 degrees to the other side";
  EXPECT_EQ(ending({{20, 50}, {20, 150}, {38, 160}}), hook);
  EXPECT_EQ(ending({{20, 50}, {120, 50}, {120, 50}}), either) << "the last point comes twice";
  EXPECT_EQ(ending({{20, 50}}), either);
}

TEST(StrokeOrder, AShortSharpLastSegmentIsReadAsAHook) {
  const StrokeOrder order({{{20, 20}, {100, 20}, {100, 100}, {90, 92}},  // hook
                           {{20, 20}, {100, 20}, {100, 100}},            // corner, no hook
                           {{20, 20}, {60, 60}, {66, 70}},               // gentle bend
                           {{20, 20}, {100, 20}}});
  const auto lines = order.to_lines(128);
  EXPECT_EQ(lines[0].ending, StrokeEnding::hook);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_EQ(lines[k].ending, StrokeEnding::either) << k;
}

}  // namespace
}  // namespace nazori::kanji
