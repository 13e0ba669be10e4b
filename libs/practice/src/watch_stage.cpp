// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/watch_stage.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace nazori::practice {
namespace {

constexpr double kSpeedStep = 1.4142135623730951;
constexpr double kSlowest = 0.25;
constexpr double kFastest = 4;

}  // namespace

void WatchStage::begin() {
  TabletGuides guides;
  guides.strokes = true;
  guides.numbers = true;
  guides.lines_opacity = 0;
  tablet().set_guides(guides);
  tablet().set_tablet(subject().tablet);
  if (subject().tablet)
    player_.set_strokes(subject().tablet->paths(), subject().tablet->lines());
  else
    player_.set_strokes({}, {});
  reported_ = 0;
  show_moment(0);
  if (reduced_motion_) report({.event = StageEvent::watch_paused});
  set_playing(!reduced_motion_ && player_.stroke_count() > 0);
}

void WatchStage::end() {
  set_playing(false);
  tablet().set_demonstration({});
}

void WatchStage::set_playing(bool playing) {
  if (playing && time_s_ >= player_.duration_s()) {
    reported_ = 0;
    show_moment(0);
  }
  is_playing_ = playing;
  since_ = clock_.steady();
  changed();
}

void WatchStage::advance() {
  if (!is_playing_) return;
  const auto now = clock_.steady();
  const double passed_s = std::chrono::duration<double>(now - std::exchange(since_, now)).count();
  double next_s = time_s_ + passed_s * speed_;
  if (next_s >= player_.duration_s()) {
    finished({});
    if (is_looping_) {
      reported_ = 0;
      next_s = 0;
    } else {
      next_s = player_.duration_s();
      set_playing(false);
      report({.event = StageEvent::all_watched, .tone = Tone::good, .count = player_.stroke_count()});
      reported_ = player_.stroke_count();
    }
  }
  show_moment(next_s);
}

void WatchStage::step(int by) {
  if (player_.stroke_count() == 0) return;
  set_playing(false);
  constexpr double kJust_s = 1e-6;
  // Moments to stop at: the start of the first stroke, then the end of each.
  std::vector<double> stops{player_.start_s(1)};
  for (int n = 1; n <= player_.stroke_count(); ++n) stops.push_back(player_.end_s(n));
  double to_s = by > 0 ? stops.back() : stops.front();
  if (by > 0) {
    for (const double stop_s : stops)
      if (stop_s > time_s_ + kJust_s) {
        to_s = stop_s;
        break;
      }
  } else {
    for (const double stop_s : stops)
      if (stop_s < time_s_ - kJust_s) to_s = stop_s;
  }
  reported_ = 0;
  show_moment(to_s);
  if (by > 0 && to_s >= stops.back()) finished({});
}

std::vector<StageCommand> WatchStage::commands() {
  auto all = PracticeStage::commands();
  all.push_back({"watch", [this] {
                   // From the start of the first stroke to the end of each.
                   for (int i = 0; i <= player_.stroke_count(); ++i) step(+1);
                 }});
  return all;
}

void WatchStage::faster() { change_speed(kSpeedStep); }

void WatchStage::slower() { change_speed(1 / kSpeedStep); }

void WatchStage::change_speed(double factor) {
  speed_ = std::clamp(speed_ * factor, kSlowest, kFastest);
  report({.event = StageEvent::speed_changed, .value = speed_});
  changed();
}

int WatchStage::current_stroke() const {
  return player_.stroke_count() == 0 ? 0 : player_.at(time_s_).stroke;
}

void WatchStage::show_moment(double time_s) {
  time_s_ = time_s;
  if (player_.stroke_count() == 0) return;
  const auto pose = player_.at(time_s);
  Demonstration demonstration;
  for (int n = 1; n <= player_.stroke_count(); ++n) demonstration.ink.push_back(player_.share_at(n, time_s));
  demonstration.brush.proxy_m = pose.tip_m;
  demonstration.brush.device_m = pose.tip_m;
  demonstration.brush.touching = pose.writing;
  demonstration.moving = is_playing_;
  tablet().set_demonstration(std::move(demonstration));
  if (pose.writing && pose.stroke != reported_) report_stroke(pose.stroke);
  changed();
}

void WatchStage::report_stroke(int stroke) {
  reported_ = stroke;
  const auto i = static_cast<std::size_t>(stroke - 1);
  StageFeedback what{.event = StageEvent::stroke_watched, .stroke = stroke, .count = player_.stroke_count()};
  what.ending = subject().tablet->lines()[i].ending.value_or(kanji::StrokeEnding::stop);
  if (subject().sheet && i < subject().sheet->character.strokes.size())
    what.type = subject().sheet->character.strokes[i].type;
  report(what);
}

}  // namespace nazori::practice
