// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <QTimer>
#include <QWidget>

namespace nazori::ui {

/// Whether a sentence may wait for others.
enum class Urgency : std::uint8_t {
  queued,  ///< spoken together with what else is said in the next moment
  at_once  ///< spoken now, in place of what is waiting: errors and verdicts
};

/// Sentences for the screen reader, without anything to see. Assistive technology is told that a notification
/// with the sentence is shown: Orca speaks that, while it ignores a changed name of a widget without the
/// keyboard. Thread: interface.
class SpokenLine final : public QWidget {
  Q_OBJECT
 public:
  /// @param wait_ms  how long a queued sentence waits for others.
  explicit SpokenLine(QWidget* parent, int wait_ms = 120);

  /// A sentence that is waiting already is not said twice.
  void speak(Urgency urgency, const QString& sentence);

 signals:
  /// Assistive technology was told this.
  void spoken(QString text);

 private:
  void send(const QString& text);

  QStringList waiting_;
  QTimer timer_;
};

}  // namespace nazori::ui
