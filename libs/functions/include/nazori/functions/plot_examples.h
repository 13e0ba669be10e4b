// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "nazori/functions/tracing.h"

namespace nazori::functions {

/// An expression to begin with, and the window in which its curve is seen best.
struct PlotExample {
  std::string_view expression;
  Window window;
};

/// The examples of the program, the simplest first. Decimal points; each can be parsed and drawn.
[[nodiscard]] std::span<const PlotExample> plot_examples();

}  // namespace nazori::functions
