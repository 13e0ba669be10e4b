// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "nazori/functions/plate.h"
#include "nazori/functions/points.h"
#include "nazori/practice/tablet_workshop.h"
#include "worker.h"

namespace nazori::ui {

/// What is to be drawn: an expression that was read, and how it is to be shown.
struct PlotRequest {
  functions::Plot plot;
  functions::Window window;
  functions::PlateSettings plate;
  functions::Language language = functions::Language::english;
};

/// A plot that was drawn, with the tablet that it lies on. Immutable once it is told.
struct Drawing {
  PlotRequest asked;
  functions::Picture picture;
  practice::Tablet tablet;
  std::vector<int> statements;                     ///< of each line of the tablet
  std::vector<functions::PointOfInterest> points;  ///< of a final drawing
  std::string summary;                             ///< of a final drawing
  bool final = false;                              ///< false: coarse, a finer one follows
};
using SharedDrawing = std::shared_ptr<const Drawing>;

/// Draws plots on a thread of its own, coarse and then fine; a newer request stops an older one. Requests
/// return at once, answers come as signals on the thread of this object.
class Plotter final : public QObject {
  Q_OBJECT
 public:
  explicit Plotter(QObject* parent = nullptr);
  ~Plotter() override;

  void draw(const PlotRequest& request);
  /// What is being drawn is given up; what was shown stays.
  void stop();
  [[nodiscard]] bool is_busy() const { return busy_; }

 signals:
  void drawn(nazori::ui::SharedDrawing drawing);
  /// From 0 to 1 while it is busy.
  void progressed(double done);
  /// Stopped, failed or done.
  void rested();
  void failed(nazori::base::Error error);

 private:
  void rest(std::uint64_t ticket);

  std::atomic<std::uint64_t> newest_{0};
  bool busy_ = false;
  Worker worker_{QStringLiteral("plotter")};  // last: stops before what it uses goes
};

}  // namespace nazori::ui
