// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

namespace nazori::devices::standin {

/// The state of a device that remains when the program that used it has ended. In memory that the test shares
/// with it.
struct Remains {
  std::atomic<double> force_n;        ///< that was written last
  std::atomic<bool> output;           ///< whether forces are on
  std::atomic<std::uint64_t> writes;  ///< of forces, so far
};

/// The hand, the cable and the faults of the stand-in for libHD.so; and a record of the commands. Shared by
/// the test and the library.
struct HdStage {
  // The test writes.
  std::atomic<double> x_mm, y_mm, z_mm;  ///< position of the stylus
  std::atomic<int> buttons;
  std::atomic<bool> plugged;
  std::atomic<bool> out_of_inkwell;
  std::atomic<bool> safety_held;
  std::atomic<unsigned int> init_error;  ///< hdInitDevice fails with it
  /// Appears once, in the next tick: 0x0300, 0x0302 and 0x0303 out of hdEndFrame, others at its beginning.
  std::atomic<unsigned int> next_error;
  std::atomic<unsigned int> every_error;  ///< appears in every tick, likewise
  std::atomic<int> bad_ticks;             ///< so many ticks begin with an error of an unknown kind
  std::atomic<unsigned int> start_error;  ///< hdStartScheduler leaves it, and the scheduler does not tick
  std::atomic<bool> frozen;               ///< the scheduler does not tick
  std::atomic<bool> dumb;                 ///< getters of limits return 0
  std::atomic<bool> refuses;              ///< getters of what the device has give garbage and an error
  std::atomic<bool> large;                ///< ... those of a Desktop, and its workspace is not centred at 0
  std::atomic<bool> silent;               ///< failed inits leave no error
  std::atomic<bool> garbage_handle;       ///< failed inits return a number instead of "no device"
  std::atomic<const char*> only_name;     ///< init accepts only this name; "" is NULL; null: any
  std::atomic<unsigned int> calibration;  ///< 0x5000, 0x5001, 0x5002
  std::atomic<int> calibration_style;
  std::atomic<double> max_force_n;
  std::atomic<Remains*> remains;  ///< updated if it is not null
  // The library writes.
  /// The last written force, which stays until another one is written: errors, stopping and closing do not
  /// set it to zero.
  std::atomic<double> force_x_n, force_y_n, force_z_n;
  std::atomic<double> force_despite_error_n;     ///< largest force written after an error could be read
  std::atomic<std::uint64_t> ticks, zero_ticks;  ///< zero_ticks: in a row, without force
  std::atomic<int> inits, disables, calibrations;
  std::atomic<int> checks;                  ///< of the calibration
  std::atomic<unsigned int> calibrated_by;  ///< the style of the last one
  std::atomic<bool> output;                 ///< FORCE_OUTPUT
  std::atomic<bool> running;
};

/// Exported by the stand-in as "nazori_standin_hd"; "nazori_standin_hd_reset" resets the stage.
using HdStageFunction = HdStage* (*)();

}  // namespace nazori::devices::standin
