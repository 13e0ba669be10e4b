// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/haptics/haptic_scene.h"

namespace nazori::haptics {

/// Steepest slope that a texture of roughness 1 pretends: tan 27 degrees.
constexpr double kSteepestTexture = 0.5;

/// Slope of the fine bumps of `texture` at a place of the plateau, as dz/dx and dz/dy; z is 0. It is the
/// gradient of a noise of fixed size (no feature finer than 0.4 mm), so at a constant press a closed way over
/// it takes and gives no energy. Length at most kSteepestTexture. Same place, same slope.
[[nodiscard]] Vec3 texture_slope(Texture texture, double x_m, double y_m) noexcept;

/// `force_n` of contact with the part along `normal` turned as if the surface there had the texture's slope;
/// that part keeps its length, and what friction adds along the surface is as it was. The proxy is not moved.
///
/// @param normal  unit.  @param roughness  0..1.
/// @source bump mapping: C. Basdogan, C.-H. Ho, M. Srinivasan, A ray-based haptic rendering technique for
/// displaying shape and texture, ASME DSC-61, 1997: m = n - grad h + (grad h . n) n; that a lateral force
/// alone is felt as a bump: M. Minsky, PhD thesis, MIT 1995. Noise: K. Perlin, An image synthesizer, SIGGRAPH
/// 1985, with values instead of gradients at the lattice.
[[nodiscard]] Vec3 textured(const Vec3& force_n, const Vec3& normal, const Vec3& proxy_m, Texture texture,
                            double roughness) noexcept;

}  // namespace nazori::haptics
