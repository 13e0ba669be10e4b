// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include "nazori/widgets/words/feedback.h"

class QLabel;

namespace nazori::ui {

class SpokenLine;

/// One sentence and one sign below the tablet, also spoken by the screen reader.
class FeedbackLine final : public QFrame {
  Q_OBJECT
 public:
  explicit FeedbackLine(QWidget* parent = nullptr);
  void announce(Feedback kind, const QString& sentence);
  /// As announce(), but spoken even if the line already shows this sentence.
  void respond(Feedback kind, const QString& sentence);
  /// Only spoken: the line keeps its sentence.
  void speak_unseen(const QString& sentence);
  /// Writes in smaller letters and closer to its neighbours, where the tablet needs the room.
  void set_compact(bool is_compact);
  /// How many sentences were given to the screen reader.
  [[nodiscard]] int times_spoken() const { return times_spoken_; }
  [[nodiscard]] QString sentence() const;
  [[nodiscard]] Feedback kind() const { return kind_; }

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  /// Size of the text in a low window.
  [[nodiscard]] double compact_pt() const;
  void draw_sign();
  void speak(const QString& sentence);

  QLabel* sign_;
  QLabel* text_;
  SpokenLine* spoken_;
  int times_spoken_ = 0;
  bool is_compact_ = false;
  Feedback kind_ = Feedback::hint;
};

}  // namespace nazori::ui
