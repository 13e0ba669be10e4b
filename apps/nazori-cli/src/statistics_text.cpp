// SPDX-License-Identifier: Apache-2.0
#include "statistics_text.h"

#include <fmt/format.h>

#include <string_view>

#include "nazori/recording/sample_csv.h"

namespace nazori::cli {
namespace {

using recording::SampleStatistics;

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

std::string statistics_text(const SampleStatistics& samples, double rate_hz) {
  std::string events;
  for (int bit = 0; bit < SampleStatistics::kEventBits; ++bit) {
    const std::uint64_t count = samples.events[static_cast<std::size_t>(bit)];
    if (count > 0)
      events += fmt::format("{}{} {}", events.empty() ? "" : ", ", recording::event_name(bit), count);
  }
  return fmt::format(
      "ticks    {} in {:.3f} s at {:g} Hz, {:.0f} % in contact\n"
      "force    mean {:.3f} N, in contact {:.3f} N, peak {:.3f} N\n"
      "depth    at most {:.3f} mm behind the surface\n"
      "energy   put in {:.3f} mJ, got back {:.3f} mJ, dissipated {:.3f} mJ\n"
      "events   {}\n",
      samples.samples, samples.duration_s(), rate_hz, 100 * share(samples.touching, samples.samples),
      samples.mean_force_n(), samples.mean_contact_force_n(), samples.peak_force_n, 1e3 * samples.max_depth_m,
      1e3 * samples.put_in_j(), 1e3 * samples.got_back_j(), 1e3 * samples.dissipated_j(),
      events.empty() ? "none" : events);
}

}  // namespace nazori::cli
