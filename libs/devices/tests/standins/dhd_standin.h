// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

#include "hd_standin.h"

namespace nazori::devices::standin {

/// The hand, the cable and the faults of the stand-in for libdhd.so, and a record of the commands.
struct DhdStage {
  // The test writes.
  std::atomic<double> x_m, y_m, z_m;  ///< in the maker's frame: towards the operator, right, up
  std::atomic<unsigned int> buttons;
  std::atomic<int> devices;          ///< how many are plugged in
  std::atomic<int> open_error;       ///< error of opening and enabling
  std::atomic<bool> not_homed;       ///< dhdEnableForce returns 0 nevertheless; dhdGetStatus reports it
  std::atomic<int> force_off_cause;  ///< 1..6: forces go off for this reason and stay off until it is 0
  std::atomic<int> bad_reads;        ///< so many positions fail
  std::atomic<int> bad_writes;       ///< so many forces are refused
  std::atomic<bool> bad_status;      ///< dhdGetStatus fails
  std::atomic<int> looks_off;        ///< so many answers of dhdGetStatus say that forces are off
  std::atomic<bool> wordless;        ///< errors have no words
  std::atomic<bool> saturated;       ///< dhdSetForce answers 2, which is a success
  std::atomic<const char*> name;
  std::atomic<int> type;
  std::atomic<double> max_force_n;  ///< -1: no answer
  std::atomic<Remains*> remains;    ///< updated if it is not null
  // The library writes.
  /// What was written last, in the maker's frame; the motors feel it while `force_on`.
  std::atomic<double> force_x_n, force_y_n, force_z_n;
  std::atomic<double> force_despite_error_n;  ///< largest force requested while nothing was plugged in
  std::atomic<double> guard_n;                ///< dhdSetMaxForce
  std::atomic<bool> force_on, gravity_on, button_emulated;
  std::atomic<double> switched_on_with_n;  ///< the force that stood there when forces were last switched on
  std::atomic<int> opens, closes, enables;
  std::atomic<std::uint64_t> reads, looks;  ///< of the position and of the status
  std::atomic<std::uint64_t>
      switched_on_at_look;  ///< how many looks there were when forces were last switched on
};

/// Exported by the stand-in as "nazori_standin_dhd"; "nazori_standin_dhd_reset" resets the stage.
using DhdStageFunction = DhdStage* (*)();

}  // namespace nazori::devices::standin
