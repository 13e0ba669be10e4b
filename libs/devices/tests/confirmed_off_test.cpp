// SPDX-License-Identifier: Apache-2.0
// Devices that a thread of their own speaks with: the end of the program waits for them no longer than
// needed. Forces that were cut never come back, so each is tried in a process of its own.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <functional>

#include "default_signals.h"
#include "felt_plane.h"
#include "force_guard.h"
#include "nazori/devices/inverse_service.h"
#include "sdl_back_end.h"
#include "standins/inverse_standin.h"
#include "standins/sdl_standin.h"

namespace nazori::devices {
namespace {

using test::comes_true;
using test::Push;
using test::Vec3;

constexpr int kAsMeant = 7;

/// @param part  returns true on success.
void expect_in_a_process(const std::function<bool()>& part) {
  const test::DefaultSignals signals;
  const pid_t process = fork();
  ASSERT_GE(process, 0);
  if (process == 0) std::_Exit(part() ? kAsMeant : 1);
  int status = 0;
  ASSERT_EQ(waitpid(process, &status, 0), process);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), kAsMeant);
}

TEST(ConfirmedOff, AnInverse3ConfirmsOnceItWasToldZero) {
  expect_in_a_process([] {
    standin::InverseService service;
    const auto force_n = [&] { return std::hypot(service.force_x_n, service.force_y_n, service.force_z_n); };
    InverseServiceSettings settings;
    settings.port = service.port();
    settings.delay_s = 0.020;
    OpenRequest request;
    request.calibration.emplace();
    DeviceResult<OpenedDevice> opened;
    if (!comes_true(
            [&] { return bool(opened = inverse_service_back_end(settings)->open("inverse3", request)); }))
      return false;
    Push push({0, 0, 1});
    if (!opened->device->start(push) || !comes_true([&] { return force_n() > 0.5; })) return false;
    if (ForceGuard::are_all_off()) return false;
    ForceGuard::cut_all();
    const bool confirmed = comes_true(ForceGuard::are_all_off) && comes_true([&] { return force_n() == 0; });
    opened->device->stop();
    return confirmed;
  });
}

TEST(ConfirmedOff, AStickConfirmsOnceAllItsEffectsHaveStopped) {
  expect_in_a_process([] {
    const auto port = std::make_shared<standin::StickPort>();
    const auto stick = port->plug_in("Stick", standin::kForceStick);
    auto opened = sdl::back_end(port)->open("sdl", {});
    if (!opened) return false;
    stick->press = 1;  // the damper runs too
    Push push({1, 0, 0});
    if (!opened->device->start(push) || !comes_true([&] { return stick->push_right() > 0.3; })) return false;
    if (ForceGuard::are_all_off()) return false;
    ForceGuard::cut_all();
    const bool confirmed = comes_true(ForceGuard::are_all_off) && !stick->anything_runs();
    opened->device->stop();
    return confirmed;
  });
}

}  // namespace
}  // namespace nazori::devices
