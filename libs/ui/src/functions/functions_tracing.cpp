// SPDX-License-Identifier: Apache-2.0
// What keys do along the curves, and what is said of it.
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
  using Way = CurveTracer::Way;
  on(actions_->step_on, [this] { show_step(tracer_.step(Way::on)); });
  on(actions_->step_back, [this] { show_step(tracer_.step(Way::back)); });
  on(actions_->tick_on, [this] { show_step(tracer_.step_to_tick(Way::on)); });
  on(actions_->tick_back, [this] { show_step(tracer_.step_to_tick(Way::back)); });
  const auto to_end = [this](Way way) {
    tracer_.go_to_end(way);
    show_place();
  };
  on(actions_->to_start, [to_end] { to_end(Way::back); });
  on(actions_->to_end, [to_end] { to_end(Way::on); });
  const auto change_branch = [this](Way way) {
    if (tracer_.change_branch(way))
      show_place(localised(functions::in_words(
          drawing_->asked.plot.statements[static_cast<std::size_t>(tracer_.place()->statement)],
          plot_language())));
    else
      desk().answer(Feedback::hint, tr("There is no other curve or branch."));
  };
  on(actions_->branch_on, [change_branch] { change_branch(Way::on); });
  on(actions_->branch_back, [change_branch] { change_branch(Way::back); });
  on(actions_->point_on, [this] { go_to_point(tracer_.next_point(Way::on)); });
  on(actions_->point_back, [this] { go_to_point(tracer_.next_point(Way::back)); });
  on(actions_->coordinates, [this] {
    if (tracer_.place() || !has_curve())
      show_place();
    else
      desk().answer(Feedback::hint, tr("Go to a place on a curve first, with the arrow keys."));
  });
  on(actions_->slope, [this] {
    const auto slope = tracer_.slope();
    desk().answer(Feedback::hint, slope ? slope_words(*slope) : tr("There is no slope here."));
  });
  on(actions_->summary, [this] {
    if (drawing_)
      desk().answer(Feedback::hint,
                    QStringLiteral("%1 %2.").arg(what_is_shown(), window_words(drawing_->asked.window)));
  });
  on(actions_->beacon, [this] {
    tracer_.drop_beacon();
    desk().answer(Feedback::good,
                  tracer_.place()
                      ? tr("Beacon %1 is here: %2.")
                            .arg(tracer_.beacon_count())
                            .arg(tracer_.point_here() != nullptr ? point_words(*tracer_.point_here())
                                                                 : place_words(*tracer_.place()))
                      : tr("Go to a place on a curve first, with the arrow keys."));
  });
  on(actions_->next_beacon, [this] {
    if (const int number = tracer_.go_to_next_beacon(); number > 0)
      show_place(tr("Beacon %1").arg(number));
    else
      desk().answer(Feedback::hint, tr("There is no beacon yet. B drops one."));
  });
  on(actions_->alone, [this](bool alone) {
    const auto& place = tracer_.place();
    show_alone(alone ? (place ? place->statement : 0) : -1);
  });
  on(actions_->next_alone, [this] {
    const int count = plot_ ? static_cast<int>(plot_->statements.size()) : 0;
    show_alone(plate_.alone + 1 < count ? plate_.alone + 1 : -1);
  });
  auto& controller = desk().tablet();
  on(actions_->curve_on, [this, &controller] {
    controller.next_stroke();
    show_piece();
  });
  on(actions_->curve_back, [this, &controller] {
    controller.previous_stroke();
    show_piece();
  });
  on(actions_->all_curves, [this, &controller] {
    controller.set_current_stroke(0);
    show_piece();
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
  if (drawing_->final) return localised(drawing_->summary);
  return plotter_->is_busy() ? tr("The curve is still being drawn.")
                             : tr("The drawing was stopped. What is shown need not be all of it.");
}

bool FunctionsWorkplace::has_curve() const { return drawing_ && !drawing_->picture.tracing.branches.empty(); }

void FunctionsWorkplace::show_alone(int statement) {
  if (!plot_) return;
  const bool alone = statement >= 0 && plot_->statements.size() > 1;
  plate_.alone = alone ? statement : -1;
  actions_->alone->setChecked(alone);
  tell_summary_ = false;
  draw();
  if (plot_->statements.size() < 2) {
    desk().answer(Feedback::hint, tr("There is only one curve."));
  } else if (!alone) {
    desk().answer(Feedback::hint, tr("All curves are shown."));
  } else {
    const auto& shown = plot_->statements[static_cast<std::size_t>(statement)];
    desk().answer(Feedback::hint, tr("Curve %1 alone: %2.")
                                      .arg(statement + 1)
                                      .arg(localised(functions::in_words(shown, plot_language()))));
  }
}

void FunctionsWorkplace::show_step(CurveTracer::Step step) {
  switch (step) {
    case CurveTracer::Step::done:
      show_place();
      break;
    case CurveTracer::Step::next_branch:
      show_place(tr("Next piece"));
      break;
    case CurveTracer::Step::end:
      show_place(tr("End"));
      break;
  }
}

void FunctionsWorkplace::show_place(const QString& before, const functions::PointOfInterest* point) {
  const auto& place = tracer_.place();
  if (!place || !drawing_) {
    desk().answer(Feedback::hint, tr("There is no curve to follow here."));
    return;
  }
  const auto& window = drawing_->asked.window;
  if (point == nullptr) point = tracer_.point_here();
  QStringList words;
  if (!before.isEmpty()) words.append(before);
  words.append(point != nullptr ? point_words(*point) : place_words(*place));
  desk().answer(Feedback::hint, words.join(QStringLiteral(": ")) + QLatin1Char('.'));
  sound_->touch_briefly(functions::cue_at(place->at, window, place->on ? 1 : 0));
  if (point != nullptr) sound_->sign(point->kind, 2 * place->at.u - 1);
  put_stylus();
}

void FunctionsWorkplace::put_stylus() {
  const auto size = drawing_->picture.plate.heights.size();
  const auto from = put_;
  put_ = functions::tablet_place(tracer_.place()->at, size, drawing_->tablet->shape());
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

void FunctionsWorkplace::go_to_point(const functions::PointOfInterest* point) {
  if (point == nullptr) {
    desk().answer(Feedback::hint, tr("There are no points of interest in this window."));
    return;
  }
  tracer_.go_to(*point);
  points_->set_current(static_cast<int>(point - drawing_->points.data()));
  show_place({}, point);
}

void FunctionsWorkplace::show_piece() {
  const auto& controller = desk().tablet();
  const int piece = controller.current_stroke();
  if (piece == 0 || !drawing_) {
    desk().answer(Feedback::hint, tr("%n pieces", nullptr, controller.stroke_count()));
    return;
  }
  const auto statement = drawing_->statements[static_cast<std::size_t>(piece - 1)];
  desk().answer(
      Feedback::hint,
      tr("Piece %1 of %2: %3")
          .arg(piece)
          .arg(controller.stroke_count())
          .arg(localised(functions::in_words(
              drawing_->asked.plot.statements[static_cast<std::size_t>(statement)], plot_language()))));
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
  if (stops ? !sound_->is_playing() && !plotter_->is_busy() : !is_tablet(watched)) return false;
  if (qobject_cast<const QWidget*>(watched) == nullptr && !is_tablet(watched)) return false;
  auto* action = actions_->on_tablet(key->keyCombination());
  if (action == nullptr) return false;
  if (event->type() == QEvent::KeyPress) action->trigger();
  event->accept();
  return true;
}

}  // namespace nazori::ui
