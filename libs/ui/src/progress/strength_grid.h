// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractListModel>
#include <QListView>
#include <QStyledItemDelegate>
#include <vector>

#include "nazori/study/statistics.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {

/// practice::StrengthLook in the colours of a palette.
struct StrengthLook {
  QColor fill;
  QColor text;
  QString sign;         ///< one character: ◔ ◑ ● ! ‖; none for a character that was not studied
  bool dashed = false;  ///< the edge
};
[[nodiscard]] StrengthLook look_of(study::Strength strength, const Colours& colours);

/// Characters, each with its strength.
class StrengthModel final : public QAbstractListModel {
  Q_OBJECT
 public:
  static constexpr int kStrengthRole = Qt::UserRole;

  using QAbstractListModel::QAbstractListModel;

  void set_states(std::vector<study::CharacterState> states);
  [[nodiscard]] char32_t at(int row) const;  ///< 0 outside
  /// "休, young, known with a chance of 93 %".
  [[nodiscard]] static QString words(const study::CharacterState& state);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::vector<study::CharacterState> states_;
};

/// Paints a character on the fill of its strength, with the sign in the corner.
class StrengthDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  [[nodiscard]] static int tile_side(const QFont& font);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

/// The grid: arrow keys walk, Enter opens a character.
class StrengthGrid final : public QListView {
  Q_OBJECT
 public:
  explicit StrengthGrid(QWidget* parent = nullptr);
  void show_states(std::vector<study::CharacterState> states);
  [[nodiscard]] const StrengthModel& states() const { return *model_; }

 signals:
  void opened(char32_t character);
  /// The words of the current character.
  void walked(QString words);

 private:
  StrengthModel* model_;
};

}  // namespace nazori::ui
