// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/functions/expression.h"
#include "nazori/functions/fit.h"
#include "nazori/functions/syntax_error.h"

namespace nazori::functions {

enum class Comparison : std::uint8_t {
  equal,
  less,
  less_equal,
  greater,
  greater_equal,
  both,  ///< no comparison: "and" between two chains, y > 0 and y < 2
};

/// "<" or ">", which exclude the border.
[[nodiscard]] constexpr bool is_strict(Comparison c) {
  return c == Comparison::less || c == Comparison::greater;
}

enum class StatementKind : std::uint8_t {
  explicit_y,      ///< y = f(x): terms[0] = f
  explicit_x,      ///< x = g(y): terms[0] = g
  implicit,        ///< terms[0] = terms[1], in x and y
  inequality,      ///< terms[0] ? terms[1] ? ..., chains of comparisons in x and y, all of which hold
  parametric,      ///< terms[0] = x(t), terms[1] = y(t)
  polar,           ///< r = f(theta): terms[0] = f
  polar_implicit,  ///< terms[0] = terms[1], in r and theta
  surface,         ///< z = f(x, y): terms[0] = f
};

/// The ends and borders of area(f, a, b).
struct Area {
  Expression first;   ///< in x
  Expression second;  ///< in x; null: the x axis
  Expression from;    ///< numbers
  Expression to;
};

/// One thing to draw, as typed.
struct Statement {
  StatementKind kind = StatementKind::explicit_y;
  std::vector<Expression> terms;
  std::vector<Comparison> comparisons;  ///< of implicit and inequality: between the terms
  Expression from;                      ///< range of the parameter, of parametric and polar statements
  Expression to;
  bool from_is_open = false;  ///< for 0 < t: the end itself does not belong to the curve
  bool to_is_open = false;
  bool range_given = false;  ///< false: the default 0 to 2 pi is used
  int column = 1;            ///< where it starts in the text
  std::string name{};        ///< of f(x) = ...: "f"; else empty
  bool is_point = false;     ///< of parametric: typed as (1, 2), or as several points ([1, 3], [2, 4])
  bool is_data = false;      ///< of points: measured ones, which are not part of the text
  bool is_model = false;     ///< y ~ a x + b before it is fitted: terms[0] has letters without values
  /// What a model was fitted to; null where no model was typed.
  std::shared_ptr<const Fit> fit{};
  /// Where lists or a model were typed: the statement as typed, of which this is one curve. Else null.
  std::shared_ptr<const Statement> typed{};
  int element = 0;             ///< the place of this curve among those of `typed`, from 0
  int elements = 1;            ///< curves that `typed` stands for
  std::optional<Area> area{};  ///< of inequality: typed as area(...); the terms are its region
};

/// The points of a statement that is_point, each x and y without variables; none of another statement.
struct TypedPoint {
  Expression x;
  Expression y;
};
[[nodiscard]] std::vector<TypedPoint> typed_points(const Statement& statement);

/// A number with a name, "a = 2", that a slider can change: "0 <= a <= 3".
struct Parameter {
  std::string name;
  double value = 0;
  double from = -10;
  double to = 10;
  bool range_given = false;  ///< false: -10 to 10, or further if the value is
};

/// A letter that stands for a list: "a = [1, 2, 3]".
struct NamedList {
  std::string name;
  Expression typed;  ///< without its name
  [[nodiscard]] std::vector<double> values() const;
};

/// The content of one line of text: one or several statements. Immutable after parse(); thread-safe.
struct Plot {
  std::vector<Statement> statements;
  std::vector<Parameter> parameters{};
  std::vector<NamedList> lists{};
  /// What can be read in two ways, with the reading that was taken: 1e3 is 1*e*3.
  std::vector<SyntaxError> questions{};
  [[nodiscard]] bool is_surface() const {
    return statements.size() == 1 && statements[0].kind == StatementKind::surface;
  }
};

struct ParseOptions {
  /// A comma between two digits is a decimal comma even among the arguments of min, max, mod, ... (these are
  /// then separated by "; " or ", " with a space). Elsewhere it always is.
  bool decimal_comma = false;
};

/// Reads expressions separated by ";". Precedence, from loose to tight: comparison; + -; * / and products
/// without a sign, from left to right (1/2x is (1/2)*x); sign; power, from right to left; factorial. A
/// function without parentheses applies to the product that follows: sin 2x, ln|x|, sqrt x + 1 = sqrt(x) + 1.
/// sin^2 x is (sin x)^2, sin^-1 x is asin x. log is to base 10, ln natural; 2e3 is 2*e*3.
/// A brace behind an expression restricts it, y = x^2 {0 <= x <= 2}; a brace with colons is cases, of which
/// the first whose condition holds is taken: {x < 0: -x, x >= 0: x}. "and" joins conditions and inequalities,
/// "or" separates inequalities. f(x) = a x^2 defines a function, a = 2 a parameter, 0 <= a <= 3 its range;
/// f'(x) is the derivative, integral(t^2, t, 0, x) or ∫_0^x t^2 dt an integral. area(x^2, 0, 2) is the region
/// between a curve and the x axis, area(x^2, x, 0, 1) that between two curves.
/// A list, y = [1, 2] x, stands for one curve with each element; two lists go
/// together element by element, as far as the shortest one reaches. ([1, 2], [3, 4]) is the points (1, 3) and
/// (2, 4).
/// y ~ a x + b is a model: its letters without a definition get the values with which it fits the points of
/// the text and of `data` best.
/// @param text  UTF-8 of at most 10,000 bytes, Unicode signs and full-width forms allowed.
/// @param data  measured points that are drawn, too.
[[nodiscard]] tl::expected<Plot, SyntaxError> parse(std::string_view text, const ParseOptions& options = {},
                                                    std::span<const DataPoint> data = {});

/// The text with the value of a parameter replaced or, where it has only a range, added.
/// @return nothing where `text` cannot be read or has no such parameter, or the value is not finite.
[[nodiscard]] std::optional<std::string> with_parameter(std::string_view text, std::string_view name,
                                                        double value, const ParseOptions& options = {});

/// The numbers, names and signs of all statements together.
[[nodiscard]] std::size_t part_count(const Plot& plot);

/// The plot as unambiguous text that parse() reads back: "y = (1/2)*x".
[[nodiscard]] std::string canonical(const Plot& plot);
[[nodiscard]] std::string canonical(const Statement& statement);

/// The plot read aloud: "y equals the quantity 1 over 2 end quantity times x". What is heard can be told
/// apart from every other expression.
[[nodiscard]] std::string in_words(const Plot& plot, Language language,
                                   SpeechStyle style = SpeechStyle::verbose);
[[nodiscard]] std::string in_words(const Statement& statement, Language language,
                                   SpeechStyle style = SpeechStyle::verbose);
[[nodiscard]] std::string in_words(const Expression& expression, Language language,
                                   SpeechStyle style = SpeechStyle::verbose);

}  // namespace nazori::functions
