// SPDX-License-Identifier: Apache-2.0
// The discs of a mark in a photograph: where they are, and what is none.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "../src/blobs.h"
#include "drawn_photo.h"

namespace nazori::scan {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

TEST(Discs, AreFoundWithCentreAndRadius) {
  Drawn drawn(600, 500, 220);
  const PhotoPoint centre{233.4, 151.7};
  drawn.disc(centre, 9);
  const auto found = find_discs(drawn.photo());
  ASSERT_THAT(found, SizeIs(1));
  expect_near(found[0].centre, centre, 0.1);
  EXPECT_NEAR(found[0].radius, 9, 0.4);
  EXPECT_LT(found[0].unlike, 0.05);
}

TEST(Discs, OfALargePhotographAreAsExact) {
  // Looked for in a picture of a third of the size.
  Drawn drawn(3700, 2500, 220);
  const PhotoPoint centre{2233.4, 1151.7};
  drawn.disc(centre, 40);
  drawn.disc({3600, 60}, 30);
  const auto found = find_discs(drawn.photo());
  ASSERT_THAT(found, SizeIs(2));
  expect_near(found[0].centre, centre, 0.2);
  EXPECT_NEAR(found[0].radius, 40, 2);
  expect_near(found[1].centre, {3600, 60}, 0.2);
  EXPECT_NEAR(found[1].radius, 30, 2);
}

TEST(Discs, SeenAtASlantAreFoundTheLargestFirst) {
  Drawn drawn(600, 500, 220);
  drawn.ellipse({100, 100}, 10, 6);
  drawn.ellipse({300, 300}, 6, 9);
  drawn.disc({500, 400}, 5);
  const auto found = find_discs(drawn.photo());
  ASSERT_THAT(found, SizeIs(3));
  expect_near(found[0].centre, {100, 100}, 0.1);
  expect_near(found[1].centre, {300, 300}, 0.1);
  expect_near(found[2].centre, {500, 400}, 0.1);
  EXPECT_NEAR(found[1].radius, std::sqrt(54), 0.4) << "the geometric mean";
}

TEST(Discs, OtherSpotsAreNone) {
  Drawn bar(600, 500, 220);
  bar.ellipse({200, 200}, 12, 4);
  EXPECT_THAT(find_discs(bar.photo()), IsEmpty()) << "three times as long as wide";
  Drawn ring(600, 500, 220);
  ring.disc({200, 200}, 10);
  ring.disc({200, 200}, 5, 220);
  EXPECT_THAT(find_discs(ring.photo()), IsEmpty());
  Drawn corner(600, 500, 220);
  corner.block(200, 200, 220, 204, 20);
  corner.block(200, 200, 204, 220, 20);
  EXPECT_THAT(find_discs(corner.photo()), IsEmpty());
  EXPECT_THAT(find_discs(Drawn(600, 500, 220).photo()), IsEmpty());
}

TEST(Discs, AtTheEdgeOfThePhotographAreNone) {
  for (const PhotoPoint centre : {PhotoPoint{4, 200}, {200, 4}, {595, 200}, {200, 495}}) {
    Drawn drawn(600, 500, 220);
    drawn.disc(centre, 8);
    EXPECT_THAT(find_discs(drawn.photo()), IsEmpty());
  }
  for (const PhotoPoint centre : {PhotoPoint{11, 200}, {200, 11}, {588, 200}, {200, 488}}) {
    Drawn drawn(600, 500, 220);
    drawn.disc(centre, 8);
    EXPECT_THAT(find_discs(drawn.photo()), SizeIs(1));
  }
}

TEST(Discs, TooSmallOrTooLargeAreNone) {
  // 20 pixels at least, and a twentieth of the narrower side of the photograph at most.
  for (const auto& [radius, counts] : {std::pair{2.0, false}, {3.0, true}, {9.0, true}, {11.0, false}}) {
    Drawn drawn(600, 400, 220);
    drawn.disc({200, 200}, radius);
    EXPECT_THAT(find_discs(drawn.photo()), SizeIs(counts ? 1 : 0)) << radius;
  }
}

TEST(Discs, OnlyWhatIsMuchDarkerThanItsSurroundingsCounts) {
  // A disc is darker than 0.78 of the brightness around.
  for (const auto& [brightness, counts] : {std::pair{150, true}, {161, false}}) {
    Drawn drawn(600, 400, 200);
    drawn.disc({200, 200}, 9, static_cast<std::uint8_t>(brightness));
    EXPECT_THAT(find_discs(drawn.photo()), SizeIs(counts ? 1 : 0)) << brightness;
  }
}

TEST(Discs, AreFoundInUnevenLight) {
  Drawn drawn(600, 400, 0);
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 600; ++x) drawn.at(x, y) = static_cast<std::uint8_t>(60 + x / 4 + y / 10);
  const std::vector<PhotoPoint> centres{{40, 50}, {560, 50}, {560, 350}, {40, 350}};
  for (const PhotoPoint c : centres)
    drawn.disc(c, 8, static_cast<std::uint8_t>((60 + c.x / 4 + c.y / 10) * 0.3));
  const auto found = find_discs(drawn.photo());
  ASSERT_THAT(found, SizeIs(4));
  for (const PhotoPoint c : centres)
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                            [&](const Blob& b) { return geometry::distance(b.centre, c) < 0.3; }))
        << c.x << " " << c.y;
}

TEST(Discs, OfVeryManyTheLargestAreKept) {
  Drawn drawn(800, 800, 220);
  for (int i = 0; i < 40; ++i) drawn.disc({100.0 + 80 * (i % 8), 100.0 + 80 * (i / 8)}, i < 12 ? 6 : 9);
  const auto found = find_discs(drawn.photo());
  ASSERT_THAT(found, SizeIs(28));
  for (const Blob& b : found) EXPECT_NEAR(b.radius, 9, 0.5);
}

TEST(Discs, MayBeUpToTwiceAndTwoFifthsAsLongAsWide) {
  for (const auto& [short_side, counts] : {std::pair{5.4, true}, {4.6, false}}) {
    Drawn level(600, 500, 220), upright(600, 500, 220);
    level.ellipse({200, 200}, 12, short_side);
    upright.ellipse({200, 200}, short_side, 12);
    EXPECT_THAT(find_discs(level.photo()), SizeIs(counts ? 1 : 0)) << short_side;
    EXPECT_THAT(find_discs(upright.photo()), SizeIs(counts ? 1 : 0)) << short_side;
  }
}

TEST(Discs, MayHaveASmallBrightMiddle) {
  // A ring is unlike a disc by 2 k^2 / (1 + k^2) where its hole has k times its radius; 0.13 is the most.
  for (const auto& [hole, counts] : {std::pair{4.6, true}, {6.0, false}}) {
    Drawn ring(1000, 1000, 220);
    ring.disc({300, 300}, 20);
    ring.disc({300, 300}, hole, 220);
    const auto found = find_discs(ring.photo());
    ASSERT_THAT(found, SizeIs(counts ? 1 : 0)) << hole;
    if (counts) {
      const double k = hole / 20;
      EXPECT_NEAR(found[0].unlike, 2 * k * k / (1 + k * k), 0.02);
    }
  }
}

TEST(Discs, OfOneSizeThatAreMoreLikeDiscsComeFirst) {
  Drawn drawn(1000, 1000, 220);
  drawn.disc({300, 300}, 20);
  drawn.disc({300, 300}, 4.6, 220);
  drawn.disc({700, 700}, 19.5);
  const auto found = find_discs(drawn.photo());
  ASSERT_THAT(found, SizeIs(2));
  expect_near(found[0].centre, {700, 700}, 0.2);
}

TEST(Discs, AreDarkComparedWithATwelfthOfThePhotographAround) {
  // On paper of 150 a disc of 115 is not dark, but it is beside paper of 255 that is near enough.
  for (const auto& [from, counts] : {std::pair{15, true}, {36, false}}) {
    Drawn drawn(600, 500, 150);
    drawn.block(300 + from, 0, 599, 499, 255);
    drawn.disc({300, 250}, 9, 115);
    EXPECT_THAT(find_discs(drawn.photo()), SizeIs(counts ? 1 : 0)) << from;
  }
}

TEST(Discs, ADarkLineBesideOneDoesNotMoveItsMiddle) {
  Drawn drawn(600, 500, 220);
  drawn.disc({200, 200}, 9);
  // Farther away than half of the radius and a pixel.
  drawn.block(216, 150, 218, 250, 20);
  const auto found = find_discs(drawn.photo());
  ASSERT_FALSE(found.empty());
  expect_near(found[0].centre, {200, 200}, 0.1);
}

}  // namespace
}  // namespace nazori::scan
