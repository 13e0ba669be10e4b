// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/every_back_end.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "environment_variable.h"

namespace nazori::devices {
namespace {

TEST(EveryBackEnd, IsThereOnceMakersDevicesFirst) {
  std::vector<std::string> ids;
  for (const auto& back_end : every_back_end({})) ids.emplace_back(back_end->id());
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
  const std::vector<std::string> ranked{"openhaptics", "forcedimension", "inverse3", "pantograph",
                                        "sdl",         "pointer",        "simulated"};
  std::erase_if(ids, [&](const auto& id) { return std::ranges::find(ranked, id) == ranked.end(); });
  EXPECT_EQ(ids, ranked);
}

TEST(EveryBackEnd, LooksWhereTheSettingsSay) {
  const std::string missing = std::string(testing::TempDir()) + "no such library.so";
  const auto all = every_back_end({{"openhaptics_library", missing}, {"forcedimension_library", missing}});
  for (const std::size_t i : {0, 1}) {
    const auto found = all[i]->find();
    ASSERT_TRUE(found.problem);
    EXPECT_NE(base::to_line(found.problem->error).find(missing), std::string::npos)
        << base::to_line(found.problem->error);
  }
}

TEST(EveryBackEnd, ThePortOfTheInverseServiceIsAWholeNumberFromOneOn) {
  const auto asked = [](const std::string& port) -> std::string {
    for (const auto& back_end : every_back_end({{"inverse_port", port}})) {
      if (back_end->id() != "inverse3") continue;
      const auto found = back_end->find();
      return found.problem ? base::to_line(found.problem->error) : "127.0.0.1:10001: a service answers";
    }
    return {};
  };
  EXPECT_NE(asked("1").find("127.0.0.1:1:"), std::string::npos) << asked("1");
  for (const char* port : {"", "0", "65536", "-1", "7x", "x"})
    EXPECT_NE(asked(port).find("127.0.0.1:10001"), std::string::npos) << port << ": " << asked(port);
}

TEST(EveryBackEnd, TheEnvironmentGoesBeforeWhatIsStored) {
  const base::Settings stored{{"openhaptics_library", "a.so"}, {"inverse_port", "7"}, {"other", "x"}};
  EXPECT_EQ(back_end_settings(stored), stored);
  const test::EnvironmentVariable library("NAZORI_LIBHD", "b.so");
  const test::EnvironmentVariable device("NAZORI_OPENHAPTICS_DEVICE", "");
  const test::EnvironmentVariable port("NAZORI_INVERSE_PORT", "");
  const test::EnvironmentVariable button("NAZORI_PANTOGRAPH_BUTTON", "1");
  EXPECT_EQ(back_end_settings(stored), (base::Settings{{"openhaptics_library", "b.so"},
                                                       {"inverse_port", ""},
                                                       {"other", "x"},
                                                       {"pantograph_button", "1"}}));
}

}  // namespace
}  // namespace nazori::devices
