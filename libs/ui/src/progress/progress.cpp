// SPDX-License-Identifier: Apache-2.0
#include "progress/progress.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QSettings>
#include <algorithm>
#include <array>

#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"
#include "progress/characters_card.h"
#include "progress/progress_actions.h"
#include "progress/progress_view.h"

namespace nazori::ui {
namespace {

using TimeShown = ProgressView::TimeShown;
constexpr std::array kTimes{TimeShown::month, TimeShown::season, TimeShown::year, TimeShown::everything};
constexpr std::array<std::string_view, 4> kTimeNames{"month", "season", "year", "everything"};

/// By its name; until version 0.2 it was stored as its number of days.
TimeShown read_time(const base::Settings& settings) {
  const auto days = static_cast<int>(base::number_setting(settings, "time_shown", 92, 0, 366));
  const auto old = std::find(kTimes.begin(), kTimes.end(), static_cast<TimeShown>(days)) - kTimes.begin();
  return kTimes[base::named_setting(settings, "time_shown", kTimeNames, static_cast<std::size_t>(old) % 4)];
}

}  // namespace

Progress::Progress(WindowParts& parts)
    : Page(parts, {QStringLiteral("progress"),
                   tr("P&rogress"),
                   tr("Your progress in charts and numbers"),
                   Icon::progress,
                   {}}),
      actions_(new ProgressActions(&parts.window())),
      view_(new ProgressView(parts.learner(), &parts.window())),
      reader_(parts.inbox()) {
  QSettings settings(parts.settings_file(), QSettings::IniFormat);
  settings.beginGroup(id());
  const base::Settings values = read_settings(settings);
  view_->set_time_shown(read_time(values));
  view_->characters().set_list(to_text(base::text_setting(values, "list")));
  const bool more = base::flag_setting(values, "more", false);
  view_->set_shows_more(more);
  actions_->more->setChecked(more);
  connect_actions();
  connect(view_, &ProgressView::more_changed, this, [this](bool shown) {
    actions_->more->setChecked(shown);
    this->parts().save_later();
  });
  connect(view_, &ProgressView::practise_wanted, actions_->practise, &QAction::trigger);
  connect(view_, &ProgressView::opened, this,
          [this](char32_t character) { this->parts().show_character(character); });
  connect(view_, &ProgressView::copy_wanted, this, [this](const ChartCard* card) { copy(*card); });
  connect(view_, &ProgressView::time_changed, this, [this] { this->parts().save_later(); });
  subscribe(reader_.progressed, view_, [this](double done) { view_->show_work(done); });
  subscribe(reader_.ready, this, [this](const practice::SharedStatistics& statistics) {
    view_->show_statistics(statistics);
    this->parts().note_opened();
  });
  subscribe(reader_.failed, this, [this](const base::Error& error) {
    view_->show_trouble(tr("The statistics could not be read: %1.").arg(reason(error)));
    this->parts().note_opened();
  });
  const auto note = [this] {
    stale_ = true;
    if (entered_) read();
  };
  subscribe(parts.learner().changed, this, note);
  subscribe(parts.learner().profile_changed, this, [this] {
    // What is still being worked out belongs to the previous learner.
    reader_.cancel();
    view_->clear();
    stale_ = true;
    emit title_changed();
  });
}

Progress::~Progress() = default;

QString Progress::title() const { return tr("Progress of %1").arg(to_text(parts().learner().profile())); }
QWidget* Progress::instead_of_tablet() const { return view_; }
ActionSet* Progress::actions() const { return actions_; }

QList<Tool> Progress::tools() const { return {{actions_->numbers, true}, {actions_->copy, true}}; }

void Progress::connect_actions() {
  for (const auto& entry : actions_->card_entries)
    on(entry.action, [this, id = entry.id] { view_->go_to(id); });
  on(actions_->more, [this](bool shown) { view_->set_shows_more(shown); });
  on(actions_->practise, [this] {
    auto& session = parts().session();
    const auto hardest = view_->hardest();
    if (session.is_running())
      parts().go_to(QStringLiteral("characters"));
    else if (hardest.empty())
      parts().announce(Feedback::hint, tr("No stroke has been wrong more than once."));
    else
      session.start_with(hardest);
  });
  on(actions_->numbers, [this] {
    auto* card = view_->card_at_hand();
    card->set_shows_numbers(!card->shows_numbers());
    card->focus_content();
  });
  on(actions_->copy, [this] { copy(*view_->card_at_hand()); });
  const auto change = [this](int by) {
    if (!view_->change_time_shown(by))
      parts().announce(Feedback::hint,
                       by > 0 ? tr("All data is shown.") : tr("One month is the shortest period."));
  };
  on(actions_->longer, [change] { change(1); });
  on(actions_->shorter, [change] { change(-1); });
}

void Progress::enter() {
  entered_ = true;
  if (stale_)
    read();
  else
    parts().note_opened();
  parts().announce(Feedback::hint, tr("1 to %1 go to a chart, N shows its numbers, Ctrl+C copies them.")
                                       .arg(actions_->card_entries.size()));
}

void Progress::leave() { entered_ = false; }

void Progress::read() {
  stale_ = false;
  reader_.request(parts().learner().file(), parts().learner().store().now());
}

void Progress::copy(const ChartCard& card) {
  const auto& numbers = card.shown().numbers;
  if (numbers.rows.isEmpty()) {
    parts().announce(Feedback::advice, tr("%1: no data yet.").arg(card.title()));
    return;
  }
  QGuiApplication::clipboard()->setText(numbers.as_text());
  parts().announce(Feedback::good, tr("Copied “%1” (rows: %2).").arg(card.title()).arg(numbers.rows.size()));
}

void Progress::refresh_appearance() { view_->refresh_appearance(); }

void Progress::save(QSettings& settings) const {
  auto values = read_settings(settings);
  const auto time = std::find(kTimes.begin(), kTimes.end(), view_->time_shown()) - kTimes.begin();
  values.insert_or_assign("time_shown", std::string(kTimeNames[static_cast<std::size_t>(time)]));
  values.insert_or_assign("list", view_->characters().list().toStdString());
  base::set_flag(values, "more", view_->shows_more());
  write_settings(settings, values);
}

}  // namespace nazori::ui
