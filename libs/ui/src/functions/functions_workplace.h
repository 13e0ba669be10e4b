// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <optional>

#include "functions/curve_tracer.h"
#include "functions/plot_export.h"
#include "functions/plotter.h"
#include "workplace.h"

namespace nazori::ui {

class FunctionActions;
class FunctionSound;
class PlotPanel;
class PointsPanel;

/// The workplace for functions: an expression on the left is carved while it is typed, its points of interest
/// stand on the right, and keys, stylus and sound go along its curves.
class FunctionsWorkplace final : public Workplace {
  Q_OBJECT
 public:
  explicit FunctionsWorkplace(Desk& desk);
  ~FunctionsWorkplace() override;

  [[nodiscard]] QString id() const override;
  [[nodiscard]] QString name() const override;
  [[nodiscard]] QString purpose() const override;
  [[nodiscard]] Icon drawing() const override;
  [[nodiscard]] QString title() const override;
  [[nodiscard]] Panel left() const override;
  [[nodiscard]] Panel right() const override;
  [[nodiscard]] ActionSet* actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;
  [[nodiscard]] QString tablet_description() const override;

  void enter() override;
  void leave() override;
  void take_appearance() override;
  void save(QSettings& settings) const override;

  [[nodiscard]] bool opens(const QStringList& paths) const override;
  void open_files(const QStringList& paths) override;
  [[nodiscard]] bool has_files() const override { return true; }
  void ask_and_open() override;
  void ask_and_save() override;

  /// What is on the plate now; null before the first picture.
  [[nodiscard]] const SharedDrawing& shown() const { return drawing_; }
  [[nodiscard]] bool is_drawing() const { return plotter_->is_busy(); }
  [[nodiscard]] const std::optional<TracePlace>& place() const { return tracer_.place(); }
  /// Writes without asking for a name.
  void write(PlotFile kind, const QString& path);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void load(const QSettings& settings);
  void connect_panels();
  void connect_trace();
  void connect_window();
  void connect_sound();
  void connect_work();

  void read_expression();
  void draw();
  void set_window(const functions::Window& window);
  void zoom(double times);
  void pan(double du, double dv);
  void take_drawing(const SharedDrawing& drawing);
  void take_document(const functions::PlotDocument& document);
  [[nodiscard]] functions::PlotDocument document() const;
  [[nodiscard]] functions::SoundSettings sound_settings() const;
  void ask_and_write(PlotFile kind);

  /// The hand is at another place by key: stylus, tone and words follow.
  /// @param point  what is there; nullptr: the point of interest that is nearest.
  void show_place(const QString& before = {}, const functions::PointOfInterest* point = nullptr);
  void put_stylus();
  void show_step(CurveTracer::Step step);
  void go_to_point(const functions::PointOfInterest* point);
  void follow_stylus();
  void sound_touched(functions::PlatePoint hand);
  void hear();
  /// The tone of y = 0, to compare with.
  void play_reference();
  void change_speed(int by);
  void set_volume(int percent);
  void set_muted(bool muted);
  void show_piece();
  [[nodiscard]] bool has_curve() const;
  /// Says why not, where nothing can be heard.
  [[nodiscard]] bool can_be_heard() const;
  /// The summary, or why there is none. Only while something is shown.
  [[nodiscard]] QString what_is_shown() const;
  /// One statement without the others; -1: all.
  void show_alone(int statement);

  static constexpr int kSlowest = 1;
  static constexpr int kFastest = 10;
  struct TabletSwitches {
    bool strokes, numbers, arrows, snapping;
  };

  FunctionActions* actions_;
  PlotPanel* panel_;
  PointsPanel* points_;
  FunctionSound* sound_;
  Plotter* plotter_;
  PlotExport* export_;

  bool entered_ = false;
  std::optional<TabletSwitches> before_;  ///< what the tablet showed before this workplace had it
  std::optional<functions::Plot> plot_;   ///< the last that could be read
  QString expression_;                    ///< as typed, of plot_
  functions::Window window_;
  functions::Window first_window_;
  functions::PlateSettings plate_;
  int speed_ = 2;
  bool snapping_ = false;
  bool tell_summary_ = true;  ///< the next picture is of another expression
  SharedDrawing drawing_;
  CurveTracer tracer_;
  std::optional<geometry::TabletPoint> put_;  ///< where keys have put the stylus
  const functions::PointOfInterest* touched_ = nullptr;
  QTimer touch_timer_;
};

}  // namespace nazori::ui
