// SPDX-License-Identifier: Apache-2.0
#include "device_nodes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

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

/// A folder with empty files, gone with the test.
class FolderOfNodes : public testing::Test {
 protected:
  FolderOfNodes() { std::filesystem::create_directories(root_); }
  ~FolderOfNodes() override { std::filesystem::remove_all(root_); }
  void add(const std::string& name, std::filesystem::perms mode = std::filesystem::perms(0660)) const {
    std::ofstream(root_ / name) << "";
    std::filesystem::permissions(root_ / name, mode);
  }
  [[nodiscard]] std::vector<std::string> names(const std::vector<std::string_view>& prefixes) const {
    std::vector<std::string> names;
    for (const DeviceNode& node : device_nodes(root_, prefixes))
      names.push_back(node.path.filename().string());
    return names;
  }
  const std::filesystem::path root_ = std::filesystem::path(testing::TempDir()) / "nazori-nodes";
};

TEST_F(FolderOfNodes, GivesThemByNameInWhicheverOrderTheyCame) {
  for (const char* name : {"raw3", "raw1", "ttyS0", "hid2", "raw2", "ttyS9", "hid0", "ttyS5", "raw0", "hid1",
                           "other", "xraw4", "hi3", "ttyS2"})
    add(name);
  EXPECT_EQ(names({"ttyS", "hid", "raw"}),
            (std::vector<std::string>{"hid0", "hid1", "hid2", "raw0", "raw1", "raw2", "raw3", "ttyS0",
                                      "ttyS2", "ttyS5", "ttyS9"}));
  EXPECT_EQ(names({"hid2"}), std::vector<std::string>{"hid2"});
  EXPECT_TRUE(names({}).empty());
}

TEST_F(FolderOfNodes, TheGroupMayUseANodeThatItMayBothReadAndWrite) {
  const auto open_to_group = [this](int mode) {
    add("node", std::filesystem::perms(mode));
    return device_nodes(root_, {"node"}).at(0).group_open;
  };
  EXPECT_TRUE(open_to_group(0660));
  EXPECT_TRUE(open_to_group(0677));
  EXPECT_FALSE(open_to_group(0640));
  EXPECT_FALSE(open_to_group(0626));
  EXPECT_FALSE(open_to_group(0606));
}

TEST_F(FolderOfNodes, ALinkToNothingIsNoNode) {
  std::filesystem::create_symlink(root_ / "gone", root_ / "link");
  EXPECT_TRUE(names({"link"}).empty());
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
