// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/writing_groove.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace nazori::practice {
namespace {

using Mode = WritingGroove::Mode;

/// A groove for 二, and the tablets that it showed to the learner.
struct GrooveUnderTest {
  GrooveUnderTest() {
    std::vector<kanji::StrokeLine> lines(2);
    lines[0].points = {{30, 30}, {80, 30}};
    lines[1].points = {{20, 80}, {90, 80}};
    model = *tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 128);
  }
  /// Depth of the newest tablet at a height of the glyph frame, 0..1 of a full groove.
  [[nodiscard]] double depth_at(double y) const {
    const auto& map = put.back()->height_map();
    const int side = map.size();
    float lowest = 1;
    for (int column = side / 3; column < 2 * side / 3; ++column)
      lowest = std::min(lowest, map.at(column, static_cast<int>(y / 109 * (side - 1))));
    return 1 - lowest;
  }
  void wait_for(std::size_t count) {
    inbox.run_until([&] { return put.size() >= count; });
  }

  Tablet model;
  std::vector<Tablet> put;
  base::Inbox inbox;
  WritingGroove groove{inbox, [this](const Tablet& tablet) { put.push_back(tablet); }};
};

TEST(WritingGroove, HiddenIsABlankTabletAndShownAllGroovesWithoutLines) {
  GrooveUnderTest under;
  under.groove.begin(Mode::hidden, under.model);
  ASSERT_EQ(under.put.size(), 1U);
  EXPECT_TRUE(under.put.back()->lines().empty());
  EXPECT_EQ(under.depth_at(30), 0);
  EXPECT_EQ(under.depth_at(80), 0);
  under.groove.begin(Mode::shown, under.model);
  ASSERT_EQ(under.put.size(), 2U);
  EXPECT_TRUE(under.put.back()->lines().empty());
  EXPECT_GT(under.depth_at(30), 0.5);
  EXPECT_GT(under.depth_at(80), 0.5);
}

TEST(WritingGroove, GroovesOfTheWrittenStrokesAppear) {
  GrooveUnderTest under;
  under.groove.begin(Mode::appears, under.model);
  ASSERT_EQ(under.put.size(), 1U);
  EXPECT_EQ(under.depth_at(30), 0);
  under.groove.carve({1});
  under.wait_for(2);
  EXPECT_EQ(under.depth_at(30), 0);
  EXPECT_GT(under.depth_at(80), 0.5);
  under.groove.carve({1, 0});
  under.wait_for(3);
  EXPECT_GT(under.depth_at(30), 0.5);
  EXPECT_GT(under.depth_at(80), 0.5);
  under.groove.carve({0, 1});
  under.groove.carve({});
  ASSERT_EQ(under.put.size(), 4U)
      << "the same strokes in another order change nothing; none is blank at once";
  EXPECT_EQ(under.depth_at(80), 0);
}

TEST(WritingGroove, OtherModesNeverChangeTheTabletWhileTheCharacterIsWritten) {
  GrooveUnderTest under;
  for (const Mode mode : {Mode::hidden, Mode::shown}) {
    under.groove.begin(mode, under.model);
    under.put.clear();
    under.groove.carve({0});
    under.groove.carve({});
    bool is_past = false;
    under.inbox.post([&] { is_past = true; });
    under.inbox.run_until([&] { return is_past; });
    EXPECT_TRUE(under.put.empty());
  }
}

TEST(WritingGroove, NothingIsPutOnceItHasEndedOrWithoutAModel) {
  GrooveUnderTest under;
  under.groove.begin(Mode::shown, nullptr);
  EXPECT_TRUE(under.put.empty());
  under.groove.begin(Mode::appears, under.model);
  under.groove.carve({0});
  under.groove.end();
  under.groove.carve({1});
  under.put.clear();
  // Another request on the same thread is answered after those before it.
  under.groove.begin(Mode::appears, under.model);
  under.groove.carve({0, 1});
  under.wait_for(2);
  EXPECT_GT(under.depth_at(30), 0.5);
  EXPECT_EQ(under.put.size(), 2U);
}

}  // namespace
}  // namespace nazori::practice
