// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QStatusBar>
#include <QTimer>
#include <cstdint>

class QLabel;

namespace nazori::practice {
class TabletControl;
class TabletRecording;
}  // namespace nazori::practice

namespace nazori::ui {

/// What one writes with, and a recording that runs. With figures also the depth, the real rate of the servo,
/// how long a tick takes and how late it comes, the age of the drawn pose, and missed ticks. Updated once a
/// second.
class StatusLine final : public QStatusBar {
  Q_OBJECT
 public:
  StatusLine(practice::TabletControl& controller, practice::TabletRecording& recording, QWidget* parent);

  void show_depth(double depth_m);
  /// Figures are for the page of devices: a learner has no use for them.
  void show_figures(bool shown);
  /// A page that says itself what one writes with needs no second line of it.
  void show_input(bool shown);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  void look();
  void show_device();
  void show_recording();

  practice::TabletControl& controller_;
  practice::TabletRecording& recording_;
  QLabel* record_;
  QLabel* device_;
  QLabel* rate_;
  QLabel* timing_;
  QLabel* missed_;
  QLabel* depth_;
  QTimer timer_;
  QTimer again_;  ///< lays the labels out again once their font has changed
  QElapsedTimer since_;
  std::uint64_t ticks_ = 0;
  bool has_figures_ = false;
  bool has_input_ = true;
};

}  // namespace nazori::ui
