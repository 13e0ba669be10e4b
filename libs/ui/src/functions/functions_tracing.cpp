// SPDX-License-Identifier: Apache-2.0
// What keys do along the curves, and the words for it.
#include <QApplication>
#include <QKeyEvent>
#include <QTimer>
#include <cmath>

#include "desk.h"
#include "functions/function_actions.h"
#include "functions/function_sound.h"
#include "functions/functions_workplace.h"
#include "functions/plot_words.h"
#include "functions/points_panel.h"

namespace nazori::ui {
namespace {

constexpr double kSlide_m = 2.5e-3;  ///< farther than a step: lifted on the way
constexpr int kLift_ms = 30;

/// The tablet's window still gets keys until the window system has followed the keyboard to another widget.
bool belongs_elsewhere(const QObject* watched, const QWidget* keyboard) {
  return qobject_cast<const QWidget*>(watched) == nullptr && keyboard != nullptr &&
         keyboard->objectName() != QLatin1String("tablet");
}

bool is_tablet(const QObject* object) {
  return object->objectName() == QLatin1String("tablet") ||
         object->objectName() == QLatin1String("tablet_window");
}

}  // namespace

void FunctionsWorkplace::connect_trace() {
  const auto on = [this](QAction* action, auto&& what) {
    connect(action, &QAction::triggered, this, std::forward<decltype(what)>(what));
  };
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
      desk().answer(Feedback::hint,
                    QStringLiteral("%1 %2.").arg(what_is_shown(), window_words(shown()->request.window)));
  });
  on(actions_->beacon, [this] {
    desk().answer(Feedback::good,
                  event_words(explorer_.drop_beacon(), shown() ? shown()->request.plot : functions::Plot()));
  });
  on(actions_->next_beacon, [this] { announce(explorer_.go_to_next_beacon()); });
  on(actions_->alone, [this](bool alone) {
    const auto& here = explorer_.location();
    if (model_.plot()) show_alone(model_.show_alone(!alone ? -1 : here ? here->statement : 0));
  });
  on(actions_->next_alone, [this] {
    if (model_.plot()) show_alone(model_.show_next_alone());
  });
  auto& controller = desk().tablet();
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
    desk().save_later();
    desk().answer(Feedback::hint, hold ? tr("Curves hold the stylus.") : tr("Curves let the stylus go."));
  });
  on(actions_->clear_ink, [&controller] { controller.clear_ink(); });
}

QString FunctionsWorkplace::what_is_shown() const {
  if (shown()->final) return localised(shown()->summary);
  return plotter_.is_busy() ? tr("The curve is still being drawn.")
                            : tr("The drawing was stopped. What is shown need not be all of it.");
}

void FunctionsWorkplace::show_alone(const functions::PlotEvent& event) {
  actions_->alone->setChecked(model_.plate().alone >= 0);
  announce_summary_ = false;
  draw();
  desk().answer(Feedback::hint, event_words(event, *model_.plot()));
}

void FunctionsWorkplace::announce(const functions::PlotEvent& event) {
  desk().answer(Feedback::hint, event_words(event, shown() ? shown()->request.plot : functions::Plot()));
  if (!event.moves_hand()) return;
  if (event.kind == functions::PlotEventKind::point_reached) points_->set_current(event.number - 1);
  sound_->touch_briefly(explorer_.cue_of(*event.location));
  if (event.point) sound_->sign(event.point->kind, 2 * event.location->at.u - 1);
  put_stylus();
}

void FunctionsWorkplace::put_stylus() {
  const auto size = shown()->picture.plate.heights.size();
  const auto from = put_;
  put_ = functions::tablet_place(explorer_.location()->at, size, tablet_->shape());
  auto& controller = desk().tablet();
  if (from && std::hypot(from->x - put_->x, from->y - put_->y) < kSlide_m) {
    controller.move_stylus(*put_, true);
    return;
  }
  // Over walls a stylus is lifted; pressed, it would stay behind one.
  controller.move_stylus(*put_, false);
  QTimer::singleShot(kLift_ms, this, [this, to = *put_] {
    if (entered_ && put_ && put_->x == to.x && put_->y == to.y) desk().tablet().move_stylus(to, true);
  });
}

void FunctionsWorkplace::show_groove() {
  const auto& controller = desk().tablet();
  announce(explorer_.groove(controller.current_stroke(), controller.stroke_count()));
}

bool FunctionsWorkplace::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
    return Workplace::eventFilter(watched, event);
  if (QApplication::activeModalWidget() != nullptr || QApplication::activePopupWidget() != nullptr)
    return false;
  if (QWidget* keyboard = desk().window().focusWidget();
      is_tablet(watched) && belongs_elsewhere(watched, keyboard))
    return QCoreApplication::sendEvent(keyboard, event);
  auto* key = static_cast<QKeyEvent*>(event);
  const bool stops = key->key() == Qt::Key_Escape;
  // Esc stops what sounds or is being drawn wherever the keyboard is; else it is the window's.
  if (stops ? !sound_->is_playing() && !plotter_.is_busy() : !is_tablet(watched)) return false;
  if (qobject_cast<const QWidget*>(watched) == nullptr && !is_tablet(watched)) return false;
  auto* action = actions_->on_tablet(key->keyCombination());
  if (action == nullptr) return false;
  if (event->type() == QEvent::KeyPress) action->trigger();
  event->accept();
  return true;
}

}  // namespace nazori::ui
