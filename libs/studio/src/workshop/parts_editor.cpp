// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/workshop/parts_editor.h"

#include <QFontInfo>
#include <QFormLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "nazori/author/stroke_numbers.h"
#include "nazori/studio/parts/panel_parts.h"
#include "nazori/studio/workshop/part_words.h"
#include "nazori/studio/workshop/workshop_actions.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

PartsEditor::PartsEditor(const WorkshopActions& actions, QWidget* parent)
    : QWidget(parent),
      list_(named(new QListWidget(this), "workshop_parts", tr("Parts"))),
      name_(named(new QLineEdit(this), "workshop_part_name", tr("Name of the part"))),
      strokes_(named(new QLineEdit(this), "workshop_part_strokes", tr("Strokes of the part"))) {
  setObjectName(QStringLiteral("parts_editor"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kPanelGap);
  list_->setFixedHeight(QFontInfo(font()).pixelSize() * 6);
  column->addWidget(list_);
  auto* form = add_form(column);
  name_->setMaxLength(static_cast<int>(author::kLongestName));
  name_->setPlaceholderText(QStringLiteral("亻"));
  strokes_->setPlaceholderText(tr("1, 2 or 1-3"));
  form->addRow(tr("Name"), name_);
  form->addRow(tr("Strokes"), strokes_);
  add_buttons(column, {actions.add_part, actions.remove_part}, this);
  connect(list_, &QListWidget::currentRowChanged, this, &PartsEditor::choose);
  connect(name_, &QLineEdit::editingFinished, this, &PartsEditor::send);
  connect(strokes_, &QLineEdit::editingFinished, this, &PartsEditor::send);
  choose(-1);
}

int PartsEditor::chosen() const {
  const int row = list_->currentRow();
  return row < static_cast<int>(parts_.size()) ? row : -1;
}

void PartsEditor::show_parts(const std::vector<author::OwnPart>& parts, std::size_t strokes) {
  const int row = std::min(list_->currentRow(), static_cast<int>(parts.size()) - 1);
  const bool same = parts == parts_ && strokes == count_;
  parts_ = parts;
  count_ = strokes;
  if (same) return;
  {
    const QSignalBlocker quiet(list_);
    while (list_->count() > static_cast<int>(parts_.size())) delete list_->takeItem(list_->count() - 1);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const QString words = part_words(parts_[i]);
      if (static_cast<int>(i) == list_->count())
        list_->addItem(words);
      else
        list_->item(static_cast<int>(i))->setText(words);
    }
    list_->setCurrentRow(row);
  }
  choose(row);
}

void PartsEditor::choose(int row) {
  const bool is_there = row >= 0 && row < static_cast<int>(parts_.size());
  for (auto* field : {name_, strokes_}) field->setEnabled(is_there);
  const author::OwnPart shown = is_there ? parts_[static_cast<std::size_t>(row)] : author::OwnPart();
  const auto set = [](QLineEdit* field, const QString& text) {
    if (field->text() != text) field->setText(text);
  };
  set(name_, to_text(shown.name));
  set(strokes_, to_text(author::stroke_numbers_text(shown.strokes)));
}

void PartsEditor::send() {
  const int row = chosen();
  if (row < 0) return;
  auto parts = parts_;
  author::OwnPart& part = parts[static_cast<std::size_t>(row)];
  part.name = name_->text().simplified().toStdString();
  const QString typed = strokes_->text();
  if (auto read = read_strokes(typed, count_)) {
    part.strokes = *std::move(read);
  } else {
    choose(row);
    emit refused(count_ == 0 ? tr("There are no strokes yet.")
                             : tr("“%1” does not name strokes. Type numbers from 1 to %2: 1, 2 or 1-3.")
                                   .arg(typed)
                                   .arg(count_));
    return;
  }
  if (parts != parts_) emit parts_typed(parts);
  // As the program writes it: "1,2,3" becomes "1-3". A part that was refused is shown as it was.
  choose(row);
}

void PartsEditor::add(std::vector<int> strokes) {
  if (strokes.empty()) {
    std::vector<bool> used(count_, false);
    for (const auto& part : parts_)
      for (const int stroke : part.strokes) used[static_cast<std::size_t>(stroke)] = true;
    for (std::size_t i = 0; i < count_; ++i)
      if (!used[i]) strokes.push_back(static_cast<int>(i));
  }
  auto parts = parts_;
  parts.push_back({{}, std::move(strokes)});
  const std::size_t wanted = parts.size();
  emit parts_typed(parts);
  if (parts_.size() != wanted) return;
  list_->setCurrentRow(static_cast<int>(wanted) - 1);
  name_->setFocus(Qt::ShortcutFocusReason);
}

bool PartsEditor::remove() {
  const int row = chosen();
  if (row < 0) return false;
  auto parts = parts_;
  parts.erase(parts.begin() + row);
  emit parts_typed(parts);
  return true;
}

}  // namespace nazori::ui
