// SPDX-License-Identifier: Apache-2.0
#include "study/home_view.h"

#include <QApplication>
#include <QEvent>
#include <QFontInfo>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "nazori/practice/extra_study.h"
#include "nazori/practice/hard_characters.h"
#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/settings/preferences.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/learner_words.h"
#include "nazori/widgets/words/study_words.h"
#include "nazori/widgets/words/trouble_words.h"
#include "study/home.h"
#include "study/home_parts.h"
#include "study/home_words.h"

namespace nazori::ui {
namespace {

constexpr int kMargin = 28;
constexpr int kGap = 18;
constexpr int kWidest_em = 88;      ///< of the content: what is farther apart does not belong together
constexpr int kTwoColumns_em = 48;  ///< narrower content is one column
constexpr int kLow_em = 18;         ///< a lower view leaves its room to the button that starts
constexpr std::size_t kMostNew = 10;
constexpr std::size_t kMostHard = 3;
constexpr std::size_t kMostInk = 200;
constexpr double kSmallTile = 0.55;

QWidget* column_of(std::initializer_list<QWidget*> parts, QWidget* parent) {
  auto* box = new QWidget(parent);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap);
  for (auto* part : parts) column->addWidget(part);
  column->addStretch(1);
  return box;
}

QWidget* flow_of(std::initializer_list<QWidget*> parts, QWidget* parent) {
  auto* box = new QWidget(parent);
  auto* flow = new FlowLayout(kGap / 2, kGap / 2, box);
  for (auto* part : parts) flow->addWidget(part);
  return box;
}

}  // namespace

HomeView::HomeView(practice::Learner& learner, const practice::StudySession& session,
                   const HomeActions& actions, QWidget* parent)
    : QScrollArea(parent),
      learner_(learner),
      session_(session),
      content_(named(new QWidget(this), "information_content")) {
  setObjectName(QStringLiteral("home_page"));
  setAccessibleName(tr("Today"));
  setFrameShape(QFrame::NoFrame);

  greeting_ = text_label("home_greeting", content_);
  day_ = sentence_label("home_day", content_, "muted");
  trouble_ = sentence_label("home_trouble", content_, "trouble");
  again_ = named(new QPushButton(tr("Try again"), content_), "home_try_again");
  again_->setAutoDefault(true);  // Enter presses what has the keyboard
  connect(again_, &QPushButton::clicked, this, [this] { learner_.open_again(); });
  start_ = named(new StartButton(content_), "home_start");
  start_->setToolTip(tr("Enter or Space: start"));
  connect(start_, &QPushButton::clicked, actions.start, &QAction::trigger);
  reviews_ = button(actions.reviews, "home_reviews", {});
  more_ = button(actions.more, "home_more", {});
  ahead_ = button(actions.ahead, "home_ahead", {});
  // What has a key of its own says so, because Enter does not press it.
  show_key(more_, actions.more, tr("Five more new characters"));
  show_key(ahead_, actions.ahead, tr("Review ahead"));
  brush_ = button(actions.brush, "home_brush", {});
  brush_key_ = actions.brush->shortcut().toString(QKeySequence::NativeText);
  choose_ = button(actions.choose, "home_free_writing", tr("Choose characters"));
  settings_ = button(actions.settings, "home_settings", tr("Study settings…"));
  advice_ = sentence_label("home_advice", content_);
  advice_->setFocusPolicy(Qt::TabFocus);

  way_title_ = heading(tr("On the way"), content_);
  auto* way = new QWidget(content_);
  way_ = new QVBoxLayout(way);
  way_->setContentsMargins(0, 0, 0, 0);
  way_->setSpacing(kGap);
  way_card_ = card("home_way", {way});

  new_title_ = heading(tr("New today"), content_);
  new_.box = named(new QWidget(content_), "home_new");
  new FlowLayout(kGap / 2, kGap / 2, new_.box);

  ink_title_ = heading({}, content_);
  ink_title_->setObjectName(QStringLiteral("home_ink_title"));
  ink_ = new InkRow(content_);
  ink_empty_ = text_label("home_ink_empty", content_, "muted");
  ink_empty_->setText(tr("What you write from memory will appear here, in your own hand."));
  ink_figures_ = sentence_label("home_written", content_, "muted");
  all_ink_ = button(actions.all_ink, "home_all_ink", {}, "link");
  week_ = button(actions.week, "home_week", tr("Picture of the week…"), "link");
  month_ = button(actions.month, "home_month", tr("Picture of the month…"), "link");
  ink_card_ =
      card("home_ink", {ink_, ink_empty_, ink_figures_, flow_of({all_ink_, week_, month_}, content_)});
  connect(ink_, &InkRow::resized, this, [this] { all_ink_->setVisible(ink_->has_more()); });

  care_title_ = heading(tr("Needs care"), content_);
  care_.box = named(new QWidget(content_), "home_care_characters");
  new FlowLayout(kGap / 2, kGap / 2, care_.box);
  care_words_ = sentence_label("home_care", content_);
  practise_ = button(actions.practise, "home_practise", {}, "link");
  leeches_ = sentence_label("home_leeches", content_);
  relearn_ = button(actions.leeches, "home_leech_lesson", tr("Relearn these"), "link");
  care_card_ = card("home_care_card", {care_.box, care_words_, flow_of({practise_}, content_), leeches_,
                                       flow_of({relearn_}, content_)});

  left_ = column_of({trouble_, again_, start_, advice_,
                     flow_of({reviews_, more_, ahead_, brush_, choose_, settings_}, content_), way_card_},
                    content_);
  right_ = column_of({new_title_, new_.box, ink_title_, ink_card_, care_title_, care_card_}, content_);
  header_ = new QGridLayout;
  header_->setHorizontalSpacing(kGap);
  header_->setVerticalSpacing(kGap / 4);
  grid_ = new QGridLayout;
  grid_->setHorizontalSpacing(2 * kGap);
  grid_->setVerticalSpacing(kGap);
  auto* column = new QVBoxLayout(content_);
  column->addLayout(header_);
  column->addLayout(grid_);
  column->addStretch(1);
  way_card_->layout()->setSpacing(kGap);
  qobject_cast<QVBoxLayout*>(way_card_->layout())->insertWidget(0, way_title_);
  make_scrolling(this, content_);
  show_all_ink(false);
  fit();
}

QPushButton* HomeView::button(QAction* action, const char* name, const QString& text, const char* role) {
  auto* made = named(new QPushButton(text, content_), name);
  made->setAutoDefault(true);
  made->setToolTip(action->toolTip());
  if (role != nullptr) with_role(made, role);
  connect(made, &QPushButton::clicked, action, &QAction::trigger);
  return made;
}

void HomeView::show_key(QPushButton* button, const QAction* action, const QString& text) {
  const auto follow = [button, action, text] {
    const auto keys = action->shortcut().toString(QKeySequence::NativeText);
    button->setText(keys.isEmpty() ? text : QStringLiteral("%1  %2").arg(text, keys));
    button->setAccessibleName(text);
  };
  connect(action, &QAction::changed, button, follow);
  follow();
}

QWidget* HomeView::card(const char* name, std::initializer_list<QWidget*> parts) {
  auto* frame = with_role(named(new QFrame(content_), name), "card");
  auto* column = new QVBoxLayout(frame);
  column->setContentsMargins(kGap, kGap, kGap, kGap);
  column->setSpacing(kGap / 2);
  for (auto* part : parts) column->addWidget(part);
  return frame;
}

void HomeView::set_text(QLabel* label, const QString& text) {
  label->setText(text);
  label->setVisible(!text.isEmpty());
}

void HomeView::show_tiles(Tiles& tiles, const std::vector<char32_t>& characters, bool captions) {
  tiles.box->setVisible(!characters.empty());
  if (tiles.shown == characters) return;
  tiles.shown = characters;
  clear_layout(tiles.box->layout());
  for (const char32_t character : characters) {
    auto* tile = new CharacterTile(character,
                                   captions ? HomeWords::caption(learner_.database(), character) : QString(),
                                   captions ? 1 : kSmallTile, tiles.box);
    connect(tile, &QPushButton::clicked, this, [this, character] { emit character_wanted(character); });
    tiles.box->layout()->addWidget(tile);
    tile->show();
  }
}

void HomeView::show_header() {
  const auto& store = learner_.store();
  greeting_->setText(HomeWords::greeting(practice::part_of_day(store)));
  QStringList said{StudyWords::day(store.today())};
  const auto run = practice::streak_now(store);
  if (run.days > 0) said.append(HomeWords::streak(run));
  if (const QString profile = to_text(learner_.profile()); profile != Preferences().profile)
    said.append(profile);
  day_->setText(said.join(QStringLiteral(" · ")));
  day_->setToolTip(run.days == 0      ? QString()
                   : run.day_off_used ? tr("One day off a week is fine; this week's is used.")
                                      : tr("One day off a week is fine."));
}

void HomeView::show_work(const study::DayPlan& plan) {
  const auto& store = learner_.store();
  const bool running = session_.is_running();
  const int fresh = plan.count(study::TaskKind::fresh);
  const int due = static_cast<int>(plan.now.size()) - fresh;
  can_start_ = running || (!plan.now.empty() && learner_.can_write());
  start_->setVisible(can_start_);
  start_->show_work(
      running ? tr("Continue the session") : tr("Start"),
      plan.now.empty()
          ? QString()
          : tr("%1 · %2", "work, time").arg(HomeWords::work(due, fresh), StudyWords::about(plan.estimate)));
  const auto reviews = practice::reviews_now(store, plan);
  const bool is_choice = can_start_ && !running && due > 0 && fresh > 0 && reviews.has_value();
  reviews_->setVisible(is_choice);
  if (is_choice) reviews_->setText(tr("Only reviews, %1").arg(HomeWords::minutes(reviews->estimate)));
  const bool is_done = plan.now.empty() && !running && learner_.can_write();
  const auto next = is_done ? practice::new_characters(learner_, 1) : std::vector<char32_t>();
  more_->setVisible(is_done && plan.held_back == 0 && next && !next->empty());
  ahead_->setVisible(is_done && plan.held_back == 0 && !practice::reviews_ahead(store, 1).empty());
  const int with_brush = static_cast<int>(plan.brush.size());
  brush_->setVisible(with_brush > 0 && learner_.can_write());
  const QString brush = tr("Write with the brush, %n characters", nullptr, with_brush);
  brush_->setText(QStringLiteral("%1  %2").arg(brush, brush_key_));
  brush_->setAccessibleName(brush);
  set_text(advice_, plan.now.empty() ? HomeWords::outlook(practice::outlook_of(store, plan), store.calendar())
                                     : HomeWords::advice(plan, store.cards().empty()));
}

void HomeView::show_way() {
  const auto reached = practice::milestones(learner_);
  const auto bars = way_card_->findChildren<MilestoneBar*>();
  const std::size_t count = reached ? reached->size() : 0;
  way_card_->setVisible(count > 0);
  for (std::size_t i = 0; i < count; ++i) {
    auto* bar = i < static_cast<std::size_t>(bars.size()) ? bars[static_cast<qsizetype>(i)] : nullptr;
    if (bar == nullptr) {
      bar = new MilestoneBar(content_);
      way_->addWidget(bar);
    }
    bar->show_milestone((*reached)[i]);
    bar->show();
  }
  for (auto i = static_cast<qsizetype>(count); i < bars.size(); ++i) bars[i]->hide();
}

void HomeView::show_last_day(const study::DayPlan& plan) {
  const auto& store = learner_.store();
  auto today = practice::writing_record(store, plan.day, plan.day);
  if (!today) today = practice::WritingRecord();
  std::vector<char32_t> fresh = today->fresh;
  for (const auto& task : plan.now)
    if (task.kind == study::TaskKind::fresh && fresh.size() < kMostNew &&
        std::find(fresh.begin(), fresh.end(), task.character) == fresh.end())
      fresh.push_back(task.character);
  if (fresh.size() > kMostNew) fresh.resize(kMostNew);
  new_title_->setVisible(!fresh.empty());
  show_tiles(new_, fresh, true);

  practice::WritingRecord shown = *today;
  if (shown.writings.empty())
    if (auto last = practice::last_record_before(store, plan.day); last && *last) shown = **std::move(last);
  const bool is_today = shown.first == plan.day;
  const auto inks = practice::inks_of(store, shown.best_of_each(), kMostInk);
  const bool any = !shown.writings.empty();
  ink_->show_inks(inks ? *inks : std::vector<practice::InkedWriting>());
  ink_->setVisible(inks && !inks->empty());
  ink_empty_->setVisible(!any);
  const bool was_yesterday = shown.first + std::chrono::days(1) == plan.day;
  ink_title_->setText(!any || is_today ? tr("Today, in your hand")
                      : was_yesterday  ? tr("Yesterday, in your hand")
                                       : tr("%1, in your hand", "a day").arg(StudyWords::day(shown.first)));
  set_text(ink_figures_, any ? HomeWords::written(shown) : QString());
  all_ink_->setVisible(ink_->has_more());
  week_->setVisible(any);
  month_->setVisible(any);
  show_care(plan, *today);
}

void HomeView::show_care(const study::DayPlan& plan, const practice::WritingRecord& today) {
  const auto& store = learner_.store();
  std::vector<practice::HardCharacter> hard;
  for (const char32_t character : today.hard) {
    if (hard.size() >= kMostHard) break;
    const auto trouble = practice::stroke_trouble(store, character,
                                                  store.today() - std::chrono::days(practice::kHardDays - 1));
    hard.push_back({character, 1, trouble ? *trouble : std::nullopt});
  }
  const bool is_of_today = !hard.empty();
  if (!is_of_today)
    if (auto found = practice::hard_characters(store, kMostHard)) hard = *std::move(found);
  // Difficult characters are named below, with a lesson of their own.
  std::erase_if(hard, [&plan](const auto& one) {
    return std::find(plan.leeches.begin(), plan.leeches.end(), one.character) != plan.leeches.end();
  });
  hard_.clear();
  for (const auto& one : hard) hard_.push_back(one.character);
  const bool can_practise = learner_.can_write() && !session_.is_running();
  show_tiles(care_, hard_, false);
  const auto worst =
      std::find_if(hard.begin(), hard.end(), [](const auto& one) { return one.stroke.has_value(); });
  set_text(care_words_, worst != hard.end() ? TroubleWords::often(*worst)
                        : hard.empty()      ? QString()
                        : is_of_today       ? tr("Not right every time today.")
                                            : TroubleWords::often(hard.front()));
  practise_->setVisible(!hard.empty() && can_practise);
  practise_->setText(tr("Practise these, %1").arg(HomeWords::minutes(practice::practice_time(hard.size()))));
  const int leeches = static_cast<int>(plan.leeches.size());
  set_text(leeches_, leeches == 0 ? QString()
                                  : tr("%n characters were forgotten too often and taken out of reviews: %1",
                                       nullptr, leeches)
                                        .arg(HomeWords::in_a_row(plan.leeches)));
  relearn_->setVisible(leeches > 0 && can_practise);
  care_title_->setVisible(leeches > 0 || !hard.empty());
  care_card_->setVisible(leeches > 0 || !hard.empty());
}

void HomeView::refresh() {
  QWidget* keyboard = QApplication::focusWidget();
  if (keyboard != nullptr && !isAncestorOf(keyboard)) keyboard = nullptr;
  show_header();
  set_text(trouble_,
           LearnerWords::sentence(learner_.trouble() ? learner_.trouble() : learner_.backup_trouble()));
  again_->setVisible(!learner_.can_write());
  const auto plan = learner_.plan();
  if (!plan) {
    set_text(trouble_, to_text(base::to_line(plan.error())));
    return;
  }
  show_work(*plan);
  show_way();
  show_last_day(*plan);
  move_focus(keyboard);
}

void HomeView::move_focus(QWidget* keyboard) {
  QWidget* first = start_;
  if (!can_start_) {
    first = again_;
    // Enter is the key for the next step all through a session. After the last one it must not begin more by
    // accident, so the keyboard goes to the sentence that says the day is done, not to a button.
    if (learner_.can_write())
      first = more_->isHidden() && ahead_->isHidden() ? static_cast<QWidget*>(settings_) : advice_;
  }
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

void HomeView::show_all_ink(bool all) {
  ink_->show_all(all);
  all_ink_->setText(all ? tr("Show less") : tr("See all"));
}

void HomeView::fit() {
  const int em = QFontInfo(font()).pixelSize();
  const bool low = viewport()->height() < em * kLow_em;
  QFont large = font();
  large.setPointSizeF(QFontInfo(font()).pointSizeF() * (low ? 1.2 : 1.7));
  greeting_->setFont(large);
  const int room = std::min(viewport()->width() - 2 * kMargin, em * kWidest_em);
  const int beside = std::max(kMargin, (viewport()->width() - room) / 2);
  content_->layout()->setContentsMargins(beside, low ? kGap / 2 : kMargin, beside, kMargin);
  content_->layout()->setSpacing(low ? kGap / 2 : kGap * 4 / 3);
  const bool two = room >= em * kTwoColumns_em;
  header_->addWidget(greeting_, 0, 0);
  header_->addWidget(day_, two ? 0 : 1, two ? 1 : 0);
  day_->setAlignment(two ? Qt::AlignRight | Qt::AlignBottom : Qt::AlignLeft);
  grid_->addWidget(left_, 0, 0);
  grid_->addWidget(right_, two ? 0 : 1, two ? 1 : 0);
  grid_->setColumnStretch(0, 3);
  grid_->setColumnStretch(1, two ? 4 : 0);
  header_->setColumnStretch(0, 3);
  header_->setColumnStretch(1, two ? 4 : 0);
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
