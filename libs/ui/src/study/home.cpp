// SPDX-License-Identifier: Apache-2.0
#include "study/home.h"

#include <QFileDialog>

#include "nazori/practice/day_record.h"
#include "nazori/practice/extra_study.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"
#include "study/home_view.h"
#include "study/period_picture.h"
#include "study/study_dialogs.h"

namespace nazori::ui {
namespace {

constexpr int kLook_ms = 30'000;
constexpr std::size_t kMore = 5;
constexpr std::size_t kMostAhead = 20;

}  // namespace

HomeActions::HomeActions(QWidget* window) : ActionSet(window) {
  start = make("home_study", tr("&Start today's study"), tr("Start today's reviews and new characters"),
               "Ctrl+Return", Icon::play);
  reviews =
      make("home_reviews", tr("Only &reviews"), tr("Start today's reviews without new characters"), "R");
  more = make("home_more", tr("&Five more new characters"),
              tr("Learn five more new characters today, beyond your daily goal"), "F");
  ahead = make("home_ahead", tr("Review a&head"),
               tr("Review the next characters before they are due, twenty at most"), "A");
  practise = make("home_practise", tr("&Practise what was hard"),
                  tr("Write the characters that need care from memory once"), "P");
  brush = make("home_brush", tr("&Write with the brush"),
               tr("Review well known characters with the brush, on the page Brush"), "B", Icon::brush);
  leeches = make("home_leeches_lesson", tr("Rele&arn difficult characters"),
                 tr("Relearn characters you forgot too often, starting with Watch"), "Ctrl+Shift+Return");
  choose = make("home_choose", tr("&Choose characters"), tr("Go to the Characters page"), "C");
  all_ink = make("home_all_ink", tr("See all hand&writing"),
                 tr("Show everything you wrote on the last day, or one row of it"), "I", true);
  week = make("home_week", tr("Picture of the wee&k…"),
              tr("Save what you wrote this week as a picture (PNG)"), "W");
  month = make("home_month", tr("Picture of the &month…"),
               tr("Save what you wrote this month as a picture (PNG)"), "M");
  undo = make("home_undo", tr("Undo las&t review"),
              tr("Undo the last saved review or change; repeat to go further back, even to earlier days"),
              "Ctrl+Shift+Z", Icon::undo);
  settings = make("home_study_settings", tr("Study se&ttings…"),
                  tr("Daily goal, lists, order and desired retention"), "Ctrl+,");
  choices = make("home_choices", tr("Change &what I learn…"),
                 tr("What you want to write, what you know already, and how long a day"), "Ctrl+Shift+G");
  add_group(tr("St&udy"), {start, reviews, more, ahead, practise, brush, leeches, choose, nullptr, all_ink,
                           week, month, nullptr, undo, nullptr, choices, settings});
}

Home::Home(WindowParts& parts)
    : Page(parts,
           {QStringLiteral("home"), tr("H&ome"), tr("Today's reviews and new characters"), Icon::home, {}}),
      actions_(new HomeActions(&parts.window())),
      view_(new HomeView(parts.learner(), parts.session(), *actions_, &parts.window())) {
  on(actions_->start, [this] { start(false); });
  on(actions_->leeches, [this] { start(true); });
  on(actions_->reviews, [this] {
    auto& learner = this->parts().learner();
    const auto plan = learner.plan();
    if (!plan) return learner.announce_unread(plan.error());
    const auto reviews = practice::reviews_now(learner.store(), *plan);
    if (!reviews) return learner.announce_unread(reviews.error());
    start_with(reviews->characters, tr("No reviews are due now."));
  });
  on(actions_->more, [this] {
    auto& learner = this->parts().learner();
    const auto next = practice::new_characters(learner, kMore);
    if (!next) return learner.announce_unread(next.error());
    start_with(*next, tr("All characters of your lists are begun."));
  });
  on(actions_->ahead, [this] {
    start_with(practice::reviews_ahead(this->parts().learner().store(), kMostAhead),
               tr("There is nothing to review ahead."));
  });
  on(actions_->practise, [this] { start_with(view_->hard(), tr("No character needs care now.")); });
  on(actions_->brush, [this] { emit this->parts().review_with_brush(); });
  on(actions_->choose, [this] { this->parts().go_to(QStringLiteral("characters")); });
  on(actions_->undo, [this] { this->parts().session().undo(); });
  on(actions_->all_ink, [this](bool all) { view_->show_all_ink(all); });
  on(actions_->week, [this] { save_picture(false); });
  on(actions_->month, [this] { save_picture(true); });
  on(actions_->choices, [this] { this->parts().go_to(QStringLiteral("start")); });
  on(actions_->settings, [this] {
    ask_study_settings(this->parts());
    this->parts().focus_tablet();
  });
  connect(view_, &HomeView::character_wanted, &parts, &WindowParts::show_character);
  subscribe(parts.learner().changed, this, [this] { refresh(); });
  connect(&look_, &QTimer::timeout, this, &Home::refresh);
}

Home::~Home() = default;

QWidget* Home::instead_of_tablet() const { return view_; }

QList<Tool> Home::tools() const { return {{actions_->start, true}, {}, {actions_->undo, true}}; }

void Home::enter() {
  entered_ = true;
  refresh();
  look_.start(kLook_ms);
  if (view_->can_start())
    parts().announce(Feedback::hint, tr("Enter: start. Each review is saved as soon as you rate it."));
  // Later, because the window has not made its own connections yet.
  QTimer::singleShot(0, &parts(), &WindowParts::note_opened);
}

void Home::leave() {
  entered_ = false;
  look_.stop();
}

void Home::refresh() {
  if (entered_) view_->refresh();
}

void Home::start(bool leeches) {
  auto& session = parts().session();
  if (session.is_running()) {
    parts().go_to(QStringLiteral("characters"));
    return;
  }
  session.start(leeches);
}

void Home::start_with(const std::vector<char32_t>& characters, const QString& if_none) {
  auto& session = parts().session();
  if (session.is_running())
    parts().go_to(QStringLiteral("characters"));
  else if (characters.empty())
    parts().announce(Feedback::hint, if_none);
  else
    session.start_with(characters);
}

void Home::save_picture(bool of_month) {
  const auto& store = parts().learner().store();
  const auto span = of_month ? practice::month_of(store.today()) : practice::week_of(store.today());
  const auto picture = PeriodPicture::draw(store, span);
  if (!picture) return parts().learner().announce_unread(picture.error());
  if (picture->isNull())
    return parts().announce(Feedback::hint, tr("Nothing was written from memory in this time."));
  QFileDialog dialog(&parts().window(), of_month ? tr("Picture of the month") : tr("Picture of the week"));
  dialog.setObjectName(QStringLiteral("picture_dialog"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilter(tr("Picture (*.png)"));
  dialog.setDefaultSuffix(QStringLiteral("png"));
  dialog.setDirectory(parts().preferences().start_folder());
  dialog.selectFile(PeriodPicture::file_name(span));
  const bool chosen = dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty();
  parts().focus_tablet();
  if (!chosen) return;
  const QString path = dialog.selectedFiles().front();
  const auto saved = PeriodPicture::save(*picture, path.toStdString());
  if (saved)
    parts().announce(Feedback::good, tr("Saved: %1.").arg(path));
  else
    parts().announce(Feedback::wrong, tr("%1: %2. Nothing was saved.").arg(path, reason(saved.error())));
}

}  // namespace nazori::ui
