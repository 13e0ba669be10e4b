// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/samples.h"

#include <string>
#include <string_view>

#include "nazori/recording/sample_csv.h"

namespace nazori::exchange {
namespace {

using recording::SampleStatistics;

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

Value to_json(const SampleStatistics& samples) {
  Value events = Value::object();
  for (int bit = 0; bit < SampleStatistics::kEventBits; ++bit) {
    if (const std::string_view name = recording::event_name(bit); !name.empty())
      events[std::string(name)] = samples.events[static_cast<std::size_t>(bit)];
  }
  return {{"ticks", samples.samples},
          {"duration_s", samples.duration_s()},
          {"contact_share", share(samples.touching, samples.samples)},
          {"stroke_share", share(samples.held, samples.samples)},
          {"mean_force_n", samples.mean_force_n()},
          {"mean_contact_force_n", samples.mean_contact_force_n()},
          {"peak_force_n", samples.peak_force_n},
          {"max_penetration_m", samples.max_depth_m},
          {"put_in_j", samples.put_in_j()},
          {"got_back_j", samples.got_back_j()},
          {"dissipated_j", samples.dissipated_j()},
          {"longest_period_s", samples.longest_period_s},
          {"events", std::move(events)}};
}

}  // namespace nazori::exchange
