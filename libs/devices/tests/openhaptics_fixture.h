// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <memory>
#include <string>
#include <utility>

#include "felt_plane.h"
#include "nazori/devices/device_catalogue.h"
#include "nazori/devices/openhaptics.h"
#include "standins/hd_standin.h"
#include "test_paths.h"

namespace nazori::devices::test {

/// The back end on the stand-in of the maker's library, whose stage the test sets.
class OpenHaptics : public testing::Test {
 protected:
  static inline const std::string kLibrary = std::string(test_paths::kStandins) + "/libHD.so";

  OpenHaptics() {
    EXPECT_NE(loaded, nullptr) << dlerror();
    stage = function<standin::HdStageFunction>("nazori_standin_hd")();
    function<void (*)()>("nazori_standin_hd_reset")();
  }
  /// A function of the library, as another part of the program calls it.
  template <class Function>
  [[nodiscard]] Function function(const char* name) const {
    return reinterpret_cast<Function>(dlsym(loaded, name));
  }
  static OpenHapticsSettings settings() {
    OpenHapticsSettings s;
    s.library = kLibrary;
    s.device_folder = "/nowhere";
    return s;
  }
  OpenedDevice opened(const OpenRequest& request = {}) {
    auto device = back_end->open("openhaptics", request);
    EXPECT_TRUE(device) << base::to_line(device.error().error);
    return std::move(*device);
  }
  /// Puts the stylus there, in the tablet frame.
  void hold(const WorkspaceMapping& mapping, const Vec3& tablet_m) const {
    const Vec3 mm = mapping.to_device_m(tablet_m) * 1e3;
    stage->x_mm = mm.x;
    stage->y_mm = mm.y;
    stage->z_mm = mm.z;
  }
  [[nodiscard]] Vec3 force() const {
    return {stage->force_x_n.load(), stage->force_y_n.load(), stage->force_z_n.load()};
  }
  [[nodiscard]] bool pushes(const Vec3& expected) const { return glm::length(force() - expected) < 1e-6; }

  void* loaded = dlopen(kLibrary.c_str(), RTLD_NOW | RTLD_GLOBAL);
  standin::HdStage* stage = nullptr;
  std::unique_ptr<BackEnd> back_end = openhaptics_back_end(settings());
};

}  // namespace nazori::devices::test
