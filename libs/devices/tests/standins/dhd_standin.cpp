// SPDX-License-Identifier: Apache-2.0
// A libdhd.so for the tests. What it answers without a device is what Force Dimension's own library was seen
// to answer: -1, last error 5, outputs untouched. Never installed.
#include "dhd_standin.h"

#include <algorithm>
#include <cmath>

#define EXPORTED extern "C" __attribute__((visibility("default")))

using nazori::devices::standin::DhdStage;

namespace {

DhdStage stage;
std::atomic<int> error;

int fail(int code) {
  error = code;
  return -1;
}
bool there(char id) { return id >= 0 && id < stage.devices; }

void switch_forces(bool on) {
  stage.force_on = on;
  if (auto* const remains = stage.remains.load(); remains != nullptr) remains->output = on;
}

void motors(double x, double y, double z) {
  stage.force_x_n = x;
  stage.force_y_n = y;
  stage.force_z_n = z;
  if (auto* const remains = stage.remains.load(); remains != nullptr) {
    remains->force_n = std::hypot(x, y, z);
    ++remains->writes;
  }
}

/// A device that is not homed brakes, whatever the command, and so does one whose forces went off.
[[maybe_unused]] bool pushes() { return stage.force_on && !stage.not_homed && stage.force_off_cause == 0; }

}  // namespace

EXPORTED DhdStage* nazori_standin_dhd() { return &stage; }

EXPORTED void nazori_standin_dhd_reset() {
  stage.x_m = 0.02;
  stage.y_m = stage.z_m = 0;
  stage.buttons = 0;
  stage.devices = 1;
  stage.open_error = stage.bad_reads = stage.bad_writes = stage.looks_off = 0;
  stage.bad_status = stage.wordless = false;
  stage.not_homed = stage.saturated = stage.force_on = stage.gravity_on = stage.button_emulated = false;
  stage.force_off_cause = stage.enables = 0;
  stage.remains = nullptr;
  stage.name = "omega.3";
  stage.type = 33;
  stage.max_force_n = -1;
  stage.force_x_n = stage.force_y_n = stage.force_z_n = 0;
  stage.force_despite_error_n = stage.guard_n = stage.switched_on_with_n = 0;
  stage.opens = stage.closes = 0;
  stage.reads = stage.looks = stage.switched_on_at_look = 0;
  error = 0;
}

EXPORTED int dhdGetDeviceCount() { return stage.devices > 0 ? stage.devices.load() : (error = 5, 0); }
EXPORTED int dhdOpenID(char index) {
  if (stage.open_error != 0) return fail(stage.open_error);
  if (!there(index)) return fail(5);
  ++stage.opens;
  return index;
}
EXPORTED int dhdClose(char) {
  ++stage.closes;
  return 0;
}
EXPORTED int dhdErrorGetLast() { return error; }
EXPORTED const char* dhdErrorGetLastStr() {
  if (stage.wordless) return nullptr;
  return error == 5 ? "no device found" : "communication error";
}
EXPORTED int dhdEnableForce(unsigned char on, char id) {
  if (!there(id)) return fail(2);
  if (on != 0) {
    stage.switched_on_at_look = stage.looks.load();
    ++stage.enables;
    stage.switched_on_with_n = std::hypot(stage.force_x_n, stage.force_y_n, stage.force_z_n);
  }
  switch_forces(on == 1);
  return 0;  // even where the device is not homed
}
EXPORTED int dhdGetPosition(double* x, double* y, double* z, char id) {
  ++stage.reads;
  if (!there(id)) return fail(2);
  if (stage.bad_reads > 0) {
    --stage.bad_reads;
    return fail(7);
  }
  // Before it is homed a device always reports the same position.
  *x = stage.not_homed ? 0 : stage.x_m.load();
  *y = stage.not_homed ? 0 : stage.y_m.load();
  *z = stage.not_homed ? 0 : stage.z_m.load();
  return 1;  // the time guard: a success
}
EXPORTED int dhdSetForce(double x, double y, double z, char id) {
  if (!there(id)) {
    stage.force_despite_error_n = std::max(stage.force_despite_error_n.load(), std::hypot(x, y, z));
    // The device's own watchdog removes the force once the cable is unplugged.
    motors(0, 0, 0);
    return fail(2);
  }
  if (stage.bad_writes > 0) {
    --stage.bad_writes;
    return fail(7);
  }
  motors(x, y, z);
  return stage.saturated ? 2 : 0;
}
#ifndef NAZORI_STANDIN_INCOMPLETE  // the variant of a library that has only what every version has
EXPORTED const char* dhdGetSystemName(char id) { return there(id) ? stage.name.load() : nullptr; }
EXPORTED int dhdGetSystemType(char id) { return there(id) ? stage.type.load() : -1; }
EXPORTED int dhdGetStatus(int* status, char id) {
  ++stage.looks;
  if (!there(id) || stage.bad_status) return fail(2);
  constexpr int kEntries = 17;
  std::fill_n(status, kEntries, 0);
  status[0] = status[1] = status[2] = 1;  // power, connected, started
  status[3] = stage.not_homed ? 1 : 0;
  status[5] = pushes() ? 1 : 0;
  status[6] = pushes() ? 0 : 1;
  status[14] = stage.force_off_cause;
  if (stage.looks_off > 0) {
    --stage.looks_off;
    status[5] = 0;
  }
  return 0;
}
EXPORTED int dhdEmulateButton(unsigned char on, char) {
  stage.button_emulated = on == 1;
  return 0;
}
EXPORTED unsigned int dhdGetButtonMask(char) { return stage.buttons; }
EXPORTED double dhdGetMaxForce(char id) { return there(id) ? stage.max_force_n.load() : -1; }
EXPORTED int dhdSetMaxForce(double newtons, char) {
  stage.guard_n = newtons;
  return 0;
}
EXPORTED int dhdSetGravityCompensation(int on, char) {
  stage.gravity_on = on == 1;
  return 0;
}
#endif
EXPORTED int dhdGetButton(int index, char) {
  return static_cast<int>(stage.buttons >> static_cast<unsigned>(index)) & 1;
}

namespace {
// A program that does not use the stage finds a working device.
[[maybe_unused]] const bool kReady = (nazori_standin_dhd_reset(), true);
}  // namespace
