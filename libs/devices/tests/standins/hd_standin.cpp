// SPDX-License-Identifier: Apache-2.0
// A libHD.so for the tests: the 36 names of HDAPI and what OpenHaptics 3.0 was seen to do when called right
// and wrong, with a servo thread and a hand of its own. Never installed.
#include "hd_standin.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#define EXPORTED extern "C" __attribute__((visibility("default")))

using nazori::devices::standin::HdStage;

struct ErrorInfo {
  unsigned int code;
  int internal_code;
  unsigned int device;
};

namespace {

constexpr unsigned int kNone = 0xFFFFFFFF;
constexpr unsigned int kHandle = 0;  // 0 is a valid handle
constexpr unsigned int kOther = 1;   // another device of the program, which is current until ours is made so

HdStage stage;

struct Scheduled {
  unsigned long handle;
  unsigned int (*callback)(void*);
  void* user;
  unsigned short priority;
  bool done;
};

// The scheduler's thread and the caller's take turns under this, as the maker's critical section does.
std::recursive_mutex everything;
// Never destroyed: the servo thread of the real library also continues while the program exits.
auto& errors = *new std::vector<ErrorInfo>;
auto& callbacks = *new std::vector<Scheduled>;
// Never destroyed: a program may end while the scheduler runs.
std::thread& servo = *new std::thread;
std::atomic<bool> servo_ends;
unsigned long last_scheduled;
bool initialised, in_frame, framed_this_tick, error_this_tick, one_frame_limit;
bool fails_to_write;  // from the first failed hdEndFrame on
std::set<unsigned int> latched;
double wanted[3];
unsigned int current = kOther;

/// The real library latches errors of the connection and the timer: it reports each one once per cause.
bool is_latched(unsigned int code) { return code >= 0x0302 && code <= 0x0304; }

void push(unsigned int code, int internal_code = 0) {
  const std::lock_guard lock(everything);
  if (is_latched(code) && !latched.insert(code).second) return;
  errors.push_back({code, internal_code, initialised ? kHandle : kNone});
}

/// Most calls are about the current device.
bool is_current() {
  if (current == kHandle) return true;
  push(0x0104);
  return false;
}

/// hdEndFrame finds these when it writes to the device.
bool comes_with_the_write(unsigned int code) { return code == 0x0300 || code == 0x0302 || code == 0x0303; }

[[noreturn]] void crash(const char* what) {
  std::fprintf(stderr, "libHD stand-in: %s: the real library crashes here\n", what);
  std::abort();
}

void remember_output(bool on) {
  stage.output = on;
  if (auto* const remains = stage.remains.load(); remains != nullptr) remains->output = on;
}

void motors(double x, double y, double z) {
  if (auto* const remains = stage.remains.load(); remains != nullptr) {
    remains->force_n = std::hypot(x, y, z);
    ++remains->writes;
  }
  stage.force_x_n = x;
  stage.force_y_n = y;
  stage.force_z_n = z;
  if (x == 0 && y == 0 && z == 0)
    ++stage.zero_ticks;
  else
    stage.zero_ticks = 0;
}

void run_tick() {
  const std::lock_guard lock(everything);
  framed_this_tick = false;
  current = kOther;
  wanted[0] = wanted[1] = wanted[2] = 0;
  const std::size_t errors_before = errors.size();
  if (!comes_with_the_write(stage.next_error)) {
    if (const unsigned int code = stage.next_error.exchange(0); code != 0) push(code);
  }
  if (stage.bad_ticks > 0) {
    --stage.bad_ticks;
    push(0x0101);
  }
  if (const unsigned int code = stage.every_error; code != 0 && !comes_with_the_write(code)) push(code);
  error_this_tick = errors.size() > errors_before;
  // Sorting allocates memory, which would be counted as the callback's.
  const auto goes_first = [](const Scheduled& a, const Scheduled& b) { return a.priority > b.priority; };
  if (!std::is_sorted(callbacks.begin(), callbacks.end(), goes_first))
    std::stable_sort(callbacks.begin(), callbacks.end(), goes_first);
  for (std::size_t i = 0; i < callbacks.size(); ++i) {
    if (!callbacks[i].done && callbacks[i].callback(callbacks[i].user) == 0) callbacks[i].done = true;
  }
  ++stage.ticks;
}

void serve() {
  while (!servo_ends) {
    if (!stage.frozen) run_tick();
    std::this_thread::sleep_for(std::chrono::microseconds(700));
  }
}

bool limits_known() { return !stage.dumb; }

}  // namespace

EXPORTED HdStage* nazori_standin_hd() { return &stage; }

EXPORTED void nazori_standin_hd_reset() {
  const std::lock_guard lock(everything);
  stage.x_mm = stage.y_mm = 0;
  stage.z_mm = 30;
  stage.buttons = 0;
  stage.plugged = stage.out_of_inkwell = true;
  stage.refuses = false;
  stage.bad_ticks = stage.checks = 0;
  stage.safety_held = stage.frozen = stage.dumb = stage.large = stage.garbage_handle = stage.silent = false;
  stage.init_error = stage.next_error = stage.every_error = stage.start_error = 0;
  stage.only_name = nullptr;
  stage.calibration = 0x5000;
  stage.calibration_style = 4;
  stage.max_force_n = 3.3;
  stage.force_despite_error_n = 0;
  stage.force_x_n = stage.force_y_n = stage.force_z_n = 0;
  stage.remains = nullptr;
  stage.inits = stage.disables = stage.calibrations = 0;
  stage.calibrated_by = 0;
  fails_to_write = false;
  one_frame_limit = true;
  latched.clear();
  errors.clear();
  callbacks.clear();
}

EXPORTED unsigned int hdInitDevice(const char* name) {
  for (int line = 0; line < 12; ++line)
    std::fprintf(stderr, "libHD stand-in: line %d of the banner that the maker prints at each look\n", line);
  ++stage.inits;
  const char* const only = stage.only_name;
  unsigned int code = stage.init_error;
  if (code == 0 && !stage.plugged) code = 0x0302;
  if (code == 0 && only != nullptr && std::strcmp(only, name == nullptr ? "" : name) != 0) code = 0x0303;
  if (code == 0 && initialised) code = 0x0301;
  current = kOther;
  if (code != 0) {
    if (stage.garbage_handle && code != 0x0301) return 40321;  // and no error
    if (!stage.silent) push(code, -1);
    return kNone;
  }
  const std::lock_guard lock(everything);
  initialised = true;
  fails_to_write = false;
  latched.clear();
  remember_output(false);
  return kHandle;
}
EXPORTED void hdDisableDevice(unsigned int) {
  ++stage.disables;
  if (stage.running) crash("hdDisableDevice while the scheduler runs");
  initialised = false;
}
EXPORTED void hdMakeCurrentDevice(unsigned int handle) {
  const std::lock_guard lock(everything);
  current = handle;
}
EXPORTED unsigned int hdGetCurrentDevice() { return initialised ? current : kNone; }
EXPORTED void hdBeginFrame(unsigned int handle) {
  if (!initialised) crash("hdBeginFrame before hdInitDevice");
  if (handle != kHandle) return push(0x0104);
  if (framed_this_tick && !in_frame && one_frame_limit) return push(0x0400);
  in_frame = framed_this_tick = true;
}
EXPORTED void hdEndFrame(unsigned int) {
  if (!in_frame) return push(0x0401);
  in_frame = false;
  const double size_squared = wanted[0] * wanted[0] + wanted[1] * wanted[1] + wanted[2] * wanted[2];
  const double most = stage.max_force_n;
  if (error_this_tick || fails_to_write)
    stage.force_despite_error_n = std::max(stage.force_despite_error_n.load(), std::sqrt(size_squared));
  unsigned int failure = stage.plugged ? 0 : 0x0302;
  if (comes_with_the_write(stage.next_error)) failure = stage.next_error.exchange(0);
  if (comes_with_the_write(stage.every_error)) failure = stage.every_error;
  if (failure != 0 && !fails_to_write) {
    fails_to_write = true;
    return push(failure, -19);  // what was there stays
  }
  if (!(size_squared <= most * most * (1 + 1e-9))) return push(0x0201);
  if (stage.output)
    motors(wanted[0], wanted[1], wanted[2]);
  else
    motors(0, 0, 0);
}
EXPORTED ErrorInfo hdGetError() {
  const std::lock_guard lock(everything);
  if (errors.empty()) return {0, 0, kNone};
  const ErrorInfo newest = errors.back();
  errors.pop_back();
  return newest;
}
EXPORTED const char* hdGetErrorString(unsigned int code) {
  switch (code) {
    case 0x0301:
      return "HD_DEVICE_ALREADY_INITIATED";
    case 0x0302:
      return "HD_COMM_ERROR";
    case 0x0303:
      return "HD_COMM_CONFIG_ERROR";
    case 0x0600:
      return "HD_INVALID_LICENSE";
    default:
      return "HD_ERROR";
  }
}
EXPORTED void hdEnable(unsigned int what) {
  if (what == 0x4000 && !is_current()) return;
  if (what == 0x4000)
    remember_output(true);
  else if (what == 0x4004)
    one_frame_limit = true;
  else if (what < 0x2606 || what > 0x4004)
    push(0x0100);
}
EXPORTED void hdDisable(unsigned int what) {
  if (what == 0x4000 && !is_current()) return;
  if (what == 0x4000) remember_output(false);
  if (what == 0x4004) one_frame_limit = false;
}
EXPORTED unsigned char hdIsEnabled(unsigned int what) {
  return what == 0x4000 ? stage.output.load() : static_cast<unsigned char>(what == 0x4004 && one_frame_limit);
}
EXPORTED void hdGetBooleanv(unsigned int what, unsigned char* out) {
  if (!is_current()) return;
  if (stage.refuses && (what == 0x2001 || what == 0x2002)) {
    *out = 1;
    return push(0x0100);
  }
  if (what == 0x2001)
    *out = stage.safety_held;
  else if (what == 0x2002)
    *out = stage.out_of_inkwell;
  else
    push(0x0100);
}
EXPORTED void hdGetIntegerv(unsigned int what, int* out) {
  if (!is_current()) return;
  if (stage.refuses && what == 0x2555) {
    *out = 7;
    return push(0x0100);
  }
  if (what == 0x2000)
    *out = stage.buttons;
  else if (what == 0x2555)
    *out = stage.calibration_style;
  else if (what == 0x2600 || what == 0x2601)
    *out = 1000;
  else
    push(0x0100);
}
EXPORTED void hdGetDoublev(unsigned int what, double* out) {
  constexpr double kBox[6] = {-80, -60, -35, 80, 60, 35};
  constexpr double kLargeBox[6] = {-90, -70, -40, 70, 50, 80};
  if (!is_current()) return;
  if (stage.refuses && what >= 0x2550 && what < 0x2700) {
    for (int i = 0; i < (what <= 0x2551 ? 6 : 1); ++i) out[i] = 7 * (i + 1);
    return push(0x0100);
  }
  switch (what) {
    case 0x2050:
      out[0] = stage.x_mm;
      out[1] = stage.y_mm;
      out[2] = stage.z_mm;
      return;
    case 0x2550:
    case 0x2551:
      for (int i = 0; i < 6; ++i) out[i] = limits_known() ? (stage.large ? kLargeBox : kBox)[i] : 0;
      return;
    case 0x2602:
      *out = limits_known() ? (stage.large ? 1 : 0.5) : 0;
      return;
    case 0x2603:
      *out = limits_known() ? stage.max_force_n.load() : 0;
      return;
    case 0x2604:
      *out = limits_known() ? (stage.large ? 1.75 : 0.88) : 0;
      return;
    case 0x2609:
      *out = limits_known() ? (stage.large ? 0.005 : 0.0025) : 0;
      return;
    case 0x2605:
      out[0] = out[1] = out[2] = 0.2;
      return;
    case 0x2700:
      for (int i = 0; i < 3; ++i) out[i] = wanted[i];
      return;
    default:
      push(0x0100);
  }
}
EXPORTED void hdGetFloatv(unsigned int, float*) { push(0x0100); }
EXPORTED void hdGetLongv(unsigned int, long*) { push(0x0100); }
EXPORTED const char* hdGetString(unsigned int what) {
  if (!is_current()) return "";
  if (stage.refuses) {
    push(0x0100);
    return "garbage";
  }
  switch (what) {
    case 0x2501:
      return "Stand-in Touch";
    case 0x2504:
      return "0042";
    case 0x2500:
      return "3.0";
    default:
      push(0x0100);
      return "";
  }
}
EXPORTED void hdSetDoublev(unsigned int what, const double* in) {
  if (!is_current()) return;
  if (what != 0x2700) return push(0x0100);
  if (!in_frame) return push(0x0402);
  for (int i = 0; i < 3; ++i) wanted[i] = in[i];
}
EXPORTED void hdSetBooleanv(unsigned int, const unsigned char*) { push(0x0100); }
EXPORTED void hdSetIntegerv(unsigned int, const int*) { push(0x0100); }
EXPORTED void hdSetFloatv(unsigned int, const float*) { push(0x0100); }
EXPORTED void hdSetLongv(unsigned int, const long*) { push(0x0100); }
EXPORTED unsigned int hdCheckCalibration() {
  ++stage.checks;
  return stage.calibration;
}
EXPORTED unsigned int hdCheckCalibrationStyle() { return static_cast<unsigned int>(stage.calibration_style); }
EXPORTED void hdUpdateCalibration(unsigned int style) {
  // Exactly one of the styles that the device has, never the whole mask.
  if ((style != 1 && style != 2 && style != 4) ||
      (static_cast<unsigned int>(stage.calibration_style) & style) == 0)
    return push(0x0101);
  ++stage.calibrations;
  stage.calibrated_by = style;
  stage.calibration = 0x5000;
}
EXPORTED void hdUpdateCalibrationMessage(unsigned int) {}
EXPORTED void hdScaleGimbalAngles(double, double, double, double*) {}
EXPORTED unsigned char hdDeploymentLicense(const char*, const char*, const char*) { return 1; }
EXPORTED void hdStartScheduler() {
  if (stage.running) return;
  if (const unsigned int code = stage.start_error; code != 0) return push(code);
  servo_ends = false;
  stage.running = true;
  servo = std::thread(serve);
}
EXPORTED void hdStopScheduler() {
  if (!stage.running) return;
  servo_ends = true;
  servo.join();
  stage.running = false;
}
EXPORTED void hdSetSchedulerRate(unsigned long hz) {
  if (hz != 500 && hz != 1000 && hz != 2000) push(0x0304);
}
EXPORTED unsigned long hdScheduleAsynchronous(unsigned int (*callback)(void*), void* user,
                                              unsigned short priority) {
  const std::lock_guard lock(everything);
  callbacks.push_back({++last_scheduled, callback, user, priority, false});
  return last_scheduled;
}
EXPORTED void hdScheduleSynchronous(unsigned int (*callback)(void*), void* user, unsigned short) {
  while (callback(user) != 0) {
  }
}
#ifndef NAZORI_STANDIN_INCOMPLETE  // the variant in which one of the names is missing
EXPORTED void hdUnschedule(unsigned long handle) {
  const std::lock_guard lock(everything);
  const auto found = std::find_if(callbacks.begin(), callbacks.end(),
                                  [&](const Scheduled& s) { return s.handle == handle && !s.done; });
  if (found == callbacks.end()) return push(0x0102);
  callbacks.erase(found);
}
#endif
EXPORTED unsigned char hdWaitForCompletion(unsigned long handle, unsigned int) {
  const std::lock_guard lock(everything);
  return std::any_of(callbacks.begin(), callbacks.end(),
                     [&](const Scheduled& s) { return s.handle == handle && !s.done; });
}

EXPORTED double hdGetSchedulerTimeStamp() { return 0; }

namespace {
// A program that does not use the stage finds a working device.
[[maybe_unused]] const bool kReady = (nazori_standin_hd_reset(), true);
}  // namespace
