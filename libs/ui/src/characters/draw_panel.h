// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <cstdint>

#include "desk.h"

class QLabel;
class QListWidget;

namespace nazori::ui {

class DrawingPad;

/// Finding a character by drawing it: the likeliest are listed while the drawing goes on.
class DrawPanel final : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kMostCandidates = 20;

  DrawPanel(Desk& desk, QWidget* parent);

  /// Empty paper, and the keyboard.
  void begin();
  [[nodiscard]] DrawingPad& pad() const { return *pad_; }

 signals:
  void character_chosen(char32_t code_point);
  void closed();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void ask();
  void show_candidates(const std::vector<writing::Candidate>& candidates);
  void choose(int row);
  void select(int by);
  bool take_key(int key, Qt::KeyboardModifiers modifiers);
  void fit();

  Desk& desk_;
  DrawingPad* pad_;
  QListWidget* candidates_;
  QLabel* words_;
  std::uint64_t ticket_ = 0;
};

}  // namespace nazori::ui
