// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHash>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QWidget>

class QAbstractButton;
class QFontMetrics;
class QScrollArea;

namespace nazori::ui {

/// Wraps the text of buttons to the width of their panel, which buttons do not do by themselves. So a panel
/// with large text is as wide as one with small text. Thread: interface.
class ButtonLines final : public QObject {
 public:
  /// @param area  the panel; owns this. @param margin_px  of its content, on each side.
  ButtonLines(QScrollArea* area, int margin_px);

  /// From now on `button` shows `text`, in as many lines as it needs.
  void add(QAbstractButton* button, const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void break_lines(QAbstractButton* button) const;

  QPointer<QWidget> viewport_;  ///< the panel may be destroyed first
  int margin_px_;
  QHash<QAbstractButton*, QString> texts_;
};

/// The text in lines that are no wider than `width_px`, broken where the language allows; a word that is
/// wider by itself is broken where the width ends.
[[nodiscard]] QString in_lines(const QString& text, const QFontMetrics& metrics, int width_px);

}  // namespace nazori::ui
