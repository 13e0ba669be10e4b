// SPDX-License-Identifier: Apache-2.0
#include "functions/functions_workplace.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QKeyEvent>
#include <QSettings>
#include <QStandardPaths>
#include <QWindow>
#include <algorithm>
#include <cmath>

#include "desk.h"
#include "error_text.h"
#include "functions/expression_line.h"
#include "functions/function_actions.h"
#include "functions/function_sound.h"
#include "functions/plot_panel.h"
#include "functions/plot_words.h"
#include "functions/points_panel.h"

namespace nazori::ui {
namespace {

constexpr int kTouch_ms = 25;
constexpr double kMoved_m = 1.5e-3;  ///< the stylus is no longer where keys put it
constexpr double kSlide_m = 2.5e-3;  ///< farther than a step: lifted on the way
constexpr int kLift_ms = 30;
constexpr int kSlowest = 1;
constexpr int kFastest = 10;
constexpr functions::Window kFirstWindow{-6, 6, -4, 4};

bool is_tablet(const QObject* object) {
  return object->objectName() == QLatin1String("tablet") ||
         object->objectName() == QLatin1String("tablet_window");
}

}  // namespace

FunctionsWorkplace::FunctionsWorkplace(Desk& desk)
    : Workplace(desk),
      actions_(new FunctionActions(&desk.window())),
      panel_(new PlotPanel(&desk.window())),
      points_(new PointsPanel(&desk.window())),
      sound_(new FunctionSound(this)),
      plotter_(new Plotter(this)),
      export_(new PlotExport(this)),
      window_(kFirstWindow),
      first_window_(kFirstWindow) {
  touch_timer_.setInterval(kTouch_ms);
  QSettings settings(desk.settings_file(), QSettings::IniFormat);
  settings.beginGroup(id());
  load(settings);
  connect_panels();
  connect_trace();
  connect_window_and_sound();
  connect_work();
  points_->show_drawing({});
}

FunctionsWorkplace::~FunctionsWorkplace() = default;

QString FunctionsWorkplace::id() const { return QStringLiteral("functions"); }
QString FunctionsWorkplace::name() const { return tr("F&unctions"); }
QString FunctionsWorkplace::purpose() const { return tr("Curves to see, feel and hear"); }
Icon FunctionsWorkplace::drawing() const { return Icon::curve; }
QString FunctionsWorkplace::title() const { return expression_; }

Workplace::Panel FunctionsWorkplace::left() const {
  return {panel_, tr("&Expression and window"), tr("Show or fold away the expression")};
}

Workplace::Panel FunctionsWorkplace::right() const {
  return {points_, tr("&Points of interest"), tr("Show or fold away the points of interest")};
}

ActionSet* FunctionsWorkplace::actions() const { return actions_; }

QList<Tool> FunctionsWorkplace::tools() const {
  return {{actions_->hear, true},
          {actions_->mute},
          {},
          {actions_->curve_back},
          {actions_->curve_on},
          {actions_->snap, true},
          {},
          {actions_->zoom_in, true},
          {actions_->zoom_out, true},
          {actions_->reset_window, true},
          {},
          {actions_->clear_ink}};
}

QString FunctionsWorkplace::tablet_description() const {
  return tr(
      "The plot as grooves. Left and right go along the curve, up and down to another, Tab to the next point "
      "of interest, H plays it, S says what it is; Control L leaves to the expression, Control T to the "
      "table");
}

void FunctionsWorkplace::load(const QSettings& settings) {
  const auto number = [&settings](const char* key, double otherwise) {
    bool good = false;
    const double value = settings.value(QString::fromLatin1(key)).toDouble(&good);
    return good && std::isfinite(value) ? value : otherwise;
  };
  const functions::Window window{number("x0", kFirstWindow.x0), number("x1", kFirstWindow.x1),
                                 number("y0", kFirstWindow.y0), number("y1", kFirstWindow.y1)};
  if (window.check()) window_ = window;
  first_window_ = window_;
  const auto flag = [&settings](const char* key, bool otherwise) {
    return settings.value(QString::fromLatin1(key), otherwise).toBool();
  };
  plate_.layers = {flag("axes", true), flag("ticks", true), flag("grid", false), flag("rim", true)};
  plate_.half_width = std::clamp(number("half_width", plate_.half_width), 0.002, 0.05);
  plate_.size = std::clamp(settings.value(QStringLiteral("size"), plate_.size).toInt(), 128, 2048);
  speed_ = std::clamp(settings.value(QStringLiteral("speed"), speed_).toInt(), kSlowest, kFastest);
  snapping_ = flag("snapping", false);
  sound_->set_volume(settings.value(QStringLiteral("volume"), 50).toInt());
  sound_->set_muted(flag("muted", false));
  auto* line = panel_->line();
  line->set_history(settings.value(QStringLiteral("history")).toStringList());
  line->setText(
      settings.value(QStringLiteral("expression"), QStringLiteral("y = tan(x); y = sin x")).toString());
  panel_->show_window(window_);
  panel_->show_plate(plate_);
  panel_->show_volume(sound_->volume(), sound_->muted());
  actions_->mute->setChecked(sound_->muted());
}

void FunctionsWorkplace::save(QSettings& settings) const {
  settings.setValue(QStringLiteral("expression"),
                    expression_.isEmpty() ? panel_->line()->text() : expression_);
  settings.setValue(QStringLiteral("history"), panel_->line()->history());
  settings.setValue(QStringLiteral("x0"), window_.x0);
  settings.setValue(QStringLiteral("x1"), window_.x1);
  settings.setValue(QStringLiteral("y0"), window_.y0);
  settings.setValue(QStringLiteral("y1"), window_.y1);
  settings.setValue(QStringLiteral("axes"), plate_.layers.axes);
  settings.setValue(QStringLiteral("ticks"), plate_.layers.ticks);
  settings.setValue(QStringLiteral("grid"), plate_.layers.grid);
  settings.setValue(QStringLiteral("rim"), plate_.layers.rim);
  settings.setValue(QStringLiteral("half_width"), plate_.half_width);
  settings.setValue(QStringLiteral("size"), plate_.size);
  settings.setValue(QStringLiteral("speed"), speed_);
  settings.setValue(QStringLiteral("snapping"), snapping_);
  settings.setValue(QStringLiteral("volume"), sound_->volume());
  settings.setValue(QStringLiteral("muted"), sound_->muted());
}

void FunctionsWorkplace::enter() {
  entered_ = true;
  auto& controller = desk().controller();
  before_ = TabletSwitches{controller.strokes_visible(), controller.numbers_visible(),
                           controller.arrows_visible(), controller.snapping()};
  controller.set_strokes_visible(true);
  controller.set_numbers_visible(false);
  controller.set_arrows_visible(false);
  controller.set_snapping(snapping_);
  actions_->snap->setChecked(snapping_);
  controller.set_tablet(drawing_ ? drawing_->tablet : nullptr);
  QCoreApplication::instance()->installEventFilter(this);
  touch_timer_.start();
  panel_->take_appearance();
  if (!drawing_)
    read_expression();
  else
    desk().say(Feedback::hint, localised(drawing_->summary));
}

void FunctionsWorkplace::leave() {
  entered_ = false;
  QCoreApplication::instance()->removeEventFilter(this);
  touch_timer_.stop();
  export_->forget_sound();
  sound_->stop();
  auto& controller = desk().controller();
  controller.lift_stylus();
  if (!before_) return;
  controller.set_strokes_visible(before_->strokes);
  controller.set_numbers_visible(before_->numbers);
  controller.set_arrows_visible(before_->arrows);
  controller.set_snapping(before_->snapping);
}

void FunctionsWorkplace::take_appearance() { panel_->take_appearance(); }

void FunctionsWorkplace::connect_panels() {
  auto* line = panel_->line();
  connect(panel_, &PlotPanel::expression_typed, this, [this] { read_expression(); });
  connect(line, &ExpressionLine::entered, this, [this, line] {
    if (line->marked_column() > 0) {
      desk().say(Feedback::wrong, line->accessibleDescription());
      return;
    }
    line->remember(line->text());
    desk().save_later();
    desk().close_drawers();
    desk().focus_tablet();
    if (drawing_ && drawing_->final && !plotter_->is_busy())
      desk().say(Feedback::good, localised(drawing_->summary));
  });
  connect(panel_, &PlotPanel::example_chosen, this,
          [this, line](const QString& expression, const functions::Window& window) {
            window_ = first_window_ = window;
            panel_->show_window(window);
            line->remember(expression);
            if (line->text() == expression)
              draw();
            else
              line->setText(expression);
          });
  connect(panel_, &PlotPanel::window_typed, this, [this](const functions::Window& window) {
    if (const auto good = window.check(); !good) {
      desk().say(Feedback::wrong, tr("This window cannot be shown: %1.").arg(reason(good.error())));
      panel_->show_window(window_);
      return;
    }
    first_window_ = window;
    set_window(window);
  });
  connect(panel_, &PlotPanel::window_refused, this, [this](const QString& text) {
    desk().say(Feedback::wrong, tr("“%1” is no number. The window is as it was.").arg(text));
  });
  connect(panel_, &PlotPanel::plate_changed, this, [this](const functions::PlateSettings& plate) {
    plate_ = plate;
    desk().save_later();
    draw();
  });
  connect(panel_, &PlotPanel::volume_changed, this, &FunctionsWorkplace::set_volume);
  connect(panel_, &PlotPanel::mute_changed, this, &FunctionsWorkplace::set_muted);
  connect(points_, &PointsPanel::point_chosen, this, [this](int row) {
    if (drawing_ && row >= 0 && row < static_cast<int>(drawing_->points.size()))
      go_to_point(&drawing_->points[static_cast<std::size_t>(row)]);
  });
}

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
      desk().say(Feedback::hint, tr("There is no other curve or branch."));
  };
  on(actions_->branch_on, [change_branch] { change_branch(Way::on); });
  on(actions_->branch_back, [change_branch] { change_branch(Way::back); });
  on(actions_->point_on, [this] { go_to_point(tracer_.next_point(Way::on)); });
  on(actions_->point_back, [this] { go_to_point(tracer_.next_point(Way::back)); });
  on(actions_->coordinates, [this] { show_place(); });
  on(actions_->slope, [this] {
    const auto slope = tracer_.slope();
    desk().say(Feedback::hint, slope ? slope_words(*slope) : tr("There is no slope here."));
  });
  on(actions_->summary, [this] {
    if (drawing_)
      desk().say(Feedback::hint, QStringLiteral("%1 %2.").arg(localised(drawing_->summary),
                                                              window_words(drawing_->asked.window)));
  });
  on(actions_->beacon, [this] {
    tracer_.drop_beacon();
    desk().say(
        Feedback::good,
        tracer_.place()
            ? tr("Beacon %1 is here: %2.").arg(tracer_.beacon_count()).arg(place_words(*tracer_.place()))
            : tr("Go to a place on a curve first, with the arrow keys."));
  });
  on(actions_->next_beacon, [this] {
    if (const int number = tracer_.go_to_next_beacon(); number > 0)
      show_place(tr("Beacon %1").arg(number));
    else
      desk().say(Feedback::hint, tr("There is no beacon yet. B drops one."));
  });
  auto& controller = desk().controller();
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
    desk().say(Feedback::hint, hold ? tr("Curves hold the stylus.") : tr("Curves let the stylus go."));
  });
  on(actions_->clear_ink, [&controller] { controller.clear_ink(); });
}

void FunctionsWorkplace::connect_window_and_sound() {
  const auto on = [this](QAction* action, auto&& what) {
    connect(action, &QAction::triggered, this, std::forward<decltype(what)>(what));
  };
  on(actions_->expression, [this] {
    desk().open_left_panel();
    panel_->line()->setFocus(Qt::ShortcutFocusReason);
    panel_->line()->selectAll();
    desk().window().activateWindow();
  });
  on(actions_->points, [this] {
    desk().window().activateWindow();
    points_->focus_table();
  });
  on(actions_->zoom_in, [this] { zoom(2); });
  on(actions_->zoom_out, [this] { zoom(0.5); });
  on(actions_->pan_left, [this] { pan(-0.25, 0); });
  on(actions_->pan_right, [this] { pan(0.25, 0); });
  on(actions_->pan_up, [this] { pan(0, 0.25); });
  on(actions_->pan_down, [this] { pan(0, -0.25); });
  on(actions_->reset_window, [this] { set_window(first_window_); });
  on(actions_->export_raw, [this] { ask_and_write(PlotFile::raw); });
  on(actions_->export_png, [this] { ask_and_write(PlotFile::png); });
  on(actions_->export_print, [this] { ask_and_write(PlotFile::print); });
  on(actions_->export_sound, [this] { ask_and_write(PlotFile::sound); });
  on(actions_->hear, [this] { hear(); });
  on(actions_->stop, [this] {
    export_->forget_sound();
    sound_->stop();
    plotter_->stop();
  });
  on(actions_->faster, [this] { change_speed(+1); });
  on(actions_->slower, [this] { change_speed(-1); });
  on(actions_->louder, [this] {
    set_volume(sound_->volume() + 10);
    desk().say(Feedback::hint, tr("Volume %1").arg(sound_->volume()));
  });
  on(actions_->quieter, [this] {
    set_volume(sound_->volume() - 10);
    desk().say(Feedback::hint, tr("Volume %1").arg(sound_->volume()));
  });
  on(actions_->mute, [this](bool muted) { set_muted(muted); });
  connect(sound_, &FunctionSound::unavailable, this, [this](const base::Error& error) {
    desk().say(Feedback::advice, tr("Nothing can be heard: %1.").arg(reason(error)));
  });
  connect(&touch_timer_, &QTimer::timeout, this, &FunctionsWorkplace::follow_stylus);
}

void FunctionsWorkplace::connect_work() {
  connect(plotter_, &Plotter::drawn, this, &FunctionsWorkplace::take_drawing);
  connect(plotter_, &Plotter::progressed, panel_, &PlotPanel::show_progress);
  connect(plotter_, &Plotter::rested, this, [this] { panel_->show_progress(-1); });
  connect(plotter_, &Plotter::failed, this, [this](const base::Error& error) {
    desk().say(Feedback::wrong, tr("This cannot be drawn: %1. The plate is as it was.").arg(reason(error)));
  });
  connect(export_, &PlotExport::composed, this,
          [this](const functions::Sound& sound) { sound_->play(sound); });
  connect(export_, &PlotExport::written, this, [this](const QString& path) {
    desk().say(Feedback::good, tr("%1 is saved.").arg(QFileInfo(path).fileName()));
  });
  connect(export_, &PlotExport::failed, this, [this](const QString& path, const base::Error& error) {
    desk().say(Feedback::wrong, tr("%1 was not saved: %2.").arg(QFileInfo(path).fileName(), reason(error)));
  });
}

void FunctionsWorkplace::read_expression() {
  const QString text = panel_->line()->text();
  auto plot = functions::parse(text.toStdString(), {uses_decimal_comma()});
  if (!plot) {
    panel_->show_error(plot.error());
    return;
  }
  panel_->show_words(localised(functions::in_words(*plot, plot_language())));
  plot_ = std::move(*plot);
  expression_ = text;
  tell_summary_ = true;
  emit title_changed();
  desk().save_later();
  draw();
}

void FunctionsWorkplace::draw() {
  // Nothing is drawn for a workplace that nobody looks at; enter() does it.
  if (!plot_ || !entered_) return;
  panel_->show_progress(0);
  plotter_->draw({*plot_, window_, plate_, plot_language()});
}

void FunctionsWorkplace::set_window(const functions::Window& window) {
  if (!window.check()) {
    desk().say(Feedback::advice, tr("The window cannot be changed any further."));
    return;
  }
  window_ = window;
  panel_->show_window(window);
  desk().save_later();
  tell_summary_ = false;
  draw();
  desk().say(Feedback::hint, window_words(window) + QLatin1Char('.'));
}

void FunctionsWorkplace::zoom(double times) {
  const auto& place = tracer_.place();
  const functions::PlatePoint about = place ? functions::PlatePoint{window_.u(place->x), window_.v(place->y)}
                                            : functions::PlatePoint{0.5, 0.5};
  // Window::zoomed: above 1 the window is drawn larger, so it shows a smaller part.
  set_window(window_.zoomed(about, times));
}

void FunctionsWorkplace::pan(double du, double dv) { set_window(window_.moved(du, dv)); }

void FunctionsWorkplace::take_drawing(const SharedDrawing& drawing) {
  drawing_ = drawing;
  touched_ = nullptr;
  if (drawing->final) {
    tracer_.set_drawing(drawing);
    points_->show_drawing(drawing);
  }
  if (!entered_) return;
  desk().controller().set_tablet(drawing->tablet);
  if (drawing->final) {
    if (put_ && tracer_.place()) put_stylus();
    if (tell_summary_ && !panel_->line()->hasFocus()) desk().say(Feedback::hint, localised(drawing->summary));
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
    desk().say(Feedback::hint, tr("There is no curve to follow here."));
    return;
  }
  const auto& window = drawing_->asked.window;
  if (point == nullptr) point = tracer_.point_here();
  QStringList words;
  if (!before.isEmpty()) words.append(before);
  words.append(point != nullptr ? point_words(*point) : place_words(*place));
  desk().say(Feedback::hint, words.join(QStringLiteral(": ")) + QLatin1Char('.'));
  sound_->touch_briefly(functions::cue_at(place->at, window, place->on ? 1 : 0));
  if (point != nullptr) sound_->sign(point->kind, 2 * place->at.u - 1);
  put_stylus();
}

void FunctionsWorkplace::put_stylus() {
  const auto size = drawing_->picture.plate.heights.size();
  const auto from = put_;
  put_ = functions::tablet_place(tracer_.place()->at, size, drawing_->tablet->shape());
  auto& controller = desk().controller();
  if (from && std::hypot(from->x - put_->x, from->y - put_->y) < kSlide_m) {
    controller.move_stylus(*put_, true);
    return;
  }
  // Over walls a stylus is lifted; pressed, it would stay behind one.
  controller.move_stylus(*put_, false);
  QTimer::singleShot(kLift_ms, this, [this, to = *put_] {
    if (entered_ && put_ && put_->x == to.x && put_->y == to.y) desk().controller().move_stylus(to, true);
  });
}

void FunctionsWorkplace::go_to_point(const functions::PointOfInterest* point) {
  if (point == nullptr) {
    desk().say(Feedback::hint, tr("There are no points of interest in this window."));
    return;
  }
  tracer_.go_to(*point);
  points_->set_current(static_cast<int>(point - drawing_->points.data()));
  show_place({}, point);
}

void FunctionsWorkplace::follow_stylus() {
  auto& controller = desk().controller();
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
  const auto near = tracer_.nearest(hand);
  const double reach = 3 * drawing_->asked.plate.half_width;
  const double nearness = near ? std::clamp(1 - near->on->distance / reach, 0.0, 1.0) : 0.0;
  const auto settings = sound_settings();
  sound_->touch(functions::cue_at(near ? near->at : hand, drawing_->asked.window, nearness, settings));
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
    desk().say(Feedback::hint, tr("A surface has no curve to play."));
    return;
  }
  if (sound_->muted()) {
    desk().say(Feedback::hint, tr("The sound is off. M turns it on."));
    return;
  }
  desk().say(Feedback::hint, localised(functions::in_words(drawing_->asked.plot, plot_language())));
  export_->compose(drawing_, sound_settings());
}

void FunctionsWorkplace::change_speed(int by) {
  speed_ = std::clamp(speed_ + by, kSlowest, kFastest);
  desk().save_later();
  desk().say(Feedback::hint, tr("Speed %1 of %2").arg(speed_).arg(kFastest));
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

void FunctionsWorkplace::show_piece() {
  const auto& controller = desk().controller();
  const int piece = controller.current_stroke();
  if (piece == 0 || !drawing_) {
    desk().say(Feedback::hint, tr("%n pieces", nullptr, controller.stroke_count()));
    return;
  }
  const auto statement = drawing_->statements[static_cast<std::size_t>(piece - 1)];
  desk().say(
      Feedback::hint,
      tr("Piece %1 of %2: %3")
          .arg(piece)
          .arg(controller.stroke_count())
          .arg(localised(functions::in_words(
              drawing_->asked.plot.statements[static_cast<std::size_t>(statement)], plot_language()))));
}

functions::PlotDocument FunctionsWorkplace::document() const {
  functions::PlotDocument document;
  document.expression = expression_.toStdString();
  document.reading.decimal_comma = uses_decimal_comma();
  document.window = window_;
  document.plate = plate_;
  document.sound = sound_settings();
  return document;
}

void FunctionsWorkplace::take_document(const functions::PlotDocument& document) {
  window_ = first_window_ = document.window;
  plate_ = document.plate;
  speed_ = std::clamp(static_cast<int>(std::lround(12.0 / document.sound.seconds)) - 1, kSlowest, kFastest);
  panel_->show_window(window_);
  panel_->show_plate(plate_);
  auto* line = panel_->line();
  const QString text = QString::fromStdString(document.expression);
  line->remember(text);
  if (line->text() == text)
    read_expression();
  else
    line->setText(text);
}

bool FunctionsWorkplace::opens(const QStringList& paths) const {
  return paths.size() == 1 && QFileInfo(paths.front()).suffix().toLower() == QLatin1String("json");
}

void FunctionsWorkplace::open_files(const QStringList& paths) {
  const auto document = functions::load_document(paths.front().toStdString());
  if (!document) {
    desk().say(Feedback::wrong, tr("%1 was not opened: %2. The plate is as it was.")
                                    .arg(QFileInfo(paths.front()).fileName(), reason(document.error())));
    return;
  }
  if (!entered_) emit wants_to_be_entered();
  take_document(*document);
  desk().say(Feedback::good, tr("%1 is on the desk.").arg(QFileInfo(paths.front()).fileName()));
}

void FunctionsWorkplace::ask_and_open() {
  const QString path =
      QFileDialog::getOpenFileName(&desk().window(), tr("Open a plot"), desk().preferences().folder,
                                   PlotExport::filter(PlotFile::document));
  if (path.isEmpty()) return;
  desk().preferences().folder = QFileInfo(path).absolutePath();
  open_files({path});
}

void FunctionsWorkplace::ask_and_save() { ask_and_write(PlotFile::document); }

void FunctionsWorkplace::ask_and_write(PlotFile kind) {
  if (!drawing_ || !drawing_->final) {
    desk().say(Feedback::advice, tr("There is no plot to save yet."));
    return;
  }
  QString folder = desk().preferences().folder;
  if (folder.isEmpty()) folder = QStandardPaths::writableLocation(QStandardPaths::HomeLocation);
  const QString suffix = PlotExport::suffix(kind);
  QString path = QFileDialog::getSaveFileName(&desk().window(), tr("Save as"),
                                              QStringLiteral("%1/%2.%3").arg(folder, tr("plot"), suffix),
                                              PlotExport::filter(kind));
  desk().focus_tablet();
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + suffix;
  desk().preferences().folder = QFileInfo(path).absolutePath();
  desk().save_later();
  write(kind, path);
}

void FunctionsWorkplace::write(PlotFile kind, const QString& path) {
  export_->write(kind, path, drawing_, document());
}

bool FunctionsWorkplace::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
    return Workplace::eventFilter(watched, event);
  if (QApplication::activeModalWidget() != nullptr || QApplication::activePopupWidget() != nullptr)
    return false;
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
