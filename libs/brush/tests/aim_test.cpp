// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/aim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nazori/brush/replay.h"

namespace nazori::brush {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLeft_rad = 3 * kPi / 4;  ///< to which side the tip of a leaning holder points

TuftForm medium() { return tuft_form(6, Hair::mixed).value(); }

/// How far the middle of the patch of contact is from the pen, at most [m].
struct Miss {
  double first = 0;  ///< over the first 4 mm
  double last = 0;   ///< after 20 mm
};

/// A brush that writes one line after another.
class Writer {
 public:
  explicit Writer(double lean_rad) : lean_rad_(lean_rad) {}

  /// A line of 24 mm in 0.6 s. @param pressure  none: guessed from the speed.
  Miss line(double angle, std::optional<double> pressure) {
    Miss miss;
    constexpr int kMoves = 80;
    constexpr double kLength_m = 0.024;
    move(last_, false, pressure);
    time_s_ += 0.5;
    move({}, false, pressure);
    for (int i = 0; i <= kMoves; ++i) {
      const double along = kLength_m * i / kMoves;
      const geometry::PaperPoint pen{along * std::cos(angle), along * std::sin(angle)};
      time_s_ += 0.0075;
      move(pen, true, pressure);
      if (!tuft_.touching()) continue;
      const double off = geometry::distance(tuft_.patch_at(), pen);
      if (along < 0.004) miss.first = std::max(miss.first, off);
      if (along > 0.020) miss.last = std::max(miss.last, off);
    }
    return miss;
  }

 private:
  void move(geometry::PaperPoint pen, bool down, std::optional<double> pressure) {
    PenSample sample;
    sample.time_s = time_s_;
    sample.at = pen;
    sample.down = down;
    sample.pressure = pressure;
    sample.lean_rad = lean_rad_;
    sample.lean_to_rad = kLeft_rad - kPi;
    HolderPose pose = holder_.next(sample);
    // The tip comes down where the pen is, wherever it was before.
    if (down && !was_down_) {
      HolderPose above = pose;
      for (const double depth : {-0.005, 0.0}) {
        above.depth_m = depth;
        tuft_.move_to(above, swept_);
      }
    }
    was_down_ = down;
    last_ = pen;
    aim_.lead(pose, tuft_);
    tuft_.move_to(pose, swept_);
  }

  double lean_rad_;
  TuftForm form_ = medium();
  Tuft tuft_{form_};
  PenToHolder holder_{form_, {}};
  Aim aim_{form_};
  std::vector<geometry::BristleSegment> swept_;
  double time_s_ = 1;
  bool was_down_ = false;
  geometry::PaperPoint last_;
};

void expect_near(std::optional<double> pressure, double first_mm, double last_mm) {
  for (const double lean : {0.0, 10 * kPi / 180}) {
    Writer writer(lean);
    for (int k = 0; k < 8; ++k) {
      const Miss miss = writer.line(k * kPi / 4, pressure);
      EXPECT_LE(miss.first * 1000, first_mm) << "lean " << lean << ", " << k * 45 << " degrees";
      EXPECT_LE(miss.last * 1000, last_mm) << "lean " << lean << ", " << k * 45 << " degrees";
    }
  }
}

// A brush that lies the other way must be swung around the ink first, so a start is not exact.
TEST(Aim, TheInkIsUnderAMouseOrAFingerFromTheStart) { expect_near({}, 4.8, 0.3); }
TEST(Aim, TheInkIsUnderALightPen) { expect_near(0.1, 2.6, 0.05); }
TEST(Aim, TheInkIsUnderAPenOfMiddlePressure) { expect_near(0.3, 2.9, 0.05); }
TEST(Aim, TheInkIsUnderAFirmPen) { expect_near(0.6, 2.2, 0.05); }
TEST(Aim, TheInkIsUnderAPenThatIsPressedHard) { expect_near(0.9, 3.0, 0.05); }

TEST(Aim, TheFootIsAheadAsFarAsTheHairBends) {
  const TuftForm form = medium();
  Tuft tuft(form);
  std::vector<geometry::BristleSegment> swept;
  Aim aim(form);
  HolderPose above;
  above.depth_m = -0.005;
  tuft.move_to(above, swept);
  // The tip points up to the left, so the foot comes down to the lower right of the pen, farther the deeper.
  double before = 0;
  for (const double depth : {0.0, 1e-13, 0.1, 0.2, 0.3}) {
    Aim fresh(form);
    HolderPose pose;
    pose.at = {0.01, 0.02};
    pose.depth_m = depth * form.hair_m;
    fresh.lead(pose, tuft);
    const geometry::PaperPoint foot = pose.at;
    EXPECT_NEAR(foot.x - 0.01, -(foot.y - 0.02), 1e-9);
    const double lead = geometry::distance(foot, {0.01, 0.02});
    if (depth < 1e-9) {
      EXPECT_NEAR(lead, 0, 1e-12);
    } else {
      EXPECT_GT(lead, before);
    }
    EXPECT_LT(lead, form.hair_m);
    before = lead;
  }
}

}  // namespace
}  // namespace nazori::brush
