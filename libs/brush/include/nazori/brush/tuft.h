// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "nazori/brush/spine.h"
#include "nazori/brush/tuft_form.h"
#include "nazori/geometry/bristle_segment.h"

namespace nazori::brush {

/// How a hand holds a brush at one moment.
struct HolderPose {
  double time_s = 0;        ///< from an arbitrary zero, never decreasing
  geometry::PaperPoint at;  ///< where the axis of the holder meets the paper: the tip of a pen
  double depth_m = 0;       ///< pressed beyond first touch; negative: lifted so far above it
  double lean_rad = 0;      ///< between the holder and upright, 0..Tuft::kMostLean_rad
  double lean_to_rad = 0;   ///< to which side its upper end leans, from x to y
  double twist_rad = 0;     ///< of the holder about its axis, from x to y
};

/// A cross-section of the tuft, for drawing it.
struct TuftSection {
  geometry::PaperPoint at;  ///< of its middle, on the paper
  double z_m = 0;           ///< of its middle, above the paper
  double rise_rad = 0;      ///< of the hair at the section against the paper: 0 lies flat, pi/2 stands
  double half_width_m = 0;  ///< to either side
  double thickness_m = 0;   ///< from the lowest to the highest hair
};

/// A tuft of hair on paper: its bend, its spread, and what each of its bristles sweeps.
///
/// The spine bends in the upright plane through the holder's foot and the patch of contact. Friction tows the
/// patch behind the foot, so this plane turns as a trailer does, on a tractrix. The cross-section spreads to
/// the sides and becomes thinner by as much, so its area stays. Bristles have fixed places in the section at
/// the root; the spine carries them. A bristle touches where it is lower than the tooth of the paper, and
/// sweeps a band from one position to the next. A dry tuft splits into clumps.
///
/// A move is made in steps of at most Spine::kStep of the hair, whatever its length, so the result does not
/// depend on how often the pen is reported.
/// @source as Spine; the towed patch: P. Karimov et al., 2024, and the robot e-David; constant area and
/// split tufts: Chu and Tai, 2004. Thread-safe: no.
class Tuft {
 public:
  static constexpr int kBristles = 400;
  static constexpr double kMostLean_rad = 1.1;
  static constexpr double kMostDepth = 0.6;  ///< of the length of the hair; a deeper pose counts as this

  explicit Tuft(const TuftForm& form, int bristles = kBristles);

  /// Water in the tuft, 0..1 of what it holds; decides about splitting, friction and what bristles offer.
  void set_wetness(double wetness) noexcept;
  /// Pigment in that water, 0..1 of undiluted ink.
  void set_pigment(double pigment) noexcept;

  /// Lifts the tuft, straightens it and points it towards `points_to_rad`: as it comes out of the ink.
  void reset(double points_to_rad = kPointsTo_rad) noexcept;
  /// Moves the holder to `pose` and appends what each bristle swept since the last pose. The first pose after
  /// a reset sweeps nothing unless it touches. A pose with a number that is not finite is ignored.
  void move_to(const HolderPose& pose, std::vector<geometry::BristleSegment>& swept);

  [[nodiscard]] const TuftForm& form() const noexcept { return form_; }
  [[nodiscard]] double wetness() const noexcept { return wetness_; }
  /// Push of the paper on the tuft [N], >= 0.
  [[nodiscard]] double push_n() const noexcept;
  [[nodiscard]] bool touching() const noexcept { return touching_ > 0; }
  /// Bristles that touch.
  [[nodiscard]] int bristles_touching() const noexcept { return touching_; }
  /// Direction on the paper from the holder's foot towards the tip, from x to y.
  [[nodiscard]] double points_to_rad() const noexcept { return azimuth_; }
  /// Breadth of the patch of contact across points_to_rad() [m]; 0 without contact.
  [[nodiscard]] double width_m() const noexcept { return width_m_; }
  /// Length of the patch of contact along points_to_rad() [m].
  [[nodiscard]] double patch_m() const noexcept { return patch_m_; }
  /// From the holder's foot to the middle of that patch, along points_to_rad() [m]; 0 without contact.
  [[nodiscard]] double reach_m() const noexcept { return reach_m_; }
  /// The middle of that patch; without contact the holder's foot.
  [[nodiscard]] geometry::PaperPoint patch_at() const noexcept;
  /// The shape from root to tip, for drawing: one section at each node of the spine.
  [[nodiscard]] std::vector<TuftSection> sections() const;

  /// Where the tip points at first: up to the left, as a right-handed writer is taught to enter a stroke.
  static constexpr double kPointsTo_rad = 2.356194490192345;

 private:
  struct Place {
    double x, y;              // in the section at the root, within the unit circle
    double clump_x, clump_y;  // centre of the clump that it joins when dry
    double end;               // length over that of the longest hair
  };
  /// Contact of a bristle: middle, and from there to its tip's end, on the paper.
  struct Contact {
    geometry::PaperPoint middle, half;
    double pressure = -1;  // < 0: none
    double band_m = 0;     // breadth of the bristle
    double reach_m = 0;    // length of half
  };
  struct Station;

  void step_to(const HolderPose& pose);
  [[nodiscard]] SpinePose spine_pose(const HolderPose& pose) const noexcept;
  void tow(geometry::PaperPoint by) noexcept;
  void touch(std::vector<Contact>& contacts);
  void sweep(double seconds, std::vector<geometry::BristleSegment>& swept) const;
  [[nodiscard]] double depth() const noexcept;
  [[nodiscard]] double spread() const noexcept;
  [[nodiscard]] double radius_m(double along) const noexcept;
  [[nodiscard]] double splitting() const noexcept;

  TuftForm form_;
  Spine spine_;
  std::vector<Place> places_;
  std::vector<Contact> before_, now_;
  HolderPose pose_;
  bool placed_ = false;
  double wetness_ = 1, pigment_ = 1;
  double azimuth_ = kPointsTo_rad;
  int touching_ = 0;
  double width_m_ = 0, patch_m_ = 0, reach_m_ = 0;
};

}  // namespace nazori::brush
