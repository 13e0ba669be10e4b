// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <cstdint>

#include "nazori/widgets/page/window_parts.h"

class QComboBox;
class QLabel;
class QListWidget;

namespace nazori::ui {

class DrawingPad;

/// Finds a character by a drawing: the most likely ones are listed while the learner draws.
class DrawPanel final : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kMostCandidates = 20;

  DrawPanel(WindowParts& parts, QWidget* parent);

  /// Clears the paper and takes the keyboard focus.
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
  void show_candidates(const std::vector<practice::FoundCharacter>& candidates);
  void choose(int row);
  void select(int by);
  /// Searches all characters, kana, kanji or letters.
  void choose_among(int by);
  bool handle_key(int key, Qt::KeyboardModifiers modifiers);
  void fit();

  WindowParts& parts_;
  DrawingPad* pad_;
  QComboBox* among_;
  QListWidget* candidates_;
  QLabel* words_;
  std::uint64_t ticket_ = 0;
};

}  // namespace nazori::ui
