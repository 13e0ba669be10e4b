// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "exact_name.h"
#include "nazori/functions/points.h"

namespace nazori::functions {
namespace {

constexpr double kTolerance = 2e-13;

class Namer {
 public:
  explicit Namer(double tolerance) : tolerance_(tolerance) {}
  [[nodiscard]] std::optional<std::string> name(double value) const;

 private:
  [[nodiscard]] bool is_same(double a, double b) const {
    return std::abs(a - b) <= tolerance_ * std::max(1.0, std::abs(b));
  }
  /// "3", "-2/5", for p/q of a value; q up to `most`, p not 0.
  [[nodiscard]] std::optional<std::pair<long, long>> fraction_of(double v, long most) const;

  double tolerance_;
};

std::optional<std::pair<long, long>> Namer::fraction_of(double v, long most) const {
  if (std::abs(v) > 1e6) return std::nullopt;
  for (long q = 1; q <= most; ++q) {
    const double p = std::round(v * static_cast<double>(q));
    if (p != 0 && is_same(p / static_cast<double>(q), v)) return std::pair{static_cast<long>(p), q};
  }
  return std::nullopt;
}

/// p/q times a symbol: "pi/2", "3*pi/4", "-pi".
std::string multiple(long p, long q, const std::string& symbol) {
  std::string text = p == 1 ? symbol : p == -1 ? "-" + symbol : fmt::format("{}*{}", p, symbol);
  return q == 1 ? text : text + fmt::format("/{}", q);
}

bool is_square_free(int n) {
  for (int k = 2; k * k <= n; ++k) {
    if (n % (k * k) == 0) return false;
  }
  return true;
}

std::optional<std::string> Namer::name(double value) const {
  if (!std::isfinite(value)) return std::nullopt;
  // Rounding results such as sin(pi) count as zero.
  if (is_same(value, 0)) return "0";
  if (const auto f = fraction_of(value, 40))
    return f->second == 1 ? fmt::format("{}", f->first) : fmt::format("{}/{}", f->first, f->second);
  if (const auto f = fraction_of(value / std::numbers::pi, 12)) return multiple(f->first, f->second, "pi");
  for (int n = 2; n <= 30; ++n) {
    if (!is_square_free(n)) continue;
    const auto f = fraction_of(value / std::sqrt(static_cast<double>(n)), 12);
    if (f && std::abs(f->first) <= 100) return multiple(f->first, f->second, fmt::format("sqrt({})", n));
  }
  if (const auto f = fraction_of(value / std::numbers::e, 6); f && std::abs(f->first) <= 20)
    return multiple(f->first, f->second, "e");
  if (const auto f = fraction_of(value * std::numbers::e, 6); f && std::abs(f->first) <= 20)
    return f->second == 1 ? fmt::format("{}/e", f->first) : fmt::format("{}/({}*e)", f->first, f->second);
  for (const int n : {2, 3, 5, 7, 10}) {
    const auto f = fraction_of(value / std::log(static_cast<double>(n)), 6);
    if (f && std::abs(f->first) <= 20) return multiple(f->first, f->second, fmt::format("ln({})", n));
  }
  if (value > 0) {
    const auto squared = fraction_of(value * value / std::numbers::pi, 6);
    if (squared && squared->first <= 100)
      return "sqrt(" + multiple(squared->first, squared->second, "pi") + ")";
    const auto power = fraction_of(std::log(value), 6);
    if (power && std::abs(power->first) <= 6)
      return power->second == 1 ? fmt::format("e^{}", power->first)
                                : fmt::format("e^({}/{})", power->first, power->second);
  }
  // (a + b sqrt(n))/c, the form of solutions of quadratic equations.
  for (const int n : {2, 3, 5, 6, 7, 10, 11, 13, 17}) {
    for (int c = 1; c <= 4; ++c) {
      for (int b = -3; b <= 3; ++b) {
        if (b == 0) continue;
        const double rest = value * c - b * std::sqrt(static_cast<double>(n));
        const double a = std::round(rest);
        if (a == 0 || std::abs(a) > 20 || std::abs(rest - a) > tolerance_ * std::max(1.0, std::abs(value)))
          continue;
        const std::string root =
            std::abs(b) == 1 ? fmt::format("sqrt({})", n) : fmt::format("{}*sqrt({})", std::abs(b), n);
        const std::string top = fmt::format("{} {} {}", a, b < 0 ? "-" : "+", root);
        return c == 1 ? top : fmt::format("({})/{}", top, c);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> exact_name(double value) { return Namer(kTolerance).name(value); }

std::optional<double> exact_value_near(double value, double tolerance) {
  const auto text = Namer(tolerance).name(value);
  const auto parsed = text ? parse(*text) : tl::unexpected(SyntaxError{});
  if (!parsed) return std::nullopt;
  return constant_value(parsed->statements[0].terms[0]);
}

}  // namespace nazori::functions
