// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QWidget>

class QLabel;
class QSlider;

namespace nazori::ui {

/// How strictly writing is judged, from lenient through normal to strict and anything between.
class StrictnessSlider final : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kSteps = 20;  ///< from lenient to strict

  explicit StrictnessSlider(QWidget* parent);

  /// 0 lenient, 0.5 normal, 1 strict; rounded to a step.
  void set_strictness(double strictness);
  [[nodiscard]] double strictness() const;
  void step(int by);
  /// "Normal", "Between normal and strict".
  [[nodiscard]] QString words() const;

 signals:
  /// The learner moved the slider; set_strictness() does not emit it.
  void moved(double strictness);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_words();

  QSlider* slider_;
  QLabel* words_;
  QList<QLabel*> marks_;
  bool silent_ = false;
};

}  // namespace nazori::ui
