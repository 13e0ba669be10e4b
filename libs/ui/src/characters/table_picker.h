// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHash>
#include <QWidget>
#include <memory>

#include "nazori/practice/character_library.h"

class QLabel;
class QPushButton;
class QScrollArea;
class QStackedWidget;

namespace nazori::ui {

/// A table of the parts of kanji, or of the 214 radicals, by their strokes. Parts that no character has
/// together with the chosen ones are grey.
class TablePicker final : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kNone = -1, kParts = 0, kRadicals = 1;

  explicit TablePicker(QWidget* parent = nullptr);

  void show_tables(const std::shared_ptr<const practice::CharacterTables>& tables);
  /// @param table  kParts or kRadicals; kNone changes nothing.
  void show_table(int table);
  /// Gives the keyboard to the first button of the shown table, at once or as soon as there are tables.
  void take_keyboard();
  /// Shows what a search is by.
  void set_query(const kanji::Query& query);

 signals:
  /// The chosen parts, one after another.
  void parts_chosen(QString parts);
  /// 0: none.
  void radical_chosen(int number);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QPushButton* add_button(QWidget* table, const QString& text, int strokes, int& before);
  QScrollArea* make_table(const char* name, const QString& title);
  void fit();
  void choose_part(const QString& element, bool chosen);

  std::shared_ptr<const practice::CharacterTables> tables_;
  kanji::Query query_;
  QStackedWidget* stack_;
  QScrollArea* parts_;
  QScrollArea* radicals_;
  QList<QPushButton*> part_buttons_;
  QHash<int, QPushButton*> radical_buttons_;
  bool awaits_tables_ = false;
};

}  // namespace nazori::ui
