// SPDX-License-Identifier: Apache-2.0
// Where boxes meet and a place is free, at their edges.
#include <gtest/gtest.h>

#include "../src/boxes.h"
#include "nazori/model/plate.h"

namespace nazori::model {
namespace {

TEST(Boxes, MeetWhereTheyOverlapInBothDirections) {
  const Box box{1, 2, 4, 6};
  EXPECT_TRUE(box.meets({3.9, 5.9, 9, 9}));
  EXPECT_TRUE(box.meets({0, 0, 1.1, 2.1}));
  EXPECT_FALSE(box.meets({4, 3, 9, 5})) << "right of it";
  EXPECT_FALSE(box.meets({0, 3, 1, 5})) << "left of it";
  EXPECT_FALSE(box.meets({2, 6, 3, 9})) << "above it";
  EXPECT_FALSE(box.meets({2, 0, 3, 2})) << "below it";
  const Box wider = box.wider(0.5);
  EXPECT_EQ(wider.left, 0.5);
  EXPECT_EQ(wider.bottom, 1.5);
  EXPECT_EQ(wider.right, 4.5);
  EXPECT_EQ(wider.top, 6.5);
  Occupied taken;
  taken.add_point({0, 0}, 1);
  taken.add_line(PlateLine{{10, 0}, {20, 0}}, 0.5);
  EXPECT_FALSE(taken.has_room({0.9, 0.9, 3, 3}));
  EXPECT_TRUE(taken.has_room({1, 1, 3, 3}));
  EXPECT_FALSE(taken.has_room({-3, -3, -0.9, -0.9}));
  EXPECT_FALSE(taken.has_room({14.9, 0.4, 15.1, 3}));
  EXPECT_TRUE(taken.has_room({14.9, 0.5, 15.1, 3}));
  EXPECT_FALSE(taken.has_room({20.4, -1, 22, 1}));
  EXPECT_TRUE(taken.has_room({20.5, -1, 22, 1}));
  taken.add_box({5, 5, 6, 6});
  EXPECT_FALSE(taken.has_room({5.5, 5.5, 5.6, 5.6}));
}

}  // namespace
}  // namespace nazori::model
