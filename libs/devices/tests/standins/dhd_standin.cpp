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

}  // namespace

EXPORTED DhdStage* nazori_standin_dhd() { return &stage; }

EXPORTED void nazori_standin_dhd_reset() {
  stage.x_m = 0.02;
  stage.y_m = stage.z_m = 0;
  stage.buttons = 0;
  stage.devices = 1;
  stage.open_error = stage.bad_reads = 0;
  stage.not_homed = stage.saturated = stage.force_on = stage.gravity_on = false;
  stage.name = "omega.3";
  stage.type = 33;
  stage.max_force_n = -1;
  stage.force_x_n = stage.force_y_n = stage.force_z_n = 0;
  stage.force_despite_error_n = stage.guard_n = 0;
  stage.opens = stage.closes = 0;
  stage.reads = 0;
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
  stage.force_on = false;
  return 0;
}
EXPORTED int dhdErrorGetLast() { return error; }
EXPORTED const char* dhdErrorGetLastStr() { return error == 5 ? "no device found" : "communication error"; }
EXPORTED const char* dhdGetSystemName(char id) { return there(id) ? stage.name.load() : nullptr; }
EXPORTED int dhdGetSystemType(char id) { return there(id) ? stage.type.load() : -1; }
EXPORTED int dhdEnableForce(unsigned char on, char id) {
  if (!there(id)) return fail(2);
  if (on != 0 && stage.not_homed) return fail(2);
  stage.force_on = on != 0;
  return 0;
}
EXPORTED int dhdGetPosition(double* x, double* y, double* z, char id) {
  ++stage.reads;
  if (!there(id)) return fail(2);
  if (stage.bad_reads > 0) {
    --stage.bad_reads;
    return fail(7);
  }
  *x = stage.x_m;
  *y = stage.y_m;
  *z = stage.z_m;
  return 1;  // the time guard: a success
}
EXPORTED int dhdSetForce(double x, double y, double z, char id) {
  if (!there(id)) {
    stage.force_despite_error_n = std::max(stage.force_despite_error_n.load(), std::hypot(x, y, z));
    // The device's own watchdog drops the force once the cable is out.
    stage.force_x_n = stage.force_y_n = stage.force_z_n = 0;
    return fail(2);
  }
  stage.force_x_n = stage.force_on ? x : 0;
  stage.force_y_n = stage.force_on ? y : 0;
  stage.force_z_n = stage.force_on ? z : 0;
  return stage.saturated ? 2 : 0;
}
#ifndef NAZORI_STANDIN_INCOMPLETE
EXPORTED unsigned int dhdGetButtonMask(char) { return stage.buttons; }
#endif
EXPORTED int dhdGetButton(int index, char) {
  return static_cast<int>(stage.buttons >> static_cast<unsigned>(index)) & 1;
}
EXPORTED double dhdGetMaxForce(char id) { return there(id) ? stage.max_force_n.load() : -1; }
EXPORTED int dhdSetMaxForce(double newtons, char) {
  stage.guard_n = newtons;
  return 0;
}
EXPORTED int dhdSetGravityCompensation(int on, char) {
  stage.gravity_on = on != 0;
  return 0;
}

namespace {
// A program that knows nothing of the stage finds a device that works.
[[maybe_unused]] const bool kReady = (nazori_standin_dhd_reset(), true);
}  // namespace
