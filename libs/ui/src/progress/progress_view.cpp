// SPDX-License-Identifier: Apache-2.0
#include "progress/progress_view.h"

#include <QApplication>
#include <QComboBox>
#include <QFontInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "nazori/practice/extra_study.h"
#include "nazori/practice/milestones.h"
#include "nazori/practice/study_charts.h"
#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/controls/parts.h"
#include "progress/calendar_card.h"
#include "progress/characters_card.h"
#include "progress/hard_strokes_card.h"
#include "study/home_words.h"

namespace nazori::ui {
namespace {

constexpr int kMargin = 16;
constexpr int kGap = 14;
constexpr int kLettersForTwoColumns = 100;
constexpr int kWidest_em = 100;

QList<ChartCard*> chart_cards(QWidget* parent) {
  QList<ChartCard*> cards;
  for (const practice::ChartKind& kind : practice::chart_kinds())
    cards.append(new ChartCard(StudyCharts::id(kind.id), parent));
  return cards;
}

}  // namespace

ProgressView::ProgressView(practice::Learner& learner, QWidget* parent)
    : QWidget(parent),
      learner_(learner),
      scroll_(named(new QScrollArea(this), "progress_scroll")),
      content_(named(new QWidget(scroll_), "progress_content")),
      trouble_(text_label("progress_trouble", this)),
      title_(text_label("progress_title", content_)),
      way_(text_label("progress_way", content_, "muted")),
      work_(named(new QProgressBar(content_), "progress_work", tr("Calculating statistics"))),
      calendar_(new CalendarCard(content_)),
      characters_(new CharactersCard(content_)),
      hard_strokes_(new HardStrokesCard(content_)),
      practise_(with_role(named(new QPushButton(content_), "progress_practise_button"), "link")),
      more_(with_role(named(new QPushButton(content_), "progress_more_button"), "link")),
      more_box_(named(new QWidget(content_), "progress_more_box")),
      figures_(text_label("progress_figures", more_box_)),
      time_(named(new QComboBox(more_box_), "progress_time", tr("Period shown"))),
      first_grid_(new QGridLayout),
      grid_(new QGridLayout),
      charts_(chart_cards(more_box_)),
      cards_(QList<ChartCard*>{calendar_, characters_, hard_strokes_} + charts_),
      at_hand_(cards_.front()) {
  setObjectName(QStringLiteral("progress_page"));
  setAccessibleName(tr("Progress"));
  setFocusPolicy(Qt::StrongFocus);
  trouble_->setAlignment(Qt::AlignCenter);
  trouble_->setMargin(3 * kMargin);
  trouble_->hide();
  figures_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* caption = new QLabel(tr("Period s&hown"), more_box_);
  caption->setBuddy(time_);
  time_->addItem(tr("1 month"), static_cast<int>(TimeShown::month));
  time_->addItem(tr("3 months"), static_cast<int>(TimeShown::season));
  time_->addItem(tr("1 year"), static_cast<int>(TimeShown::year));
  time_->addItem(tr("All time"), static_cast<int>(TimeShown::everything));
  time_->setCurrentIndex(1);
  work_->setTextVisible(false);
  work_->hide();
  more_->setAutoDefault(true);
  practise_->setAutoDefault(true);
  practise_->setToolTip(tr("Write these characters from memory once (P)"));

  auto* choice = new QHBoxLayout;
  choice->setSpacing(8);
  choice->addWidget(caption);
  choice->addWidget(time_);
  choice->addStretch(1);
  first_grid_->setSpacing(kGap);
  grid_->setSpacing(kGap);
  auto* more = new QVBoxLayout(more_box_);
  more->setContentsMargins(0, 0, 0, 0);
  more->setSpacing(kGap);
  more->addWidget(figures_);
  more->addLayout(choice);
  more->addLayout(grid_);
  auto* column = new QVBoxLayout(content_);
  column->setSpacing(kGap);
  column->addWidget(title_);
  column->addWidget(way_);
  column->addWidget(work_);
  column->addLayout(first_grid_);
  column->addWidget(more_, 0, Qt::AlignLeft);
  column->addWidget(more_box_);
  column->addStretch(1);
  hard_strokes_->layout()->addWidget(practise_);
  scroll_->setWidget(content_);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(scroll_, 1);
  all->addWidget(trouble_, 1);
  more_box_->hide();

  connect(more_, &QPushButton::clicked, this, [this] { set_shows_more(!shows_more()); });
  connect(practise_, &QPushButton::clicked, this, &ProgressView::practise_wanted);
  connect(time_, &QComboBox::currentIndexChanged, this, [this] {
    show_charts(false);
    emit time_changed();
  });
  connect(characters_, &CharactersCard::list_changed, this, [this] {
    show_characters();
    emit time_changed();
  });
  connect(characters_, &CharactersCard::opened, this, &ProgressView::opened);
  connect(hard_strokes_, &HardStrokesCard::opened, this, &ProgressView::opened);
  for (auto* card : cards_)
    connect(card, &ChartCard::copy_wanted, this, [this, card] { emit copy_wanted(card); });
  connect(qApp, &QApplication::focusChanged, this,
          [this](const QWidget* /*old*/, QWidget* now) { note_focus(now); });
  clear();
  set_shows_more(false);
}

void ProgressView::clear() {
  study::Statistics none;
  none.today = learner_.store().today();
  show_statistics(std::make_shared<const study::Statistics>(std::move(none)));
}

// The card with the focus is destroyed after the list of cards. That moves the focus, and the slot would use
// the list.
ProgressView::~ProgressView() { disconnect(qApp, nullptr, this, nullptr); }

void ProgressView::show_statistics(const practice::SharedStatistics& statistics) {
  statistics_ = statistics;
  show_work(1);
  show_trouble({});
  show_way();
  show_figures();
  calendar_->show_calendar(*statistics_);
  show_charts(true);
  show_characters();
  hard_strokes_->show_strokes(*statistics_, learner_.database());
  const auto hard = hardest();
  practise_->setVisible(!hard.empty() && learner_.can_write());
  practise_->setText(tr("Practise these, %1").arg(HomeWords::minutes(practice::practice_time(hard.size()))));
  arrange();
}

void ProgressView::show_characters() {
  characters_->show_characters(*statistics_, learner_.lists(), learner_.store());
}

void ProgressView::show_charts(bool all) {
  const int days = static_cast<int>(time_shown());
  const study::Day first = days == 0 ? study::Day() : statistics_->today - std::chrono::days(days - 1);
  auto card = charts_.begin();
  for (const practice::ChartKind& kind : practice::chart_kinds()) {
    if (all || kind.looks_back) {
      const practice::Chart chart = kind.build(*statistics_, first);
      (*card)->show_chart(chart, StudyCharts::text(chart));
    }
    ++card;
  }
}

bool ProgressView::shows_more() const { return !more_box_->isHidden(); }

void ProgressView::set_shows_more(bool more) {
  const bool changes = more != shows_more();
  if (!more && at_hand_ != nullptr && more_box_->isAncestorOf(at_hand_)) at_hand_ = cards_.front();
  more_box_->setVisible(more);
  more_->setText((more ? QStringLiteral("▾ ") : QStringLiteral("▸ ")) + tr("More charts and figures"));
  more_->setAccessibleName(more ? tr("Less: hide the charts") : tr("More charts and figures"));
  more_->setToolTip(tr("Show or hide the charts (M)"));
  if (changes) emit more_changed(more);
}

std::vector<char32_t> ProgressView::hardest() const {
  constexpr std::size_t kMost = 4;
  std::vector<char32_t> found;
  for (const auto& stroke : statistics_->hard_strokes)
    if (found.size() < kMost && std::find(found.begin(), found.end(), stroke.character) == found.end())
      found.push_back(stroke.character);
  return found;
}

void ProgressView::show_way() {
  if (statistics_->characters.empty()) {
    title_->setText(tr("Progress"));
    way_->setText(
        tr("Nothing studied yet. Start with a few characters on Home, or trace one on the Characters page. "
           "Your progress will appear here in charts and tables."));
    way_->show();
    return;
  }
  const auto reached = practice::milestones(learner_);
  if (!reached || reached->empty()) {
    title_->setText(tr("Progress"));
    way_->hide();
    return;
  }
  // All school kanji where they are learned, else the list that is learned now.
  const auto& whole = reached->back().list == practice::kSchoolKanji ? reached->back() : reached->front();
  title_->setText(whole.list == practice::kSchoolKanji
                      ? tr("%1 school kanji", "405 of 2,136").arg(HomeWords::count(whole))
                      : tr("%1: %2", "list, 40 of 46").arg(HomeWords::list(whole), HomeWords::count(whole)));
  QStringList said;
  for (const auto& one : *reached) {
    if (&one == &whole) {
      if (one.days_left)
        said.append(tr("At this pace, all of them in %1.").arg(HomeWords::about_days(*one.days_left)));
      continue;
    }
    said.append(
        one.days_left
            ? tr("%1: %2, at this pace done in %3.")
                  .arg(HomeWords::list(one), HomeWords::count(one), HomeWords::about_days(*one.days_left))
            : tr("%1: %2.", "list, 40 of 46").arg(HomeWords::list(one), HomeWords::count(one)));
  }
  way_->setText(said.join(QLocale().language() == QLocale::Japanese ? QString() : QStringLiteral(" ")));
  way_->setVisible(!said.isEmpty());
}

void ProgressView::show_figures() {
  const auto& s = *statistics_;
  const QLocale locale;
  QStringList lines;
  lines.append(tr("Days in a row: %1, longest %2%3")
                   .arg(locale.toString(s.streak.days), locale.toString(s.streak.longest),
                        s.streak.days == 0      ? QString()
                        : !s.streak.today_done  ? tr("; not yet today")
                        : s.streak.day_off_used ? tr("; day off used this week")
                                                : QString()));
  lines.append(tr("Reviews: %1 in %2").arg(locale.toString(s.reviews), StudyCharts::duration(s.time)));
  if (s.last_30_days.reviews > 0)
    lines.append(tr("Recall in the last 30 days: %1 of %2 reviews (predicted: %3)")
                     .arg(StudyCharts::percent(s.last_30_days.actual()),
                          locale.toString(s.last_30_days.reviews),
                          StudyCharts::percent(s.last_30_days.predicted)));
  const auto known = std::count_if(s.characters.begin(), s.characters.end(), [](const auto& one) {
    return one.strength == study::Strength::young || one.strength == study::Strength::mature;
  });
  lines.append(tr("Characters: %1 studied, %2 learned")
                   .arg(locale.toString(static_cast<qlonglong>(s.characters.size())),
                        locale.toString(static_cast<qlonglong>(known))));
  figures_->setText(lines.join(QStringLiteral("\n")));
}

void ProgressView::show_trouble(const QString& sentence) {
  trouble_->setText(sentence);
  trouble_->setVisible(!sentence.isEmpty());
  scroll_->setVisible(sentence.isEmpty());
}

void ProgressView::show_work(double done) {
  work_->setVisible(done < 1);
  work_->setValue(static_cast<int>(100 * done));
}

void ProgressView::refresh_appearance() {
  for (auto* card : cards_) card->refresh_appearance();
  if (statistics_) show_characters();
  columns_ = 0;
  arrange();
}

ProgressView::TimeShown ProgressView::time_shown() const {
  return static_cast<TimeShown>(time_->currentData().toInt());
}

void ProgressView::set_time_shown(TimeShown time) {
  time_->setCurrentIndex(std::max(0, time_->findData(static_cast<int>(time))));
}

bool ProgressView::change_time_shown(int by) {
  const int next = time_->currentIndex() + by;
  if (next < 0 || next >= time_->count()) return false;
  time_->setCurrentIndex(next);
  return true;
}

ChartCard* ProgressView::card(const QString& id) const {
  const auto found = std::find_if(cards_.begin(), cards_.end(),
                                  [&](const ChartCard* card) { return card->shown().id == id; });
  return found == cards_.end() ? cards_.front() : *found;
}

ChartCard* ProgressView::card_at_hand() const { return at_hand_; }

void ProgressView::go_to(const QString& id) {
  at_hand_ = card(id);
  if (charts_.contains(at_hand_)) set_shows_more(true);
  at_hand_->focus_content();
  scroll_to(at_hand_);
}

void ProgressView::scroll_to(ChartCard* card) {
  // Together with the first card, the figures above it are shown.
  if (card == cards_.front())
    scroll_->ensureVisible(0, 0);
  else
    scroll_->ensureWidgetVisible(card, 0, kMargin);
}

void ProgressView::note_focus(QWidget* now) {
  for (auto* card : cards_) {
    if (now == nullptr || !card->isAncestorOf(now)) continue;
    at_hand_ = card;
    scroll_to(card);
  }
}

void ProgressView::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  at_hand_->focus_content();
}

void ProgressView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void ProgressView::arrange() {
  const int em = std::max(1, QFontInfo(font()).pixelSize());
  const int beside = std::max(kMargin, (width() - em * kWidest_em) / 2);
  content_->layout()->setContentsMargins(beside, kMargin, beside, kMargin);
  QFont large = font();
  large.setPointSizeF(QFontInfo(font()).pointSizeF() * 1.7);
  title_->setFont(large);
  const int letters = width() / std::max(1, fontMetrics().averageCharWidth());
  const int columns = letters >= kLettersForTwoColumns ? 2 : 1;
  if (columns == columns_) return;
  columns_ = columns;
  while (first_grid_->count() > 0) delete first_grid_->takeAt(0);
  first_grid_->addWidget(calendar_, 0, 0, 1, columns);
  first_grid_->addWidget(characters_, 1, 0);
  first_grid_->addWidget(hard_strokes_, columns == 2 ? 1 : 2, columns - 1);
  while (grid_->count() > 0) delete grid_->takeAt(0);
  for (int i = 0; i < charts_.size(); ++i) grid_->addWidget(charts_[i], i / columns, i % columns);
  for (auto* grid : {first_grid_, grid_})
    for (int i = 0; i < 2; ++i) grid->setColumnStretch(i, i < columns ? 1 : 0);
}

}  // namespace nazori::ui
