// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/data_points.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "test_paths.h"

namespace nazori::functions {
namespace {

using Points = std::vector<DataPoint>;

TEST(DataPoints, AreReadWithAndWithoutAHeader) {
  const Points wanted{{1, 2.5}, {-3, 4e3}};
  for (const char* text :
       {"1,2.5\n-3,4e3\n", "x,y\n1,2.5\n-3,4e3", "\xEF\xBB\xBFtime;length\r\n1;2.5\r\n-3;4e3\r\n",
        "1\t2.5\n\n-3\t4e3\n", "# measured on Monday\n1  2.5\n-3 4e3\n",
        "\"x\",\"y\"\n\"1\",\"2.5\"\n\"-3\",\"+4000\"\n", "1, 2.5,\n−3, 4000,\n"}) {
    const auto points = parse_data_points(text);
    ASSERT_TRUE(points) << text << points.error().what;
    EXPECT_EQ(*points, wanted) << text;
  }
}

TEST(DataPoints, HaveDecimalCommasWhereTheyAreAskedFor) {
  const auto points = parse_data_points("x;y\n1,5;2\n3;4,25\n", true);
  ASSERT_TRUE(points);
  EXPECT_EQ(*points, (Points{{1.5, 2}, {3, 4.25}}));
}

TEST(DataPoints, NameTheLineThatIsNotXAndY) {
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"x,y\n1,2\n3\n", "line 3"},  {"1,2\n\n3,4,5\n", "line 3"},
      {"1,2\nx,y\n", "line 2"},     {"x,y\n1,2\n3,inf\n", "line 3"},
      {"x,y\n1,2\n3,\n", "line 3"}, {"1,y\n", "line 1"},
      {"x,y\n", "line 1"},          {"", "line 1"},
      {"x,y\n1,2 3\n", "line 2"}};
  for (const auto& [text, line] : mistakes) {
    const auto points = parse_data_points(text);
    ASSERT_FALSE(points) << text;
    EXPECT_EQ(points.error().where, line) << text;
    EXPECT_FALSE(points.error().remedy.empty());
  }
}

TEST(DataPoints, AreAtMostAThousand) {
  std::string text;
  for (std::size_t i = 0; i < kMostDataPoints; ++i) text += "1,2\n";
  EXPECT_EQ(parse_data_points(text)->size(), kMostDataPoints);
  const auto points = parse_data_points(text + "1,2\n");
  ASSERT_FALSE(points);
  EXPECT_EQ(points.error().where, "line 1001");
}

TEST(DataPoints, OfAFileAreRefusedWithItsName) {
  const auto points = load_data_points(std::string(test_paths::kFixtures) + "/plot.json");
  ASSERT_FALSE(points);
  EXPECT_EQ(points.error().where, "plot.json: line 1");
  EXPECT_FALSE(load_data_points("/nowhere/data.csv"));
}

}  // namespace
}  // namespace nazori::functions
