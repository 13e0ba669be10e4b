// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStyledItemDelegate>

namespace nazori::ui {

/// A tile with one character in the textbook face and its strength, or the row of a search with the reason.
/// The size follows the text size.
class CharacterTileDelegate final : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void set_current(char32_t code_point) { current_ = code_point; }
  /// The side that suits a text size.
  [[nodiscard]] static int tile_side(const QFont& font);
  [[nodiscard]] static int row_height(const QFont& font);
  void set_side(int side) { side_ = side; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  int side_ = 48;
  char32_t current_ = 0;  ///< the character that is shown
};

}  // namespace nazori::ui
