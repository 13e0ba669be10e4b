// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

#include "../src/palette.h"
#include "view_fixtures.h"

namespace nazori::view {
namespace {

using fixtures::difference;
using fixtures::luminance;
using fixtures::pixel;
using fixtures::Rgb;
using fixtures::seen;
using fixtures::straight;
using fixtures::Studio;

Rgb rgb_of(Colour c) {
  return {static_cast<int>(std::lround(c.x * 255)), static_cast<int>(std::lround(c.y * 255)),
          static_cast<int>(std::lround(c.z * 255))};
}

Rgb mixed(Rgb a, Rgb b, double share) {
  const auto channel = [&](int x, int y) { return static_cast<int>(std::lround(x + (y - x) * share)); };
  return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

/// A level stroke on a plateau, without heads and numbers unless requested.
class Lines : public testing::Test {
 protected:
  // One for all tests, because making the face takes time.
  static void SetUpTestSuite() {
    shared_ = std::make_unique<Studio>(600, 600);
    shared_->view->set_height_map(surface::HeightMap::create(64).value());
  }
  static void TearDownTestSuite() { shared_.reset(); }
  Lines() {
    studio_.view->set_style(Style::wood);
    studio_.view->set_theme(Theme::light);
    studio_.view->set_camera({});
    studio_.view->set_strokes(
        kanji::centre_lines(std::vector{straight({20, 54.5}, {90, 54.5}), straight({20, 90}, {90, 90})}));
    overlay_.strokes_visible = true;
    overlay_.arrows_visible = false;
    overlay_.numbers_visible = false;
  }
  Picture bare() {
    Overlay none;
    return studio_.shoot(none);
  }
  /// By how much the strip across the middle of the first stroke differs in all, in pixels of a colour as far
  /// from the tablet's as `from_bare`.
  double across(const Picture& without, const Picture& with, double from_bare) {
    const glm::dvec2 middle = seen(studio_, {60, 54.5});
    double sum = 0;
    for (int y = -25; y <= 25; ++y) {
      const glm::dvec2 at = middle + glm::dvec2(0, y);
      sum += luminance(pixel(with, at)) - luminance(pixel(without, at));
    }
    return sum / from_bare;
  }
  static inline std::unique_ptr<Studio> shared_;
  Studio& studio_ = *shared_;
  Overlay overlay_;
};

TEST_F(Lines, OfTheLookOf2005AreTwoPixelsWideAndRed) {
  studio_.view->set_style(Style::classic);
  const Picture without = bare();
  for (const double scale : {1.0, 2.0, 3.0}) {
    const Picture with = studio_.shoot(overlay_, scale);
    EXPECT_NEAR(across(without, with, luminance({255, 0, 0}) - 255), 2 * scale, 0.05 * scale) << scale;
    EXPECT_EQ(difference(pixel(with, seen(studio_, {60, 54.5}, 0.00008)), {255, 0, 0}), 0);
  }
}

TEST_F(Lines, AreThreePixelsWideWithAnOutlineOfOneAndGrowWithTheRootOfTheText) {
  struct Case {
    double scale, text_scale;
  };
  const Palette& colours = palette(Style::wood, Theme::light);
  for (const Case c : {Case{1, 1}, {2, 1}, {1, 4}, {2, 2}}) {
    const Picture without = bare();
    overlay_.text_scale = c.text_scale;
    const Picture with = studio_.shoot(overlay_, c.scale);
    const double ground = luminance(pixel(without, seen(studio_, {60, 54.5})));
    const double line = 3 * c.scale * std::sqrt(c.text_scale);
    const double edge = 2 * c.scale;
    const double expected = line * (luminance(rgb_of(colours.stroke)) - ground) +
                            edge * (luminance(rgb_of(colours.stroke_edge)) - ground);
    EXPECT_NEAR(across(without, with, 1), expected, 0.05 * std::abs(expected))
        << c.scale << ' ' << c.text_scale;
    EXPECT_LT(difference(pixel(with, seen(studio_, {60, 54.5})), rgb_of(colours.stroke)), 6);
  }
}

TEST_F(Lines, OfTheCurrentStrokeHaveTheirOwnColour) {
  for (const Style style : {Style::wood, Style::slate}) {
    for (const Theme theme : {Theme::dark}) {
      studio_.view->set_style(style);
      studio_.view->set_theme(theme);
      overlay_.current_stroke = 1;
      const Picture with = studio_.shoot(overlay_);
      EXPECT_LT(
          difference(pixel(with, seen(studio_, {60, 54.5})), rgb_of(palette(style, theme).current_stroke)),
          6);
      overlay_.current_stroke = 0;
      EXPECT_LT(difference(pixel(studio_.shoot(overlay_), seen(studio_, {60, 54.5})),
                           rgb_of(palette(style, theme).stroke)),
                6);
    }
  }
}

TEST_F(Lines, SeeThroughLinesAreMixedOnceWithWhatLiesUnderThem) {
  const Palette& colours = palette(Style::wood, Theme::light);
  // Their pieces overlap by half their width.
  kanji::StrokeLine pieces;
  for (int i = 0; i <= 7; ++i) pieces.points.push_back({20 + i * 10.0, 54.5});
  studio_.view->set_strokes(kanji::centre_lines(std::vector{pieces}));
  const Picture without = bare();
  for (const double opacity : {0.5, 0.25}) {
    overlay_.lines_opacity = opacity;
    const Picture with = studio_.shoot(overlay_);
    for (const double x : {45.0, 54.0, 66.0, 75.0}) {
      const glm::dvec2 at = seen(studio_, {x, 54.5});
      const Rgb outline = mixed(pixel(without, at), rgb_of(colours.stroke_edge), opacity);
      EXPECT_LT(difference(pixel(with, at), mixed(outline, rgb_of(colours.stroke), opacity)), 9) << opacity;
    }
  }
  overlay_.lines_opacity = 0;
  EXPECT_EQ(fixtures::changed_pixels(without, studio_.shoot(overlay_), 0), 0);
  overlay_.numbers_visible = true;
  (void)studio_.shoot(overlay_);
  EXPECT_EQ(studio_.view->numbers().size(), 1U) << "the numbers alone stay";
  overlay_.lines_opacity = 7;
  EXPECT_LT(difference(pixel(studio_.shoot(overlay_), seen(studio_, {60, 54.5})), rgb_of(colours.stroke)), 6);
}

TEST_F(Lines, AnArrowheadIsADartThirteenPixelsLong) {
  for (const double scale : {1.0, 2.0}) {
    overlay_.arrows_visible = false;
    const Picture without = studio_.shoot(overlay_, scale);
    overlay_.arrows_visible = true;
    const Picture with = studio_.shoot(overlay_, scale);
    const glm::dvec2 tip = seen(studio_, {90, 54.5});
    double behind = 0, ahead = 0, aside = 0;
    for (int y = -40; y <= 40; ++y) {
      for (int x = -60; x <= 20; ++x) {
        const glm::dvec2 at = glm::floor(tip) + glm::dvec2(x + 0.5, y + 0.5);
        if (difference(pixel(without, at), pixel(with, at)) < 60) continue;
        behind = std::max(behind, tip.x - at.x);
        ahead = std::max(ahead, at.x - tip.x);
        aside = std::max(aside, std::abs(at.y - tip.y));
      }
    }
    // Its sides lean by 24 degrees, and tan 24 = 0.445. The outline is nearly as pale as the wood.
    const double outline = scale > 1 ? 3 * scale : 1;
    EXPECT_GT(behind, 12 * scale);
    EXPECT_LT(behind, 13 * scale + outline);
    EXPECT_GT(aside, 13 * 0.445 * scale - scale);
    EXPECT_LT(aside, 13 * 0.445 * scale + outline);
    EXPECT_LT(ahead, 1.5 * scale);
  }
}

TEST_F(Lines, ANumberIsADiscOfTenPixelsWithARingAndADotOnItsStart) {
  overlay_.numbers_visible = true;
  overlay_.lines_opacity = 0;
  const Picture without = bare();
  for (const int current : {0, 2}) {
    overlay_.current_stroke = current;
    for (const double scale : {1.0, 2.0}) {
      const Picture with = studio_.shoot(overlay_, scale);
      const Palette& colours = palette(Style::wood, Theme::light);
      ASSERT_EQ(studio_.view->numbers().size(), current == 0 ? 2U : 1U);
      const NumberPlace place = studio_.view->numbers().back();
      EXPECT_EQ(place.radius, 10 * scale);
      const Rgb ground = rgb_of(current == 0 ? colours.disc : colours.current_disc);
      const Rgb edge = rgb_of(current == 0 ? colours.disc_edge : colours.stroke_edge);
      const Rgb figure = rgb_of(current == 0 ? colours.number : colours.current_number);
      int figure_pixels = 0;
      for (int y = -26; y < 26; ++y) {
        for (int x = -26; x < 26; ++x) {
          const double r = std::hypot(x + 0.5, y + 0.5);
          const Rgb there = pixel(with, place.pixel + glm::dvec2(x + 0.5, y + 0.5));
          if (r < 6 * scale) figure_pixels += difference(there, figure) < 60 ? 1 : 0;
          if (r > 7.6 * scale && r < 9 * scale - 0.6) {
            EXPECT_LT(difference(there, ground), 8) << x << ", " << y;
          }
          if (scale > 1 && r > 9 * scale + 0.6 && r < 10 * scale - 0.6) {
            EXPECT_LT(difference(there, edge), 8) << x << ", " << y;
          }
        }
      }
      EXPECT_GT(figure_pixels, 8 * scale * scale);
      // The dot: a disc of 3.4 pixels in the colour of the lines, with a ring.
      const glm::dvec2 start = seen(studio_, {20, 90}, 0.00008);
      const Rgb dot = rgb_of(current == 0 ? colours.stroke : colours.current_stroke);
      EXPECT_LT(difference(pixel(with, start), dot), 8);
      const glm::dvec2 away = glm::normalize(start - place.pixel);
      const glm::dvec2 aside = start + away * (5.2 * scale);
      EXPECT_LT(difference(pixel(with, aside), pixel(without, aside)), 8) << "it is no larger";
    }
  }
}

TEST_F(Lines, ANumberThatHadToMoveAwayIsLedToByDots) {
  // So many start at one point that most numbers are far from it.
  std::vector<kanji::StrokeLine> lines(12, straight({54, 54}, {54.2, 54}));
  studio_.view->set_strokes(kanji::centre_lines(lines));
  overlay_.numbers_visible = true;
  overlay_.lines_opacity = 0;
  const Picture without = bare();
  const Picture with = studio_.shoot(overlay_);
  const glm::dvec2 start = seen(studio_, {54, 54}, 0.00008);
  int far = 0;
  for (const NumberPlace& place : studio_.view->numbers()) {
    const glm::dvec2 way = place.pixel - start;
    const double length = glm::length(way);
    if (length < 40) continue;
    ++far;
    // The first dot lies one and a half spacings of 4.5 pixels from the start, the next a spacing further on.
    for (const double s : {6.75, 11.25, 15.75}) {
      const glm::dvec2 at = start + way / length * s;
      bool covered = false;
      for (const NumberPlace& other : studio_.view->numbers())
        covered = covered || glm::distance(other.pixel, at) < other.radius + 2;
      if (covered) continue;
      EXPECT_GT(difference(pixel(without, at), pixel(with, at)), 60) << place.stroke << ' ' << s;
    }
  }
  EXPECT_GT(far, 0);
}

TEST_F(Lines, TheTextScaleIsHeldBetweenAHalfAndFour) {
  overlay_.numbers_visible = true;
  for (const auto& [given, radius] :
       {std::pair{0.01, 5.0}, {0.5, 5.0}, {0.6, 6.0}, {4.0, 40.0}, {99.0, 40.0}}) {
    overlay_.text_scale = given;
    (void)studio_.shoot(overlay_);
    EXPECT_EQ(studio_.view->numbers()[0].radius, radius) << given;
  }
}

TEST_F(Lines, OfStartsOutsideThePictureThereIsNoNumber) {
  overlay_.numbers_visible = true;
  const auto corner = [](double x, double y) { return straight({x, y}, {54.5, 54.5}); };
  studio_.view->set_strokes(kanji::centre_lines(
      std::vector{corner(54, 5), corner(104, 54), corner(54, 104), corner(5, 54), corner(54.5, 50)}));
  studio_.view->set_camera({0, 0, 5, {}});
  (void)studio_.shoot(overlay_);
  ASSERT_EQ(studio_.view->numbers().size(), 1U);
  EXPECT_EQ(studio_.view->numbers()[0].stroke, 5);
  studio_.view->set_camera({});
  (void)studio_.shoot(overlay_);
  EXPECT_EQ(studio_.view->numbers().size(), 5U);
}

TEST_F(Lines, WithoutStrokesNothingIsDrawn) {
  studio_.view->set_strokes({});
  overlay_.numbers_visible = true;
  overlay_.arrows_visible = true;
  const Picture without = bare();
  EXPECT_EQ(fixtures::changed_pixels(without, studio_.shoot(overlay_), 0), 0);
  EXPECT_TRUE(studio_.view->numbers().empty());
}

}  // namespace
}  // namespace nazori::view
