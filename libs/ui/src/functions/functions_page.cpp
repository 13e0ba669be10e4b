// SPDX-License-Identifier: Apache-2.0
#include "functions/functions_page.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>

#include "functions/expression_line.h"
#include "functions/function_actions.h"
#include "functions/function_sound.h"
#include "functions/plot_panel.h"
#include "functions/plot_words.h"
#include "functions/points_panel.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kTouch_ms = 25;

}  // namespace

FunctionsPage::FunctionsPage(WindowParts& parts)
    : Page(parts,
           {QStringLiteral("functions"), tr("F&unctions"), tr("Curves to see, feel and hear"), Icon::curve,
            tr("The plot as grooves. Left and Right: move along the curve. Up and Down: go to another curve. "
               "N: next point of interest. H: play it. S: summary. Ctrl+L: expression. Ctrl+T: table")}),
      actions_(new FunctionActions(&parts.window())),
      panel_(new PlotPanel(&parts.window())),
      points_(new PointsPanel(&parts.window())),
      sound_(new FunctionSound(this)),
      hand_(parts.tablet(), explorer_) {
  touch_timer_.setInterval(kTouch_ms);
  QSettings settings(parts.settings_file(), QSettings::IniFormat);
  settings.beginGroup(id());
  load(settings);
  connect_panels();
  connect_trace();
  connect_window();
  connect_sound();
  connect_work();
  points_->show_drawing({});
}

FunctionsPage::~FunctionsPage() = default;

QString FunctionsPage::title() const { return QString::fromStdString(model_.expression()); }

Page::Panel FunctionsPage::left() const {
  return {panel_, tr("&Expression and range"), tr("Show or hide the expression")};
}

Page::Panel FunctionsPage::right() const {
  return {points_, tr("&Points of interest"), tr("Show or hide the points of interest")};
}

ActionSet* FunctionsPage::actions() const { return actions_; }

QList<Tool> FunctionsPage::tools() const {
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

void FunctionsPage::load(const QSettings& settings) {
  const base::Settings values = read_settings(settings);
  model_.load(values);
  snapping_ = base::flag_setting(values, "snapping", false);
  sound_->set_volume(static_cast<int>(base::number_setting(values, "volume", 50, 0, 100)));
  sound_->set_muted(base::flag_setting(values, "muted", false));
  set_plot_speech(static_cast<functions::SpeechStyle>(base::number_setting(values, "speech", 0, 0, 2)));
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

void FunctionsPage::save(QSettings& settings) const {
  auto values = read_settings(settings);
  model_.save(values);
  base::set_flag(values, "snapping", snapping_);
  base::set_number(values, "volume", sound_->volume());
  base::set_number(values, "speech", static_cast<int>(plot_speech()));
  base::set_flag(values, "muted", sound_->muted());
  write_settings(settings, values);
  settings.setValue(QStringLiteral("expression"), model_.expression().empty()
                                                      ? panel_->line()->text()
                                                      : QString::fromStdString(model_.expression()));
  settings.setValue(QStringLiteral("history"), panel_->line()->history());
}

void FunctionsPage::enter() {
  entered_ = true;
  auto& controller = parts().tablet();
  before_ = controller.switches();
  controller.set_switches({true, false, false, snapping_});
  actions_->snap->setChecked(snapping_);
  controller.set_tablet(tablet_);
  QCoreApplication::instance()->installEventFilter(this);
  touch_timer_.start();
  panel_->refresh_appearance();
  if (!shown())
    read_expression();
  else
    parts().announce(Feedback::hint, what_is_shown());
}

void FunctionsPage::leave() {
  entered_ = false;
  QCoreApplication::instance()->removeEventFilter(this);
  touch_timer_.stop();
  export_.forget_sound();
  sound_->stop();
  auto& controller = parts().tablet();
  controller.lift_stylus();
  if (before_) controller.set_switches(*before_);
}

void FunctionsPage::refresh_appearance() { panel_->refresh_appearance(); }

void FunctionsPage::connect_panels() {
  auto* line = panel_->line();
  connect(panel_, &PlotPanel::expression_typed, this, [this] { read_expression(); });
  connect(line, &ExpressionLine::entered, this, [this, line] {
    if (line->marked_column() > 0) {
      parts().announce(Feedback::wrong, line->accessibleDescription());
      return;
    }
    line->remember(line->text());
    parts().save_later();
    parts().close_drawers();
    parts().focus_tablet();
    if (shown() && shown()->final && !plotter_.is_busy())
      parts().announce(Feedback::good, localised(shown()->summary));
  });
  connect(panel_, &PlotPanel::parameter_moved, this, &FunctionsPage::set_parameter);
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
      parts().announce(Feedback::wrong, tr("This range cannot be shown: %1.").arg(reason(started.error())));
      panel_->show_window(model_.window());
      return;
    }
    show_window(model_.reset_window());
  });
  connect(panel_, &PlotPanel::window_refused, this, [this](const QString& text) {
    parts().announce(Feedback::wrong, tr("“%1” is not a number. The range was not changed.").arg(text));
  });
  connect(panel_, &PlotPanel::heights_refused, this, [this](const QString& text) {
    parts().announce(Feedback::wrong,
                     tr("“%1” is not a valid height range. The range was not changed.").arg(text));
  });
  connect(panel_, &PlotPanel::plate_changed, this, [this](const functions::PlateSettings& plate) {
    model_.set_plate(plate);
    parts().save_later();
    draw();
  });
  connect(panel_, &PlotPanel::volume_changed, this, &FunctionsPage::set_volume);
  connect(panel_, &PlotPanel::mute_changed, this, &FunctionsPage::set_muted);
  connect(points_, &PointsPanel::point_chosen, this, [this](int row) {
    if (shown() && row >= 0 && row < static_cast<int>(shown()->points.size()))
      announce(explorer_.go_to_point(static_cast<std::size_t>(row)));
  });
}

void FunctionsPage::connect_window() {
  on(actions_->expression, [this] {
    parts().open_left_panel();
    panel_->line()->setFocus(Qt::ShortcutFocusReason);
    panel_->line()->selectAll();
    parts().window().activateWindow();
  });
  on(actions_->points, [this] {
    parts().window().activateWindow();
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
  on(actions_->make_model, [this] { ask_model(); });
}

void FunctionsPage::connect_work() {
  plotter_.drawn.connect([this](const practice::TabletPlot& plot) { show_plot(plot); });
  plotter_.progressed.connect([this](double done) { panel_->show_progress(done); });
  plotter_.rested.connect([this] { panel_->show_progress(-1); });
  plotter_.failed.connect([this](const base::Error& error) {
    parts().announce(Feedback::wrong,
                     tr("This cannot be drawn: %1. The plot was not changed.").arg(reason(error)));
  });
  const auto name_of = [](const std::filesystem::path& path) {
    return QFileInfo(QString::fromStdString(path.string())).fileName();
  };
  export_.composed.connect([this](const functions::Sound& sound) { sound_->play(sound); });
  export_.written.connect([this, name_of](const std::filesystem::path& path) {
    parts().announce(Feedback::good, tr("Saved %1.").arg(name_of(path)));
  });
  export_.failed.connect([this, name_of](const std::filesystem::path& path, const base::Error& error) {
    parts().announce(Feedback::wrong, tr("Could not save %1: %2.").arg(name_of(path), reason(error)));
  });
}

void FunctionsPage::read_expression() {
  if (const auto read = model_.read(panel_->line()->text().toStdString(), {uses_decimal_comma()}); !read) {
    panel_->show_error(read.error());
    return;
  }
  const auto& plot = *model_.plot();
  panel_->show_words(localised(functions::in_words(plot, plot_language(), plot_speech())));
  announce_summary_ = true;
  actions_->alone->setChecked(false);
  panel_->show_parameters(plot.parameters);
  panel_->show_surface(plot.is_surface());
  emit title_changed();
  parts().save_later();
  draw();
}

void FunctionsPage::set_parameter(const QString& letter, double value) {
  auto* line = panel_->line();
  const auto text = functions::with_parameter(line->text().toStdString(), letter.toStdString(), value,
                                              {uses_decimal_comma()});
  if (!text || to_text(*text) == line->text()) return;
  // Inserted, because setText() would end what can be undone in the line.
  line->selectAll();
  line->insert(to_text(*text));
  // Who moves a slider hears the value; the summary of each picture would follow it too late.
  announce_summary_ = false;
  parts().respond(Feedback::hint, tr("%1 = %2").arg(letter, QLocale().toString(value, 'g', 10)));
}

void FunctionsPage::draw() {
  // A page that is not shown draws nothing. enter() does it later.
  if (!model_.plot() || !entered_) return;
  panel_->show_progress(0);
  plotter_.draw(model_.request(plot_language(), plot_speech()));
}

void FunctionsPage::show_window(const functions::PlotEvent& event) {
  if (event.kind == functions::PlotEventKind::window_limit) {
    parts().respond(Feedback::advice, event_words(event, {}));
    return;
  }
  panel_->show_window(event.window);
  parts().save_later();
  announce_summary_ = false;
  draw();
  parts().respond(Feedback::hint, event_words(event, {}));
}

void FunctionsPage::show_plot(const practice::TabletPlot& plot) {
  const auto& drawing = *plot.drawing;
  tablet_ = plot.tablet;
  explorer_.show(plot.drawing);
  if (drawing.final) points_->show_drawing(plot.drawing);
  if (!entered_) return;
  parts().tablet().set_tablet(tablet_);
  if (!drawing.final) return;
  if (hand_.is_put() && explorer_.location()) put_stylus();
  if (announce_summary_ && !panel_->line()->hasFocus())
    parts().announce(Feedback::hint, localised(drawing.summary));
}

}  // namespace nazori::ui
