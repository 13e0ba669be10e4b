// SPDX-License-Identifier: Apache-2.0
// The lesson: which stroke, where on it, right or wrong. The forces are in guidance_force.cpp.
#include "guidance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nazori::haptics {
namespace {

// The tip counts as down in contact or at this depth, and as up only well above: this avoids flicker at the
// plateau.
constexpr double kDown_m = 0.00025;
constexpr double kUp_m = 0.0005;

Vec3 from_above(const Vec3& p) noexcept { return {p.x, p.y, 0}; }

double end_reach(double length_m) noexcept { return std::min(Guidance::kEnd_m, 0.1 * length_m); }
double lifted_end_reach(double length_m) noexcept {
  return std::min(Guidance::kLiftedEnd_m, 0.25 * length_m);
}

}  // namespace

void Guidance::mark(ServoEvent event) noexcept {
  events_ = static_cast<std::uint16_t>(events_ | static_cast<std::uint16_t>(event));
}

void Guidance::begin(const GuidancePlan& plan, std::int32_t first, const Disturbance& disturbance) noexcept {
  disturbance_ = disturbance;
  must_lift_ = astray_ = false;
  stop_writing();
  offer(plan, first);
}

void Guidance::offer(const GuidancePlan& plan, std::int32_t from) noexcept {
  stroke_ = plan.stroke_from(from);
  reached_ = 0;
  stopped_ = false;
  gain_ = resisted_s_ = pulled_back_s_ = 0;
}

void Guidance::finish(const GuidancePlan& plan) noexcept {
  mark(ServoEvent::stroke_done);
  done_ = stroke_;
  must_lift_ = down_;
  stop_writing();
  offer(plan, stroke_ + 1);
  if (stroke_ == 0) mark(ServoEvent::lesson_done);
}

void Guidance::start_writing(const GuidancePlan& plan, const StrokeIndex::Hit& at,
                             const Vec3& from_above) noexcept {
  writing_ = true;
  hit_ = plan.lines().follow(from_above, at.segment);
  arc_ = wall_ = target_ = plan.lines().arc_length_m(hit_);
  going_back_ = false;
  gain_ = resisted_s_ = pulled_back_s_ = 0;
  new_way_ = true;
  if (stopped_) mark(ServoEvent::resumed);
  stopped_ = false;
}

void Guidance::stop_writing() noexcept {
  writing_ = false;
  new_way_ = true;
  off_ = 0;
}

void Guidance::stop() noexcept {
  if (stopped_) return;
  mark(ServoEvent::resisted);
  stopped_ = true;
  stopped_at_ = 0;
}

void Guidance::see_whether_down(const GuidancePlan& plan, const Input& in) noexcept {
  const bool came_down = known_ && !down_;
  if (in.touching || in.device_m.z < -kDown_m)
    down_ = true;
  else if (in.device_m.z > kUp_m)
    down_ = false;
  if (!down_) must_lift_ = astray_ = false;
  if (stroke_ == 0 || writing_ || !down_ || must_lift_) return;

  const Vec3 at = from_above(in.device_m);
  const double reach = start_reach_m(plan.length_m(stroke_));
  const StrokeIndex::Hit entry = plan.lines().at_length(stroke_, reached_);
  if (glm::length(at - entry.point) <= reach) {
    astray_ = false;
    start_writing(plan, entry, at);
    return;
  }
  if (!came_down) return;
  const StrokeIndex::Hit start = plan.lines().at_length(stroke_, 0);
  if (glm::length(at - start.point) <= reach) {  // written again
    reached_ = 0;
    start_writing(plan, start, at);
  } else if (plan.lines().nearest(at, kWrongReach_m).segment >= 0) {
    astray_ = true;
    mark(ServoEvent::wrong_start);
  }
}

void Guidance::track(const GuidancePlan& plan, const Settings& settings, const Vec3& device_m) noexcept {
  const double length = plan.length_m(stroke_);
  if (down_) {
    hit_ = plan.lines().follow(from_above(device_m), hit_.segment);
    off_ = std::sqrt(hit_.squared_m2);
  }
  if (!down_ || off_ > kLeave_m) {
    if (!down_ && length - reached_ <= lifted_end_reach(length)) {
      finish(plan);
      return;
    }
    stop_writing();
    if (settings.mode == GuidingMode::lead && settings.strength > 0) stop();
    return;
  }
  arc_ = plan.lines().arc_length_m(hit_);
  reached_ = std::max(reached_, arc_);
  wall_ = std::max(wall_, arc_);
  const double back = wall_ - arc_;
  if (back > kWrongWay_m && !going_back_) {
    going_back_ = true;
    mark(ServoEvent::wrong_direction);
  } else if (back < kSlack_m) {
    going_back_ = false;
  }
  if (length - reached_ <= end_reach(length)) finish(plan);
}

void Guidance::update(const GuidancePlan& plan, const Settings& settings, const Input& in) noexcept {
  events_ = 0;
  done_ = 0;
  guide_ = in.device_m;
  book(settings, in.device_m - last_);

  const bool was_writing = writing_;
  see_whether_down(plan, in);
  if (was_writing) track(plan, settings, in.device_m);
  last_ = in.device_m;
  known_ = true;

  Vec3 wanted(0);
  double most = settings.cap_n * settings.strength;
  if (settings.mode == GuidingMode::disturb) {
    disturbance_.advance();
    most = settings.disturbance_n * settings.strength;
    if (writing_) wanted = most * disturbance_.value();
  } else if (settings.mode != GuidingMode::off && stroke_ != 0) {
    wanted = writing_ ? write(plan, settings, in) : carry(plan, settings, in);
  }

  const double size = glm::length(wanted);
  if (size > most) wanted *= most / size;
  const Vec3 change = wanted - force_;
  const double step = glm::length(change);
  force_ = step > in.most_step_n ? force_ + change * (in.most_step_n / step) : wanted;
}

void Guidance::book(const Settings& settings, const Vec3& moved_m) noexcept {
  // A disturbance may use the work that its size and the motion of the hand allow; it cannot exceed that.
  if (settings.mode == GuidingMode::disturb) allowance_ = 1;
  const double work = glm::dot(force_, moved_m);
  granted_ = std::min(work, std::max(0.0, allowance_));
  allowance_ -= granted_;
}

void Guidance::lose(const GuidancePlan& plan, const Settings& settings, bool lifted) noexcept {
  events_ = 0;
  done_ = 0;
  granted_ = 0;
  const bool carried = !writing_ && stroke_ != 0 && glm::dot(force_, force_) > 0;
  force_ = Vec3(0);
  known_ = false;
  if (lifted) down_ = must_lift_ = false;
  astray_ = false;
  if (writing_) {
    const double length = plan.length_m(stroke_);
    if (lifted && length - reached_ <= lifted_end_reach(length)) {
      finish(plan);
    } else {
      stop_writing();
      if (settings.mode == GuidingMode::lead && settings.strength > 0) stop();
    }
  } else if (carried) {
    stop();
  }
}

}  // namespace nazori::haptics
