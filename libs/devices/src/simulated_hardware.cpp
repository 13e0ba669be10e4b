// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/back_end.h"
#include "nazori/devices/simulated_device.h"

namespace nazori::devices {
namespace {

std::string simulated(const char* name) { return name + std::string(kSimulatedMark); }

}  // namespace

SimulatedHardware SimulatedHardware::touch() {
  SimulatedHardware h;
  h.name = simulated("Touch / PHANTOM Omni");
  h.limits.max_force_n = 3.3;
  h.limits.continuous_force_n = 0.88;
  h.limits.max_stiffness_n_m = 500;
  h.limits.max_damping_n_s_m = 2.5;
  h.limits.own_damping_n_s_m = 0.05;
  h.limits.max_slew_n_s = 200;
  h.mass_kg = 0.045;
  h.coulomb_n = 0.26;
  h.encoder_m = 0.055e-3;
  return h;
}

SimulatedHardware SimulatedHardware::touch_x() {
  SimulatedHardware h;
  h.name = simulated("Touch X / PHANTOM Desktop");
  h.limits.max_force_n = 7.9;
  h.limits.continuous_force_n = 1.75;
  h.limits.max_stiffness_n_m = 1000;
  h.limits.max_damping_n_s_m = 5;
  h.limits.own_damping_n_s_m = 0.05;
  h.limits.max_slew_n_s = 400;
  h.mass_kg = 0.045;
  h.coulomb_n = 0.06;
  h.encoder_m = 0.023e-3;
  return h;
}

SimulatedHardware SimulatedHardware::falcon() {
  SimulatedHardware h;
  h.name = simulated("Falcon");
  h.limits.max_force_n = 8;
  h.limits.continuous_force_n = 4;
  h.limits.max_stiffness_n_m = 3000;
  h.limits.max_damping_n_s_m = 20;
  h.limits.own_damping_n_s_m = 0.5;
  h.limits.max_slew_n_s = 1200;
  h.mass_kg = 0.12;
  h.coulomb_n = 0.4;
  h.encoder_m = 0.06e-3;
  return h;
}

SimulatedHardware SimulatedHardware::omega_3() {
  SimulatedHardware h;
  h.name = simulated("omega.3");
  h.rate_hz = 4000;
  h.limits.max_force_n = 12;
  h.limits.continuous_force_n = 12;
  h.limits.max_stiffness_n_m = 5000;
  h.limits.max_damping_n_s_m = 30;
  h.limits.own_damping_n_s_m = 0.1;
  h.limits.max_slew_n_s = 2000;
  h.mass_kg = 0.2;
  h.coulomb_n = 0.05;
  h.encoder_m = 0.01e-3;
  return h;
}

SimulatedHardware SimulatedHardware::inverse3() {
  SimulatedHardware h;
  h.name = simulated("Inverse3");
  h.limits.max_force_n = 2;
  h.limits.continuous_force_n = 2;
  h.limits.max_stiffness_n_m = 1000;
  h.limits.max_damping_n_s_m = 5;
  h.limits.own_damping_n_s_m = 0.05;
  h.limits.max_slew_n_s = 400;
  h.limits.delay_s = 0.001;
  h.mass_kg = 0.1;
  h.coulomb_n = 0.1;
  h.encoder_m = 0.02e-3;
  return h;
}

std::vector<SimulatedHardware> SimulatedHardware::presets() {
  return {touch(), touch_x(), falcon(), omega_3(), inverse3()};
}

}  // namespace nazori::devices
