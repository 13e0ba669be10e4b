// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/spine.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "resistance.h"

namespace nazori::brush {
namespace {

constexpr double kPaper = 2000;   // stiffness of the paper between two updates of the multipliers
constexpr double kStill = 1e-6;   // a gradient below this counts as none
constexpr double kAtRest = 1e-5;  // entering the paper by less counts as none
constexpr int kMostNewton = 40;
constexpr int kMostUpdates = 12;      // of the multipliers
constexpr double kLongestTurn = 0.4;  // of one joint in one Newton step [rad]

}  // namespace

Spine::Spine(const SpineForm& form, const SpineFriction& friction) : n_(form.segments), friction_(friction) {
  assert(n_ >= 1 && n_ <= kMostSegments && form.tip_segment > 0 && form.taper > 0);
  const auto n = static_cast<std::size_t>(n_);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double share = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.0;
    length_[i] = std::pow(form.tip_segment, share);
    sum += length_[i];
  }
  for (std::size_t i = 0; i < n; ++i) {
    length_[i] /= sum;
    along_[i + 1] = along_[i] + length_[i];
  }
  for (std::size_t k = 1; k < n; ++k) clear_[k] = form.thickness * (1 - std::pow(along_[k], form.bulge));
  for (std::size_t i = 0; i < n; ++i) {
    const double radius = 1 + (form.taper - 1) * along_[i];
    // Half a segment on each side of a joint bends at it. Behind the root joint is the holder, which is
    // stiff.
    const double bends = i == 0 ? 0.5 * length_[0] : 0.5 * (length_[i - 1] + length_[i]);
    stiffness_[i] = std::pow(radius, form.taper_power) / bends;
    rest_[i] = form.own_bend_rad / n_;
  }
  place({{0, 1}, 0});
}

void Spine::lay_out(const Joints& bend, const SpinePose& pose,
                    std::array<SpinePoint, kSize + 1>& nodes) const noexcept {
  double angle = pose.tilt_rad;
  nodes[0] = pose.root;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n_); ++i) {
    angle += bend[i];
    nodes[i + 1] = {nodes[i].x + length_[i] * std::sin(angle), nodes[i].z - length_[i] * std::cos(angle)};
  }
}

double Spine::energy(const Joints& bend, const std::array<SpinePoint, kSize + 1>& nodes) const noexcept {
  const auto n = static_cast<std::size_t>(n_);
  double sum = -tip_force_.x * nodes[n].x - tip_force_.z * nodes[n].z;
  for (std::size_t i = 0; i < n; ++i) {
    sum +=
        keeping(bend[i], kept_[i], stiffness_[i], friction_.yield_rad, friction_.keeps_rad, rest_[i]).energy;
    sum += slipping(bend[i] - inner_[i], stiffness_[i] * friction_.inner_share, friction_.inner_rad).energy;
  }
  for (std::size_t k = 1; k <= n; ++k) {
    const double push = std::max(0.0, push_[k] - kPaper * (nodes[k].z - clear_[k]));
    sum += 0.5 * push * push / kPaper;
    sum += slipping(nodes[k].x - anchor_[k], friction_.sideways, limit_[k] / friction_.sideways).energy;
  }
  return sum;
}

void Spine::derivatives(const Joints& bend, const std::array<SpinePoint, kSize + 1>& nodes, Joints& gradient,
                        Matrix& curvature) const noexcept {
  const auto n = static_cast<std::size_t>(n_);
  Nodes fx, fz, kx, kz;  // derivatives of the energy by the place of each node
  for (std::size_t k = 1; k <= n; ++k) {
    const double push = push_[k] - kPaper * (nodes[k].z - clear_[k]);
    fz[k] = push > 0 ? -push : 0.0;
    kz[k] = push > 0 ? kPaper : 0.0;
    const Resistance drag =
        slipping(nodes[k].x - anchor_[k], friction_.sideways, limit_[k] / friction_.sideways);
    fx[k] = drag.moment;
    kx[k] = drag.stiffness;
  }
  fx[n] -= tip_force_.x;
  fz[n] -= tip_force_.z;
  // A joint turns all nodes beyond it: dx/dbend = z(joint) - z(node), dz/dbend = x(node) - x(joint).
  for (std::size_t i = 0; i < n; ++i) {
    const Resistance elastic =
        keeping(bend[i], kept_[i], stiffness_[i], friction_.yield_rad, friction_.keeps_rad, rest_[i]);
    const Resistance inner =
        slipping(bend[i] - inner_[i], stiffness_[i] * friction_.inner_share, friction_.inner_rad);
    gradient[i] = elastic.moment + inner.moment;
    for (std::size_t k = i + 1; k <= n; ++k)
      gradient[i] += fx[k] * (nodes[i].z - nodes[k].z) + fz[k] * (nodes[k].x - nodes[i].x);
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = i == j ? elastic.stiffness + inner.stiffness : 0.0;
      for (std::size_t k = i + 1; k <= n; ++k) {
        sum += kx[k] * (nodes[i].z - nodes[k].z) * (nodes[j].z - nodes[k].z);
        sum += kz[k] * (nodes[k].x - nodes[i].x) * (nodes[k].x - nodes[j].x);
        sum += fx[k] * (nodes[i].x - nodes[k].x) + fz[k] * (nodes[i].z - nodes[k].z);
      }
      curvature[i][j] = sum;
    }
  }
}

bool Spine::minimise(Joints& bend, const SpinePose& pose, std::array<SpinePoint, kSize + 1>& nodes) noexcept {
  const auto n = static_cast<std::size_t>(n_);
  // Only the first n of each are used, and written before they are read: clearing 10 kB here would take
  // longer than the work itself.
  Joints gradient, way, trial{};
  Matrix curvature, factor;
  std::array<SpinePoint, kSize + 1> there;
  lay_out(bend, pose, nodes);
  double now = energy(bend, nodes);
  for (int iteration = 0; iteration < kMostNewton; ++iteration) {
    derivatives(bend, nodes, gradient, curvature);
    double steepest = 0;
    for (std::size_t i = 0; i < n; ++i) steepest = std::max(steepest, std::abs(gradient[i]));
    if (!(steepest < 1e9)) return false;
    if (steepest < kStill) return true;
    ++iterations_;
    // Cholesky's factors; where the energy is not convex, of the curvature with more on its diagonal.
    const auto is_factored = [&](double added) {
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          double sum = curvature[i][j] + (i == j ? added : 0.0);
          for (std::size_t k = 0; k < j; ++k) sum -= factor[i][k] * factor[j][k];
          if (i != j) {
            factor[i][j] = sum / factor[j][j];
          } else if (sum > 1e-9) {
            factor[i][i] = std::sqrt(sum);
          } else {
            return false;
          }
        }
      }
      return true;
    };
    for (double added = 0; !is_factored(added);) {
      added = added > 0 ? 4 * added : 0.05;
      if (added > 1e9) return false;
    }
    for (std::size_t i = 0; i < n; ++i) {
      double sum = -gradient[i];
      for (std::size_t k = 0; k < i; ++k) sum -= factor[i][k] * way[k];
      way[i] = sum / factor[i][i];
    }
    double largest = 0;
    double slope = 0;
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = i + 1; k < n; ++k) way[i] -= factor[k][i] * way[k];
      way[i] /= factor[i][i];
      largest = std::max(largest, std::abs(way[i]));
      slope += way[i] * gradient[i];
    }
    double part = largest > kLongestTurn ? kLongestTurn / largest : 1.0;
    bool lower = false;
    for (int halving = 0; halving < 20; ++halving, part /= 2) {
      for (std::size_t i = 0; i < n; ++i) trial[i] = bend[i] + part * way[i];
      lay_out(trial, pose, there);
      const double then = energy(trial, there);
      // Near the minimum the energy changes by less than its rounding.
      if (then <= now + 1e-4 * part * slope + 1e-14 * (1 + std::abs(now))) {
        lower = true;
        now = then;
        break;
      }
    }
    if (!lower) return steepest < 1e-3;
    bend = trial;
    nodes = there;
  }
  return false;
}

double Spine::limit(std::size_t node, const std::array<SpinePoint, kSize + 1>& nodes,
                    double push) const noexcept {
  double coefficient = friction_.paper;
  if (friction_.along_hair > 0) {
    // Hair that is dragged behind its root slides easily: it moves against the way from root to tip.
    const double slip = nodes[node].x - anchor_[node];
    const double lies = (nodes[node].x - nodes[node - 1].x) / length_[node - 1];
    const double along = std::clamp(slip > 0 ? -lies : lies, 0.0, 1.0);
    coefficient *= 1 - friction_.along_hair * std::pow(along, friction_.exponent);
  }
  return coefficient * push;
}

bool Spine::step_to(const SpinePose& pose) noexcept {
  const auto n = static_cast<std::size_t>(n_);
  const Nodes pushes_before = push_;
  Joints bend = bend_;
  std::array<SpinePoint, kSize + 1> nodes = nodes_;
  bool good = false;
  for (std::size_t k = 1; k <= n; ++k) limit_[k] = limit(k, nodes, push_[k]);
  for (int update = 0; update < kMostUpdates; ++update) {
    good = minimise(bend, pose, nodes);
    if (!good) break;
    double entered = 0, changed = 0, total = 0;
    for (std::size_t k = 1; k <= n; ++k) {
      const double push = std::max(0.0, push_[k] - kPaper * (nodes[k].z - clear_[k]));
      entered = std::max(entered, push > 0 ? std::abs(nodes[k].z - clear_[k]) : clear_[k] - nodes[k].z);
      push_[k] = push;
      total += push;
    }
    for (std::size_t k = 1; k <= n; ++k) {
      const double now = limit(k, nodes, push_[k]);
      changed = std::max(changed, std::abs(now - limit_[k]));
      limit_[k] = now;
    }
    // Near a snap friction may go on changing a little; settle() holds it to its limit.
    good = entered < kTouching;
    if (entered < kAtRest && changed <= 1e-3 * (friction_.paper * total + 1e-3)) break;
  }
  if (!good) {
    // The last good shape where it was: the next step tries again from there.
    push_ = pushes_before;
    return false;
  }
  bend_ = bend;
  nodes_ = nodes;
  pose_ = pose;
  settle();
  return true;
}

/// What slipped stays slipped.
void Spine::settle() noexcept {
  const auto n = static_cast<std::size_t>(n_);
  for (std::size_t i = 0; i < n; ++i) {
    if (friction_.keeps_rad > 0) {
      const double e = bend_[i] - kept_[i];
      if (std::abs(e) > friction_.yield_rad) {
        const double moved = bend_[i] - std::copysign(friction_.yield_rad, e);
        // A zero that lies beyond the limit, because the limit became less, stays until the bend is less.
        const double least = std::min(rest_[i] - friction_.keeps_rad, kept_[i]);
        const double most = std::max(rest_[i] + friction_.keeps_rad, kept_[i]);
        kept_[i] = std::clamp(moved, least, most);
      }
    }
    const double stretch = bend_[i] - inner_[i];
    if (std::abs(stretch) > friction_.inner_rad)
      inner_[i] = bend_[i] - std::copysign(friction_.inner_rad, stretch);
  }
  for (std::size_t k = 1; k <= n; ++k) {
    nodes_[k].z = std::max(clear_[k], nodes_[k].z);
    const double most = limit_[k] / friction_.sideways;
    anchor_[k] = nodes_[k].x - std::clamp(nodes_[k].x - anchor_[k], -most, most);
    drag_[k] = -friction_.sideways * (nodes_[k].x - anchor_[k]);
  }
}

void Spine::place(const SpinePose& pose) noexcept {
  bend_ = kept_ = inner_ = rest_;
  push_ = drag_ = limit_ = {};
  // From just above the paper downwards, as a hand does it.
  SpinePose above = pose;
  above.root.z = std::max(pose.root.z, 1.1);
  pose_ = above;
  lay_out(bend_, pose_, nodes_);
  for (std::size_t k = 0; k <= static_cast<std::size_t>(n_); ++k) anchor_[k] = nodes_[k].x;
  (void)move_to(pose);
}

bool Spine::move_to(const SpinePose& pose) noexcept {
  iterations_ = 0;
  const SpinePose from = pose_;
  if (!(std::isfinite(pose.root.x) && std::isfinite(pose.root.z) && std::isfinite(pose.tilt_rad)))
    return false;
  const double far = std::max(std::abs(pose.root.x - from.root.x), std::abs(pose.root.z - from.root.z));
  const double turn = std::abs(pose.tilt_rad - from.tilt_rad);
  const double needed = std::ceil(std::max(far / kStep, turn / kTurn_rad));
  const int steps = static_cast<int>(std::clamp(needed, 1.0, static_cast<double>(kMostSteps)));
  bool good = true;
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const SpinePose next{
        {from.root.x + t * (pose.root.x - from.root.x), from.root.z + t * (pose.root.z - from.root.z)},
        from.tilt_rad + t * (pose.tilt_rad - from.tilt_rad)};
    good = step_to(i < steps ? next : pose) && good;
  }
  return good;
}

void Spine::shift(double by) noexcept {
  pose_.root.x += by;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(n_); ++k) {
    nodes_[k].x += by;
    anchor_[k] += by;
  }
}

void Spine::mirror() noexcept {
  pose_.root.x = -pose_.root.x;
  pose_.tilt_rad = -pose_.tilt_rad;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(n_); ++k) {
    nodes_[k].x = -nodes_[k].x;
    anchor_[k] = -anchor_[k];
    drag_[k] = -drag_[k];
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(n_); ++i) {
    bend_[i] = -bend_[i];
    kept_[i] = -kept_[i];
    inner_[i] = -inner_[i];
  }
}

double Spine::push() const noexcept {
  double sum = 0;
  for (const double push : pushes()) sum += push;
  return sum;
}

double Spine::drag() const noexcept {
  double sum = 0;
  for (const double drag : drags()) sum += drag;
  return sum;
}

}  // namespace nazori::brush
