// SPDX-License-Identifier: Apache-2.0
#include "study/study_settings_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QTabWidget>
#include <QTimeZone>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "nazori/study/statistics.h"
#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/number_slider.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/learner_words.h"

namespace nazori::ui {

StudySettingsDialog::StudySettingsDialog(practice::Learner& learner, const Preferences& preferences,
                                         QWidget* parent)
    : QDialog(parent),
      learner_(learner),
      before_(learner.store().settings()),
      weights_(before_.fsrs.weights),
      tabs_(named(new QTabWidget(this), "study_settings_tabs")) {
  if (const auto pace = study::pace_of(learner.store())) pace_ = *pace;
  setObjectName(QStringLiteral("study_settings_dialog"));
  setWindowTitle(tr("Study settings"));
  tabs_->setDocumentMode(true);
  make_amount();
  make_lists();
  make_schedule();
  make_window(preferences);
  auto* buttons = named(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this),
                        "study_settings_buttons");
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  buttons->button(QDialogButtonBox::Ok)->setEnabled(learner.can_write());
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 12);
  column->addWidget(tabs_, 1);
  if (!learner.can_write()) {
    auto* trouble = text_label("study_settings_trouble", this, "muted");
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
  area->setFrameShape(QFrame::NoFrame);
  auto* page = named(new QWidget(area), "information_content");
  auto* form = new QFormLayout(page);
  form->setContentsMargins(12, 16, 12, 12);
  form->setSpacing(10);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  make_scrolling(area, page);
  tabs_->addTab(area, name);
  return page;
}

QSpinBox* StudySettingsDialog::add_spin(QWidget* page, const QString& name, const char* object, int low,
                                        int high, int value) {
  auto* spin = named(new QSpinBox(page), object);
  spin->setAccessibleName(QString(name).remove(QLatin1Char('&')));
  spin->setRange(low, high);
  spin->setValue(value);
  static_cast<QFormLayout*>(page->layout())->addRow(name, spin);
  return spin;
}

QCheckBox* StudySettingsDialog::add_check(QWidget* page, const QString& name, const char* object, bool on) {
  auto* check = named(new QCheckBox(name, page), object);
  check->setChecked(on);
  static_cast<QFormLayout*>(page->layout())->addRow(check);
  return check;
}

QWidget* StudySettingsDialog::make_amount() {
  auto* page = add_page(tr("Daily goal"));
  auto* form = static_cast<QFormLayout*>(page->layout());
  retention_ = new NumberSlider(tr("Desired retention"), QStringLiteral("study_retention"),
                                study::kLowestRetention * 100, study::kHighestRetention * 100, 1,
                                QStringLiteral("%1%"), 0, page);
  retention_->set_value(before_.fsrs.desired_retention * 100);
  form->addRow(retention_);
  workload_ = text_label("study_workload", page, "muted");
  form->addRow(workload_);
  new_ = add_spin(page, tr("&New characters per day (maximum)"), "study_new", 0, 1000, before_.new_per_day);
  reviews_ =
      add_spin(page, tr("&Reviews per day (maximum)"), "study_reviews", 1, 10'000, before_.reviews_per_day);
  brush_ = add_spin(page, tr("Characters with the &brush per day (maximum)"), "study_brush", 0, 100,
                    before_.brush_per_day);
  brush_->setSpecialValueText(tr("off"));
  auto* brush_words = text_label("study_brush_words", page, "muted");
  brush_words->setText(
      tr("Well known characters are also written with the brush, on the page Brush. These reviews are "
         "scheduled apart from those from memory."));
  form->addRow(brush_words);
  day_starts_ =
      add_spin(page, tr("A study &day starts at (hour)"), "study_day_starts", 0, 12, before_.day_starts_at);
  zone_ = named(new QComboBox(page), "study_zone", tr("Time zone"));
  zone_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  zone_->addItem(tr("same as the computer"), QString());
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

QWidget* StudySettingsDialog::make_schedule() {
  auto* page = add_page(tr("Review"));
  auto* form = static_cast<QFormLayout*>(page->layout());
  hint_ = add_spin(page, tr("Mistakes on a stroke before a &hint is offered"), "study_hint_after", 1, 20,
                   before_.lesson.hint_after_misses);
  show_ = add_spin(page, tr("Mistakes before the stroke is &shown"), "study_show_after", 1, 20,
                   before_.lesson.show_after_misses);
  leech_ = add_spin(page, tr("&Lapses before a character must be relearned"), "study_leech", 2, 100,
                    before_.leech_lapses);
  fuzz_ = add_check(page, tr("&Vary review intervals a little"), "study_fuzz", before_.fuzz);
  balance_ = add_check(page, tr("Pref&er days with fewer reviews"), "study_balance", before_.load_balance);
  weights_words_ = text_label("study_weights", page, "muted");
  form->addRow(weights_words_);
  auto* buttons = new QWidget(page);
  auto* flow = new FlowLayout(kButtonGap_px, kButtonGap_px, buttons);
  auto* import = named(new QPushButton(tr("Custom FSRS parameters…"), buttons), "weights_import");
  connect(import, &QPushButton::clicked, this, &StudySettingsDialog::import_weights);
  auto* usual = named(new QPushButton(tr("Default parameters"), buttons), "weights_default");
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
  at_home_ = add_check(page, tr("Start Nazori on &Home"), "study_at_home", preferences.begin_at_home);
  by_words_ = add_check(page, tr("Sometimes ask with a &word that leaves out the character"),
                        "study_by_words", preferences.asks_by_words);
  left_handed_ = add_check(page, tr("&Left-handed: panels, next button, brush and light change sides"),
                           "study_left_handed", preferences.left_handed);
  one_hand_ = named(new QComboBox(page), "study_one_hand", tr("One-handed keys"));
  one_hand_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  one_hand_->addItem(tr("none"), static_cast<int>(OneHand::none));
  one_hand_->addItem(tr("left hand: 1 2 3 4, E next, W hint, X undo"), static_cast<int>(OneHand::left));
  one_hand_->addItem(tr("right hand: 7 8 9 0, K next, U hint, Backspace undo"),
                     static_cast<int>(OneHand::right));
  one_hand_->setCurrentIndex(one_hand_->findData(static_cast<int>(preferences.one_hand)));
  form->addRow(tr("One-handed &keys"), one_hand_);
  return page;
}

study::Settings StudySettingsDialog::settings() const {
  study::Settings to = before_;
  to.fsrs.desired_retention = std::round(retention_->value()) / 100;
  to.fsrs.weights = weights_;
  to.new_per_day = new_->value();
  to.reviews_per_day = reviews_->value();
  to.brush_per_day = brush_->value();
  to.day_starts_at = day_starts_->value();
  to.time_zone = zone_->currentData().toString().toStdString();
  to.new_order = static_cast<study::NewOrder>(order_->currentData().toInt());
  to.new_lists = chosen_lists();
  to.fuzz = fuzz_->isChecked();
  to.load_balance = balance_->isChecked();
  to.leech_lapses = leech_->value();
  to.lesson.hint_after_misses = hint_->value();
  // The stroke is never shown before the hint.
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
  workload_->setText(tr("With %1 new characters a day: about %2 reviews and %n minutes a day, and about %3 "
                        "characters known after a year. Higher retention means more reviews.",
                        nullptr, static_cast<int>(std::lround(workload->minutes_per_day)))
                         .arg(locale.toString(std::min(new_->value(), 100)),
                              locale.toString(std::lround(workload->reviews_per_day)),
                              locale.toString(std::lround(workload->known))));
}

void StudySettingsDialog::show_weights() {
  weights_words_->setText(weights_ == study::kDefaultWeights
                              ? tr("FSRS-6 with default parameters.")
                              : tr("FSRS-6 with custom parameters (the first is %1).")
                                    .arg(QLocale().toString(weights_.front(), 'f', 4)));
  show_workload();
}

void StudySettingsDialog::import_weights() {
  bool fine = false;
  QStringList all;
  for (const double weight : weights_) all.append(QString::number(weight));
  const QString text = QInputDialog::getMultiLineText(this, tr("FSRS parameters"),
                                                      tr("21, 19 or 17 numbers, as Anki shows them:"),
                                                      all.join(QStringLiteral(", ")), &fine);
  if (!fine) return;
  const auto weights = study::parse_weights(text.toStdString());
  if (!weights) {
    weights_words_->setText(tr("These parameters cannot be used: %1.").arg(reason(weights.error())));
    return;
  }
  weights_ = *weights;
  show_weights();
}

}  // namespace nazori::ui
