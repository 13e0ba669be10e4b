// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numbers>

#include "nazori/base/result.h"
#include "nazori/geometry/frames.h"
#include "nazori/haptics/haptic_device.h"

namespace nazori::devices {

/// The box that a stylus can reach, in metres in the device frame.
///
/// Device frame, the same for every back end: seen by someone who faces the base of the device, x right, y up
/// against gravity, z towards that person. The origin is the device's own.
struct DeviceWorkspace {
  haptics::Vec3 low_m{-0.080, -0.060, -0.035};
  haptics::Vec3 high_m{0.080, 0.060, 0.035};
};

enum class WritingHand : std::uint8_t { right, left };

/// The pose of the tablet that the learner has chosen.
struct TabletPosture {
  double tilt_rad = std::numbers::pi / 2;  ///< 0 lies flat, pi/2 stands upright
  /// How far the learner sits turned from the front of the device, about the vertical, towards the writing
  /// hand.
  double yaw_rad = 0;
  WritingHand hand = WritingHand::right;
};

/// Where the tablet lies in a device's workspace. Plain values that can be stored directly.
struct WorkspaceCalibration {
  double scale = 1;  ///< metres on the tablet per metre of the stylus; the same in all directions
  haptics::Vec3 centre_m{0, 0, 0};  ///< device frame: the middle of the tablet's plateau
  TabletPosture posture;
  double roll_rad = 0;  ///< the tablet turned in its own plane, anticlockwise
};

/// Converts between the device frame and the tablet frame: a rotation, a translation and one scale, so that
/// slopes, angles and friction are unchanged.
///
/// Forces are rotated but not scaled. A spring of K in the tablet frame is then one of K * scale at the
/// stylus, and energy in the tablet frame is the energy at the stylus times the scale. So what is passive in
/// one frame is passive in the other. Thread-safe: yes, immutable. Real-time-safe: all but create().
class WorkspaceMapping {
 public:
  /// @return Errc::bad_argument for numbers that are not finite, a scale outside 0.02..50, a centre more than
  ///   2 m away, a tilt outside 0..pi/2 by more than 0.2 rad.
  [[nodiscard]] static base::Result<WorkspaceMapping> create(const WorkspaceCalibration& calibration);

  [[nodiscard]] haptics::Vec3 to_tablet_m(const haptics::Vec3& device_m) const noexcept;
  [[nodiscard]] haptics::Vec3 to_device_m(const haptics::Vec3& tablet_m) const noexcept;
  [[nodiscard]] haptics::Vec3 to_tablet_n(const haptics::Vec3& device_n) const noexcept;
  [[nodiscard]] haptics::Vec3 to_device_n(const haptics::Vec3& tablet_n) const noexcept;

  /// The device's limits as the servo must apply them in the tablet frame: forces and slew unchanged,
  /// stiffness and damping divided by the scale.
  [[nodiscard]] haptics::DeviceLimits to_tablet(haptics::DeviceLimits device) const noexcept;

  [[nodiscard]] const WorkspaceCalibration& calibration() const noexcept { return calibration_; }

 private:
  explicit WorkspaceMapping(const WorkspaceCalibration& calibration);
  WorkspaceCalibration calibration_;
  haptics::Vec3 x_, y_, z_;  // the tablet's axes in the device frame
};

/// Height above the plateau that fit_workspace() keeps within reach.
inline constexpr double kRoomAbove_m = 0.020;

/// The largest tablet that lies completely within the workspace, with kRoomAbove_m above it and a margin of a
/// tenth.
/// @param workspace  if it is empty or not finite, the default one is used.
[[nodiscard]] WorkspaceCalibration fit_workspace(const DeviceWorkspace& workspace,
                                                 const geometry::TabletShape& shape,
                                                 const TabletPosture& posture);

/// The calibration that puts the tablet where the learner showed three of its corners with the stylus.
/// @param bottom_left_m,bottom_right_m,top_left_m  device frame.
/// @return Errc::bad_argument, in one sentence for the learner, where the corners are closer than 20 mm, not
/// at
///   a right angle by more than 20 degrees, or one side is more than 1.5 times as long as the other.
[[nodiscard]] base::Result<WorkspaceCalibration> calibrate_from_corners(const haptics::Vec3& bottom_left_m,
                                                                        const haptics::Vec3& bottom_right_m,
                                                                        const haptics::Vec3& top_left_m,
                                                                        const geometry::TabletShape& shape,
                                                                        WritingHand hand);

}  // namespace nazori::devices
