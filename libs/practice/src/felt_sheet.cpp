// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/felt_sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "nazori/devices/simulated_device.h"

namespace nazori::practice {
namespace {

/// A mouse presses the hand of a simulated device as hard: about 4 mm deep.
constexpr double kMousePressure = 0.3;
/// Steps of the wetness that are told to the device.
constexpr double kWetnessStep = 0.1;
/// How far a held stylus may be above the paper and still be shown as a brush over it.
constexpr double kNear_m = 0.04;

/// The strokes of a hand as paths at the depth to which it presses.
std::vector<haptics::StrokePath> paths_of(std::span<const brush::PenSample> hand, double hair_m) {
  const double deepest_m = brush::Handling{}.full_depth * hair_m;
  std::vector<haptics::StrokePath> paths;
  bool was_down = false;
  for (const brush::PenSample& sample : hand) {
    if (sample.down) {
      if (!was_down) paths.emplace_back();
      paths.back().points.emplace_back(sample.at.x, sample.at.y, -deepest_m * sample.pressure.value_or(0.5));
    }
    was_down = sample.down;
  }
  std::erase_if(paths, [](const haptics::StrokePath& path) { return path.points.size() < 2; });
  return paths;
}

}  // namespace

FeltSheet::FeltSheet(base::Inbox& inbox, TabletControl& tablet, std::function<double()> now_s)
    : tablet_(tablet),
      now_s_(std::move(now_s)),
      sampled_(tablet.sampled.connect([this](auto samples) { follow(samples); })),
      changed_(tablet.device().changed.connect([this] {
        lose_pen();
        hand_over();
      })),
      pressed_(tablet.device().button_pressed.connect([this](int) {
        if (entered_) button_pressed();
      })),
      preparing_(
          "brush force", inbox,
          [](const brush::TuftForm& form, const auto&) {
            return std::make_shared<const brush::ForceTable>(form);
          },
          [this](Table table) {
            table_ = std::move(table);
            hand_over();
          }) {}

void FeltSheet::enter() {
  entered_ = true;
  hand_over();
}

void FeltSheet::leave() {
  if (!std::exchange(entered_, false)) return;
  lose_pen();
  led_.clear();
  tablet_.set_sheet(std::nullopt);
}

bool FeltSheet::has_no_hand() const {
  const auto* opened = tablet_.device().opened();
  return is_felt() && opened != nullptr &&
         dynamic_cast<const devices::SimulatedDevice*>(opened->device.get()) != nullptr;
}

void FeltSheet::move_hand(geometry::PaperPoint at, bool is_down, std::optional<double> pressure) {
  tablet_.move_stylus({at.x, at.y}, is_down, pressure.value_or(kMousePressure));
}

void FeltSheet::set_brush(const brush::TuftForm& form) { preparing_.request(form); }

void FeltSheet::set_wetness(double wetness) {
  if (!(std::abs(wetness - wetness_) >= kWetnessStep)) return;
  wetness_ = std::clamp(wetness, 0.0, 1.0);
  hand_over();
}

void FeltSheet::set_feel(brush::Feel feel) {
  if (std::exchange(feel_, feel) != feel) hand_over();
}

void FeltSheet::set_tilt(double lean_rad, double lean_to_rad) {
  lean_to_rad_ = lean_to_rad;
  if (std::exchange(lean_rad_, lean_rad) != lean_rad) hand_over();
}

bool FeltSheet::lead(std::span<const brush::PenSample> hand) {
  if (!is_felt() || !table_) return false;
  led_ = paths_of(hand, table_->form().hair_m);
  ++led_times_;
  hand_over();
  return is_leading();
}

void FeltSheet::stop_leading() {
  if (led_.empty()) return;
  led_.clear();
  hand_over();
}

void FeltSheet::hand_over() {
  if (!entered_) return;
  FlatSheet sheet;
  if (table_)
    sheet.tip = std::make_shared<const haptics::SoftTip>(soft_tip(*table_, lean_rad_, wetness_, feel_));
  sheet.led = led_;
  sheet.led_times = led_times_;
  tablet_.set_sheet(std::move(sheet));
}

void FeltSheet::lose_pen() {
  if (std::exchange(is_down_, false)) pen_lost();
}

void FeltSheet::follow(std::span<const haptics::ServoSample> samples) {
  if (!is_felt() || samples.empty()) return;
  // While a stroke is written its clock runs evenly.
  if (!is_down_) later_s_ = now_s_() - samples.back().begun_s;
  bool is_done = false;
  for (const haptics::ServoSample& sample : samples) {
    // A late tick says nothing of the hand.
    if (haptics::has(sample.events, haptics::ServoEvent::fault)) continue;
    move(sample);
    is_done = is_done || haptics::has(sample.events, haptics::ServoEvent::lesson_done);
  }
  const haptics::Vec3& at = samples.back().device_m;
  if (at.z < kNear_m) pointed({at.x, at.y});
  if (!is_done || led_.empty()) return;
  stop_leading();
  led();
}

void FeltSheet::move(const haptics::ServoSample& sample) {
  const bool is_down = sample.device_m.z < 0;
  const bool was_down = std::exchange(is_down_, is_down);
  if (!is_down && !was_down) return;
  if (is_down && was_down && ++since_ < kEvery) return;
  since_ = 0;
  brush::PenSample pen;
  pen.time_s = sample.begun_s + later_s_;
  pen.at = {sample.device_m.x, sample.device_m.y};
  pen.down = is_down;
  pen.height_m = sample.device_m.z;
  pen.lean_rad = lean_rad_;
  pen.lean_to_rad = lean_to_rad_;
  pen_moved(pen);
}

}  // namespace nazori::practice
