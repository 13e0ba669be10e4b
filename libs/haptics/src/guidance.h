// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "disturbance.h"
#include "guidance_plan.h"
#include "nazori/haptics/haptic_scene.h"
#include "nazori/haptics/servo.h"

namespace nazori::haptics {

/// Takes a learner through the strokes in their order: it pulls the stylus to the stroke to be written, lets
/// it move only forwards, leads it as a teacher would, carries the lifted stylus to the next start, and
/// reports mistakes.
///
/// Two states. *Carrying*: the tip is not writing; a force field that depends only on its position draws it
/// up, across and down to where the stroke begins or continues. *Writing*: the tip came down there. It is
/// followed along the line as seen from above, so depth and hook do not matter for the progress.
///
/// The wanted force is a function of the tip's position and, in lead mode, of a target that only moves
/// forwards and waits. The actual force follows it by at most kMostStep_n per tick and is never more than cap
/// x strength, so no event is felt as a jolt; strength 0 gives exactly no force.
///
/// Thread-safe: no. Real-time-safe: yes.
/// @source lead, follow and jump between strokes: Y. Kim et al., five forces for writing training, 2013;
/// target that waits, cap: see docs/haptics.md. States and their conditions: own design.
class Guidance {
 public:
  static constexpr double kMostStep_n = 0.04;  ///< largest change of force in a tick
  static constexpr double kHover_m = 0.005;    ///< height above the plateau at which the tip is carried
  static constexpr double kCarry = 0.6;        ///< part of the cap that is used for carrying
  static constexpr double kStartReach_m =
      0.004;  ///< within at most this distance the tip counts as at the start
  static constexpr double kWrongReach_m =
      0.004;                                    ///< within this distance of a stroke the tip counts as on it
  static constexpr double kLeave_m = 0.007;     ///< farther than this from the line is off it
  static constexpr double kSlack_m = 0.001;     ///< going back this far is ignored
  static constexpr double kWrongWay_m = 0.003;  ///< going back this far is the wrong direction
  static constexpr double kEnd_m = 0.0015;      ///< within this distance of the end the stroke is done
  static constexpr double kLiftedEnd_m =
      0.005;  ///< within this distance and lifted it is done, too: in a sweep the tip is lifted early

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

  /// Starts at the first stroke with points from number `first` on. The present pull fades out.
  void begin(const GuidancePlan& plan, std::int32_t first, const Disturbance& disturbance) noexcept;
  /// One tick. `plan` is the same as at begin().
  void update(const GuidancePlan& plan, const Settings& settings, const Input& in) noexcept;
  /// The stylus is out of reach or the tick was bad: sets the force to zero at once. Leading stops. @param
  /// lifted  the learner lifted the stylus: near the end of a stroke this finishes it.
  void lose(const GuidancePlan& plan, const Settings& settings, bool lifted) noexcept;

  /// The distance from the start of a stroke that counts as at the start: shorter for a dot, whose end is
  /// near, too.
  [[nodiscard]] static double start_reach_m(double length_m) noexcept {
    return std::clamp(0.4 * length_m, 0.5 * kStartReach_m, kStartReach_m);
  }

  [[nodiscard]] const Vec3& force_n() const noexcept { return force_; }
  /// Allowed work of its force since the last tick, which is left out of the servo's energy balance. Each
  /// state begins with an allowance of force x distance; leading adds cap x the distance of the target.
  [[nodiscard]] double granted_j() const noexcept { return granted_; }
  /// ServoEvent bits of the last update() or lose().
  [[nodiscard]] std::uint16_t events() const noexcept { return events_; }
  /// Stroke that was finished in that tick, 0 none.
  [[nodiscard]] std::int32_t done_stroke() const noexcept { return done_; }
  /// Stroke to be written, 0 none.
  [[nodiscard]] std::int32_t stroke() const noexcept { return stroke_; }
  /// It is being written.
  [[nodiscard]] bool writing() const noexcept { return writing_; }
  /// Furthest arc length of it that was reached.
  [[nodiscard]] double progress_m() const noexcept { return reached_; }
  /// Distance to its line while writing, seen from above.
  [[nodiscard]] double off_m() const noexcept { return off_; }
  /// The target of the tip; the tip itself without a target.
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
  bool going_back_ = false;   // and it was reported

  // The tip.
  Vec3 last_{0, 0, 0};
  bool known_ = false;  // last_ is the previous position of the tip; else there is no force
  bool down_ = false;
  bool must_lift_ = false;  // after a stroke, before the next
  bool astray_ = false;     // the tip is down in a wrong place

  // Giving way.
  bool stopped_ = false;
  double to_go_ = 0;       // distance to the target
  double stopped_at_ = 0;  // longest to_go_ since it stopped
  double resisted_s_ = 0, pulled_back_s_ = 0;
  double gain_ = 1;  // 0..1, rises after the learner follows again

  Vec3 force_{0, 0, 0};
  double allowance_ = 0;  // [J] work that force_ may still do, including the energy put into its springs
  bool new_way_ = true;   // the allowance has to be set
  double granted_ = 0;
  Vec3 guide_{0, 0, 0};
  Disturbance disturbance_;
  std::uint16_t events_ = 0;
  std::int32_t done_ = 0;
};

}  // namespace nazori::haptics
