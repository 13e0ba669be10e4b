// SPDX-License-Identifier: Apache-2.0
#include "laid_over.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "nazori/geometry/polyline.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;

/// Positions, and directions as unit vectors of twice the angle.
struct Cloud {
  Eigen::MatrixX2d at;
  Eigen::MatrixX2d twice;
};

void put(Cloud& cloud, Eigen::Index i, GlyphPoint at, GlyphPoint along) {
  cloud.at.row(i) << at.x, at.y;
  cloud.twice.row(i) << along.x * along.x - along.y * along.y, 2 * along.x * along.y;
}

Cloud cloud_of(const Ridge& ridge) {
  constexpr std::size_t kMost = 420;
  const std::size_t step = ridge.points.size() / kMost + 1;
  const std::size_t count = (ridge.points.size() + step - 1) / step;
  Cloud cloud{Eigen::MatrixX2d(static_cast<Eigen::Index>(count), 2),
              Eigen::MatrixX2d(static_cast<Eigen::Index>(count), 2)};
  for (std::size_t i = 0; i < count; ++i)
    put(cloud, static_cast<Eigen::Index>(i), ridge.points[i * step].at, ridge.points[i * step].along);
  return cloud;
}

Cloud cloud_of(const std::vector<GlyphLine>& lines) {
  constexpr double kMost = 230;
  double total = 0;
  for (const GlyphLine& line : lines) total += geometry::arc_length<geometry::GlyphFrame>(line);
  const double spacing = std::max(1.5, total / kMost);
  std::vector<std::pair<GlyphPoint, GlyphPoint>> points;
  for (const GlyphLine& line : lines) {
    const double length = geometry::arc_length<geometry::GlyphFrame>(line);
    const auto count = static_cast<std::size_t>(std::max(2.0, std::round(length / spacing)));
    const auto even = geometry::resample<geometry::GlyphFrame>(line, count);
    for (std::size_t i = 0; i < count; ++i) {
      const GlyphPoint along = even[std::min(i + 1, count - 1)] - even[i - std::min<std::size_t>(i, 1)];
      const double l = geometry::length(along);
      points.emplace_back(even[i], l > 0 ? along * (1 / l) : GlyphPoint{});
    }
  }
  Cloud cloud{Eigen::MatrixX2d(static_cast<Eigen::Index>(points.size()), 2),
              Eigen::MatrixX2d(static_cast<Eigen::Index>(points.size()), 2)};
  for (std::size_t i = 0; i < points.size(); ++i)
    put(cloud, static_cast<Eigen::Index>(i), points[i].first, points[i].second);
  return cloud;
}

/// How much each point of the model (rows) belongs to each of the ink (columns).
struct Shares {
  Eigen::VectorXd of_model;  ///< sums of rows
  Eigen::MatrixX2d goal;     ///< for each row the sum of its points of ink
};

Shares shares_of(const Eigen::MatrixX2d& at, const Cloud& model, const Cloud& ink, double sigma) {
  // A right angle between directions counts as this many units.
  constexpr double kDirection = 7.0;
  // The share of a point of ink that belongs to no line.
  constexpr double kNone = 0.02;
  const double two_sigma2 = 2 * sigma * sigma;
  Shares s{Eigen::VectorXd::Zero(at.rows()), Eigen::MatrixX2d::Zero(at.rows(), 2)};
  Eigen::VectorXd p(at.rows());
  for (Eigen::Index n = 0; n < ink.at.rows(); ++n) {
    double sum = kNone;
    for (Eigen::Index m = 0; m < at.rows(); ++m) {
      const double d2 =
          (at.row(m) - ink.at.row(n)).squaredNorm() +
          kDirection * kDirection * 0.25 * (model.twice.row(m) - ink.twice.row(n)).squaredNorm();
      p[m] = d2 < 24 * two_sigma2 ? std::exp(-d2 / two_sigma2) : 0.0;
      sum += p[m];
    }
    for (Eigen::Index m = 0; m < at.rows(); ++m) {
      if (p[m] <= 0) continue;
      s.of_model[m] += p[m] / sum;
      s.goal.row(m) += p[m] / sum * ink.at.row(n);
    }
  }
  return s;
}

struct Box {
  double left = std::numeric_limits<double>::infinity();
  double top = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double bottom = -std::numeric_limits<double>::infinity();
  void add(GlyphPoint p) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
};

void bring_boxes_together(std::vector<GlyphLine>& lines, const Ridge& ridge) {
  Box from;
  Box to;
  for (const GlyphLine& line : lines)
    for (const GlyphPoint p : line) from.add(p);
  for (const RidgePoint& p : ridge.points) to.add(p.at);
  // A flat character gets the scale of its larger side in both directions.
  const auto scale = [](double own, double goal, double other) {
    return own > 12 && goal > 6 ? std::clamp(goal / own, 0.6 * other, 1.6 * other) : other;
  };
  const double wide = from.right - from.left;
  const double high = from.bottom - from.top;
  const double most = std::max({wide, high, 1e-3});
  const double whole = std::max({to.right - to.left, to.bottom - to.top, 1e-3}) / most;
  const double sx = scale(wide, to.right - to.left, whole);
  const double sy = scale(high, to.bottom - to.top, whole);
  for (GlyphLine& line : lines)
    for (GlyphPoint& p : line)
      p = {(to.left + to.right) / 2 + (p.x - (from.left + from.right) / 2) * sx,
           (to.top + to.bottom) / 2 + (p.y - (from.top + from.bottom) / 2) * sy};
}

}  // namespace

LaidOver laid_over(std::vector<GlyphLine> lines, const Ridge& ridge, bool is_in_place) {
  if (!is_in_place) bring_boxes_together(lines, ridge);
  const Cloud ink = cloud_of(ridge);
  LaidOver out;

  // As a whole: x -> A x + b, held back towards where it is, so that a single line does not turn freely.
  {
    const Cloud model = cloud_of(lines);
    Eigen::MatrixX2d at = model.at;
    Eigen::Matrix<double, 3, 2> map = Eigen::Matrix<double, 3, 2>::Zero();
    map.block<2, 2>(0, 0).setIdentity();
    const Eigen::RowVector2d middle = model.at.colwise().mean();
    Eigen::MatrixX3d own(at.rows(), 3);
    own << model.at.rowwise() - middle, Eigen::VectorXd::Ones(at.rows());
    Eigen::Matrix<double, 3, 2> start = Eigen::Matrix<double, 3, 2>::Zero();
    start.block<2, 2>(0, 0).setIdentity();
    start.row(2) = middle;
    map = start;
    for (const double sigma : {9.0, 8.0, 7.0, 6.0, 5.0, 4.5, 4.0, 3.5, 3.0, 3.0}) {
      const Shares s = shares_of(at, model, ink, sigma);
      Eigen::Matrix3d left = own.transpose() * s.of_model.asDiagonal() * own;
      Eigen::Matrix<double, 3, 2> right = own.transpose() * s.goal;
      const double total = s.of_model.sum();
      if (total < 1) break;
      const Eigen::Vector3d hold(40 * total, 40 * total, 1e-3 * total);
      left += hold.asDiagonal();
      right += hold.asDiagonal() * start;
      map = left.ldlt().solve(right);
      at = own * map;
    }
    for (GlyphLine& line : lines)
      for (GlyphPoint& p : line) {
        const Eigen::RowVector2d q = Eigen::RowVector3d(p.x - middle[0], p.y - middle[1], 1) * map;
        p = {q[0], q[1]};
      }
  }
  out.as_a_whole = lines;

  // Bent: y -> y + G w with a bell G as wide as a part of a character.
  constexpr double kWidth = 22.0;
  constexpr double kStiff = 0.6;
  const Cloud model = cloud_of(lines);
  const Eigen::Index count = model.at.rows();
  const auto bell = [](double d2) { return std::exp(-d2 / (2 * kWidth * kWidth)); };
  Eigen::MatrixXd g(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index k = 0; k <= i; ++k)
      g(i, k) = g(k, i) = bell((model.at.row(i) - model.at.row(k)).squaredNorm());
  Eigen::MatrixX2d weights = Eigen::MatrixX2d::Zero(count, 2);
  for (const double sigma : {4.0, 3.4, 2.8, 2.4, 2.0, 1.7, 1.5}) {
    const Eigen::MatrixX2d at = model.at + g * weights;
    const Shares s = shares_of(at, model, ink, sigma);
    Eigen::MatrixXd left = s.of_model.asDiagonal() * g;
    left.diagonal().array() += kStiff * sigma * sigma;
    const Eigen::MatrixX2d right = s.goal - s.of_model.asDiagonal() * model.at;
    weights = left.partialPivLu().solve(right);
  }
  for (GlyphLine& line : lines)
    for (GlyphPoint& p : line) {
      GlyphPoint d;
      for (Eigen::Index i = 0; i < count; ++i) {
        const double b = bell(std::pow(p.x - model.at(i, 0), 2) + std::pow(p.y - model.at(i, 1), 2));
        d = d + GlyphPoint{weights(i, 0), weights(i, 1)} * b;
      }
      p = p + d;
    }
  out.bent = std::move(lines);
  return out;
}

}  // namespace nazori::author
