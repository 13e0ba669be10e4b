// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>
#include <QString>

namespace nazori::ui::test {

/// An application that measures how long the thread of the window works on each event. It measures the
/// processor time of the thread, so a busy machine does not matter. The work of a nested event loop counts
/// for the events of that loop.
class WatchedApplication final : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override;
};

/// The longest event since this object was made.
class Watchdog {
 public:
  Watchdog();
  /// Longest event [ms of processor time]; what a sanitizer adds is taken off.
  [[nodiscard]] static double longest_ms();
  /// Which event it was.
  [[nodiscard]] static QString longest();
  /// What all threads of the process worked since this object was made [ms of processor time]; what a
  /// sanitizer adds is taken off.
  [[nodiscard]] double all_threads_ms() const;

 private:
  double begin_ms_;
};

}  // namespace nazori::ui::test
