// SPDX-License-Identifier: Apache-2.0
#include "start/check_page.h"

#include <QFontInfo>
#include <QFrame>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"
#include "start/start_words.h"

namespace nazori::ui {
namespace {

constexpr double kLarge = 1.5;
constexpr int kGap = 10;

}  // namespace

CheckActions::CheckActions(QWidget* window) : ActionSet(window) {
  done = make("check_done", tr("&Finish"), tr("Check what you wrote and go on"), "Return Enter", Icon::tick);
  unknown = make("check_unknown", tr("I &don't know"), tr("Go on to the next character"), "I");
  undo = make("check_undo", tr("&Undo stroke"), tr("Undo the last stroke"), "Ctrl+Z Backspace", Icon::undo);
  clear = make("check_clear", tr("&Clear"), tr("Write the character again"), "Del", Icon::erase);
  end = make("check_end", tr("&End the test"), tr("Go back to the questions; nothing is saved"),
             "Ctrl+Shift+E");
  add_group(tr("T&est"), {done, unknown, nullptr, undo, clear, nullptr, end});
}

CheckPage::CheckPage(WindowParts& parts)
    : Page(parts, {QStringLiteral("check"), tr("&Test"), tr("What you can write already, in two minutes"),
                   Icon::strokes, tr("An empty tablet to write on from memory")}),
      actions_(new CheckActions(&parts.window())),
      question_bar_(named(new QFrame(&parts.window()), "check_bar")),
      buttons_(named(new QFrame(&parts.window()), "check_buttons")) {
  make_question();
  make_buttons();
  auto& placement = parts.placement();
  on(actions_->done, [this, &placement] {
    if (!placement.has_writing())
      this->parts().announce(Feedback::advice,
                             tr("Write the character first, or press I if you don't know it."));
    placement.finish_writing();
    this->parts().focus_tablet();
  });
  on(actions_->unknown, [this, &placement] {
    placement.do_not_know();
    this->parts().focus_tablet();
  });
  on(actions_->undo, [&placement] { placement.undo_stroke(); });
  on(actions_->clear, [&placement] { placement.clear(); });
  on(actions_->end, [this] { end(); });
  subscribe(placement.changed, this, [this] { show_question(); });
  subscribe(placement.failed, this, [this](const base::Error& error) {
    this->parts().announce(Feedback::wrong, tr("The writing could not be checked: %1.").arg(reason(error)));
  });
}

CheckPage::~CheckPage() = default;

void CheckPage::make_question() {
  progress_ = with_role(new QLabel(question_bar_), "muted");
  progress_->setObjectName(QStringLiteral("check_progress"));
  question_ = text_label("check_question", question_bar_);
  line_ = named(new QProgressBar(question_bar_), "check_line", tr("Questions answered"));
  line_->setTextVisible(false);
  line_->setFixedHeight(8);
  line_->setRange(0, practice::PlacementCheck::kFewest);
  auto* column = new QVBoxLayout(question_bar_);
  column->setContentsMargins(16, 8, 16, 8);
  column->setSpacing(6);
  for (QWidget* one :
       {static_cast<QWidget*>(progress_), static_cast<QWidget*>(line_), static_cast<QWidget*>(question_)})
    column->addWidget(one);
  question_bar_->hide();
}

void CheckPage::make_buttons() {
  auto* around = new QVBoxLayout(buttons_);
  around->setContentsMargins(16, 8, 16, 8);
  auto* row = new QWidget(buttons_);
  around->addWidget(row);
  auto* flow = new FlowLayout(kGap, kGap, row);
  auto* done = action_button(actions_->done, tr("Finish  ⏎"), buttons_);
  done->setObjectName(QStringLiteral("check_done_button"));
  done->setProperty("role", QStringLiteral("primary"));
  flow->addWidget(done);
  flow->addWidget(action_button(actions_->unknown, tr("I don't know  (I)"), buttons_));
  flow->addWidget(action_button(actions_->end, tr("End the test"), buttons_));
  buttons_->hide();
}

QWidget* CheckPage::above_tablet() const { return question_bar_; }
QWidget* CheckPage::under_tablet() const { return buttons_; }

QList<Tool> CheckPage::tools() const {
  return {{actions_->done, true}, {actions_->unknown, true}, {},
          {actions_->undo, true}, {actions_->clear, true},   {},
          {actions_->end, true}};
}

void CheckPage::enter() {
  entered_ = true;
  question_bar_->show();
  buttons_->show();
  parts().placement().enter();
  refresh_appearance();
  QTimer::singleShot(0, &parts(), &WindowParts::note_opened);
}

void CheckPage::leave() {
  entered_ = false;
  question_bar_->hide();
  buttons_->hide();
  parts().placement().leave();
  parts().placement().stop();
}

void CheckPage::refresh_appearance() {
  question_->setFont([this] {
    QFont large = question_bar_->font();
    large.setPointSizeF(QFontInfo(large).pointSizeF() * kLarge);
    return large;
  }());
}

void CheckPage::show_question() {
  const auto& placement = parts().placement();
  if (!entered_ || !placement.question()) return;
  const bool is_new = line_->value() != placement.answered() || question_->text().isEmpty();
  const QString asked = StartWords::asked(*placement.question());
  line_->setValue(std::min(placement.answered(), line_->maximum()));
  progress_->setText(tr("Question %1 of about %2. Write from memory.")
                         .arg(placement.answered() + 1)
                         .arg(practice::PlacementCheck::kFewest));
  const bool differs = question_->text() != asked;
  question_->setText(asked);
  if (is_new || differs) parts().announce(Feedback::hint, tr("Write: %1").arg(asked));
}

void CheckPage::end() {
  parts().placement().stop();
  parts().go_to(QStringLiteral("start"));
  parts().announce(Feedback::hint, tr("The test was ended. Nothing was saved."));
}

}  // namespace nazori::ui
