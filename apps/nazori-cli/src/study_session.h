// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "characters.h"
#include "console.h"
#include "json_answers.h"
#include "nazori/study/character_lists.h"
#include "nazori/study/day_plan.h"
#include "nazori/study/learner_store.h"
#include "stop.h"
#include "verbs.h"

namespace nazori::cli {

/// The options of every subcommand of `study`.
struct StudyOptions {
  std::string profile;
  std::string learners;
  std::string now;
  std::string database;
  double wait_s = 0;  ///< time to wait for another program that has the learner open
  bool json = false;
};

/// --profile, --learners, --now, --json.
void add_learner_options(CLI::App& verb, StudyOptions& options);
/// The same and --wait, for commands that change a learner.
void add_writer_options(CLI::App& verb, StudyOptions& options);

/// Adds a subcommand to `study`. @param footer  of its help.
[[nodiscard]] CLI::App* add_study_verb(CLI::App& study, const char* name, const char* description,
                                       const char* footer);

/// The folder of learners, and the chosen learner.
[[nodiscard]] base::Result<std::filesystem::path> learners_folder(const StudyOptions& options);
[[nodiscard]] base::Result<std::filesystem::path> learner_path(const StudyOptions& options);
/// The computer's clock, or a fixed one at --now.
[[nodiscard]] base::Result<study::Clock> study_clock(const StudyOptions& options);
[[nodiscard]] base::Result<study::LearnerStore> open_learner(const StudyOptions& options,
                                                             study::Access access);

/// Repeats `work` until no other program has the learner open, at most for the time of --wait.
/// @param work  returns a base::Result. @return its last result; Errc::cancelled.
template <class Work>
[[nodiscard]] auto when_free(const StudyOptions& options, Work work) -> decltype(work()) {
  const auto begin = std::chrono::steady_clock::now();
  for (;;) {
    auto done = work();
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - begin;
    if (done || done.error().code != base::Errc::in_use || waited.count() >= options.wait_s) return done;
    if (stop_requested()) return base::fail(base::Errc::cancelled, "stopped", "--wait");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

/// For commands that need an existing learner: a mistyped name must not become a new learner.
/// @return the exit code if the learner has no file.
[[nodiscard]] std::optional<int> refuse_missing(Console& console, const StudyOptions& options);

/// A learner with the kanji database, for what needs both.
class StudySession {
 public:
  [[nodiscard]] static base::Result<StudySession> open(const StudyOptions& options, study::Access access);
  [[nodiscard]] study::LearnerStore& learner() { return learner_; }
  [[nodiscard]] const kanji::KanjiDatabase& database() const { return *database_; }
  [[nodiscard]] study::CharacterLists& lists() { return *lists_; }
  [[nodiscard]] base::Result<study::DayPlan> plan();
  /// The characters named by arguments: characters, or a list as "list:NAME", "grade-1" and so on. All must
  /// have strokes.
  [[nodiscard]] base::Result<std::vector<char32_t>> characters(const std::vector<std::string>& arguments);

 private:
  StudySession(study::LearnerStore learner, kanji::KanjiDatabase database);
  study::LearnerStore learner_;
  std::unique_ptr<kanji::KanjiDatabase> database_;
  std::unique_ptr<study::CharacterLists> lists_;
};

/// "1 character", "3 characters", "2 entries". @param several  if it is not `one` with an s.
[[nodiscard]] std::string counted(std::int64_t count, std::string_view one, std::string_view several = {});
/// "in 10 min", "in 4 days", for people.
[[nodiscard]] std::string wait_text(const study::Card& card, study::Time now, study::Day today);
/// "6 min", "1 h 20 min".
[[nodiscard]] std::string duration_text(std::chrono::milliseconds duration);

// The subcommands of `study`, each group in its own file.
void add_study_day(CLI::App& study, Action& chosen);     ///< due, next
void add_study_review(CLI::App& study, Action& chosen);  ///< review, undo
void add_study_changes(CLI::App& study,
                       Action& chosen);  ///< know, postpone, pause, resume, reset, leech, settings
void add_study_stats(CLI::App& study, Action& chosen);  ///< stats, workload
void add_study_lists(CLI::App& study, Action& chosen);  ///< lists, profiles
void add_study_files(CLI::App& study, Action& chosen);  ///< export, import, backup, restore, rebuild, replay

}  // namespace nazori::cli
