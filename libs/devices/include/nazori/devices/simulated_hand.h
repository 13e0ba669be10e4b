// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/devices/rt_thread.h"
#include "nazori/devices/simulated_device.h"
#include "nazori/haptics/haptic_scene.h"
#include "nazori/haptics/servo.h"

namespace nazori::devices {

/// The movements of a learner who does not look closely.
struct HandHabits {
  double speed_m_s = 0.05;   ///< along a stroke, after speeding up; > 0
  double wander_m = 0.0008;  ///< how far off the line the hand strays, root mean square
  double press_m = 0.006;    ///< how far below the groove's floor the hand aims
  double hover_m = 0.006;    ///< above the plateau between strokes
};

/// How well the tablet kept the hand on one stroke. Distances from the line are measured from above.
struct FollowedStroke {
  int stroke = 0;  ///< its number, from 1
  double length_m = 0;
  double duration_s = 0;
  double aim_rms_m = 0;  ///< distance of the hand's target from the line
  double aim_max_m = 0;
  double tip_rms_m = 0;  ///< distance of the tip from the line during contact
  double tip_max_m = 0;
  double mean_force_n = 0;  ///< force that the servo sent: mean and peak
  double peak_force_n = 0;
  double contact_share = 0;   ///< of the ticks
  double snapped_share = 0;   ///< share of the ticks in which this stroke attracted the stylus
  double mean_depth_m = 0;    ///< of the tip below the plateau during contact
  int slips = 0;              ///< how often the tip left the stroke and the hand had to lift and come back
  double followed_share = 0;  ///< of the stroke's length, 0..1
};

/// The result of following all strokes.
struct HandReport {
  std::vector<FollowedStroke> strokes;
  double work_on_hand_j =
      0;  ///< work of the device's motors at the tip; negative: the tablet absorbed energy
  haptics::ServoTiming timing;
  double p999_tick_s = 0;      ///< 99.9 % of the ticks took no longer, to within 3 %
  double p999_lateness_s = 0;  ///< 99.9 % of the ticks were no later than this, with HandClock::real_time
  ClockStatus clock;           ///< of the clock thread, with HandClock::real_time
};

/// The source of the ticks of a simulated hand's device.
enum class HandClock : std::uint8_t {
  none,       ///< they follow each other without waiting, and the result is the same every time
  real_time,  ///< the clock thread, as with a real device
};

/// Receives every sample of the servo of a simulated hand.
class HandObserver {
 public:
  virtual ~HandObserver() = default;
  /// After each tick. Thread: the one that ticks. Must not allocate, lock, throw or wait.
  virtual void see(const haptics::ServoSample& sample) noexcept = 0;
};

/// A learner's hand at a simulated device. It follows strokes one after the other with the given HandHabits,
/// under the forces of the servo. When the tip has slipped into another groove, the hand lifts it and puts it
/// back. It pulls harder where friction stops the tip. For each stroke it sets the scene of that stroke, like
/// a learner who steps through the strokes.
///
/// Thread rules: one thread, but for HandObserver.
class SimulatedHand {
 public:
  /// @param strokes   centre lines in the tablet frame, z the depth of the groove there (<= 0). One without
  ///   points is a dot in the middle of the tablet.
  /// @param scenes    [n] is the scene while the hand follows stroke n, from 1, or goes to it; [0] is the
  ///   scene without a stroke. One more than strokes.
  /// @param observer  null, or outlives this.
  SimulatedHand(std::span<const haptics::StrokePath> strokes,
                std::vector<std::shared_ptr<const haptics::HapticScene>> scenes,
                const SimulatedHardware& hardware, HandObserver* observer = nullptr,
                const HandHabits& habits = {});
  ~SimulatedHand();
  SimulatedHand(const SimulatedHand&) = delete;
  SimulatedHand& operator=(const SimulatedHand&) = delete;

  /// The device that the hand holds.
  [[nodiscard]] haptics::DeviceDescription describe() const;
  /// The servo, to record what it does.
  [[nodiscard]] haptics::Servo& servo();

  /// Follows all strokes, once per object.
  /// @param progress  called from time to time on this thread; without a clock, between two ticks.
  /// @return Errc::cancelled where `progress` stopped it; the errors of the clock thread.
  [[nodiscard]] base::Result<void> run(HandClock clock, const base::Progress& progress);

  /// The result, after run().
  [[nodiscard]] HandReport report() const;

 private:
  class Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::devices
