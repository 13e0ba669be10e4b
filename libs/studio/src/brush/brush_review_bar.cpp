// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/brush/brush_review_bar.h"

#include <QAction>
#include <QFontInfo>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QStyle>
#include <QVBoxLayout>
#include <initializer_list>
#include <utility>

#include "nazori/studio/brush/brush_actions.h"
#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/controls/spoken_line.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/study_words.h"

namespace nazori::ui {
namespace {

constexpr int kGap_px = 6;
constexpr int kSide_px = 16;
constexpr double kLarger = 1.4;  ///< size of the question, relative to other text
/// Below this height of the window, in sizes of its text, the keys of lesser buttons are in their tool tips
/// only.
constexpr double kRoomForKeys_em = 42;

/// "Skip  Ctrl+Shift+P".
QString with_key(const QAction& action) {
  return QStringLiteral("%1  %2").arg(action.iconText(),
                                      action.shortcut().toString(QKeySequence::NativeText));
}

QPushButton* compact_button(QAction* action, QWidget* parent) {
  auto* button = with_role(action_button(action, with_key(*action), parent), "compact");
  button->setAccessibleName(action->iconText());
  return button;
}

}  // namespace

BrushReviewBar::BrushReviewBar(const practice::BrushSession& session, const practice::Learner& learner,
                               const BrushActions& actions, QWidget* parent)
    : QFrame(parent),
      session_(session),
      learner_(learner),
      words_(new QStackedWidget(this)),
      question_(sentence_label("brush_review_question", words_)),
      verdict_(text_label("brush_review_verdict", words_, "muted")),
      steps_(new QStackedWidget(this)),
      advice_(with_role(action_button(actions.go_on, {}, this), "primary")),
      ratings_(new QWidget(steps_)),
      progress_(text_label("brush_review_progress", this, "muted")),
      spoken_(new SpokenLine(this)) {
  setObjectName(QStringLiteral("brush_review_bar"));
  setAccessibleName(tr("Review with the brush"));
  QFont large = question_->font();
  large.setPointSizeF(QFontInfo(large).pointSizeF() * kLarger);
  question_->setFont(large);
  advice_->setText(tr("Advice  ⏎"));
  advice_->setAccessibleName(tr("Advice"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kSide_px, kGap_px, kSide_px, kGap_px);
  column->setSpacing(kGap_px);
  // A stack has room for its largest page, so the paper below does not move under the brush.
  words_->addWidget(question_);
  words_->addWidget(verdict_);
  column->addWidget(words_);
  QSizePolicy kept = advice_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  advice_->setSizePolicy(kept);
  auto* step = new QWidget(steps_);
  (new FlowLayout(kGap_px, kGap_px, step))->addWidget(advice_);
  steps_->addWidget(step);
  steps_->addWidget(ratings_);
  ratings_->setLayout(new FlowLayout(kGap_px, kGap_px, nullptr));
  for (std::size_t i = 0; i < rating_.size(); ++i) {
    rating_[i] = action_button(actions.rate[i], {}, ratings_);
    rating_[i]->setProperty("is_rating", true);
    ratings_->layout()->addWidget(rating_[i]);
  }
  column->addWidget(steps_);
  auto* others = new QWidget(this);
  auto* row = new FlowLayout(kGap_px, kGap_px, others);
  for (auto* action : {actions.skip, actions.undo_rating, actions.end})
    row->addWidget(others_.emplace_back(compact_button(action, others), action).first);
  progress_->setWordWrap(false);
  row->addWidget(progress_);
  column->addWidget(others);
  hide();
}

QString BrushReviewBar::question_words(const kanji::Character& character, bool is_secret,
                                       practice::QuestionRoom room) {
  const auto asks = practice::shortened(practice::question_about(character), room);
  QStringList parts;
  if (!is_secret) parts.append(to_text(character.code_point));
  if (asks.sound) parts.append(StudyWords::kana_asked(*asks.sound, asks.script));
  if (!asks.meanings.empty()) parts.append(joined(asks.meanings, QStringLiteral(", ")));
  if (!asks.readings.empty()) parts.append(joined(asks.readings, QStringLiteral("、")));
  if (parts.isEmpty()) parts.append(tr("a character with %n strokes", nullptr, asks.strokes));
  return parts.join(QStringLiteral(" · "));
}

void BrushReviewBar::show_state(const std::optional<kanji::Character>& character) {
  setVisible(session_.is_running());
  if (!session_.is_running()) {
    said_.clear();
    return;
  }
  const QString place = tr("With the brush · %1 of %2").arg(session_.done() + 1).arg(session_.total());
  progress_->setText(place);
  const double height_em = static_cast<double>(window()->height()) / QFontInfo(font()).pixelSize();
  const QString question = character ? question_words(*character, session_.asks_from_memory(),
                                                      practice::room_for_question(height_em))
                                     : QString();
  question_->setText(question);
  const bool advised = session_.state() == practice::BrushSession::State::advised;
  for (const auto& [button, action] : others_)
    button->setText(height_em < kRoomForKeys_em ? action->iconText() : with_key(*action));
  words_->setCurrentIndex(advised ? 1 : 0);
  steps_->setCurrentIndex(advised ? 1 : 0);
  advice_->setVisible(!advised);
  show_ratings();
  if (question.isEmpty()) return;
  QString words = place + QStringLiteral(". ") + question;
  if (advised) words = verdict_->text();
  if (std::exchange(said_, words) != words) spoken_->speak(Urgency::queued, words);
}

void BrushReviewBar::show_ratings() {
  const bool advised = session_.state() == practice::BrushSession::State::advised;
  const auto today = learner_.store().today();
  for (std::size_t i = 0; i < rating_.size(); ++i) {
    const auto rating = study::kRatings[i];
    const bool proposed = advised && rating == session_.proposed();
    const QString name = StudyWords::rating(rating);
    // A day that cannot be computed is left out. Rating then says why it fails.
    const auto after = session_.after(rating);
    const QString when =
        after ? StudyWords::comes_again(study::review_delay(after->brush, today)) : QStringLiteral("–");
    rating_[i]->setText(QStringLiteral("%1  %2  %3%4")
                            .arg((i + 7) % 10)
                            .arg(name, when, proposed ? QStringLiteral("  ⏎") : QString()));
    rating_[i]->setAccessibleName(proposed ? tr("%1: %2, suggested").arg(name, when)
                                           : tr("%1: %2").arg(name, when));
    rating_[i]->setProperty("role", proposed ? QStringLiteral("primary") : QStringLiteral("rating"));
    rating_[i]->setStyle(rating_[i]->style());
  }
  // Before, the longer sentence keeps the place.
  verdict_->setText(advised && session_.result().accepted
                        ? tr("The advice is not a mark: you rate your writing. Suggested: %1.")
                              .arg(StudyWords::rating(session_.proposed()))
                        : tr("Not all strokes are those of the character. The advice is not a mark: you rate "
                             "your writing. Suggested: %1.")
                              .arg(StudyWords::rating(session_.proposed())));
}

}  // namespace nazori::ui
