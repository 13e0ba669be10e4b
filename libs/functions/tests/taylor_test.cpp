// SPDX-License-Identifier: Apache-2.0
// Taylor coefficients, against series as tables have them, and what is not known in corners and jumps.
#include "../src/taylor.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "nazori/functions/plot.h"
#include "nazori/functions/tape.h"

namespace nazori::functions {
namespace {

Taylor series(const std::string& text, const Interval& box, double place) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  const Tape tape = Tape::compile(std::array{plot->statements[0].terms[0]}, std::array{Variable::x});
  return tape.evaluate_one<Taylor>(std::array{Taylor::of_variable(box, place)});
}

double factorial(int n) { return std::tgamma(n + 1.0); }

struct Known {
  const char* text;
  double place;
  std::function<double(int)> term;
};

TEST(Taylor, HasTheTermsOfKnownSeries) {
  for (const Known& known : std::vector<Known>{
           {"e^x", 0, [](int k) { return 1 / factorial(k); }},
           {"sin(x)", 0, [](int k) { return k % 2 == 0 ? 0 : (k % 4 == 1 ? 1 : -1) / factorial(k); }},
           {"cosh(x)", 0, [](int k) { return k % 2 == 0 ? 1 / factorial(k) : 0; }},
           {"1/(1-x)", 0, [](int) { return 1.0; }},
           {"ln(x)", 1, [](int k) { return k == 0 ? 0 : (k % 2 == 1 ? 1.0 : -1.0) / k; }},
           {"atan(x)", 0, [](int k) { return k % 2 == 0 ? 0 : (k % 4 == 1 ? 1.0 : -1.0) / k; }},
           {"x^4", 1, [](int k) { return k > 4 ? 0 : factorial(4) / factorial(k) / factorial(4 - k); }},
           {"sqrt(x)", 1,
            [](int k) {
              return factorial(2 * k) / std::pow(factorial(k), 2) / std::pow(-4, k) / (1 - 2 * k);
            }},
           {"tan(x)", 0,
            [](int k) {
              return std::array{0.0, 1.0,         0.0, 1.0 / 3,         0.0, 2.0 / 15, 0.0, 17.0 / 315,
                                0.0, 62.0 / 2835, 0.0, 1382.0 / 155925, 0.0}
                  .at(static_cast<std::size_t>(k));
            }},
           {"sin(x)/x", 0, [](int k) { return k % 2 == 1 ? 0 : (k % 4 == 0 ? 1 : -1) / factorial(k + 1); }},
       }) {
    const Taylor t = series(known.text, {known.place, known.place + 0x1p-20}, known.place);
    // A quotient of two zeros loses the last term.
    for (int k = 0; k < Taylor::kOrder; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double wanted = known.term(k);
      for (const Interval& v : {t.place[i], t.box[i]}) {
        EXPECT_LE(v.lower, wanted + 1e-15) << known.text << ' ' << k;
        EXPECT_GE(v.upper, wanted - 1e-15) << known.text << ' ' << k;
      }
      EXPECT_LE(t.place[i].width(), 1e-12) << known.text << ' ' << k;
    }
  }
}

TEST(Taylor, KnowsOneSlopeInACornerAndNoneInAJump) {
  const Interval box(-1, 1);
  for (const char* corner : {"|x|", "max(x, -x)", "-min(x, -x)"}) {
    const Taylor t = series(corner, box, 0.5);
    EXPECT_EQ(t.box[1].lower, -1) << corner;
    EXPECT_EQ(t.box[1].upper, 1) << corner;
    EXPECT_FALSE(t.box[2].is_bounded()) << corner;
    EXPECT_EQ(t.place[1].lower, 1) << corner;
    EXPECT_FALSE(series(corner, box, 0).place[1].is_bounded()) << corner;
  }
  for (const char* jump : {"floor(x)", "sign(x)", "ceil(x)", "{x < 0: 1, 2}", "atan2(x, -1)"}) {
    const Taylor t = series(jump, box, 0.5);
    EXPECT_TRUE(t.box[0].is_bounded()) << jump;
    EXPECT_FALSE(t.box[1].is_bounded()) << jump;
    EXPECT_TRUE(t.place[1].is_bounded()) << jump;
  }
}

TEST(Taylor, KnowsNoSlopeWhereARootEnds) {
  const Taylor t = series("sqrt(x)", {0, 1}, 0.5);
  EXPECT_TRUE(t.box[0].is_bounded());
  EXPECT_FALSE(t.box[1].is_bounded());
}

}  // namespace
}  // namespace nazori::functions
