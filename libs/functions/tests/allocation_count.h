// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nazori::functions::test {

/// From now on every operator new of this program is counted.
void begin_counting_allocations();
/// @return the number of allocations.
[[nodiscard]] int end_counting_allocations();

}  // namespace nazori::functions::test
