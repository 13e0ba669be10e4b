// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "json_answers.h"
#include "nazori/devices/device_catalogue.h"
#include "nazori/devices/every_back_end.h"
#include "nazori/exchange/devices.h"
#include "options.h"
#include "stop.h"
#include "text_layout.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

struct DevicesSettings {
  std::string device;
  double test_s = 0;
  bool json = false;
};

int list(Console& console, devices::DeviceCatalogue& catalogue, const DevicesSettings& settings) {
  const std::vector<devices::BackEndFindings> findings = catalogue.find();
  std::string text;
  for (const devices::BackEndFindings& found : findings) {
    text += found.back_end + "\n";
    for (const devices::FoundDevice& device : found.devices)
      text += fmt::format("  {}  {}{}\n", pad(device.id, 22), device.name,
                          device.has_force ? "" : "  (no force)");
    if (found.problem)
      text += fmt::format("  {}: {}\n", found.devices.empty() ? "nothing found" : "but",
                          base::to_line(found.problem->error));
  }
  console.print(settings.json ? to_text(exchange::to_json(findings)) : text);
  return kDone;
}

std::string describe(const exchange::TriedDevice& tried) {
  const auto& [id, description, trial, status, machine] = tried;
  std::string text = fmt::format("{}  {}\n", id, description.name);
  if (description.has_force) {
    text += fmt::format("limits      {:.2f} N peak, {:.2f} N continuous, {:.0f} N/m on the tablet\n",
                        description.limits.max_force_n, description.limits.continuous_force_n,
                        description.limits.max_stiffness_n_m);
  }
  text += fmt::format("rate        {:.0f} Hz of {:.0f} Hz, {} ticks in {:.1f} s\n", trial.rate_hz,
                      description.rate_hz, trial.ticks, trial.seconds);
  for (std::size_t i = 0; i < trial.lateness.size(); ++i) {
    const std::string edge = i < devices::TrialResult::kEdges_s.size()
                                 ? fmt::format("up to {:.2f} ms", devices::TrialResult::kEdges_s[i] * 1e3)
                                 : fmt::format("more, up to {:.2f} ms", trial.max_lateness_s * 1e3);
    text += fmt::format("{}{:>8}  {}\n", pad(i == 0 ? "lateness" : "", 12), trial.lateness[i], edge);
  }
  if (trial.rest_noise_m >= 0)
    text += fmt::format("noise       {:.1f} um at rest (let go of the stylus to measure it)\n",
                        trial.rest_noise_m * 1e6);
  if (status.delay_s > 0)
    text += fmt::format("round trip  {:.2f} ms from pose to force\n", status.delay_s * 1e3);
  if (trial.absent > 0) text += fmt::format("absent      {} ticks without a stylus\n", trial.absent);
  if (!status.message.empty()) text += "problem     " + status.message + "\n";
  text += "machine     " + machine.kernel + "\n";
  if (machine.advice.empty()) text += "            ready for real time\n";
  for (const std::string& advice : machine.advice) text += "            " + advice + "\n";
  return text;
}

int test(Console& console, devices::DeviceCatalogue& catalogue, const DevicesSettings& settings) {
  auto opened =
      settings.device.empty() ? catalogue.open_best("", {}).opened : catalogue.open(settings.device, {});
  if (!opened) return console.deny(opened.error().error);
  haptics::HapticDevice& device = *opened->device;
  const haptics::DeviceDescription description = device.describe();
  devices::DeviceTrial trial(description.rate_hz);
  if (auto started = device.start(trial); !started) return console.deny(started.error());
  const auto begin = std::chrono::steady_clock::now();
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  for (double done = 0; done < 1;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    done = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / settings.test_s;
    if (!progress.show(std::min(done, 1.0), "testing " + description.name)) break;
  }
  progress.clear();
  haptics::DeviceStatus status = device.status();
  // A short pause of the computer does not mean that the device is lost.
  for (int i = 0; i < 100 && status.trouble == haptics::DeviceTrouble::stalled && !stop_requested(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    status = device.status();
  }
  device.stop();
  const exchange::TriedDevice tried{opened->id, description, trial.result(), status,
                                    devices::real_time_readiness()};
  console.print(settings.json ? to_text(exchange::to_json(tried)) : describe(tried));
  return status.state == haptics::DeviceState::lost || tried.trial.ticks == 0 ? kNo : kDone;
}

int run(Console& console, const DevicesSettings& settings) {
  devices::DeviceCatalogue catalogue(devices::every_back_end(devices::back_end_settings()));
  if (settings.test_s > 0) return test(console, catalogue, settings);
  if (settings.device.empty()) return list(console, catalogue, settings);
  return console.refuse(
      {base::Errc::bad_argument, "it is only used together with --test", "--device", "add --test SECONDS"});
}

}  // namespace

void add_devices(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<DevicesSettings>();
  CLI::App* verb =
      app.add_subcommand("devices", "List haptic devices, explain why others were not found, and test one");
  verb->add_option("--test", settings->test_s,
                   "Run a device without force for this many seconds and report its rate, lateness, noise at "
                   "rest and round trip, and whether the computer is ready for real time")
      ->check(within(0.1, 3600))
      ->type_name("SECONDS");
  verb->add_option("--device", settings->device,
                   "Device to test: its id or part of its name (default: the best one)")
      ->type_name("NAME");
  verb->add_flag("--json", settings->json, "Print JSON (see docs/command-line.md)");
  verb->footer(
      "The makers' libraries are looked for under their usual names, or where NAZORI_LIBHD\n"
      "and NAZORI_LIBDHD say; the Inverse Service on port 10001 or NAZORI_INVERSE_PORT;\n"
      "a Haply 2diy at USB serial ports, or at NAZORI_PANTOGRAPH_PORT.\n"
      "How to set a device up is in docs/devices.md.\n\nExamples:\n  nazori-cli devices\n"
      "  nazori-cli devices --test 10 --device openhaptics --json");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
