// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/functions/tracing.h"

namespace nazori::functions {

enum class PointKind : std::uint8_t {
  zero,         ///< on the x axis
  y_intercept,  ///< on the y axis
  maximum,
  minimum,
  inflection,
  crossing,              ///< two statements cross
  touching,              ///< two statements touch without crossing
  vertical_asymptote,    ///< x only
  horizontal_asymptote,  ///< y only
  hole,
  jump,
  end,
  self_crossing,
  singular,  ///< a point without a tangent whose kind is not known
  isolated,
  cusp,               ///< the curve stops and goes back
  slanted_asymptote,  ///< neither x nor y: slope and intercept
};

/// The two sides of a jump, and what lies on the curve there.
struct Jump {
  double x_before = 0;  ///< where the part before ends; x stays the same for y = f(x)
  double y_before = 0;
  double x_after = 0;  ///< where the part after begins
  double y_after = 0;
  double y_at = 0;  ///< the value at the jump itself, of y = f(x); NaN where there is none or it is not known
};

/// A point of a plot that is announced and that keys move to. In the units of the window.
struct PointOfInterest {
  PointKind kind = PointKind::zero;
  int statement = 0;
  int other = -1;        ///< of crossing and touching: the second statement
  double x = 0;          ///< NaN where only y counts
  double y = 0;          ///< NaN where only x counts
  double parameter = 0;  ///< as CurvePoint::parameter
  std::string x_name;    ///< exact, "pi/2", "sqrt(2)"; empty where none is known
  std::string y_name;
  std::optional<Jump> jump;  ///< of a jump
  /// Of asymptotes: -1 where the curve approaches only far to the left (below), 1 far to the right (above), 0
  /// to both sides. Of a vertical asymptote of y = f(x): the side of it on which the curve is.
  int side = 0;
  bool along_y = false;  ///< of asymptotes of x = g(y): `side` is below (-1) or above (1)
  double slope = 0;      ///< of a slanted asymptote y = slope x + intercept
  double intercept = 0;  ///< of a slanted asymptote
};

/// All points of interest inside the window, by statement, then from left to right. At most `most` of one
/// statement; dense curves would have too many to use.
[[nodiscard]] std::vector<PointOfInterest> points_of_interest(const Plot& plot, const Tracing& tracing,
                                                              std::size_t most = 200);

/// The connected parts of one statement inside the window, as a person counts them: a rhombus is one, a
/// region with its border is one, the two arms of y = 1/x are two, and two lines that cross are one.
[[nodiscard]] int pieces_of(const Tracing& tracing, int statement);
/// The same of all statements together.
[[nodiscard]] int pieces(const Plot& plot, const Tracing& tracing);

/// The exact number that equals `value` within its last places: whole numbers, fractions, multiples of pi,
/// roots, powers of e and logarithms of whole numbers. Text as parse() reads it.
[[nodiscard]] std::optional<std::string> exact_name(double value);

/// "zero", "maximum", ... in words.
[[nodiscard]] std::string in_words(PointKind kind, Language language);
/// "maximum at x = pi/2, about 1.571, y = 1".
[[nodiscard]] std::string in_words(const PointOfInterest& point, Language language,
                                   SpeechStyle style = SpeechStyle::verbose);
/// The position of a hand, in four significant digits: "x = about 1.57; y = minus 2".
[[nodiscard]] std::string place_in_words(double x, double y, Language language);
/// A summary in one sentence: what is drawn, in how many branches, what is remarkable, what is uncertain.
[[nodiscard]] std::string summary(const Plot& plot, const Tracing& tracing,
                                  const std::vector<PointOfInterest>& points, Language language,
                                  SpeechStyle style = SpeechStyle::verbose);

}  // namespace nazori::functions
