// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "nazori/base/result.h"
#include "nazori/exchange/document.h"
#include "nazori/practice/session_feedback.h"
#include "nazori/practice/stage_feedback.h"
#include "nazori/study/card.h"

namespace nazori::exchange {

/// A character is on the tablet.
struct CharacterShown {
  char32_t character = 0;
  int strokes = 0;
  std::string stage;  ///< practice::StageKind::id
};

/// What a stage reports.
struct StageReport {
  std::string stage;  ///< practice::StageKind::id
  practice::StageFeedback feedback;
  practice::StageDetails details;  ///< what only this stage has to tell: practice::PracticeStage::details()
};

/// A character was practised to the end of a stage.
struct StageFinished {
  std::string stage;  ///< practice::StageKind::id
};

/// How far a study session is.
struct SessionProgress {
  /// While the session runs.
  struct Task {
    char32_t character = 0;
    study::Stage stage = study::Stage::watch;
    int done = 0;
    int total = 0;
  };
  practice::SessionState state = practice::SessionState::idle;
  std::optional<Task> task;
  std::optional<study::Rating> proposed;  ///< when judged
};

// Events of practice: each is an object with "event" (docs/schemas/practice.json, event).
[[nodiscard]] Value to_json(const CharacterShown& event);
[[nodiscard]] Value to_json(const StageReport& event);
[[nodiscard]] Value to_json(const StageFinished& event);
[[nodiscard]] Value to_json(const SessionProgress& event);
[[nodiscard]] Value to_json(const practice::SessionFeedback& event);
/// Something failed that no stage reports: the database cannot be read.
[[nodiscard]] Value error_event(const base::Error& error);

/// A failure that no stage reported.
struct FailureEvent {
  std::string line;  ///< what is wrong, where, and what would be right
};
/// Any event of practice.
using PracticeEvent = std::variant<CharacterShown, StageReport, StageFinished, SessionProgress,
                                   practice::SessionFeedback, FailureEvent>;
/// Reads docs/schemas/practice.json, event: all that it holds. Of a mistake it holds the kind, of an error
/// its line. Names of a stage's own events and details are parts of `event`, which must outlive the answer.
/// @return Errc::parse with the member in Error::where.
[[nodiscard]] base::Result<PracticeEvent> read_practice_event(const Value& event);
/// An event that read_practice_event() gave.
[[nodiscard]] Value to_json(const PracticeEvent& event);

/// One line of events (docs/schemas/practice.json, events). @param events  an array.
[[nodiscard]] Value events_document(Value events);

}  // namespace nazori::exchange
