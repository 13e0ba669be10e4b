// SPDX-License-Identifier: Apache-2.0
// study stats, study workload
#include <fmt/format.h>

#include <map>
#include <memory>

#include "characters.h"
#include "nazori/exchange/statistics.h"
#include "nazori/study/statistics.h"
#include "options.h"
#include "study_session.h"

namespace nazori::cli {
namespace {

using study::Statistics;

std::string statistics_text(const Statistics& statistics) {
  std::map<std::string_view, int> strengths;
  for (const auto& one : statistics.characters) ++strengths[study::name_of(one.strength)];
  const auto minutes = [](std::chrono::milliseconds time) {
    return std::chrono::round<std::chrono::minutes>(time).count();
  };
  std::string text =
      fmt::format("reviews     {} in {} min\nstreak      {} (longest {}){}\n", statistics.reviews,
                  minutes(statistics.time), counted(statistics.streak.days, "day"), statistics.streak.longest,
                  statistics.streak.today_done ? "" : ", not yet today");
  if (statistics.retention.reviews > 0) {
    text += fmt::format("retention   {:.1f} % of {} reviews (predicted {:.1f} %)\n",
                        100 * statistics.retention.actual(), statistics.retention.reviews,
                        100 * statistics.retention.predicted);
  }
  text += "characters ";
  for (const auto& [name, count] : strengths) text += fmt::format(" {} {}", count, name);
  text += "\nforecast   ";
  for (const auto& day : statistics.forecast) text += fmt::format(" {}", day.reviews);
  text += "\n";
  for (const auto& one : statistics.hard_strokes) {
    text += fmt::format("hard        {} stroke {}: {} of {}", letter(one.character), one.stroke + 1,
                        one.mistakes, counted(one.writings, "writing"));
    for (const auto& [kind, count] : one.kinds) text += fmt::format(", {} {}", kanji::name_of(kind), count);
    text += "\n";
  }
  return text;
}

int stats(Console& console, const StudyOptions& options) {
  const auto learner = open_learner(options, study::Access::read);
  if (!learner) return console.refuse(learner.error());
  const auto statistics = study::statistics_of(*learner);
  if (!statistics) return console.refuse(statistics.error());
  if (!options.json && statistics->reviews == 0 && statistics->characters.empty()) {
    console.print("nothing studied yet; nazori-cli study due shows what to start with\n");
    return kDone;
  }
  console.print(options.json ? to_text(exchange::to_json(*statistics)) : statistics_text(*statistics));
  return kDone;
}

int workload(Console& console, const StudyOptions& options) {
  const auto learner = open_learner(options, study::Access::read);
  if (!learner) return console.refuse(learner.error());
  const auto pace = study::pace_of(*learner);
  if (!pace) return console.refuse(pace.error());
  Json json = Json::array();
  std::string lines = "retention  reviews a day  minutes a day  known after a year\n";
  for (int percent = 80; percent <= 97; ++percent) {
    study::FsrsSettings settings = learner->settings().fsrs;
    settings.desired_retention = percent / 100.0;
    const auto one =
        study::expected_workload(settings, std::min(100, learner->settings().new_per_day), *pace);
    if (!one) return console.refuse(one.error());
    json.push_back(exchange::to_json(settings.desired_retention, *one));
    lines += fmt::format("{:.2f} {:18.1f} {:14.1f} {:19.0f}\n", settings.desired_retention,
                         one->reviews_per_day, one->minutes_per_day, one->known);
  }
  console.print(options.json ? to_text(json) : lines);
  return kDone;
}

}  // namespace

void add_study_stats(CLI::App& study, Action& chosen) {
  const auto add = [&](const char* name, const char* description, const char* footer, auto run) {
    auto options = std::make_shared<StudyOptions>();
    CLI::App* verb = add_study_verb(study, name, description, footer);
    add_learner_options(*verb, *options);
    verb->callback([options, &chosen, run] {
      chosen = [options, run](Console& console) { return run(console, *options); };
    });
  };
  add("stats", "Show study statistics: retention, streak, forecast, hardest strokes",
      "Example:\n  nazori-cli study stats --json", stats);
  add("workload", "Show the workload of each desired retention over a year at the current pace",
      "Example:\n  nazori-cli study workload", workload);
}

}  // namespace nazori::cli
