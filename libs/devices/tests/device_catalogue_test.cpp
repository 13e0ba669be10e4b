// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/device_catalogue.h"

#include <gtest/gtest.h>

#include "nazori/devices/pointer_device.h"

namespace nazori::devices {
namespace {

using haptics::DeviceTrouble;

/// A back end whose devices can be plugged in and out.
struct Plug {
  std::vector<FoundDevice> devices;
  bool opens = true;
  std::optional<WorkspaceCalibration> asked_for{};
};

class FakeBackEnd final : public BackEnd {
 public:
  FakeBackEnd(std::string id, Plug& plug) : id_(std::move(id)), plug_(plug) {}
  [[nodiscard]] std::string_view id() const override { return id_; }
  [[nodiscard]] BackEndFindings find() override {
    BackEndFindings found{id_, plug_.devices, std::nullopt};
    if (plug_.devices.empty())
      found.problem =
          no_device(DeviceTrouble::device_absent, "nothing is plugged in", id_, "plug in").value();
    return found;
  }
  [[nodiscard]] DeviceResult<OpenedDevice> open(std::string_view device,
                                                const OpenRequest& request) override {
    plug_.asked_for = request.calibration;
    if (plug_.devices.empty() || !plug_.opens)
      return no_device(DeviceTrouble::init_failed, "it refuses", std::string(device), "switch it off and on");
    const std::string id = device == id_ ? plug_.devices.front().id : std::string(device);
    return OpenedDevice{id, std::make_unique<PointerDevice>(), {}, {}};
  }

 private:
  std::string id_;
  Plug& plug_;
};

class Catalogue : public testing::Test {
 protected:
  Plug arm{{{"arm:1", "Great Arm", true, true}}}, pad{{{"pad:1", "Pad", true, true}}};
  DeviceCatalogue catalogue = [this] {
    std::vector<std::unique_ptr<BackEnd>> all;
    all.push_back(std::make_unique<FakeBackEnd>("arm", arm));
    all.push_back(pointer_back_end());
    all.push_back(std::make_unique<FakeBackEnd>("pad", pad));
    all.push_back(simulated_back_end());
    return DeviceCatalogue(std::move(all));
  }();
};

TEST_F(Catalogue, ListsEveryBackEndWithItsDevicesOrTheReason) {
  arm.devices.clear();
  const std::vector<BackEndFindings> found = catalogue.find();
  ASSERT_EQ(found.size(), 4U);
  EXPECT_TRUE(found[0].devices.empty());
  ASSERT_TRUE(found[0].problem);
  EXPECT_EQ(base::to_line(found[0].problem->error), "arm: nothing is plugged in (plug in)");
  EXPECT_EQ(found[2].devices.front().id, "pad:1");
  EXPECT_EQ(found[3].devices.size(), 5U);
}

TEST_F(Catalogue, OpensByIdByBackEndAndByAPartOfTheName) {
  EXPECT_EQ(catalogue.open("arm:1", {})->id, "arm:1");
  EXPECT_EQ(catalogue.open("arm", {})->id, "arm:1");
  EXPECT_EQ(catalogue.open("great", {})->id, "arm:1");
  EXPECT_EQ(catalogue.open("simulated:falcon", {})->device->describe().name, "Falcon (simulated)");
  const auto none = catalogue.open("gramophone", {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().trouble, DeviceTrouble::device_absent);
  EXPECT_NE(base::to_line(none.error().error).find("arm:1"), std::string::npos);
  EXPECT_FALSE(catalogue.open("", {}));
  EXPECT_FALSE(catalogue.open("simulated:spoon", {}));
}

TEST_F(Catalogue, TheBestOneIsTheFirstWithForce) {
  const BestDevice best = catalogue.open_best("", {});
  ASSERT_TRUE(best.opened);
  EXPECT_EQ(best.opened->id, "arm:1");
  EXPECT_TRUE(best.passed_over.empty());
}

TEST_F(Catalogue, FallsBackAndSaysWhyAndNeverToASimulation) {
  arm.opens = false;
  EXPECT_EQ(catalogue.open_best("", {}).opened->id, "pad:1");
  pad.devices.clear();
  const BestDevice best = catalogue.open_best("", {});
  EXPECT_EQ(best.opened->id, "pointer");
  ASSERT_EQ(best.passed_over.size(), 2U);
  EXPECT_EQ(best.passed_over[0].trouble, DeviceTrouble::device_absent);
  EXPECT_EQ(best.passed_over[1].trouble, DeviceTrouble::init_failed);
}

TEST_F(Catalogue, ThePreferredOneComesFirstAndItsCalibrationIsNotGivenToAnother) {
  OpenRequest request;
  request.calibration.emplace();
  EXPECT_EQ(catalogue.open_best("pad:1", request).opened->id, "pad:1");
  EXPECT_TRUE(pad.asked_for);
  pad.opens = false;
  const BestDevice best = catalogue.open_best("pad:1", request);
  EXPECT_EQ(best.opened->id, "arm:1");
  EXPECT_FALSE(arm.asked_for);
}

TEST_F(Catalogue, ADeviceThatWasJustLostIsTriedLastAndFoundAgainOncePluggedIn) {
  EXPECT_EQ(catalogue.open_best("", {}, "arm:1").opened->id, "pad:1");
  arm.devices.clear();
  EXPECT_EQ(catalogue.open_best("", {}).opened->id, "pad:1");
  arm.devices = {{"arm:1", "Great Arm", true, true}};
  EXPECT_EQ(catalogue.open_best("", {}).opened->id, "arm:1");
}

}  // namespace
}  // namespace nazori::devices
