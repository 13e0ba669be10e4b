// SPDX-License-Identifier: Apache-2.0
#include "study_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "nazori/study/profiles.h"
#include "options.h"

namespace nazori::cli {

using study::LearnerStore;

void add_learner_options(CLI::App& verb, StudyOptions& options) {
  const std::string group = "Learner";
  verb.add_option("--profile", options.profile, "Profile to use (default: learner)")
      ->type_name("NAME")
      ->group(group);
  verb.add_option(
          "--learners", options.learners,
          "Folder of all profiles (default: NAZORI_LEARNERS, otherwise nazori/learners in XDG_DATA_HOME)")
      ->type_name("FOLDER")
      ->group(group);
  verb.add_option("--now", options.now, "Use this as the current time: 2026-01-01T09:00Z or with +09:00")
      ->type_name("TIME")
      ->group(group);
  verb.add_flag("--json", options.json, "Print JSON (see docs/command-line.md)");
}

void add_writer_options(CLI::App& verb, StudyOptions& options) {
  add_learner_options(verb, options);
  verb.add_option("--wait", options.wait_s,
                  "Where another program has the learner open, wait so long for it (exit code 3 after that)")
      ->check(within(0, 86'400))
      ->capture_default_str()
      ->type_name("SECONDS")
      ->group("Learner");
}

CLI::App* add_study_verb(CLI::App& study, const char* name, const char* description, const char* footer) {
  CLI::App* verb = study.add_subcommand(name, description);
  verb->footer(footer);
  return verb;
}

base::Result<std::filesystem::path> learners_folder(const StudyOptions& options) {
  auto folder = options.learners.empty() ? study::profiles_folder()
                                         : base::Result<std::filesystem::path>(options.learners);
  std::error_code ignored;
  if (folder && std::filesystem::exists(*folder, ignored) &&
      !std::filesystem::is_directory(*folder, ignored)) {
    return base::fail(base::Errc::bad_argument, "is a file, not a folder", folder->string(),
                      "give the folder of all learners");
  }
  return folder;
}

base::Result<std::filesystem::path> learner_path(const StudyOptions& options) {
  const auto folder = learners_folder(options);
  if (!folder) return tl::unexpected(folder.error());
  return study::learner_file(
      *folder, options.profile.empty() ? study::kDefaultProfile : std::string_view(options.profile));
}

base::Result<study::Clock> study_clock(const StudyOptions& options) {
  if (options.now.empty()) return study::environment_clock();
  const auto now = study::parse_time(options.now);
  if (!now) return tl::unexpected(now.error());
  return study::Clock([now = *now] { return now; });
}

base::Result<LearnerStore> open_learner(const StudyOptions& options, study::Access access) {
  const auto path = learner_path(options);
  if (!path) return tl::unexpected(path.error());
  const auto clock = study_clock(options);
  if (!clock) return tl::unexpected(clock.error());
  auto learner = when_free(options, [&] { return LearnerStore::open(*path, access, *clock); });
  if (learner && learner->backup_trouble()) {
    base::Error trouble = *learner->backup_trouble();
    trouble.what = "today's backup could not be made: " + trouble.what;
    (void)std::fputs(("nazori-cli study: " + base::to_line(trouble) + "\n").c_str(), stderr);
  }
  return learner;
}

std::optional<int> refuse_missing(Console& console, const StudyOptions& options) {
  const auto path = learner_path(options);
  if (!path) return console.refuse(path.error());
  std::error_code error;
  if (std::filesystem::exists(*path, error)) return std::nullopt;
  return console.deny({base::Errc::not_found, "nothing studied yet", path->string(), ""});
}

StudySession::StudySession(LearnerStore learner, kanji::KanjiDatabase database)
    : learner_(std::move(learner)),
      database_(std::make_unique<kanji::KanjiDatabase>(std::move(database))),
      lists_(std::make_unique<study::CharacterLists>(*database_)) {}

base::Result<StudySession> StudySession::open(const StudyOptions& options, study::Access access) {
  auto database = open_database(options.database);
  if (!database) return tl::unexpected(std::move(database.error()));
  auto learner = open_learner(options, access);
  if (!learner) return tl::unexpected(std::move(learner.error()));
  return StudySession(*std::move(learner), *std::move(database));
}

base::Result<study::DayPlan> StudySession::plan() {
  const auto order = lists_->in_learning_order(learner_.settings(), learner_);
  if (!order) return tl::unexpected(order.error());
  return study::plan_day(learner_, *order);
}

base::Result<std::vector<char32_t>> StudySession::characters(const std::vector<std::string>& arguments) {
  std::vector<char32_t> characters;
  std::vector<std::string> named;
  for (const std::string& argument : arguments) {
    const auto ready = study::ready_lists();
    const bool list =
        argument.starts_with("list:") || argument.starts_with("tag:") ||
        std::any_of(ready.begin(), ready.end(), [&](const auto& one) { return one.id == argument; });
    if (!list) {
      named.push_back(argument);
      continue;
    }
    const auto members = lists_->members(argument, learner_);
    if (!members) return tl::unexpected(members.error());
    characters.insert(characters.end(), members->begin(), members->end());
  }
  if (!named.empty()) {
    const auto names = kanji::parse_characters(named);
    if (!names) return tl::unexpected(names.error());
    std::vector<CharacterName> missing;
    for (const CharacterName& name : *names) {
      if (lists_->facts(name.code_point) == nullptr) missing.push_back(name);
      characters.push_back(name.code_point);
    }
    if (!missing.empty()) return tl::unexpected(not_found(missing));
  }
  return characters;
}

std::string counted(std::int64_t count, std::string_view one, std::string_view several) {
  if (count == 1) return fmt::format("1 {}", one);
  return several.empty() ? fmt::format("{} {}s", count, one) : fmt::format("{} {}", count, several);
}

std::string wait_text(const study::Card& card, study::Time now, study::Day today) {
  if (card.due_day) {
    const auto days = (*card.due_day - today).count();
    if (days <= 0) return "today";
    return "in " + counted(days, "day");
  }
  const auto minutes = std::chrono::ceil<std::chrono::minutes>(card.memory.due - now).count();
  return minutes <= 0 ? "now" : fmt::format("in {} min", minutes);
}

std::string duration_text(std::chrono::milliseconds duration) {
  const auto minutes = std::chrono::ceil<std::chrono::minutes>(duration).count();
  if (minutes < 60) return fmt::format("{} min", minutes);
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

void add_study(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand(
      "study", "Study characters by spaced repetition: due characters, reviews, statistics");
  verb->require_subcommand(1);
  verb->footer(
      "Examples:\n  nazori-cli study due\n  nazori-cli study review 休 --rating good\n"
      "  nazori-cli study export --output me.json");
  add_study_day(*verb, chosen);
  add_study_review(*verb, chosen);
  add_study_changes(*verb, chosen);
  add_study_stats(*verb, chosen);
  add_study_lists(*verb, chosen);
  add_study_files(*verb, chosen);
}

}  // namespace nazori::cli
