// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "nazori/recording/trajectory_csv.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::recording;
  auto reader = TrajectoryReader::from(memory_source({reinterpret_cast<const char*>(data), size}, "fuzz"));
  if (!reader) return 0;
  TrajectoryPoint point;
  double last = -INFINITY;
  for (;;) {
    const auto more = reader->next(point);
    if (!more || !*more) return 0;
    const auto& p = point.position_m;
    if (!(point.time_s > last) || !std::isfinite(p.x + 0 * p.y) || !std::isfinite(p.y) || !std::isfinite(p.z))
      std::abort();
    last = point.time_s;
  }
}
