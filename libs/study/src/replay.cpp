// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "nazori/json/reader.h"

namespace nazori::study {
namespace {

constexpr json::Limits kLimits{.bytes = std::size_t{1} << 30};
constexpr double kSameTo8Decimals = 0.5e-8;

/// Whole days of 24 hours from `from` to `to`.
int full_days(Time from, Time to) {
  return static_cast<int>(
      std::max<std::int64_t>(0, std::chrono::floor<std::chrono::days>(to - from).count()));
}

void read_step(json::Reader::Object& object, std::vector<ReplayStep>& steps) {
  const std::string at = object.text("at", 40);
  ReplayStep step;
  step.rating = static_cast<Rating>(
      object.whole("rating", static_cast<int>(kRatings.front()), static_cast<int>(kRatings.back())));
  if (auto time = parse_time(at)) {
    step.at = *time;
    if (!steps.empty() && step.at < steps.back().at) {
      object.refuse("at", at + " is before the review that precedes it", "sort the steps by time");
    }
  } else {
    object.refuse("at", "'" + at + "' " + time.error().what, time.error().remedy);
  }
  steps.push_back(step);
}

ReplayCase read_case(json::Reader::Object& object) {
  ReplayCase one;
  one.desired_retention = object.number("request_retention", kLowestRetention, kHighestRetention);
  if (object.has("short_term_steps")) one.short_term_steps = object.truth("short_term_steps");
  object.each("steps", [&](json::Reader::Object& step) { read_step(step, one.steps); });
  return one;
}

void schedule(ReplayCase& one, const Fsrs& fsrs) {
  Memory memory;
  for (ReplayStep& step : one.steps) {
    int elapsed_days = 0;
    if (memory.last_review) {
      // The reference takes full days for the chance it reports, dates for the step itself.
      step.retrievability_before =
          fsrs.retrievability(memory.stability, full_days(*memory.last_review, step.at));
      elapsed_days = static_cast<int>((utc_day(step.at) - utc_day(*memory.last_review)).count());
    }
    memory = fsrs.next(memory, step.rating, step.at, elapsed_days);
    step.after = memory;
  }
}

/// A whole number without ".0", as other programs write it.
json::Value number(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;
}

}  // namespace

base::Result<Replay> replay_histories(std::string_view json, const base::Progress& progress) {
  const auto document = json::parse(json, kLimits);
  if (!document) return tl::unexpected(document.error());
  json::Reader reader(json);
  json::Reader::Object root = reader.root(*document);
  Replay replay;
  if (root.has("version")) (void)root.whole("version", 1, kReplayVersion);
  if (root.has("weights")) {
    std::vector<double> numbers;
    if (const json::Value* list = root.array("weights")) {
      for (const json::Value& one : *list) numbers.push_back(one.is_number() ? one.get<double>() : NAN);
    }
    if (const auto weights = weights_from(numbers)) {
      replay.weights = *weights;
    } else {
      root.refuse("weights", weights.error().what, weights.error().remedy);
    }
  }
  root.each("cases", [&](json::Reader::Object& object) { replay.cases.push_back(read_case(object)); });
  if (!reader.ok()) return tl::unexpected(reader.error());
  for (std::size_t i = 0; i < replay.cases.size(); ++i) {
    ReplayCase& one = replay.cases[i];
    if (progress && !progress(static_cast<double>(i) / static_cast<double>(replay.cases.size()), "replay")) {
      return base::fail(base::Errc::cancelled, "stopped");
    }
    FsrsSettings settings;
    settings.weights = replay.weights;
    settings.desired_retention = one.desired_retention;
    settings.short_term_steps = one.short_term_steps;
    const auto fsrs = Fsrs::create(settings);
    if (!fsrs) return tl::unexpected(fsrs.error());
    schedule(one, *fsrs);
  }
  return replay;
}

std::string to_json(const Replay& replay) {
  json::Value root;
  root["version"] = kReplayVersion;
  root["algorithm"] =
      "FSRS-6, no fuzz, learning steps 1 min and 10 min, relearning step 10 min, maximum interval 36500 days";
  root["weights"] = replay.weights;
  root["cases"] = json::Value::array();
  for (const ReplayCase& one : replay.cases) {
    json::Value steps = json::Value::array();
    for (const ReplayStep& step : one.steps) {
      steps.push_back({{"at", to_text(step.at)},
                       {"rating", static_cast<int>(step.rating)},
                       {"retrievability_before",
                        step.retrievability_before ? number(*step.retrievability_before) : json::Value()},
                       {"stability", number(step.after.stability)},
                       {"difficulty", number(step.after.difficulty)},
                       {"state", name_of(step.after.phase)},
                       {"scheduled_days", step.after.scheduled_days},
                       {"due", to_text(step.after.due)},
                       {"reps", step.after.reps},
                       {"lapses", step.after.lapses}});
    }
    root["cases"].push_back({{"request_retention", one.desired_retention},
                             {"short_term_steps", one.short_term_steps},
                             {"steps", std::move(steps)}});
  }
  return root.dump(1) + "\n";
}

base::Result<ReplayDifferences> compare_with_own_numbers(std::string_view json, const Replay& replay) {
  const auto document = json::parse(json, kLimits);
  if (!document) return tl::unexpected(document.error());
  json::Reader reader(json);
  json::Reader::Object root = reader.root(*document);
  ReplayDifferences differences;
  std::size_t case_index = 0;
  root.each("cases", [&](json::Reader::Object& one) {
    if (case_index >= replay.cases.size()) return;
    const ReplayCase& computed = replay.cases[case_index++];
    std::size_t step_index = 0;
    one.each("steps", [&](json::Reader::Object& step) {
      if (step_index >= computed.steps.size()) return;
      const ReplayStep& own = computed.steps[step_index++];
      if (!step.has("stability")) return;
      ++differences.steps;
      bool differs = false;
      const auto compare = [&](double theirs, double ours, double& largest) {
        const double difference = std::abs(theirs - ours);
        largest = std::max(largest, difference);
        differs = differs || difference >= kSameTo8Decimals;
      };
      compare(step.number("stability", 0, 1e6), own.after.stability, differences.stability);
      compare(step.number("difficulty", 0, 1e6), own.after.difficulty, differences.difficulty);
      if (step.has("retrievability_before")) {
        compare(step.number("retrievability_before", 0, 1), own.retrievability_before.value_or(-1),
                differences.retrievability);
      }
      const auto days = static_cast<int>(step.whole("scheduled_days", 0, 1'000'000));
      differences.scheduled_days =
          std::max(differences.scheduled_days, std::abs(days - own.after.scheduled_days));
      differs = differs || days != own.after.scheduled_days;
      const std::string due = step.text("due", 40);
      if (const auto time = parse_time(due)) {
        compare(0, std::chrono::duration<double>(*time - own.after.due).count(), differences.due_s);
      } else {
        step.refuse("due", "'" + due + "' " + time.error().what, time.error().remedy);
      }
      if (step.text("state", 20) != name_of(own.after.phase) ||
          step.whole("reps", 0, 1'000'000) != own.after.reps ||
          step.whole("lapses", 0, 1'000'000) != own.after.lapses) {
        ++differences.states;
        differs = true;
      }
      if (differs && differences.first.empty()) {
        differences.first = fmt::format("case {}, step {}", case_index, step_index);
      }
    });
  });
  if (!reader.ok()) return tl::unexpected(reader.error());
  return differences;
}

}  // namespace nazori::study
