// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "felt_plane.h"
#include "nazori/devices/force_dimension.h"
#include "standins/dhd_standin.h"
#include "test_paths.h"

namespace nazori::devices::test {

/// The back end on the stand-in of the maker's library, whose stage the test sets.
class ForceDimension : public testing::Test {
 protected:
  static inline const std::string kLibrary = std::string(test_paths::kStandins) + "/libdhd.so";
  /// Has only the functions that every version of the library has.
  static inline const std::string kOlderLibrary =
      std::string(test_paths::kStandins) + "/incomplete/libdhd.so";

  ForceDimension() : stage(stage_of(kLibrary)) {}
  static standin::DhdStage* stage_of(const std::string& path) {
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    EXPECT_NE(library, nullptr) << dlerror();
    reinterpret_cast<void (*)()>(dlsym(library, "nazori_standin_dhd_reset"))();
    return reinterpret_cast<standin::DhdStageFunction>(dlsym(library, "nazori_standin_dhd"))();
  }
  OpenedDevice opened() {
    OpenRequest request;
    request.calibration.emplace();
    auto device = back_end->open("forcedimension", request);
    EXPECT_TRUE(device) << base::to_line(device.error().error);
    return std::move(*device);
  }
  [[nodiscard]] double force() const {
    return std::hypot(stage->force_x_n, stage->force_y_n, stage->force_z_n);
  }

  standin::DhdStage* stage;
  static ForceDimensionSettings settings() {
    ForceDimensionSettings s;
    s.library = kLibrary;
    s.system_folder = "/nowhere";
    return s;
  }
  std::unique_ptr<BackEnd> back_end = force_dimension_back_end(settings());
};

}  // namespace nazori::devices::test
