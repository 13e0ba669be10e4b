// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/recordings.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "nazori/exchange/samples.h"

namespace nazori::exchange {

std::string_view ReadRecording::state() const {
  if (end.finished) return end.recovered ? "recovered" : "complete";
  return recovery == recording::Recovery::in_progress ? "being recorded" : "incomplete";
}

std::string ReadRecording::start() const {
  const auto seconds = static_cast<std::time_t>(std::floor(static_cast<double>(session.start_ns) * 1e-9));
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(seconds));
}

double ReadRecording::max_lateness_s() const {
  return std::max(0.0, samples.longest_period_s - 1 / session.device.rate_hz);
}

Value to_json(const ReadRecording& read, const std::string& file) {
  const recording::Session& session = read.session;
  Value json{{"file", file},
             {"state", read.state()},
             {"start", read.start()},
             {"start_ns", session.start_ns},
             {"device", session.device.name},
             {"has_force", session.device.has_force},
             {"rate_hz", session.device.rate_hz},
             {"character", session.character},
             {"tablet_width_m", session.shape.width_m},
             {"tablet_depth_m", session.shape.depth_m},
             {"tip_radius_m", session.tip_radius_m},
             {"lost", read.end.lost},
             {"damaged", read.end.damaged},
             {"gaps", read.gaps},
             {"trailing_bytes", read.end.trailing_bytes},
             {"late_ticks", read.late_ticks},
             {"max_lateness_s", read.max_lateness_s()}};
  json.update(to_json(read.samples));
  return json;
}

Value exported_recording(const recording::RecordingEnd& end, const std::string& file) {
  return {{"file", file}, {"ticks", end.samples}, {"damaged", end.damaged}, {"finished", end.finished}};
}

}  // namespace nazori::exchange
