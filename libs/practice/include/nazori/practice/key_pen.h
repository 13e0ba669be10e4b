// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "nazori/functions/sound.h"
#include "nazori/geometry/frames.h"
#include "nazori/practice/key_pen_ground.h"

namespace nazori::practice {

/// Where the pen is that is moved by key.
struct KeyPenPlace {
  geometry::TabletPoint at{0, 0};
  bool is_down = false;
  double depth = 0;  ///< of the relief under it: 0 on the plateau, 1 at the bottom of the deepest groove
  int stroke = 0;    ///< whose centre line is within reach, from 1; 0: none
  double along = 0;  ///< share of that stroke's length, 0 at its start to 1 at its end
  double from_left = 0.5;  ///< share of the ground's side
  double from_top = 0.5;
};

/// What a key did to the pen.
enum class KeyPenDid : std::uint8_t {
  moved,        ///< nothing worth announcing
  met_stroke,   ///< it came within reach of another stroke, not at one of its ends
  at_start,     ///< it reached the start of a stroke
  at_end,       ///< it reached the end of a stroke
  left_stroke,  ///< no stroke is within reach any more
  at_border,    ///< the ground ends here, so it did not move
  put_down,
  lifted,
  no_strokes  ///< there is no stroke to go to
};

struct KeyPenEvent {
  KeyPenDid did = KeyPenDid::moved;
  KeyPenPlace place;
  int left = 0;  ///< left_stroke: the stroke that was left, from 1
};

/// A pen for people who use neither a mouse nor a pen: keys move it over the tablet or a sheet in steps, put
/// it down and lift it. What is written with it goes the way of every other writing, so each stage works with
/// it and judges it. The strokes it names are those that the ground shows: a blank tablet tells nothing.
/// Thread: the one of the ground.
class KeyPen {
 public:
  /// A step and a fine step [m]: 50 and 200 of them cross a tablet of 0.1 m.
  static constexpr double kStep_m = 2e-3;
  static constexpr double kFineStep_m = 0.5e-3;
  /// A stroke is within reach when its centre line is this near [m].
  static constexpr double kReach_m = 2.5e-3;

  /// @param ground  outlives this.
  explicit KeyPen(KeyPenGround& ground) : ground_(ground) {}

  /// Shows the pen over the middle of the ground.
  KeyPenEvent begin();
  /// Takes the pen away; what is being written ends.
  void end();
  [[nodiscard]] bool is_in_use() const { return in_use_; }

  /// Moves the pen. @param right, up  steps, -1, 0 or 1 each; both: a diagonal of the same length in each
  ///   direction.
  KeyPenEvent step(int right, int up, bool fine = false);
  /// Puts the pen down, or lifts it.
  KeyPenEvent press();
  /// Lifts the pen and goes to the start of the stroke that is shown alone; where all are shown, to the start
  /// of the first one and then of the one after the last visited.
  KeyPenEvent go_to_next_start();
  [[nodiscard]] KeyPenPlace where() const;

 private:
  [[nodiscard]] KeyPenPlace place_at(geometry::TabletPoint at) const;
  KeyPenEvent arrive(geometry::TabletPoint at);
  void send();

  KeyPenGround& ground_;
  geometry::TabletPoint at_{0, 0};
  bool is_down_ = false;
  bool in_use_ = false;
  int visited_ = 0;  ///< the stroke whose start was gone to last, from 1
};

/// The sound of a place: pitch by height as for plots, left and right by pan, louder the deeper the groove
/// is, rough at the edge of a groove and clear on its bottom and on the plateau.
[[nodiscard]] functions::Cue cue_of(const KeyPenPlace& place);

}  // namespace nazori::practice
