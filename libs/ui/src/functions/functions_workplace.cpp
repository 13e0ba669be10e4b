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

}  // namespace

FunctionsWorkplace::FunctionsWorkplace(Desk& desk)
    : Workplace(desk),
      actions_(new FunctionActions(&desk.window())),
      panel_(new PlotPanel(&desk.window())),
      points_(new PointsPanel(&desk.window())),
      sound_(new FunctionSound(this)) {
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
QString FunctionsWorkplace::title() const { return QString::fromStdString(model_.expression()); }

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
  const functions::Window& first = functions::PlotModel::kFirstWindow;
  const functions::Window window{number("x0", first.x0), number("x1", first.x1), number("y0", first.y0),
                                 number("y1", first.y1)};
  const auto flag = [&settings](const char* key, bool otherwise) {
    return settings.value(QString::fromLatin1(key), otherwise).toBool();
  };
  functions::PlateSettings plate;
  plate.layers = {flag("axes", true), flag("ticks", true), flag("grid", false), flag("rim", true)};
  plate.half_width = number("half_width", plate.half_width);
  plate.size = settings.value(QStringLiteral("size"), plate.size).toInt();
  model_.restore(window, plate, settings.value(QStringLiteral("speed"), model_.speed()).toInt());
  snapping_ = flag("snapping", false);
  sound_->set_volume(settings.value(QStringLiteral("volume"), 50).toInt());
  sound_->set_muted(flag("muted", false));
  auto* line = panel_->line();
  line->set_history(settings.value(QStringLiteral("history")).toStringList());
  line->setText(
      settings.value(QStringLiteral("expression"), QStringLiteral("y = tan(x); y = sin x")).toString());
  line->setCursorPosition(0);
  panel_->show_window(model_.window());
  panel_->show_plate(model_.plate());
  panel_->show_volume(sound_->volume(), sound_->muted());
  actions_->mute->setChecked(sound_->muted());
}

void FunctionsWorkplace::save(QSettings& settings) const {
  const auto& window = model_.window();
  const auto& plate = model_.plate();
  settings.setValue(QStringLiteral("expression"), model_.expression().empty()
                                                      ? panel_->line()->text()
                                                      : QString::fromStdString(model_.expression()));
  settings.setValue(QStringLiteral("history"), panel_->line()->history());
  settings.setValue(QStringLiteral("x0"), window.x0);
  settings.setValue(QStringLiteral("x1"), window.x1);
  settings.setValue(QStringLiteral("y0"), window.y0);
  settings.setValue(QStringLiteral("y1"), window.y1);
  settings.setValue(QStringLiteral("axes"), plate.layers.axes);
  settings.setValue(QStringLiteral("ticks"), plate.layers.ticks);
  settings.setValue(QStringLiteral("grid"), plate.layers.grid);
  settings.setValue(QStringLiteral("rim"), plate.layers.rim);
  settings.setValue(QStringLiteral("half_width"), plate.half_width);
  settings.setValue(QStringLiteral("size"), plate.size);
  settings.setValue(QStringLiteral("speed"), model_.speed());
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
  controller.set_tablet(tablet_);
  QCoreApplication::instance()->installEventFilter(this);
  touch_timer_.start();
  panel_->take_appearance();
  if (!shown())
    read_expression();
  else
    desk().say(Feedback::hint, what_is_shown());
}

void FunctionsWorkplace::leave() {
  entered_ = false;
  QCoreApplication::instance()->removeEventFilter(this);
  touch_timer_.stop();
  export_.forget_sound();
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
    if (shown() && shown()->final && !plotter_.is_busy())
      desk().say(Feedback::good, localised(shown()->summary));
  });
  connect(panel_, &PlotPanel::example_chosen, this,
          [this, line](const QString& expression, const functions::Window& window) {
            (void)model_.start_with(window);
            panel_->show_window(model_.window());
            line->remember(expression);
            if (line->text() == expression)
              draw();
            else
              line->setText(expression);
          });
  connect(panel_, &PlotPanel::window_typed, this, [this](const functions::Window& window) {
    if (const auto started = model_.start_with(window); !started) {
      desk().say(Feedback::wrong, tr("This window cannot be shown: %1.").arg(reason(started.error())));
      panel_->show_window(model_.window());
      return;
    }
    show_window(model_.reset_window());
  });
  connect(panel_, &PlotPanel::window_refused, this, [this](const QString& text) {
    desk().say(Feedback::wrong, tr("“%1” is no number. The window is as it was.").arg(text));
  });
  connect(panel_, &PlotPanel::heights_refused, this, [this](const QString& text) {
    desk().say(Feedback::wrong, tr("“%1” is no range of heights. The range is as it was.").arg(text));
  });
  connect(panel_, &PlotPanel::plate_changed, this, [this](const functions::PlateSettings& plate) {
    model_.set_plate(plate);
    desk().save_later();
    draw();
  });
  connect(panel_, &PlotPanel::volume_changed, this, &FunctionsWorkplace::set_volume);
  connect(panel_, &PlotPanel::mute_changed, this, &FunctionsWorkplace::set_muted);
  connect(points_, &PointsPanel::point_chosen, this, [this](int row) {
    if (shown() && row >= 0 && row < static_cast<int>(shown()->points.size()))
      announce(explorer_.go_to_point(static_cast<std::size_t>(row)));
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
  on(actions_->zoom_in, [this] { show_window(model_.zoom(explorer_.location(), 2)); });
  on(actions_->zoom_out, [this] { show_window(model_.zoom(explorer_.location(), 0.5)); });
  on(actions_->pan_left, [this] { show_window(model_.pan(-0.25, 0)); });
  on(actions_->pan_right, [this] { show_window(model_.pan(0.25, 0)); });
  on(actions_->pan_up, [this] { show_window(model_.pan(0, 0.25)); });
  on(actions_->pan_down, [this] { show_window(model_.pan(0, -0.25)); });
  on(actions_->reset_window, [this] { show_window(model_.reset_window()); });
  on(actions_->export_raw, [this] { ask_and_write(functions::PlotFile::raw); });
  on(actions_->export_png, [this] { ask_and_write(functions::PlotFile::png); });
  on(actions_->export_print, [this] { ask_and_write(functions::PlotFile::print); });
  on(actions_->export_sound, [this] { ask_and_write(functions::PlotFile::sound); });
}

void FunctionsWorkplace::connect_work() {
  plotter_.drawn.connect([this](const practice::TabletPlot& plot) { show_plot(plot); });
  plotter_.progressed.connect([this](double done) { panel_->show_progress(done); });
  plotter_.rested.connect([this] { panel_->show_progress(-1); });
  plotter_.failed.connect([this](const base::Error& error) {
    desk().say(Feedback::wrong, tr("This cannot be drawn: %1. The plate is as it was.").arg(reason(error)));
  });
  const auto name_of = [](const std::filesystem::path& path) {
    return QFileInfo(QString::fromStdString(path.string())).fileName();
  };
  export_.composed.connect([this](const functions::Sound& sound) { sound_->play(sound); });
  export_.written.connect([this, name_of](const std::filesystem::path& path) {
    desk().say(Feedback::good, tr("%1 is saved.").arg(name_of(path)));
  });
  export_.failed.connect([this, name_of](const std::filesystem::path& path, const base::Error& error) {
    desk().say(Feedback::wrong, tr("%1 was not saved: %2.").arg(name_of(path), reason(error)));
  });
}

void FunctionsWorkplace::read_expression() {
  if (const auto read = model_.read(panel_->line()->text().toStdString(), {uses_decimal_comma()}); !read) {
    panel_->show_error(read.error());
    return;
  }
  const auto& plot = *model_.plot();
  panel_->show_words(localised(functions::in_words(plot, plot_language())));
  announce_summary_ = true;
  actions_->alone->setChecked(false);
  panel_->show_surface(plot.is_surface());
  emit title_changed();
  desk().save_later();
  draw();
}

void FunctionsWorkplace::draw() {
  // Nothing is drawn for a workplace that nobody looks at; enter() does it.
  if (!model_.plot() || !entered_) return;
  panel_->show_progress(0);
  plotter_.draw(model_.request(plot_language()));
}

void FunctionsWorkplace::show_window(const functions::PlotEvent& event) {
  if (event.kind == functions::PlotEventKind::window_limit) {
    desk().answer(Feedback::advice, event_words(event, {}));
    return;
  }
  panel_->show_window(event.window);
  desk().save_later();
  announce_summary_ = false;
  draw();
  desk().answer(Feedback::hint, event_words(event, {}));
}

void FunctionsWorkplace::show_plot(const practice::TabletPlot& plot) {
  const auto& drawing = *plot.drawing;
  tablet_ = plot.tablet;
  explorer_.show(plot.drawing);
  if (drawing.final) points_->show_drawing(plot.drawing);
  if (!entered_) return;
  desk().tablet().set_tablet(tablet_);
  if (!drawing.final) return;
  if (put_ && explorer_.location()) put_stylus();
  if (announce_summary_ && !panel_->line()->hasFocus())
    desk().say(Feedback::hint, localised(drawing.summary));
}

}  // namespace nazori::ui
