// SPDX-License-Identifier: Apache-2.0
// Following the curves with keys, and the sentences for it.
#include <QApplication>
#include <QKeyEvent>
#include <QTimer>

#include "functions/function_actions.h"
#include "functions/function_sound.h"
#include "functions/functions_page.h"
#include "functions/plot_panel.h"
#include "functions/plot_words.h"
#include "functions/points_panel.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/page/window_parts.h"

namespace nazori::ui {
namespace {

/// The window of the tablet still receives keys until the window system has moved the focus to another
/// widget.
bool belongs_elsewhere(const QObject* watched, const QWidget* keyboard) {
  return qobject_cast<const QWidget*>(watched) == nullptr && keyboard != nullptr &&
         keyboard->objectName() != QLatin1String("tablet");
}

}  // namespace

void FunctionsPage::connect_trace() {
  using Way = functions::PlotExplorer::Way;
  on(actions_->step_on, [this] { announce(explorer_.step(Way::on)); });
  on(actions_->step_back, [this] { announce(explorer_.step(Way::back)); });
  on(actions_->tick_on, [this] { announce(explorer_.step_to_tick(Way::on)); });
  on(actions_->tick_back, [this] { announce(explorer_.step_to_tick(Way::back)); });
  on(actions_->to_start, [this] { announce(explorer_.go_to_end(Way::back)); });
  on(actions_->to_end, [this] { announce(explorer_.go_to_end(Way::on)); });
  on(actions_->branch_on, [this] { announce(explorer_.change_branch(Way::on)); });
  on(actions_->branch_back, [this] { announce(explorer_.change_branch(Way::back)); });
  on(actions_->point_on, [this] { announce(explorer_.next_point(Way::on)); });
  on(actions_->point_back, [this] { announce(explorer_.next_point(Way::back)); });
  on(actions_->coordinates, [this] { announce(explorer_.where()); });
  on(actions_->slope, [this] { announce(explorer_.slope()); });
  on(actions_->summary, [this] {
    if (shown())
      parts().respond(Feedback::hint,
                      QStringLiteral("%1 %2.").arg(what_is_shown(), window_words(shown()->request.window)));
  });
  on(actions_->speech, [this] {
    set_plot_speech(static_cast<functions::SpeechStyle>((static_cast<int>(plot_speech()) + 1) % 3));
    parts().save_later();
    if (const auto& plot = model_.plot()) {
      panel_->show_words(localised(functions::in_words(*plot, plot_language(), plot_speech())));
      draw();
    }
    parts().respond(Feedback::good, speech_words(plot_speech()) + QLatin1Char('.'));
  });
  on(actions_->beacon, [this] {
    parts().respond(Feedback::good, event_words(explorer_.drop_beacon(),
                                                shown() ? shown()->request.plot : functions::Plot()));
  });
  on(actions_->next_beacon, [this] { announce(explorer_.go_to_next_beacon()); });
  on(actions_->alone, [this](bool alone) {
    const auto& here = explorer_.location();
    if (model_.plot()) show_alone(model_.show_alone(!alone ? -1 : here ? here->statement : 0));
  });
  on(actions_->next_alone, [this] {
    if (model_.plot()) show_alone(model_.show_next_alone());
  });
  auto& controller = parts().tablet();
  on(actions_->curve_on, [this, &controller] {
    controller.next_stroke();
    show_groove();
  });
  on(actions_->curve_back, [this, &controller] {
    controller.previous_stroke();
    show_groove();
  });
  on(actions_->all_curves, [this, &controller] {
    controller.set_current_stroke(0);
    show_groove();
  });
  on(actions_->snap, [this, &controller](bool hold) {
    snapping_ = hold;
    controller.set_snapping(hold);
    parts().save_later();
    parts().respond(Feedback::hint, hold ? tr("Snapping on: curves attract the stylus.")
                                         : tr("Snapping off: the stylus moves freely."));
  });
  on(actions_->clear_ink, [&controller] { controller.clear_ink(); });
}

QString FunctionsPage::what_is_shown() const {
  if (shown()->final) return localised(shown()->summary);
  return plotter_.is_busy() ? tr("The curve is still being drawn.")
                            : tr("The drawing was stopped and may be incomplete.");
}

void FunctionsPage::show_alone(const functions::PlotEvent& event) {
  actions_->alone->setChecked(model_.plate().alone >= 0);
  announce_summary_ = false;
  draw();
  parts().respond(Feedback::hint, event_words(event, *model_.plot()));
}

void FunctionsPage::announce(const functions::PlotEvent& event) {
  parts().respond(Feedback::hint, event_words(event, shown() ? shown()->request.plot : functions::Plot()));
  if (!event.moves_hand()) return;
  if (event.kind == functions::PlotEventKind::point_reached) points_->set_current(event.number - 1);
  sound_->touch_briefly(explorer_.cue_of(*event.location));
  if (event.point) sound_->sign(event.point->kind, 2 * event.location->at.u - 1);
  put_stylus();
}

void FunctionsPage::put_stylus() {
  const auto lifted = hand_.put();
  if (!lifted) return;
  QTimer::singleShot(practice::PlotHand::kLift, this, [this, to = *lifted] {
    if (entered_) hand_.press(to);
  });
}

void FunctionsPage::show_groove() {
  const auto& controller = parts().tablet();
  announce(explorer_.groove(controller.current_stroke(), controller.stroke_count()));
}

bool FunctionsPage::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
    return Page::eventFilter(watched, event);
  if (QApplication::activeModalWidget() != nullptr || QApplication::activePopupWidget() != nullptr)
    return false;
  if (QWidget* keyboard = parts().window().focusWidget();
      is_tablet(watched) && belongs_elsewhere(watched, keyboard))
    return QCoreApplication::sendEvent(keyboard, event);
  auto* key = static_cast<QKeyEvent*>(event);
  const bool stops = key->key() == Qt::Key_Escape;
  // Esc stops sound and drawing wherever the focus is. Otherwise it belongs to the window.
  if (stops ? !sound_->is_playing() && !plotter_.is_busy() : !is_tablet(watched)) return false;
  if (qobject_cast<const QWidget*>(watched) == nullptr && !is_tablet(watched)) return false;
  auto* action = actions_->on_tablet(key->keyCombination());
  if (action == nullptr) return false;
  if (event->type() == QEvent::KeyPress) action->trigger();
  event->accept();
  return true;
}

}  // namespace nazori::ui
