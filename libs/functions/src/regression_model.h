// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "nazori/functions/plot.h"
#include "nazori/functions/tape.h"

namespace nazori::functions {

/// A letter of a model, which has no value yet. It is written and spoken by its name.
[[nodiscard]] Expression free_letter(std::string name);
[[nodiscard]] bool is_free_letter(const Node& n);

/// The right side of y ~ a e^(b x): an expression in x and letters without values.
///
/// Some letters are linear: with the other ones given, the model is a sum of terms, each with one of them as
/// its factor. Those are found by solving linear equations, so that only the other ones have to be searched.
class RegressionModel {
 public:
  explicit RegressionModel(Expression typed);

  /// All letters, in the order in which they were typed.
  [[nodiscard]] const std::vector<std::string>& letters() const { return letters_; }
  /// Numbers of letters.
  [[nodiscard]] const std::vector<std::size_t>& linear() const { return linear_; }
  [[nodiscard]] const std::vector<std::size_t>& nonlinear() const { return nonlinear_; }

  /// A nonlinear letter in what is integrated, which cannot be searched; empty where there is none.
  [[nodiscard]] const std::string& searched_under_integral() const { return searched_under_integral_; }

  /// The model with x and all letters as inputs, in this order.
  [[nodiscard]] const Tape& whole() const { return whole_; }
  /// With x and the nonlinear letters as inputs: the part without a linear letter, then the factor of each.
  [[nodiscard]] const Tape& terms() const { return terms_; }

  /// The model with numbers in place of the letters: 2*x - 1.
  [[nodiscard]] Expression with_values(const std::vector<double>& values) const;

 private:
  Expression typed_;
  std::vector<std::string> letters_;
  std::vector<std::size_t> linear_;
  std::vector<std::size_t> nonlinear_;
  std::string searched_under_integral_;
  Tape whole_;
  Tape terms_;
};

/// Replaces every model of the plot by the curve that fits its points best, and adds `data` as points.
/// @return the errors: too few points, letters that they do not determine, no solution.
[[nodiscard]] tl::expected<void, SyntaxError> fit_models(Plot& plot, std::span<const DataPoint> data);

}  // namespace nazori::functions
