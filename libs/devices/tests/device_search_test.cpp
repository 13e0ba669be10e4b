// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/device_search.h"

#include <gtest/gtest.h>

#include "scripted_device.h"

namespace nazori::devices {
namespace {

TEST(DeviceSearch, LooksCancelsAndOpensAgainAndAnswersTheNewestWish) {
  base::Inbox inbox;
  DeviceSearch::BackEnds back_ends;
  back_ends.push_back(simulated_back_end());
  back_ends.push_back(pointer_back_end());
  DeviceSearch search(inbox, std::move(back_ends), {});
  std::vector<BackEndFindings> findings;
  search.find([&](auto found) { findings = std::move(found); });
  int answers = 0;
  std::string id;
  for (int i = 0; i < 20; ++i) {
    search.open({"simulated:touch", true, {}}, {}, [&](DeviceFind found) {
      ++answers;
      if (found.opened) id = found.opened->id;
      if (found.opened) search.close(std::move(*found.opened));
    });
    if (i == 10) search.cancel();
  }
  inbox.run_until([&] { return !id.empty(); });
  EXPECT_EQ(id, "simulated:touch");
  EXPECT_EQ(answers, 1);
  EXPECT_EQ(findings.size(), 2U);
  search.open({"simulated:touch", true, {}}, {},
              [](const DeviceFind&) {});  // destroyed before it is answered
}

TEST(DeviceSearch, OpensADeviceWithWhatIsRememberedOfItsId) {
  const auto script = std::make_shared<test::Script>();
  base::Inbox inbox;
  DeviceSearch search(inbox, test::only(script), {});
  RememberedDevices remembered;
  remembered["scripted:arm"].posture.tilt_rad = 0.25;
  std::optional<DeviceFind> answer;
  search.open({"Scripted", true, {}}, remembered, [&](DeviceFind found) { answer = std::move(found); });
  inbox.run_until([&] { return answer.has_value(); });
  ASSERT_TRUE(answer->opened);
  EXPECT_EQ(answer->opened->id, "scripted:arm");
  EXPECT_FALSE(answer->refused);
  EXPECT_EQ(script->asked_tilt_rad, 0.25);
  search.close(std::move(*answer->opened));
}

TEST(DeviceSearch, ExplainsWhyWhatWasAskedForIsNotOpened) {
  const auto script = std::make_shared<test::Script>();
  base::Inbox inbox;
  DeviceSearch search(inbox, test::only(script), {});
  std::optional<DeviceFind> answer;
  const auto ask = [&](DeviceWish wish) {
    answer.reset();
    search.open(std::move(wish), {}, [&](DeviceFind found) { answer = std::move(found); });
    inbox.run_until([&] { return answer.has_value(); });
  };
  ask({"no such device", true, {}});
  ASSERT_TRUE(answer->refused);
  EXPECT_EQ(answer->refused->trouble, haptics::DeviceTrouble::device_absent);
  ASSERT_TRUE(answer->opened) << "the next best";
  search.close(std::move(*answer->opened));
  ask({"no such device", false, {}});
  EXPECT_TRUE(answer->refused);
  EXPECT_FALSE(answer->opened);
  ask({{}, true, {"scripted:arm"}});
  EXPECT_FALSE(answer->refused);
  EXPECT_FALSE(answer->opened);
}

}  // namespace
}  // namespace nazori::devices
