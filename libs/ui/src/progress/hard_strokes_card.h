// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStyledItemDelegate>
#include <map>
#include <vector>

#include "nazori/kanji/kanji_database.h"
#include "nazori/study/statistics.h"
#include "nazori/widgets/charts/chart_card.h"

class QListWidget;

namespace nazori::ui {

/// Which stroke of which character goes wrong, and how: each with the character drawn and its stroke marked.
class HardStrokesCard final : public ChartCard {
  Q_OBJECT
 public:
  explicit HardStrokesCard(QWidget* parent = nullptr);

  /// @param database  to draw from; may be nullptr. Must live until the next call.
  void show_strokes(const study::Statistics& statistics, const kanji::KanjiDatabase* database);

 signals:
  void opened(char32_t character);

 private:
  HardStrokesCard(QListWidget* list, QWidget* parent);
  QListWidget* list_;
};

/// Draws a character's strokes with one of them marked, from the database, when it is first seen.
class HardStrokeDelegate final : public QStyledItemDelegate {
 public:
  static constexpr int kCharacterRole = Qt::UserRole;
  static constexpr int kStrokeRole = Qt::UserRole + 1;

  using QStyledItemDelegate::QStyledItemDelegate;
  void set_database(const kanji::KanjiDatabase* database);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  [[nodiscard]] const std::vector<kanji::StrokeLine>& lines_of(char32_t character) const;
  const kanji::KanjiDatabase* database_ = nullptr;
  mutable std::map<char32_t, std::vector<kanji::StrokeLine>> lines_;
};

}  // namespace nazori::ui
