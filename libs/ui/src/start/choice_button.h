// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QRadioButton>

namespace nazori::ui {

/// One of several answers, as a button that stays down. With a character it is a card.
class ChoiceButton final : public QRadioButton {
  Q_OBJECT
 public:
  /// @param name  object name. @param glyph  drawn large above the words; empty: only the words.
  /// @param more  a line below the words.
  ChoiceButton(const char* name, const QString& words, QWidget* parent, const QString& glyph = {},
               const QString& more = {});

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  [[nodiscard]] bool hitButton(const QPoint& position) const override { return rect().contains(position); }

 private:
  [[nodiscard]] QFont glyph_font() const;
  [[nodiscard]] QFont more_font() const;

  QString glyph_;
  QString more_;
};

}  // namespace nazori::ui
