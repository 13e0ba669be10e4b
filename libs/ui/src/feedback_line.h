// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <cstdint>

class QLabel;

namespace nazori::ui {

/// What a sentence is, and so its sign and colour: never the colour alone.
enum class Feedback : std::uint8_t {
  hint,    ///< what to do
  good,    ///< a tick
  advice,  ///< a warning sign
  wrong,   ///< a cross
};

/// One sentence and one sign below the tablet, also spoken to assistive technology.
class FeedbackLine final : public QFrame {
  Q_OBJECT
 public:
  explicit FeedbackLine(QWidget* parent = nullptr);
  void say(Feedback kind, const QString& sentence);
  /// As say(), but spoken also where it is what stands here already.
  void answer(Feedback kind, const QString& sentence);
  [[nodiscard]] QString sentence() const;
  [[nodiscard]] Feedback kind() const { return kind_; }

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  void draw_sign();
  void speak(const QString& sentence);

  QLabel* sign_;
  QLabel* text_;
  Feedback kind_ = Feedback::hint;
};

}  // namespace nazori::ui
