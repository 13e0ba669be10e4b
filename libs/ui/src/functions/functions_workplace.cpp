// SPDX-License-Identifier: Apache-2.0
#include "functions/functions_workplace.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>
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
constexpr functions::Window kFirstWindow{-6, 6, -4, 4};

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
  connect_window();
  connect_sound();
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
  line->setCursorPosition(0);
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
  auto& controller = desk().tablet();
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
    desk().say(Feedback::hint, what_is_shown());
}

void FunctionsWorkplace::leave() {
  entered_ = false;
  QCoreApplication::instance()->removeEventFilter(this);
  touch_timer_.stop();
  export_->forget_sound();
  sound_->stop();
  auto& controller = desk().tablet();
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
  connect(panel_, &PlotPanel::heights_refused, this, [this](const QString& text) {
    desk().say(Feedback::wrong, tr("“%1” is no range of heights. The range is as it was.").arg(text));
  });
  connect(panel_, &PlotPanel::plate_changed, this, [this](const functions::PlateSettings& plate) {
    const int alone = plate_.alone;
    plate_ = plate;
    plate_.alone = alone;
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

void FunctionsWorkplace::connect_window() {
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
  plate_.alone = -1;
  actions_->alone->setChecked(false);
  panel_->show_surface(plot_->is_surface());
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
    desk().answer(Feedback::advice, tr("The window cannot be changed any further."));
    return;
  }
  window_ = window;
  panel_->show_window(window);
  desk().save_later();
  tell_summary_ = false;
  draw();
  desk().answer(Feedback::hint, window_words(window) + QLatin1Char('.'));
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
  desk().tablet().set_tablet(drawing->tablet);
  if (drawing->final) {
    if (put_ && tracer_.place()) put_stylus();
    if (tell_summary_ && !panel_->line()->hasFocus()) desk().say(Feedback::hint, localised(drawing->summary));
  }
}

}  // namespace nazori::ui
