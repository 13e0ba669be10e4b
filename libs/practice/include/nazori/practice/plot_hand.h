// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>

#include "nazori/functions/plot_explorer.h"
#include "nazori/practice/tablet_control.h"

namespace nazori::practice {

/// The stylus on a plot: keys put it where the explorer is, or a hand moves it. Thread: the owner of the
/// tablet.
class PlotHand {
 public:
  /// How long the stylus stays lifted on a way that would lead it over walls.
  static constexpr std::chrono::milliseconds kLift{30};

  /// @param tablet, explorer  outlive this. The tablet shows the explorer's drawing while put() and follow()
  /// are
  ///   called.
  PlotHand(TabletControl& tablet, functions::PlotExplorer& explorer) : tablet_(tablet), explorer_(explorer) {}

  /// Puts the stylus where the explorer is. A step is a move of the pressed stylus; on a longer way it is
  /// lifted, because it would get stuck behind a wall.
  /// @return where to press() it after kLift; nothing: it is pressed already.
  std::optional<geometry::TabletPoint> put();
  /// Presses the stylus where put() asked for it, unless it was put elsewhere meanwhile.
  void press(geometry::TabletPoint at);
  /// Whether the stylus is where a key put it: no hand has moved it since.
  [[nodiscard]] bool is_put() const { return put_.has_value(); }

  /// What a hand feels on the plot.
  struct Feeling {
    functions::Touch touch;    ///< silent where the stylus touches nothing
    functions::PlatePoint at;  ///< of a touch
  };
  /// Looks at the stylus. @return what it touches now; nothing: a key put it there, and the sound of the key
  /// holds.
  [[nodiscard]] std::optional<Feeling> follow();

 private:
  TabletControl& tablet_;
  functions::PlotExplorer& explorer_;
  std::optional<geometry::TabletPoint> put_;
};

}  // namespace nazori::practice
