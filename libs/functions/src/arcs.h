// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "arc_tracer.h"

namespace nazori::functions {

/// The statement as an arc with the parameter range given by the window or the statement; nothing for
/// equations and regions. Not for points.
[[nodiscard]] std::optional<Arc> arc_of(const Statement& s, const Window& window, double margin);

/// All arcs that draw a statement: one of a course, one or two of an equation in r and theta with a single
/// power of r, one for each of several points, none of other kinds.
[[nodiscard]] std::vector<Arc> arcs_of(const Statement& s, const Window& window, double margin = 0);

/// F with F(x, y) = 0 for the statement, null for arcs over t or theta and for regions.
[[nodiscard]] Expression equation_of(const Statement& s);

}  // namespace nazori::functions
