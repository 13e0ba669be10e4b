// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "line_comparison.h"
#include "moved_model.h"
#include "nazori/author/trace.h"
#include "nazori/carving/carve.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::author::test {
namespace {

constexpr double kWithin = 109.0 / 128;

struct Counts {
  int strokes = 0;
  int mean = 0;        ///< strokes whose mean distance is within 1/128 of the side
  int most_of_95 = 0;  ///< and those of which 95 % is
  int ending = 0;      ///< whose width says the ending
  int tip = 0;         ///< whose last point is within 1/128 of the side
};

/// Every 230th character of kanji.db, carved at 512 x 512.
template <class Each>
void each_character(Each each) {
  auto path = kanji::KanjiDatabase::locate();
  ASSERT_TRUE(path) << base::to_line(path.error());
  auto database = kanji::KanjiDatabase::open(*path);
  ASSERT_TRUE(database) << base::to_line(database.error());
  int number = 0;
  for (const kanji::Summary& summary : database->list(kanji::List::all)) {
    if (number++ % 230 != 0) continue;
    const auto character = database->find(summary.code_point);
    ASSERT_TRUE(character);
    std::vector<kanji::StrokeLine> strokes;
    for (const kanji::Stroke& s : character->strokes) strokes.push_back(s.line);
    const auto map = carving::carve(strokes, 512);
    ASSERT_TRUE(map);
    each(strokes, *map, static_cast<unsigned>(summary.code_point));
  }
}

void add(Counts& counts, const kanji::StrokeLine& truth, const GlyphLine& found, kanji::StrokeEnding ending) {
  const LineDistance d = distance_of(truth.points, found);
  counts.mean += d.mean <= kWithin ? 1 : 0;
  counts.most_of_95 += d.most_of_95 <= kWithin ? 1 : 0;
  counts.tip += geometry::distance(truth.points.back(), found.back()) <= kWithin ? 1 : 0;
  const bool is_free = truth.ending == kanji::StrokeEnding::either;
  counts.ending += ending == (is_free ? kanji::StrokeEnding::stop : truth.ending) ? 1 : 0;
}

double share(int count, const Counts& counts) { return static_cast<double>(count) / counts.strokes; }

// The figures of all characters are in docs; these are limits just below those of the sample.
TEST(CarvedKanjiTraced, AsThemselvesLieOnTheirLinesWithTheirEndings) {
  Counts counts;
  each_character([&](const auto& strokes, const auto& map, unsigned) {
    const auto found = trace_as(map, strokes);
    ASSERT_TRUE(found) << base::to_line(found.error());
    ASSERT_EQ(found->size(), strokes.size());
    for (std::size_t k = 0; k < strokes.size(); ++k) {
      ++counts.strokes;
      add(counts, strokes[k], line_of((*found)[k].stroke), (*found)[k].ending_of_ink);
      EXPECT_EQ((*found)[k].stroke.ending, strokes[k].ending);
    }
  });
  EXPECT_GT(share(counts.mean, counts), 0.99);
  EXPECT_GT(share(counts.tip, counts), 0.85);
  EXPECT_GT(share(counts.most_of_95, counts), 0.96);
  EXPECT_GT(share(counts.ending, counts), 0.95);
}

TEST(CarvedKanjiTraced, ByAnotherHandLieOnTheirOwnLines) {
  Counts counts;
  each_character([&](const auto& strokes, const auto& map, unsigned code_point) {
    const auto found = trace_as(map, moved(strokes, code_point));
    ASSERT_TRUE(found);
    for (std::size_t k = 0; k < strokes.size(); ++k) {
      ++counts.strokes;
      add(counts, strokes[k], line_of((*found)[k].stroke), (*found)[k].ending_of_ink);
    }
  });
  EXPECT_GT(share(counts.mean, counts), 0.985);
  EXPECT_GT(share(counts.most_of_95, counts), 0.955);
  EXPECT_GT(share(counts.ending, counts), 0.95);
}

TEST(CarvedKanjiTraced, AsNothingKnownAreMostlyTheirStrokes) {
  Counts counts;
  each_character([&](const auto& strokes, const auto& map, unsigned) {
    const auto found = trace(map);
    ASSERT_TRUE(found);
    std::vector<GlyphLine> truth;
    std::vector<GlyphLine> lines;
    for (const auto& s : strokes) truth.push_back(s.points);
    for (const auto& s : *found) lines.push_back(line_of(s));
    const auto match = matched(truth, lines);
    for (std::size_t k = 0; k < truth.size(); ++k) {
      ++counts.strokes;
      if (match[k] < 0) continue;
      const auto m = static_cast<std::size_t>(match[k]);
      add(counts, strokes[k], lines[m], (*found)[m].ending);
    }
  });
  EXPECT_GT(share(counts.mean, counts), 0.92);
  EXPECT_GT(share(counts.most_of_95, counts), 0.82);
  EXPECT_GT(share(counts.ending, counts), 0.92);
}

TEST(CarvedKanjiTraced, SweepsReachToTheirTips) {
  int sweeps = 0;
  int reached = 0;
  each_character([&](const auto& strokes, const auto& map, unsigned) {
    const auto found = trace_as(map, strokes);
    ASSERT_TRUE(found);
    for (std::size_t k = 0; k < strokes.size(); ++k) {
      if (strokes[k].ending != kanji::StrokeEnding::taper) continue;
      ++sweeps;
      const GlyphPoint tip = (*found)[k].stroke.points.back().at;
      reached += geometry::distance(tip, strokes[k].points.back()) <= kWithin ? 1 : 0;
    }
  });
  ASSERT_GT(sweeps, 20);
  EXPECT_GT(static_cast<double>(reached) / sweeps, 0.72);
}

}  // namespace
}  // namespace nazori::author::test
