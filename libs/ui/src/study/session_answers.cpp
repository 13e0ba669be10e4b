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
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/study_words.h"
#include "study/session_text_size.h"

namespace nazori::ui {
namespace {

using practice::NextStep;

constexpr int kSides_px = 36;  ///< of a button, beside its words
constexpr int kRoomForFour_em = 30;
constexpr int kSide_px = 16;
constexpr int kMargin_px = 6;

int height_of(const QFontMetrics& metrics) { return metrics.lineSpacing() * 4 / 3 + 4; }

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
      help_actions_(help),
      next_(with_role(named(new QPushButton(task_), "session_next"), "primary")),
      ratings_(new QWidget(this)),
      grid_(new QGridLayout(ratings_)) {
  setObjectName(QStringLiteral("session_answers"));
  setAccessibleName(tr("Next step"));
  auto* row = new QHBoxLayout(task_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  for (auto* action : help) {
    auto* button = with_role(action_button(action, {}, task_), "compact");
    const auto follow = [button, action] { button->setEnabled(action->isEnabled()); };
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
    rating_[i]->setProperty("is_rating", true);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kSide_px, kMargin_px, kSide_px, kMargin_px);
  column->setSpacing(0);
  // The ratings take the space of the help, so that the tablet does not move under the pen.
  column->addWidget(task_);
  column->addWidget(ratings_);
  hide();
}

void SessionAnswers::show_state() {
  setVisible(session_.is_running());
  if (!session_.is_running()) return;
  const QFont own = session_font(session_room(*this));
  for (auto* one : findChildren<QPushButton*>())
    if (one->font() != own) one->setFont(own);
  const QFontMetrics metrics(own);
  const bool judged = session_.state() == practice::StudySession::State::judged && !session_.is_away();
  ratings_->setVisible(judged);
  task_->setVisible(!judged);
  if (judged)
    show_ratings(metrics);
  else
    show_next(metrics);
  // As high as the ratings, whatever is shown now.
  const int rows = width() < metrics.height() * kRoomForFour_em ? 2 : 1;
  const int least =
      std::max(rows * height_of(metrics) + (rows - 1) * grid_->spacing(), next_->sizeHint().height());
  const int border = height() - contentsRect().height();
  setMinimumHeight(least + 2 * kMargin_px + border);
}

void SessionAnswers::set_left_handed(bool left) {
  static_cast<QHBoxLayout*>(task_->layout())
      ->setDirection(left ? QBoxLayout::RightToLeft : QBoxLayout::LeftToRight);
}

void SessionAnswers::show_ratings(const QFontMetrics& metrics) {
  const auto now = learner_.store().now();
  const auto today = learner_.store().today();
  std::array<QString, 4> texts;
  std::array<QString, 4> short_texts;
  int widest = 0;
  int widest_short = 0;
  for (std::size_t i = 0; i < rating_.size(); ++i) {
    const auto rating = study::kRatings[i];
    const QString name = StudyWords::rating(rating);
    const bool proposed = rating == session_.proposed();
    // A day that cannot be computed is left out. Rating then says why it fails.
    const auto after = session_.after(rating);
    const QString when = after ? StudyWords::comes_again(*after, now, today) : QStringLiteral("–");
    const auto words = [&](const QString& time) {
      return QStringLiteral("%1  %2  %3%4")
          .arg(i + 1)
          .arg(name, time, proposed ? QStringLiteral("  ⏎") : QString());
    };
    texts[i] = words(when);
    short_texts[i] = words(after ? StudyWords::comes_again_short(*after, now, today) : when);
    widest = std::max(widest, metrics.horizontalAdvance(texts[i]) + kSides_px);
    widest_short = std::max(widest_short, metrics.horizontalAdvance(short_texts[i]) + kSides_px);
    rating_[i]->setAccessibleName(proposed ? tr("%1: %2, suggested").arg(name, when)
                                           : tr("%1: %2").arg(name, when));
    rating_[i]->setProperty("role", proposed ? QStringLiteral("primary") : QStringLiteral("rating"));
    rating_[i]->setStyle(rating_[i]->style());
  }
  // Four in a row if they fit, in full or short, otherwise two rows of two.
  const int room = width() - 2 * kSide_px - 3 * grid_->spacing();
  const bool are_short = 4 * widest > room;
  const int columns = are_short && 4 * widest_short > room ? 2 : 4;
  for (std::size_t i = 0; i < rating_.size(); ++i) {
    // Another role has brought the size of other buttons with it.
    rating_[i]->setFont(session_font(session_room(*this)));
    rating_[i]->setText(are_short ? short_texts[i] : texts[i]);
    rating_[i]->setFixedHeight(height_of(metrics));
    grid_->addWidget(rating_[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
  }
}

void SessionAnswers::show_next(const QFontMetrics& metrics) {
  const auto next = practice::next_step(session_, actions_.has_unjudged());
  const bool from_memory = session_.asks_from_memory() && !session_.is_away();
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
  // Keys are left to the tool tips where they do not fit.
  int needed = next_->sizeHint().width();
  for (const auto* action : help_actions_) needed += metrics.horizontalAdvance(with_key(*action)) + kSides_px;
  const bool has_room = needed <= width() - 2 * kSide_px;
  for (qsizetype i = 0; i < help_.size(); ++i) {
    help_[i]->setVisible(from_memory);
    help_[i]->setText(has_room ? with_key(*help_actions_[i]) : help_actions_[i]->iconText());
  }
}

void SessionAnswers::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::FontChange && !isHidden()) show_state();
}

void SessionAnswers::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  if (event->oldSize().width() != event->size().width() && !isHidden()) show_state();
}

}  // namespace nazori::ui
