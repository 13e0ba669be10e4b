// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arc_probe.h"
#include "nazori/functions/expression.h"
#include "nazori/functions/tracing.h"

namespace nazori::functions {

/// Newton's method for f = g = 0 from `start`, which is returned if it does not converge nearby. Points are x
/// and y here, not plate units.
[[nodiscard]] PlatePoint refined(const Expression& f, const Expression& g, PlatePoint start);

/// Newton's method for two parameters at which an arc passes the same point; returns the first of them.
[[nodiscard]] double same_place(ArcProbe& probe, double s, double t);

}  // namespace nazori::functions
