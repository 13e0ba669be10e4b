// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/devices.h"

#include <utility>

namespace nazori::exchange {

Value to_json(std::span<const devices::BackEndFindings> findings) {
  Value document = Value::array();
  for (const devices::BackEndFindings& found : findings) {
    Value list = Value::array();
    for (const devices::FoundDevice& device : found.devices)
      list.push_back({{"id", device.id},
                      {"name", device.name},
                      {"has_force", device.has_force},
                      {"automatic", device.automatic}});
    Value problem;
    if (found.problem)
      problem = {{"what", found.problem->error.what},
                 {"where", found.problem->error.where},
                 {"remedy", found.problem->error.remedy}};
    document.push_back(
        {{"back_end", found.back_end}, {"devices", std::move(list)}, {"problem", std::move(problem)}});
  }
  return document;
}

Value to_json(const TriedDevice& tried) {
  Value histogram = Value::array();
  for (std::size_t i = 0; i < tried.trial.lateness.size(); ++i) {
    histogram.push_back(
        {{"up_to_s", i < devices::TrialResult::kEdges_s.size() ? Value(devices::TrialResult::kEdges_s[i])
                                                               : Value(nullptr)},
         {"ticks", tried.trial.lateness[i]}});
  }
  return {{"id", tried.id},
          {"name", tried.description.name},
          {"has_force", tried.description.has_force},
          {"max_force_n", tried.description.limits.max_force_n},
          {"continuous_force_n", tried.description.limits.continuous_force_n},
          {"max_stiffness_n_m", tried.description.limits.max_stiffness_n_m},
          {"nominal_rate_hz", tried.description.rate_hz},
          {"rate_hz", tried.trial.rate_hz},
          {"seconds", tried.trial.seconds},
          {"ticks", tried.trial.ticks},
          {"absent_ticks", tried.trial.absent},
          {"lateness", std::move(histogram)},
          {"max_lateness_s", tried.trial.max_lateness_s},
          {"rest_noise_m", tried.trial.rest_noise_m >= 0 ? Value(tried.trial.rest_noise_m) : Value(nullptr)},
          {"round_trip_delay_s", tried.status.delay_s > 0 ? Value(tried.status.delay_s) : Value(nullptr)},
          {"trouble", tried.status.message.empty() ? Value(nullptr) : Value(tried.status.message)},
          {"machine",
           {{"kernel", tried.machine.kernel},
            {"kernel_preempts", tried.machine.kernel_preempts},
            {"priority_limit", tried.machine.priority_limit},
            {"locked_bytes", tried.machine.locked_bytes},
            {"advice", tried.machine.advice}}}};
}

}  // namespace nazori::exchange
