// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The binary interface of Force Dimension's DHD, as far as it is used here, declared by this program. C
/// linkage; the device's number, a default argument of -1 in the maker's header, must be passed.
/// @source DHD 3.17 dhdc.h: names and types. Metres and newtons; x towards the operator, y to the right, z
/// up. A negative answer is an error, 1 (time guard) and 2 (motors saturated) are successes.
namespace nazori::devices::dhd {

inline constexpr int kFalcon = 60;
inline constexpr const char* kVendor = "1451";          // USB, of Force Dimension
inline constexpr const char* kFalconUsb = "0403:cb48";  // of a Novint Falcon
inline constexpr int kErrorComm = 2, kErrorBusy = 3, kErrorNoDevice = 5, kErrorInUse = 20;

// Entries of dhdGetStatus. Versions differ in how many there are (15 to 17), so there is room for more.
inline constexpr int kStatusRoom = 32;
inline constexpr int kReset = 3;           // 1: not homed
inline constexpr int kForce = 5;           // 1: forces are on
inline constexpr int kForceOffCause = 14;  // as devices::ForcesOff

/// The functions; those of the second group may be missing.
struct Functions {
  int (*device_count)() = nullptr;
  int (*open)(char index) = nullptr;
  int (*close)(char id) = nullptr;
  int (*last_error)() = nullptr;
  const char* (*last_error_text)() = nullptr;
  int (*enable_force)(unsigned char on, char id) = nullptr;
  int (*get_position)(double* x, double* y, double* z, char id) = nullptr;
  int (*set_force)(double x, double y, double z, char id) = nullptr;

  const char* (*system_name)(char id) = nullptr;
  int (*system_type)(char id) = nullptr;
  unsigned int (*button_mask)(char id) = nullptr;
  int (*button)(int index, char id) = nullptr;
  double (*max_force)(char id) = nullptr;
  int (*set_max_force)(double newtons, char id) = nullptr;
  int (*set_gravity_compensation)(int on, char id) = nullptr;
  int (*status)(int* entries, char id) = nullptr;
  int (*emulate_button)(unsigned char on, char id) = nullptr;
};

}  // namespace nazori::devices::dhd
