// SPDX-License-Identifier: Apache-2.0
#include "polyline_crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nazori::functions {
namespace {

constexpr int kCells = 128;
constexpr std::size_t kMost = 400;

struct Piece {
  PlatePoint p;
  PlatePoint q;
  int statement;
  std::size_t branch;
  std::size_t index;
  std::size_t count;
  bool closed;
  double from;
  double to;
};

std::optional<Meeting> crossing(const Piece& a, const Piece& b) {
  const double ru = a.q.u - a.p.u;
  const double rv = a.q.v - a.p.v;
  const double su = b.q.u - b.p.u;
  const double sv = b.q.v - b.p.v;
  const double det = ru * sv - rv * su;
  if (std::abs(det) < 1e-18) return std::nullopt;
  const double wu = b.p.u - a.p.u;
  const double wv = b.p.v - a.p.v;
  const double t = (wu * sv - wv * su) / det;
  const double s = (wu * rv - wv * ru) / det;
  constexpr double kHair = 1e-9;
  if (t < -kHair || t > 1 + kHair || s < -kHair || s > 1 + kHair) return std::nullopt;
  return Meeting{
      {a.p.u + t * ru, a.p.v + t * rv}, a.from + t * (a.to - a.from), b.from + s * (b.to - b.from)};
}

bool neighbours(const Piece& a, const Piece& b) {
  if (a.branch != b.branch) return false;
  const std::size_t gap = a.index > b.index ? a.index - b.index : b.index - a.index;
  return gap <= 1 || (a.closed && gap + 1 >= a.count);
}

int cell_of(double c) { return std::clamp(static_cast<int>(std::floor(c * kCells)), 0, kCells - 1); }

}  // namespace

std::vector<Meeting> crossings_of(const Tracing& tracing, int a, int b) {
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < tracing.branches.size(); ++k) {
    const Branch& branch = tracing.branches[k];
    if (branch.statement != a && branch.statement != b) continue;
    const std::size_t n = branch.points.size() - 1;
    for (std::size_t i = 0; i < n; ++i) {
      const CurvePoint& p = branch.points[i];
      const CurvePoint& q = branch.points[i + 1];
      pieces.push_back(
          {{p.u, p.v}, {q.u, q.v}, branch.statement, k, i, n, branch.closed, p.parameter, q.parameter});
    }
  }
  std::vector<std::vector<std::size_t>> grid(static_cast<std::size_t>(kCells) * kCells);
  std::vector<Meeting> found;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& s = pieces[i];
    if (std::max(s.p.u, s.q.u) < 0 || std::min(s.p.u, s.q.u) > 1 || std::max(s.p.v, s.q.v) < 0 ||
        std::min(s.p.v, s.q.v) > 1)
      continue;
    for (int r = cell_of(std::min(s.p.v, s.q.v)); r <= cell_of(std::max(s.p.v, s.q.v)); ++r) {
      for (int c = cell_of(std::min(s.p.u, s.q.u)); c <= cell_of(std::max(s.p.u, s.q.u)); ++c) {
        auto& bucket = grid[static_cast<std::size_t>(r * kCells + c)];
        for (const std::size_t j : bucket) {
          const Piece& o = pieces[j];
          if (a != b ? o.statement == s.statement : neighbours(o, s)) continue;
          const auto at = crossing(o, s);
          if (!at) continue;
          const auto same = [&](const Meeting& m) {
            return std::hypot(m.at.u - at->at.u, m.at.v - at->at.v) < 1e-4;
          };
          if (std::none_of(found.begin(), found.end(), same)) found.push_back(*at);
          if (found.size() >= kMost) return found;
        }
        bucket.push_back(i);
      }
    }
  }
  return found;
}

}  // namespace nazori::functions
