// SPDX-License-Identifier: Apache-2.0
#include "sdl_feedback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "nazori/haptics/servo.h"
#include "standins/sdl_standin.h"

namespace nazori::devices::sdl {
namespace {

using haptics::ServoEvent;
using standin::Stick;
using standin::StickController;

class Feedback : public testing::Test {
 protected:
  std::shared_ptr<Stick> stick = std::make_shared<Stick>();
  StickController controller{stick};

  [[nodiscard]] ForceEffects effects(const Abilities& abilities) {
    auto made = ForceEffects::create(controller, abilities);
    EXPECT_TRUE(made);
    return std::move(*made);
  }
  static Wish push(double right, double up) { return {true, 0, 0, right, up, false, 0}; }
  static Wish told(ServoEvent event) { return {true, 0, 0, 0, 0, true, static_cast<std::uint16_t>(event)}; }
};

TEST_F(Feedback, APushComesFromTheOtherSide) {
  ForceEffects force = effects(standin::kForceStick);
  double now_s = 0;
  for (const auto& [right, up] : {std::pair{0.5, 0.0}, {-0.5, 0.0}, {0.0, 0.5}, {0.0, -0.5}, {0.3, -0.4}}) {
    EXPECT_TRUE(force.apply(push(right, up), now_s += 1));
    EXPECT_NEAR(stick->push_right(), right, 1e-4);
    EXPECT_NEAR(stick->push_up(), up, 1e-4);
  }
  // SDL_haptic.h: a force that comes from the south has the direction (0, 1).
  EXPECT_TRUE(force.apply(push(0, 1), now_s + 1));
  const SDL_HapticConstant c = stick->effect(SDL_HAPTIC_CONSTANT).what.constant;
  EXPECT_EQ(c.direction.type, SDL_HAPTIC_CARTESIAN);
  EXPECT_EQ(c.direction.dir[0], 0);
  EXPECT_GT(c.direction.dir[1], 0);
  EXPECT_EQ(c.level, 32767);
}

TEST_F(Feedback, APushBeyondTheFullForceKeepsItsDirection) {
  ForceEffects force = effects(standin::kForceStick);
  EXPECT_TRUE(force.apply(push(30, 40), 1));
  EXPECT_NEAR(stick->push_right(), 0.6, 1e-4);
  EXPECT_NEAR(stick->push_up(), 0.8, 1e-4);
  EXPECT_TRUE(force.apply(push(std::nan(""), 0), 2));
  EXPECT_FALSE(stick->anything_runs());
}

TEST_F(Feedback, OnlyChangesAreToldAndAtMostAHundredASecond) {
  ForceEffects force = effects(standin::kForceStick);
  for (int ms = 0; ms < 1000; ++ms) EXPECT_TRUE(force.apply(push(0.5, 0.2), ms * 0.001));
  EXPECT_EQ(stick->effect(SDL_HAPTIC_CONSTANT).updates, 1);
  EXPECT_EQ(stick->effect(SDL_HAPTIC_CONSTANT).runs,
            3);  // at 0, 0.4 and 0.8 s, before it would end by itself
  // A hundredth more every 25 ms.
  for (int ms = 1000; ms < 2000; ++ms) EXPECT_TRUE(force.apply(push(0.0004 * (ms - 1000), 0.5), ms * 0.001));
  EXPECT_NEAR(stick->effect(SDL_HAPTIC_CONSTANT).updates, 1 + 40, 2);
  EXPECT_EQ(stick->effect(SDL_HAPTIC_CONSTANT).what.constant.length, 1000U);
}

TEST_F(Feedback, AForceThatNeverRestsIsToldAHundredTimesASecond) {
  ForceEffects force = effects(standin::kForceStick);
  for (int ms = 0; ms < 1000; ++ms) EXPECT_TRUE(force.apply(push(ms * 7 % 100 / 100.0, 0.5), ms * 0.001));
  EXPECT_LE(stick->effect(SDL_HAPTIC_CONSTANT).updates, 101);
  EXPECT_GE(stick->effect(SDL_HAPTIC_CONSTANT).updates, 90);
}

TEST_F(Feedback, LessThanAHundredthOfTheFullForceIsNone) {
  ForceEffects force = effects(standin::kForceStick);
  EXPECT_TRUE(force.apply(push(0.006, 0.007), 1));
  EXPECT_FALSE(stick->anything_runs());
  EXPECT_TRUE(force.apply(push(0.008, 0.007), 2));
  EXPECT_TRUE(stick->anything_runs());
  EXPECT_TRUE(force.apply(push(0.006, 0.007), 2.001));
  EXPECT_FALSE(stick->anything_runs());
}

TEST_F(Feedback, LettingGoIsToldAtOnce) {
  ForceEffects force = effects(standin::kForceStick);
  Wish wish = push(0.5, 0);
  wish.pressed = true;
  EXPECT_TRUE(force.apply(wish, 1));
  EXPECT_TRUE(stick->effect(SDL_HAPTIC_DAMPER).running);
  wish.on = false;
  EXPECT_TRUE(force.apply(wish, 1.0001));
  EXPECT_FALSE(stick->anything_runs());
}

TEST_F(Feedback, ThePenIsHeldBackOnlyWhilePressedDown) {
  ForceEffects force = effects(standin::kForceStick);
  Wish wish = push(0, 0);
  EXPECT_TRUE(force.apply(wish, 1));
  EXPECT_FALSE(stick->anything_runs());
  wish.pressed = true;
  EXPECT_TRUE(force.apply(wish, 2));
  EXPECT_TRUE(stick->effect(SDL_HAPTIC_DAMPER).running);
  EXPECT_EQ(stick->effect(SDL_HAPTIC_DAMPER).updates, 0);
  const SDL_HapticCondition drag = stick->effect(SDL_HAPTIC_DAMPER).what.condition;
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_EQ(drag.right_coeff[axis], drag.left_coeff[axis]);
    EXPECT_NEAR(drag.right_coeff[axis] / 32767.0, 0.1875, 0.02) << "a little: three sixteenths";
    EXPECT_EQ(drag.right_sat[axis], 0xFFFF);
    EXPECT_EQ(drag.left_sat[axis], 0xFFFF);
  }
  EXPECT_EQ(drag.length, 1000U);
  wish.pressed = false;
  EXPECT_TRUE(force.apply(wish, 3));
  EXPECT_FALSE(stick->anything_runs());
}

TEST_F(Feedback, AWheelPushesAlongItsOneAxis) {
  ForceEffects force = effects(standin::kWheel);
  EXPECT_TRUE(force.apply(push(-0.25, 0.9), 1));
  EXPECT_NEAR(stick->push_right(), -0.25, 1e-4);
  EXPECT_EQ(stick->push_up(), 0);
}

TEST_F(Feedback, ADeviceWithSpringsOnlyIsPulledToWhereTheForceWouldBring) {
  ForceEffects force = effects({SDL_HAPTIC_SPRING, 2, false, false});
  EXPECT_TRUE(force.apply({true, 0.25, 0.5, 0.25, -0.25, true, 0}, 1));
  const Stick::Effect spring = stick->effect(SDL_HAPTIC_SPRING);
  EXPECT_TRUE(spring.running);
  EXPECT_NEAR(spring.what.condition.center[0] / 32767.0, 0.5, 1e-4);
  EXPECT_NEAR(spring.what.condition.center[1] / 32767.0, -0.25, 1e-4);  // SDL's y is down
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_EQ(spring.what.condition.right_coeff[axis], 32767);
    EXPECT_EQ(spring.what.condition.left_coeff[axis], 32767);
  }
  EXPECT_TRUE(force.apply({true, 0.8, -0.8, 0.5, -0.5, true, 0}, 2));
  const SDL_HapticCondition at_the_edge = stick->effect(SDL_HAPTIC_SPRING).what.condition;
  EXPECT_EQ(at_the_edge.center[0], 32767);
  EXPECT_EQ(at_the_edge.center[1], 32767);
}

TEST_F(Feedback, ARefusedEffectIsToldAndTriedAgain) {
  ForceEffects force = effects(standin::kWheel);
  stick->refuses_effects = true;
  for (int ms = 0; ms < 50; ++ms) EXPECT_FALSE(force.apply(push(0.5, 0), ms * 0.001)) << ms;
  stick->refuses_effects = false;
  EXPECT_TRUE(force.apply(push(0.5, 0), 0.06));
  EXPECT_NEAR(stick->push_right(), 0.5, 1e-4);
  stick->refuses_effects = true;
  const auto none = ForceEffects::create(controller, standin::kWheel);
  ASSERT_FALSE(none);
  EXPECT_NE(base::to_line(none.error()).find("close other programs"), std::string::npos);
}

TEST_F(Feedback, NothingIsLeftOnTheDevice) {
  {
    ForceEffects force = effects(standin::kForceStick);
    EXPECT_TRUE(force.apply(push(0.5, 0), 1));
    EXPECT_EQ(stick->effects.size(), 2U);
  }
  EXPECT_TRUE(stick->effects.empty());
}

TEST_F(Feedback, APadTellsStrokesAndMistakesApart) {
  RumbleCues rumble(controller);
  rumble.apply(told(ServoEvent::capture), 1);
  const std::uint16_t tap = stick->high;
  EXPECT_GT(tap, 0);
  EXPECT_EQ(stick->low, 0);
  rumble.apply(push(0, 0), 1.1);
  EXPECT_FALSE(stick->anything_runs());
  rumble.apply(told(ServoEvent::stroke_done), 2);
  EXPECT_GT(stick->high, tap);
  EXPECT_EQ(stick->low, 0);
  rumble.apply(told(ServoEvent::wrong_direction), 2.1);  // a mistake replaces the signal of a finished stroke
  EXPECT_GT(stick->low, 0);
  rumble.apply(told(ServoEvent::capture), 2.2);  // a tap does not shorten it
  EXPECT_GT(stick->low, 0);
  rumble.apply(push(0, 0), 2.4);
  EXPECT_FALSE(stick->anything_runs());
}

TEST_F(Feedback, ACueLastsItsTimeAndGivesWayOnlyToOneThatMattersAsMuch) {
  struct Cue {
    ServoEvent event;
    int length_ms;
    bool low;
  };
  // Each kind replaces the kinds before it, but not its own.
  const std::vector<std::vector<Cue>> ranks{
      {{ServoEvent::capture, 60, false}, {ServoEvent::release, 60, false}},
      {{ServoEvent::stroke_done, 180, false}},
      {{ServoEvent::lesson_done, 400, true}},
      {{ServoEvent::wrong_start, 250, true}, {ServoEvent::wrong_direction, 250, true}}};
  double now_s = 0;
  for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
    for (const Cue& cue : ranks[rank]) {
      RumbleCues rumble(controller);
      rumble.apply(told(cue.event), now_s += 10);
      EXPECT_GT(stick->high, 0);
      EXPECT_EQ(stick->low > 0, cue.low);
      const std::uint16_t high = stick->high;
      rumble.apply(push(0, 0), now_s + cue.length_ms * 0.001 - 0.002);
      EXPECT_EQ(stick->high, high) << cue.length_ms;
      rumble.apply(push(0, 0), now_s + cue.length_ms * 0.001 + 0.002);
      EXPECT_FALSE(stick->anything_runs()) << cue.length_ms;
      for (std::size_t other = 0; other < ranks.size(); ++other) {
        for (const Cue& next : ranks[other]) {
          rumble.apply(told(next.event), now_s += 10);
          const std::uint16_t next_high = stick->high;
          rumble.apply(push(0, 0), now_s += 10);
          rumble.apply(told(cue.event), now_s += 10);
          rumble.apply(told(next.event), now_s + 0.02);
          EXPECT_EQ(stick->high, other >= rank ? next_high : high) << rank << " " << other;
          rumble.apply(push(0, 0), now_s += 10);
        }
      }
    }
  }
}

TEST_F(Feedback, AMistakeIsTheStrongestCueAndALostHoldTheWeakest) {
  RumbleCues rumble(controller);
  double now_s = 0;
  int last = 0;
  for (const ServoEvent event :
       {ServoEvent::release, ServoEvent::capture, ServoEvent::stroke_done, ServoEvent::lesson_done}) {
    rumble.apply(told(event), now_s += 10);
    EXPECT_GT(stick->high, last);
    last = stick->high;
    rumble.apply(push(0, 0), now_s += 10);
  }
  rumble.apply(told(ServoEvent::lesson_done), now_s += 10);
  const int lesson = stick->low;
  rumble.apply(push(0, 0), now_s += 10);
  for (const ServoEvent mistake : {ServoEvent::wrong_start, ServoEvent::wrong_direction}) {
    rumble.apply(told(mistake), now_s += 10);
    EXPECT_EQ(stick->low, stick->high) << "both motors alike";
    EXPECT_GT(stick->low, lesson);
    EXPECT_GE(stick->high, last);
    rumble.apply(push(0, 0), now_s += 10);
  }
}

TEST_F(Feedback, ACueThatWasLetGoDoesNotComeBack) {
  RumbleCues rumble(controller);
  rumble.apply(told(ServoEvent::wrong_start), 1);
  rumble.apply({}, 1.05);
  EXPECT_FALSE(stick->anything_runs());
  rumble.apply(push(0, 0), 1.1);
  EXPECT_FALSE(stick->anything_runs());
  Wish off = told(ServoEvent::wrong_start);
  off.on = false;
  rumble.apply(off, 1.2);
  rumble.apply(push(0, 0), 1.25);
  EXPECT_FALSE(stick->anything_runs());
}

TEST_F(Feedback, TheHumGoesInSixteenthsAndBelowACueItIsTheStronger) {
  RumbleCues rumble(controller);
  double now_s = 0;
  for (const auto& [part, low] :
       {std::pair{0.06, 0}, {0.063, 0x600}, {0.52, 0x3000}, {0.99, 0x5A00}, {1.0, 0x6000}, {7.0, 0x6000}}) {
    rumble.apply(push(0, part), now_s += 1);
    EXPECT_EQ(stick->low, low) << part;
  }
  rumble.apply(push(std::nan(""), 0), now_s += 1);
  EXPECT_FALSE(stick->anything_runs());
  Wish both = told(ServoEvent::lesson_done);
  both.push_x = 1;
  rumble.apply(both, now_s += 1);
  EXPECT_EQ(stick->low, 0x6000);
}

TEST_F(Feedback, AWallHumsAsHardAsItPushes) {
  RumbleCues rumble(controller);
  rumble.apply(push(0.2, 0), 1);
  const std::uint16_t soft = stick->low;
  rumble.apply(push(0, -0.9), 2);
  EXPECT_GT(soft, 0);
  EXPECT_GT(stick->low, 3 * soft);
  EXPECT_EQ(stick->high, 0);
  rumble.apply({}, 2.0001);
  EXPECT_FALSE(stick->anything_runs());
}

TEST_F(Feedback, RumbleThatWasToldAtTheVeryStartIsNotToldAgainWithinAHundredthOfASecond) {
  RumbleCues rumble(controller);
  rumble.apply(push(0.25, 0), 0);
  EXPECT_EQ(stick->rumbles, 1);
  rumble.apply(push(0.75, 0), 0.009);
  EXPECT_EQ(stick->rumbles, 1);
  rumble.apply(push(0.75, 0), 0.011);
  EXPECT_EQ(stick->rumbles, 2);
}

TEST_F(Feedback, RumbleIsToldOnChangeAtMostAHundredTimesASecond) {
  RumbleCues rumble(controller);
  for (int ms = 0; ms < 1000; ++ms) rumble.apply(push(0.5, 0), ms * 0.001);
  EXPECT_EQ(stick->rumbles, 3);
  for (int ms = 1000; ms < 2000; ++ms) rumble.apply(push(ms % 2 == 0 ? 0.2 : 0.8, 0), ms * 0.001);
  EXPECT_LE(stick->rumbles, 103);
}

}  // namespace
}  // namespace nazori::devices::sdl
