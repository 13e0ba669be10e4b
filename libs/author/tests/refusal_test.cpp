// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "nazori/author/trace.h"

namespace nazori::author {
namespace {

scan::Photo plain(int width, int height, int grey) {
  return {width, height,
          std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                                    static_cast<std::uint8_t>(grey))};
}

void expect_sane(const base::Result<std::vector<OwnStroke>>& found) {
  if (!found) {
    EXPECT_EQ(found.error().code, base::Errc::bad_argument);
    EXPECT_FALSE(found.error().what.empty());
    EXPECT_EQ(found.error().what.find('\n'), std::string::npos);
    return;
  }
  EXPECT_FALSE(found->empty());
  EXPECT_LE(found->size(), static_cast<std::size_t>(kMostTracedStrokes));
  for (const OwnStroke& stroke : *found) {
    ASSERT_FALSE(stroke.points.empty());
    for (const GroovePoint& p : stroke.points) {
      // A sweep may be lengthened over the edge.
      ASSERT_TRUE(p.at.x > -10 && p.at.x < 119 && p.at.y > -10 && p.at.y < 119) << p.at.x << ", " << p.at.y;
      ASSERT_TRUE(p.half_width > 0 && p.half_width < 109) << p.half_width;
      ASSERT_TRUE(p.depth > 0 && p.depth <= 1) << p.depth;
    }
  }
}

const kanji::StrokeLine kBar{{{20, 50}, {90, 50}}, kanji::StrokeEnding::stop, {}};

TEST(TraceRefuses, APictureWithoutInkAndOneOfNothingButInk) {
  for (const int grey : {255, 180, 90}) {
    const auto found = trace(plain(200, 300, grey));
    ASSERT_FALSE(found) << grey;
    EXPECT_EQ(found.error().what, "there is no ink in the picture");
  }
  const auto black = trace(plain(200, 300, 3));
  ASSERT_FALSE(black);
  EXPECT_EQ(black.error().what, "there is nothing but ink in the picture");
  const auto fit = trace_as(plain(200, 300, 255), {{kBar}});
  ASSERT_FALSE(fit);
  EXPECT_EQ(fit.error().what, "there is no ink in the picture");
}

TEST(TraceRefuses, AHeightMapWithoutGrooveAndOneThatIsAllGroove) {
  const auto none = trace(surface::HeightMap{});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().what, "no height map is loaded");
  const auto flat = trace(*surface::HeightMap::create(100, 1.0F));
  ASSERT_FALSE(flat);
  EXPECT_EQ(flat.error().what, "the height map has no groove");
  const auto deep = trace(*surface::HeightMap::create(100, 0.0F));
  ASSERT_FALSE(deep);
  EXPECT_EQ(deep.error().what, "nearly the whole height map is groove");
}

TEST(TraceRefuses, MoreLinesThanACharacterHas) {
  // 15 x 15 dots.
  auto map = *surface::HeightMap::create(512, 1.0F);
  for (int y = 0; y < 512; ++y)
    for (int x = 0; x < 512; ++x)
      if (std::hypot(x % 34 - 17, y % 34 - 17) < 6) map.set(x, y, 0);
  const auto found = trace(map);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().what, "there are 225 separate lines, too many for one character");
}

TEST(TraceRefuses, ACharacterThatIsNone) {
  const auto map = *surface::HeightMap::create(100, 1.0F);
  const auto error = [&](const std::vector<kanji::StrokeLine>& character) {
    const auto found = trace_as(map, character);
    return found ? std::string() : base::to_line(found.error());
  };
  EXPECT_EQ(error({}), "character: has no strokes (give strokes of the database)");
  EXPECT_EQ(error({{}}), "character: has a stroke without points (give strokes of the database)");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error({{{{nan, 1}}, kanji::StrokeEnding::stop, {}}}),
            "character: has a point far outside of the glyph box (give strokes of the database)");
  EXPECT_EQ(error(std::vector<kanji::StrokeLine>(kMostTracedStrokes + 1, kBar)),
            "character: has too many strokes (give strokes of the database)");
}

TEST(TraceNeverBreaks, OnNoiseOfAnyDensity) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    scan::Photo photo = plain(240, 200, 255);
    for (auto& value : photo.grey) value = random() % 16 < seed * 2 ? 0 : 255;
    expect_sane(trace(photo));
    auto map = *surface::HeightMap::create(150, 1.0F);
    for (float& value : map.samples()) value = static_cast<float>(random() % 256) / 255;
    expect_sane(trace(map));
  }
}

TEST(TraceNeverBreaks, OnSinglePixelsAndChequers) {
  for (const int at : {0, 1, 63 * 64 + 63, 32 * 64 + 32}) {
    scan::Photo photo = plain(64, 64, 255);
    photo.grey[static_cast<std::size_t>(at)] = 0;
    expect_sane(trace(photo));
  }
  for (const int size : {1, 2, 7, 40}) {
    scan::Photo photo = plain(320, 320, 255);
    for (int y = 0; y < 320; ++y)
      for (int x = 0; x < 320; ++x)
        if ((x / size + y / size) % 2 == 0) photo.grey[static_cast<std::size_t>(y * 320 + x)] = 0;
    expect_sane(trace(photo));
  }
  for (const int size : {2, 3, 8192 / 8}) {
    auto map = *surface::HeightMap::create(size, 1.0F);
    map.set(0, 0, 0);
    expect_sane(trace(map));
  }
}

TEST(TraceNeverBreaks, OnInkThatTouchesTheEdgesOrFillsHalf) {
  scan::Photo half = plain(200, 200, 250);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 100; ++x) half.grey[static_cast<std::size_t>(y * 200 + x)] = 10;
  expect_sane(trace(half));
  scan::Photo frame = plain(200, 200, 250);
  for (int k = 0; k < 200; ++k)
    for (const int i : {k, k * 200, 199 * 200 + k, k * 200 + 199})
      frame.grey[static_cast<std::size_t>(i)] = 10;
  expect_sane(trace(frame));
  expect_sane(trace(plain(5000, 64, 200)));
  scan::Photo line = plain(5000, 64, 240);
  for (int x = 10; x < 4990; ++x) line.grey[static_cast<std::size_t>(30 * 5000 + x)] = 0;
  expect_sane(trace(line));
}

TEST(TraceNeverBreaks, OnACharacterThatIsNotInThePicture) {
  auto map = *surface::HeightMap::create(200, 1.0F);
  for (int x = 20; x < 180; ++x)
    for (int y = 90; y < 100; ++y) map.set(x, y, 0);
  const std::vector<kanji::StrokeLine> far{{{{-500, -500}}, kanji::StrokeEnding::stop, {}},
                                           {{{5, 5}, {5, 5}}, kanji::StrokeEnding::hook, {}},
                                           {{{100, 5}, {5, 105}}, kanji::StrokeEnding::taper, {}}};
  const auto found = trace_as(map, far);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 3U);
  for (const FittedStroke& s : *found) {
    ASSERT_FALSE(s.stroke.points.empty());
    EXPECT_GE(s.covered, 0);
    EXPECT_LE(s.covered, 1);
    for (const GroovePoint& p : s.stroke.points) EXPECT_TRUE(std::isfinite(p.at.x) && std::isfinite(p.at.y));
  }
}

}  // namespace
}  // namespace nazori::author
