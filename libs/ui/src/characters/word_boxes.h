// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "nazori/practice/pen_recorder.h"
#include "nazori/view/tablet_view.h"

namespace nazori::ui {

/// The characters of a word in boxes beside each other, as far as they are written, as on squared paper.
class WordBoxes final : public QWidget {
  Q_OBJECT
 public:
  struct Box {
    std::vector<practice::HandStroke> strokes;
    std::vector<view::Verdict> verdicts;
    bool is_finished = false;
    bool is_right = false;  ///< of a finished one
    bool is_current = false;
  };

  explicit WordBoxes(QWidget* parent);
  void show_boxes(std::vector<Box> boxes);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] int side() const;

  std::vector<Box> boxes_;
};

}  // namespace nazori::ui
