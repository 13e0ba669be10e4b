// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>

#include "nazori/functions/dual.h"
#include "nazori/functions/expression.h"
#include "nazori/functions/interval.h"
#include "taylor.h"

namespace nazori::functions {

class Tape;
struct IntegralLeaf;
struct IntegralBlock;
struct IntegralSum;

/// The integrals of one function of one variable between any two places, with proven bounds.
///
/// The line is cut into blocks whose ends are powers of two, [1, 2], [2, 4], ..., and a block, the first time
/// that it is needed, into leaves over which a Taylor polynomial with its remainder is as exact as doubles
/// are, or as narrow as they get. The sums of neighbouring leaves are kept, so that one more costs a search.
/// Undefined across places where the function is not proven defined and bounded, such as the pole of 1/t or
/// the end of ln(t) at 0. Thread-safe.
class Antiderivative {
 public:
  /// @param integrand  depends on `v` only.
  Antiderivative(Expression integrand, Variable v);
  ~Antiderivative();
  Antiderivative(const Antiderivative&) = delete;
  Antiderivative& operator=(const Antiderivative&) = delete;

  /// The integral; NaN where undefined, and where the bounds are too far from the value.
  [[nodiscard]] double between(double from, double to) const;
  /// Encloses the integrals for all ends in two intervals.
  [[nodiscard]] Interval between(const Interval& from, const Interval& to) const;

  /// The function itself, continued where sin(t)/t is.
  [[nodiscard]] double integrand(double t) const;
  [[nodiscard]] Interval integrand(const Interval& t) const;
  [[nodiscard]] Taylor integrand(const Taylor& t) const;

 private:
  struct Slot {
    std::once_flag built;
    std::unique_ptr<const IntegralBlock> block;
  };
  static constexpr int kBlocks = 60;

  [[nodiscard]] const Tape& tape() const;
  [[nodiscard]] const IntegralBlock& block(bool negative, int number) const;
  /// The leaf around a place, a good one where two meet. Null beyond the last block.
  [[nodiscard]] const IntegralLeaf* find(double t) const;
  [[nodiscard]] const IntegralLeaf* find_on_side(bool negative, double distance) const;
  /// Whether a block between two places shows that there is no value: the blocks behind it are not built.
  [[nodiscard]] bool is_cut_off(double from, double to) const;
  /// From the place of a leaf to that of another one, or from 0 to it.
  [[nodiscard]] IntegralSum sum_between(const IntegralLeaf& from, const IntegralLeaf& to) const;
  [[nodiscard]] IntegralSum sum_from_zero(const IntegralLeaf& leaf) const;
  [[nodiscard]] std::optional<Interval> proven_between(double from, double to) const;
  /// The integrals from `middle` to every place of `t`.
  [[nodiscard]] Interval around(double middle, const Interval& t) const;
  [[nodiscard]] Interval range_of_leaves(const Interval& t) const;

  Expression integrand_;
  Variable variable_;
  mutable std::once_flag compiled_;
  mutable std::unique_ptr<const Tape> tape_;
  mutable std::array<std::array<Slot, kBlocks>, 2> slots_;
};

/// The integral as a number of a tape.
[[nodiscard]] inline double integral(const Antiderivative& f, double from, double to) {
  return f.between(from, to);
}
[[nodiscard]] long double integral(const Antiderivative& f, long double from, long double to);
[[nodiscard]] inline Interval integral(const Antiderivative& f, const Interval& from, const Interval& to) {
  return f.between(from, to);
}
[[nodiscard]] LongInterval integral(const Antiderivative& f, const LongInterval& from,
                                    const LongInterval& to);
[[nodiscard]] Taylor integral(const Antiderivative& f, const Taylor& from, const Taylor& to);

/// The function under the integral.
[[nodiscard]] inline double integrand_at(const Antiderivative& f, double t) { return f.integrand(t); }
[[nodiscard]] inline Interval integrand_at(const Antiderivative& f, const Interval& t) {
  return f.integrand(t);
}
[[nodiscard]] LongInterval integrand_at(const Antiderivative& f, const LongInterval& t);

/// The slope is f(to) to' - f(from) from'.
template <class T, int N>
Dual<T, N> integral(const Antiderivative& f, const Dual<T, N>& from, const Dual<T, N>& to) {
  Dual<T, N> r(integral(f, from.value, to.value));
  const auto moves = [](const Dual<T, N>& end) {
    for (const T& s : end.slopes) {
      if (!detail::is_zero(s)) return true;
    }
    return false;
  };
  if (moves(to)) {
    const T height = integrand_at(f, to.value);
    for (std::size_t i = 0; i < N; ++i) r.slopes[i] = height * to.slopes[i];
  }
  if (moves(from)) {
    const T height = integrand_at(f, from.value);
    for (std::size_t i = 0; i < N; ++i) r.slopes[i] = r.slopes[i] - height * from.slopes[i];
  }
  return r;
}

}  // namespace nazori::functions
