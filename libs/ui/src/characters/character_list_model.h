// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractListModel>
#include <functional>
#include <memory>
#include <vector>

#include "nazori/practice/character_library.h"
#include "nazori/study/statistics.h"

namespace nazori::ui {

/// The characters of a list, or the rows of the answer to a search, in their order.
class CharacterListModel final : public QAbstractListModel {
  Q_OBJECT
 public:
  static constexpr int kCodePointRole = Qt::UserRole;
  static constexpr int kStrengthRole = Qt::UserRole + 1;  ///< study::Strength as int
  static constexpr int kWhyRole = Qt::UserRole + 2;       ///< why a row was found; empty in a list
  using StrengthOf = std::function<study::Strength(char32_t)>;

  using QAbstractListModel::QAbstractListModel;

  void set_characters(practice::Summaries characters);
  void set_answer(std::shared_ptr<const practice::SearchAnswer> answer);
  /// How well each character is known; empty: nothing is known of a learner.
  void set_strengths(StrengthOf strength_of);
  /// Something was studied.
  void refresh_strengths();
  [[nodiscard]] int row_of(char32_t code_point) const;  ///< -1 where it is not in the list
  [[nodiscard]] char32_t at(int row) const;             ///< to open; 0 outside

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  [[nodiscard]] const kanji::Summary& summary(int row) const;
  [[nodiscard]] const practice::SearchRow* found(int row) const;  ///< nullptr in a list
  [[nodiscard]] QString describe(int row, const QString& separator) const;

  practice::Summaries characters_;
  std::shared_ptr<const practice::SearchAnswer> answer_;  ///< in place of the list
  StrengthOf strength_of_;
};

}  // namespace nazori::ui
