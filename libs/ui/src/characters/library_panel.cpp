// SPDX-License-Identifier: Apache-2.0
#include "characters/library_panel.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "characters/character_tile_delegate.h"
#include "characters/table_picker.h"
#include "nazori/kanji/query_text.h"
#include "nazori/widgets/controls/list_choice.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/look/icons.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

LibraryPanel::LibraryPanel(practice::CharacterLibrary* library, practice::Learner* learner, QWidget* parent)
    : QWidget(parent),
      library_(library),
      learner_(learner),
      model_(new CharacterListModel(this)),
      delegate_(new CharacterTileDelegate(this)),
      search_(named(new QLineEdit(this), "search", tr("Find a character"))),
      conditions_(new QToolButton(this)),
      tables_(new TablePicker(this)),
      lists_(named(new QComboBox(this), "lists", tr("List of characters"))),
      count_(with_role(named(new QLabel(this), "list_count"), "muted")),
      row_(new QBoxLayout(QBoxLayout::LeftToRight)),
      grid_(named(new QListView(this), "character_grid", tr("Characters in the list"))),
      nothing_(text_label("nothing_found", this, "muted")),
      stack_(new QStackedWidget(this)) {
  setObjectName(QStringLiteral("library_panel"));
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Characters"));

  search_->setPlaceholderText(tr("休, yasumu, rest …"));
  search_->setToolTip(tr("Search by character, by reading (kana or romaji) or by English meaning (Ctrl+F)"));
  search_->setClearButtonEnabled(true);
  lens_ = search_->addAction(QIcon(), QLineEdit::LeadingPosition);
  draw_lens();
  search_->installEventFilter(this);

  make_conditions();
  const std::pair<kanji::List, QString> lists[] = {{kanji::List::grade_1, tr("Grade 1")},
                                                   {kanji::List::grade_2, tr("Grade 2")},
                                                   {kanji::List::grade_3, tr("Grade 3")},
                                                   {kanji::List::grade_4, tr("Grade 4")},
                                                   {kanji::List::grade_5, tr("Grade 5")},
                                                   {kanji::List::grade_6, tr("Grade 6")},
                                                   {kanji::List::secondary, tr("Secondary school")},
                                                   {kanji::List::jinmeiyou, tr("Kanji for names")},
                                                   {kanji::List::hiragana, tr("Hiragana")},
                                                   {kanji::List::katakana, tr("Katakana")},
                                                   {kanji::List::latin_and_digits, tr("Letters and digits")},
                                                   {kanji::List::own, tr("My characters")},
                                                   {kanji::List::all, tr("All characters")}};
  for (const auto& [list, name] : lists) lists_->addItem(name, static_cast<int>(list));
  lists_->setMaxVisibleItems(static_cast<int>(std::size(lists)));
  make_narrow(lists_, 5);
  lists_->setPlaceholderText(tr("Search results"));

  grid_->setModel(model_);
  grid_->setItemDelegate(delegate_);
  grid_->setResizeMode(QListView::Adjust);
  grid_->setUniformItemSizes(true);
  grid_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  grid_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  grid_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  grid_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  grid_->setMouseTracking(true);
  grid_->viewport()->installEventFilter(this);

  nothing_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  nothing_->setContentsMargins(6, 10, 6, 6);
  stack_->addWidget(grid_);
  stack_->addWidget(nothing_);

  row_->setSpacing(8);
  row_->addWidget(lists_, 1);
  row_->addWidget(count_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 12, 6, 0);
  column->setSpacing(8);
  auto* search_row = new QHBoxLayout;
  search_row->setSpacing(4);
  search_row->addWidget(search_, 1);
  search_row->addWidget(conditions_);
  search_row->setContentsMargins(0, 0, 6, 0);
  column->addLayout(search_row);
  column->addWidget(tables_, 2);
  tables_->hide();
  column->addLayout(row_);
  column->addWidget(stack_, 3);
  row_->setContentsMargins(0, 0, 6, 0);

  connect(search_, &QLineEdit::textChanged, this, &LibraryPanel::search);
  connect(search_, &QLineEdit::returnPressed, this, &LibraryPanel::choose_first);
  connect(lists_, &QComboBox::activated, this, &LibraryPanel::choose_list);
  connect(tables_, &TablePicker::parts_chosen, this,
          [this](const QString& parts) { add_condition("parts", parts); });
  connect(tables_, &TablePicker::radical_chosen, this,
          [this](int number) { add_condition("radical", number > 0 ? QString::number(number) : QString()); });
  const auto choose = [this](const QModelIndex& index) {
    if (const char32_t chosen = model_->at(index.row())) emit character_chosen(chosen);
  };
  connect(grid_, &QListView::clicked, this, choose);
  connect(grid_, &QListView::activated, this, choose);
  subscribe(library_->listed, this, [this](kanji::List which, const practice::Summaries& characters) {
    if (which == list_ && search_->text().trimmed().isEmpty()) show_characters(characters);
  });
  subscribe(library_->found, this,
            [this](const std::string& text, const std::shared_ptr<const practice::SearchAnswer>& answer) {
              if (to_text(text) == search_->text().trimmed()) show_answer(answer);
            });
  subscribe(library_->tables_ready, this,
            [this](const std::shared_ptr<const practice::CharacterTables>& tables) {
              tables_->show_tables(tables);
              tables_->set_query(kanji::read_query(search_->text().toStdString()).query);
            });
  model_->set_strengths(
      [this](char32_t character) { return study::strength_of(learner_->store().card(character)); });
  subscribe(learner_->changed, this, [this] {
    fill_lists();
    model_->refresh_strengths();
    if (list_ == kanji::List::own) library_->request_list(list_);
  });
  fill_lists();
  fit_tiles();
}

void LibraryPanel::show_list(kanji::List list) {
  list_ = list;
  lists_->setCurrentIndex(lists_->findData(static_cast<int>(list)));
  library_->request_list(list);
}

void LibraryPanel::search(const QString& text) {
  choose_when_found_ = false;
  const QString wanted = text.trimmed();
  const auto typed = kanji::read_query(wanted.toStdString());
  tables_->set_query(typed.query);
  if (wanted.isEmpty()) {
    library_->request_list(list_);
    return;
  }
  const auto among = practice::members_of(typed, *learner_);
  // A list of this name may still be typed: nothing is in it.
  library_->request_search(wanted.toStdString(), among ? *among : std::vector<char32_t>());
}

void LibraryPanel::show_answer(const std::shared_ptr<const practice::SearchAnswer>& answer) {
  model_->set_answer(answer);
  shows_answer_ = true;
  fit_tiles();
  show_count(static_cast<int>(answer->rows.size()), true);
  grid_->scrollToTop();
  if (choose_when_found_) {
    choose_when_found_ = false;
    choose_first();
  }
}

void LibraryPanel::show_characters(const practice::Summaries& characters) {
  model_->set_characters(characters);
  if (shows_answer_) {
    shows_answer_ = false;
    fit_tiles();
  }
  show_count(static_cast<int>(characters->size()), false);
  set_current(current_);
}

void LibraryPanel::show_count(int count, bool searched) {
  const QString wanted = search_->text().trimmed();
  shown_search_ = wanted;
  lists_->setCurrentIndex(searched ? -1 : lists_->findData(static_cast<int>(list_)));
  count_->setText(searched ? tr("%n found", nullptr, count) : QString::number(count));
  count_->setAccessibleName(searched ? count_->text() : tr("%n characters", nullptr, count));
  fit_row();
  nothing_->setText(tr("Nothing found for “%1”. Try a character (休), a reading (やすむ, yasumu) or an "
                       "English meaning (rest).")
                        .arg(wanted));
  stack_->setCurrentWidget(count == 0 && searched ? static_cast<QWidget*>(nothing_) : grid_);
}

void LibraryPanel::choose_first() {
  const QString wanted = search_->text().trimmed();
  if (wanted.isEmpty()) return;
  if (shown_search_ != wanted)
    choose_when_found_ = true;
  else if (const char32_t first = model_->at(0); first != 0)
    emit character_chosen(first);
}

void LibraryPanel::set_current(char32_t code_point) {
  current_ = code_point;
  delegate_->set_current(code_point);
  const int row = model_->row_of(code_point);
  if (row >= 0) {
    const QModelIndex index = model_->index(row);
    grid_->setCurrentIndex(index);
    const bool seen = grid_->viewport()->rect().contains(grid_->visualRect(index));
    if (!seen) grid_->scrollTo(index, QAbstractItemView::PositionAtCenter);
  } else {
    grid_->clearSelection();
  }
  grid_->viewport()->update();
}

char32_t LibraryPanel::neighbour(int step) const {
  const int row = model_->row_of(current_);
  return row < 0 ? model_->at(0) : model_->at(row + step);
}

void LibraryPanel::focus_search() {
  search_->setFocus(Qt::ShortcutFocusReason);
  search_->selectAll();
}

bool LibraryPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == grid_->viewport() && event->type() == QEvent::Resize) fit_tiles();
  if (watched == search_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Down && model_->rowCount() > 0) {
      grid_->setFocus(Qt::TabFocusReason);
      if (!grid_->currentIndex().isValid()) grid_->setCurrentIndex(model_->index(0));
      return true;
    }
    if (key->key() == Qt::Key_Escape && !search_->text().isEmpty()) {
      search_->clear();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void LibraryPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) {
    fit_row();
    fit_tiles();
  }
  if (event->type() == QEvent::PaletteChange) draw_lens();
}

void LibraryPanel::draw_lens() {
  lens_->setIcon(icon(Icon::search, current_colours().muted, current_colours().muted));
}

void LibraryPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit_row();
}

void LibraryPanel::fit_row() {
  // Large text in a narrow panel: the count under the list instead of beside it.
  const int name = lists_->fontMetrics().horizontalAdvance(lists_->currentText()) +
                   2 * QFontInfo(lists_->font()).pixelSize();
  const bool beside = name + row_->spacing() + count_->sizeHint().width() <= row_->contentsRect().width();
  row_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void LibraryPanel::fit_tiles() {
  // As many columns as fit without making the tiles much smaller; they fill the panel's width.
  const int wished = CharacterTileDelegate::tile_side(font());
  const int room = grid_->viewport()->width() - 1;
  grid_->setFlow(shows_answer_ ? QListView::TopToBottom : QListView::LeftToRight);
  grid_->setWrapping(!shows_answer_);
  if (shows_answer_) {
    grid_->setGridSize({room, CharacterTileDelegate::row_height(font())});
    grid_->verticalScrollBar()->setSingleStep(CharacterTileDelegate::row_height(font()) / 2);
    return;
  }
  const int columns = std::max(room * 20 / (wished * 17), 1);
  const int side = std::clamp(room / columns, wished / 2, wished * 3 / 2);
  delegate_->set_side(side);
  grid_->setGridSize({side, side});
  // The new layout is applied by the next pass of the event loop.
  QTimer::singleShot(0, grid_, [this] {
    if (const int row = model_->row_of(current_); row >= 0)
      grid_->scrollTo(model_->index(row), QAbstractItemView::PositionAtCenter);
  });
  grid_->verticalScrollBar()->setSingleStep(side / 2);
}

void LibraryPanel::fill_lists() {
  // The built-in lists come first and stay; the lists that are searches are filled again.
  const QVariant before = lists_->currentData();
  while (lists_->count() > 0 && lists_->itemData(lists_->count() - 1).metaType().id() == QMetaType::QString)
    lists_->removeItem(lists_->count() - 1);
  QStringList ids;
  for (int level = 4; level >= 1; --level) ids.append(QStringLiteral("old-jlpt-%1").arg(level));
  const auto& store = learner_->store();
  if (const auto own = store.lists())
    for (const auto& one : *own) ids.append(QStringLiteral("list:") + to_text(one.name));
  if (const auto tags = store.tags())
    for (const auto& [tag, members] : *tags) ids.append(QStringLiteral("tag:") + to_text(tag));
  for (const QString& id : ids) lists_->addItem(ListChoice::name_of(id), id);
  lists_->setCurrentIndex(before.isValid() ? lists_->findData(before) : -1);
}

void LibraryPanel::choose_list(int row_number) {
  const QVariant chosen = lists_->itemData(row_number);
  if (chosen.metaType().id() != QMetaType::QString) {
    search_->clear();
    show_list(static_cast<kanji::List>(chosen.toInt()));
    emit list_changed(list_);
    return;
  }
  // These lists are searches, which the box shows.
  const QString id = chosen.toString();
  const QString level = QStringLiteral("old-jlpt-");
  const QString wanted = id.startsWith(level) ? QStringLiteral("jlpt:") + id.mid(level.size()) : id;
  search_->setText(wanted.contains(QLatin1Char(' ')) ? QLatin1Char('"') + wanted + QLatin1Char('"') : wanted);
}

void LibraryPanel::add_condition(const char* key, const QString& value) {
  search_->setText(to_text(kanji::with_condition(search_->text().toStdString(), key, value.toStdString())));
}

void LibraryPanel::make_conditions() {
  conditions_->setObjectName(QStringLiteral("search_conditions"));
  conditions_->setText(QStringLiteral("⋯"));
  conditions_->setAccessibleName(tr("Search by strokes, radical, parts or code"));
  conditions_->setToolTip(conditions_->accessibleName());
  conditions_->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(conditions_);
  menu->addAction(tr("Parts…"), this, [this] { show_parts(true); });
  menu->addAction(tr("Radical…"), this, [this] { show_radicals(true); });
  menu->addSeparator();
  // Each begins a condition in the box; its value is typed.
  const std::pair<QString, QString> begun[] = {{tr("Number of strokes"), QStringLiteral("strokes:")},
                                               {tr("SKIP code"), QStringLiteral("skip:")},
                                               {tr("Four-corner code"), QStringLiteral("corner:")},
                                               {tr("School grade"), QStringLiteral("grade:")},
                                               {tr("Old JLPT level"), QStringLiteral("jlpt:")},
                                               {tr("The most frequent"), QStringLiteral("freq:")}};
  for (const auto& [name, key] : begun)
    menu->addAction(name + QStringLiteral("\t") + key, this, [this, key = key] {
      const QString before = search_->text().trimmed();
      search_->setText(before.isEmpty() ? key : before + QLatin1Char(' ') + key);
      search_->setFocus(Qt::OtherFocusReason);
    });
  conditions_->setMenu(menu);
}

void LibraryPanel::show_table(int table) {
  if (table != TablePicker::kNone) library_->request_tables();
  tables_->show_table(table);
  const bool is_open = table != TablePicker::kNone;
  if (!is_open && has_keyboard(*tables_)) focus_search();
  tables_->setVisible(is_open);
  if (is_open) tables_->take_keyboard();
  emit table_shown(table == TablePicker::kParts, table == TablePicker::kRadicals);
}

void LibraryPanel::show_parts(bool open) { show_table(open ? TablePicker::kParts : TablePicker::kNone); }

void LibraryPanel::show_radicals(bool open) {
  show_table(open ? TablePicker::kRadicals : TablePicker::kNone);
}

}  // namespace nazori::ui
