// SPDX-License-Identifier: Apache-2.0
#include "study/session_bar.h"

#include <QEvent>
#include <QFontInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QResizeEvent>
#include <QVBoxLayout>
#include <utility>

#include "look/palette.h"
#include "nazori/base/utf8.h"
#include "nazori/kanji/kana_sound.h"
#include "nazori/practice/session_question.h"
#include "widgets/parts.h"
#include "words/kanji_text.h"
#include "words/study_words.h"

namespace nazori::ui {
namespace {

constexpr int kWide_em = 36;
constexpr double kLarge = 1.25;  ///< size of the question, relative to other text

}  // namespace

SessionBar::SessionBar(const practice::StudySession& session, const SessionActions& actions,
                       const practice::Learner& learner, QWidget* parent)
    : QFrame(parent),
      session_(session),
      actions_(actions),
      learner_(learner),
      progress_(with_role(named(new QLabel(this), "session_progress"), "muted")),
      line_(named(new QProgressBar(this), "session_line", tr("Session progress"))),
      question_(named(new QLabel(this), "session_question")),
      next_(with_role(named(new QPushButton(this), "session_next"), "primary")),
      ratings_(new QWidget(this)),
      grid_(new QGridLayout(ratings_)) {
  setObjectName(QStringLiteral("session_bar"));
  setAccessibleName(tr("Study session"));
  line_->setTextVisible(false);
  question_->setWordWrap(true);
  question_->setTextFormat(Qt::RichText);
  connect(next_, &QPushButton::clicked, actions.go_on, &QAction::trigger);

  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(6);
  for (std::size_t i = 0; i < rating_.size(); ++i) {
    rating_[i] = action_button(actions.rate[i], {}, ratings_);
    rating_[i]->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }
  auto* head = new QHBoxLayout;
  head->setSpacing(12);
  head->addWidget(progress_);
  head->addWidget(line_, 1);
  task_ = new QWidget(this);
  auto* middle = new QHBoxLayout(task_);
  middle->setContentsMargins(0, 0, 0, 0);
  middle->setSpacing(12);
  middle->addWidget(question_, 1);
  middle->addWidget(next_, 0, Qt::AlignVCenter);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 8, 16, 8);
  column->setSpacing(6);
  column->addLayout(head);
  // The ratings take the space of the question, so that the tablet does not move under the pen.
  column->addWidget(task_);
  column->addWidget(ratings_);
  fit();
}

QString SessionBar::question(const practice::CharacterSheet& sheet) const {
  const auto asks = practice::question_of(session_, sheet);
  const double large = QFontInfo(font()).pointSizeF() * kLarge;
  const QString muted = current_colours().muted.name();
  const auto in_hand = [&](const QString& text) {
    return QStringLiteral("<span style=\"font-family:'Klee One'; font-size:%1pt\">%2</span>")
        .arg(large)
        .arg(text.toHtmlEscaped());
  };
  if (!asks.gap.empty())
    return QStringLiteral("%1 &nbsp;<span style=\"color:%2\">%3</span> &nbsp;%4")
        .arg(in_hand(to_text(asks.gap)), muted, to_text(asks.reading).toHtmlEscaped(),
             joined(asks.meanings, QStringLiteral("; ")).toHtmlEscaped());
  QString asked;
  if (asks.shown != 0) asked = in_hand(to_text(asks.shown)) + QStringLiteral(" &nbsp;");
  if (!asks.meanings.empty())
    asked +=
        QStringLiteral("<b>%1</b> &nbsp;").arg(joined(asks.meanings, QStringLiteral(", ")).toHtmlEscaped());
  if (!asks.readings.empty()) asked += in_hand(joined(asks.readings, QStringLiteral("、")));
  if (asks.sound)
    asked += StudyWords::kana_asked(*asks.sound, asks.script).toHtmlEscaped();
  else if (asks.meanings.empty() && asks.readings.empty())
    asked += tr("a character with %n strokes", nullptr, asks.strokes);
  // Look-alikes stand beside the kana itself, as large as it is.
  QStringList others;
  for (const char32_t other : asks.lookalikes)
    others.append(QStringLiteral("%1 %2").arg(in_hand(to_text(other)),
                                              to_text(kanji::romaji_of(base::encode_utf8(other)))));
  if (!others.isEmpty())
    asked += QStringLiteral(" &nbsp;<span style=\"color:%1\">%2</span>")
                 .arg(muted, tr("looks like %1").arg(others.join(QStringLiteral(", "))));
  return asked;
}

void SessionBar::show_state(const std::shared_ptr<const practice::CharacterSheet>& sheet) {
  sheet_ = sheet;
  setVisible(session_.is_running());
  if (!session_.is_running()) return;
  const int at = std::min(session_.done() + 1, session_.total());
  progress_->setText(
      tr("%1 of %2 · %3 left").arg(at).arg(session_.total()).arg(StudyWords::about(session_.time_left())));
  line_->setRange(0, std::max(session_.total(), 1));
  line_->setValue(session_.done());
  const bool ours = sheet && sheet->character.code_point == session_.character();
  if (session_.is_away())
    question_->setText(tr("This is not the character you are being asked for.").toHtmlEscaped());
  else
    question_->setText(ours ? question(*sheet) : QString());
  show_ratings();
  show_next();
}

void SessionBar::refresh() {
  fit();
  if (isVisibleTo(parentWidget())) show_state(std::shared_ptr<const practice::CharacterSheet>(sheet_));
}

void SessionBar::show_ratings() {
  const bool judged = session_.state() == practice::StudySession::State::judged && !session_.is_away();
  ratings_->setVisible(judged);
  task_->setVisible(!judged);
  if (!judged) return;
  progress_->setText(
      tr("Suggested: %1 (%2)")
          .arg(StudyWords::rating(session_.proposed()), StudyWords::reason(session_.reason())));
  const auto now = learner_.store().now();
  const auto today = learner_.store().today();
  for (std::size_t i = 0; i < rating_.size(); ++i) {
    const auto rating = study::kRatings[i];
    const auto after = session_.after(rating);
    // A day that cannot be computed is left out. Rating then says why it fails.
    const QString when = after ? StudyWords::comes_again(*after, now, today) : QStringLiteral("–");
    const QString short_when =
        after ? StudyWords::comes_again_short(*after, now, today) : QStringLiteral("–");
    const bool proposed = rating == session_.proposed();
    const QString sign = proposed ? QStringLiteral(" ⏎") : QString();
    rating_[i]->setText(
        narrow_ ? QStringLiteral("%1 %2%3 · %4").arg(i + 1).arg(StudyWords::rating(rating), sign, short_when)
                : QStringLiteral("%1  %2 %3\n%4").arg(i + 1).arg(StudyWords::rating(rating), sign, when));
    rating_[i]->setAccessibleName(proposed ? tr("%1: %2, suggested").arg(StudyWords::rating(rating), when)
                                           : tr("%1: %2").arg(StudyWords::rating(rating), when));
    rating_[i]->setProperty("role", proposed ? QStringLiteral("primary") : QStringLiteral("rating"));
    rating_[i]->setStyle(rating_[i]->style());
  }
}

void SessionBar::show_next() {
  const bool offered = session_.state() == practice::StudySession::State::offered;
  next_->setVisible(session_.is_away() || offered);
  if (session_.is_away())
    next_->setText(tr("Back to the session  ⏎"));
  else if (offered && session_.is_over())
    next_->setText(tr("Next character  ⏎"));
  else
    next_->setText(tr("%1  ⏎").arg(StudyWords::stage(session_.stage())));
}

void SessionBar::fit() {
  // Four in a row with two lines each if they fit, otherwise two rows of two with one line each.
  const int em = QFontInfo(font()).pixelSize();
  const bool narrow = width() < em * kWide_em;
  const int columns = narrow ? 2 : 4;
  for (std::size_t i = 0; i < rating_.size(); ++i)
    grid_->addWidget(rating_[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
  line_->setFixedHeight(std::max(6, em / 3));
  const int line = QFontMetrics(font()).lineSpacing();
  const int button = narrow ? line + em / 2 : 2 * line + em;
  for (auto* one : rating_) one->setFixedHeight(button);
  // Both are as high as a question of two lines, so that the tablet does not move.
  const int question = 2 * QFontMetrics(textbook_font(QFontInfo(font()).pointSizeF() * kLarge)).lineSpacing();
  const int height = std::max(question, narrow ? 2 * button + grid_->spacing() : button);
  for (auto* one : {task_, ratings_}) one->setMinimumHeight(height);
  if (std::exchange(narrow_, narrow) != narrow) show_ratings();
}

void SessionBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

void SessionBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  if (event->oldSize().width() != event->size().width()) fit();
}

}  // namespace nazori::ui
