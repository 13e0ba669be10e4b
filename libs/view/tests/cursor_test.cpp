// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

#include "view_fixtures.h"

namespace nazori::view {
namespace {

using fixtures::difference;
using fixtures::pixel;
using fixtures::Rgb;
using fixtures::Studio;

/// The pixels that the stylus changes, relative to its tip: pixels right and up.
std::vector<glm::dvec2> changed(const Studio& studio, const Picture& without, const Picture& with,
                                glm::dvec3 tip_m, int least) {
  const glm::dvec2 tip = studio.view->project(tip_m, without.width, without.height);
  std::vector<glm::dvec2> places;
  for (int y = 0; y < without.height; ++y)
    for (int x = 0; x < without.width; ++x)
      if (difference(pixel(without, x, y), pixel(with, x, y)) > least)
        places.push_back({x + 0.5 - tip.x, tip.y - y - 0.5});
  return places;
}

double reach(const std::vector<glm::dvec2>& places, glm::dvec2 way) {
  double far = -1e9;
  for (const glm::dvec2 p : places) far = std::max(far, glm::dot(p, glm::normalize(way)));
  return far;
}

class Stylus : public testing::Test {
 protected:
  static constexpr int kSide = 600;
  // One for all tests, because making the face takes time.
  static void SetUpTestSuite() { shared_ = std::make_unique<Studio>(kSide, kSide); }
  static void TearDownTestSuite() { shared_.reset(); }
  static inline std::unique_ptr<Studio> shared_;
  static Overlay with(const Cursor& cursor) {
    Overlay overlay;
    overlay.cursor = cursor;
    return overlay;
  }
  static void ready(Studio& studio, Style style) {
    studio.view->set_style(style);
    studio.view->set_theme(Theme::light);
    studio.view->set_hand(Hand::right);
    studio.view->set_strokes({});
    studio.view->set_height_map(surface::HeightMap::create(64).value());
  }
};

TEST_F(Stylus, TheBrushLeansToTheHandThatHoldsIt) {
  Studio& studio = *shared_;
  ready(studio, Style::slate);
  for (const Hand hand : {Hand::right, Hand::left}) {
    studio.view->set_hand(hand);
    const Picture without = studio.shoot();
    const auto places = changed(studio, without, studio.shoot(with({})), {}, 60);
    const double side = hand == Hand::right ? 1 : -1;
    glm::dvec2 middle(0);
    for (const glm::dvec2 p : places) middle += p / static_cast<double>(places.size());
    // To the hand by 0.56, up by 0.66, towards the eye by 0.42.
    EXPECT_NEAR(std::atan2(middle.y, middle.x * side), std::atan2(0.66, 0.56), 0.12);
    // It fades before its end.
    const glm::dvec2 way(0.56 * side, 0.66);
    const double length =
        500 * 0.32 * std::hypot(0.56, 0.66) / std::sqrt(0.56 * 0.56 + 0.66 * 0.66 + 0.42 * 0.42);
    EXPECT_GT(reach(places, way), 0.6 * length);
    EXPECT_LT(reach(places, way), 1.03 * length);
    EXPECT_LT(reach(places, -way), 12);
  }
}

TEST_F(Stylus, ItsLengthIsAHundredAndNinetyPixelsWhereThereIsRoom) {
  const auto length = [](Studio& studio, double scale, glm::dvec3 axis) {
    ready(studio, Style::wood);
    const Picture without = studio.shoot({}, scale);
    Cursor cursor;
    cursor.axis = axis;
    return reach(changed(studio, without, studio.shoot(with(cursor), scale), {}, 60), {axis.x, axis.y});
  };
  const double large = length(*shared_, 1, {1, 0, 0.2});
  EXPECT_GT(large, 190 * 0.6);
  EXPECT_LT(large, 190 * 1.02);
  EXPECT_NEAR(length(*shared_, 1, {0, 1, 0.2}), large, 5) << "whichever way it points";
  EXPECT_NEAR(length(*shared_, 0.5, {1, 0, 0.2}), large / 2, 5);
  EXPECT_NEAR(length(*shared_, 2, {1, 0, 0.2}), large * 600 * 0.32 / 190, 5)
      << "a third of the picture at most";
}

TEST_F(Stylus, OfTheBrushTheHairIsInkTheShaftBambooAndTheWidthAStylusHas) {
  Studio& studio = *shared_;
  ready(studio, Style::slate);
  const Picture without = studio.shoot();
  Cursor cursor;
  cursor.axis = {1, 0, 0.3};
  cursor.touching = true;
  const Picture picture = studio.shoot(with(cursor));
  const double length = 190 / std::hypot(1, 0.3);
  const glm::dvec2 tip = studio.view->project({0, 0, 0}, kSide, kSide);
  const auto at = [&](double along) { return pixel(picture, tip + glm::dvec2(along * length, -1)); };
  const auto width = [&](double along) {
    int count = 0;
    for (int y = -20; y <= 20; ++y) {
      const glm::dvec2 p = tip + glm::dvec2(along * length, y);
      count += difference(pixel(without, p), pixel(picture, p)) > 40 ? 1 : 0;
    }
    return count;
  };
  EXPECT_LT(fixtures::luminance(at(0.10)), 60) << "ink";
  const Rgb hair = at(0.235);
  EXPECT_GT(hair.red, hair.blue + 25) << "pale hair";
  EXPECT_LT(fixtures::luminance(at(0.30)), 110) << "the collar";
  const Rgb bamboo = at(0.45);
  EXPECT_GT(bamboo.red, bamboo.blue + 40);
  EXPECT_GT(fixtures::luminance(bamboo), fixtures::luminance(at(0.57)) + 10) << "a node is darker";
  // 0.05, 0.035 of the length to both sides.
  EXPECT_NEAR(width(0.15), 2 * 0.05 * 190, 5);
  EXPECT_NEAR(width(0.45), 2 * 0.035 * 190, 4);
}

TEST_F(Stylus, TheConeOf2005IsThirtyPixelsLongAndLeansALittle) {
  Studio& studio = *shared_;
  ready(studio, Style::classic);
  const Picture without = studio.shoot();
  for (const Hand hand : {Hand::right, Hand::left}) {
    studio.view->set_hand(hand);
    const auto places = changed(studio, without, studio.shoot(with({})), {}, 100);
    glm::dvec2 middle(0);
    for (const glm::dvec2 p : places) middle += p / static_cast<double>(places.size());
    EXPECT_GT(middle.x * (hand == Hand::right ? 1 : -1), 1.5);
    EXPECT_GT(middle.y, 1.5);
    EXPECT_LT(glm::length(middle), 15);
    EXPECT_GT(places.size(), 200U);
    EXPECT_LT(places.size(), 520U);
  }
  const Picture twice = studio.shoot(with({}), 2);
  const Picture once = studio.shoot(with({}), 1);
  EXPECT_NEAR(static_cast<double>(changed(studio, without, twice, {}, 100).size()) /
                  static_cast<double>(changed(studio, without, once, {}, 100).size()),
              4, 0.6);
}

TEST_F(Stylus, AnAxisThatIsGivenIsKept) {
  Studio& studio = *shared_;
  ready(studio, Style::wood);
  const Picture without = studio.shoot();
  for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0.3), glm::dvec3(0, -1, 0.5), glm::dvec3(-3, 3, 1)}) {
    Cursor cursor;
    cursor.axis = axis;
    cursor.touching = true;
    // The pale parts of the stylus, not its shadow.
    const auto places = changed(studio, without, studio.shoot(with(cursor)), {}, 130);
    const glm::dvec2 way = glm::normalize(glm::dvec2(axis));
    double aside = 0;
    for (const glm::dvec2 p : places)
      aside += std::abs(p.x * way.y - p.y * way.x) / static_cast<double>(places.size());
    EXPECT_GT(places.size(), 100U);
    EXPECT_GT(reach(places, way), 60);
    EXPECT_LT(aside, 8) << "it lies along its axis";
  }
}

TEST_F(Stylus, TheDevicesOwnPlaceIsARingOnAThread) {
  Studio& studio = *shared_;
  ready(studio, Style::slate);
  const Picture without = studio.shoot(with({}));
  Cursor cursor;
  cursor.device_m = {-0.03, -0.03, 0};
  for (const double scale : {1.0, 2.0}) {
    const Picture bare = studio.shoot(with({}), scale);
    const Picture picture = studio.shoot(with(cursor), scale);
    const glm::dvec2 device = studio.view->project(cursor.device_m, 600, 600);
    const glm::dvec2 proxy = studio.view->project({0, 0, 0}, 600, 600);
    const auto change = [&](glm::dvec2 at) { return difference(pixel(bare, at), pixel(picture, at)); };
    // On the side away from the proxy.
    const glm::dvec2 away = glm::normalize(device - proxy);
    EXPECT_GT(change(device + away * (4.3 * scale)), 60) << "a ring of five pixels";
    EXPECT_LT(change(device + away * (6.4 * scale)), 10);
    EXPECT_GT(change(device), 15) << "faintly filled";
    EXPECT_LT(change(device), change(device + away * (4.3 * scale)));
    EXPECT_GT(change((device + proxy) / 2.0), 20) << "a thread leads to it";
    EXPECT_LT(change((device + proxy) / 2.0 + glm::dvec2(away.y, -away.x) * (3 * scale)), 10);
  }
  // Where both are at the same point there is no ring.
  cursor.device_m = {0.0001, 0, 0};
  EXPECT_EQ(fixtures::changed_pixels(without, studio.shoot(with(cursor)), 0), 0);
}

TEST_F(Stylus, ItsShadowFallsAwayFromTheLight) {
  Studio& studio = *shared_;
  ready(studio, Style::wood);
  // The stylus stands upright in the picture; light comes from the upper left, or the upper right.
  for (const Hand hand : {Hand::right, Hand::left}) {
    studio.view->set_hand(hand);
    const Picture without = studio.shoot();
    const auto shade = [&](bool right, bool touching) {
      Cursor cursor;
      cursor.axis = {0, 0.7, 0.7};
      cursor.touching = touching;
      const Picture picture = studio.shoot(with(cursor));
      double sum = 0;
      for (int y = 2; y < 40; ++y)
        for (int x = 14; x < 60; ++x) {
          const glm::dvec2 at = glm::dvec2(kSide / 2, kSide / 2) + glm::dvec2(right ? x : -x, -y);
          sum += fixtures::luminance(pixel(without, at)) - fixtures::luminance(pixel(picture, at));
        }
      return sum;
    };
    const bool right = hand == Hand::right;
    EXPECT_GT(shade(right, true), 300);
    EXPECT_GT(shade(right, true), 4 * shade(!right, true));
    EXPECT_GT(shade(right, false), 100);
  }
}

TEST_F(Stylus, CarriesTheColourOfTheCurrentStroke) {
  Studio& studio = *shared_;
  ready(studio, Style::wood);
  studio.view->set_strokes(kanji::centre_lines(std::vector{fixtures::straight({10, 100}, {100, 100})}));
  Cursor cursor;
  cursor.axis = {1, 0, 0.3};
  cursor.touching = true;
  const auto ink = [&](int current) {
    Overlay overlay = with(cursor);
    overlay.strokes_visible = true;
    overlay.current_stroke = current;
    const Picture picture = studio.shoot(overlay);
    return pixel(picture, studio.view->project({0, 0, 0}, 600, 600) + glm::dvec2(20, -1));
  };
  EXPECT_GT(ink(1).red, ink(1).green + 60);
  EXPECT_LT(std::abs(ink(0).red - ink(0).green), 30);
}

}  // namespace
}  // namespace nazori::view
