// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "nazori/base/result.h"
#include "nazori/geometry/frames.h"
#include "nazori/surface/height_map.h"
#include "nazori/surface/smooth_surface.h"

namespace nazori::surface {

/// The largest ball of a stylus [m].
inline constexpr double kLargestBall_m = 0.003;

/// The heights at which the lowest point of a ball is that rests on the SmoothSurface of a map: the surface
/// dilated by the ball and lowered by its radius. On the plateau it is 1, as the map is; it is nowhere below
/// the map's surface.
///
/// Each height is the largest over contacts at the samples, raised to the contact between them that is near
/// the best of these. Where the ball covers less than four samples to each side, the points that are tried
/// are a quarter of the radius or half a sample apart, whatever is less. On walls steeper than the distance
/// of these points resolves, two contacts that are almost equally good may be confused, so that the height is
/// too low by the little that the samples differ there; never too high by more than 2 micrometres on a ball
/// of more than eight samples. Contacts are searched on the map: beyond the edge, where it goes on level, no
/// other is higher by more than the edge bends.
///
/// @param shape  of the tablet, both sizes above 0. @param radius_m  0 (the map's surface at the samples) to
/// a quarter of the width.
/// @return Errc::bad_argument for an empty map and sizes out of range. Uses up to four threads while it runs;
/// the result does not depend on how many. Thread-safe: yes. Real-time-safe: no.
[[nodiscard]] base::Result<HeightMap> heights_under_ball(const HeightMap& map,
                                                         const geometry::TabletShape& shape, double radius_m);

/// Control heights whose SmoothSurface passes through `heights` at the samples wherever the bend changes
/// little from sample to sample. A kink is rounded as SmoothSurface rounds it, so that nothing rings.
[[nodiscard]] HeightMap controls_through(const HeightMap& heights);

/// The surface that the lowest point of a ball feels: a point that moves on it moves as the ball does on the
/// map. Radius 0: the SmoothSurface of the map itself.
/// @return as heights_under_ball.
[[nodiscard]] base::Result<std::shared_ptr<const SmoothSurface>> surface_for_ball(
    const HeightMap& map, const geometry::TabletShape& shape, double radius_m);

}  // namespace nazori::surface
