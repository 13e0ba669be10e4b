// SPDX-License-Identifier: Apache-2.0
#include "characters/library_panel.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "characters/character_tile_delegate.h"
#include "events/signals.h"
#include "look/icons.h"
#include "look/palette.h"
#include "widgets/parts.h"
#include "words/kanji_text.h"

namespace nazori::ui {

LibraryPanel::LibraryPanel(practice::CharacterLibrary* library, QWidget* parent)
    : QWidget(parent),
      library_(library),
      model_(new CharacterListModel(this)),
      delegate_(new CharacterTileDelegate(this)),
      search_(named(new QLineEdit(this), "search", tr("Find a character"))),
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
                                                   {kanji::List::all, tr("All characters")}};
  for (const auto& [list, name] : lists) lists_->addItem(name, static_cast<int>(list));
  lists_->setMaxVisibleItems(static_cast<int>(std::size(lists)));
  make_narrow(lists_, 5);
  lists_->setPlaceholderText(tr("Search results"));

  grid_->setModel(model_);
  grid_->setItemDelegate(delegate_);
  grid_->setFlow(QListView::LeftToRight);
  grid_->setWrapping(true);
  grid_->setResizeMode(QListView::Adjust);
  grid_->setUniformItemSizes(true);
  grid_->setSelectionMode(QAbstractItemView::SingleSelection);
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
  column->addWidget(search_);
  column->addLayout(row_);
  column->addWidget(stack_, 1);
  row_->setContentsMargins(0, 0, 6, 0);

  connect(search_, &QLineEdit::textChanged, this, &LibraryPanel::search);
  connect(search_, &QLineEdit::returnPressed, this, &LibraryPanel::choose_first);
  connect(lists_, &QComboBox::activated, this, [this](int row_number) {
    search_->clear();
    show_list(static_cast<kanji::List>(lists_->itemData(row_number).toInt()));
    emit list_changed(list_);
  });
  const auto choose = [this](const QModelIndex& index) {
    if (const char32_t chosen = model_->at(index.row())) emit character_chosen(chosen);
  };
  connect(grid_, &QListView::clicked, this, choose);
  connect(grid_, &QListView::activated, this, choose);
  subscribe(library_->listed, this, [this](kanji::List which, const practice::Summaries& characters) {
    if (which == list_ && search_->text().trimmed().isEmpty()) show_characters(characters);
  });
  subscribe(library_->found, this, [this](const std::string& text, const practice::Summaries& characters) {
    if (to_text(text) == search_->text().trimmed()) show_characters(characters);
  });
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
  if (wanted.isEmpty())
    library_->request_list(list_);
  else
    library_->request_search(wanted.toStdString());
}

void LibraryPanel::show_characters(const practice::Summaries& characters) {
  model_->set_characters(characters);
  const auto count = static_cast<int>(characters->size());
  const QString wanted = search_->text().trimmed();
  const bool searched = !wanted.isEmpty();
  shown_search_ = wanted;
  lists_->setCurrentIndex(searched ? -1 : lists_->findData(static_cast<int>(list_)));
  count_->setText(searched ? tr("%n found", nullptr, count) : QString::number(count));
  count_->setAccessibleName(searched ? count_->text() : tr("%n characters", nullptr, count));
  fit_row();
  nothing_->setText(tr("Nothing found for “%1”. Try a character (休), a reading (やすむ, yasumu) or an "
                       "English meaning (rest).")
                        .arg(wanted));
  stack_->setCurrentWidget(count == 0 && searched ? static_cast<QWidget*>(nothing_) : grid_);
  if (searched)
    grid_->scrollToTop();
  else
    set_current(current_);
  if (choose_when_found_) {
    choose_when_found_ = false;
    choose_first();
  }
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

}  // namespace nazori::ui
