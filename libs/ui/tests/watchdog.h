// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>
#include <QString>

namespace nazori::ui::test {

/// An application that measures how long the thread of the window works on each event. Time is the thread's
/// own processor time, so a busy machine changes nothing. What a nested event loop does is counted for its
/// own events.
class WatchedApplication final : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override;
};

/// The longest event since it was made.
class Watchdog {
 public:
  Watchdog();
  /// Longest event [ms of processor time]; what a sanitizer adds is taken off.
  [[nodiscard]] static double longest_ms();
  /// Which it was.
  [[nodiscard]] static QString longest();
};

}  // namespace nazori::ui::test
