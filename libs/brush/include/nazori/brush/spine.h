// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace nazori::brush {

/// A point of the plane in which a spine bends, in lengths of the hair: x along the paper, z up, paper at z =
/// 0.
struct SpinePoint {
  double x = 0;
  double z = 0;
};

/// The form of a spine. Lengths are in lengths of the hair and stiffnesses in EI at the root, so one form
/// serves brushes of all sizes.
struct SpineForm {
  int segments = 6;        ///< 1..Spine::kMostSegments
  double tip_segment = 1;  ///< length of the last segment over that of the first, > 0
  double taper = 1;        ///< radius of the tuft at the tip over that at the root, > 0
  double thickness = 0;    ///< height of the middle line over the paper where the root lies on it [L]
  double bulge = 4;        ///< how full the tuft is: that height falls as 1 - along^bulge to the tip
  double taper_power = 2;  ///< bending stiffness EI ~ radius^power: 4 for a solid rod, 2 for loose hair
  double own_bend_rad =
      0.005;  ///< bend of the whole hair at rest: decides to which side a straight tuft bends
};

/// What resists the motion of a spine besides its elasticity. All zero: purely elastic.
struct SpineFriction {
  double paper = 0;        ///< coefficient of friction between hair and paper, >= 0
  double along_hair = 0;   ///< 0..1: share of `paper` that is missing where hair is dragged along its lie
  double exponent = 1;     ///< how sharply that depends on the direction, > 0
  double sideways = 300;   ///< stiffness of the friction of a node before it slips [EI/L^3], > 0
  double yield_rad = 0;    ///< a joint that is bent further keeps a part of its bend; > 0 with keeps_rad
  double keeps_rad = 0;    ///< largest bend that a joint keeps after it is released
  double inner_share = 0;  ///< hair on hair: stiffness of the inner friction over that of the joint
  double inner_rad = 0;    ///< change of the bend at which hairs slip past each other
};

/// Where the holder of the brush is: the root of the hair and its direction there.
struct SpinePose {
  SpinePoint root;
  double tilt_rad = 0;  ///< of the hair at its root, from straight down towards +x
};

/// The middle line of a tuft of hair that is pressed on paper, in one upright plane: straight segments with
/// elastic joints, whose energy is at a minimum.
///
/// The energy is that of the bent joints, of the paper, which no node may enter, and of friction as springs
/// that slip at their limit. The minimum is found by Newton's method from the previous shape; the paper is an
/// augmented Lagrangian, so the force of each node is its multiplier. A move is made in small steps. A step
/// that does not converge keeps the last good shape.
///
/// Units: lengths in lengths of the hair L, forces in EI/L^2, moments in EI/L, EI at the root.
/// @source W. Baxter, M. Lin, A versatile interactive 3D brush model, Pacific Graphics 2004 (minimum of
/// energy); N. Chu, C.-L. Tai, Real-time painting with an expressive virtual Chinese brush, IEEE CG&A 24(5),
/// 2004 (friction with anisotropy, plasticity); J. Nocedal, S. Wright, Numerical Optimization, 2006, chapter
/// 17 (augmented Lagrangian). Thread-safe: no. Allocates nothing.
class Spine {
 public:
  static constexpr int kMostSegments = 24;
  static constexpr double kStep = 0.02;      ///< longest step of the root [L]
  static constexpr double kTurn_rad = 0.05;  ///< largest step of the tilt
  static constexpr int kMostSteps = 64;      ///< of one move; a longer move has longer steps
  static constexpr double kTouching =
      1e-3;  ///< a node that is at most so far above its clearance touches [L]

  explicit Spine(const SpineForm& form, const SpineFriction& friction = {});

  /// The shape at `pose`, forgetting all that happened: straight, or as the paper bends it from there.
  void place(const SpinePose& pose) noexcept;
  /// Moves the root to `pose` in small steps; the nodes follow.
  /// @return false if at least one step did not converge; the shape and pose() are then the last good ones.
  bool move_to(const SpinePose& pose) noexcept;
  /// Moves the origin of x by `by`: the spine, and the places on the paper that hold it.
  void shift(double by) noexcept;
  /// Mirrors everything at x = 0.
  void mirror() noexcept;
  /// A force on the tip, besides paper and friction, from the next move on.
  void set_tip_force(SpinePoint force) noexcept { tip_force_ = force; }
  void set_friction(const SpineFriction& friction) noexcept { friction_ = friction; }

  [[nodiscard]] int segments() const noexcept { return n_; }
  [[nodiscard]] const SpinePose& pose() const noexcept { return pose_; }
  /// Root first, tip last: segments() + 1 of them, none nearer to the paper than clearances().
  [[nodiscard]] std::span<const SpinePoint> nodes() const noexcept {
    return {nodes_.data(), static_cast<std::size_t>(n_) + 1};
  }
  /// Distance along the hair of each node from the root [L].
  [[nodiscard]] std::span<const double> along() const noexcept {
    return {along_.data(), static_cast<std::size_t>(n_) + 1};
  }
  /// Height over the paper at which each node touches it [L], >= 0.
  [[nodiscard]] std::span<const double> clearances() const noexcept {
    return {clear_.data(), static_cast<std::size_t>(n_) + 1};
  }
  /// Push of the paper on each node, upwards, >= 0.
  [[nodiscard]] std::span<const double> pushes() const noexcept {
    return {push_.data(), static_cast<std::size_t>(n_) + 1};
  }
  /// Friction of the paper on each node, along x: at most paper x push.
  [[nodiscard]] std::span<const double> drags() const noexcept {
    return {drag_.data(), static_cast<std::size_t>(n_) + 1};
  }
  /// Sum of pushes().
  [[nodiscard]] double push() const noexcept;
  /// Sum of drags().
  [[nodiscard]] double drag() const noexcept;
  /// Angle of each joint [rad], from the root on.
  [[nodiscard]] std::span<const double> bends() const noexcept {
    return {bend_.data(), static_cast<std::size_t>(n_)};
  }
  /// Newton steps of the last move.
  [[nodiscard]] int iterations() const noexcept { return iterations_; }

 private:
  static constexpr std::size_t kSize = kMostSegments;
  using Joints = std::array<double, kSize>;
  using Nodes = std::array<double, kSize + 1>;
  using Matrix = std::array<Joints, kSize>;

  void lay_out(const Joints& bend, const SpinePose& pose,
               std::array<SpinePoint, kSize + 1>& nodes) const noexcept;
  [[nodiscard]] double energy(const Joints& bend,
                              const std::array<SpinePoint, kSize + 1>& nodes) const noexcept;
  void derivatives(const Joints& bend, const std::array<SpinePoint, kSize + 1>& nodes, Joints& gradient,
                   Matrix& curvature) const noexcept;
  [[nodiscard]] bool minimise(Joints& bend, const SpinePose& pose,
                              std::array<SpinePoint, kSize + 1>& nodes) noexcept;
  [[nodiscard]] bool step_to(const SpinePose& pose) noexcept;
  [[nodiscard]] double limit(std::size_t node, const std::array<SpinePoint, kSize + 1>& nodes,
                             double push) const noexcept;
  void settle() noexcept;

  int n_;
  Joints length_{}, stiffness_{}, rest_{};
  Nodes along_{}, clear_{};
  SpineFriction friction_;
  SpinePoint tip_force_;

  SpinePose pose_;
  Joints bend_{};   // angle of each joint
  Joints kept_{};   // angle at which the joint has no moment
  Joints inner_{};  // angle at which the inner friction of the joint has no moment
  std::array<SpinePoint, kSize + 1> nodes_{};
  Nodes push_{}, drag_{};
  Nodes anchor_{};  // x at which the friction of the node has no force
  Nodes limit_{};   // of the friction, while the minimum is searched
  int iterations_ = 0;
};

}  // namespace nazori::brush
