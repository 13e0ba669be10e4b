// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

namespace nazori::devices::standin {

/// The hand, the cable and the faults of the stand-in for libHD.so; and what the device was made to do.
/// Shared by the test and the library.
struct HdStage {
  // The test writes.
  std::atomic<double> x_mm, y_mm, z_mm;  ///< where the hand holds the stylus
  std::atomic<int> buttons;
  std::atomic<bool> plugged;
  std::atomic<bool> out_of_inkwell;
  std::atomic<bool> safety_held;
  std::atomic<unsigned int> init_error;   ///< hdInitDevice fails with it
  std::atomic<unsigned int> next_error;   ///< appears once, in the next tick
  std::atomic<unsigned int> every_error;  ///< appears in every tick
  std::atomic<unsigned int> start_error;  ///< hdStartScheduler leaves it
  std::atomic<bool> frozen;               ///< the scheduler does not tick
  std::atomic<bool> dumb;                 ///< getters of limits answer 0
  std::atomic<bool> garbage_handle;       ///< failed inits return a number instead of "no device"
  std::atomic<const char*> only_name;     ///< init takes only this name; "" is NULL; null: any
  std::atomic<unsigned int> calibration;  ///< 0x5000, 0x5001, 0x5002
  std::atomic<int> calibration_style;
  std::atomic<double> max_force_n;
  // The library writes.
  std::atomic<double> force_x_n, force_y_n, force_z_n;  ///< at the motors
  std::atomic<double> force_despite_error_n;            ///< most that was written in a tick that had an error
  std::atomic<std::uint64_t> ticks, zero_ticks;         ///< zero_ticks: in a row, without force
  std::atomic<int> inits, disables, calibrations;
  std::atomic<bool> output;  ///< FORCE_OUTPUT
  std::atomic<bool> running;
};

/// Exported by the stand-in as "nazori_standin_hd"; "nazori_standin_hd_reset" puts the stage back.
using HdStageFunction = HdStage* (*)();

}  // namespace nazori::devices::standin
