// SPDX-License-Identifier: Apache-2.0
#include "study/question_view.h"

#include <QAction>
#include <QEvent>
#include <QFontInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTextDocument>
#include <algorithm>
#include <initializer_list>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/controls/spoken_line.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/study_words.h"
#include "study/session_text_size.h"

namespace nazori::ui {
namespace {

using practice::QuestionRoom;
using practice::SessionQuestion;

constexpr double kLarge = 1.8;   ///< size of the meaning, relative to other text
constexpr double kMiddle = 1.4;  ///< of readings and words
constexpr double kLeast = 0.85;  ///< of all of it, where a long question needs room
constexpr double kOneLine = 1.15;
constexpr double kLeastOfLine = 0.65;
constexpr double kStep = 0.9;

/// Spans of rich text in the sizes of a question.
class QuestionText {
 public:
  QuestionText(double text_pt, double share, QuestionRoom room)
      : text_pt_(text_pt), share_(share), is_one_line_(room == QuestionRoom::line) {}

  [[nodiscard]] QString of(const SessionQuestion& asks) const {
    QStringList first;
    QStringList second;
    if (asks.shown != 0) first.append(in_hand(to_text(asks.shown), kLarge));
    if (!asks.meanings.empty())
      first.append(plain(joined(asks.meanings, QStringLiteral(", ")), kLarge, current_colours().ink));
    if (asks.sound)
      first.append(plain(StudyWords::kana_asked(*asks.sound, asks.script), kLarge, current_colours().ink));
    if (!asks.readings.empty()) second.append(in_hand(joined(asks.readings, QStringLiteral("、")), kMiddle));
    if (asks.word) {
      const bool is_question = asks.prompt == practice::Prompt::word;
      (is_question ? first : second)
          .append(in_hand(to_text(asks.word->text), is_question ? kLarge : kMiddle));
      second.append(in_hand(to_text(asks.word->reading), kMiddle) + QStringLiteral(" &nbsp;") +
                    plain(joined(asks.word->meanings, QStringLiteral("; ")), 1, current_colours().muted));
    }
    if (first.isEmpty() && second.isEmpty())
      first.append(plain(QuestionView::spoken(asks), kMiddle, current_colours().ink));
    // Look-alikes stand beside the kana itself.
    for (const char32_t other : asks.lookalikes)
      second.append(QStringLiteral("%1 %2").arg(
          in_hand(to_text(other), kMiddle),
          plain(to_text(kanji::romaji_of(base::encode_utf8(other))), 1, current_colours().muted)));
    if (!asks.lookalikes.empty())
      second.prepend(plain(QuestionView::tr("looks like"), 1, current_colours().muted));
    const QString gap = QStringLiteral(" &nbsp; ");
    if (is_one_line_) return (first + second).join(gap);
    return second.isEmpty() ? first.join(gap) : first.join(gap) + QStringLiteral("<br>") + second.join(gap);
  }

 private:
  [[nodiscard]] QString span(const QString& text, double size, const QString& style) const {
    const double scale = is_one_line_ ? std::max(std::min(size, kOneLine) * share_, kLeastOfLine)
                                      : std::max(size * share_, kLeast);
    return QStringLiteral("<span style=\"font-size:%1pt; %2\">%3</span>")
        .arg(text_pt_ * scale)
        .arg(style, text.toHtmlEscaped());
  }
  [[nodiscard]] QString in_hand(const QString& text, double size) const {
    return span(text, size, QStringLiteral("font-family:'Klee One'"));
  }
  [[nodiscard]] QString plain(const QString& text, double size, const QColor& colour) const {
    return span(text, size, QStringLiteral("color:%1").arg(colour.name()));
  }

  double text_pt_;
  double share_;
  bool is_one_line_;
};

}  // namespace

QuestionView::QuestionView(const practice::StudySession& session, QAction* show, QWidget* parent)
    : QFrame(parent),
      session_(session),
      question_(named(new QLabel(this), "session_question")),
      answer_(new QWidget(this)),
      character_(named(new QLabel(answer_), "session_answer")),
      verdict_line_(with_role(named(new QLabel(answer_), "session_verdict"), "title")),
      reason_(text_label("session_reason", answer_, "muted")),
      show_(action_button(show, {}, answer_)),
      spoken_(new SpokenLine(this)) {
  setObjectName(QStringLiteral("question_view"));
  setAccessibleName(tr("Question"));
  question_->setWordWrap(true);
  reason_->setWordWrap(false);
  question_->setTextFormat(Qt::RichText);
  question_->setAlignment(Qt::AlignCenter);
  const auto name_button = [this, show] {
    show_->setText(QStringLiteral("▶ %1  %2")
                       .arg(show->iconText(), show->shortcut().toString(QKeySequence::NativeText)));
    show_->setVisible(show->isEnabled());
  };
  connect(show, &QAction::changed, show_, name_button);
  show_->setAccessibleName(show->iconText());
  name_button();
  auto* words = new QVBoxLayout;
  words->setSpacing(0);
  words->addStretch(1);
  words->addWidget(verdict_line_);
  words->addWidget(reason_);
  words->addStretch(1);
  auto* row = new QHBoxLayout(answer_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(16);
  row->addStretch(1);
  row->addWidget(character_);
  row->addLayout(words);
  row->addWidget(show_);
  row->addStretch(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 0, 16, 0);
  column->addWidget(question_, 1);
  column->addWidget(answer_, 1);
  // The height of the window decides how much of the question is shown, and this widget does not see that.
  parent->window()->installEventFilter(this);
  hide();
}

void QuestionView::show_state(const std::shared_ptr<const practice::CharacterSheet>& sheet,
                              const Verdict& verdict) {
  sheet_ = sheet;
  verdict_ = verdict;
  setVisible(session_.is_running());
  if (!session_.is_running()) said_.clear();
  refresh();
}

void QuestionView::refresh() {
  if (const auto now = session_room(*this); std::exchange(room_, now) != now) emit room_changed(now);
  if (isHidden()) return;
  const bool judged = session_.state() == practice::StudySession::State::judged && !session_.is_away();
  question_->setVisible(!judged);
  answer_->setVisible(judged);
  fit();
  if (judged)
    show_verdict();
  else
    show_question();
}

void QuestionView::show_question() {
  const bool ours = sheet_ && sheet_->character.code_point == session_.character();
  if (session_.is_away()) {
    question_->setText(tr("This is not the character you are being asked for.").toHtmlEscaped());
    question_->setAccessibleName(tr("This is not the character you are being asked for."));
    return;
  }
  if (!ours) {
    question_->clear();
    return;
  }
  const auto whole = practice::question_of(session_, *sheet_);
  const auto asks = practice::shortened(whole, room_);
  const double text_pt = QFontInfo(font()).pointSizeF();
  // A long question is written smaller until it fits.
  QTextDocument page;
  page.setDefaultFont(font());
  page.setDocumentMargin(0);
  page.setTextWidth(std::max(width() - 32, 100));
  QString text;
  for (double share = 1; share > 0.4; share *= kStep) {
    text = QuestionText(text_pt, share, room_).of(asks);
    page.setHtml(text);
    if (page.size().height() <= minimumHeight()) break;
  }
  question_->setText(text);
  question_->setAccessibleName(spoken(whole));
  say_question(whole);
}

QString QuestionView::spoken(const SessionQuestion& asks) {
  QStringList parts;
  if (asks.shown != 0) parts.append(to_text(asks.shown));
  if (asks.sound) parts.append(StudyWords::kana_asked(*asks.sound, asks.script));
  if (!asks.meanings.empty()) parts.append(joined(asks.meanings, QStringLiteral(", ")));
  if (!asks.readings.empty()) parts.append(joined(asks.readings, QStringLiteral("、")));
  if (asks.word) {
    const QString text = to_text(asks.word->text).replace(to_text(SessionQuestion::kGap), tr(" blank "));
    parts.append(QStringLiteral("%1, %2, %3")
                     .arg(text.simplified(), to_text(asks.word->reading),
                          joined(asks.word->meanings, QStringLiteral("; "))));
  }
  if (parts.isEmpty()) parts.append(tr("a character with %n strokes", nullptr, asks.strokes));
  return parts.join(QStringLiteral(". "));
}

void QuestionView::say_question(const SessionQuestion& asks) {
  if (asks.shown != 0) {
    said_.clear();
    return;
  }
  const QString question = spoken(asks);
  if (std::exchange(said_, question) != question) spoken_->speak(Urgency::queued, question);
}

void QuestionView::show_verdict() {
  said_.clear();
  const Colours& c = current_colours();
  const bool accepted = session_.result().accepted;
  verdict_line_->setText(
      QStringLiteral("<span style=\"color:%1\">%2</span> %3")
          .arg((accepted ? c.moss : c.vermilion).name(), accepted ? QStringLiteral("✓") : QStringLiteral("✗"),
               (room_ == QuestionRoom::line ? verdict_.brief : verdict_.words).toHtmlEscaped()));
  verdict_line_->setAccessibleName(verdict_.spoken);
  reason_->setText(tr("Suggested: %1 (%2)")
                       .arg(StudyWords::rating(session_.proposed()), StudyWords::reason(session_.reason())));
  character_->setText(to_text(session_.character()));
}

void QuestionView::fit() {
  const QFont own = session_font(room_);
  const double text_pt = own.pointSizeF();
  const int line = QFontMetrics(own).lineSpacing();
  const auto lines = [&] {
    switch (room_) {
      case QuestionRoom::full:
        return 4.0;
      case QuestionRoom::lines:
        return 2.8;
      case QuestionRoom::line:
        break;
    }
    return 1.5;
  };
  const bool is_low = room_ == QuestionRoom::line;
  setFixedHeight(static_cast<int>(lines() * line));
  const QFont answer = character_font(character_->text(), is_low ? text_pt : 2 * text_pt);
  if (character_->font() != answer) character_->setFont(answer);
  for (QWidget* one : std::initializer_list<QWidget*>{verdict_line_, show_})
    if (one->font().pointSizeF() != text_pt) one->setFont(own);
  // In a low window the suggested rating has its colour only.
  reason_->setVisible(!is_low);
}

bool QuestionView::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && watched == window()) refresh();
  return QFrame::eventFilter(watched, event);
}

void QuestionView::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::FontChange) refresh();
}

void QuestionView::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  refresh();
}

}  // namespace nazori::ui
