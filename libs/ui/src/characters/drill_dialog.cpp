// SPDX-License-Identifier: Apache-2.0
#include "characters/drill_dialog.h"

#include <QFontInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

QLabel* label(const char* name, double scale, bool textbook, QWidget* parent) {
  auto* made = new QLabel(parent);
  made->setObjectName(QString::fromLatin1(name));
  made->setWordWrap(true);
  made->setAlignment(Qt::AlignCenter);
  made->setTextFormat(Qt::PlainText);
  const double size_pt = QFontInfo(made->font()).pointSizeF() * scale;
  QFont font = made->font();
  font.setPointSizeF(size_pt);
  made->setFont(textbook ? textbook_font(size_pt) : font);
  return made;
}

}  // namespace

DrillDialog::DrillDialog(const std::vector<practice::ConfusableFacts>& characters, unsigned seed,
                         QWidget* parent)
    : QDialog(parent),
      drill_(characters, seed),
      progress_(label("drill_progress", 1, false, this)),
      word_(label("drill_word", 2.4, true, this)),
      meaning_(label("drill_meaning", 1.3, false, this)),
      verdict_(label("drill_verdict", 1.1, false, this)),
      write_(new QPushButton(tr("&Write them"), this)) {
  setObjectName(QStringLiteral("drill_dialog"));
  setWindowTitle(tr("Which one is it?"));
  progress_->setProperty("role", QStringLiteral("muted"));
  auto* column = new QVBoxLayout(this);
  column->setSpacing(12);
  for (auto* one : {progress_, word_, meaning_}) column->addWidget(one);
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  int number = 0;
  for (const auto& facts : characters) {
    ++number;
    const QString text = to_text(facts.character);
    auto* button = new QPushButton(text, this);
    button->setObjectName(QStringLiteral("drill_choice_%1").arg(number));
    button->setFont(textbook_font(QFontInfo(font()).pointSizeF() * 3));
    button->setShortcut(QKeySequence(Qt::Key_0 + number));
    button->setAccessibleName(tr("%1: %2").arg(number).arg(text));
    button->setToolTip(tr("Key %1").arg(number));
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, [this, one = facts.character] { answer(one); });
    row->addWidget(button);
    choices_.append(button);
  }
  row->addStretch(1);
  column->addLayout(row);
  column->addWidget(verdict_);
  auto* foot = new QHBoxLayout;
  auto* close = new QPushButton(tr("&Close"), this);
  close->setObjectName(QStringLiteral("drill_close"));
  write_->setObjectName(QStringLiteral("drill_write"));
  write_->setEnabled(false);
  foot->addStretch(1);
  foot->addWidget(write_);
  foot->addWidget(close);
  column->addLayout(foot);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  connect(write_, &QPushButton::clicked, this, [this] {
    wants_to_write_ = true;
    accept();
  });
  setMinimumWidth(QFontInfo(font()).pixelSize() * 28);
  close->setAutoDefault(false);
  write_->setAutoDefault(false);
  verdict_->setText(tr("Which character belongs here? Press 1 to %1.").arg(characters.size()));
  ask();
}

void DrillDialog::ask() {
  const auto* question = drill_.question();
  progress_->setText(tr("%1 of %2").arg(std::min(drill_.asked() + 1, drill_.total())).arg(drill_.total()));
  if (question == nullptr) {
    word_->clear();
    progress_->clear();
    meaning_->setText(tr("%1 of %2 right").arg(drill_.right()).arg(drill_.asked()));
    for (auto* button : choices_) button->setEnabled(false);
    write_->setEnabled(true);
    write_->setDefault(true);
    write_->setFocus();
    return;
  }
  const QString reading =
      question->gap.empty() ? kun_plain(kanji::split_kun(question->reading)) : to_text(question->gap_reading);
  word_->setText(question->gap.empty() ? reading : to_text(question->gap));
  meaning_->setText(question->gap.empty() ? to_text(question->meaning)
                                          : reading + QStringLiteral(" · ") + to_text(question->meaning));
}

void DrillDialog::answer(char32_t character) {
  const auto* question = drill_.question();
  if (question == nullptr) return;
  const QString right = to_text(question->answer);
  const QString meaning = to_text(question->meaning);
  const bool is_right = drill_.answer(character);
  verdict_->setText(is_right ? tr("✓ Correct: %1, %2.").arg(right, meaning)
                             : tr("✗ It is %1 (%2), not %3.").arg(right, meaning, to_text(character)));
  ask();
}

}  // namespace nazori::ui
