// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "nazori/base/result.h"
#include "nazori/exchange/document.h"
#include "nazori/study/card.h"
#include "nazori/writing/written_character.h"

namespace nazori::exchange {

/// Going to a stage of practice.
struct StageChoice {
  std::string stage;  ///< practice::StageKind::id: "watch", "dictation", ...

  friend bool operator==(const StageChoice&, const StageChoice&) = default;
};

/// Something that the current stage or the session can do. Which names there are depends on the stage.
struct PracticeCommand {
  std::string name;  ///< "hint", "go_on", ...

  friend bool operator==(const PracticeCommand&, const PracticeCommand&) = default;
};

/// What a learner does in practice: writes, goes to a stage, rates, or gives a command.
using PracticeRequest = std::variant<writing::WrittenCharacter, StageChoice, study::Rating, PracticeCommand>;

/// Reads docs/schemas/practice.json, request: "strokes" as read_handwriting() does, else "do", else "stage".
/// @return Errc::parse where nothing is asked for, the errors of read_handwriting().
[[nodiscard]] base::Result<PracticeRequest> read_practice_request(const Value& request);
/// An object that read_practice_request() reads back.
[[nodiscard]] Value to_json(const PracticeRequest& request);

}  // namespace nazori::exchange
