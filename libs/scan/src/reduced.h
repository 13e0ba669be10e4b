// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/scan/picture.h"

namespace nazori::scan {

/// The picture made smaller by a whole factor: each pixel is the mean of factor x factor, what is left over
/// at the right and below goes. @param factor  at least 1, at most each side of the picture.
[[nodiscard]] Photo reduced(const Photo& photo, int factor);

}  // namespace nazori::scan
