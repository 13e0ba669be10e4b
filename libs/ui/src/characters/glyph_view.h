// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <memory>

#include "nazori/practice/character_library.h"

namespace nazori::ui {

/// One character, large, in the textbook face; drawn from its strokes where the font lacks it, or somebody
/// made its form.
class GlyphView final : public QWidget {
  Q_OBJECT
 public:
  explicit GlyphView(QWidget* parent = nullptr);
  void show_character(std::shared_ptr<const practice::CharacterSheet> sheet);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::shared_ptr<const practice::CharacterSheet> sheet_;
};

}  // namespace nazori::ui
