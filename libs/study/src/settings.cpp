// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "named_values.h"
#include "nazori/study/calendar.h"
#include "settings_json.h"

namespace nazori::study {
namespace {

using std::chrono::minutes;

constexpr std::size_t kMostLists = 100;
constexpr int kMostBrush = 100;  // a day

base::Result<void> check_number(const char* name, double value, double lowest, double highest) {
  if (value >= lowest && value <= highest) return {};
  return base::fail(base::Errc::bad_argument, fmt::format("{} is out of range", value), name,
                    fmt::format("give {} to {}", lowest, highest));
}

json::Value minutes_json(const std::vector<minutes>& steps) {
  json::Value list = json::Value::array();
  for (const minutes step : steps) list.push_back(step.count());
  return list;
}

std::vector<minutes> read_minutes(json::Reader::Object& object, const char* member) {
  std::vector<minutes> steps;
  const json::Value* list = object.array(member);
  if (list == nullptr) return steps;
  for (const json::Value& one : *list) {
    if (!one.is_number_integer() || steps.size() > 100) {
      object.refuse(member, "holds what is not a whole number of minutes");
      return steps;
    }
    steps.emplace_back(one.get<std::int64_t>());
  }
  return steps;
}

void read_weights(json::Reader::Object& object, FsrsWeights& weights) {
  const json::Value* list = object.array("weights");
  if (list == nullptr) return;
  std::vector<double> numbers;
  for (const json::Value& one : *list) numbers.push_back(one.is_number() ? one.get<double>() : NAN);
  if (const auto read = weights_from(numbers)) {
    weights = *read;
  } else {
    object.refuse("weights", read.error().what, read.error().remedy);
  }
}

/// All but the time zone: whether that is known depends on the computer.
base::Result<void> check_rules(const Settings& settings) {
  if (auto fsrs = Fsrs::create(settings.fsrs); !fsrs) return tl::unexpected(std::move(fsrs.error()));
  const LessonRules& lesson = settings.lesson;
  struct Limit {
    const char* name;
    double value, lowest, highest;
  };
  for (const Limit& limit : std::array<Limit, 9>{{
           {"new characters a day", static_cast<double>(settings.new_per_day), 0, 1'000},
           {"reviews a day", static_cast<double>(settings.reviews_per_day), 1, 10'000},
           {"characters with the brush a day", static_cast<double>(settings.brush_per_day), 0, kMostBrush},
           {"lapses of a leech", static_cast<double>(settings.leech_lapses), 2, 100},
           {"misses before a hint", static_cast<double>(lesson.hint_after_misses), 1, 20},
           {"misses before the stroke is shown", static_cast<double>(lesson.show_after_misses),
            static_cast<double>(lesson.hint_after_misses), 20},
           {"help retained", lesson.help_retained, 0, 1},
           {"help per error", lesson.help_per_error, 0, 1},
           {"help that is over", lesson.help_is_over, 0, 1},
       }}) {
    if (auto fine = check_number(limit.name, limit.value, limit.lowest, limit.highest); !fine) return fine;
  }
  if (settings.new_lists.size() > kMostLists) {
    return base::fail(base::Errc::bad_argument, "too many lists", "lists of new characters",
                      "give at most 100");
  }
  return {};
}

}  // namespace

std::string_view name_of(NewOrder order) {
  switch (order) {
    case NewOrder::grade:
      return "grade";
    case NewOrder::frequency:
      return "frequency";
    case NewOrder::strokes:
      return "strokes";
    case NewOrder::components:
      return "components";
    case NewOrder::own:
      return "own";
  }
  return {};
}

std::optional<NewOrder> new_order_named(std::string_view name) { return value_named<NewOrder>(name); }

base::Result<void> check(const Settings& settings) {
  if (auto calendar = Calendar::create(settings.time_zone, settings.day_starts_at); !calendar) {
    return tl::unexpected(std::move(calendar.error()));
  }
  return check_rules(settings);
}

json::Value settings_json(const Settings& settings) {
  const LessonRules& lesson = settings.lesson;
  return {{"desired_retention", settings.fsrs.desired_retention},
          {"weights", settings.fsrs.weights},
          {"short_term_steps", settings.fsrs.short_term_steps},
          {"learning_steps_min", minutes_json(settings.fsrs.learning_steps)},
          {"relearning_steps_min", minutes_json(settings.fsrs.relearning_steps)},
          {"maximum_interval_days", settings.fsrs.maximum_interval_days},
          {"fuzz", settings.fuzz},
          {"load_balance", settings.load_balance},
          {"new_per_day", settings.new_per_day},
          {"reviews_per_day", settings.reviews_per_day},
          {"day_starts_at", settings.day_starts_at},
          {"time_zone", settings.time_zone},
          {"new_order", name_of(settings.new_order)},
          {"new_lists", settings.new_lists},
          {"brush_per_day", settings.brush_per_day},
          {"leech_lapses", settings.leech_lapses},
          {"hint_after_misses", lesson.hint_after_misses},
          {"show_after_misses", lesson.show_after_misses},
          {"help_retained", lesson.help_retained},
          {"help_per_error", lesson.help_per_error},
          {"help_is_over", lesson.help_is_over}};
}

Settings read_settings(json::Reader::Object object) {
  Settings settings;
  const auto whole = [&](const char* name, int& value, int lowest, int highest) {
    if (object.has(name)) value = static_cast<int>(object.whole(name, lowest, highest));
  };
  const auto number = [&](const char* name, double& value, double lowest, double highest) {
    if (object.has(name)) value = object.number(name, lowest, highest);
  };
  const auto truth = [&](const char* name, bool& value) {
    if (object.has(name)) value = object.truth(name);
  };
  number("desired_retention", settings.fsrs.desired_retention, kLowestRetention, kHighestRetention);
  if (object.has("weights")) read_weights(object, settings.fsrs.weights);
  truth("short_term_steps", settings.fsrs.short_term_steps);
  if (object.has("learning_steps_min")) {
    settings.fsrs.learning_steps = read_minutes(object, "learning_steps_min");
  }
  if (object.has("relearning_steps_min")) {
    settings.fsrs.relearning_steps = read_minutes(object, "relearning_steps_min");
  }
  whole("maximum_interval_days", settings.fsrs.maximum_interval_days, 1, 36'500);
  truth("fuzz", settings.fuzz);
  truth("load_balance", settings.load_balance);
  whole("new_per_day", settings.new_per_day, 0, 1'000);
  whole("reviews_per_day", settings.reviews_per_day, 1, 10'000);
  whole("day_starts_at", settings.day_starts_at, 0, 12);
  if (object.has("time_zone")) settings.time_zone = object.text("time_zone", 100);
  if (object.has("new_order")) {
    const std::string name = object.text("new_order", 40);
    if (const auto order = new_order_named(name)) {
      settings.new_order = *order;
    } else {
      object.refuse("new_order", "'" + name + "' is not an order",
                    "give grade, frequency, strokes, components or own");
    }
  }
  if (object.has("new_lists")) {
    settings.new_lists.clear();
    if (const json::Value* lists = object.array("new_lists")) {
      for (const json::Value& one : *lists) {
        if (!one.is_string() || settings.new_lists.size() >= kMostLists) {
          object.refuse("new_lists", "has an invalid list name, or too many");
          break;
        }
        settings.new_lists.push_back(one.get<std::string>());
      }
    }
  }
  whole("brush_per_day", settings.brush_per_day, 0, kMostBrush);
  whole("leech_lapses", settings.leech_lapses, 2, 100);
  whole("hint_after_misses", settings.lesson.hint_after_misses, 1, 20);
  whole("show_after_misses", settings.lesson.show_after_misses, 1, 20);
  number("help_retained", settings.lesson.help_retained, 0, 1);
  number("help_per_error", settings.lesson.help_per_error, 0, 1);
  number("help_is_over", settings.lesson.help_is_over, 0, 1);
  return settings;
}

std::string to_json(const Settings& settings) {
  return settings_json(settings).dump(-1, ' ', false, json::Value::error_handler_t::replace);
}

base::Result<Settings> parse_settings(std::string_view json) {
  const auto document = json::parse(json);
  if (!document) return tl::unexpected(document.error());
  json::Reader reader(json);
  Settings settings = read_settings(reader.root(*document));
  if (!reader.ok()) return tl::unexpected(reader.error());
  if (auto fine = check_rules(settings); !fine) return tl::unexpected(std::move(fine.error()));
  return settings;
}

}  // namespace nazori::study
