// SPDX-License-Identifier: Apache-2.0
#include "study/session_answers.h"

#include <QEvent>
#include <QFontMetrics>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QResizeEvent>
#include <algorithm>

#include "nazori/practice/session_steps.h"
#include "study/session_text_size.h"
#include "widgets/parts.h"
#include "words/study_words.h"

namespace nazori::ui {
namespace {

using practice::NextStep;

constexpr int kSides_px = 36;  ///< of a button, beside its words
constexpr int kRoomForFour_em = 30;

/// "Hint  H".
QString with_key(const QAction& action) {
  const auto keys = action.shortcut().toString(QKeySequence::NativeText);
  const QString name = action.iconText();
  return keys.isEmpty() ? name : QStringLiteral("%1  %2").arg(name, keys);
}

}  // namespace

SessionAnswers::SessionAnswers(const practice::StudySession& session, const SessionActions& actions,
                               const practice::Learner& learner, const QList<QAction*>& help, QWidget* parent)
    : QFrame(parent),
      session_(session),
      actions_(actions),
      learner_(learner),
      task_(new QWidget(this)),
      next_(with_role(named(new QPushButton(task_), "session_next"), "primary")),
      ratings_(new QWidget(this)),
      grid_(new QGridLayout(ratings_)) {
  setObjectName(QStringLiteral("session_answers"));
  setAccessibleName(tr("Next step"));
  auto* row = new QHBoxLayout(task_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  for (auto* action : help) {
    auto* button = with_role(action_button(action, with_key(*action), task_), "compact");
    const auto follow = [button, action] {
      button->setText(with_key(*action));
      button->setEnabled(action->isEnabled());
    };
    connect(action, &QAction::changed, button, follow);
    follow();
    button->setAccessibleName(action->iconText());
    row->addWidget(button);
    help_.append(button);
  }
  row->addStretch(1);
  row->addWidget(next_);
  connect(next_, &QPushButton::clicked, this, [this] {
    const bool finishes = practice::next_step(session_, actions_.has_unjudged()) == NextStep::finish_writing;
    (finishes ? actions_.done() : actions_.go_on)->trigger();
  });
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(6);
  for (std::size_t i = 0; i < rating_.size(); ++i) {
    rating_[i] = action_button(actions.rate[i], {}, ratings_);
    rating_[i]->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 6, 16, 6);
  column->setSpacing(0);
  // The ratings take the space of the help, so that the tablet does not move under the pen.
  column->addWidget(task_);
  column->addWidget(ratings_);
  hide();
}

void SessionAnswers::show_state() {
  setVisible(session_.is_running());
  if (!session_.is_running()) return;
  show_ratings();
  show_next();
  fit();
}

QString SessionAnswers::words(std::size_t at, bool are_short) const {
  const auto rating = study::kRatings[at];
  const auto after = session_.after(rating);
  const auto now = learner_.store().now();
  const auto today = learner_.store().today();
  // A day that cannot be computed is left out. Rating then says why it fails.
  QString when = QStringLiteral("–");
  if (after)
    when = are_short ? StudyWords::comes_again_short(*after, now, today)
                     : StudyWords::comes_again(*after, now, today);
  const QString sign = rating == session_.proposed() ? QStringLiteral("  ⏎") : QString();
  return QStringLiteral("%1  %2  %3%4").arg(at + 1).arg(StudyWords::rating(rating), when, sign);
}

void SessionAnswers::show_ratings() {
  const bool judged = session_.state() == practice::StudySession::State::judged && !session_.is_away();
  ratings_->setVisible(judged);
  task_->setVisible(!judged);
  if (!judged) return;
  for (std::size_t i = 0; i < rating_.size(); ++i) {
    const auto rating = study::kRatings[i];
    const auto after = session_.after(rating);
    const QString when =
        after ? StudyWords::comes_again(*after, learner_.store().now(), learner_.store().today())
              : QStringLiteral("–");
    const bool proposed = rating == session_.proposed();
    rating_[i]->setAccessibleName(proposed ? tr("%1: %2, suggested").arg(StudyWords::rating(rating), when)
                                           : tr("%1: %2").arg(StudyWords::rating(rating), when));
    rating_[i]->setProperty("role", proposed ? QStringLiteral("primary") : QStringLiteral("rating"));
    rating_[i]->setStyle(rating_[i]->style());
  }
}

void SessionAnswers::show_next() {
  const auto next = practice::next_step(session_, actions_.has_unjudged());
  const bool from_memory = session_.asks_from_memory() && !session_.is_away();
  for (auto* one : help_) one->setVisible(from_memory);
  next_->setVisible(next != NextStep::none);
  switch (next) {
    case NextStep::finish_writing:
      next_->setText(tr("Finish  ⏎"));
      break;
    case NextStep::go_back:
      next_->setText(tr("Back to the session  ⏎"));
      break;
    case NextStep::next_character:
      next_->setText(tr("Next character  ⏎"));
      break;
    case NextStep::stage:
      next_->setText(tr("%1  ⏎").arg(StudyWords::stage(session_.stage())));
      break;
    case NextStep::none:
    case NextStep::rate:
      break;
  }
}

void SessionAnswers::fit() {
  const QFont own = session_font(session_room(*this));
  for (auto* one : findChildren<QPushButton*>())
    if (one->font() != own) one->setFont(own);
  const QFontMetrics metrics(own);
  const int line = metrics.lineSpacing();
  // Four in a row if they fit, in full or short, otherwise two rows of two.
  const auto widest = [&](bool are_short) {
    int most = 0;
    for (std::size_t i = 0; i < rating_.size(); ++i)
      most = std::max(most, metrics.horizontalAdvance(words(i, are_short)) + kSides_px);
    return most;
  };
  const int room = width() - 32 - 3 * grid_->spacing();
  const bool judged = !ratings_->isHidden();
  const bool are_short = judged && 4 * widest(false) > room;
  const int columns = are_short && 4 * widest(true) > room ? 2 : 4;
  for (std::size_t i = 0; i < rating_.size(); ++i) {
    if (judged) rating_[i]->setText(words(i, are_short));
    grid_->addWidget(rating_[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
    rating_[i]->setFixedHeight(line + (columns == 4 ? line / 2 : line / 3));
  }
  // As high as what follows, whatever is shown now.
  const int one = line + line / 2;
  const int two = 2 * (line + line / 3) + grid_->spacing();
  setMinimumHeight((width() < metrics.height() * kRoomForFour_em ? two : one) + 12);
}

void SessionAnswers::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::FontChange && session_.is_running()) fit();
}

void SessionAnswers::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  if (session_.is_running() && event->oldSize().width() != event->size().width()) fit();
}

}  // namespace nazori::ui
