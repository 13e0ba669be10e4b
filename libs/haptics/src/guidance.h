// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "disturbance.h"
#include "guidance_plan.h"
#include "nazori/haptics/haptic_scene.h"
#include "nazori/haptics/servo.h"

namespace nazori::haptics {

/// Takes a learner through the strokes in their order: holds the stylus on the one to be written, lets it go
/// forwards only, leads it as a teacher would, carries it lifted to the next start, and says what was done
/// wrong.
///
/// Two states. *Carrying*: the tip is not writing; a field of force that depends on its place alone draws it
/// up, across and down to where the stroke begins or goes on. *Writing*: it came down there. The tip is
/// followed along the line as seen from above, so depth and kick do not matter for what is done.
///
/// What is wanted is a function of the tip's place and, in lead mode, of a target that only moves forwards
/// and waits. What is given follows it by at most kMostStep_n a tick and is never more than cap x strength,
/// so no event is felt as a jolt; strength 0 gives exactly none.
///
/// Thread-safe: no. Real-time-safe: yes.
/// @source lead, follow and jump between strokes: Y. Kim et al., five forces for writing training, 2013;
/// target that waits, cap: see docs/haptics.md. States and their conditions: own design.
class Guidance {
 public:
  static constexpr double kMostStep_n = 0.04;     ///< largest change of force in a tick
  static constexpr double kHover_m = 0.005;       ///< height above the plateau at which the tip is carried
  static constexpr double kCarry = 0.6;           ///< part of the cap that carries
  static constexpr double kStartReach_m = 0.004;  ///< as near as this, at most, counts as at the start
  static constexpr double kWrongReach_m = 0.004;  ///< as near as this to a stroke counts as on it
  static constexpr double kLeave_m = 0.007;       ///< farther than this from the line is off it
  static constexpr double kSlack_m = 0.001;       ///< going back this far is not noticed
  static constexpr double kWrongWay_m = 0.003;    ///< going back this far is the wrong direction
  static constexpr double kEnd_m = 0.0015;        ///< as near as this to the end is done
  static constexpr double kLiftedEnd_m = 0.005;   ///< as near as this, and lifted, too: a sweep leaves early

  /// In SI and within the device's limits.
  struct Settings {
    GuidingMode mode = GuidingMode::off;
    double strength = 0;
    double cap_n = 0;
    double stiffness_n_m = 0;
    double damping_n_s_m = 0;  ///< while carrying
    double disturbance_n = 0;
  };

  /// What a tick brings.
  struct Input {
    Vec3 device_m;
    Vec3 velocity_m_s;
    bool touching;       ///< contact with the surface
    double period_s;     ///< > 0
    double most_step_n;  ///< largest change of force in this tick, at most kMostStep_n
  };

  /// Starts anew at the first stroke with points from number `first` on. What was pulled fades out.
  void begin(const GuidancePlan& plan, std::int32_t first, const Disturbance& disturbance) noexcept;
  /// One tick. `plan` as it was at begin().
  void update(const GuidancePlan& plan, const Settings& settings, const Input& in) noexcept;
  /// The stylus is out of reach or the tick was bad: no force at once. What is led stops. @param lifted  the
  /// learner lifted it: near the end of a stroke that finishes it.
  void lose(const GuidancePlan& plan, const Settings& settings, bool lifted) noexcept;

  /// How near to the start of a stroke counts as at it: less for a dot, whose end is near too.
  [[nodiscard]] static double start_reach_m(double length_m) noexcept {
    return std::clamp(0.4 * length_m, 0.5 * kStartReach_m, kStartReach_m);
  }

  [[nodiscard]] const Vec3& force_n() const noexcept { return force_; }
  /// Work of its force since the last tick as far as it was allowed: what is to be left out of the servo's
  /// energy account. Each state begins with an allowance of force x way; leading adds cap x way of the
  /// target.
  [[nodiscard]] double granted_j() const noexcept { return granted_; }
  /// ServoEvent bits of the last update() or lose().
  [[nodiscard]] std::uint16_t events() const noexcept { return events_; }
  /// Stroke that was finished in it, 0 none.
  [[nodiscard]] std::int32_t done_stroke() const noexcept { return done_; }
  /// Stroke to be written, 0 none.
  [[nodiscard]] std::int32_t stroke() const noexcept { return stroke_; }
  /// It is being written.
  [[nodiscard]] bool writing() const noexcept { return writing_; }
  /// Furthest arc length of it that was reached.
  [[nodiscard]] double progress_m() const noexcept { return reached_; }
  /// Distance to its line while writing, seen from above.
  [[nodiscard]] double off_m() const noexcept { return off_; }
  /// Where the tip is wanted; the tip itself where nowhere.
  [[nodiscard]] const Vec3& guide_m() const noexcept { return guide_; }

 private:
  void mark(ServoEvent event) noexcept;
  void offer(const GuidancePlan& plan, std::int32_t from) noexcept;
  void finish(const GuidancePlan& plan) noexcept;
  void start_writing(const GuidancePlan& plan, const StrokeIndex::Hit& at, const Vec3& from_above) noexcept;
  void stop_writing() noexcept;
  void stop() noexcept;
  void see_whether_down(const GuidancePlan& plan, const Input& in) noexcept;
  void track(const GuidancePlan& plan, const Settings& settings, const Vec3& device_m) noexcept;
  void book(const Settings& settings, const Vec3& moved_m) noexcept;
  Vec3 write(const GuidancePlan& plan, const Settings& settings, const Input& in) noexcept;
  Vec3 lead(const GuidancePlan& plan, const Settings& settings, const Input& in) noexcept;
  Vec3 carry(const GuidancePlan& plan, const Settings& settings, const Input& in) noexcept;
  Vec3 yield(const Vec3& wanted, const Vec3& velocity_m_s, double most_n, double patience_s, double rise_s,
             double period_s) noexcept;
  Vec3 ahead(const GuidancePlan& plan) const noexcept;

  // The lesson.
  std::int32_t stroke_ = 0;
  double reached_ = 0;  // arc length
  bool writing_ = false;
  StrokeIndex::Hit hit_;      // while writing
  double arc_ = 0, off_ = 0;  // of it
  double wall_ = 0;           // while writing: furthest arc length since the tip came down
  double target_ = 0;         // lead mode: the teacher's arc length
  bool going_back_ = false;   // and said so

  // The tip.
  Vec3 last_{0, 0, 0};
  bool known_ = false;  // last_ says where the tip was
  bool down_ = false;
  bool must_lift_ = false;  // after a stroke, before the next
  bool astray_ = false;     // down in a wrong place

  // Giving way.
  bool stopped_ = false;
  double to_go_ = 0;       // way to what is wanted
  double stopped_at_ = 0;  // longest way to go since it stopped
  double resisted_s_ = 0, pulled_back_s_ = 0;
  double gain_ = 1;  // 0..1, rises after the learner comes along again

  Vec3 force_{0, 0, 0};
  double allowance_ = 0;  // [J] that force_ may still do, what was put into its springs among it
  bool new_way_ = true;   // the allowance is to be set
  double granted_ = 0;
  Vec3 guide_{0, 0, 0};
  Disturbance disturbance_;
  std::uint16_t events_ = 0;
  std::int32_t done_ = 0;
};

}  // namespace nazori::haptics
