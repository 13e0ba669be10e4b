// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/devices/rt_thread.h"
#include "nazori/devices/simulated_device.h"
#include "nazori/haptics/haptic_scene.h"
#include "nazori/haptics/servo.h"

namespace nazori::devices {

/// How a learner's hand moves that does not look closely.
struct HandHabits {
  double speed_m_s = 0.05;   ///< along a stroke, once under way; > 0
  double wander_m = 0.0008;  ///< how far off the line the hand strays, root mean square
  double press_m = 0.006;    ///< how far below the groove's floor the hand wants to be
  double hover_m = 0.006;    ///< above the plateau between strokes
};

/// How well the tablet held the hand along one stroke. Distances from the line are seen from above.
struct FollowedStroke {
  int stroke = 0;  ///< its number, from 1
  double length_m = 0;
  double duration_s = 0;
  double aim_rms_m = 0;  ///< how far off the line the hand wanted to be
  double aim_max_m = 0;
  double tip_rms_m = 0;  ///< how far off the line the tip was held while it touched
  double tip_max_m = 0;
  double mean_force_n = 0;  ///< that the servo sent, and its peak
  double peak_force_n = 0;
  double contact_share = 0;   ///< of the ticks
  double snapped_share = 0;   ///< of the ticks in which this stroke held the stylus
  double mean_depth_m = 0;    ///< of the tip below the plateau while it touched
  int slips = 0;              ///< how often the tip went astray and the hand had to lift and come back
  double followed_share = 0;  ///< of the stroke's length, 0..1
};

/// What came of following all strokes.
struct HandReport {
  std::vector<FollowedStroke> strokes;
  double work_on_hand_j = 0;  ///< that the device's motors did at the tip; negative: the tablet took energy
  haptics::ServoTiming timing;
  double p999_tick_s = 0;      ///< 99.9 % of the ticks took no longer, to within 3 %
  double p999_lateness_s = 0;  ///< 99.9 % began no later after their due time, with HandClock::real_time
  ClockStatus clock;           ///< of the clock thread, with HandClock::real_time
};

/// What makes the ticks of a simulated hand's device.
enum class HandClock : std::uint8_t {
  none,       ///< they follow each other without waiting, and the result is the same every time
  real_time,  ///< the clock thread, as a device does
};

/// Is shown every sample of the servo that a simulated hand moves at.
class HandObserver {
 public:
  virtual ~HandObserver() = default;
  /// After each tick. Thread: the one that ticks. Must neither allocate, lock, throw nor wait.
  virtual void see(const haptics::ServoSample& sample) noexcept = 0;
};

/// A learner's hand at a simulated device: follows strokes one after the other as HandHabits say, and is held
/// by what the servo makes it feel. It sees when the tip has slipped into another groove, lifts it and puts
/// it back. It pulls harder where friction holds the tip back. For each stroke it sets the scene of that
/// stroke, as a learner does who steps through the strokes.
///
/// Thread rules: one thread, but for HandObserver.
class SimulatedHand {
 public:
  /// @param strokes   centre lines in the tablet frame, z the depth of the groove there (<= 0). One without
  /// points is a dot in the middle of the tablet.
  /// @param scenes    what is felt while stroke n, from 1, is followed or gone to, at [n]; at [0] where there
  /// is no stroke: one more than strokes.
  /// @param observer  null, or outlives this.
  SimulatedHand(std::span<const haptics::StrokePath> strokes,
                std::vector<std::shared_ptr<const haptics::HapticScene>> scenes,
                const SimulatedHardware& hardware, HandObserver* observer = nullptr,
                const HandHabits& habits = {});
  ~SimulatedHand();
  SimulatedHand(const SimulatedHand&) = delete;
  SimulatedHand& operator=(const SimulatedHand&) = delete;

  /// The device at which the hand is.
  [[nodiscard]] haptics::DeviceDescription describe() const;
  /// The servo, to record what it does.
  [[nodiscard]] haptics::Servo& servo();

  /// Follows all strokes, once for an object.
  /// @param go_on  called now and then on this thread with what is done, 0..1, without a clock between two
  /// ticks; false stops.
  /// @return whether the strokes were followed to their end: false where go_on said no. The errors of the
  /// clock thread.
  [[nodiscard]] base::Result<bool> run(HandClock clock, const std::function<bool(double done)>& go_on);

  /// What came of it. After run().
  [[nodiscard]] HandReport report() const;

 private:
  class Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::devices
