// SPDX-License-Identifier: Apache-2.0
#include "characters/characters.h"
#include "device/device_place.h"
#include "functions/functions_workplace.h"
#include "progress/progress.h"
#include "study/home.h"
#include "workplace.h"

namespace nazori::ui {
namespace {

template <class T>
std::unique_ptr<Workplace> make(Desk& desk) {
  return std::make_unique<T>(desk);
}

}  // namespace

std::vector<MakeWorkplace> registered_workplaces() {
  return {
      make<Home>, make<Characters>, make<Progress>, make<FunctionsWorkplace>, make<DevicePlace>,
  };
}

}  // namespace nazori::ui
