// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/sample_statistics.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nazori::recording {

void SampleStatistics::add(const haptics::ServoSample& sample) {
  const double force = glm::length(sample.force_n);
  if (samples == 0) {
    first_s = sample.time_s;
  } else {
    longest_period_s = std::max(longest_period_s, sample.time_s - last_s);
    const double work = glm::dot(last_n_, sample.device_m - last_m_);
    (work < 0 ? put_in_j_ : got_back_j_) += std::abs(work);
  }
  ++samples;
  last_s = sample.time_s;
  last_m_ = sample.device_m;
  last_n_ = sample.force_n;
  force_sum_ += force;
  peak_force_n = std::max(peak_force_n, force);
  if (sample.stroke != 0) ++held;
  if (sample.touching) {
    ++touching;
    contact_force_sum_ += force;
    max_depth_m = std::max(max_depth_m, glm::distance(sample.proxy_m, sample.device_m));
  }
  for (unsigned bits = sample.events, bit = 0; bits != 0; bits >>= 1U, ++bit) events[bit] += bits & 1U;
}

double SampleStatistics::mean_force_n() const {
  return samples == 0 ? 0 : force_sum_ / static_cast<double>(samples);
}

double SampleStatistics::mean_contact_force_n() const {
  return touching == 0 ? 0 : contact_force_sum_ / static_cast<double>(touching);
}

}  // namespace nazori::recording
