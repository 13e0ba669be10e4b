// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "nazori/practice/writing_replay.h"
#include "nazori/view/inked_stroke.h"

class QPainter;

namespace nazori::ui {

/// The learner's writing beside the model, and both written again at once: the learner's at its true speed,
/// the model at a teacher's.
class CompareView final : public QWidget {
  Q_OBJECT
 public:
  explicit CompareView(QWidget* parent = nullptr);

  void show_writing(const std::vector<practice::HandStroke>& strokes,
                    const std::vector<view::Verdict>& verdicts, const practice::Tablet& model);
  void set_playing(bool playing);
  /// Shows both as they were at this time since the start [s].
  void show_moment(double time_s);
  /// When the longer of the two ends [s].
  [[nodiscard]] double duration_s() const { return replay_.duration_s(); }
  /// How many points of the writing are visible.
  [[nodiscard]] int points_shown() const { return static_cast<int>(replay_.points_written(time_s_)); }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 signals:
  /// The time of the replay [s]; below 0: it is over, everything is shown.
  void moment_shown(double time_s);
  void finished();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paint_own(QPainter& painter, const QRectF& box) const;
  void paint_model(QPainter& painter, const QRectF& box) const;
  practice::WritingReplay replay_;
  std::vector<view::Verdict> verdicts_;
  QTimer timer_;
  QElapsedTimer since_;
  double time_s_ = -1;  ///< below 0: all
};

}  // namespace nazori::ui
