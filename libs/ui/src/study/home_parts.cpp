// SPDX-License-Identifier: Apache-2.0
#include "study/home_parts.h"

#include <QEvent>
#include <QFontInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QRegularExpression>
#include <algorithm>
#include <utility>

#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/look/ink_painting.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"
#include "study/home_words.h"

namespace nazori::ui {
namespace {

constexpr double kCorner = 10;
constexpr int kMostPadding = 20;  ///< of the start button: large text needs the room for itself
constexpr double kTile_pt = 48;
constexpr double kInkSide_em = 4.2;
constexpr double kInkPen = 0.045;

int em_of(const QWidget* widget) { return QFontInfo(widget->font()).pixelSize(); }

QFont larger(const QFont& font, double share) {
  QFont made = font;
  made.setPointSizeF(QFontInfo(font).pointSizeF() * share);
  return made;
}

}  // namespace

StartButton::StartButton(QWidget* parent) : QPushButton(parent) {
  setAutoDefault(true);  // Enter presses it
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void StartButton::show_work(const QString& word, const QString& details) {
  if (text() == word && details_ == details) return;
  details_ = details;
  setText(word);
  setAccessibleName(details.isEmpty() ? word : tr("%1: %2", "start, what").arg(word, details));
  updateGeometry();
  update();
}

int StartButton::padding() const { return std::min(em_of(this) * 5 / 4, kMostPadding); }

int StartButton::heightForWidth(int width) const {
  const int room = std::max(1, width - 2 * padding());
  const int word = QFontMetrics(larger(font(), 1.4)).lineSpacing();
  const int details =
      details_.isEmpty()
          ? 0
          : fontMetrics().boundingRect(0, 0, room, 10'000, Qt::TextWordWrap, details_).height();
  return word + details + 2 * padding();
}

QSize StartButton::sizeHint() const {
  const int width = em_of(this) * 12;
  return {width, heightForWidth(std::max(width, this->width()))};
}

void StartButton::paintEvent(QPaintEvent* /*event*/) {
  const Colours& c = current_colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool stands_out = isDown() || underMouse();
  painter.setBrush(stands_out ? blend(c.indigo, c.ink, isDown() ? 0.25 : 0.12) : c.indigo);
  painter.setPen(Qt::NoPen);
  painter.drawRoundedRect(QRectF(rect()), kCorner, kCorner);
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(c.surface, 2));
    painter.drawRoundedRect(QRectF(rect()).adjusted(4, 4, -4, -4), kCorner - 3, kCorner - 3);
  }
  painter.setPen(c.surface);
  const QRect inner = rect().adjusted(padding(), padding(), -padding(), -padding());
  painter.setFont(larger(font(), 1.4));
  const int line = painter.fontMetrics().lineSpacing();
  const QRect first(inner.left(), inner.top(), inner.width(), line);
  painter.drawText(first, Qt::AlignLeft | Qt::AlignVCenter, text());
  const int taken = painter.fontMetrics().horizontalAdvance(text());
  painter.setFont(font());
  const QString key = tr("Enter", "the key");
  if (taken + painter.fontMetrics().horizontalAdvance(key) + em_of(this) <= first.width())
    painter.drawText(first, Qt::AlignRight | Qt::AlignVCenter, key);
  painter.drawText(inner.adjusted(0, line, 0, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, details_);
}

CharacterTile::CharacterTile(char32_t character, const QString& caption, double share, QWidget* parent)
    : QPushButton(parent), character_(character), caption_(caption), share_(share) {
  setObjectName(QStringLiteral("character_tile"));
  setAutoDefault(true);
  setText(to_text(character));
  setAccessibleName(caption.isEmpty() ? text() : tr("%1, %2", "character, meaning").arg(text(), caption));
  setToolTip(tr("Show %1 and its words").arg(text()));
}

QFont CharacterTile::large_font() const {
  // As large beside larger text as beside the smallest.
  constexpr double kSmallestText_pt = 12;
  return character_font(
      text(), kTile_pt * share_ * std::max(1.0, QFontInfo(font()).pointSizeF() / kSmallestText_pt * 0.75));
}

QSize CharacterTile::sizeHint() const {
  const int em = em_of(this);
  const QFontMetrics large(large_font());
  int width = large.horizontalAdvance(text()) + em * 5 / 4;
  if (caption_.isEmpty()) return {width, large.height() + em / 2};
  width = std::max(width, em * 13 / 2);
  // A word is not cut off.
  static const QRegularExpression between_words(QStringLiteral("\\s"));
  for (const auto& word : caption_.split(between_words))
    width = std::max(width, fontMetrics().horizontalAdvance(word) + em);
  const int lines = fontMetrics()
                        .boundingRect(0, 0, width - em, 10'000, Qt::TextWordWrap | Qt::AlignHCenter, caption_)
                        .height();
  return {width, large.height() + lines + em};
}

void CharacterTile::paintEvent(QPaintEvent* /*event*/) {
  const Colours& c = current_colours();
  const int em = em_of(this);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(hasFocus() || underMouse() ? c.indigo : c.edge, hasFocus() ? 2 : 1));
  painter.setBrush(c.surface);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), kCorner, kCorner);
  painter.setPen(c.ink);
  painter.setFont(large_font());
  const QRect inner = rect().adjusted(em / 2, em / 4, -em / 2, -em / 2);
  const int high = painter.fontMetrics().height();
  painter.drawText(QRect(inner.left(), inner.top(), inner.width(), high), Qt::AlignCenter | Qt::TextDontClip,
                   text());
  if (caption_.isEmpty()) return;
  painter.setFont(font());
  painter.setPen(c.muted);
  painter.drawText(inner.adjusted(0, high, 0, 0), Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap,
                   caption_);
}

InkRow::InkRow(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("ink_row"));
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void InkRow::show_inks(std::vector<practice::InkedWriting> inks) {
  inks_ = std::move(inks);
  QStringList said;
  for (const auto& one : inks_) said.append(to_text(one.character));
  setAccessibleName(tr("Your handwriting: %1").arg(said.join(QLatin1Char(' '))));
  updateGeometry();
  update();
}

void InkRow::show_all(bool all) {
  all_ = all;
  updateGeometry();
  update();
}

int InkRow::side() const { return static_cast<int>(em_of(this) * kInkSide_em); }
int InkRow::columns(int width) const { return std::max(1, width / std::max(1, side())); }
bool InkRow::has_more() const { return columns(width()) < static_cast<int>(inks_.size()); }

int InkRow::heightForWidth(int width) const {
  const int across = columns(width);
  const int rows = all_ ? (static_cast<int>(inks_.size()) + across - 1) / across : 1;
  return std::max(1, rows) * side();
}

QSize InkRow::sizeHint() const { return {side() * 3, heightForWidth(std::max(side() * 3, width()))}; }

void InkRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  emit resized();
}

void InkRow::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int across = columns(width());
  const int shown = all_ ? static_cast<int>(inks_.size()) : std::min(across, static_cast<int>(inks_.size()));
  for (int i = 0; i < shown; ++i) {
    const QRectF box(i % across * side(), i / across * side(), side(), side());
    paint_handwriting(painter, inks_[static_cast<std::size_t>(i)].ink, box.adjusted(3, 3, -3, -3),
                      current_colours().ink, kInkPen);
  }
}

MilestoneBar::MilestoneBar(QWidget* parent)
    : QWidget(parent),
      name_(text_label("milestone_name", this)),
      reached_(text_label("milestone_reached", this, "muted")),
      bar_(named(new QProgressBar(this), "milestone_bar")),
      done_(text_label("milestone_done", this, "muted")) {
  reached_->setAlignment(Qt::AlignRight);
  bar_->setTextVisible(false);
  bar_->setFixedHeight(8);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  grid->addWidget(name_, 0, 0);
  grid->addWidget(reached_, 0, 1);
  grid->addWidget(bar_, 1, 0, 1, 2);
  grid->addWidget(done_, 2, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
}

void MilestoneBar::show_milestone(const practice::Milestone& milestone) {
  name_->setText(HomeWords::list(milestone));
  reached_->setText(HomeWords::count(milestone));
  done_->setText(HomeWords::done(milestone));
  done_->setVisible(!done_->text().isEmpty());
  bar_->setRange(0, std::max(1, milestone.size));
  bar_->setValue(milestone.learned);
  bar_->setAccessibleName(name_->text());
  bar_->setAccessibleDescription(QStringLiteral("%1. %2").arg(reached_->text(), done_->text()).trimmed());
}

}  // namespace nazori::ui
