// SPDX-License-Identifier: Apache-2.0
// study due, study next
#include <fmt/format.h>

#include <memory>

#include "characters.h"
#include "nazori/base/utf8.h"
#include "nazori/exchange/cards.h"
#include "study_session.h"
#include "text_layout.h"

namespace nazori::cli {
namespace {

using study::DayPlan;
using study::TaskKind;

std::string characters_line(const DayPlan& plan, TaskKind kind) {
  std::vector<std::string> characters;
  for (const auto& task : plan.now) {
    if (task.kind == kind) characters.push_back(letter(task.character));
  }
  return characters.empty() ? std::string() : "  " + flow(characters, " ", 14, text_width());
}

int due(Console& console, const StudyOptions& options) {
  auto session = StudySession::open(options, study::Access::read);
  if (!session) return console.refuse(session.error());
  const auto plan = session->plan();
  if (!plan) return console.refuse(plan.error());
  if (options.json) {
    console.print(to_text(exchange::to_json(*plan)));
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
        fmt::format("{} later today, the next in {} min\n", plan->later_today.size(), wait.count()));
  }
  if (plan->gentle) {
    console.print(
        fmt::format("{} waiting; do {} today, and you will catch up by {} ({}); nothing new until then\n",
                    plan->gentle->overdue, plan->gentle->per_day, study::to_text(plan->gentle->last_day),
                    counted(plan->gentle->days, "day")));
  }
  if (!plan->brush.empty()) {
    console.print(fmt::format("with the brush: {}\n",
                              base::encode_utf8(std::u32string(plan->brush.begin(), plan->brush.end()))));
  }
  if (!plan->leeches.empty()) {
    console.print(
        fmt::format("{} difficult, forgotten too often: nazori-cli study leech\n", plan->leeches.size()));
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
  std::vector<std::pair<study::Rating, study::Card>> ratings;
  std::string line;
  for (const study::Rating rating : study::kRatings) {
    const auto preview = learner.preview(task.character, rating);
    if (!preview) return console.refuse(preview.error());
    const study::Card& after = *preview;
    const std::string wait = wait_text(after, learner.now(), learner.today());
    ratings.emplace_back(rating, after);
    line += fmt::format("{}{} {}", line.empty() ? "" : " · ", study::name_of(rating), wait);
  }
  if (options.json) {
    console.print(to_text(exchange::next_task(task, ratings)));
    return kDone;
  }
  console.print(fmt::format("{}  {}\n{}\n", letter(task.character), study::name_of(task.stage), line));
  return kDone;
}

}  // namespace

void add_study_day(CLI::App& study, Action& chosen) {
  auto add = [&](const char* name, const char* description, const char* footer, auto run) {
    auto options = std::make_shared<StudyOptions>();
    CLI::App* verb = add_study_verb(study, name, description, footer);
    add_learner_options(*verb, *options);
    verb->add_option("--database", options->database, "Kanji database to use")->type_name("FILE");
    verb->callback([options, &chosen, run] {
      chosen = [options, run](Console& console) { return run(console, *options); };
    });
  };
  add("due", "Show what is due today and how long it will take",
      "Examples:\n  nazori-cli study due\n  nazori-cli study due --now 2026-01-08T09:00+09:00 --json", due);
  add("next", "Show the next character, its stage, and when it comes back after each rating",
      "Exit code 1 if nothing is due.\n\nExample:\n  nazori-cli study next --json", next);
}

}  // namespace nazori::cli
