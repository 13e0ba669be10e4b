// SPDX-License-Identifier: Apache-2.0
#include "characters/draw_panel.h"

#include <QComboBox>
#include <QEvent>
#include <QFontInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "characters/candidate_delegate.h"
#include "characters/drawing_pad.h"
#include "nazori/kanji/kana.h"
#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/writing_language.h"

namespace nazori::ui {
namespace {

/// What a found character is, in a few words: "katakana", "kanji, power".
QString kind_of(const practice::FoundCharacter& found) {
  const char32_t c = found.character;
  switch (kanji::script_of(c)) {
    case kanji::Script::hiragana:
      return DrawPanel::tr("hiragana");
    case kanji::Script::katakana:
      return DrawPanel::tr("katakana");
    case kanji::Script::latin:
      if (c >= U'0' && c <= U'9') return DrawPanel::tr("digit");
      return writing::is_among(c, writing::Among::letters) ? DrawPanel::tr("letter") : DrawPanel::tr("sign");
    case kanji::Script::other:
      break;
  }
  if (!writing::is_among(c, writing::Among::kanji)) return DrawPanel::tr("sign");
  const QString what =
      to_text(writing_language() == writing::Language::japanese ? found.reading : found.meaning);
  return what.isEmpty() ? DrawPanel::tr("kanji") : DrawPanel::tr("kanji, %1").arg(what);
}

/// "力 (kanji, power)"
QString with_kind(const QString& character, const QString& kind) {
  return DrawPanel::tr("%1 (%2)").arg(character, kind);
}

}  // namespace

DrawPanel::DrawPanel(WindowParts& parts, QWidget* parent)
    : QWidget(parent),
      parts_(parts),
      pad_(new DrawingPad(this)),
      among_(new QComboBox(this)),
      candidates_(named(new QListWidget(this), "candidates", tr("Similar characters"))),
      words_(text_label("draw_words", this, "muted")) {
  setObjectName(QStringLiteral("draw_panel"));
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Draw to find"));
  words_->setText(
      tr("Enter: open the first match. Arrow keys: choose another. Page Down: search only kana, kanji or "
         "letters. Ctrl+Z: undo a stroke. Delete: clear. Esc: close."));

  candidates_->setViewMode(QListView::IconMode);
  candidates_->setMovement(QListView::Static);
  candidates_->setResizeMode(QListView::Adjust);
  candidates_->setUniformItemSizes(true);
  candidates_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  candidates_->setItemDelegate(new CandidateDelegate(candidates_));
  candidates_->installEventFilter(this);

  among_->setObjectName(QStringLiteral("draw_among"));
  among_->setAccessibleName(tr("Search among"));
  among_->setToolTip(tr("Which characters are searched (Page Up, Page Down)"));
  const std::pair<writing::Among, QString> choices[] = {{writing::Among::all, tr("All characters")},
                                                        {writing::Among::kana, tr("Kana")},
                                                        {writing::Among::kanji, tr("Kanji")},
                                                        {writing::Among::letters, tr("Letters and digits")}};
  for (const auto& [among, name] : choices) among_->addItem(name, static_cast<int>(among));
  connect(among_, &QComboBox::currentIndexChanged, this, [this] { ask(); });
  pad_->installEventFilter(this);

  const auto button = [this](const QString& text, const char* name, auto&& what) {
    auto* made = named(new QPushButton(text, this), name);
    connect(made, &QPushButton::clicked, this, std::forward<decltype(what)>(what));
    return made;
  };
  // In a narrow panel, or with large text, the buttons are in several rows.
  auto* row = new FlowLayout(6, 6);
  row->addWidget(button(tr("Undo"), "draw_undo", [this] { pad_->undo(); }));
  row->addWidget(button(tr("Clear"), "draw_clear", [this] { pad_->clear(); }));
  row->addWidget(button(tr("Close"), "draw_close", [this] { emit closed(); }));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 12, 6, 12);
  column->setSpacing(8);
  column->addWidget(pad_);
  column->addLayout(row);
  column->addWidget(among_);
  column->addWidget(candidates_, 1);
  column->addWidget(words_);

  connect(pad_, &DrawingPad::drawn, this, &DrawPanel::ask);
  connect(candidates_, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { choose(candidates_->row(item)); });
  subscribe(parts_.judge().recognised, this,
            [this](std::uint64_t ticket, const std::vector<practice::FoundCharacter>& candidates) {
              if (ticket == ticket_) show_candidates(candidates);
            });
  subscribe(parts_.judge().recognising_failed, this, [this](std::uint64_t ticket, const base::Error& error) {
    // A stroke of one point is no drawing yet.
    if (ticket == ticket_ && error.code != base::Errc::bad_argument)
      parts_.announce(Feedback::wrong, tr("Your drawing could not be recognised: %1.").arg(reason(error)));
  });
  fit();
}

void DrawPanel::begin() {
  parts_.judge().prepare_recogniser();
  pad_->clear();
  pad_->setFocus(Qt::OtherFocusReason);
  parts_.announce(Feedback::hint,
                  tr("Draw the character you are looking for. Stroke order and direction hardly matter."));
}

void DrawPanel::ask() {
  writing::WrittenCharacter ink = pad_->ink();
  std::erase_if(ink.strokes, [](const writing::WrittenStroke& stroke) { return stroke.size() < 2; });
  if (ink.strokes.empty()) {
    ticket_ = 0;
    candidates_->clear();
    return;
  }
  ticket_ = parts_.judge().recognise(ink, kMostCandidates,
                                     static_cast<writing::Among>(among_->currentData().toInt()));
}

void DrawPanel::show_candidates(const std::vector<practice::FoundCharacter>& candidates) {
  const char32_t before = candidates_->currentItem() != nullptr && candidates_->currentRow() > 0
                              ? static_cast<char32_t>(candidates_->currentItem()->data(Qt::UserRole).toUInt())
                              : 0;
  candidates_->clear();
  int row = 0;
  for (const auto& candidate : candidates) {
    auto* item = new QListWidgetItem(to_text(candidate.character), candidates_);
    item->setTextAlignment(Qt::AlignCenter);
    item->setData(Qt::UserRole, static_cast<uint>(candidate.character));
    const QString kind = kind_of(candidate);
    item->setData(CandidateDelegate::kKindRole, kind);
    item->setData(Qt::AccessibleTextRole, with_kind(item->text(), kind));
    item->setToolTip(with_kind(item->text(), kind));
    if (candidate.character == before) row = candidates_->count() - 1;
  }
  candidates_->setCurrentRow(row);
  if (!candidates.empty())
    parts_.announce(Feedback::hint,
                    tr("Best match: %1. Enter: open it.").arg(candidates_->item(0)->toolTip()));
}

void DrawPanel::choose(int row) {
  const auto* item = candidates_->item(row);
  if (item == nullptr) return;
  const auto chosen = static_cast<char32_t>(item->data(Qt::UserRole).toUInt());
  emit character_chosen(chosen);
}

void DrawPanel::select(int by) {
  if (candidates_->count() == 0) return;
  candidates_->setCurrentRow(std::clamp(candidates_->currentRow() + by, 0, candidates_->count() - 1));
  const auto* item = candidates_->currentItem();
  parts_.announce(
      Feedback::hint,
      tr("%1, %2 of %3.").arg(item->toolTip()).arg(candidates_->currentRow() + 1).arg(candidates_->count()));
}

void DrawPanel::choose_among(int by) {
  among_->setCurrentIndex(std::clamp(among_->currentIndex() + by, 0, among_->count() - 1));
  parts_.respond(Feedback::hint, tr("Searching: %1.").arg(among_->currentText()));
}

bool DrawPanel::handle_key(int key, Qt::KeyboardModifiers modifiers) {
  const int columns =
      std::max(candidates_->viewport()->width() / std::max(candidates_->gridSize().width(), 1), 1);
  switch (key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      choose(std::max(candidates_->currentRow(), 0));
      return true;
    case Qt::Key_Left:
      select(-1);
      return true;
    case Qt::Key_Right:
      select(+1);
      return true;
    case Qt::Key_Up:
      select(-columns);
      return true;
    case Qt::Key_Down:
      select(columns);
      return true;
    case Qt::Key_PageUp:
      choose_among(-1);
      return true;
    case Qt::Key_PageDown:
      choose_among(+1);
      return true;
    case Qt::Key_Delete:
      pad_->clear();
      return true;
    case Qt::Key_Backspace:
      pad_->undo();
      return true;
    case Qt::Key_Z:
      if (!modifiers.testFlag(Qt::ControlModifier)) return false;
      pad_->undo();
      return true;
    case Qt::Key_Escape:
      emit closed();
      return true;
    default:
      return false;
  }
}

bool DrawPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (handle_key(key->key(), key->modifiers())) return true;
  } else if (event->type() == QEvent::ShortcutOverride) {
    // These keys belong to the drawing here, even where they are shortcuts of the window.
    const auto* key = static_cast<QKeyEvent*>(event);
    switch (key->key()) {
      case Qt::Key_Return:
      case Qt::Key_Enter:
      case Qt::Key_Left:
      case Qt::Key_Right:
      case Qt::Key_Up:
      case Qt::Key_Down:
      case Qt::Key_PageUp:
      case Qt::Key_PageDown:
      case Qt::Key_Delete:
      case Qt::Key_Backspace:
        if (key->modifiers() != Qt::NoModifier && key->modifiers() != Qt::KeypadModifier) break;
        event->accept();
        return true;
      case Qt::Key_Z:
        if (key->modifiers() != Qt::ControlModifier) break;
        event->accept();
        return true;
      default:
        break;
    }
  } else if (watched == pad_ && (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut)) {
    pad_->update();
  }
  return QWidget::eventFilter(watched, event);
}

void DrawPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

void DrawPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void DrawPanel::fit() {
  // The items have the font of their list, whatever size it is given later.
  candidates_->setFont(textbook_font(QFontInfo(font()).pointSizeF() * 1.8));
  const int em = QFontInfo(font()).pixelSize();
  candidates_->setGridSize({em * 9 / 2, em * 4});
  // The candidates need the space more.
  constexpr int kRoomForWords = 26;
  words_->setVisible(height() >= kRoomForWords * em);
}

}  // namespace nazori::ui
