// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/workshop/trace_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "nazori/author/font_picture.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

TraceDialog::TraceDialog(const QString& picture, const QString& character, QWidget* parent)
    : QDialog(parent),
      character_(named(new QLineEdit(character, this), "trace_character", tr("Character"))),
      words_(sentence_label("trace_words", this)) {
  setObjectName(QStringLiteral("trace_dialog"));
  const bool of_font = picture.isEmpty();
  setWindowTitle(of_font ? tr("Strokes of a font") : tr("Strokes of a picture"));
  constexpr int kLongest = 8;
  character_->setMaxLength(kLongest);
  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  if (!of_font) form->addRow(tr("Picture"), text_label("trace_picture", this));
  form->addRow(tr("&Character"), character_);
  if (of_font) {
    family_ = named(new QComboBox(this), "trace_family", tr("Font"));
    constexpr int kLetters = 14;
    make_narrow(family_, kLetters);
    form->addRow(tr("&Font"), family_);
  } else {
    findChild<QLabel*>(QStringLiteral("trace_picture"))->setText(picture);
    words_->setText(tr(
        "If you type the character, its strokes get their order, direction and ending. Leave it empty for a "
        "sign of your own."));
  }
  auto* buttons = dialog_buttons(QDialogButtonBox::Cancel, this);
  find_ = named(buttons->addButton(tr("&Find strokes"), QDialogButtonBox::AcceptRole), "trace_find");
  find_->setDefault(true);
  auto* all = new QVBoxLayout(this);
  all->addLayout(form);
  all->addWidget(words_);
  all->addWidget(buttons);
  if (of_font) {
    connect(character_, &QLineEdit::textChanged, this, &TraceDialog::show_families);
    show_families();
  }
}

char32_t TraceDialog::character() const {
  const std::u32string text = character_->text().simplified().toStdU32String();
  return text.empty() ? U'\0' : text.front();
}

QString TraceDialog::family() const { return family_ != nullptr ? family_->currentText() : QString(); }

void TraceDialog::show_families() {
  const QString before = family_->currentText();
  family_->clear();
  const char32_t c = character();
  if (c != 0)
    for (const auto& name : author::font_families(c)) family_->addItem(to_text(name));
  if (const int at = family_->findText(before); at >= 0) family_->setCurrentIndex(at);
  find_->setEnabled(family_->count() > 0);
  words_->setText(c == 0                  ? tr("Type a character.")
                  : family_->count() == 0 ? tr("No installed font has this character.")
                                          : tr("%n fonts have this character.", nullptr, family_->count()));
}

}  // namespace nazori::ui
