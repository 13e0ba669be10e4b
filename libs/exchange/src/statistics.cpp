// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/statistics.h"

#include <map>
#include <string>

#include "nazori/base/utf8.h"

namespace nazori::exchange {
namespace {

Value retention_json(const study::Retention& retention) {
  return {{"reviews", retention.reviews},
          {"recalled", retention.recalled},
          {"actual", retention.reviews > 0 ? Value(retention.actual()) : Value()},
          {"predicted", retention.reviews > 0 ? Value(retention.predicted) : Value()}};
}

Value mistakes_json(const std::map<kanji::MistakeKind, int>& kinds) {
  Value json = Value::object();
  for (const auto& [kind, count] : kinds) json[std::string(kanji::name_of(kind))] = count;
  return json;
}

Value pace_json(const study::Pace& pace) {
  const auto one = [](std::chrono::milliseconds time, int days) {
    return Value{{"time_ms", time.count()}, {"days", days}, {"own", days >= study::kPaceNeeds}};
  };
  return {{"recalled", one(pace.recalled, pace.recalled_days)},
          {"failed", one(pace.failed, pace.failed_days)},
          {"introduced", one(pace.introduced, pace.introduced_days)}};
}

}  // namespace

Value to_json(const study::Statistics& statistics) {
  Value json{{"today", study::to_text(statistics.today)},
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
    Value one = retention_json(day.retention);
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
  for (const char* list : {"days", "forecast", "retention_days", "characters", "hard_strokes", "motion"}) {
    if (!json.contains(list)) json[list] = Value::array();
  }
  return json;
}

Value to_json(double desired_retention, const study::Workload& workload) {
  return {{"desired_retention", desired_retention},
          {"reviews_per_day", workload.reviews_per_day},
          {"minutes_per_day", workload.minutes_per_day},
          {"known", workload.known}};
}

}  // namespace nazori::exchange
