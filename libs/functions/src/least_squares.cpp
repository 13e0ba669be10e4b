// SPDX-License-Identifier: Apache-2.0
#include "least_squares.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <unsupported/Eigen/NonLinearOptimization>

namespace nazori::functions {
namespace {

template <class T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
template <class T>
using Column = Eigen::Matrix<T, Eigen::Dynamic, 1>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Points that the starts are compared by, combinations of starts, and starts that are improved.
constexpr std::size_t kMostCompared = 40;
constexpr std::size_t kMostStarts = 5000;
constexpr std::size_t kImproved = 12;
constexpr int kMostSteps = 500;
// Where the model is undefined, residuals count as this large.
constexpr double kFar = 1e150;
// Columns count as dependent below these shares: of data with rounding in long double, of slopes in double.
constexpr long double kLeastShare = 1e-15L;
constexpr double kLeastSlopeShare = 1e-11;
constexpr double kLeastStartShare = 1e-12;
// A term that contributes less than this share of y is rounding.
constexpr long double kLeastTerm = 1e-16L;

/// Solves A v = b in the sense of least squares, with columns scaled to length 1. Nothing where columns
/// depend on each other.
template <class T>
std::optional<Column<T>> solve(Matrix<T> a, const Column<T>& b, T least_share) {
  Column<T> lengths = a.colwise().norm().transpose();
  for (Eigen::Index i = 0; i < a.cols(); ++i) {
    if (!(lengths[i] > 0) || !std::isfinite(lengths[i])) return std::nullopt;
    a.col(i) /= lengths[i];
  }
  Eigen::ColPivHouseholderQR<Matrix<T>> qr(a);
  qr.setThreshold(least_share);
  if (qr.rank() < a.cols()) return std::nullopt;
  Column<T> v = qr.solve(b);
  const T least = static_cast<T>(kLeastTerm) * b.norm();
  v = v.unaryExpr([least](T term) { return std::abs(term) <= least ? T(0) : term; });
  return Column<T>(v.cwiseQuotient(lengths));
}

/// The linear letters that fit best, with the other ones given.
template <class T>
class LinearPart {
 public:
  LinearPart(const RegressionModel& model, std::span<const DataPoint> points)
      : model_(model),
        points_(points),
        a_(static_cast<Eigen::Index>(points.size()), static_cast<Eigen::Index>(model.linear().size())),
        b_(static_cast<Eigen::Index>(points.size())),
        inputs_(1 + model.nonlinear().size()),
        registers_(model.terms().size()) {}

  /// Where the model has no value.
  [[nodiscard]] const std::optional<double>& undefined_at() const { return undefined_at_; }
  [[nodiscard]] T residual_sum() const { return residual_sum_; }

  std::optional<Column<T>> solve_with(std::span<const double> nonlinear, T least_share) {
    std::copy(nonlinear.begin(), nonlinear.end(), inputs_.begin() + 1);
    for (Eigen::Index k = 0; k < b_.size(); ++k) {
      const DataPoint& p = points_[static_cast<std::size_t>(k)];
      inputs_[0] = static_cast<T>(p.x);
      model_.terms().template evaluate<T>(inputs_, registers_);
      b_[k] = static_cast<T>(p.y) - registers_[model_.terms().output(0)];
      bool is_finite = std::isfinite(b_[k]);
      for (Eigen::Index i = 0; i < a_.cols(); ++i) {
        a_(k, i) = registers_[model_.terms().output(static_cast<std::size_t>(i) + 1)];
        is_finite = is_finite && std::isfinite(a_(k, i));
      }
      if (is_finite) continue;
      undefined_at_ = p.x;
      return std::nullopt;
    }
    undefined_at_.reset();
    Column<T> values(0);
    if (a_.cols() > 0) {
      auto solved = solve<T>(a_, b_, least_share);
      if (!solved) return std::nullopt;
      values = std::move(*solved);
      residual_sum_ = (b_ - a_ * values).squaredNorm();
    } else {
      residual_sum_ = b_.squaredNorm();
    }
    return values;
  }

 private:
  const RegressionModel& model_;
  std::span<const DataPoint> points_;
  Matrix<T> a_;
  Column<T> b_;
  std::vector<T> inputs_;
  std::vector<T> registers_;
  std::optional<double> undefined_at_;
  T residual_sum_ = 0;
};

/// Residuals and their slopes, in the form that Eigen's Levenberg-Marquardt takes.
class Residuals {
 public:
  using Slope = Dual<double, 1>;

  Residuals(const RegressionModel& model, std::span<const DataPoint> points)
      : model_(model),
        points_(points),
        inputs_(1 + model.letters().size()),
        registers_(model.whole().size()) {}

  [[nodiscard]] int values() const { return static_cast<int>(points_.size()); }
  [[nodiscard]] int inputs() const { return static_cast<int>(model_.letters().size()); }

  int operator()(const Column<double>& letters, Column<double>& residuals) {
    for (int k = 0; k < values(); ++k) {
      const double r = at(letters, k, -1).value - points_[static_cast<std::size_t>(k)].y;
      residuals[k] = std::isfinite(r) ? r : kFar;
    }
    return 0;
  }

  int df(const Column<double>& letters, Matrix<double>& slopes) {
    for (int k = 0; k < values(); ++k) {
      for (int i = 0; i < inputs(); ++i) {
        const double slope = at(letters, k, i).slopes[0];
        slopes(k, i) = std::isfinite(slope) ? slope : 0;
      }
    }
    return 0;
  }

 private:
  Slope at(const Column<double>& letters, int point, int by) {
    inputs_[0] = Slope(points_[static_cast<std::size_t>(point)].x);
    for (int i = 0; i < inputs(); ++i)
      inputs_[static_cast<std::size_t>(i) + 1] = i == by ? Slope(letters[i], 0) : Slope(letters[i]);
    model_.whole().evaluate<Slope>(inputs_, registers_);
    return registers_[model_.whole().output(0)];
  }

  const RegressionModel& model_;
  std::span<const DataPoint> points_;
  std::vector<Slope> inputs_;
  std::vector<Slope> registers_;
};

struct Start {
  double residual_sum = kInfinity;
  std::vector<double> nonlinear;
};

/// Some of the points, evenly.
std::vector<DataPoint> thinned(std::span<const DataPoint> points) {
  if (points.size() <= kMostCompared) return {points.begin(), points.end()};
  std::vector<DataPoint> some;
  for (std::size_t i = 0; i < kMostCompared; ++i)
    some.push_back(points[i * (points.size() - 1) / (kMostCompared - 1)]);
  return some;
}

/// The number `i` with its digits to `base` behind the point: spreads evenly over 0 to 1 (Halton).
double radical_inverse(std::size_t i, std::size_t base) {
  double value = 0;
  double share = 1;
  for (; i > 0; i /= base) {
    share /= static_cast<double>(base);
    value += share * static_cast<double>(i % base);
  }
  return value;
}

/// All combinations of values for `count` letters where these are few, else some of them, spread evenly.
std::vector<std::vector<double>> combinations(const std::vector<double>& values, std::size_t count) {
  constexpr std::array<std::size_t, 20> kPrimes{2,  3,  5,  7,  11, 13, 17, 19, 23, 29,
                                                31, 37, 41, 43, 47, 53, 59, 61, 67, 71};
  std::vector<std::vector<double>> all;
  const bool is_grid = count <= 2;
  const std::size_t most = is_grid ? static_cast<std::size_t>(std::pow(values.size(), count)) : kMostStarts;
  for (std::size_t i = 0; i < most; ++i) {
    std::vector<double> one(count);
    std::size_t rest = i;
    for (std::size_t k = 0; k < count; ++k, rest /= values.size()) {
      const auto spread = radical_inverse(i + 1, kPrimes[k]) * static_cast<double>(values.size());
      one[k] = values[is_grid ? rest % values.size() : static_cast<std::size_t>(spread)];
    }
    all.push_back(std::move(one));
  }
  return all;
}

LeastSquares fit_linear(const RegressionModel& model, std::span<const DataPoint> points) {
  LeastSquares best;
  LinearPart<long double> part(model, points);
  const auto values = part.solve_with({}, kLeastShare);
  if (part.undefined_at()) return {FitOutcome::undefined, {}, 0, *part.undefined_at()};
  if (!values) return {FitOutcome::undetermined, {}, 0, 0};
  for (const long double v : *values) best.values.push_back(static_cast<double>(v));
  best.residual_sum = static_cast<double>(part.residual_sum());
  return best;
}

class Search {
 public:
  Search(const RegressionModel& model, std::span<const DataPoint> points) : model_(model), points_(points) {}

  LeastSquares run() {
    const std::vector<Start> starts = best_starts();
    if (starts.empty())
      return {
          undefined_at_ ? FitOutcome::undefined : FitOutcome::undetermined, {}, 0, undefined_at_.value_or(0)};
    LeastSquares best;
    best.outcome = FitOutcome::not_converged;
    for (const Start& start : starts) {
      const auto found = improved(start);
      if (found && (best.values.empty() || is_better(*found, best))) best = *found;
    }
    if (!best.values.empty() && !is_determined(best.values)) best.outcome = FitOutcome::undetermined;
    return best;
  }

 private:
  /// Of two solutions that are equally good, as of a sine with another phase, the one with smaller letters.
  static bool is_better(const LeastSquares& a, const LeastSquares& b) {
    const double hair = 1e-7 * std::max(a.residual_sum, b.residual_sum) + 1e-25;
    if (std::abs(a.residual_sum - b.residual_sum) > hair) return a.residual_sum < b.residual_sum;
    const auto size = [](const LeastSquares& s) {
      double sum = 0;
      for (const double v : s.values) sum += std::abs(v) - 1e-6 * v;
      return sum;
    };
    return size(a) < size(b);
  }

  /// The best combination with each value of the first nonlinear letter: neighbours of the very best one
  /// would all lead to the same solution.
  std::vector<Start> best_starts() {
    const std::vector<DataPoint> some = thinned(points_);
    LinearPart<double> part(model_, some);
    std::map<double, Start> best;
    for (auto& values : combinations(starts_for(points_), model_.nonlinear().size())) {
      if (!part.solve_with(values, kLeastStartShare)) {
        if (part.undefined_at()) undefined_at_ = part.undefined_at();
        continue;
      }
      Start& known = best[values[0]];
      if (part.residual_sum() < known.residual_sum) known = {part.residual_sum(), std::move(values)};
    }
    std::vector<Start> starts;
    for (auto& [first, start] : best) {
      if (std::isfinite(start.residual_sum)) starts.push_back(std::move(start));
    }
    std::stable_sort(starts.begin(), starts.end(),
                     [](const Start& a, const Start& b) { return a.residual_sum < b.residual_sum; });
    starts.resize(std::min(kImproved, starts.size()));
    return starts;
  }

  /// All letters of a start, the linear ones solved for.
  std::optional<Column<double>> letters_of(const Start& start) {
    LinearPart<double> part(model_, points_);
    const auto linear = part.solve_with(start.nonlinear, kLeastStartShare);
    if (!linear) return std::nullopt;
    Column<double> letters(static_cast<Eigen::Index>(model_.letters().size()));
    for (std::size_t i = 0; i < model_.linear().size(); ++i)
      letters[static_cast<Eigen::Index>(model_.linear()[i])] = (*linear)[static_cast<Eigen::Index>(i)];
    for (std::size_t i = 0; i < model_.nonlinear().size(); ++i)
      letters[static_cast<Eigen::Index>(model_.nonlinear()[i])] = start.nonlinear[i];
    return letters;
  }

  std::optional<LeastSquares> improved(const Start& start) {
    auto letters = letters_of(start);
    if (!letters) return std::nullopt;
    Residuals residuals(model_, points_);
    Eigen::LevenbergMarquardt<Residuals> search(residuals);
    search.parameters.ftol = search.parameters.xtol = 1e-15;
    search.parameters.gtol = 0;
    search.parameters.maxfev = kMostSteps;
    const auto status = search.minimize(*letters);
    namespace status_of = Eigen::LevenbergMarquardtSpace;
    if (status == status_of::TooManyFunctionEvaluation || status == status_of::ImproperInputParameters)
      return std::nullopt;
    LeastSquares found;
    found.values.assign(letters->begin(), letters->end());
    found.residual_sum = search.fnorm * search.fnorm;
    const bool are_finite =
        std::all_of(found.values.begin(), found.values.end(), [](double v) { return std::isfinite(v); });
    if (!are_finite || !(search.fnorm < kFar / 2)) return std::nullopt;
    return found;
  }

  [[nodiscard]] bool is_determined(const std::vector<double>& values) const {
    Residuals residuals(model_, points_);
    Matrix<double> slopes(residuals.values(), residuals.inputs());
    const Column<double> letters = Eigen::Map<const Column<double>>(values.data(), residuals.inputs());
    residuals.df(letters, slopes);
    return solve<double>(slopes, Column<double>::Zero(residuals.values()), kLeastSlopeShare).has_value();
  }

  const RegressionModel& model_;
  std::span<const DataPoint> points_;
  std::optional<double> undefined_at_;
};

}  // namespace

std::vector<double> starts_for(std::span<const DataPoint> points) {
  std::vector<double> xs;
  for (const DataPoint& p : points) xs.push_back(p.x);
  std::sort(xs.begin(), xs.end());
  const double span = xs.back() > xs.front() ? xs.back() - xs.front() : 1;
  std::vector<double> starts{0.1, 0.3, 1, 2, 3, std::numbers::pi / 2, std::numbers::pi};
  for (const double v : {0.1, 0.3, 1.0, 2.0, std::numbers::pi / 2}) starts.push_back(-v);
  for (const double rate : {0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0}) {
    starts.push_back(rate / span);
    starts.push_back(-rate / span);
  }
  for (int halves = 1; halves <= 32; ++halves) starts.push_back(halves * std::numbers::pi / span);
  constexpr std::size_t kPlaces = 8;
  for (std::size_t i = 0; i <= kPlaces; ++i) starts.push_back(xs[i * (xs.size() - 1) / kPlaces]);
  return starts;
}

LeastSquares fit(const RegressionModel& model, std::span<const DataPoint> points) {
  LeastSquares best = model.nonlinear().empty() ? fit_linear(model, points) : Search(model, points).run();
  double largest = 0;
  for (const DataPoint& p : points) largest = std::max(largest, std::abs(p.y));
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * largest;
  if (best.residual_sum <= static_cast<double>(points.size()) * rounding * rounding) best.residual_sum = 0;
  return best;
}

}  // namespace nazori::functions
