// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/haptics/haptic_scene.h"

namespace nazori::haptics {

/// Steepest slope that a texture of roughness 1 imitates: tan 27 degrees.
constexpr double kSteepestTexture = 0.5;

/// Slope of the fine bumps of `texture` at a point of the plateau, as dz/dx and dz/dy; z is 0. It is the
/// gradient of a noise of fixed size (no feature finer than 0.4 mm), so at constant pressure a closed path
/// over it neither takes nor gives energy. Length at most kSteepestTexture. The same point always has the
/// same slope.
[[nodiscard]] Vec3 texture_slope(Texture texture, double x_m, double y_m) noexcept;

/// The contact force `force_n` with its part along `normal` tilted as if the surface there had the texture's
/// slope. That part keeps its length; the friction along the surface does not change. The proxy is not moved.
///
/// @param normal  unit.  @param roughness  0..1.
/// @source bump mapping: C. Basdogan, C.-H. Ho, M. Srinivasan, A ray-based haptic rendering technique for
/// displaying shape and texture, ASME DSC-61, 1997: m = n - grad h + (grad h . n) n; that a lateral force
/// alone is felt as a bump: M. Minsky, PhD thesis, MIT 1995. Noise: K. Perlin, An image synthesizer, SIGGRAPH
/// 1985, with values instead of gradients at the lattice.
[[nodiscard]] Vec3 textured(const Vec3& force_n, const Vec3& normal, const Vec3& proxy_m, Texture texture,
                            double roughness) noexcept;

}  // namespace nazori::haptics
