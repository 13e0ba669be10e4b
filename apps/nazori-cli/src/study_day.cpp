// SPDX-License-Identifier: Apache-2.0
// study due, study next
#include <fmt/format.h>

#include <memory>

#include "nazori/base/utf8.h"
#include "study_session.h"
#include "text_layout.h"

namespace nazori::cli {
namespace {

using study::DayPlan;
using study::TaskKind;

Json plan_json(const DayPlan& plan) {
  Json now = Json::array();
  for (const auto& task : plan.now) now.push_back(task_json(task));
  Json later = Json::array();
  for (const auto& task : plan.later_today) later.push_back(task_json(task));
  Json leeches = Json::array();
  for (const char32_t one : plan.leeches) leeches.push_back(base::encode_utf8(one));
  Json gentle;
  if (plan.gentle) {
    gentle = {{"overdue", plan.gentle->overdue},
              {"per_day", plan.gentle->per_day},
              {"days", plan.gentle->days},
              {"last_day", study::to_text(plan.gentle->last_day)}};
  }
  return {{"day", study::to_text(plan.day)},
          {"steps", plan.count(TaskKind::step)},
          {"reviews", plan.count(TaskKind::review)},
          {"new", plan.count(TaskKind::fresh)},
          {"held_back", plan.held_back},
          {"reviews_done", plan.reviews_done},
          {"new_done", plan.new_done},
          {"estimate_ms", plan.estimate.count()},
          {"gentle_plan", std::move(gentle)},
          {"leeches", std::move(leeches)},
          {"now", std::move(now)},
          {"later_today", std::move(later)}};
}

std::string characters_line(const DayPlan& plan, TaskKind kind) {
  std::vector<std::string> characters;
  for (const auto& task : plan.now) {
    if (task.kind == kind) characters.push_back(base::encode_utf8(task.character));
  }
  return characters.empty() ? std::string() : "  " + flow(characters, " ", 14, text_width());
}

int due(Console& console, const StudyOptions& options) {
  auto session = StudySession::open(options, study::Access::read);
  if (!session) return console.refuse(session.error());
  const auto plan = session->plan();
  if (!plan) return console.refuse(plan.error());
  if (options.json) {
    console.print(to_text(plan_json(*plan)));
    return kDone;
  }
  if (plan->now.empty()) {
    console.print(fmt::format("{}: nothing is due\n", study::to_text(plan->day)));
  } else {
    console.print(fmt::format("{}: {} due, about {}\n", study::to_text(plan->day), plan->now.size(),
                              duration_text(plan->estimate)));
    for (const auto& [kind, name] :
         {std::pair(TaskKind::step, "steps"), std::pair(TaskKind::review, "reviews"),
          std::pair(TaskKind::fresh, "new")}) {
      if (plan->count(kind) > 0) {
        console.print(fmt::format("{:8}{:4}{}\n", name, plan->count(kind), characters_line(*plan, kind)));
      }
    }
  }
  if (!plan->later_today.empty()) {
    const auto wait =
        std::chrono::ceil<std::chrono::minutes>(plan->later_today.front().due - session->learner().now());
    console.print(
        fmt::format("later today {}, the next in {} min\n", plan->later_today.size(), wait.count()));
  }
  if (plan->gentle) {
    console.print(fmt::format(
        "{} wait; {} today and as the days allow, all is caught up by {} ({}), nothing new until then\n",
        plan->gentle->overdue, plan->gentle->per_day, study::to_text(plan->gentle->last_day),
        counted(plan->gentle->days, "day")));
  }
  if (!plan->leeches.empty()) {
    console.print(
        fmt::format("{} set apart, often forgotten: nazori-cli study leech\n", plan->leeches.size()));
  }
  return kDone;
}

int next(Console& console, const StudyOptions& options) {
  auto session = StudySession::open(options, study::Access::read);
  if (!session) return console.refuse(session.error());
  const auto plan = session->plan();
  if (!plan) return console.refuse(plan.error());
  if (plan->now.empty()) {
    if (options.json) console.print("null\n");
    return console.deny({base::Errc::not_found, "nothing is due", "", ""});
  }
  const study::StudyTask& task = plan->now.front();
  const study::LearnerStore& learner = session->learner();
  Json ratings = Json::object();
  std::string line;
  for (const study::Rating rating : study::kRatings) {
    const auto preview = learner.preview(task.character, rating);
    if (!preview) return console.refuse(preview.error());
    const study::Card& after = *preview;
    const std::string wait = wait_text(after, learner.now(), learner.today());
    ratings[std::string(study::name_of(rating))] = {
        {"due", study::to_text(after.memory.due)},
        {"due_day", after.due_day ? Json(study::to_text(*after.due_day)) : Json()}};
    line += fmt::format("{}{} {}", line.empty() ? "" : " · ", study::name_of(rating), wait);
  }
  if (options.json) {
    Json json = task_json(task);
    json["ratings"] = std::move(ratings);
    console.print(to_text(json));
    return kDone;
  }
  console.print(
      fmt::format("{}  {}\n{}\n", base::encode_utf8(task.character), study::name_of(task.stage), line));
  return kDone;
}

}  // namespace

void add_study_day(CLI::App& study, Action& chosen) {
  auto add = [&](const char* name, const char* description, const char* footer, auto run) {
    auto options = std::make_shared<StudyOptions>();
    CLI::App* verb = add_study_verb(study, name, description, footer);
    add_learner_options(*verb, *options);
    verb->add_option("--database", options->database, "The kanji database to read")->type_name("FILE");
    verb->callback([options, &chosen, run] {
      chosen = [options, run](Console& console) { return run(console, *options); };
    });
  };
  add("due", "Tell what is due today and how long it will take",
      "Examples:\n  nazori-cli study due\n  nazori-cli study due --now 2026-01-08T09:00+09:00 --json", due);
  add("next", "Tell the next character, its stage, and when each rating would bring it back",
      "Exit code 1 where nothing is due.\n\nExample:\n  nazori-cli study next --json", next);
}

}  // namespace nazori::cli
