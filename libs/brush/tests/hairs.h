// SPDX-License-Identifier: Apache-2.0
// Hairs, and what rubs them, for the tests of spines.
#pragma once

#include "nazori/brush/spine.h"

namespace nazori::brush::test {

inline SpineForm form(int segments, double own_bend_rad = 0.005) {
  SpineForm made;
  made.segments = segments;
  made.own_bend_rad = own_bend_rad;
  return made;
}

/// A hair that thins out.
inline SpineForm hair() {
  SpineForm made;
  made.taper = 0.1;
  made.tip_segment = 0.5;
  return made;
}

inline SpineFriction rubbing(double paper) {
  SpineFriction made;
  made.paper = paper;
  return made;
}

}  // namespace nazori::brush::test
