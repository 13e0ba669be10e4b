// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>

namespace nazori::ui {

class CompareView;
class StrictnessSlider;
class WritingReport;

/// The panel beside the tablet while the learner writes from memory: strictness, the writing beside the
/// model, and the report. As high as its content, but it leaves enough space for the information below.
class WritingPanel final : public QScrollArea {
  Q_OBJECT
 public:
  explicit WritingPanel(QWidget* parent);

  [[nodiscard]] StrictnessSlider& strictness() const { return *strictness_; }
  [[nodiscard]] CompareView& compare() const { return *compare_; }
  [[nodiscard]] WritingReport& report() const { return *report_; }
  void set_compare_shown(bool shown);
  void set_report_shown(bool shown);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* content_;
  StrictnessSlider* strictness_;
  CompareView* compare_;
  WritingReport* report_;
};

}  // namespace nazori::ui
