// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStyledItemDelegate>

namespace nazori::ui {

/// A found character with a line under it that says what it is: カ katakana, 力 kanji "power".
class CandidateDelegate final : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  /// The item's line in small letters.
  static constexpr int kKindRole = Qt::UserRole + 1;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace nazori::ui
