// SPDX-License-Identifier: Apache-2.0
// The sound of a plot: at the hand, by key, and the sweep along a curve.
#include "functions/function_actions.h"
#include "functions/function_sound.h"
#include "functions/functions_page.h"
#include "functions/plot_panel.h"
#include "functions/plot_words.h"
#include "functions/points_panel.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"

namespace nazori::ui {
void FunctionsPage::connect_sound() {
  on(actions_->hear, [this] { hear(); });
  on(actions_->stop, [this] {
    export_.forget_sound();
    sound_->stop();
    if (!plotter_.is_busy()) return;
    plotter_.stop();
    // The explorer and the table then belong to the first picture, which has no points.
    if (shown() && !shown()->final) {
      explorer_.settle();
      points_->show_drawing(shown());
    }
    parts().respond(Feedback::advice, tr("The drawing was stopped and may be incomplete."));
  });
  const auto change_speed = [this](int by) {
    const auto event = model_.change_speed(by);
    parts().save_later();
    announce(event);
  };
  on(actions_->faster, [change_speed] { change_speed(+1); });
  on(actions_->slower, [change_speed] { change_speed(-1); });
  on(actions_->louder, [this] {
    set_volume(sound_->volume() + 10);
    parts().respond(Feedback::hint, tr("Volume %1").arg(sound_->volume()));
  });
  on(actions_->quieter, [this] {
    set_volume(sound_->volume() - 10);
    parts().respond(Feedback::hint, tr("Volume %1").arg(sound_->volume()));
  });
  on(actions_->mute, [this](bool muted) { set_muted(muted); });
  on(actions_->reference, [this] { play_reference(); });
  connect(sound_, &FunctionSound::unavailable, this,
          [this](const base::Error& error) { parts().announce(Feedback::advice, no_sound(error)); });
  connect(&touch_timer_, &QTimer::timeout, this, &FunctionsPage::follow_stylus);
  const auto follow = [this] {
    if (entered_ && !touch_timer_.isActive()) touch_timer_.start();
  };
  auto& controller = parts().tablet();
  subscribe(controller.depth_changed, this, [follow](double) { follow(); });
  subscribe(controller.device().changed, this, follow);
}

void FunctionsPage::follow_stylus() {
  // The next move of the stylus starts the sound again.
  if (parts().tablet().device().is_resting()) touch_timer_.stop();
  const auto felt = hand_.follow();
  if (!felt) return;
  const auto& touch = felt->touch;
  sound_->touch(touch.cue, touch.trembles);
  if (touch.reached == nullptr) return;
  sound_->sign(touch.reached->kind, 2 * felt->at.u - 1);
  parts().announce(Feedback::hint, point_words(*touch.reached) + QLatin1Char('.'));
}

void FunctionsPage::play_reference() {
  const auto cue = functions::reference_cue(model_.window());
  if (!cue) {
    parts().respond(Feedback::hint, tr("y = 0 is outside the range."));
    return;
  }
  if (!can_be_heard()) return;
  sound_->touch_briefly(*cue);
  // If playing was refused just now, the feedback line already says why.
  if (sound_->is_refused()) return;
  parts().respond(Feedback::hint, tr("This is the tone of y = 0."));
}

bool FunctionsPage::can_be_heard() const {
  if (sound_->muted())
    parts().respond(Feedback::hint, tr("Sound is off. M: turn it on."));
  else if (sound_->is_refused())
    parts().respond(Feedback::advice, tr("Sound is not available on this computer."));
  return !sound_->muted() && !sound_->is_refused();
}

void FunctionsPage::hear() {
  if (!shown() || !shown()->final) return;
  if (shown()->request.plot.is_surface()) {
    parts().respond(Feedback::hint, tr("A surface has no curve to play."));
    return;
  }
  if (!can_be_heard()) return;
  const auto& request = shown()->request;
  parts().respond(Feedback::hint,
                  localised(request.plate.alone < 0
                                ? functions::in_words(request.plot, plot_language(), plot_speech())
                                : functions::in_words(
                                      request.plot.statements[static_cast<std::size_t>(request.plate.alone)],
                                      plot_language(), plot_speech())));
  export_.compose(shown(), model_.sound());
}

void FunctionsPage::set_volume(int percent) {
  sound_->set_volume(percent);
  panel_->show_volume(sound_->volume(), sound_->muted());
  parts().save_later();
}

void FunctionsPage::set_muted(bool muted) {
  sound_->set_muted(muted);
  actions_->mute->setChecked(muted);
  panel_->show_volume(sound_->volume(), muted);
  parts().save_later();
  parts().announce(Feedback::hint, muted ? tr("Sound off.") : tr("Sound on."));
}

}  // namespace nazori::ui
