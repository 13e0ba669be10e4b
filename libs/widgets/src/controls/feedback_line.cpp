// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/feedback_line.h"

#include <QEvent>
#include <QFontInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QResizeEvent>
#include <algorithm>

#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/controls/spoken_line.h"
#include "nazori/widgets/look/icons.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/line_stretch.h"
#include "nazori/widgets/words/own_names.h"

namespace nazori::ui {
namespace {

constexpr int kRoomForTwo_em = 32;
constexpr int kMargin_px = 9;
constexpr double kCompact = 0.72;
constexpr double kLeast = 0.5;
constexpr double kStep = 0.94;

}  // namespace

FeedbackLine::FeedbackLine(QWidget* parent)
    : QFrame(parent),
      sign_(named(new QLabel(this), "feedback_sign")),
      text_(text_label("feedback_text", this)),
      spoken_(new SpokenLine(this)) {
  setObjectName(QStringLiteral("feedback_line"));
  setAccessibleName(tr("Feedback"));
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, kMargin_px, 16, kMargin_px);
  row->setSpacing(10);
  row->addWidget(sign_, 0, Qt::AlignVCenter);
  row->addWidget(text_, 1);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Minimum);
  draw_sign();
}

void FeedbackLine::announce(Feedback kind, const QString& sentence) {
  kind_ = kind;
  draw_sign();
  if (text_->text() == sentence) return;
  text_->setText(sentence);
  if (is_compact_) fit();
  speak(sentence);
}

void FeedbackLine::respond(Feedback kind, const QString& sentence) {
  if (text_->text() != sentence) return announce(kind, sentence);
  kind_ = kind;
  draw_sign();
  speak(sentence);
}

void FeedbackLine::speak(const QString& sentence) {
  const QString words = spoken_text(sentence);
  text_->setAccessibleName(words);
  setAccessibleDescription(words);
  if (!words.isEmpty()) ++times_spoken_;
  spoken_->speak(kind_ == Feedback::hint ? Urgency::queued : Urgency::at_once, words);
}

void FeedbackLine::speak_unseen(const QString& sentence) {
  ++times_spoken_;
  spoken_->speak(Urgency::queued, spoken_text(sentence));
}

QString FeedbackLine::sentence() const { return text_->text(); }

void FeedbackLine::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) draw_sign();
  if (event->type() == QEvent::FontChange) fit();
}

void FeedbackLine::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fit();
}

void FeedbackLine::set_compact(bool is_compact) {
  if (is_compact == is_compact_) return;
  is_compact_ = is_compact;
  fit();
}

double FeedbackLine::compact_pt() const {
  QFont own = font();
  const double least = own.pointSizeF() * kLeast;
  double size = own.pointSizeF() * kCompact / line_stretch(own);
  // A long sentence is written smaller until two lines hold it.
  const QRect room(0, 0, std::max(text_->width(), 1), QWIDGETSIZE_MAX);
  for (own.setPointSizeF(size); size > least; own.setPointSizeF(size *= kStep)) {
    const QFontMetrics metrics(own);
    const int all = metrics.boundingRect(room, Qt::TextWordWrap, text_->text()).height();
    const int one = metrics.boundingRect(room, Qt::TextSingleLine, text_->text()).height();
    if (all <= 2 * one) break;
  }
  return size;
}

void FeedbackLine::fit() {
  QFont own = font();
  if (is_compact_) own.setPointSizeF(compact_pt());
  if (text_->font() != own) text_->setFont(own);
  const int margin = is_compact_ ? kMargin_px / 3 : kMargin_px;
  layout()->setContentsMargins(16, margin, 16, margin);
  // Always reserves two lines, so that the tablet above does not move under the pen. In a low window with
  // large text that space is needed elsewhere.
  const bool roomy = window()->height() >= kRoomForTwo_em * QFontInfo(font()).pixelSize();
  const int height = (roomy ? 2 : 1) * text_->fontMetrics().lineSpacing();
  if (text_->minimumHeight() != height) text_->setMinimumHeight(height);
}

void FeedbackLine::draw_sign() {
  const Colours& c = current_colours();
  const int side = QFontInfo(font()).pixelSize() * 5 / 4;
  switch (kind_) {
    case Feedback::hint:
      sign_->setPixmap(sign(Icon::hint, c.muted, side, devicePixelRatioF()));
      break;
    case Feedback::good:
      sign_->setPixmap(sign(Icon::tick, c.moss, side, devicePixelRatioF()));
      break;
    case Feedback::advice:
      sign_->setPixmap(sign(Icon::advice, c.amber, side, devicePixelRatioF()));
      break;
    case Feedback::wrong:
      sign_->setPixmap(sign(Icon::cross, c.vermilion, side, devicePixelRatioF()));
      break;
  }
}

}  // namespace nazori::ui
