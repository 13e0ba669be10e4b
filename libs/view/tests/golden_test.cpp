// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "test_paths.h"
#include "view_fixtures.h"

namespace nazori::view {
namespace {

using fixtures::carved;
using fixtures::difference;
using fixtures::pixel;
using fixtures::rest;
using fixtures::Studio;

/// The tolerance for other versions of Mesa, other fonts for the numbers and other GPUs: the mean over all
/// channels by this much of 255, and this share of the pixels by more than kFar summed over the channels.
constexpr double kMeanTolerance = 1.5;
constexpr double kFarShare = 0.015;
constexpr int kFar = 90;

struct Scene {
  const char* name;
  Style style;
  Theme theme;
  Camera camera;
  int current;
  double traced;  ///< strokes finished, and the share of the next
  bool strokes;
};

constexpr std::array kScenes{
    Scene{"classic", Style::classic, Theme::light, {}, 0, 0, true},
    Scene{"classic_plain", Style::classic, Theme::light, {}, 0, 0, false},
    Scene{"wood", Style::wood, Theme::light, {0, Camera::kRestingTilt, 1, {}}, 0, 0, true},
    Scene{"wood_tracing", Style::wood, Theme::light, {0, Camera::kRestingTilt, 1, {}}, 4, 3.6, true},
    Scene{"wood_dark", Style::wood, Theme::dark, {0.5, 0.8, 1.1, {}}, 3, 2.5, true},
    Scene{"slate", Style::slate, Theme::light, {-0.4, 0.6, 1, {}}, 0, 2.0, true},
    Scene{"slate_dark", Style::slate, Theme::dark, {0, 0.2, 2.2, {0.01, 0.01}}, 2, 1.4, true},
};

class Golden : public testing::TestWithParam<Scene> {};

TEST_P(Golden, LooksAsItDidWhenAPersonLookedAtIt) {
  const Scene& scene = GetParam();
  Studio studio(320, 240);
  studio.view->set_style(scene.style);
  studio.view->set_theme(scene.theme);
  studio.view->set_height_map(carved(rest()));
  studio.view->set_strokes(kanji::centre_lines(rest()));
  studio.view->set_camera(scene.camera);
  Overlay overlay;
  overlay.strokes_visible = scene.strokes;
  overlay.current_stroke = scene.current;
  overlay.text_scale = 0.8;
  std::array<double, 6> ink{};
  for (std::size_t i = 0; i < ink.size(); ++i)
    ink[i] = std::clamp(scene.traced - static_cast<double>(i), 0.0, 1.0);
  overlay.groove_ink = ink;
  if (scene.current > 0 || scene.style == Style::classic) {
    overlay.cursor = Cursor{{0.012, 0.004, -0.006}, {0.018, -0.004, -0.010}, true, {}};
  }
  const Picture actual = studio.shoot(overlay);

  const std::string file = std::string(scene.name) + ".png";
  const auto golden_path = std::filesystem::path(test_paths::kFixtures).parent_path() / "goldens" / file;
  if (std::getenv("NAZORI_WRITE_GOLDENS") != nullptr) {  // NOLINT(concurrency-mt-unsafe): no thread sets it
    ASSERT_TRUE(save_png(actual, golden_path).has_value());
  }
  const auto golden = load_picture_png(golden_path);
  ASSERT_TRUE(golden.has_value()) << base::to_line(golden.error());
  ASSERT_EQ(golden->width, actual.width);
  ASSERT_EQ(golden->height, actual.height);
  double sum = 0;
  int far = 0;
  for (int y = 0; y < actual.height; ++y) {
    for (int x = 0; x < actual.width; ++x) {
      const int off = difference(pixel(actual, x, y), pixel(*golden, x, y));
      sum += off;
      far += off > kFar ? 1 : 0;
    }
  }
  const double pixels = static_cast<double>(actual.width) * actual.height;
  const bool alike = sum / pixels / 3 <= kMeanTolerance && far / pixels <= kFarShare;
  const auto actual_path = std::filesystem::current_path() / (std::string(scene.name) + ".actual.png");
  if (!alike) (void)save_png(actual, actual_path);
  EXPECT_TRUE(alike) << "mean " << sum / pixels / 3 << " of " << kMeanTolerance << ", far " << far / pixels
                     << " of " << kFarShare << "; what was drawn is in " << actual_path;
}

INSTANTIATE_TEST_SUITE_P(View, Golden, testing::ValuesIn(kScenes),
                         [](const auto& scene) { return std::string(scene.param.name); });

}  // namespace
}  // namespace nazori::view
