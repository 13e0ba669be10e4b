// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../src/number_labels.h"
#include "../src/palette.h"
#include "view_fixtures.h"

namespace nazori::view {
namespace {

using fixtures::carved;
using fixtures::luminance;
using fixtures::pixel;
using fixtures::straight;
using fixtures::Studio;

constexpr int kSide = 400;

class Labels : public testing::Test {
 protected:
  Labels() {
    studio_.view->set_height_map(carved({straight({2, 2}, {4, 2})}));
    Camera camera;
    camera.tilt = 0;
    studio_.view->set_camera(camera);
  }

  Picture shoot(std::vector<geometry::Label> labels, double text_scale = 1) {
    studio_.view->set_labels(std::move(labels));
    Overlay overlay;
    overlay.text_scale = text_scale;
    return studio_.shoot(overlay);
  }
  [[nodiscard]] std::span<const LabelPlace> places() const { return studio_.view->labels(); }
  [[nodiscard]] glm::dvec2 seen(const geometry::Label& label) const {
    return studio_.view->project({label.at.x, label.at.y, 0}, kSide, kSide);
  }

  Studio studio_{kSide, kSide};
};

TEST_F(Labels, StandOnTheirSideOfTheirPoint) {
  const std::vector<geometry::Label> labels{{"1", {0.02, 0}, 0, -1},
                                            {"2", {0, 0.02}, -1, 0},
                                            {"3", {-0.02, -0.02}, 0, 1},
                                            {"4", {0.02, -0.03}, 1, 0}};
  shoot(labels);
  ASSERT_EQ(places().size(), 4U);
  const auto middle = [this](std::size_t i) { return (places()[i].low + places()[i].high) / 2.0; };
  EXPECT_GT(places()[0].low.y, seen(labels[0]).y);  // below: y is down in a picture
  EXPECT_NEAR(middle(0).x, seen(labels[0]).x, 1);
  EXPECT_LT(places()[1].high.x, seen(labels[1]).x);
  EXPECT_NEAR(middle(1).y, seen(labels[1]).y, 1);
  EXPECT_LT(places()[2].high.y, seen(labels[2]).y);
  EXPECT_GT(places()[3].low.x, seen(labels[3]).x);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(glm::length(middle(i) - seen(labels[i])), 25) << i;
}

TEST_F(Labels, KeepAGapOfFivePixelsOfTheScreenFromTheirPoint) {
  for (const double scale : {1.0, 2.0}) {
    studio_.view->set_labels({{"25", {0, 0}, 1, 0}, {"25", {0, -0.02}, 0, -1}, {"25", {0, 0.02}, 0, 0}});
    (void)studio_.shoot({}, scale);
    ASSERT_EQ(places().size(), 3U);
    const auto at = [this](double y) { return studio_.view->project({0, y, 0}, kSide, kSide); };
    EXPECT_NEAR(places()[0].low.x - at(0).x, 5 * scale, 1);
    EXPECT_NEAR((places()[0].low.y + places()[0].high.y) / 2, at(0).y, 1);
    EXPECT_NEAR(places()[1].low.y - at(-0.02).y, 5 * scale, 1);
    EXPECT_NEAR((places()[1].low.x + places()[1].high.x) / 2, at(-0.02).x, 1);
    // Without a side it stands on its point.
    const glm::dvec2 middle = (places()[2].low + places()[2].high) / 2.0;
    EXPECT_NEAR(middle.x, at(0.02).x, 1);
    EXPECT_NEAR(middle.y, at(0.02).y, 1);
    // Digits of nine pixels, with an edge of two around them.
    EXPECT_NEAR(places()[0].high.y - places()[0].low.y, 13 * scale, 2 * scale);
    for (const LabelPlace& place : places()) {
      EXPECT_EQ(place.low, glm::floor(place.low)) << "texels fall on pixels";
    }
  }
}

TEST_F(Labels, HaveTheColoursOfNumbersInEachLook) {
  for (const Style style : {Style::wood, Style::slate, Style::classic}) {
    studio_.view->set_style(style);
    const Picture bare = shoot({});
    const Picture lettered = shoot({{"8", {0, 0}, 0, -1}}, 4);
    const Palette& colours = palette(style, Theme::light);
    const auto near = [](fixtures::Rgb a, Colour b) {
      const auto apart = [](int level, float share) { return std::abs(level - std::lround(255 * share)); };
      return apart(a.red, b.r) + apart(a.green, b.g) + apart(a.blue, b.b) < 12;
    };
    int inks = 0, grounds = 0;
    for (double y = places()[0].low.y; y < places()[0].high.y; ++y)
      for (double x = places()[0].low.x; x < places()[0].high.x; ++x) {
        const auto there = pixel(lettered, {x, y});
        inks += near(there, colours.number) ? 1 : 0;
        grounds += near(there, colours.disc) && fixtures::difference(there, pixel(bare, {x, y})) > 0 ? 1 : 0;
      }
    EXPECT_GT(inks, 60) << static_cast<int>(style);
    EXPECT_GT(grounds + (style == Style::classic ? 20 : 0), 10) << static_cast<int>(style);
  }
}

TEST_F(Labels, MayTouchTheBorderOfThePictureAndEachOther) {
  // The box of a label is moved until it leaves the picture.
  shoot({{"7", {0, 0}, 0, 0}});
  const glm::dvec2 size = places()[0].high - places()[0].low;
  const auto shown_at = [&](glm::dvec2 middle) {
    const auto at = studio_.view->pick(middle, kSide, kSide);
    studio_.view->set_labels({{"7", *at, 0, 0}});
    (void)studio_.shoot();
    return places().size() == 1;
  };
  const glm::dvec2 half = size / 2.0;
  EXPECT_TRUE(shown_at(half + glm::dvec2(0.5, 100)));
  EXPECT_FALSE(shown_at(half + glm::dvec2(-0.5, 100)));
  EXPECT_TRUE(shown_at({kSide - half.x + 0.5, 100}));
  EXPECT_FALSE(shown_at({kSide - half.x + 1.5, 100}));
  EXPECT_TRUE(shown_at({100, half.y + 0.5}));
  EXPECT_FALSE(shown_at({100, half.y - 0.5}));
  EXPECT_TRUE(shown_at({100, kSide - half.y + 0.5}));
  EXPECT_FALSE(shown_at({100, kSide - half.y + 1.5}));
  const auto both = [&](double apart_x, double apart_y) {
    const auto one = studio_.view->pick({200.5, 200.5}, kSide, kSide);
    const auto other = studio_.view->pick({200.5 + apart_x, 200.5 + apart_y}, kSide, kSide);
    studio_.view->set_labels({{"7", *one, 0, 0}, {"7", *other, 0, 0}});
    (void)studio_.shoot();
    return places().size() == 2;
  };
  for (const double side : {1.0, -1.0}) {
    EXPECT_TRUE(both(side * size.x, 0));
    EXPECT_FALSE(both(side * (size.x - 1), 0));
    EXPECT_TRUE(both(0, side * (size.y + 1)));
    EXPECT_FALSE(both(0, side * (size.y - 1)));
  }
}

TEST_F(Labels, AreDrawnInTheirBoxAndNowhereElse) {
  const Picture bare = shoot({});
  const Picture lettered = shoot({{"-12.5", {0, 0}, 0, -1}});
  ASSERT_EQ(places().size(), 1U);
  int inside = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double change = std::abs(luminance(pixel(bare, x, y)) - luminance(pixel(lettered, x, y)));
      const bool in_box = x >= places()[0].low.x && x < places()[0].high.x && y >= places()[0].low.y &&
                          y < places()[0].high.y;
      ASSERT_TRUE(in_box || change < 1) << x << ", " << y;
      if (in_box && change > 20) ++inside;
    }
  }
  EXPECT_GT(inside, 100);
}

TEST_F(Labels, OneThatWouldCoverAnEarlierOneOrLeaveThePictureIsNotDrawn) {
  shoot({{"100", {0, 0}, 0, -1}, {"200", {0.001, 0}, 0, -1}, {"300", {0.03, 0}, 0, -1}});
  ASSERT_EQ(places().size(), 2U);
  EXPECT_EQ(places()[0].label, 0U);
  EXPECT_EQ(places()[1].label, 2U);
  Camera near;
  near.tilt = 0;
  near.zoom = 4;
  studio_.view->set_camera(near);
  shoot({{"100", {0, 0}, 0, -1}, {"300", {0.045, 0}, 0, -1}});
  ASSERT_EQ(places().size(), 1U);
  EXPECT_EQ(places()[0].label, 0U);
}

TEST_F(Labels, GrowWithTheTextOfTheWindow) {
  shoot({{"7", {0, 0}, 0, -1}});
  const double usual = places()[0].high.y - places()[0].low.y;
  shoot({{"7", {0, 0}, 0, -1}}, 2);
  // An edge of two pixels on both sides stays.
  EXPECT_NEAR(places()[0].high.y - places()[0].low.y - 4, 2 * (usual - 4), 2);
}

TEST_F(Labels, AreSentOnceToTheGraphicsCard) {
  shoot({{"7", {0, 0}, 0, -1}});
  const auto before = studio_.view->statistics().texture_uploads;
  Camera camera = studio_.view->camera();
  camera.azimuth += 0.1;
  studio_.view->set_camera(camera);
  studio_.shoot();
  EXPECT_EQ(studio_.view->statistics().texture_uploads, before);
  shoot({{"8", {0, 0}, 0, -1}});
  EXPECT_EQ(studio_.view->statistics().texture_uploads, before + 1);
}

double channel(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double relative_luminance(const Colour& c) {
  return 0.2126 * channel(c.r) + 0.7152 * channel(c.g) + 0.0722 * channel(c.b);
}

/// WCAG 2.1, contrast ratio.
TEST_F(Labels, CanBeReadOnTheirGroundInEachLook) {
  for (const Style style : {Style::wood, Style::slate, Style::classic}) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
      const double a = relative_luminance(palette(style, theme).number);
      const double b = relative_luminance(palette(style, theme).disc);
      EXPECT_GE((std::max(a, b) + 0.05) / (std::min(a, b) + 0.05), 4.5);
    }
  }
}

/// Rows and columns of a text with ink, without its margin.
struct Extent {
  int left = 1000, right = -1, top = 1000, bottom = -1;
};

Extent extent(const LabelPicture& picture) {
  Extent e;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (picture.coverage[static_cast<std::size_t>(y * picture.width + x)] < 100) continue;
      e = {std::min(e.left, x), std::max(e.right, x), std::min(e.top, y), std::max(e.bottom, y)};
    }
  }
  return e;
}

class EachLabelFont : public testing::TestWithParam<bool> {
 protected:
  NumberFont font_ = GetParam() ? NumberFont::built_in() : NumberFont();
};

INSTANTIATE_TEST_SUITE_P(View, EachLabelFont, testing::Bool(),
                         [](const auto& chosen) { return chosen.param ? "BuiltIn" : "System"; });

TEST_P(EachLabelFont, SignsStandWhereTheyStandInNumbers) {
  const auto digit = extent(font_.draw_text("5", 40, 3));
  EXPECT_NEAR(digit.bottom - digit.top + 1, 40, 3);
  const auto minus = extent(font_.draw_text("-", 40, 3));
  const double middle = (digit.top + digit.bottom) / 2.0;
  EXPECT_NEAR((minus.top + minus.bottom) / 2.0, middle, 6);
  EXPECT_LT(minus.bottom - minus.top, 12);
  const auto point = extent(font_.draw_text(".", 40, 3));
  EXPECT_NEAR(point.bottom, digit.bottom, 2);
  EXPECT_GT(point.top, middle + 8);
  const auto plus = extent(font_.draw_text("+", 40, 3));
  EXPECT_GT(plus.bottom - plus.top, 12);
  EXPECT_NEAR((plus.top + plus.bottom) / 2.0, middle, 6);
}

TEST_P(EachLabelFont, CharactersFollowEachOtherWithoutTouching) {
  const auto one = font_.draw_text("8", 40, 3);
  const auto three = font_.draw_text("888", 40, 3);
  EXPECT_EQ(three.height, one.height);
  EXPECT_GT(three.width - 6, 3 * (one.width - 6));
  // Between two figures there is a column without ink.
  int gaps = 0;
  bool was_ink = false;
  for (int x = 0; x < three.width; ++x) {
    bool ink = false;
    for (int y = 0; y < three.height; ++y)
      ink = ink || three.coverage[static_cast<std::size_t>(y * three.width + x)] > 100;
    if (was_ink && !ink) ++gaps;
    was_ink = ink;
  }
  EXPECT_EQ(gaps, 3);
}

TEST_P(EachLabelFont, TheMarginStaysEmptyAndOtherCharactersAreLeftOut) {
  const auto picture = font_.draw_text("-1e5", 20, 4);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (x >= 4 && y >= 4 && x < picture.width - 4 && y < picture.height - 4) continue;
      ASSERT_EQ(picture.coverage[static_cast<std::size_t>(y * picture.width + x)], 0);
    }
  }
  EXPECT_EQ(font_
                .draw_text("1\xC3\xA4"
                           "5",
                           20, 4)
                .coverage,
            font_.draw_text("15", 20, 4).coverage);
}

}  // namespace
}  // namespace nazori::view
