// SPDX-License-Identifier: Apache-2.0
#include "device_nodes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace nazori::devices {
namespace {

TEST(PermissionAdvice, NamesTheGroupToJoinOrAsksForARule) {
  EXPECT_FALSE(permission_advice({}));
  EXPECT_FALSE(permission_advice({{"/dev/ttyACM0", "dialout", true, true}}));
  EXPECT_EQ(*permission_advice({{"/dev/ttyACM0", "dialout", true, false}}),
            "no permission to open /dev/ttyACM0: run sudo usermod -aG dialout $USER, then log out and in");
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

TEST(UsbVendor, IsReadFromBothKindsOfDescriptionAndTheProductToo) {
  namespace fs = std::filesystem;
  const fs::path root = fs::path(testing::TempDir()) / "nazori-usb-vendor";
  const auto describe = [&](const char* group, const char* name, const char* text) {
    fs::create_directories(root / "class" / group / name / "device");
    std::ofstream(root / "class" / group / name / "device" / "uevent") << text;
  };
  describe("hidraw", "hidraw3", "DRIVER=hid-generic\nHID_ID=0003:0000046D:0000C31C\nHID_NAME=a:b\n");
  describe("hidraw", "hidraw4", "HID_ID=0003:00002988:00000302\n");
  describe("tty", "ttyACM0", "DEVTYPE=usb_interface\nPRODUCT=2988/302/100\n");
  describe("tty", "ttyACM1", "PRODUCT=403/cb48/900\n");
  describe("tty", "ttyACM2", "DRIVER=none\n");
  EXPECT_EQ(usb_vendor("/dev/hidraw3", root), "046D");
  EXPECT_EQ(usb_vendor("/dev/hidraw4", root), "2988");
  EXPECT_EQ(usb_vendor("/dev/ttyACM0", root), "2988");
  EXPECT_EQ(usb_vendor("/dev/ttyACM1", root), "0403");
  EXPECT_EQ(usb_vendor("/dev/ttyACM2", root), "");
  EXPECT_EQ(usb_product("/dev/hidraw4", root), "2988:0302");
  EXPECT_EQ(usb_product("/dev/ttyACM1", root), "0403:cb48");
  EXPECT_EQ(usb_product("/dev/ttyACM2", root), "");
  EXPECT_EQ(usb_vendor("/dev/hidraw9", root), "");
  fs::remove_all(root);
}

}  // namespace
}  // namespace nazori::devices
