// SPDX-License-Identifier: Apache-2.0
// What is heard of a plot: under the hand, by key, and the sweep.
#include <algorithm>
#include <cmath>

#include "desk.h"
#include "error_text.h"
#include "functions/function_actions.h"
#include "functions/function_sound.h"
#include "functions/functions_workplace.h"
#include "functions/plot_panel.h"
#include "functions/plot_words.h"
#include "functions/points_panel.h"
#include "signals.h"

namespace nazori::ui {
namespace {

constexpr double kMoved_m = 1.5e-3;  ///< the stylus is no longer where keys put it

}  // namespace

void FunctionsWorkplace::connect_sound() {
  const auto on = [this](QAction* action, auto&& what) {
    connect(action, &QAction::triggered, this, std::forward<decltype(what)>(what));
  };
  on(actions_->hear, [this] { hear(); });
  on(actions_->stop, [this] {
    export_->forget_sound();
    sound_->stop();
    if (!plotter_->is_busy()) return;
    plotter_->stop();
    // The first picture, which has no points, is what tracing and table are of then.
    if (drawing_ && !drawing_->final) {
      tracer_.set_drawing(drawing_);
      points_->show_drawing(drawing_);
    }
    desk().answer(Feedback::advice, tr("The drawing was stopped. What is shown need not be all of it."));
  });
  on(actions_->faster, [this] { change_speed(+1); });
  on(actions_->slower, [this] { change_speed(-1); });
  on(actions_->louder, [this] {
    set_volume(sound_->volume() + 10);
    desk().answer(Feedback::hint, tr("Volume %1").arg(sound_->volume()));
  });
  on(actions_->quieter, [this] {
    set_volume(sound_->volume() - 10);
    desk().answer(Feedback::hint, tr("Volume %1").arg(sound_->volume()));
  });
  on(actions_->mute, [this](bool muted) { set_muted(muted); });
  on(actions_->reference, [this] { play_reference(); });
  connect(sound_, &FunctionSound::unavailable, this,
          [this](const base::Error& error) { desk().say(Feedback::advice, no_sound(error)); });
  connect(&touch_timer_, &QTimer::timeout, this, &FunctionsWorkplace::follow_stylus);
  const auto follow = [this] {
    if (entered_ && !touch_timer_.isActive()) touch_timer_.start();
  };
  auto& controller = desk().tablet();
  subscribe(controller.depth_changed, this, [follow](double) { follow(); });
  subscribe(controller.device().changed, this, follow);
}

void FunctionsWorkplace::follow_stylus() {
  auto& controller = desk().tablet();
  // Its next move begins this again.
  if (controller.device().is_resting()) touch_timer_.stop();
  const auto& sample = controller.latest();
  const geometry::TabletPoint tip{sample.proxy_m.x, sample.proxy_m.y};
  if (put_) {
    if (std::hypot(tip.x - put_->x, tip.y - put_->y) < kMoved_m || !controller.is_pressed()) return;
    // A hand has taken the stylus, or it is still on its way to where keys sent it.
    const geometry::TabletPoint wanted{sample.device_m.x, sample.device_m.y};
    if (std::hypot(wanted.x - put_->x, wanted.y - put_->y) < kMoved_m) return;
  }
  if (!sample.touching || !drawing_ || !drawing_->final) {
    if (!put_) sound_->touch({});
    return;
  }
  put_.reset();
  const auto size = drawing_->picture.plate.heights.size();
  const auto hand = functions::plate_place(tip, size, drawing_->tablet->shape());
  sound_touched(hand);
  const functions::PointOfInterest* here = nullptr;
  for (const auto& point : drawing_->points) {
    const auto& window = drawing_->asked.window;
    if (std::hypot(window.u(point.x) - hand.u, window.v(point.y) - hand.v) < CurveTracer::kStep)
      here = &point;
  }
  if (here != nullptr && here != touched_) {
    sound_->sign(here->kind, 2 * hand.u - 1);
    desk().say(Feedback::hint, point_words(*here) + QLatin1Char('.'));
  }
  touched_ = here;
}

void FunctionsWorkplace::sound_touched(functions::PlatePoint hand) {
  const auto& asked = drawing_->asked;
  const auto& picture = drawing_->picture;
  if (asked.plot.is_surface()) {
    // Its height is what the pitch tells.
    const auto& heights = picture.plate.heights;
    const int last = heights.size() - 1;
    const int column = std::clamp(static_cast<int>(hand.u * heights.size()), 0, last);
    const int row = std::clamp(static_cast<int>((1 - hand.v) * heights.size()), 0, last);
    const std::size_t sample = static_cast<std::size_t>(row) * static_cast<std::size_t>(heights.size()) +
                               static_cast<std::size_t>(column);
    const bool defined = picture.plate.mask[sample] != 0;
    const functions::Window window{asked.window.x0, asked.window.x1, picture.plate.range.low,
                                   picture.plate.range.high};
    sound_->touch(functions::cue_at({hand.u, heights.at(column, row)}, window, defined ? 1 : 0));
    return;
  }
  const double reach = 3 * asked.plate.half_width;
  const bool on_band =
      std::any_of(picture.tracing.bars.begin(), picture.tracing.bars.end(), [&](const functions::Bar& bar) {
        const auto [low, high] = std::minmax(bar.from.v, bar.to.v);
        return std::abs(bar.from.u - hand.u) < asked.plate.half_width && hand.v >= low && hand.v <= high;
      });
  if (on_band) {
    sound_->touch(functions::cue_at(hand, asked.window, 1), true);
    return;
  }
  const auto near = tracer_.nearest(hand);
  const double nearness = near ? std::clamp(1 - near->on->distance / reach, 0.0, 1.0) : 0.0;
  sound_->touch(functions::cue_at(near ? near->at : hand, asked.window, nearness));
}

void FunctionsWorkplace::play_reference() {
  const double v = window_.v(0);
  if (v < 0 || v > 1) {
    desk().answer(Feedback::hint, tr("y = 0 lies outside the window."));
    return;
  }
  if (!can_be_heard()) return;
  sound_->touch_briefly(functions::cue_at({0.5, v}, window_, 1));
  // Refused just now, the sentence that says so stands there already.
  if (sound_->is_refused()) return;
  desk().answer(Feedback::hint, tr("This is the tone of y = 0."));
}

bool FunctionsWorkplace::can_be_heard() const {
  if (sound_->muted())
    desk().answer(Feedback::hint, tr("The sound is off. M turns it on."));
  else if (sound_->is_refused())
    desk().answer(Feedback::advice, tr("Nothing can be heard on this computer."));
  return !sound_->muted() && !sound_->is_refused();
}

functions::SoundSettings FunctionsWorkplace::sound_settings() const {
  functions::SoundSettings settings;
  // From 6 s at 1 through 3 s at 3 to 1.1 s at 10.
  settings.seconds = 12.0 / (speed_ + 1);
  settings.volume = 1;
  return settings;
}

void FunctionsWorkplace::hear() {
  if (!drawing_ || !drawing_->final) return;
  if (drawing_->asked.plot.is_surface()) {
    desk().answer(Feedback::hint, tr("A surface has no curve to play."));
    return;
  }
  if (!can_be_heard()) return;
  const auto& asked = drawing_->asked;
  desk().answer(
      Feedback::hint,
      localised(asked.plate.alone < 0
                    ? functions::in_words(asked.plot, plot_language())
                    : functions::in_words(asked.plot.statements[static_cast<std::size_t>(asked.plate.alone)],
                                          plot_language())));
  export_->compose(drawing_, sound_settings());
}

void FunctionsWorkplace::change_speed(int by) {
  speed_ = std::clamp(speed_ + by, kSlowest, kFastest);
  desk().save_later();
  desk().answer(Feedback::hint, tr("Speed %1 of %2").arg(speed_).arg(kFastest));
}

void FunctionsWorkplace::set_volume(int percent) {
  sound_->set_volume(percent);
  panel_->show_volume(sound_->volume(), sound_->muted());
  desk().save_later();
}

void FunctionsWorkplace::set_muted(bool muted) {
  sound_->set_muted(muted);
  actions_->mute->setChecked(muted);
  panel_->show_volume(sound_->volume(), muted);
  desk().save_later();
  desk().say(Feedback::hint, muted ? tr("The sound is off.") : tr("The sound is on."));
}

}  // namespace nazori::ui
