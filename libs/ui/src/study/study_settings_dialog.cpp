// SPDX-License-Identifier: Apache-2.0
#include "study/study_settings_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QTabWidget>
#include <QTimeZone>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "error_text.h"
#include "flow_layout.h"
#include "kanji_text.h"
#include "nazori/study/statistics.h"
#include "number_slider.h"
#include "study/learner_words.h"
#include "study/list_choice.h"

namespace nazori::ui {
namespace {

constexpr int kGap = 6;

QLabel* sentence(const char* name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QString::fromLatin1(name));
  label->setWordWrap(true);
  label->setProperty("role", QStringLiteral("muted"));
  return label;
}

}  // namespace

StudySettingsDialog::StudySettingsDialog(practice::Learner& learner, const Preferences& preferences,
                                         QWidget* parent)
    : QDialog(parent),
      learner_(learner),
      before_(learner.store().settings()),
      weights_(before_.fsrs.weights),
      tabs_(new QTabWidget(this)) {
  if (const auto pace = study::pace_of(learner.store())) pace_ = *pace;
  setObjectName(QStringLiteral("study_settings_dialog"));
  setWindowTitle(tr("Study settings"));
  tabs_->setObjectName(QStringLiteral("study_settings_tabs"));
  tabs_->setUsesScrollButtons(true);
  tabs_->setDocumentMode(true);
  make_amount();
  make_lists();
  make_schedule();
  make_window(preferences);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->setObjectName(QStringLiteral("study_settings_buttons"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  buttons->button(QDialogButtonBox::Ok)->setEnabled(learner.can_write());
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 12);
  column->addWidget(tabs_, 1);
  if (!learner.can_write()) {
    auto* trouble = sentence("study_settings_trouble", this);
    trouble->setText(LearnerWords::sentence(learner.trouble()));
    column->addWidget(trouble);
  }
  column->addWidget(buttons);
  show_workload();
  show_lists();
  show_weights();
  if (parent != nullptr) {
    const int em = QFontInfo(font()).pixelSize();
    resize(QSize(em * 44, em * 38).boundedTo(parent->size() * 0.95));
  }
}

QWidget* StudySettingsDialog::add_page(const QString& name) {
  auto* area = new QScrollArea(tabs_);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* page = new QWidget(area);
  page->setObjectName(QStringLiteral("information_content"));
  auto* form = new QFormLayout(page);
  form->setContentsMargins(12, 16, 12, 12);
  form->setSpacing(10);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  area->setWidget(page);
  area->viewport()->setAutoFillBackground(false);
  page->setAutoFillBackground(false);
  tabs_->addTab(area, name);
  return page;
}

QSpinBox* StudySettingsDialog::add_spin(QWidget* page, const QString& name, const char* object, int low,
                                        int high, int value) {
  auto* spin = new QSpinBox(page);
  spin->setObjectName(QString::fromLatin1(object));
  spin->setAccessibleName(QString(name).remove(QLatin1Char('&')));
  spin->setRange(low, high);
  spin->setValue(value);
  static_cast<QFormLayout*>(page->layout())->addRow(name, spin);
  return spin;
}

QCheckBox* StudySettingsDialog::add_check(QWidget* page, const QString& name, const char* object, bool on) {
  auto* check = new QCheckBox(name, page);
  check->setObjectName(QString::fromLatin1(object));
  check->setChecked(on);
  static_cast<QFormLayout*>(page->layout())->addRow(check);
  return check;
}

QWidget* StudySettingsDialog::make_amount() {
  auto* page = add_page(tr("How much"));
  auto* form = static_cast<QFormLayout*>(page->layout());
  retention_ = new NumberSlider(tr("Desired retention"), QStringLiteral("study_retention"),
                                study::kLowestRetention * 100, study::kHighestRetention * 100, 1,
                                QStringLiteral("%1 %"), 0, page);
  retention_->set_value(before_.fsrs.desired_retention * 100);
  form->addRow(retention_);
  workload_ = sentence("study_workload", page);
  form->addRow(workload_);
  new_ = add_spin(page, tr("&New characters a day, at most"), "study_new", 0, 1000, before_.new_per_day);
  reviews_ =
      add_spin(page, tr("&Reviews a day, at most"), "study_reviews", 1, 10'000, before_.reviews_per_day);
  day_starts_ =
      add_spin(page, tr("A study &day begins at (hour)"), "study_day_starts", 0, 12, before_.day_starts_at);
  zone_ = new QComboBox(page);
  zone_->setObjectName(QStringLiteral("study_zone"));
  zone_->setAccessibleName(tr("Time zone"));
  zone_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  zone_->addItem(tr("as the computer"), QString());
  for (const auto& id : QTimeZone::availableTimeZoneIds()) {
    const QString name = QString::fromLatin1(id);
    if (name.contains(QLatin1Char('/'))) zone_->addItem(name, name);
  }
  const QString own = to_text(before_.time_zone);
  if (zone_->findData(own) < 0) zone_->addItem(own, own);
  zone_->setCurrentIndex(zone_->findData(own));
  form->addRow(tr("Time &zone"), zone_);
  connect(retention_, &NumberSlider::moved, this, &StudySettingsDialog::show_workload);
  connect(new_, &QSpinBox::valueChanged, this, &StudySettingsDialog::show_workload);
  return page;
}

QWidget* StudySettingsDialog::make_lists() {
  auto* page = add_page(tr("What"));
  auto* form = static_cast<QFormLayout*>(page->layout());
  order_ = new QComboBox(page);
  order_->setObjectName(QStringLiteral("study_order"));
  order_->setAccessibleName(tr("Order of new characters"));
  order_->addItem(tr("by school grade"), static_cast<int>(study::NewOrder::grade));
  order_->addItem(tr("commonest first"), static_cast<int>(study::NewOrder::frequency));
  order_->addItem(tr("fewest strokes first"), static_cast<int>(study::NewOrder::strokes));
  order_->addItem(tr("parts before wholes"), static_cast<int>(study::NewOrder::components));
  order_->addItem(tr("as in the lists"), static_cast<int>(study::NewOrder::own));
  order_->setCurrentIndex(order_->findData(static_cast<int>(before_.new_order)));
  form->addRow(tr("&Order of new characters"), order_);
  lists_ = new QListWidget(page);
  lists_->setObjectName(QStringLiteral("study_lists"));
  lists_->setAccessibleName(tr("Lists to learn from"));
  lists_->setMinimumHeight(QFontMetrics(font()).height() * 9);
  form->addRow(lists_);
  choice_ = sentence("study_choice", page);
  form->addRow(choice_);
  auto* buttons = new QWidget(page);
  auto* flow = new FlowLayout(kGap, kGap, buttons);
  const auto button = [&](const char* name, const QString& text, auto&& what) {
    auto* made = new QPushButton(text, buttons);
    made->setObjectName(QString::fromLatin1(name));
    connect(made, &QPushButton::clicked, this, std::forward<decltype(what)>(what));
    made->setEnabled(learner_.can_write());
    flow->addWidget(made);
  };
  button("list_new", tr("New list…"), [this] { new_list(); });
  button("list_remove", tr("Remove"), [this] { remove_list(); });
  button("list_up", tr("Up"), [this] { move_list(-1); });
  button("list_down", tr("Down"), [this] { move_list(+1); });
  button("list_postpone", tr("Postpone all…"), [this] {
    bool fine = false;
    const int days = QInputDialog::getInt(this, tr("Postpone"), tr("Days"), 7, 1, 3650, 1, &fine);
    if (!fine) return;
    const auto until = learner_.store().today() + std::chrono::days(days);
    for_list([&](std::span<const char32_t> all) { return learner_.store().postpone(all, until); },
             [](int n) { return tr("%n characters are postponed.", nullptr, n); });
  });
  button("list_pause", tr("Pause all"), [this] {
    for_list([this](std::span<const char32_t> all) { return learner_.store().pause(all); },
             [](int n) { return tr("%n characters are paused.", nullptr, n); });
  });
  button("list_resume", tr("Resume all"), [this] {
    for_list([this](std::span<const char32_t> all) { return learner_.store().resume(all); },
             [](int n) { return tr("%n characters come again.", nullptr, n); });
  });
  button("list_reset", tr("Begin all anew"), [this] {
    for_list([this](std::span<const char32_t> all) { return learner_.store().reset(all); },
             [](int n) { return tr("%n characters are new again.", nullptr, n); });
  });
  form->addRow(buttons);
  connect(lists_, &QListWidget::itemChanged, this, &StudySettingsDialog::show_choice);
  return page;
}

QWidget* StudySettingsDialog::make_schedule() {
  auto* page = add_page(tr("How"));
  auto* form = static_cast<QFormLayout*>(page->layout());
  hint_ = add_spin(page, tr("Misses of a stroke until a &hint is offered"), "study_hint_after", 1, 20,
                   before_.lesson.hint_after_misses);
  show_ = add_spin(page, tr("Misses until the stroke is &shown"), "study_show_after", 1, 20,
                   before_.lesson.show_after_misses);
  leech_ = add_spin(page, tr("Forgotten so often, a character gets another &lesson"), "study_leech", 2, 100,
                    before_.leech_lapses);
  fuzz_ = add_check(page, tr("&Vary intervals a little"), "study_fuzz", before_.fuzz);
  balance_ = add_check(page, tr("Choose the &emptier day"), "study_balance", before_.load_balance);
  weights_words_ = sentence("study_weights", page);
  form->addRow(weights_words_);
  auto* buttons = new QWidget(page);
  auto* flow = new FlowLayout(kGap, kGap, buttons);
  auto* import = new QPushButton(tr("FSRS weights of your own…"), buttons);
  import->setObjectName(QStringLiteral("weights_import"));
  connect(import, &QPushButton::clicked, this, &StudySettingsDialog::import_weights);
  auto* usual = new QPushButton(tr("The usual weights"), buttons);
  usual->setObjectName(QStringLiteral("weights_default"));
  connect(usual, &QPushButton::clicked, this, [this] {
    weights_ = study::kDefaultWeights;
    show_weights();
  });
  flow->addWidget(import);
  flow->addWidget(usual);
  form->addRow(buttons);
  return page;
}

QWidget* StudySettingsDialog::make_window(const Preferences& preferences) {
  auto* page = add_page(tr("Window"));
  auto* form = static_cast<QFormLayout*>(page->layout());
  at_home_ = add_check(page, tr("Nazori opens with &Home"), "study_at_home", preferences.begin_at_home);
  by_words_ = add_check(page, tr("Ask by a &word at times, the character left out"), "study_by_words",
                        preferences.asks_by_words);
  left_handed_ = add_check(page, tr("&Left-handed: what stands beside the tablet changes sides"),
                           "study_left_handed", preferences.left_handed);
  one_hand_ = new QComboBox(page);
  one_hand_->setObjectName(QStringLiteral("study_one_hand"));
  one_hand_->setAccessibleName(tr("Keys for one hand"));
  one_hand_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  one_hand_->addItem(tr("none"), static_cast<int>(OneHand::none));
  one_hand_->addItem(tr("left hand: 1 2 3 4, E goes on, W hint, X takes back"),
                     static_cast<int>(OneHand::left));
  one_hand_->addItem(tr("right hand: 7 8 9 0, K goes on, U hint, Backspace takes back"),
                     static_cast<int>(OneHand::right));
  one_hand_->setCurrentIndex(one_hand_->findData(static_cast<int>(preferences.one_hand)));
  form->addRow(tr("&Keys for one hand"), one_hand_);
  return page;
}

study::Settings StudySettingsDialog::settings() const {
  study::Settings to = before_;
  to.fsrs.desired_retention = std::round(retention_->value()) / 100;
  to.fsrs.weights = weights_;
  to.new_per_day = new_->value();
  to.reviews_per_day = reviews_->value();
  to.day_starts_at = day_starts_->value();
  to.time_zone = zone_->currentData().toString().toStdString();
  to.new_order = static_cast<study::NewOrder>(order_->currentData().toInt());
  to.new_lists.clear();
  for (int row = 0; row < lists_->count(); ++row)
    if (lists_->item(row)->checkState() == Qt::Checked)
      to.new_lists.push_back(lists_->item(row)->data(Qt::UserRole).toString().toStdString());
  to.fuzz = fuzz_->isChecked();
  to.load_balance = balance_->isChecked();
  to.leech_lapses = leech_->value();
  to.lesson.hint_after_misses = hint_->value();
  // What is shown at once needs no hint before.
  to.lesson.show_after_misses = std::max(show_->value(), hint_->value());
  return to;
}

void StudySettingsDialog::fill(Preferences& preferences) const {
  preferences.begin_at_home = at_home_->isChecked();
  preferences.asks_by_words = by_words_->isChecked();
  preferences.left_handed = left_handed_->isChecked();
  preferences.one_hand = static_cast<OneHand>(one_hand_->currentData().toInt());
}

void StudySettingsDialog::show_workload() {
  study::FsrsSettings fsrs = before_.fsrs;
  fsrs.weights = weights_;
  fsrs.desired_retention = std::round(retention_->value()) / 100;
  const auto workload = study::expected_workload(fsrs, std::min(new_->value(), 100), pace_);
  if (!workload) {
    workload_->clear();
    return;
  }
  const QLocale locale;
  workload_->setText(
      tr("With %1 new a day about %2 reviews and %n minutes a day; after a year about %3 characters "
         "known. Higher retention means more reviews.",
         nullptr, static_cast<int>(std::lround(workload->minutes_per_day)))
          .arg(locale.toString(std::min(new_->value(), 100)),
               locale.toString(std::lround(workload->reviews_per_day)),
               locale.toString(std::lround(workload->known))));
}

void StudySettingsDialog::show_lists() {
  const QSignalBlocker quiet(lists_);
  const QString at = current_list();
  QStringList chosen;
  if (lists_->count() == 0) {
    for (const auto& id : before_.new_lists) chosen.append(to_text(id));
  } else {
    for (int row = 0; row < lists_->count(); ++row)
      if (lists_->item(row)->checkState() == Qt::Checked)
        chosen.append(lists_->item(row)->data(Qt::UserRole).toString());
  }
  // Those that are chosen first, in their order; then the others.
  QStringList all = chosen;
  QStringList there;
  for (const auto& ready : study::ready_lists()) there.append(to_text(ready.id));
  const auto own_lists = learner_.store().lists();
  const auto tags = learner_.store().tags();
  if (own_lists)
    for (const auto& own : *own_lists) there.append(QStringLiteral("list:") + to_text(own.name));
  if (tags)
    for (const auto& [tag, members] : *tags) there.append(QStringLiteral("tag:") + to_text(tag));
  // What is chosen and cannot be read now stays chosen.
  if (!own_lists || !tags) there.append(chosen);
  for (const auto& id : there)
    if (!all.contains(id)) all.append(id);
  lists_->clear();
  for (const auto& id : all) {
    if (!there.contains(id)) continue;
    auto* item = new QListWidgetItem(ListChoice::name_of(id), lists_);
    item->setData(Qt::UserRole, id);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(chosen.contains(id) ? Qt::Checked : Qt::Unchecked);
    if (id == at) lists_->setCurrentItem(item);
  }
  if (lists_->currentRow() < 0) lists_->setCurrentRow(0);
  show_choice();
  if (!own_lists || !tags)
    choice_->setText(tr("Your lists and tags cannot be read: %1")
                         .arg(reason(own_lists ? tags.error() : own_lists.error())));
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
  choice_->setText(order.empty() ? tr("No list is chosen: nothing new will come.")
                                 : tr("%Ln characters are chosen, %1 of them met already.", nullptr,
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

void StudySettingsDialog::remove_list() {
  const QString id = current_list();
  if (!id.startsWith(QLatin1String("list:"))) {
    choice_->setText(tr("Only lists of your own can be removed."));
    return;
  }
  QMessageBox box(QMessageBox::Question, tr("Remove the list"),
                  tr("Remove “%1”? What was learnt of its characters stays.").arg(id.mid(5)),
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
                         ? tr("There is nothing in this list.")
                         : tr("Your lists and tags cannot be read: %1").arg(reason(members.error())));
    return;
  }
  const auto result = what(*members);
  if (!learner_.report(result)) {
    choice_->setText(reason(result.error()));
    return;
  }
  choice_->setText(done(static_cast<int>(members->size())) + QLatin1Char(' ') +
                   tr("Ctrl+Shift+Z takes it back."));
}

void StudySettingsDialog::show_weights() {
  weights_words_->setText(weights_ == study::kDefaultWeights
                              ? tr("FSRS-6 with its usual weights.")
                              : tr("FSRS-6 with weights of your own, the first %1.")
                                    .arg(QLocale().toString(weights_.front(), 'f', 4)));
  show_workload();
}

void StudySettingsDialog::import_weights() {
  bool fine = false;
  QStringList all;
  for (const double weight : weights_) all.append(QString::number(weight));
  const QString text = QInputDialog::getMultiLineText(this, tr("FSRS weights"),
                                                      tr("21, 19 or 17 numbers, as Anki shows them:"),
                                                      all.join(QStringLiteral(", ")), &fine);
  if (!fine) return;
  const auto weights = study::parse_weights(text.toStdString());
  if (!weights) {
    weights_words_->setText(tr("These weights are not taken: %1.").arg(reason(weights.error())));
    return;
  }
  weights_ = *weights;
  show_weights();
}

}  // namespace nazori::ui
