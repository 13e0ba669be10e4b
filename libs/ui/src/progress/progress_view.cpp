// SPDX-License-Identifier: Apache-2.0
#include "progress/progress_view.h"

#include <QApplication>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "nazori/practice/study_charts.h"
#include "progress/characters_card.h"
#include "progress/hard_strokes_card.h"
#include "progress/study_charts.h"
#include "widgets/parts.h"

namespace nazori::ui {
namespace {

constexpr int kMargin = 16;
constexpr int kGap = 14;
constexpr int kLettersForTwoColumns = 100;

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
      figures_(text_label("progress_figures", content_)),
      time_(named(new QComboBox(content_), "progress_time", tr("Period shown"))),
      work_(named(new QProgressBar(content_), "progress_work", tr("Calculating statistics"))),
      grid_(new QGridLayout),
      charts_(chart_cards(content_)),
      characters_(new CharactersCard(content_)),
      hard_strokes_(new HardStrokesCard(content_)),
      cards_(charts_ + QList<ChartCard*>{characters_, hard_strokes_}),
      at_hand_(cards_.front()) {
  setObjectName(QStringLiteral("progress_page"));
  setAccessibleName(tr("Progress"));
  setFocusPolicy(Qt::StrongFocus);
  trouble_->setAlignment(Qt::AlignCenter);
  trouble_->setMargin(3 * kMargin);
  trouble_->hide();
  figures_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* caption = new QLabel(tr("Period s&hown"), content_);
  caption->setBuddy(time_);
  time_->addItem(tr("1 month"), static_cast<int>(TimeShown::month));
  time_->addItem(tr("3 months"), static_cast<int>(TimeShown::season));
  time_->addItem(tr("1 year"), static_cast<int>(TimeShown::year));
  time_->addItem(tr("All time"), static_cast<int>(TimeShown::everything));
  time_->setCurrentIndex(1);
  work_->setRange(0, 100);
  work_->setTextVisible(false);
  work_->hide();

  auto* choice = new QHBoxLayout;
  choice->setSpacing(8);
  choice->addWidget(caption);
  choice->addWidget(time_);
  choice->addWidget(work_, 1);
  choice->addStretch(1);
  grid_->setSpacing(kGap);
  auto* column = new QVBoxLayout(content_);
  column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  column->setSpacing(kGap);
  column->addWidget(figures_);
  column->addLayout(choice);
  column->addLayout(grid_, 1);
  scroll_->setWidget(content_);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(scroll_, 1);
  all->addWidget(trouble_, 1);

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
  show_statistics(std::make_shared<const study::Statistics>());
}

// The card with the focus is destroyed after the list of cards. That moves the focus, and the slot would use
// the list.
ProgressView::~ProgressView() { disconnect(qApp, nullptr, this, nullptr); }

void ProgressView::show_statistics(const practice::SharedStatistics& statistics) {
  statistics_ = statistics;
  show_work(1);
  show_trouble({});
  show_figures();
  show_charts(true);
  show_characters();
  hard_strokes_->show_strokes(*statistics_, learner_.database());
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

void ProgressView::show_figures() {
  const auto& s = *statistics_;
  const QLocale locale;
  if (s.characters.empty()) {
    figures_->setText(
        tr("Nothing studied yet. Start with a few characters on Home, or trace one on the Characters page. "
           "Your progress will appear here in charts and tables."));
    return;
  }
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
  at_hand_->focus_content();
  scroll_to(at_hand_);
}

void ProgressView::scroll_to(ChartCard* card) {
  // Together with the first row of cards, the figures above it are shown.
  if (cards_.indexOf(card) < columns_)
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
  const int letters = width() / std::max(1, fontMetrics().averageCharWidth());
  const int columns = letters >= kLettersForTwoColumns ? 2 : 1;
  if (columns == columns_) return;
  columns_ = columns;
  while (grid_->count() > 0) delete grid_->takeAt(0);
  for (int i = 0; i < cards_.size(); ++i) grid_->addWidget(cards_[i], i / columns, i % columns);
  for (int i = 0; i < 2; ++i) grid_->setColumnStretch(i, i < columns ? 1 : 0);
  for (int i = 1; i < cards_.size(); ++i) QWidget::setTabOrder(cards_[i - 1], cards_[i]);
}

}  // namespace nazori::ui
