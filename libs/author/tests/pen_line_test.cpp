// SPDX-License-Identifier: Apache-2.0
// Which points of a groove are needed, and the pressure of a pen.
#include "../src/pen_line.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

namespace nazori::author {
namespace {

using carving::Groove;
using carving::GroovePoint;

TEST(SimplifiedGroove, KeepsAPointThatLineWidthOrDepthNeeds) {
  const GroovePoint first{{10, 20}, 2, 0.5};
  const GroovePoint last{{30, 20}, 4, 0.7};
  // Half way all is in the middle; then one of the four is off by a tenth of a unit.
  const GroovePoint even{{20, 20}, 3, 0.6};
  for (const GroovePoint& middle : {even, GroovePoint{{20, 20.1}, 3, 0.6}, GroovePoint{{20, 20}, 3.1, 0.6},
                                    GroovePoint{{20, 20}, 3, 0.61}}) {
    EXPECT_EQ(simplified({first, middle, last}, 0.11), (Groove{first, last}));
    const Groove exact = middle == even ? Groove{first, last} : Groove{first, middle, last};
    EXPECT_EQ(simplified({first, middle, last}, 0.08), exact);
  }
}

TEST(SimplifiedGroove, HasNoPlaceTwiceInARow) {
  const GroovePoint first{{10, 20}, 1, 0.5};
  const GroovePoint there_too{{10, 20}, 3, 0.5};
  const GroovePoint last{{30, 20}, 1, 0.5};
  EXPECT_EQ(simplified({first, there_too, last}, 0.1), (Groove{first, last}));
  EXPECT_EQ(simplified({first, last, first}, 0.1), (Groove{first, last, first}));
  EXPECT_EQ(simplified({first}, 0.1), Groove{first});
  EXPECT_TRUE(simplified({}, 0.1).empty());
}

TEST(PenPressure, IsBetweenNoneAndFullAndFullWhereThereIsNone) {
  const auto pressure = [](std::optional<double> reported) {
    geometry::WrittenPoint<geometry::GlyphFrame> point;
    point.pressure = reported;
    return pressure_of(point);
  };
  EXPECT_EQ(pressure(0.25), 0.25);
  EXPECT_EQ(pressure(0.0), 0.0);
  EXPECT_EQ(pressure(-0.1), 0.0);
  EXPECT_EQ(pressure(1.1), 1.0);
  EXPECT_EQ(pressure(std::nullopt), 1.0);
  EXPECT_EQ(pressure(std::numeric_limits<double>::quiet_NaN()), 1.0);
  EXPECT_EQ(pressure(std::numeric_limits<double>::infinity()), 1.0);
}

}  // namespace
}  // namespace nazori::author
