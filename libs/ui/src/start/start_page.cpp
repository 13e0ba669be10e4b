// SPDX-License-Identifier: Apache-2.0
#include "start/start_page.h"

#include <QTimer>
#include <algorithm>
#include <chrono>
#include <utility>

#include "nazori/widgets/controls/input_pause.h"
#include "nazori/widgets/controls/input_watch.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/device_text.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/learner_words.h"
#include "start/start_view.h"
#include "start/start_words.h"

namespace nazori::ui {
namespace {

/// The result of the test appears under the hand that has just answered the last question.
constexpr std::chrono::milliseconds kPause{800};

}  // namespace

StartActions::StartActions(QWidget* window) : ActionSet(window) {
  write = make("start_go_on", tr("&Write"), tr("Save these answers and write the first character"),
               "Ctrl+Return", Icon::play);
  skip = make("start_skip_all", tr("S&kip"), tr("Leave everything as it is"), "Esc");
  add_group(tr("St&udy"), {write, skip});
}

StartPage::StartPage(WindowParts& parts)
    : Page(parts, {QStringLiteral("start"),
                   tr("Change &what I learn"),
                   tr("What you want to write, what you know already, and how long a day"),
                   Icon::home,
                   {}}),
      actions_(new StartActions(&parts.window())),
      view_(new StartView(&parts.window())),
      pause_(new InputPause(view_)) {
  on(actions_->write, [this] { go_on(); });
  on(actions_->skip, [this] { skip(); });
  connect(view_, &StartView::write_wanted, actions_->write, &QAction::trigger);
  connect(view_, &StartView::skip_wanted, actions_->skip, &QAction::trigger);
  connect(view_, &StartView::changed, this, [this] { show_plan(); });
  connect(&InputWatch::of_program(), &InputWatch::changed, this, [this] { show_input(); });
  subscribe(parts.tablet().device().changed, this, [this] { show_input(); });
  subscribe(parts.learner().changed, this, [this] {
    if (entered_) show_plan();
  });
  subscribe(parts.learner().profile_changed, this, [this] {
    is_open_ = false;
    if (comes_first()) {
      emit wants_to_be_entered();
    } else if (entered_) {
      this->parts().go_to(QStringLiteral("home"));
    }
  });
  subscribe(parts.placement().ended, this, [this](const practice::PlacementResult& result) {
    view_->show_result(result);
    emit wants_to_be_entered();
    pause_->begin(kPause);
    this->parts().announce(Feedback::good, StartWords::found(result, view_->answers().goal));
  });
}

StartPage::~StartPage() = default;

QWidget* StartPage::instead_of_tablet() const { return view_; }

bool StartPage::comes_first() const {
  const auto& learner = parts().learner();
  const auto& preferences = parts().preferences();
  return preferences.begin_at_home && learner.can_write() && practice::is_new(learner.store()) &&
         !preferences.skipped_start.contains(to_text(learner.profile()));
}

void StartPage::begin_again() {
  const auto& store = parts().learner().store();
  is_first_ = practice::is_new(store);
  before_ = {};
  if (is_first_) {
    practice::LearningAnswers usual;
    usual.goal = practice::LearningGoal::hiragana;
    usual.minutes = 10;
    view_->show_answers(usual, true);
  } else {
    before_ = practice::answers_of(store.settings());
    view_->show_answers(before_, false);
  }
  is_open_ = true;
}

void StartPage::enter() {
  entered_ = true;
  if (!is_open_) begin_again();
  show_input();
  show_plan();
  parts().announce(Feedback::hint, tr("Enter: start. Tab and the arrow keys: other answers."));
  QTimer::singleShot(0, &parts(), &WindowParts::note_opened);
}

void StartPage::leave() { entered_ = false; }

practice::LearningAnswers StartPage::changed_answers() const {
  practice::LearningAnswers answers = view_->answers();
  if (is_first_) return answers;
  const bool has_text =
      answers.goal == practice::LearningGoal::own_list &&
      std::any_of(answers.own_text.begin(), answers.own_text.end(), [](char one) { return one != ' '; });
  if (answers.goal == before_.goal && !has_text) answers.goal.reset();
  if (answers.minutes == before_.minutes) answers.minutes.reset();
  return answers;
}

void StartPage::show_plan() {
  auto& learner = parts().learner();
  const auto answers = view_->answers();
  std::vector<char32_t> own;
  if (answers.goal == practice::LearningGoal::own_list)
    own = practice::characters_in(answers.own_text, [&learner](char32_t one) {
      return learner.lists() != nullptr && learner.lists()->facts(one) != nullptr;
    });
  const bool lists_known = answers.known->kind == practice::KnownAlready::Kind::listed;
  view_->show_known({}, 0);
  const auto changed = changed_answers();
  const auto plan = practice::plan_learning(learner, changed);
  QString trouble = LearnerWords::sentence(learner.trouble());
  char32_t first = 0;
  if (changed.goal == practice::LearningGoal::own_list && own.empty()) {
    if (trouble.isEmpty()) trouble = tr("Type or paste the characters that you want to write.");
  } else if (plan) {
    first = plan->first;
    if (lists_known) {
      std::vector<char32_t> known;
      for (const auto& one : plan->choices.known) known.push_back(one.character);
      // Planned from the hardest to the easiest.
      std::reverse(known.begin(), known.end());
      const auto all = practice::kanji_and_kana_in(answers.known_text, [&learner](char32_t one) {
        return learner.lists() != nullptr && learner.lists()->facts(one) != nullptr;
      });
      view_->show_known(known, static_cast<int>(all.size() - known.size()));
    }
  } else if (lists_known && plan.error().code == base::Errc::bad_argument) {
    trouble = tr("Type or paste the characters that you know.");
  } else if (trouble.isEmpty()) {
    trouble = reason(plan.error());
  }
  view_->show_plan(first, trouble, own);
}

void StartPage::show_input() {
  const auto& device = parts().tablet().device();
  view_->show_input(InputWatch::of_program().sentence(
      device.is_pointer() ? QString() : device_name(device.describe().name)));
}

void StartPage::go_on() {
  if (view_->wants_check()) {
    start_check();
  } else {
    write();
  }
}

void StartPage::start_check() {
  auto& learner = parts().learner();
  auto characters = practice::characters_to_check(learner, view_->answers());
  if (!characters) return learner.announce_unread(characters.error());
  if (parts().placement().start(*std::move(characters))) {
    parts().go_to(QStringLiteral("check"));
  } else {
    parts().announce(Feedback::advice, tr("There are no characters to test."));
  }
}

void StartPage::write() {
  auto& learner = parts().learner();
  const auto plan = practice::plan_learning(learner, changed_answers());
  if (!plan) return learner.announce_unread(plan.error());
  // Why it was not saved is announced, and the page stays with the answers.
  if (!practice::take_plan(learner, *plan)) return;
  is_open_ = false;
  auto& session = parts().session();
  if (session.is_running()) session.end();
  if (plan->first == 0) {
    parts().go_to(QStringLiteral("home"));
    if (const auto known = plan->choices.known.size(); known > 0)
      parts().announce(Feedback::good, tr("%Ln characters marked as known. Ctrl+Shift+Z: undo.", nullptr,
                                          static_cast<int>(known)));
    return;
  }
  const auto today = learner.plan();
  const bool is_next = today && !today->now.empty() && today->now.front().character == plan->first;
  if (!(is_next ? session.start() : session.start_with({plan->first}))) parts().go_to(QStringLiteral("home"));
}

void StartPage::skip() {
  is_open_ = false;
  auto& skipped = parts().preferences().skipped_start;
  const QString profile = to_text(parts().learner().profile());
  if (is_first_ && !skipped.contains(profile)) {
    skipped.append(profile);
    parts().save_later();
  }
  parts().go_to(QStringLiteral("home"));
}

}  // namespace nazori::ui
