// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "../src/pantograph_model.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::devices::pantograph;
  for (const Model& model : kModels) {
    for (const bool has_button : {false, true}) {
      BoardSetup setup = model.setup;
      setup.has_button = has_button;
      Reading reading;
      if (read_reply({data, size}, setup, reading) != Reply::complete) continue;
      if (size < reply_size(setup)) std::abort();
      // Every valid reading gives a pose, and torques within the limits of the motors.
      const LinkagePose pose = pose_at(model.linkage, reading.angle_deg);
      const PerJoint torques = torques_for(pose, {1, -2}, kMostTorque_n_m);
      for (const double torque : torques) {
        if (!(std::abs(torque) <= kMostTorque_n_m)) std::abort();
      }
      if (!std::isfinite(pose.handle_m.x + pose.handle_m.y)) std::abort();
    }
  }
  return 0;
}
