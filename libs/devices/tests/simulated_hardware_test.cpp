// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "nazori/devices/simulated_device.h"

namespace nazori::devices {
namespace {

/// A row of the table in docs/haptics.md, Devices, which names the sources of its figures.
struct Documented {
  std::string name;
  double rate_hz, peak_n, continuous_n, stiffness_n_m, damping_n_s_m, own_n_s_m, slew_n_s, mass_kg,
      friction_n, encoder_mm, delay_ms;
};
const std::vector<Documented> kTable{
    {"Touch / PHANTOM Omni (simulated)", 1000, 3.3, 0.88, 500, 2.5, 0.05, 200, 0.045, 0.26, 0.055, 0},
    {"Touch X / PHANTOM Desktop (simulated)", 1000, 7.9, 1.75, 1000, 5, 0.05, 400, 0.045, 0.06, 0.023, 0},
    {"Falcon (simulated)", 1000, 8, 4, 3000, 20, 0.5, 1200, 0.12, 0.4, 0.06, 0},
    {"omega.3 (simulated)", 4000, 12, 12, 5000, 30, 0.1, 2000, 0.2, 0.05, 0.01, 0},
    {"Inverse3 (simulated)", 1000, 2, 2, 1000, 5, 0.05, 400, 0.1, 0.1, 0.02, 1}};

TEST(SimulatedHardware, IsAsDocumented) {
  const std::vector<SimulatedHardware> presets = SimulatedHardware::presets();
  ASSERT_EQ(presets.size(), kTable.size());
  for (std::size_t i = 0; i < presets.size(); ++i) {
    const SimulatedHardware& h = presets[i];
    const Documented& d = kTable[i];
    EXPECT_EQ(h.name, d.name);
    EXPECT_EQ(h.rate_hz, d.rate_hz) << d.name;
    EXPECT_EQ(h.limits.max_force_n, d.peak_n) << d.name;
    EXPECT_EQ(h.limits.continuous_force_n, d.continuous_n) << d.name;
    EXPECT_EQ(h.limits.max_stiffness_n_m, d.stiffness_n_m) << d.name;
    EXPECT_EQ(h.limits.max_damping_n_s_m, d.damping_n_s_m) << d.name;
    EXPECT_EQ(h.limits.own_damping_n_s_m, d.own_n_s_m) << d.name;
    EXPECT_EQ(h.limits.max_slew_n_s, d.slew_n_s) << d.name;
    EXPECT_EQ(h.mass_kg, d.mass_kg) << d.name;
    EXPECT_EQ(h.coulomb_n, d.friction_n) << d.name;
    EXPECT_NEAR(h.encoder_m * 1e3, d.encoder_mm, 1e-12) << d.name;
    EXPECT_NEAR(h.limits.delay_s * 1e3, d.delay_ms, 1e-12) << d.name;
  }
}

TEST(SimulatedHardware, AHandOfFourTenthsOfAMetreASecondDecidesTheSlew) {
  for (const SimulatedHardware& h : SimulatedHardware::presets())
    EXPECT_NEAR(h.limits.max_slew_n_s, 0.4 * h.limits.max_stiffness_n_m, 1e-9) << h.name;
}

}  // namespace
}  // namespace nazori::devices
