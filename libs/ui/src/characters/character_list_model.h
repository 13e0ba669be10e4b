// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractListModel>

#include "nazori/practice/character_library.h"

namespace nazori::ui {

/// The characters of a list or of a search, in their order.
class CharacterListModel final : public QAbstractListModel {
  Q_OBJECT
 public:
  static constexpr int kCodePointRole = Qt::UserRole;

  using QAbstractListModel::QAbstractListModel;

  void set_characters(practice::Summaries characters);
  [[nodiscard]] int row_of(char32_t code_point) const;  ///< -1 where it is not in the list
  [[nodiscard]] char32_t at(int row) const;             ///< 0 outside

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  practice::Summaries characters_;
};

}  // namespace nazori::ui
