// SPDX-License-Identifier: Apache-2.0
// The tab of the study settings that says what is studied: the lists, their order, and what is done with a
// whole list.
#include <QComboBox>
#include <QFormLayout>
#include <QInputDialog>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/list_choice.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/learner_words.h"
#include "study/known_dialog.h"
#include "study/new_list_dialog.h"
#include "study/study_settings_dialog.h"

namespace nazori::ui {

QWidget* StudySettingsDialog::make_lists() {
  auto* page = add_page(tr("Lists"));
  auto* form = static_cast<QFormLayout*>(page->layout());
  order_ = named(new QComboBox(page), "study_order", tr("Order of new characters"));
  order_->addItem(tr("by school grade"), static_cast<int>(study::NewOrder::grade));
  order_->addItem(tr("most common first"), static_cast<int>(study::NewOrder::frequency));
  order_->addItem(tr("fewest strokes first"), static_cast<int>(study::NewOrder::strokes));
  order_->addItem(tr("simple parts first"), static_cast<int>(study::NewOrder::components));
  order_->addItem(tr("in list order"), static_cast<int>(study::NewOrder::own));
  order_->setCurrentIndex(order_->findData(static_cast<int>(before_.new_order)));
  form->addRow(tr("&Order of new characters"), order_);
  lists_ = named(new QListWidget(page), "study_lists", tr("Lists to learn from"));
  lists_->setMinimumHeight(QFontMetrics(font()).height() * 9);
  form->addRow(lists_);
  choice_ = text_label("study_choice", page, "muted");
  form->addRow(choice_);
  auto* buttons = new QWidget(page);
  auto* flow = new FlowLayout(kButtonGap_px, kButtonGap_px, buttons);
  const auto button = [&](const char* name, const QString& text, auto&& what) {
    auto* made = named(new QPushButton(text, buttons), name);
    connect(made, &QPushButton::clicked, this, std::forward<decltype(what)>(what));
    made->setEnabled(learner_.can_write());
    flow->addWidget(made);
  };
  button("list_new", tr("New list…"), [this] { new_list(); });
  button("list_remove", tr("Remove"), [this] { remove_list(); });
  button("list_up", tr("Up"), [this] { move_list(-1); });
  button("list_down", tr("Down"), [this] { move_list(+1); });
  button("list_know", tr("I know these…"), [this] { mark_known(); });
  button("list_postpone", tr("Postpone all…"), [this] {
    bool fine = false;
    const int days = QInputDialog::getInt(this, tr("Postpone"), tr("Days"), 7, 1, 3650, 1, &fine);
    if (!fine) return;
    const auto until = learner_.store().today() + std::chrono::days(days);
    for_list([&](std::span<const char32_t> all) { return learner_.store().postpone(all, until); },
             [](int n) { return tr("%n characters postponed.", nullptr, n); });
  });
  button("list_pause", tr("Suspend all"), [this] {
    for_list([this](std::span<const char32_t> all) { return learner_.store().pause(all); },
             [](int n) { return tr("%n characters suspended.", nullptr, n); });
  });
  button("list_resume", tr("Resume all"), [this] {
    for_list([this](std::span<const char32_t> all) { return learner_.store().resume(all); },
             [](int n) { return tr("%n characters resumed.", nullptr, n); });
  });
  button("list_reset", tr("Start all over"), [this] {
    for_list([this](std::span<const char32_t> all) { return learner_.store().reset(all); },
             [](int n) { return tr("%n characters started over as new.", nullptr, n); });
  });
  form->addRow(buttons);
  connect(lists_, &QListWidget::itemChanged, this, &StudySettingsDialog::show_choice);
  return page;
}

std::vector<std::string> StudySettingsDialog::chosen_lists() const {
  std::vector<std::string> chosen;
  for (int row = 0; row < lists_->count(); ++row)
    if (lists_->item(row)->checkState() == Qt::Checked)
      chosen.push_back(lists_->item(row)->data(Qt::UserRole).toString().toStdString());
  return chosen;
}

void StudySettingsDialog::show_lists() {
  const QSignalBlocker quiet(lists_);
  const QString at = current_list();
  const auto chosen = lists_->count() == 0 ? before_.new_lists : chosen_lists();
  const auto known = study::list_ids(learner_.store());
  lists_->clear();
  for (const auto& one : known.chosen_first(chosen)) {
    const QString id = to_text(one);
    auto* item = new QListWidgetItem(ListChoice::name_of(id), lists_);
    item->setData(Qt::UserRole, id);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    const bool is_chosen = std::find(chosen.begin(), chosen.end(), one) != chosen.end();
    item->setCheckState(is_chosen ? Qt::Checked : Qt::Unchecked);
    if (id == at) lists_->setCurrentItem(item);
  }
  if (lists_->currentRow() < 0) lists_->setCurrentRow(0);
  show_choice();
  if (known.unread) choice_->setText(tr("Your lists and tags cannot be read: %1").arg(reason(*known.unread)));
}

void StudySettingsDialog::show_choice() {
  if (learner_.lists() == nullptr) return;
  const auto ordered = learner_.lists()->in_learning_order(settings(), learner_.store());
  if (!ordered) {
    choice_->setText(tr("Your lists and tags cannot be read: %1").arg(reason(ordered.error())));
    return;
  }
  const auto& order = *ordered;
  const auto& cards = learner_.store().cards();
  const auto met =
      std::count_if(order.begin(), order.end(), [&](char32_t one) { return cards.contains(one); });
  const QLocale locale;
  choice_->setText(order.empty() ? tr("No list is selected, so no new characters will come up.")
                                 : tr("%Ln characters selected, %1 of them already studied.", nullptr,
                                      static_cast<int>(order.size()))
                                       .arg(locale.toString(static_cast<qlonglong>(met))));
}

QString StudySettingsDialog::current_list() const {
  const auto* item = lists_->currentItem();
  return item == nullptr ? QString() : item->data(Qt::UserRole).toString();
}

void StudySettingsDialog::new_list() {
  NewListDialog dialog(learner_, this);
  if (dialog.exec() != QDialog::Accepted) return;
  const auto saved = learner_.store().save_list(dialog.list());
  if (!saved) {
    choice_->setText(reason(saved.error()));
    return;
  }
  learner_.renew_order();
  show_lists();
  const QString id = QStringLiteral("list:") + to_text(dialog.list().name);
  for (int row = 0; row < lists_->count(); ++row)
    if (lists_->item(row)->data(Qt::UserRole).toString() == id) {
      lists_->item(row)->setCheckState(Qt::Checked);
      lists_->setCurrentRow(row);
    }
}

void StudySettingsDialog::mark_known() {
  KnownDialog dialog(learner_, this);
  dialog.resize(size() * 0.8);
  if (dialog.exec() != QDialog::Accepted) return;
  if (!practice::take_plan(learner_, dialog.plan())) {
    choice_->setText(LearnerWords::sentence(learner_.trouble()));
    return;
  }
  show_choice();
  choice_->setText(
      choice_->text() + QLatin1Char('\n') +
      tr("%Ln characters marked as known.", nullptr, static_cast<int>(dialog.plan().choices.known.size())) +
      QLatin1Char(' ') + tr("Ctrl+Shift+Z: undo."));
}

void StudySettingsDialog::remove_list() {
  const QString id = current_list();
  if (!id.startsWith(QLatin1String("list:"))) {
    choice_->setText(tr("Only your own lists can be removed."));
    return;
  }
  QMessageBox box(QMessageBox::Question, tr("Remove the list"),
                  tr("Remove “%1”? Your progress with its characters is kept.").arg(id.mid(5)),
                  QMessageBox::Ok | QMessageBox::Cancel, this);
  box.setObjectName(QStringLiteral("remove_list_box"));
  if (box.exec() != QMessageBox::Ok) return;
  const auto removed = learner_.store().remove_list(id.mid(5).toStdString());
  if (!removed) choice_->setText(reason(removed.error()));
  learner_.renew_order();
  show_lists();
}

void StudySettingsDialog::move_list(int by) {
  const int row = lists_->currentRow();
  const int to = row + by;
  if (row < 0 || to < 0 || to >= lists_->count()) return;
  lists_->insertItem(to, lists_->takeItem(row));
  lists_->setCurrentRow(to);
}

void StudySettingsDialog::for_list(const std::function<base::Result<void>(std::span<const char32_t>)>& what,
                                   const std::function<QString(int)>& done) {
  if (learner_.lists() == nullptr) return;
  const auto members = learner_.lists()->members(current_list().toStdString(), learner_.store());
  if (!members || members->empty()) {
    choice_->setText(members || members.error().code == base::Errc::not_found
                         ? tr("This list is empty.")
                         : tr("Your lists and tags cannot be read: %1").arg(reason(members.error())));
    return;
  }
  const auto result = what(*members);
  if (!learner_.report(result)) {
    choice_->setText(reason(result.error()));
    return;
  }
  choice_->setText(done(static_cast<int>(members->size())) + QLatin1Char(' ') + tr("Ctrl+Shift+Z: undo."));
}

}  // namespace nazori::ui
