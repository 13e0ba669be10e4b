// SPDX-License-Identifier: Apache-2.0
#include "characters/characters.h"
#include "device/device_page.h"
#include "functions/functions_page.h"
#include "nazori/studio/brush/brush_page.h"
#include "nazori/studio/workshop/workshop_page.h"
#include "nazori/widgets/page/page.h"
#include "progress/progress.h"
#include "start/check_page.h"
#include "start/start_page.h"
#include "study/home.h"

namespace nazori::ui {
namespace {

template <class T>
std::unique_ptr<Page> make(WindowParts& parts) {
  return std::make_unique<T>(parts);
}

}  // namespace

std::vector<MakePage> registered_pages() {
  return {
      make<Home>,      make<Characters>,   make<Progress>,  make<FunctionsPage>, make<DevicePage>,
      make<BrushPage>, make<WorkshopPage>, make<StartPage>, make<CheckPage>,
  };
}

}  // namespace nazori::ui
