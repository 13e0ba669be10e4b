// SPDX-License-Identifier: Apache-2.0
// study stats, study workload
#include <fmt/format.h>

#include <map>
#include <memory>

#include "nazori/base/utf8.h"
#include "nazori/study/statistics.h"
#include "options.h"
#include "study_session.h"

namespace nazori::cli {
namespace {

using study::Statistics;

Json retention_json(const study::Retention& retention) {
  return {{"reviews", retention.reviews},
          {"recalled", retention.recalled},
          {"actual", retention.reviews > 0 ? Json(retention.actual()) : Json()},
          {"predicted", retention.reviews > 0 ? Json(retention.predicted) : Json()}};
}

Json mistakes_json(const std::map<kanji::MistakeKind, int>& kinds) {
  Json json = Json::object();
  for (const auto& [kind, count] : kinds) json[std::string(kanji::name_of(kind))] = count;
  return json;
}

Json pace_json(const study::Pace& pace) {
  const auto one = [](std::chrono::milliseconds time, int days) {
    return Json{{"time_ms", time.count()}, {"days", days}, {"own", days >= study::kPaceNeeds}};
  };
  return {{"recalled", one(pace.recalled, pace.recalled_days)},
          {"failed", one(pace.failed, pace.failed_days)},
          {"introduced", one(pace.introduced, pace.introduced_days)}};
}

Json statistics_json(const Statistics& statistics) {
  Json json{{"today", study::to_text(statistics.today)},
            {"reviews", statistics.reviews},
            {"time_ms", statistics.time.count()},
            {"streak",
             {{"days", statistics.streak.days},
              {"longest", statistics.streak.longest},
              {"today_done", statistics.streak.today_done},
              {"day_off_used", statistics.streak.day_off_used}}},
            {"retention", retention_json(statistics.retention)},
            {"retention_30_days", retention_json(statistics.last_30_days)}};
  json["pace"] = pace_json(statistics.pace);
  for (const auto& day : statistics.retention_days) {
    Json one = retention_json(day.retention);
    one["day"] = study::to_text(day.day);
    json["retention_days"].push_back(std::move(one));
  }
  for (const auto& day : statistics.days) {
    json["days"].push_back({{"day", study::to_text(day.day)},
                            {"reviews", day.reviews},
                            {"practices", day.practices},
                            {"introduced", day.introduced},
                            {"time_ms", day.time.count()}});
  }
  for (const auto& day : statistics.forecast) {
    json["forecast"].push_back({{"day", study::to_text(day.day)}, {"reviews", day.reviews}});
  }
  for (const auto& one : statistics.characters) {
    json["characters"].push_back({{"character", base::encode_utf8(one.character)},
                                  {"strength", study::name_of(one.strength)},
                                  {"retrievability", one.retrievability}});
  }
  for (const auto& one : statistics.hard_strokes) {
    json["hard_strokes"].push_back({{"character", base::encode_utf8(one.character)},
                                    {"stroke", one.stroke + 1},
                                    {"faults", one.mistakes},
                                    {"writings", one.writings},
                                    {"kinds", mistakes_json(one.kinds)}});
  }
  for (const auto& day : statistics.motion) {
    json["motion"].push_back({{"day", study::to_text(day.day)},
                              {"writings", day.writings},
                              {"speed", day.speed},
                              {"smoothness", day.smoothness}});
  }
  for (const char* list : {"days", "retention_days", "characters", "hard_strokes", "motion"}) {
    if (!json.contains(list)) json[list] = Json::array();
  }
  return json;
}

std::string statistics_text(const Statistics& statistics) {
  std::map<std::string_view, int> strengths;
  for (const auto& one : statistics.characters) ++strengths[study::name_of(one.strength)];
  const auto minutes = [](std::chrono::milliseconds time) {
    return std::chrono::round<std::chrono::minutes>(time).count();
  };
  std::string text =
      fmt::format("reviews     {} in {} min\nstreak      {} (longest {}){}\n", statistics.reviews,
                  minutes(statistics.time), counted(statistics.streak.days, "day"), statistics.streak.longest,
                  statistics.streak.today_done ? "" : ", today is open");
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
    text += fmt::format("hard        {} stroke {}: {} of {}", base::encode_utf8(one.character),
                        one.stroke + 1, one.mistakes, counted(one.writings, "writing"));
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
    console.print("nothing studied yet: nazori-cli study due says what to begin with\n");
    return kDone;
  }
  console.print(options.json ? to_text(statistics_json(*statistics)) : statistics_text(*statistics));
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
    json.push_back({{"desired_retention", settings.desired_retention},
                    {"reviews_per_day", one->reviews_per_day},
                    {"minutes_per_day", one->minutes_per_day},
                    {"known", one->known}});
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
  add("stats", "Tell how study goes: retention, streak, forecast, hardest strokes",
      "Example:\n  nazori-cli study stats --json", stats);
  add("workload", "Tell what each desired retention would cost in a year at the present pace",
      "Example:\n  nazori-cli study workload", workload);
}

}  // namespace nazori::cli
