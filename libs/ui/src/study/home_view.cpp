// SPDX-License-Identifier: Apache-2.0
#include "study/home_view.h"

#include <QApplication>
#include <QEvent>
#include <QFontInfo>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QResizeEvent>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "nazori/practice/day_outlook.h"
#include "settings/preferences.h"
#include "widgets/parts.h"
#include "words/kanji_text.h"
#include "words/learner_words.h"
#include "words/study_words.h"

namespace nazori::ui {
namespace {

constexpr int kMargin = 28;
constexpr int kWidest_em = 60;  ///< longer lines are hard to read
constexpr int kMostShown = 12;  ///< characters in a sentence

QString in_a_row(const std::vector<char32_t>& characters) {
  QString text;
  for (std::size_t i = 0; i < characters.size() && i < kMostShown; ++i) text += to_text(characters[i]);
  return characters.size() > kMostShown ? text + QStringLiteral("…") : text;
}

}  // namespace

HomeView::HomeView(practice::Learner& learner, const practice::StudySession& session, QWidget* parent)
    : QScrollArea(parent),
      learner_(learner),
      session_(session),
      content_(named(new QWidget(this), "information_content")) {
  setObjectName(QStringLiteral("home_page"));
  setAccessibleName(tr("Today"));
  setFrameShape(QFrame::NoFrame);

  day_ = sentence_label("home_day", content_);
  trouble_ = sentence_label("home_trouble", content_, "trouble");
  summary_ = sentence_label("home_summary", content_, "card");
  advice_ = sentence_label("home_advice", content_);
  leeches_ = sentence_label("home_leeches", content_);
  const auto button = [this](const char* name, const QString& text) {
    auto* made = named(new QPushButton(text, content_), name);
    made->setAutoDefault(true);  // Enter presses what has the keyboard
    return made;
  };
  again_ = button("home_try_again", tr("Try again"));
  start_ = button("home_start", {});
  start_->setProperty("role", QStringLiteral("primary"));
  leech_button_ = button("home_leech_lesson", tr("Relearn these"));
  settings_ = button("home_settings", tr("Study settings…"));
  free_writing_ = button("home_free_writing", tr("Choose a character"));
  connect(again_, &QPushButton::clicked, this, [this] { learner_.open_again(); });
  connect(start_, &QPushButton::clicked, this, &HomeView::start_wanted);
  connect(leech_button_, &QPushButton::clicked, this, &HomeView::leeches_wanted);
  connect(settings_, &QPushButton::clicked, this, &HomeView::settings_wanted);
  connect(free_writing_, &QPushButton::clicked, this, &HomeView::free_writing_wanted);

  grid_ = new QGridLayout;
  grid_->setSpacing(12);
  for (const auto& [which, name] : {std::pair(due, "home_due"), std::pair(fresh, "home_new"),
                                    std::pair(minutes, "home_time"), std::pair(streak, "home_streak")})
    tiles_[which] = make_tile(name);

  auto* column = new QVBoxLayout;
  column->setSpacing(16);
  column->addWidget(day_);
  column->addWidget(trouble_);
  column->addWidget(again_, 0, Qt::AlignLeft);
  column->addWidget(summary_);
  column->addWidget(start_);
  column->addLayout(grid_);
  column->addWidget(advice_);
  column->addWidget(leeches_);
  column->addWidget(leech_button_, 0, Qt::AlignLeft);
  column->addStretch(1);
  auto* others = new QHBoxLayout;
  others->addWidget(settings_);
  others->addWidget(free_writing_);
  others->addStretch(1);
  column->addLayout(others);
  content_->setLayout(column);
  make_scrolling(this, content_);
  summary_->hide();
  fit();
}

HomeView::Tile HomeView::make_tile(const char* name) {
  Tile tile;
  tile.frame = new QFrame(content_);
  tile.frame->setProperty("role", QStringLiteral("card"));
  tile.number = new QLabel(tile.frame);
  tile.number->setObjectName(QString::fromLatin1(name));
  tile.words = new QLabel(tile.frame);
  tile.words->setWordWrap(true);
  tile.words->setProperty("role", QStringLiteral("muted"));
  auto* column = new QVBoxLayout(tile.frame);
  column->setContentsMargins(16, 12, 16, 12);
  column->setSpacing(2);
  column->addWidget(tile.number);
  column->addWidget(tile.words);
  column->addStretch(1);
  return tile;
}

void HomeView::show_tile(TileName which, const QString& number, const QString& words) {
  tiles_[which].number->setText(number);
  tiles_[which].words->setText(words);
  tiles_[which].number->setAccessibleName(QStringLiteral("%1 %2").arg(number, words));
}

void HomeView::set_text(QLabel* label, const QString& text) {
  label->setText(text);
  label->setVisible(!text.isEmpty());
}

QString HomeView::after_the_work(const study::DayPlan& plan) const {
  using Kind = practice::DayOutlook::Kind;
  const auto& store = learner_.store();
  const auto outlook = practice::outlook_of(store, plan);
  switch (outlook.kind) {
    case Kind::later_today:
      return tr("Done for now. %n characters come back today, the first at %1.", nullptr, outlook.characters)
          .arg(StudyWords::minute(outlook.first, store.calendar()));
    case Kind::limit_reached:
      return tr("Done for today: you have reached your daily limit. %n reviews will wait until tomorrow.",
                nullptr, outlook.characters);
    case Kind::nothing_to_learn:
      return tr(
          "Nothing to learn yet. In the study settings, choose lists and how many new characters you want "
          "per day.");
    case Kind::reviews_tomorrow:
      return tr("Done for today. %n reviews are due tomorrow.", nullptr, outlook.characters);
    case Kind::new_tomorrow:
      return tr("Done for today. Tomorrow: new characters, no reviews.");
    case Kind::nothing_tomorrow:
      return tr("Done for today. Nothing is due tomorrow.");
  }
  return {};
}

QString HomeView::advice(const study::DayPlan& plan) const {
  if (plan.now.empty()) return after_the_work(plan);
  QStringList said;
  if (plan.gentle) {
    said.append(
        tr("%n reviews are waiting. No hurry: do %1 today, starting with the characters you know best.",
           nullptr, plan.gentle->overdue)
            .arg(plan.gentle->per_day));
    said.append(
        tr("You will catch up in %n days, on %1. No new characters until then.", nullptr, plan.gentle->days)
            .arg(StudyWords::day(plan.gentle->last_day)));
  } else if (plan.held_back > 0) {
    said.append(tr("%n more reviews will wait for another day because of your daily limit.", nullptr,
                   plan.held_back));
  }
  if (learner_.store().cards().empty())
    said.append(
        tr("You first watch each new character, then trace it, then write it with less and less help, and "
           "finally from memory. It comes back just before you would forget it."));
  std::vector<char32_t> news;
  for (const auto& task : plan.now)
    if (task.kind == study::TaskKind::fresh) news.push_back(task.character);
  if (!news.empty()) said.append(tr("New today: %1").arg(in_a_row(news)));
  return said.join(QLatin1Char('\n'));
}

void HomeView::refresh() {
  QWidget* keyboard = QApplication::focusWidget();
  if (keyboard != nullptr && !isAncestorOf(keyboard)) keyboard = nullptr;
  const auto& store = learner_.store();
  const QString day = StudyWords::day(store.today());
  const QString profile = to_text(learner_.profile());
  day_->setText(profile == Preferences().profile ? day : tr("%1 · %2").arg(day, profile));
  set_text(trouble_,
           LearnerWords::sentence(learner_.trouble() ? learner_.trouble() : learner_.backup_trouble()));
  again_->setVisible(!learner_.can_write());
  const auto plan = learner_.plan();
  if (!plan) {
    set_text(trouble_, to_text(base::to_line(plan.error())));
    return;
  }
  const QLocale locale;
  const int news = plan->count(study::TaskKind::fresh);
  const int reviews = static_cast<int>(plan->now.size()) - news;
  show_tile(due, locale.toString(reviews), tr("due now"));
  show_tile(fresh, locale.toString(news),
            plan->new_done > 0 ? tr("new (%1 already done today)").arg(plan->new_done) : tr("new today"));
  const auto rounded = std::chrono::round<std::chrono::minutes>(plan->estimate).count();
  const int whole = plan->now.empty() ? 0 : std::max(1, static_cast<int>(rounded));
  show_tile(minutes, locale.toString(whole), tr("minutes (estimate)", nullptr, whole));
  const auto run = practice::streak_now(store);
  show_tile(streak, locale.toString(run.days),
            run.days == 0      ? tr("days in a row", nullptr, 0)
            : run.day_off_used ? tr("days in a row (day off used this week)", nullptr, run.days)
                               : tr("days in a row (one day off per week is fine)", nullptr, run.days));

  const bool running = session_.is_running();
  can_start_ = running || (!plan->now.empty() && learner_.can_write());
  start_->setVisible(can_start_);
  start_->setText(running ? tr("Continue the session")
                          : tr("Start: %n characters, %1", nullptr, static_cast<int>(plan->now.size()))
                                .arg(StudyWords::about(plan->estimate)));
  start_->setToolTip(tr("Enter or Space: start"));
  set_text(advice_, advice(*plan));
  const int leeches = static_cast<int>(plan->leeches.size());
  set_text(leeches_, leeches == 0 ? QString()
                                  : tr("%n characters were forgotten too often and taken out of reviews: %1",
                                       nullptr, leeches)
                                        .arg(in_a_row(plan->leeches)));
  leech_button_->setVisible(leeches > 0 && !running && learner_.can_write());
  QWidget* first = start_;
  if (!can_start_) first = learner_.can_write() ? static_cast<QWidget*>(settings_) : again_;
  // The widget with the focus may be hidden now, or may no longer be the first thing to do.
  const bool moves = keyboard == focusProxy() || (keyboard != nullptr && !keyboard->isVisible());
  setFocusProxy(first);
  if (keyboard == nullptr || !moves) return;
  first->setFocus(Qt::OtherFocusReason);
  // Scroll to the top after the new layout.
  QTimer::singleShot(0, this, [this] {
    verticalScrollBar()->setValue(0);
    if (auto* at = focusProxy()) ensureWidgetVisible(at);
  });
}

void HomeView::show_summary(const practice::SessionSummary& summary) {
  QStringList said;
  if (summary.reviews > 0) {
    said.append(tr("Written from memory: %n", nullptr, summary.reviews));
    QStringList counts;
    for (std::size_t i = 0; i < study::kRatings.size(); ++i)
      if (summary.ratings[i] > 0)
        counts.append(
            QStringLiteral("%1 %2").arg(StudyWords::rating(study::kRatings[i])).arg(summary.ratings[i]));
    said.append(counts.join(QStringLiteral(" · ")));
  }
  if (!summary.met.empty()) said.append(tr("New: %1").arg(in_a_row(summary.met)));
  if (!summary.lessons.empty()) said.append(tr("Relearned: %1").arg(in_a_row(summary.lessons)));
  if (!summary.again.empty()) said.append(tr("Coming back soon: %1").arg(in_a_row(summary.again)));
  if (summary.reviews + summary.practices > 0)
    said.append(tr("Time: %1").arg(StudyWords::about(summary.time)));
  set_text(summary_, said.join(QLatin1Char('\n')));
}

void HomeView::fit() {
  const int em = QFontInfo(font()).pixelSize();
  QFont large = font();
  large.setPointSizeF(QFontInfo(font()).pointSizeF() * 2.2);
  for (const auto& tile : tiles_) tile.number->setFont(large);
  QFont heading = font();
  heading.setPointSizeF(QFontInfo(font()).pointSizeF() * 1.5);
  day_->setFont(heading);
  QFont button = font();
  button.setPointSizeF(QFontInfo(font()).pointSizeF() * 1.25);
  start_->setFont(button);
  const int room = std::min(viewport()->width() - 2 * kMargin, em * kWidest_em);
  const int beside = std::max(kMargin, (viewport()->width() - room) / 2);
  content_->layout()->setContentsMargins(beside, kMargin, beside, kMargin);
  const int columns = room >= em * 40 ? 4 : room >= em * 20 ? 2 : 1;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    grid_->addWidget(tiles_[i].frame, static_cast<int>(i) / columns, static_cast<int>(i) % columns);
    grid_->setColumnStretch(static_cast<int>(i), static_cast<int>(i) < columns ? 1 : 0);
  }
}

void HomeView::changeEvent(QEvent* event) {
  QScrollArea::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

void HomeView::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  fit();
}

}  // namespace nazori::ui
