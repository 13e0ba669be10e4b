// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/statistics.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "entry_progress.h"
#include "nazori/study/day_plan.h"

namespace nazori::study {
namespace {

using std::chrono::days;

constexpr double kMatureDays = 21;
constexpr std::size_t kMostHardStrokes = 100;
constexpr int kForgiveness = 7;

/// Computes all sums in one pass over the log.
class Summing {
 public:
  /// The settings of a new learner; later ones come from the log.
  explicit Summing(Day today) : today_(today) {}

  void take(const LearnerStore::LoggedEntry& logged) {
    const LogEntry& entry = logged.entry;
    if (entry.kind == EntryKind::settings || entry.kind == EntryKind::choices) change_settings(entry);
    if (entry.character == 0) return;
    CardHistory& history =
        histories_.try_emplace(entry.character, CardHistory(entry.character)).first->second;
    const Card before = history.card();
    if (entry.kind == EntryKind::writing) {
      writing(logged, before);
    }
    history.apply(entry, settings_);
  }

  void finish(Statistics& statistics) const {
    for (const auto& [day, activity] : activity_) {
      statistics.days.push_back(activity);
      statistics.reviews += activity.reviews;
      statistics.time += activity.time;
    }
    for (const auto& [day, retention] : retention_days_)
      statistics.retention_days.push_back({day, finished(retention)});
    statistics.retention = finished(all_);
    statistics.last_30_days = finished(recent_);
    for (const auto& [key, stroke] : strokes_) {
      if (stroke.mistakes < 2) continue;
      statistics.hard_strokes.push_back(stroke);
      statistics.hard_strokes.back().writings = writings_.at(stroke.character);
    }
    std::sort(statistics.hard_strokes.begin(), statistics.hard_strokes.end(),
              [](const HardStroke& a, const HardStroke& b) {
                return std::tuple(-a.mistakes, a.writings, a.character, a.stroke) <
                       std::tuple(-b.mistakes, b.writings, b.character, b.stroke);
              });
    if (statistics.hard_strokes.size() > kMostHardStrokes) statistics.hard_strokes.resize(kMostHardStrokes);
    for (const auto& [day, sum] : motion_) {
      statistics.motion.push_back(
          {day, sum.writings, sum.speed / sum.writings, sum.smoothness / sum.writings});
    }
  }

 private:
  /// The predicted probabilities use the weights that applied at the time.
  void change_settings(const LogEntry& entry) {
    const auto settings = parse_settings(entry.settings);
    if (!settings) return;
    const bool others = changes_memory(settings_, *settings);
    settings_ = *settings;
    if (!others) return;
    if (auto fsrs = Fsrs::create(settings_.fsrs)) fsrs_ = *fsrs;
    for (auto& [character, history] : histories_) history.change_settings(settings_);
  }

  void writing(const LearnerStore::LoggedEntry& logged, const Card& before) {
    const LogEntry& entry = logged.entry;
    const Writing& written = entry.writing;
    DayActivity& activity = activity_[entry.day];
    activity.day = entry.day;
    activity.time += written.result.duration;
    // The brush has reviews of its own, and another motion and other mistakes than the stylus.
    if (written.stage == Stage::brush) {
      ++activity.practices;
      return;
    }
    if (!before.introduced) ++activity.introduced;
    if (written.stage == Stage::memory) {
      ++activity.reviews;
      review(entry, before);
    } else {
      ++activity.practices;
    }
    if (written.stage != Stage::watch) {
      ++writings_[entry.character];
      mistakes(entry);
    }
    if (logged.motion) {
      DayMotion& sum = motion_[entry.day];
      ++sum.writings;
      sum.speed += logged.motion->speed;
      sum.smoothness += logged.motion->smoothness;
    }
  }

  void review(const LogEntry& entry, const Card& before) {
    if (before.memory.phase != Phase::review || !before.last_day || entry.day <= *before.last_day) return;
    const double chance = fsrs_.retrievability(before.memory.stability,
                                               static_cast<double>((entry.day - *before.last_day).count()));
    const bool recalled = entry.writing.rating != Rating::again;
    for (Retention* sum :
         {&all_, &retention_days_[entry.day], entry.day > today_ - days(30) ? &recent_ : nullptr}) {
      if (sum == nullptr) continue;
      ++sum->reviews;
      sum->recalled += recalled ? 1 : 0;
      sum->predicted += chance;
    }
  }

  void mistakes(const LogEntry& entry) {
    std::set<int> seen;
    for (const StrokeMistake& mistake : entry.writing.result.mistakes) {
      HardStroke& stroke = strokes_[{entry.character, mistake.stroke}];
      stroke.character = entry.character;
      stroke.stroke = mistake.stroke;
      ++stroke.kinds[mistake.kind];
      if (seen.insert(mistake.stroke).second) ++stroke.mistakes;
    }
  }

  static Retention finished(Retention sum) {
    if (sum.reviews > 0) sum.predicted /= sum.reviews;
    return sum;
  }

  Settings settings_;
  Fsrs fsrs_;
  Day today_;
  std::map<Day, Retention> retention_days_;
  std::map<char32_t, CardHistory> histories_;
  std::map<Day, DayActivity> activity_;
  std::map<Day, DayMotion> motion_;
  std::map<std::pair<char32_t, int>, HardStroke> strokes_;
  std::map<char32_t, int> writings_;
  Retention all_;
  Retention recent_;
};

}  // namespace

std::string_view name_of(Strength strength) {
  switch (strength) {
    case Strength::unseen:
      return "unseen";
    case Strength::learning:
      return "learning";
    case Strength::young:
      return "young";
    case Strength::mature:
      return "mature";
    case Strength::leech:
      return "leech";
    case Strength::paused:
      return "paused";
  }
  return {};
}

Strength strength_of(const Card& card) {
  if (card.paused) return Strength::paused;
  if (card.leech) return Strength::leech;
  if (card.memory.phase == Phase::fresh) return card.introduced ? Strength::learning : Strength::unseen;
  if (card.memory.phase != Phase::review) return Strength::learning;
  return card.memory.stability < kMatureDays ? Strength::young : Strength::mature;
}

Streak streak_of(const std::vector<Day>& studied, Day today) {
  Streak streak;
  int run = 0;
  std::optional<Day> last;
  constexpr Day kNever{days(-1'000'000)};
  Day last_off = kNever;
  const auto follows = [&](Day day) {
    if (!last) return false;
    const auto gap = (day - *last).count();
    if (gap <= 1) return true;
    const Day off = day - days(1);
    return gap == 2 && (off - last_off).count() >= kForgiveness;
  };
  for (const Day day : studied) {
    if (day > today) break;
    if (last == day) continue;
    if (follows(day)) {
      if ((day - *last).count() == 2) last_off = day - days(1);
      ++run;
    } else {
      run = 1;
      last_off = kNever;
    }
    last = day;
    streak.longest = std::max(streak.longest, run);
  }
  streak.today_done = last == today;
  // Today may still be done, so yesterday's streak lasts while today can still continue it.
  streak.days = streak.today_done || follows(today) ? run : 0;
  if (streak.days > 0 && !streak.today_done && (today - *last).count() == 2) last_off = today - days(1);
  streak.day_off_used = streak.days > 0 && (today - last_off).count() < kForgiveness;
  return streak;
}

base::Result<Statistics> statistics_of(const LearnerStore& learner, const base::Progress& progress) {
  const auto fsrs = Fsrs::create(learner.settings().fsrs);
  if (!fsrs) return tl::unexpected(fsrs.error());
  Statistics statistics;
  statistics.today = learner.today();
  Summing sums(statistics.today);
  bool cancelled = false;
  int entries_read = 0;
  auto read = learner.for_each_entry(true, [&](const LearnerStore::LoggedEntry& logged) {
    if (progress && ++entries_read % kEntriesBetweenProgress == 0) {
      const auto all = static_cast<double>(learner.last_entry());
      cancelled = !progress(static_cast<double>(logged.entry.id) / all, "statistics");
      if (cancelled) return false;
    }
    sums.take(logged);
    return true;
  });
  if (cancelled) return base::fail(base::Errc::cancelled, "stopped");
  if (!read) return tl::unexpected(std::move(read.error()));
  sums.finish(statistics);
  auto pace = pace_of(learner);
  if (!pace) return tl::unexpected(std::move(pace.error()));
  statistics.pace = *pace;
  for (int day = 0; day < kForecastDays; ++day)
    statistics.forecast.push_back({statistics.today + days(day), 0});
  for (const auto& [character, card] : learner.cards()) {
    statistics.characters.push_back(
        {character, strength_of(card), retrievability_now(card, *fsrs, statistics.today)});
    if (card.paused || card.leech || card.memory.phase == Phase::fresh) continue;
    Day due = card.due_day.value_or(statistics.today);
    if (card.postponed_until) due = std::max(due, *card.postponed_until);
    const auto offset = std::max<std::int64_t>(0, (due - statistics.today).count());
    if (offset < kForecastDays) ++statistics.forecast[static_cast<std::size_t>(offset)].reviews;
  }
  std::vector<Day> studied;
  for (const DayActivity& day : statistics.days) studied.push_back(day.day);
  statistics.streak = streak_of(studied, statistics.today);
  return statistics;
}

}  // namespace nazori::study
