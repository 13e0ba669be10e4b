// SPDX-License-Identifier: Apache-2.0
// Guidance as a servo gives it, with the tip moved by script: what is right and wrong, and what is felt.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "../src/guidance.h"
#include "alloc_guard.h"
#include "nazori/haptics/servo.h"
#include "nazori/haptics/stroke_index.h"
#include "relief.h"

namespace nazori::haptics {
namespace {

using test::Relief;

constexpr double kDepth_m = 0.01;
constexpr double kTick_s = 0.001;

StrokePath line(const std::vector<Vec3>& corners, int pieces = 60) {
  StrokePath path;
  path.points.push_back(corners.front());
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    for (int i = 1; i <= pieces; ++i)
      path.points.push_back(corners[k] + (corners[k + 1] - corners[k]) * (static_cast<double>(i) / pieces));
  return path;
}

// Two strokes that do not meet, and one with a corner that crosses the second.
const std::vector<StrokePath>& strokes() {
  static const std::vector<StrokePath> made{
      line({{-0.03, 0.03, -kDepth_m}, {0.03, 0.03, -kDepth_m}}),
      line({{0, 0.02, -kDepth_m}, {0, -0.03, -kDepth_m}}),
      line({{-0.03, 0, -kDepth_m}, {0.03, 0, -kDepth_m}, {0.03, -0.03, -kDepth_m}})};
  return made;
}

double distance_from_above(const Vec3& p) {
  double best = 1;
  for (const StrokePath& s : strokes())
    for (const Vec3& q : s.points) best = std::min(best, std::hypot(p.x - q.x, p.y - q.y));
  return best;
}

const Relief& relief() {
  static const Relief made(256, kDepth_m, [](double x, double y) {
    const double d = distance_from_above({x, y, 0});
    return d > 0.003 ? 0.0 : -0.5 * kDepth_m * (1 + std::cos(d / 0.003 * 3.14159265358979));
  });
  return made;
}

/// A servo and its clock, with a tip that the test moves.
class Hand {
 public:
  explicit Hand(const Guiding& guiding) { guide(guiding); }
  void guide(const Guiding& guiding) {
    auto scene = relief().scene();
    scene->strokes = strokes();
    scene->guiding = guiding;
    servo.set_scene(scene);
  }
  Vec3 at(const Vec3& p, bool present = true) {
    time_s += kTick_s;
    tip = p;
    const Vec3 force = servo.tick({time_s, p, 0, present});
    const ServoSample& s = servo.latest();
    seen = static_cast<std::uint16_t>(seen | s.events);
    for (unsigned bit = 0; bit < 16; ++bit) counts[bit] += (s.events >> bit) & 1;
    if (has(s.events, ServoEvent::stroke_done)) done.push_back(s.done_stroke);
    return force;
  }
  /// In a straight line, at 20 mm/s by default.
  Vec3 go(const Vec3& to, double speed_m_s = 0.02) {
    const Vec3 from = tip;
    const int ticks =
        std::max(1, static_cast<int>(std::lround(glm::length(to - from) / speed_m_s / kTick_s)));
    Vec3 force(0);
    for (int i = 1; i <= ticks; ++i) force = at(from + (to - from) * (static_cast<double>(i) / ticks));
    return force;
  }
  Vec3 rest(int ticks) {
    Vec3 force(0);
    for (int i = 0; i < ticks; ++i) force = at(tip);
    return force;
  }
  /// Moves along a stroke, from arc length to arc length, `above_m` over its line.
  void along(int stroke, double from_m, double to_m, double above_m = 0.001) {
    const StrokeIndex index(strokes(), 0);
    const double step = to_m > from_m ? 2e-5 : -2e-5;
    for (double s = from_m; (to_m - s) * step > 0; s += step)
      at(index.at_length(stroke, s).point + Vec3(0, 0, above_m));
  }
  void write(int stroke) {
    const StrokePath& path = strokes()[static_cast<std::size_t>(stroke) - 1];
    over(path.points.front());
    go(path.points.front() + Vec3(0, 0, 0.001));
    along(stroke, 0, 1e-9);
    const StrokeIndex index(strokes(), 0);
    along(stroke, 0, index.stroke_length_m(index.at_length(stroke, 0).segment));
  }
  /// Moves, lifted, to above a point.
  void over(const Vec3& p) {
    go({tip.x, tip.y, 0.005});
    go({p.x, p.y, 0.005}, 0.1);
  }
  [[nodiscard]] const ServoSample& now() { return servo.latest(); }
  [[nodiscard]] int count(ServoEvent e) const {
    unsigned bit = 0;
    while ((1U << bit) != static_cast<unsigned>(e)) ++bit;
    return counts[bit];
  }

  Servo servo{DeviceDescription{}};
  double time_s = 0;
  Vec3 tip{-0.04, 0.04, 0.005};
  std::uint16_t seen = 0;
  std::vector<int> done;
  int counts[16] = {};
};

Guiding mode(GuidingMode m, double strength = 1) {
  Guiding g;
  g.mode = m;
  g.strength = strength;
  return g;
}
Guiding lesson(double strength = 1) { return mode(GuidingMode::lesson, strength); }

TEST(Lesson, StrokesWrittenInOrderAreDoneOneByOneInEveryMode) {
  for (const GuidingMode m : {GuidingMode::lesson, GuidingMode::lead, GuidingMode::disturb})
    for (const double strength : {0.0, 1.0}) {
      Hand hand(mode(m, strength));
      hand.rest(10);
      EXPECT_EQ(hand.now().guided_stroke, 1);
      for (int n = 1; n <= 3; ++n) {
        hand.write(n);
        EXPECT_EQ(hand.now().guided_stroke, n < 3 ? n + 1 : 0);
        EXPECT_EQ(hand.count(ServoEvent::capture), n);
        EXPECT_EQ(hand.count(ServoEvent::release), n);
      }
      EXPECT_EQ(hand.done, (std::vector{1, 2, 3}));
      EXPECT_EQ(hand.count(ServoEvent::lesson_done), 1);
      EXPECT_EQ(hand.count(ServoEvent::wrong_start), 0);
      EXPECT_EQ(hand.count(ServoEvent::wrong_direction), 0);
      hand.go({0, 0, 0.005});
      EXPECT_EQ(hand.rest(100), Vec3(0)) << "a lesson that is over does not pull";
    }
}

TEST(Lesson, ALessonMayBeginAtALaterStroke) {
  Guiding from = lesson();
  from.stroke = 3;
  Hand hand(from);
  hand.write(3);
  EXPECT_EQ(hand.done, (std::vector{3}));
  EXPECT_EQ(hand.count(ServoEvent::lesson_done), 1);
  from.stroke = 9;
  Hand none(from);
  none.rest(10);
  EXPECT_EQ(none.now().guided_stroke, 0);
}

TEST(Lesson, ComingDownOnAnotherStrokeIsReportedOnceAndMeetsASoftWall) {
  Hand hand(lesson());
  hand.over({0, -0.01, 0});  // on the second stroke, while the first is to be written
  EXPECT_EQ(hand.count(ServoEvent::wrong_start), 0);
  hand.go({0, -0.01, -0.004});
  const Vec3 force = hand.rest(100);
  EXPECT_EQ(hand.count(ServoEvent::wrong_start), 1);
  EXPECT_NEAR(force.z, 100 * 0.004, 1e-6) << "100 N/m, as if the groove were filled";
  EXPECT_NEAR(std::hypot(force.x, force.y), 0, 1e-6);
  EXPECT_EQ(hand.now().stroke, 0);
  EXPECT_FALSE(hand.now().touching) << "still above the bottom of the groove";
  hand.over({0, -0.01, 0});
  hand.go({0, -0.01, -0.009});
  EXPECT_EQ(hand.count(ServoEvent::wrong_start), 2);
  EXPECT_LE(glm::length(hand.rest(100)), 0.8 + 1e-9);
  EXPECT_TRUE(hand.done.empty());
}

TEST(Lesson, ComingDownAtTheFarEndIsAWrongStartAndWritesNothing) {
  Hand hand(lesson());
  hand.over({0.03, 0.03, 0});
  hand.go({0.03, 0.03, -0.008});
  EXPECT_EQ(hand.count(ServoEvent::wrong_start), 1);
  hand.along(1, 0.06, 0.02, 0.002);
  EXPECT_EQ(hand.now().progress_m, 0);
  EXPECT_TRUE(hand.done.empty());
}

TEST(Lesson, PuttingTheTipDownBesideAllStrokesIsNotAWrongStart) {
  Hand hand(lesson());
  hand.over({-0.04, -0.03, 0});
  hand.go({-0.04, -0.03, -0.001});
  EXPECT_TRUE(hand.now().touching);
  EXPECT_EQ(hand.count(ServoEvent::wrong_start), 0);
}

TEST(Lesson, GoingBackMeetsASoftWallAndIsReportedOncePerOccurrence) {
  Hand hand(lesson());
  hand.over({-0.03, 0.03, 0});
  hand.go({-0.03, 0.03, -0.009});
  hand.along(1, 0, 0.03);
  const Vec3 forwards = hand.rest(100);
  EXPECT_NEAR(forwards.x, 0, 1e-6) << "nothing pushes along while going forwards";
  hand.along(1, 0.03, 0.0292);
  EXPECT_NEAR(hand.rest(100).x, 0, 1e-6) << "a little slack";
  double before = 0;
  double from = 0.03;
  for (const double back : {0.0025, 0.004, 0.006}) {
    hand.along(1, from, 0.03 - back);
    from = 0.03 - back;
    const Vec3 force = hand.rest(100);
    EXPECT_GT(force.x, before);
    EXPECT_NEAR(force.x, 100 * (back - 0.001), 0.01);
    before = force.x;
    EXPECT_EQ(hand.count(ServoEvent::wrong_direction), back > 0.003 ? 1 : 0);
  }
  hand.along(1, 0.024, 0.005);
  EXPECT_LE(hand.rest(100).x, 0.75 * 0.8 + 1e-9);
  EXPECT_EQ(hand.count(ServoEvent::wrong_direction), 1);
  hand.along(1, 0.005, 0.031);
  hand.along(1, 0.031, 0.027);
  EXPECT_EQ(hand.count(ServoEvent::wrong_direction), 2);
  EXPECT_NEAR(hand.now().progress_m, 0.031, 1e-4) << "what was reached stays";
}

TEST(Lesson, TheStrokeHoldsTheTipSidewaysWithinTheCapAndNeverLiftsIt) {
  Hand hand(lesson());
  hand.over({-0.03, 0.03, 0});
  hand.go({-0.03, 0.03, -0.009});
  hand.along(1, 0, 0.03);
  // 2 mm aside and 6 mm above the bottom, in the air at the top of the groove.
  hand.go({0, 0.032, -0.004});
  const Vec3 force = hand.rest(200);
  if (!hand.now().touching) {
    EXPECT_NEAR(force.y, -100 * 0.002, 0.01);
    EXPECT_NEAR(force.z, -0.4 * 0.8, 1e-6);
  }
  EXPECT_EQ(hand.now().stroke, 1);
  EXPECT_NEAR(hand.now().off_m, 0.002, 1e-6);
}

TEST(Lesson, FinishingAStrokeCarriesTheHandLiftedToTheNextStart) {
  Hand hand(lesson());
  hand.write(1);
  ASSERT_EQ(hand.done, (std::vector{1}));
  Vec3 force = hand.rest(300);
  EXPECT_GT(force.z, 0.3) << "first up";
  EXPECT_LT(std::hypot(force.x, force.y), 0.05) << "not against the walls of the groove";
  hand.go({0.03, 0.03, 0.004});
  force = hand.rest(50);
  const Vec3 towards = glm::normalize(Vec3(0, 0.02, 0) - Vec3(0.03, 0.03, 0));
  EXPECT_GT(glm::dot(force, towards), 0.3) << "then across";
  EXPECT_NEAR(hand.now().guide_m.z, 0.005, 1e-9);
  hand.go({0.0002, 0.02, 0.004});
  EXPECT_LT(hand.rest(50).z, -0.2) << "and down where it begins";
  EXPECT_LE(glm::length(force), 0.6 * 0.8 + 1e-9);
}

TEST(Lesson, WhoHoldsTheHandStillIsNotCarriedUntilComingAlong) {
  Hand hand(lesson());
  hand.go({-0.01, 0.03, 0.005});
  EXPECT_EQ(hand.rest(1500), Vec3(0));
  EXPECT_EQ(hand.count(ServoEvent::resisted), 1);
  hand.go({-0.008, 0.03, 0.005});
  EXPECT_EQ(hand.rest(100), Vec3(0)) << "away from the start is not along";
  hand.go({-0.011, 0.03, 0.005});
  EXPECT_EQ(hand.count(ServoEvent::resumed), 1);
  EXPECT_LT(hand.rest(100).x, -0.05);
}

TEST(Lesson, AStrokeMayBeLeftBeforeItsEndButNotInItsMiddle) {
  Hand hand(lesson());
  hand.over({-0.03, 0.03, 0});
  hand.go({-0.03, 0.03, -0.009});
  hand.along(1, 0, 0.03);
  hand.over({0, 0.03, 0});
  EXPECT_TRUE(hand.done.empty());
  EXPECT_NEAR(hand.now().progress_m, 0.03, 1e-4);
  hand.go({0, 0.03, -0.009});  // continues where it was
  EXPECT_EQ(hand.count(ServoEvent::wrong_start), 0);
  hand.along(1, 0.03, 0.0565);
  EXPECT_TRUE(hand.done.empty());
  hand.go({hand.tip.x, hand.tip.y, 0.002}, 0.05);
  EXPECT_EQ(hand.done, (std::vector{1})) << "3.5 mm before the end, lifted: a sweep";
}

TEST(Lesson, APenThatLeavesTheTabletIsAsGoodAsLifted) {
  Hand hand(lesson());
  hand.over({-0.03, 0.03, 0});
  hand.go({-0.03, 0.03, -0.009});
  hand.along(1, 0, 0.0565);
  EXPECT_EQ(hand.at(hand.tip, false), Vec3(0));
  EXPECT_EQ(hand.done, (std::vector{1}));
  EXPECT_TRUE(has(hand.now().events, ServoEvent::release));
}

TEST(Lesson, ChangingTheStrengthGoesOnAndAnotherAttemptStartsAnew) {
  Hand hand(lesson());
  hand.write(1);
  hand.over({0, 0.02, 0});
  hand.go({0, 0.02, -0.009});
  hand.along(2, 0, 0.02);
  Guiding weaker = lesson(0.3);
  hand.guide(weaker);
  hand.rest(5);
  EXPECT_EQ(hand.now().guided_stroke, 2);
  EXPECT_EQ(hand.now().stroke, 2);
  EXPECT_NEAR(hand.now().progress_m, 0.02, 1e-4);
  weaker.attempt = 1;
  hand.guide(weaker);
  hand.rest(5);
  EXPECT_EQ(hand.now().guided_stroke, 1);
  EXPECT_EQ(hand.now().stroke, 0);
  EXPECT_EQ(hand.now().progress_m, 0);
}

TEST(Guidance, AtStrengthZeroTheForceIsThatOfTheSurfaceAlone) {
  for (const GuidingMode m : {GuidingMode::lesson, GuidingMode::lead, GuidingMode::disturb}) {
    Hand guided(mode(m, 0)), free(mode(GuidingMode::off));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-0.04, 0.04), high(-0.012, 0.006);
    for (int i = 0; i < 300; ++i) {
      const Vec3 to{any(random), any(random), high(random)};
      const Vec3 from = guided.tip;
      for (int k = 1; k <= 50; ++k) {
        const Vec3 p = from + (to - from) * (k / 50.0);
        ASSERT_EQ(guided.at(p), free.at(p));
      }
    }
    EXPECT_FALSE(has(guided.seen, ServoEvent::resisted)) << "what does not pull cannot be resisted";
  }
}

// Without the rest of the servo, because surface forces and braking may change faster.
TEST(Guidance, NeverStepsByMoreThanATwentiethOfANewtonNorPullsMoreThanItsCap) {
  const GuidancePlan plan(strokes(), 0.04);
  for (const GuidingMode m : {GuidingMode::lesson, GuidingMode::lead, GuidingMode::disturb}) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(0, 1);
    Guidance guidance;
    Guidance::Settings settings{m, 1, 1, 100, 1, 1};
    Vec3 tip{0, 0, 0.005}, before(0);
    double worst = 0, most = 0;
    int finished = 0;
    for (int i = 0; i < 3000; ++i) {
      if (i % 10 == 0) settings.strength = any(random);
      if (i % 50 == 0) settings.mode = i % 100 == 0 ? GuidingMode::off : m;
      if (i % 150 == 0) guidance.begin(plan, 1, Disturbance(static_cast<std::uint64_t>(i), kTick_s));
      // Mostly where the stroke to be written begins and along it, so that strokes are finished.
      const int stroke =
          any(random) < 0.8 ? std::max(1, guidance.stroke()) : 1 + static_cast<int>(3 * any(random));
      const double s = guidance.writing() ? guidance.progress_m() + 0.02 * any(random) - 0.004
                                          : (any(random) < 0.7 ? guidance.progress_m() : 0.1 * any(random));
      Vec3 to = plan.lines().at_length(stroke, s).point;
      to.z = any(random) < 0.2 ? 0.004 : -0.01 * any(random);
      const Vec3 from = tip;
      const int ticks = static_cast<int>(glm::length(to - from) / 1e-4) + 1;
      for (int k = 1; k <= ticks; ++k) {
        const Vec3 velocity = (to - from) / (ticks * kTick_s);
        tip = from + (to - from) * (static_cast<double>(k) / ticks);
        guidance.update(plan, settings, {tip, velocity, tip.z < -0.0095, kTick_s, Guidance::kMostStep_n});
        finished += guidance.done_stroke() != 0 ? 1 : 0;
        worst = std::max(worst, glm::length(guidance.force_n() - before));
        most = std::max(most, glm::length(guidance.force_n()));
        before = guidance.force_n();
        ASSERT_LE(guidance.granted_j(), 1.0 * 1e-4 + 1e-12) << "force x way";
      }
    }
    EXPECT_GT(finished, 20);
    EXPECT_LE(worst, 0.04 + 1e-12);
    EXPECT_LE(most, 1 + 1e-12);
    EXPECT_GT(most, 0.3);
  }
}

TEST(Lead, TheTeacherIsSlowAtTheStartTheCornerAndTheEndAndWaits) {
  Guiding g = mode(GuidingMode::lead);
  g.stroke = 3;
  Hand hand(g);
  hand.over({-0.03, 0, 0});
  hand.at({-0.03, 0, -0.0095});
  // A hand that is always at the target: its progress is the teacher's.
  std::vector<double> speed(100, 1);  // the slowest in each millimetre
  double last = hand.now().progress_m;
  double time = 0;
  while (hand.done.empty() && time < 20) {
    const Vec3 to = hand.now().guide_m;
    hand.at({to.x, to.y, -0.0095});
    time += kTick_s;
    const double v = (hand.now().progress_m - last) / kTick_s;
    last = hand.now().progress_m;
    if (v > 0 && hand.done.empty()) {
      double& slowest = speed[static_cast<std::size_t>(last / 0.001)];
      slowest = std::min(slowest, v);
    }
  }
  ASSERT_EQ(hand.done, (std::vector{3}));
  // Arc length 60 mm is the corner, 90 mm the end.
  EXPECT_NEAR(speed[30], 0.04, 1e-4);
  EXPECT_NEAR(speed[75], 0.04, 1e-4);
  // 90 degrees within 1.5 mm either way: a radius of 0.955 mm, and v = 40 mm/s cbrt(R / (R + 10 mm)).
  EXPECT_NEAR(std::min(speed[59], speed[60]), 0.04 * std::cbrt(0.955 / 10.955), 0.0015);
  // From a quarter of the speed at 0.25 m/s^2, and back to it: v^2 = v0^2 + 2 a s.
  for (const double s : {1, 2}) {
    const double v = std::sqrt(0.01 * 0.01 + 2 * 0.25 * 0.001 * s);
    EXPECT_NEAR(speed[static_cast<std::size_t>(s)], v, 0.001);
  }
  EXPECT_NEAR(speed[88], std::sqrt(0.01 * 0.01 + 2 * 0.25 * 0.0015), 0.001);
}

TEST(Lead, ALearnerWhoStandsStillIsPulledByAtMostTheCapAndThenNotAtAll) {
  for (const double cap : {0.8, 1.0, 7.0}) {
    Guiding g = mode(GuidingMode::lead);
    g.cap_n = cap;
    Hand hand(g);
    hand.over({-0.03, 0.03, 0});
    hand.go({-0.03, 0.03, -0.0095});
    double most = 0;
    int ticks = 0;
    for (; ticks < 3000 && hand.count(ServoEvent::resisted) == 0; ++ticks)
      most = std::max(most, hand.at(hand.tip).x);
    EXPECT_EQ(hand.count(ServoEvent::resisted), 1);
    EXPECT_LT(ticks, 2000);
    EXPECT_GT(most, 0.6);
    EXPECT_LE(most, std::min(cap, 1.0));
    EXPECT_NEAR(hand.rest(30).x, 0, 1e-9) << "within 30 ms of the event";
    EXPECT_NEAR(hand.rest(2000).x, 0, 1e-9) << "and it stays so";
    EXPECT_EQ(hand.count(ServoEvent::resumed), 0);
    hand.along(1, 0, 0.004, 0.0005);
    EXPECT_EQ(hand.count(ServoEvent::resumed), 1);
    EXPECT_LT(hand.at(hand.tip).x, 0.45) << "gently";
  }
}

TEST(Lead, PullingBackStopsItAtOnceAndSoDoesLifting) {
  for (const bool lift : {false, true}) {
    Hand hand(mode(GuidingMode::lead));
    hand.over({-0.03, 0.03, 0});
    hand.go({-0.03, 0.03, -0.0095});
    hand.along(1, 0, 0.03, 0.0005);
    hand.rest(120);
    ASSERT_EQ(hand.count(ServoEvent::resisted), 0);
    ASSERT_GT(hand.at(hand.tip).x, 0.2);
    const double since = hand.time_s;
    while (hand.count(ServoEvent::resisted) == 0 && hand.time_s < since + 1)
      hand.at(hand.tip + (lift ? Vec3(0, 0, 1e-4) : Vec3(-5e-5, 0, 0)));
    EXPECT_LT(hand.time_s - since, lift ? 0.11 : 0.05);
    hand.rest(30);
    EXPECT_NEAR(hand.rest(1).x, 0, 1e-9);
  }
}

TEST(Lead, StopsWhenTheStylusIsLostAndWhenATickIsLate) {
  for (const bool late : {false, true}) {
    Hand hand(mode(GuidingMode::lead));
    hand.over({-0.03, 0.03, 0});
    hand.go({-0.03, 0.03, -0.0095});
    hand.along(1, 0, 0.03, 0.0005);
    hand.rest(100);
    if (late) hand.time_s += 0.05;
    EXPECT_EQ(hand.at(hand.tip, late), Vec3(0));
    EXPECT_EQ(hand.count(ServoEvent::resisted), 1);
    EXPECT_LT(glm::length(hand.at(hand.tip)), 0.05);
  }
}

TEST(Disturbance, PushesOnlyWhileAStrokeIsWrittenAndIsTheSameForTheSameSeed) {
  const auto pushes = [](std::uint64_t seed) {
    Guiding g = mode(GuidingMode::disturb);
    g.seed = seed;
    Hand hand(g);
    EXPECT_EQ(hand.rest(500), Vec3(0));
    hand.over({-0.03, 0.03, 0});
    hand.go({-0.03, 0.03, -0.009});
    std::vector<Vec3> forces;
    for (int i = 0; i < 60'000; ++i) forces.push_back(hand.at({-0.01, 0.03, -0.005}));
    return forces;
  };
  const std::vector<Vec3> forces = pushes(5);
  EXPECT_EQ(forces, pushes(5));
  EXPECT_NE(forces, pushes(6));
  Vec3 sum(0);
  double most = 0, squares = 0;
  for (const Vec3& f : forces) {
    sum += f;
    most = std::max(most, glm::length(f));
    squares += glm::dot(f, f);
    EXPECT_EQ(f.z, 0);
  }
  const auto n = static_cast<double>(forces.size());
  EXPECT_LT(glm::length(sum) / n, 0.01 * 0.4) << "no mean";
  EXPECT_LE(most, 0.4);
  EXPECT_GT(std::sqrt(squares / n), 0.1) << "can be felt";
  // Band-limited: a discrete Fourier transform at frequencies outside 0.4..3 Hz finds nothing.
  for (const double hz : {0.1, 5.0, 20.0, 100.0}) {
    double re = 0, im = 0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const double turn = 2 * 3.14159265358979 * hz * kTick_s * static_cast<double>(i);
      re += forces[i].x * std::cos(turn);
      im += forces[i].x * std::sin(turn);
    }
    EXPECT_LT(2 * std::hypot(re, im) / n, 0.01) << hz;
  }
}

TEST(Guidance, NeverAllocatesInATick) {
  for (const GuidingMode m : {GuidingMode::lesson, GuidingMode::lead, GuidingMode::disturb}) {
    Hand hand(mode(m));
    hand.done.reserve(100);
    const test::AllocGuard guard;
    hand.over({-0.03, 0.03, 0});
    hand.go({-0.03, 0.03, -0.009});
    for (int i = 0; i < 20'000; ++i)
      hand.at({-0.03 + 0.05 * std::sin(0.001 * i), 0.03 * std::cos(0.0013 * i),
               -0.004 + 0.008 * std::sin(0.01 * i)});
    hand.at(hand.tip, false);
    EXPECT_EQ(guard.calls(), 0);
  }
}

}  // namespace
}  // namespace nazori::haptics
