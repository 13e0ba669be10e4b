// SPDX-License-Identifier: Apache-2.0
#include "study/session_bar.h"

#include <QEvent>
#include <QFontInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <initializer_list>

#include "nazori/practice/session_steps.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/session_words.h"
#include "study/session_text_size.h"

namespace nazori::ui {
namespace {

constexpr int kRoomForNote_em = 56;
constexpr int kRoomForTime_em = 26;

}  // namespace

SessionBar::SessionBar(const practice::StudySession& session, const SessionActions& actions, QWidget* parent)
    : QFrame(parent),
      session_(session),
      progress_(with_role(named(new QLabel(this), "session_progress"), "muted")),
      line_(named(new QProgressBar(this), "session_line", tr("Session progress"))),
      time_(with_role(named(new QLabel(this), "session_time"), "muted")),
      note_(with_role(named(new QLabel(this), "session_note"), "muted")),
      undo_(with_role(action_button(actions.undo, tr("Undo"), this), "compact")),
      more_(named(new QToolButton(this), "session_menu", tr("More for this character"))) {
  setObjectName(QStringLiteral("session_bar"));
  setAccessibleName(tr("Study session"));
  line_->setTextVisible(false);
  undo_->setAccessibleName(actions.undo->iconText());
  connect(actions.undo, &QAction::changed, undo_,
          [this, undo = actions.undo] { undo_->setEnabled(undo->isEnabled()); });
  more_->setText(QStringLiteral("⋯"));
  more_->setToolTip(more_->accessibleName());
  more_->setPopupMode(QToolButton::InstantPopup);
  // Each entry shows its key.
  auto* menu = new QMenu(more_);
  menu->addActions({actions.reset, actions.postpone, actions.pause, actions.tags});
  menu->addSeparator();
  menu->addActions({actions.settings, actions.end});
  more_->setMenu(menu);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 4, 16, 4);
  row->setSpacing(12);
  row->addWidget(progress_);
  row->addWidget(line_, 1);
  for (QWidget* one : std::initializer_list<QWidget*>{time_, note_, undo_, more_}) row->addWidget(one);
  fit();
}

void SessionBar::show_state() {
  setVisible(session_.is_running());
  if (!session_.is_running()) return;
  const auto progress = practice::progress_of(session_);
  progress_->setText(tr("%1 of %2").arg(progress.at).arg(progress.total));
  line_->setRange(0, std::max(progress.total, 1));
  line_->setValue(progress.done);
  time_->setText(progress.minutes_left == 0 ? tr("almost done")
                                            : tr("%n min left", nullptr, progress.minutes_left));
  note_->setText(SessionWords::sentence(session_.last_event()));
  undo_->setAccessibleDescription(note_->text());
  fit();
}

void SessionBar::set_short(bool is_short) {
  is_short_ = is_short;
  fit();
}

void SessionBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

void SessionBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fit();
}

void SessionBar::fit() {
  const int em = QFontInfo(font()).pixelSize();
  line_->setFixedHeight(std::max(6, em / 3));
  note_->setVisible(!is_short_ && !note_->text().isEmpty() && width() >= em * kRoomForNote_em);
  time_->setVisible(!is_short_ && width() >= em * kRoomForTime_em);
  line_->setVisible(!is_short_);
  setSizePolicy(is_short_ ? QSizePolicy::Maximum : QSizePolicy::Preferred, QSizePolicy::Fixed);
  const QFont own = session_font(session_room(*this));
  for (QWidget* one : std::initializer_list<QWidget*>{progress_, time_, note_, undo_, more_})
    if (one->font() != own) one->setFont(own);
}

}  // namespace nazori::ui
