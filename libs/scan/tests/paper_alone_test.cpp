// SPDX-License-Identifier: Apache-2.0
#include "nazori/scan/paper_alone.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace nazori::scan {
namespace {

struct Place {
  double x = 0;
  double y = 0;
};

/// A sheet on a table before a camera without distortion, and the light on both.
struct Scene {
  double width = 210, height = 297;  // mm
  double tilt = 0.3, turn = 0.1, roll = 0.05;
  Place middle{};         // of the sheet, beside the middle of the picture [mm]
  double distance = 500;  // mm
  double focal = 0.8;     // of the longer side of the picture
  double paper = 225, table = 90;
  double fall_off = 0.3;  // of the light, from the left side of the picture to the right
  std::vector<Place> dots{
      {60, 60}, {150, 80}, {70, 230}, {140, 200}};  // of 9 mm on the sheet, from its upper left
};

constexpr int kWidth = 480, kHeight = 360;

/// Where the line of sight through a pixel meets the sheet [mm from its upper left corner].
class View {
 public:
  explicit View(const Scene& scene) : scene_(scene) {
    const Eigen::Matrix3d pose = (Eigen::AngleAxisd(scene.tilt, Eigen::Vector3d::UnitX()) *
                                  Eigen::AngleAxisd(scene.turn, Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(scene.roll, Eigen::Vector3d::UnitZ()))
                                     .toRotationMatrix();
    across_ = pose.col(0);
    down_ = pose.col(1);
    normal_ = pose.col(2);
    middle_ = {scene.middle.x, scene.middle.y, scene.distance};
  }
  [[nodiscard]] Place on_sheet(double x, double y) const {
    const Eigen::Vector3d sight((x - (kWidth - 1) / 2.0) / (scene_.focal * kWidth),
                                (y - (kHeight - 1) / 2.0) / (scene_.focal * kWidth), 1);
    const Eigen::Vector3d met = sight * (middle_.dot(normal_) / sight.dot(normal_)) - middle_;
    return {met.dot(across_) + scene_.width / 2, met.dot(down_) + scene_.height / 2};
  }

 private:
  Scene scene_;
  Eigen::Vector3d across_, down_, normal_, middle_;
};

Photo photographed(const Scene& scene, unsigned seed = 1) {
  const View view(scene);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 3);
  Photo photo{kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      double sum = 0;
      for (const double du : {-0.25, 0.25})
        for (const double dv : {-0.25, 0.25}) {
          const Place p = view.on_sheet(x + du, y + dv);
          const bool is_paper = p.x >= 0 && p.y >= 0 && p.x <= scene.width && p.y <= scene.height;
          const bool is_ink = std::any_of(scene.dots.begin(), scene.dots.end(), [&](Place dot) {
            return std::hypot(p.x - dot.x, p.y - dot.y) < 9;
          });
          sum += !is_paper ? scene.table : is_ink ? 0.2 * scene.paper : scene.paper;
        }
      const double light = 1 - scene.fall_off * x / kWidth;
      photo.grey.push_back(
          static_cast<std::uint8_t>(std::clamp(sum / 4 * light + noise(random), 0.0, 255.0)));
    }
  return photo;
}

/// The middle of the dark pixels around a place of the picture, in parts of its sides.
Place dark_around(const Photo& photo, Place place) {
  double n = 0, sum_x = 0, sum_y = 0;
  const int left = static_cast<int>(place.x * photo.width), top = static_cast<int>(place.y * photo.height);
  const int reach = photo.width / 10;
  for (int y = std::max(0, top - reach); y < std::min(photo.height, top + reach); ++y)
    for (int x = std::max(0, left - reach); x < std::min(photo.width, left + reach); ++x)
      if (photo.at(x, y) < 75) {
        ++n;
        sum_x += x;
        sum_y += y;
      }
  return {(sum_x / n + 0.5) / photo.width, (sum_y / n + 0.5) / photo.height};
}

void expect_flat(const Scene& scene, unsigned seed) {
  const Photo flat = paper_alone(photographed(scene, seed));
  ASSERT_NE(flat.width, kWidth) << seed << ": no sheet was found, " << flat.height;
  EXPECT_NEAR(static_cast<double>(flat.width) / flat.height / (scene.width / scene.height), 1, 0.04) << seed;
  for (const Place dot : scene.dots) {
    const Place wanted{dot.x / scene.width, dot.y / scene.height};
    const Place found = dark_around(flat, wanted);
    EXPECT_NEAR(found.x, wanted.x, 0.012) << seed << ": " << dot.x << ' ' << dot.y;
    EXPECT_NEAR(found.y, wanted.y, 0.012) << seed << ": " << dot.x << ' ' << dot.y;
  }
  const double share =
      static_cast<double>(std::count_if(flat.grey.begin(), flat.grey.end(), [](auto v) { return v < 75; })) /
      static_cast<double>(flat.grey.size());
  // The table around would be far more than the dots.
  const double dots =
      static_cast<double>(scene.dots.size()) * std::numbers::pi * 81 / (scene.width * scene.height);
  EXPECT_NEAR(share / dots, 1, 0.25) << seed;
}

TEST(PaperAlone, IsTheSheetFromAboveHoweverTheCameraStood) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  for (unsigned seed = 0; seed < 8; ++seed) {
    Scene scene;
    scene.tilt = between(-0.6, 0.6);
    scene.turn = between(-0.6, 0.6);
    scene.roll = between(-0.5, 0.5);
    scene.focal = between(0.7, 1.3);
    scene.distance = scene.focal * between(620, 800);
    scene.middle = {between(-20, 20), between(-15, 15)};
    scene.table = between(40, 200);
    scene.fall_off = between(0, 0.4);
    expect_flat(scene, seed);
  }
}

TEST(PaperAlone, ASheetThatLiesAcrossKeepsItsProportions) {
  Scene scene;
  scene.width = 297;
  scene.height = 210;
  scene.dots = {{60, 60}, {230, 70}, {150, 150}};
  expect_flat(scene, 1);
  scene.width = scene.height = 200;
  scene.dots = {{40, 50}, {150, 60}, {90, 160}, {160, 150}};
  expect_flat(scene, 2);
}

TEST(PaperAlone, OfASheetThatReachesBeyondThePictureTheTableGoes) {
  Scene scene;
  scene.distance = 330;
  scene.middle = {20, 60};
  const Photo photo = photographed(scene);
  ASSERT_LT(*std::min_element(photo.grey.begin(), photo.grey.begin() + 200), 110)
      << "the table is in the picture";
  const Photo cut = paper_alone(photo);
  EXPECT_EQ(cut.width, photo.width);
  EXPECT_LT(cut.height, photo.height);
  // The table has 0.4 of the paper's brightness, ink 0.2, and the light falls off to 0.7.
  int table = 0, ink = 0;
  for (int y = 0; y < cut.height; ++y)
    for (int x = 0; x < cut.width; ++x) {
      const double part = cut.at(x, y) / 225.0 / (1 - 0.3 * x / kWidth);
      table += part > 0.3 && part < 0.5 ? 1 : 0;
      ink += part < 0.3 ? 1 : 0;
    }
  EXPECT_LT(table, 0.003 * cut.width * cut.height) << "only at the edges of the dots";
  EXPECT_GT(ink, 0.004 * cut.width * cut.height);
}

TEST(PaperAlone, OfASheetThatIsWiderThanThePictureTheTableGoesAboveAndBelow) {
  // 297 mm across at 300 mm: 380 of 360 pixels and more; 150 mm high: 192 of 360.
  for (const double y : {-25.0, 0.0, 25.0}) {
    Scene scene;
    scene.width = 500;
    scene.height = 150;
    scene.distance = 300;
    scene.tilt = scene.turn = 0;
    scene.roll = 0.02;
    scene.fall_off = 0;
    scene.middle = {0, y};
    scene.dots = {{200, 50}, {260, 110}, {310, 60}};
    const Photo cut = paper_alone(photographed(scene));
    EXPECT_EQ(cut.width, kWidth);
    EXPECT_NEAR(cut.height, 150 / 300.0 * 0.8 * kWidth, 16) << y;
    const auto table =
        std::count_if(cut.grey.begin(), cut.grey.end(), [](auto v) { return v > 70 && v < 120; });
    EXPECT_LT(static_cast<double>(table), 0.004 * static_cast<double>(cut.grey.size())) << y;
  }
}

TEST(PaperAlone, ASheetAndAsBrightATableAreNotToldApart) {
  Scene scene;
  scene.fall_off = 0;
  scene.table = 0.97 * scene.paper;
  const Photo photo = photographed(scene);
  EXPECT_EQ(paper_alone(photo).grey, photo.grey);
}

/// Dark writing on paper that fills the picture: `ink(x, y)` for 0..1.
Photo drawn(auto ink) {
  Photo photo{400, 400, {}};
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 400; ++x) photo.grey.push_back(ink(x / 400.0, y / 400.0) ? 40 : 230);
  return photo;
}

TEST(PaperAlone, APictureThatIsNothingButPaperStaysAsItIs) {
  Scene close;
  close.distance = 120;
  close.tilt = close.turn = 0;
  const Photo photo = photographed(close);
  EXPECT_EQ(paper_alone(photo).grey, photo.grey);
}

TEST(PaperAlone, WhatInkEnclosesIsNoSheet) {
  const auto ring = [](double x, double y, double low, double wide) {
    const double out = std::max(std::abs(x - 0.5), std::abs(y - 0.5));
    return out < 0.5 - low && out > 0.5 - low - wide;
  };
  const Photo mouth = drawn([&](double x, double y) { return ring(x, y, 0.1, 0.06); });
  EXPECT_EQ(paper_alone(mouth).grey, mouth.grey) << "口";
  const Photo sun = drawn([&](double x, double y) {
    return ring(x, y, 0.1, 0.06) || (ring(x, y, 0.1, 0.4) && std::abs(y - 0.5) < 0.02);
  });
  EXPECT_EQ(paper_alone(sun).grey, sun.grey) << "日";
}

TEST(PaperAlone, ABroadStrokeIsNoSheet) {
  const Photo one =
      drawn([](double x, double y) { return std::abs(x - 0.5) < 0.45 && std::abs(y - 0.5) < 0.2; });
  EXPECT_EQ(paper_alone(one).grey, one.grey);
}

TEST(PaperAlone, ASheetWithoutWritingIsNotLookedFor) {
  Scene scene;
  scene.dots.clear();
  const Photo photo = photographed(scene);
  EXPECT_EQ(paper_alone(photo).grey, photo.grey);
}

TEST(PaperAlone, TakesThePicturesOfTheSmallestSides) {
  for (const auto& [width, height] : {std::pair{64, 64}, {64, 4000}, {4000, 64}}) {
    Photo photo{width, height, {}};
    photo.grey.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 200);
    EXPECT_EQ(paper_alone(photo).grey, photo.grey);
  }
}

}  // namespace
}  // namespace nazori::scan
