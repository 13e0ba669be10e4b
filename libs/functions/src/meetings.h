// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "point_list.h"

namespace nazori::functions {

/// Adds the places where two statements cross or touch, found from their equations.
void add_meetings(int first, int second, PointList& list);

}  // namespace nazori::functions
