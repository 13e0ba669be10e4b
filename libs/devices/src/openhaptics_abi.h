// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The binary interface of 3D Systems' HDAPI, as far as it is used here, declared by this program: the
/// maker's headers are not needed and do not compile in standard C++20. 64-bit Linux, plain C calling
/// convention.
/// @source OpenHaptics 3.0 and 3.4: the names, values and sizes of HD/hdDefines.h and HD/hdDevice.h;
/// programmer's guide and API reference for units.
namespace nazori::devices::hd {

using Handle = unsigned int;
using Enum = unsigned int;
using Boolean = unsigned char;
using SchedulerHandle = unsigned long;
using Callback = unsigned int (*)(void*);

struct ErrorInfo {
  unsigned int code;
  int internal_code;
  Handle device;
};
static_assert(sizeof(ErrorInfo) == 12 && sizeof(SchedulerHandle) == 8);

inline constexpr Handle kNoDevice = 0xFFFFFFFF;  // 0 is a device
inline constexpr unsigned int kDone = 0, kAgain = 1;
inline constexpr unsigned short kFirst = 65535;  // priority of callbacks

// Parameters. Lengths are millimetres.
inline constexpr Enum kButtons = 0x2000;                                 // int, bit n = button n + 1
inline constexpr Enum kSafetySwitch = 0x2001;                            // boolean
inline constexpr Enum kInkwellSwitch = 0x2002;                           // boolean: 0 while docked
inline constexpr Enum kPosition = 0x2050;                                // double[3]
inline constexpr Enum kModel = 0x2501, kSerial = 0x2504;                 // strings
inline constexpr Enum kUsableWorkspace = 0x2551;                         // double[6]: least x y z, most x y z
inline constexpr Enum kCalibrationStyle = 0x2555;                        // int, bits
inline constexpr Enum kUpdateRate = 0x2600;                              // int, Hz
inline constexpr Enum kMaxStiffness = 0x2602;                            // double, N/mm
inline constexpr Enum kMaxForce = 0x2603, kMaxContinuousForce = 0x2604;  // double, N
inline constexpr Enum kMaxDamping = 0x2609;                              // double, N per mm/s
inline constexpr Enum kForce = 0x2700;                                   // double[3], N
inline constexpr Enum kForceOutput = 0x4000, kOneFrameLimit = 0x4004;    // capabilities

inline constexpr Enum kCalibrated = 0x5000, kNeedsUpdate = 0x5001, kNeedsManualInput = 0x5002;
// Styles of calibration: a device has one or several, hdUpdateCalibration takes exactly one.
inline constexpr int kResetStyle = 1, kAutoStyle = 2, kInkwellStyle = 4;

enum : unsigned int {
  bad_handle = 0x0104,
  warm_motors = 0x0200,
  max_force = 0x0201,
  force_impulse = 0x0202,
  max_velocity = 0x0203,
  mixed_forces = 0x0204,
  device_fault = 0x0300,
  already_initiated = 0x0301,
  communication = 0x0302,
  configuration = 0x0303,
  timer = 0x0304,
  priority = 0x0500,
  scheduler_full = 0x0501,
  licence = 0x0600,
};

/// The functions; those of the second group may be missing.
struct Functions {
  Handle (*init_device)(const char*) = nullptr;
  void (*disable_device)(Handle) = nullptr;
  void (*make_current)(Handle) = nullptr;
  void (*begin_frame)(Handle) = nullptr;
  void (*end_frame)(Handle) = nullptr;
  ErrorInfo (*get_error)() = nullptr;
  const char* (*error_string)(unsigned int) = nullptr;
  void (*enable)(Enum) = nullptr;
  void (*disable)(Enum) = nullptr;
  Boolean (*is_enabled)(Enum) = nullptr;
  void (*get_booleans)(Enum, Boolean*) = nullptr;
  void (*get_integers)(Enum, int*) = nullptr;
  void (*get_doubles)(Enum, double*) = nullptr;
  const char* (*get_string)(Enum) = nullptr;
  void (*set_doubles)(Enum, const double*) = nullptr;
  unsigned int (*check_calibration)() = nullptr;
  void (*update_calibration)(unsigned int) = nullptr;
  void (*start_scheduler)() = nullptr;
  void (*stop_scheduler)() = nullptr;
  SchedulerHandle (*schedule_asynchronous)(Callback, void*, unsigned short) = nullptr;
  void (*unschedule)(SchedulerHandle) = nullptr;

  void (*set_scheduler_rate)(unsigned long) = nullptr;
};

}  // namespace nazori::devices::hd
