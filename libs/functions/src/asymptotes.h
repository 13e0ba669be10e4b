// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "point_list.h"

namespace nazori::functions {

/// Adds the level and slanted asymptotes of y = f(x), and the upright and slanted ones of x = g(y).
void add_asymptotes(int statement, PointList& list);

}  // namespace nazori::functions
