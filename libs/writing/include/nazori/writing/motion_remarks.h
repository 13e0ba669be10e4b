// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "nazori/writing/explanation.h"
#include "nazori/writing/grade.h"
#include "nazori/writing/model.h"
#include "nazori/writing/pen_motion.h"

namespace nazori::writing {

/// What the motion of the pen tells a learner. None of it keeps writing from being accepted.
enum class MotionRemarkKind : std::uint8_t {
  paused,       ///< the pen rested within the stroke
  hesitant,     ///< the stroke was made of many short moves
  not_stopped,  ///< it ends with a stop (tome); the pen was lifted while it moved
  not_swept,    ///< it is swept out (harai); the pen came to rest first
  kick_held,    ///< it ends with a kick (hane); the pen came to rest after it
  heavy_end,    ///< it is swept out; the pressure did not fade
  light_end,    ///< it ends with a stop; the pressure had faded before
};

/// One thing to say about how a stroke was written.
struct MotionRemark {
  MotionRemarkKind kind = MotionRemarkKind::paused;
  int stroke = 0;     ///< drawn stroke, from 0
  int model = 0;      ///< the stroke of the model it is, from 0
  double amount = 0;  ///< paused: seconds of the longest rest; hesitant: how many moves

  friend bool operator==(const MotionRemark&, const MotionRemark&) = default;
};

/// What is worth saying, by stroke, at most one remark on the flow of a stroke and one on its ending. Only
/// strokes that were recognised are spoken of, of their endings only where they are right and the ending is
/// not officially free. Peaks of speed are counted against the turns of the model: corners slow every hand
/// down. Pressure is spoken of only where the pen has one that varies; that of a mouse does not. Thread-safe.
/// @param motions  pen_motion() of the ink that was graded.
[[nodiscard]] std::vector<MotionRemark> motion_remarks(std::span<const PenMotion> motions, const Grade& grade,
                                                       const Model& model);

/// One sentence for each kind of remark that is among them, with the strokes it is about; they have the
/// model's numbers, from 1. "Sweep out strokes 1, 5 and 6: lift the pen while it still moves."
[[nodiscard]] std::vector<std::string> explain(std::span<const MotionRemark> remarks, Language language);

/// How all of it was written, as a sentence: "Written in 5.2 seconds; 5 of 6 strokes flowed." Empty where
/// nothing was timed.
[[nodiscard]] std::string explain_pace(std::span<const PenMotion> motions,
                                       std::span<const MotionRemark> remarks, Language language);

}  // namespace nazori::writing
