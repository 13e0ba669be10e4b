// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "nazori/view/tablet_view.h"

namespace nazori::ui {

/// How hands move the camera. Pure: a camera goes in, a camera comes out, held within what can be seen.
namespace camera_motion {

inline constexpr double kMaxTilt = 1.30;
inline constexpr double kMinZoom = 0.5;
inline constexpr double kMaxZoom = 12.0;

/// Turns by the drag: right turns the tablet to the right, down tilts it up towards the eye. @param drag  in
/// logical pixels.
[[nodiscard]] view::Camera orbit(view::Camera camera, glm::dvec2 drag);

/// Keeps the point that was grabbed under the pointer. @param grabbed,now  points of the plateau under the
/// old and the new pixel with `camera`.
[[nodiscard]] view::Camera pan(view::Camera camera, geometry::TabletPoint grabbed, geometry::TabletPoint now);

[[nodiscard]] view::Camera zoom(view::Camera camera, double factor);

/// The camera `share` of the way from one to the other, eased.
[[nodiscard]] view::Camera between(const view::Camera& from, const view::Camera& to, double share);

/// Where the classic style and the others begin.
[[nodiscard]] view::Camera home();

}  // namespace camera_motion
}  // namespace nazori::ui
