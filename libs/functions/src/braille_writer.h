// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "braille_cells.h"
#include "nazori/functions/curve_kinds.h"

namespace nazori::functions {

/// Writes expressions, comparisons and conditions in the cells of a code.
class BrailleWriter {
 public:
  explicit BrailleWriter(BrailleCode code) : cells_(code) {}

  [[nodiscard]] std::string text() && { return std::move(cells_).text(); }
  BrailleCells& cells() { return cells_; }

  /// @param followed  something follows in the same product: an argument needs its parentheses.
  void write(const Expression& e, bool followed = false, bool follows_operation = false);
  void comparison(Comparison c);
  /// A sign of comparison, with a space on both sides.
  void sign(std::string_view cells);
  void condition(const Node& n);
  void braced(const Expression& condition_of);

 private:
  void write_number(double v, bool follows_operation);
  void grouped(const Expression& e);

  /// With parentheses where it binds less than `least`; a fraction has its own ends.
  void part(const Expression& e, int least, bool followed, bool follows_operation);
  void product(const Node& n, bool followed, bool follows_operation);
  static bool is_factorial(const Node& n);
  void fraction(const Expression& top, const Expression& bottom);
  void exponent(const Expression& e);
  static bool has_name(Function f);
  void power(const Expression& base, const Expression& e, bool followed);

  /// The 2 of log to base 2 (§ 77: a number below a function has no indicator).
  void return_subscript();

  /// § 119: a space behind the name of a function.
  void argument(const Expression& e, bool followed);
  void radical(const Expression& inside, const Expression& index);
  void cases(const Node& n);
  /// [1, 2, 3]; of a range [1, 3, ..., 9].
  void list(const Node& n);
  void integral(const Node& n, bool followed);
  void item(const Expression& e);
  void between(std::string_view open, const Expression& e, std::string_view close);
  void function(const Node& n, bool followed);

  BrailleCells cells_;
  int roots_ = 0;
};

}  // namespace nazori::functions
