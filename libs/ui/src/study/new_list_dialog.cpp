// SPDX-License-Identifier: Apache-2.0
#include "study/new_list_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>

#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"
#include "study/text_file.h"

namespace nazori::ui {

NewListDialog::NewListDialog(practice::Learner& learner, QWidget* parent)
    : QDialog(parent),
      learner_(learner),
      name_(named(new QLineEdit(this), "new_list_name")),
      text_(named(new QPlainTextEdit(this), "new_list_text", tr("Characters"))),
      trouble_(text_label("new_list_trouble", this)) {
  setObjectName(QStringLiteral("new_list_dialog"));
  setWindowTitle(tr("New list"));
  text_->setPlaceholderText(tr("休日月火水木金土\n# text after # is a comment"));
  text_->setTabChangesFocus(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  auto* file = buttons->addButton(tr("From a file…"), QDialogButtonBox::ActionRole);
  file->setObjectName(QStringLiteral("new_list_file"));
  connect(file, &QPushButton::clicked, this, &NewListDialog::read_file);
  connect(buttons, &QDialogButtonBox::accepted, this, &NewListDialog::read_and_accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(20, 20, 20, 16);
  form->setSpacing(12);
  form->addRow(tr("&Name"), name_);
  form->addRow(tr("&Characters"), text_);
  form->addRow(trouble_);
  form->addRow(buttons);
}

void NewListDialog::read_file() {
  const auto file = ask_text_file(this, tr("Open a list"), *trouble_);
  if (!file) return;
  text_->setPlainText(file->text);
  if (name_->text().isEmpty())
    name_->setText(file->path.section(QLatin1Char('/'), -1).section(QLatin1Char('.'), 0, 0));
}

void NewListDialog::read_and_accept() {
  const std::string name = name_->text().trimmed().toStdString();
  if (!study::can_be_name(name)) {
    trouble_->setText(tr("Give the list a name of at most 100 letters (33 in Japanese)."));
    return;
  }
  const auto known = [this](char32_t one) {
    return learner_.lists() != nullptr && learner_.lists()->facts(one) != nullptr;
  };
  auto characters = study::parse_list(text_->toPlainText().toStdString(), known);
  if (!characters) {
    trouble_->setText(
        characters.error().where.empty()
            ? reason(characters.error())
            : QStringLiteral("%1: %2").arg(to_text(characters.error().where), reason(characters.error())));
    return;
  }
  list_ = {name, *std::move(characters)};
  accept();
}

}  // namespace nazori::ui
