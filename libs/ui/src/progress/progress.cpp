// SPDX-License-Identifier: Apache-2.0
#include "progress/progress.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QSettings>

#include "desk.h"
#include "error_text.h"
#include "kanji_text.h"
#include "progress/characters_card.h"
#include "progress/progress_actions.h"
#include "progress/progress_page.h"
#include "signals.h"

namespace nazori::ui {

Progress::Progress(Desk& desk)
    : Workplace(desk),
      actions_(new ProgressActions(&desk.window())),
      page_(new ProgressPage(desk.learner(), &desk.window())),
      reader_(desk.inbox()) {
  QSettings settings(desk.settings_file(), QSettings::IniFormat);
  settings.beginGroup(id());
  page_->set_time_shown(static_cast<ProgressPage::TimeShown>(
      settings.value(QStringLiteral("time_shown"), static_cast<int>(ProgressPage::TimeShown::season))
          .toInt()));
  page_->characters().set_list(settings.value(QStringLiteral("list")).toString());
  connect_actions();
  connect(page_, &ProgressPage::opened, this,
          [this](char32_t character) { this->desk().show_character(character); });
  connect(page_, &ProgressPage::copy_wanted, this, [this](const ChartCard* card) { copy(*card); });
  connect(page_, &ProgressPage::time_changed, this, [this] { this->desk().save_later(); });
  subscribe(reader_.progressed, page_, [this](double done) { page_->show_work(done); });
  subscribe(reader_.ready, this, [this](const practice::SharedStatistics& statistics) {
    page_->show_statistics(statistics);
    this->desk().note_opened();
  });
  subscribe(reader_.failed, this, [this](const base::Error& error) {
    page_->show_trouble(tr("The statistics could not be read: %1.").arg(reason(error)));
    this->desk().note_opened();
  });
  const auto note = [this] {
    stale_ = true;
    if (entered_) read();
  };
  subscribe(desk.learner().changed, this, note);
  subscribe(desk.learner().profile_changed, this, [this] { emit title_changed(); });
}

Progress::~Progress() = default;

QString Progress::id() const { return QStringLiteral("progress"); }
QString Progress::name() const { return tr("P&rogress"); }
QString Progress::purpose() const { return tr("What study has brought: charts and numbers"); }
Icon Progress::drawing() const { return Icon::progress; }
QString Progress::title() const { return tr("Progress of %1").arg(to_text(desk().learner().profile())); }
QWidget* Progress::page() const { return page_; }
ActionSet* Progress::actions() const { return actions_; }

QList<Tool> Progress::tools() const { return {{actions_->numbers, true}, {actions_->copy, true}}; }

void Progress::connect_actions() {
  for (const auto& place : actions_->places)
    connect(place.action, &QAction::triggered, this, [this, id = place.id] { page_->go_to(id); });
  connect(actions_->numbers, &QAction::triggered, this, [this] {
    auto* card = page_->card_at_hand();
    card->set_shows_numbers(!card->shows_numbers());
    card->focus_content();
  });
  connect(actions_->copy, &QAction::triggered, this, [this] { copy(*page_->card_at_hand()); });
  const auto change = [this](int by) {
    if (!page_->change_time_shown(by))
      desk().say(Feedback::hint, by > 0 ? tr("Everything is shown.") : tr("A month is the shortest time."));
  };
  connect(actions_->longer, &QAction::triggered, this, [change] { change(1); });
  connect(actions_->shorter, &QAction::triggered, this, [change] { change(-1); });
}

void Progress::enter() {
  entered_ = true;
  if (stale_)
    read();
  else
    desk().note_opened();
  desk().say(
      Feedback::hint,
      tr("1 to %1 go to a chart, N shows its numbers, Ctrl+C copies them.").arg(actions_->places.size()));
}

void Progress::leave() { entered_ = false; }

void Progress::read() {
  stale_ = false;
  reader_.request(desk().learner().file(), desk().learner().store().now());
}

void Progress::copy(const ChartCard& card) {
  const auto& numbers = card.shown().numbers;
  if (numbers.rows.isEmpty()) {
    desk().say(Feedback::advice, tr("%1: there are no numbers yet.").arg(card.title()));
    return;
  }
  QGuiApplication::clipboard()->setText(numbers.as_text());
  desk().say(Feedback::good,
             tr("The numbers of “%1” are copied, lines: %2.").arg(card.title()).arg(numbers.rows.size()));
}

void Progress::take_appearance() { page_->take_appearance(); }

void Progress::save(QSettings& settings) const {
  settings.setValue(QStringLiteral("time_shown"), static_cast<int>(page_->time_shown()));
  settings.setValue(QStringLiteral("list"), page_->characters().list());
}

}  // namespace nazori::ui
