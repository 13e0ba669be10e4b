// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "nazori/tablet/carved_tablet.h"

namespace nazori::tablet {

/// A tablet to try a device with: a floor and a steep wall on the left, a round groove in the plateau on the
/// right, which is the only line.
[[nodiscard]] std::shared_ptr<const CarvedTablet> wall_and_groove(const geometry::TabletShape& shape);

}  // namespace nazori::tablet
