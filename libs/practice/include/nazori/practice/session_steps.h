// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "nazori/practice/study_session.h"

namespace nazori::practice {

/// How far a session is.
struct SessionProgress {
  int at = 0;            ///< the present character, from 1; never more than `total`
  int done = 0;          ///< characters that are finished
  int total = 0;         ///< characters of the session, as far as is known now
  int minutes_left = 0;  ///< rounded up; 0: less than half a minute

  friend bool operator==(const SessionProgress&, const SessionProgress&) = default;
};
[[nodiscard]] SessionProgress progress_of(const StudySession& session);

/// What Enter does now. There is never more than one next step.
enum class NextStep : std::uint8_t {
  none,            ///< the stage is not done yet, and Enter has nothing to do
  finish_writing,  ///< has the writing checked
  stage,           ///< goes to StudySession::stage()
  rate,            ///< takes the suggested rating
  next_character,  ///< the present one is done
  go_back,         ///< to the character that the session asks for
};
/// @param has_unjudged  something is written that is not checked as a whole.
[[nodiscard]] NextStep next_step(const StudySession& session, bool has_unjudged);

/// Whether the tablet needs the room of the panels beside it: while something is to be written. The list
/// comes back with the end of the session, the information also with a verdict. In the lesson of a difficult
/// character the information stays.
struct FoldedPanels {
  bool list = false;
  bool information = false;

  friend bool operator==(const FoldedPanels&, const FoldedPanels&) = default;
};
[[nodiscard]] FoldedPanels folded_panels(const StudySession& session);

}  // namespace nazori::practice
