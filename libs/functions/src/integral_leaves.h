// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "nazori/functions/interval.h"
#include "nazori/functions/tape.h"
#include "taylor.h"

namespace nazori::functions {

/// The innermost block of an Antiderivative ends at 2^-16.
inline constexpr int kFirstBlockPower = 16;

/// The integral over a stretch and how far it may be off.
struct IntegralSum {
  long double centre = 0;
  long double radius = 0;
  void add(const IntegralSum& other);
};

/// Leaves that were passed on the way from 0 outwards.
struct PassedLeaves {
  std::uint32_t bad = 0;     ///< where the function is not proven defined and bounded
  std::uint32_t coarse = 0;  ///< whose bounds are wide because there were too many
};

/// A stretch over which the integral is a polynomial with a remainder.
struct IntegralLeaf {
  double inner = 0;  ///< distances of its ends from 0
  double outer = 0;
  bool is_negative = false;
  double place = 0;  ///< around which the polynomial is written
  bool is_bad = true;
  bool is_coarse = false;
  Cause cause = Cause::none;  ///< of a bad one
  int order = 0;              ///< of the remainder
  Interval range;             ///< of the function
  Taylor::Terms terms{};      ///< of the integral over (t - place): c_k/(k+1)
  IntegralSum to_place;       ///< from the inner end to the place
  IntegralSum to_outer;       ///< from the place to the outer end
  PassedLeaves passed;        ///< further in
  int block = 0;              ///< its number
  std::size_t index = 0;      ///< in the block

  /// The integral from the place to `t`.
  [[nodiscard]] long double near(double t) const;
  [[nodiscard]] Interval enclosed_near(double t) const;
  /// The value of the function.
  [[nodiscard]] double height_near(double t) const;
};

struct IntegralBlock {
  std::vector<IntegralLeaf> leaves;  ///< from the inside outwards
  std::vector<IntegralSum> tree;     ///< sums of 1, 2, 4, ... leaves: [n + i] of leaf i, [1] of all
  PassedLeaves passed;               ///< from 0 to the outer end

  /// Outwards over the leaves from `first` to the one in front of `last`. Nothing cancels that lies outside:
  /// beside a pole a sum from 0 would be of no use.
  [[nodiscard]] IntegralSum sum(std::size_t first, std::size_t last) const;
};

/// @param tape    the function, of one variable.
/// @param inner   the end nearer to 0; both ends have one sign.
/// @param passed  up to the inner end.
[[nodiscard]] IntegralBlock build_block(const Tape& tape, double inner, double outer, int number,
                                        PassedLeaves passed);

}  // namespace nazori::functions
