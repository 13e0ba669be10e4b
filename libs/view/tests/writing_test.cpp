// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "view_fixtures.h"

namespace nazori::view {
namespace {

using fixtures::changed_pixels;
using fixtures::difference;
using fixtures::pixel;
using fixtures::Rgb;
using fixtures::seen;
using fixtures::Studio;

surface::HeightMap blank() { return surface::HeightMap::create(64).value(); }

WrittenStroke level(double glyph_y, Verdict verdict, double half_width_m = 0.002) {
  WrittenStroke stroke;
  stroke.verdict = verdict;
  for (const double x : {30.0, 50.0, 80.0})
    stroke.points.push_back({geometry::glyph_to_tablet({x, glyph_y}, {}), half_width_m});
  return stroke;
}

class WritingInEveryLook : public testing::TestWithParam<std::tuple<Style, Theme>> {
 protected:
  WritingInEveryLook() : studio(500, 500) {
    studio.view->set_style(std::get<0>(GetParam()));
    studio.view->set_theme(std::get<1>(GetParam()));
    studio.view->set_height_map(blank());
  }
  Studio studio;
};

TEST_P(WritingInEveryLook, LiesWhereItWasWrittenAndNowhereElse) {
  const Picture bare = studio.shoot();
  const std::vector writing{level(54, Verdict::none)};
  Overlay overlay;
  overlay.writing = writing;
  const Picture written = studio.shoot(overlay);
  EXPECT_GT(difference(pixel(bare, seen(studio, {60, 54})), pixel(written, seen(studio, {60, 54}))), 100);
  EXPECT_EQ(difference(pixel(bare, seen(studio, {60, 60})), pixel(written, seen(studio, {60, 60}))), 0);
  EXPECT_EQ(difference(pixel(bare, seen(studio, {20, 54})), pixel(written, seen(studio, {20, 54}))), 0);
  EXPECT_EQ(changed_pixels(bare, studio.shoot(), 0), 0) << "it leaves nothing behind";
}

TEST_P(WritingInEveryLook, EveryVerdictIsSeenAgainstTheTabletEvenWithoutColour) {
  const Picture bare = studio.shoot();
  for (const auto verdict :
       {Verdict::none, Verdict::right, Verdict::nearly, Verdict::wrong, Verdict::shown}) {
    const std::vector writing{level(54, verdict)};
    Overlay overlay;
    overlay.writing = writing;
    const Picture written = studio.shoot(overlay);
    const auto linear = [](Rgb c) {
      const auto channel = [](int v) {
        const double s = v / 255.0;
        return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
      };
      return 0.2126 * channel(c.red) + 0.7152 * channel(c.green) + 0.0722 * channel(c.blue) + 0.05;
    };
    double a = linear(pixel(bare, seen(studio, {60, 54})));
    double b = linear(pixel(written, seen(studio, {60, 54})));
    if (a < b) std::swap(a, b);
    EXPECT_GE(a / b, 3.0) << static_cast<int>(verdict);
  }
}

TEST_P(WritingInEveryLook, TheSignsOfTheVerdictsDifferInShape) {
  std::vector<Picture> pictures;
  for (const auto verdict : {Verdict::right, Verdict::nearly, Verdict::wrong}) {
    const std::vector writing{level(54, verdict)};
    Overlay overlay;
    overlay.writing = writing;
    pictures.push_back(studio.shoot(overlay));
    ASSERT_EQ(studio.view->signs().size(), 1U);
    EXPECT_EQ(studio.view->signs()[0].verdict, verdict);
  }
  const SignPlace sign = studio.view->signs()[0];
  // Which pixels of the disc are ground tells the shapes apart whatever their colour.
  const auto mask = [&](const Picture& picture) {
    const Rgb ground = pixel(picture, sign.pixel + glm::dvec2(-sign.radius * 0.72, 0));
    std::vector<bool> bits;
    for (int y = -6; y <= 6; ++y)
      for (int x = -6; x <= 6; ++x)
        bits.push_back(difference(ground, pixel(picture, sign.pixel + glm::dvec2(x, y))) > 120);
    return bits;
  };
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = a + 1; b < 3; ++b) {
      int differ = 0;
      const auto one = mask(pictures[a]);
      const auto other = mask(pictures[b]);
      for (std::size_t i = 0; i < one.size(); ++i) differ += one[i] != other[i] ? 1 : 0;
      EXPECT_GT(differ, 12) << a << " and " << b;
    }
}

INSTANTIATE_TEST_SUITE_P(View, WritingInEveryLook,
                         testing::Combine(testing::Values(Style::classic, Style::wood, Style::slate),
                                          testing::Values(Theme::light, Theme::dark)));

TEST(Writing, PressureIsTheWidthOfTheLine) {
  Studio studio(500, 500);
  studio.view->set_height_map(blank());
  const Picture bare = studio.shoot();
  const auto inked = [&](double half_width_m) {
    const std::vector writing{level(54, Verdict::none, half_width_m)};
    Overlay overlay;
    overlay.writing = writing;
    return changed_pixels(bare, studio.shoot(overlay));
  };
  const double thin = inked(0.0005);
  const double wide = inked(0.002);
  EXPECT_NEAR(wide / thin, 4.0, 0.8);
}

TEST(Writing, SignsOfStrokesThatStartTogetherDoNotHideEachOther) {
  Studio studio(500, 500);
  studio.view->set_height_map(blank());
  const std::vector writing{level(54, Verdict::right), level(54.5, Verdict::wrong),
                            level(53.5, Verdict::nearly)};
  Overlay overlay;
  overlay.writing = writing;
  (void)studio.shoot(overlay);
  const auto signs = studio.view->signs();
  ASSERT_EQ(signs.size(), 3U);
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = a + 1; b < 3; ++b)
      EXPECT_GE(glm::distance(signs[a].pixel, signs[b].pixel), 2 * signs[a].radius - 1e-6);
}

TEST(Writing, IsSentToTheGraphicsOnceWhileItStaysTheSame) {
  Studio studio(300, 300);
  studio.view->set_height_map(blank());
  const std::vector writing{level(54, Verdict::none)};
  Overlay overlay;
  overlay.writing = writing;
  (void)studio.shoot(overlay);
  const auto before = studio.view->statistics();
  (void)studio.shoot(overlay);
  EXPECT_EQ(studio.view->statistics().buffer_uploads, before.buffer_uploads);
  EXPECT_EQ(studio.view->statistics().full_redraws, before.full_redraws);
}

}  // namespace
}  // namespace nazori::view
