// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "characters/character_list_model.h"
#include "nazori/practice/character_library.h"

class QAction;
class QBoxLayout;
class QComboBox;
class QLabel;
class QLineEdit;
class QListView;
class QStackedWidget;
class QToolButton;

namespace nazori::ui {

class CharacterTileDelegate;
class TablePicker;

/// Where a character is chosen: a search box, tables of parts and radicals, the lists, and their characters
/// as tiles. The answer to a search is rows that say why they match.
class LibraryPanel final : public QWidget {
  Q_OBJECT
 public:
  LibraryPanel(practice::CharacterLibrary* library, practice::Learner* learner, QWidget* parent = nullptr);

  void show_list(kanji::List list);
  [[nodiscard]] kanji::List list() const { return list_; }
  /// Marks the character that is shown and scrolls to it if it is in the list.
  void set_current(char32_t code_point);
  /// The character before (-1) or after (+1) the current one in the list; 0 where there is none.
  [[nodiscard]] char32_t neighbour(int step) const;

 public slots:
  void focus_search();
  /// Opens a table above the tiles, or closes it.
  void show_parts(bool open);
  void show_radicals(bool open);

 signals:
  void character_chosen(char32_t code_point);
  void list_changed(nazori::kanji::List list);
  /// Which of the tables is open.
  void table_shown(bool parts, bool radicals);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void search(const QString& text);
  void show_characters(const practice::Summaries& characters);
  void show_answer(const std::shared_ptr<const practice::SearchAnswer>& answer);
  void show_count(int count, bool searched);
  void fill_lists();
  void choose_list(int row_number);
  void show_table(int table);
  void add_condition(const char* key, const QString& value);
  void make_conditions();
  void fit_row();
  void fit_tiles();
  void draw_lens();
  void choose_first();

  practice::CharacterLibrary* library_;
  practice::Learner* learner_;
  CharacterListModel* model_;
  CharacterTileDelegate* delegate_;
  QLineEdit* search_;
  QAction* lens_;
  QToolButton* conditions_;  ///< opens the menu of what can be searched by
  TablePicker* tables_;
  QComboBox* lists_;
  QLabel* count_;
  QBoxLayout* row_;  ///< of the box for lists and the count
  QListView* grid_;
  QLabel* nothing_;
  QStackedWidget* stack_;
  kanji::List list_ = kanji::List::grade_1;
  char32_t current_ = 0;
  QString shown_search_;            ///< the search whose results the tiles show; empty: the list
  bool shows_answer_ = false;       ///< rows instead of tiles
  bool choose_when_found_ = false;  ///< Enter was pressed before the results arrived
};

}  // namespace nazori::ui
