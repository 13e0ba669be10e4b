// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_examples.h"

#include <array>
#include <numbers>

namespace nazori::functions {
namespace {

using std::numbers::pi;

constexpr std::array kExamples{
    PlotExample{"y = sin x", {-5, 5, -5, 5}},
    PlotExample{"y = tan(x); y = sin x", {-6, 6, -4, 4}},
    PlotExample{"y = x^3 - 3x", {-3, 3, -4, 4}},
    PlotExample{"y = 1/x", {-5, 5, -5, 5}},
    PlotExample{"y = |x| - 1", {-3, 3, -2, 2}},
    PlotExample{"y = floor(x)", {-3.5, 3.5, -4.5, 4.5}},
    PlotExample{"y = e^x; y = ln x", {-4, 4, -4, 4}},
    PlotExample{"y = x^2; y = 2 - x^2", {-3, 3, -3, 5}},
    PlotExample{"x^2 + y^2 = 4", {-3, 3, -3, 3}},
    PlotExample{"y^2 = x^3 - x", {-2, 3, -3, 3}},
    PlotExample{"x = cos(3t); y = sin(2t); 0 <= t <= 2π", {-1.5, 1.5, -1.5, 1.5}},
    PlotExample{"r = 2cos(3θ); 0 <= θ <= π", {-2.5, 2.5, -2.5, 2.5}},
    PlotExample{"y > x^2", {-3, 3, -1, 5}},
    PlotExample{"z = sin(x) cos(y)", {-pi, pi, -pi, pi}},
};

}  // namespace

std::span<const PlotExample> plot_examples() { return kExamples; }

}  // namespace nazori::functions
