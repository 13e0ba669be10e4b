// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "nazori/base/clock.h"
#include "nazori/base/executor.h"
#include "nazori/practice/practice_stage.h"
#include "nazori/practice/writing_judge.h"

namespace nazori::practice {

/// What a stage is made with; all of it outlives the stage.
struct StageParts {
  base::Inbox& inbox;
  const base::Clock& clock;
  TabletControl& tablet;
  CharacterLibrary& library;
  WritingJudge& judge;
  std::function<bool(char32_t)> knows;  ///< whether the learner has studied a character; may be empty
};

/// A row of the table of stages.
struct StageKind {
  std::string_view id;  ///< in settings and data formats, never changed: "memory"
  /// The stage of a lesson that it is; nothing: only the learner chooses it.
  std::optional<study::Stage> lesson;
  std::unique_ptr<PracticeStage> (*make)(const StageParts& parts);
};

/// All stages, in the order in which they are offered: first those of a lesson, in its order.
[[nodiscard]] std::span<const StageKind> stage_kinds();

/// @return nullptr for a name that no stage has.
[[nodiscard]] const StageKind* stage_kind(std::string_view id);

/// The names of all stages, for a message: "watch, trace, guided or memory".
[[nodiscard]] std::string stage_names();

}  // namespace nazori::practice
