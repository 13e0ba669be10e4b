// SPDX-License-Identifier: Apache-2.0
#include "inverse_device.h"

#include "linked_device.h"

namespace nazori::devices::inverse {

std::unique_ptr<haptics::HapticDevice> arm_device(const InverseServiceSettings& settings,
                                                  const ArmAddress& arm, const std::string& name,
                                                  const haptics::DeviceLimits& limits,
                                                  const WorkspaceMapping& mapping) {
  return std::make_unique<LinkedDevice<ArmServo, ArmLink>>(
      name, limits, mapping, [&](ServoLink& feeling) { return ArmServo(feeling, limits.delay_s); },
      [&](ServoLink&, ArmServo& servo) { return ArmLink(settings, arm, servo); });
}

}  // namespace nazori::devices::inverse
