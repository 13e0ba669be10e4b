// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <optional>

#include "nazori/functions/plot_explorer.h"
#include "nazori/functions/plot_export.h"
#include "nazori/functions/plot_model.h"
#include "nazori/practice/plot_hand.h"
#include "nazori/practice/tablet_plot.h"
#include "nazori/widgets/events/event_loop_inbox.h"
#include "nazori/widgets/page/page.h"

namespace nazori::ui {

class FunctionActions;
class FunctionSound;
class PlotPanel;
class PointsPanel;

/// The page for functions: an expression on the left is carved while it is typed, its points of interest are
/// listed on the right, and keys, stylus and sound follow its curves.
class FunctionsPage final : public Page {
  Q_OBJECT
 public:
  explicit FunctionsPage(WindowParts& parts);
  ~FunctionsPage() override;

  [[nodiscard]] QString title() const override;
  [[nodiscard]] Panel left() const override;
  [[nodiscard]] Panel right() const override;
  [[nodiscard]] ActionSet* actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;

  void enter() override;
  void leave() override;
  void refresh_appearance() override;
  void save(QSettings& settings) const override;

  [[nodiscard]] bool opens(const QStringList& paths) const override;
  void open_files(const QStringList& paths) override;
  [[nodiscard]] bool has_files() const override { return true; }
  void ask_and_open() override;
  void ask_and_save() override;

  /// The drawing that is shown; null before the first picture.
  [[nodiscard]] const functions::SharedDrawing& shown() const { return explorer_.drawing(); }
  /// The tablet of what is shown; null before the first picture.
  [[nodiscard]] const practice::Tablet& tablet() const { return tablet_; }
  [[nodiscard]] bool is_drawing() const { return plotter_.is_busy(); }
  [[nodiscard]] const std::optional<functions::PlotLocation>& location() const {
    return explorer_.location();
  }
  /// Writes without asking for a name.
  void write(functions::PlotFile kind, const QString& path);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void load(const QSettings& settings);
  void connect_panels();
  void connect_trace();
  void connect_window();
  void connect_sound();
  void connect_work();

  void read_expression();
  /// Writes another value of a parameter into the expression.
  void set_parameter(const QString& letter, double value);
  void draw();
  void show_window(const functions::PlotEvent& event);
  void show_plot(const practice::TabletPlot& plot);
  void open(const functions::PlotDocument& document);
  void ask_and_write(functions::PlotFile kind);
  /// Opens the dialog for a solid of the plot that is shown.
  void ask_model();

  /// Announces what a key did on the plot. If the position has moved, tone and stylus follow.
  void announce(const functions::PlotEvent& event);
  void put_stylus();
  void follow_stylus();
  void hear();
  /// Plays the tone of y = 0, for comparison.
  void play_reference();
  void set_volume(int percent);
  void set_muted(bool muted);
  void show_groove();
  /// Whether sound can be heard. If not, announces why.
  [[nodiscard]] bool can_be_heard() const;
  /// The summary, or why there is none. Only while something is shown.
  [[nodiscard]] QString what_is_shown() const;
  /// Draws and announces one curve or all of them, after the model has changed.
  void show_alone(const functions::PlotEvent& event);

  FunctionActions* actions_;
  PlotPanel* panel_;
  PointsPanel* points_;
  FunctionSound* sound_;
  bool entered_ = false;
  std::optional<practice::TabletControl::Switches>
      before_;  ///< what the tablet showed before this page was entered
  functions::PlotModel model_;
  functions::PlotExplorer explorer_;
  practice::PlotHand hand_;
  practice::Tablet tablet_;  ///< of the drawing that is shown
  bool snapping_ = false;
  bool announce_summary_ = true;  ///< the next picture is of another expression
  QTimer touch_timer_;
  EventLoopInbox inbox_;
  // Declared last so that their threads end before the objects they use are destroyed.
  functions::Plotter<practice::TabletPlot> plotter_{inbox_.inbox(), practice::on_tablet};
  functions::PlotExport export_{inbox_.inbox()};
};

}  // namespace nazori::ui
