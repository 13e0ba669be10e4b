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

/// Kinds of remarks about the motion of the pen. None of them keeps a writing from being accepted.
enum class MotionRemarkKind : std::uint8_t {
  paused,       ///< the pen rested within the stroke
  hesitant,     ///< the stroke was made of many short moves
  not_stopped,  ///< it should end with a stop (tome); the pen was lifted while it moved
  not_swept,    ///< it should end with a sweep (harai); the pen came to rest first
  kick_held,    ///< it should end with a hook (hane); the pen came to rest after it
  heavy_end,    ///< it should end with a sweep; the pressure did not fade
  light_end,    ///< it should end with a stop; the pressure had faded before
};

/// One remark about the motion in a stroke.
struct MotionRemark {
  MotionRemarkKind kind = MotionRemarkKind::paused;
  int stroke = 0;     ///< drawn stroke, from 0
  int model = 0;      ///< the stroke of the model it is, from 0
  double amount = 0;  ///< paused: seconds of the longest rest; hesitant: number of moves

  friend bool operator==(const MotionRemark&, const MotionRemark&) = default;
};

/// The remarks that are worth making, by stroke: at most one on the flow of a stroke and one on its ending.
/// There are remarks only on recognised strokes, and on endings only if the stroke is right and the ending is
/// not officially free. Peaks of speed are compared with the turns of the model, because every hand slows
/// down at corners. Pressure counts only if it varies; that of a mouse does not. Thread-safe.
/// @param motions  pen_motion() of the ink that was graded.
[[nodiscard]] std::vector<MotionRemark> motion_remarks(std::span<const PenMotion> motions, const Grade& grade,
                                                       const Model& model);

/// One sentence for each kind among the remarks, with the numbers of its strokes in the model, from 1. "Sweep
/// out strokes 1, 5 and 6: lift the pen while it still moves."
[[nodiscard]] std::vector<std::string> explain(std::span<const MotionRemark> remarks, Language language);

/// A sentence about the motion of the whole writing: "Written in 5.2 seconds; 5 of 6 strokes flowed." Empty
/// where nothing was timed.
[[nodiscard]] std::string explain_pace(std::span<const PenMotion> motions,
                                       std::span<const MotionRemark> remarks, Language language);

}  // namespace nazori::writing
