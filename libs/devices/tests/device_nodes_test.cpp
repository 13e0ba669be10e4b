// SPDX-License-Identifier: Apache-2.0
#include "device_nodes.h"

#include <gtest/gtest.h>

namespace nazori::devices {
namespace {

TEST(PermissionAdvice, NamesTheGroupToJoinOrAsksForARule) {
  EXPECT_FALSE(permission_advice({}));
  EXPECT_FALSE(permission_advice({{"/dev/ttyACM0", "dialout", true, true}}));
  EXPECT_EQ(*permission_advice({{"/dev/ttyACM0", "dialout", true, false}}),
            "you may not open /dev/ttyACM0: run sudo usermod -aG dialout $USER, then log out and in");
  const std::string rule = *permission_advice({{"/dev/hidraw3", "root", false, false}});
  EXPECT_NE(rule.find("udev rule"), std::string::npos);
  EXPECT_NE(rule.find("/dev/hidraw3"), std::string::npos);
}

TEST(DeviceNodes, AreTheEntriesOfTheFolderWithThosePrefixes) {
  const std::vector<DeviceNode> nodes = device_nodes("/dev", {"null"});
  ASSERT_EQ(nodes.size(), 1U);
  EXPECT_EQ(nodes.front().path, "/dev/null");
  EXPECT_TRUE(nodes.front().open);
  EXPECT_FALSE(nodes.front().group.empty());
  EXPECT_TRUE(device_nodes("/nowhere/at/all", {"null"}).empty());
}

}  // namespace
}  // namespace nazori::devices
