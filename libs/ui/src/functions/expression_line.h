// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLineEdit>
#include <QStringList>

namespace nazori::ui {

/// The field for an expression. Up and down go through earlier entries. The position of an error is
/// underlined with a zigzag.
class ExpressionLine final : public QLineEdit {
  Q_OBJECT
 public:
  static constexpr int kMostEntries = 50;

  explicit ExpressionLine(QWidget* parent = nullptr);

  /// Newest last.
  [[nodiscard]] const QStringList& history() const { return history_; }
  void set_history(const QStringList& history);
  void remember(const QString& expression);

  /// @param column  in code points from 1; 0: there is no error.
  void mark_error(int column);
  [[nodiscard]] int marked_column() const { return error_column_; }

 signals:
  /// Enter was pressed.
  void entered();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void recall(int step);

  QStringList history_;
  qsizetype at_ = 0;  ///< in the history; its size: the line that is being typed
  QString draft_;
  int error_column_ = 0;
};

}  // namespace nazori::ui
