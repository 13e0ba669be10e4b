// SPDX-License-Identifier: Apache-2.0
#include "far_out.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "exact_name.h"
#include "nazori/functions/points.h"
#include "one_variable.h"

namespace nazori::functions {
namespace {

using Long = long double;

// Where the sequence is sampled: powers of ten and places between, so that no wave fits them all.
constexpr std::array<Long, 5> kMantissas{1.0L, 1.618033988749895L, 2.718281828459045L, 4.669201609102990L,
                                         7.3890560989L};
constexpr int kFirst = 1;
constexpr int kLast = 8;  // of far_behaviour
constexpr int kShortest = 4;

class FarLook {
 public:
  /// @param last  the sequence goes to this power of ten.
  FarLook(const Expression& f, Variable v, int direction, int last = kLast)
      : f_(f, v), direction_(direction), last_(last) {}

  /// The limit, if it is one.
  [[nodiscard]] std::optional<double> level() const {
    return limit([this](Long x) { return value(x); }, last_ == kLast);
  }

  FarBehaviour run() {
    int undefined = 0;
    for (int k = 2; k <= kLast; ++k) undefined += std::isnan(at(k, 0)) ? 1 : 0;
    if (undefined == kLast - 1) return {FarOut::undefined};
    if (const auto level = limit([this](Long x) { return value(x); }, true))
      return {FarOut::level, 0, *level, lies_on(0, *level)};
    const auto slope = limit([this](Long x) { return value(x) / x; }, false);
    if (slope && *slope != 0) {
      const Long m = *slope;
      // The slope itself is rounded.
      const double doubt = 4e-16 * std::abs(*slope) * std::pow(10.0, kLast + 1);
      if (const auto b = limit([this, m](Long x) { return value(x) - m * x; }, false, doubt))
        return {FarOut::slanted, static_cast<double>(direction_) * *slope, *b, lies_on(m, *b)};
    }
    return grows();
  }

 private:
  /// Whether the function is the line itself from some place on; tanh(5) is not yet 1.
  [[nodiscard]] bool lies_on(Long slope, Long intercept) const {
    bool all = true;
    bool near = true;
    for (const Long x : {20.7L, 31.3L, 57.1L, 83.9L, 1234.5L, 5.3e4L}) {
      const Long gap = std::abs(value(x) - slope * x - intercept);
      all = all && gap <= 1e-15L * (1 + std::abs(slope * x) + std::abs(intercept));
    }
    for (const Long x : {4.1L, 5.3L, 7.7L}) {
      const Long gap = std::abs(value(x) - slope * x - intercept);
      near = near && (std::isnan(gap) || gap <= 1e-15L * (1 + std::abs(slope * x) + std::abs(intercept)));
    }
    return all && near;
  }

  [[nodiscard]] Long value(Long x) const { return f_.long_value(direction_ * x); }
  [[nodiscard]] Long at(int power, std::size_t mantissa) const {
    return value(std::pow(10.0L, power) * kMantissas[mantissa]);
  }

  /// The limit of a sequence whose distance from it falls to a half or less from each power of ten to the
  /// next.
  template <class F>
  [[nodiscard]] std::optional<double> limit(const F& f, bool is_function, double doubt = 0) const {
    const auto x_of = [](int k, std::size_t m) { return std::pow(10.0L, k) * kMantissas[m]; };
    std::array<Long, kLast + 1> low{};
    std::array<Long, kLast + 1> high{};
    for (int k = kFirst; k <= last_; ++k) {
      low[static_cast<std::size_t>(k)] = std::numeric_limits<Long>::infinity();
      high[static_cast<std::size_t>(k)] = -std::numeric_limits<Long>::infinity();
      for (std::size_t m = 0; m < kMantissas.size(); ++m) {
        const Long v = f(x_of(k, m));
        if (!std::isfinite(v)) {
          if (k < 3) continue;
          return std::nullopt;
        }
        low[static_cast<std::size_t>(k)] = std::min(low[static_cast<std::size_t>(k)], v);
        high[static_cast<std::size_t>(k)] = std::max(high[static_cast<std::size_t>(k)], v);
      }
    }
    // The value with the fewest decimals, or with a name, that all later samples approach.
    const Long last = f(x_of(last_, 2));
    const Long before = f(x_of(last_ - (last_ - 2) / 3, 2));
    const Long earlier = f(x_of(last_ - 2 * ((last_ - 2) / 3), 2));
    std::vector<double> guesses;
    // Aitken's extrapolation.
    const Long d1 = before - earlier;
    const Long d2 = last - before;
    const Long extrapolated = d1 != d2 && d1 != 0 ? last - d2 * d2 / (d2 - d1) : last;
    for (const Long v : {last, extrapolated}) {
      if (!std::isfinite(v)) continue;
      for (const double tolerance : {1e-12, 1e-9, 1e-7}) {
        if (const auto named = exact_value_near(static_cast<double>(v), tolerance)) guesses.push_back(*named);
      }
    }
    if (is_function) {
      // 1/ln(x) comes to 0 so slowly that only infinity itself shows it.
      const Long far = f(std::numeric_limits<Long>::infinity());
      if (std::isfinite(far)) guesses.push_back(static_cast<double>(far));
    }
    guesses.push_back(0);
    if (std::isfinite(extrapolated)) guesses.push_back(static_cast<double>(extrapolated));
    guesses.push_back(static_cast<double>(last));
    for (const double g : guesses) {
      if (approaches(g, low, high, is_function, doubt)) return g;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool approaches(double limit, const std::array<Long, kLast + 1>& low,
                                const std::array<Long, kLast + 1>& high, bool is_function,
                                double doubt) const {
    const auto distance = [&](int k) {
      const auto i = static_cast<std::size_t>(k);
      return std::max(std::abs(low[i] - limit), std::abs(high[i] - limit));
    };
    const Long noise = 1e-9L * std::max(1.0L, std::abs(static_cast<Long>(limit))) + doubt;
    bool halves = true;
    for (int k = std::min(3, last_ - 2); k + 1 <= last_; ++k) {
      const Long next = distance(k + 1);
      halves = halves && (next <= 0.6L * distance(k) || next <= noise);
    }
    if (halves &&
        distance(last_) <= std::max(noise, 2e-3L * std::max(1.0L, std::abs(static_cast<Long>(limit)))))
      return true;
    if (!is_function) return false;
    // Slowly: nearer at every step, and near enough at the largest numbers.
    for (int k = 3; k + 1 <= last_; ++k) {
      if (!(distance(k + 1) < distance(k))) return false;
    }
    const Long huge = std::abs(value(1e4000L) - limit);
    return std::isfinite(huge) && huge < 0.01L * distance(3) + noise;
  }

  [[nodiscard]] FarBehaviour grows() const {
    // Every later stretch lies wholly above all earlier ones, or below.
    Long least = 0;
    Long most = 0;
    bool rises = true;
    bool falls = true;
    for (int k = 2; k <= 12; ++k) {
      Long low = std::numeric_limits<Long>::infinity();
      Long high = -std::numeric_limits<Long>::infinity();
      for (std::size_t m = 0; m < kMantissas.size(); ++m) {
        const Long v = at(k, m);
        if (std::isnan(v)) return {FarOut::unknown};
        low = std::min(low, v);
        high = std::max(high, v);
      }
      if (k > 2) {
        rises = rises && (low > least || (std::isinf(low) && low > 0));
        falls = falls && (high < most || (std::isinf(high) && high < 0));
      }
      least = low;
      most = high;
    }
    if (!rises && !falls) return {FarOut::unknown};
    // What grows less and less may have a limit: 1 - 1/ln(x).
    const Long d1 = at(11, 0) - at(10, 0);
    const Long d2 = at(12, 0) - at(11, 0);
    if (std::isfinite(d1) && std::isfinite(d2) && std::abs(d2) < 0.88L * std::abs(d1))
      return {FarOut::unknown};
    return {rises ? FarOut::rises : FarOut::falls};
  }

  OneVariable f_;
  Long direction_;
  int last_;
};

/// The number as it is written where it has a name: x - pi beside pi is not left to rounding.
Expression exact_number(double value) {
  const auto name = exact_name(value);
  const auto parsed = name ? parse(*name) : tl::unexpected(SyntaxError{});
  return parsed ? parsed->statements[0].terms[0] : number(value);
}

}  // namespace

std::optional<double> limit_at(const Expression& f, Variable v, double at, int side) {
  const Expression step = binary(NodeKind::divide, number(side), variable(v));
  const Expression moved = at == 0 ? step : binary(NodeKind::add, exact_number(at), step);
  const Expression g = substitute(reduced(f), v, moved);
  // Where two large parts nearly cancel, (1 - cos(x))/x^2, nearer is less exact.
  for (int last = kLast; last >= kShortest; last -= 2) {
    if (const auto limit = FarLook(g, v, 1, last).level()) return limit;
  }
  return std::nullopt;
}

FarBehaviour far_behaviour(const Expression& f, Variable v, int direction) {
  return FarLook(f, v, direction).run();
}

}  // namespace nazori::functions
