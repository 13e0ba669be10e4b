// SPDX-License-Identifier: Apache-2.0
// Which bristles touch the paper and with what, against the definition of a tuft.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "nazori/brush/tuft.h"

namespace nazori::brush {
namespace {

using geometry::BristleSegment;
using geometry::PaperPoint;
using Swept = std::vector<BristleSegment>;

constexpr int kBristles = 90;

/// Vogel's spiral over the unit circle.
PaperPoint on_spiral(int i, int count) {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  return PaperPoint{std::cos(golden * i), std::sin(golden * i)} * std::sqrt((i + 0.5) / count);
}

/// Thomas Wang's hash of a whole number, as a share of all.
double hashed(std::uint32_t key) {
  key = key ^ 61U ^ (key >> 16U);
  key = key + (key << 3U);
  key = key ^ (key >> 4U);
  key = key * 0x27d4eb2dU;
  key = key ^ (key >> 15U);
  return static_cast<double>(key) / std::pow(2.0, 32);
}

/// The tuft half way and at the nodes of its spine, each with the way of the hair before it.
struct Place {
  double along, x, z, lean, rise, half_width, radius;
};

/// The places of an upright tuft that points along +x, in metres from its foot.
std::vector<Place> places_of(const Tuft& tuft, double depth, double splitting) {
  const TuftForm& form = tuft.form();
  const Spine spine(form.spine);
  const auto along = spine.along();
  const auto sections = tuft.sections();
  const double spread = 1 + 0.7 * depth / (depth + 0.25);
  const double tip = 0.04 + 0.20 * splitting;
  std::vector<Place> places;
  const double foot = sections.front().at.x;
  for (std::size_t k = 0; k + 1 < sections.size(); ++k)
    for (int half = 0; half <= (k + 2 == sections.size() ? 2 : 1); ++half) {
      const TuftSection &a = sections[k], &b = sections[k + 1];
      const double t = half / 2.0;
      const double length = (along[k + 1] - along[k]) * form.hair_m;
      const double s = along[k] + t * (along[k + 1] - along[k]);
      const double radius = form.root_radius_m * (tip + (1 - tip) * (1 - std::pow(s, 4)));
      places.push_back({s, a.at.x - foot + t * (b.at.x - a.at.x), a.z_m + t * (b.z_m - a.z_m),
                        (a.z_m - b.z_m) / length, std::abs(b.at.x - a.at.x) / length, radius * spread,
                        radius / spread});
    }
  return places;
}

struct Touch {
  PaperPoint first, last;  // from the foot
  double half_width, pressure, band;
};

/// The contact of one bristle, or nothing.
std::optional<Touch> touch_of(const std::vector<Place>& places, PaperPoint in_section, double end,
                              double reach, double depth, double splitting) {
  const double up = in_section.x, side = in_section.y;
  const auto between = [&](std::size_t j, double t) {
    const Place &a = places[j - 1], &b = places[j];
    const auto mix = [t](double from, double to) { return from + t * (to - from); };
    return Place{mix(a.along, b.along),           mix(a.x, b.x),          0, b.lean, b.rise,
                 mix(a.half_width, b.half_width), mix(a.radius, b.radius)};
  };
  std::optional<Place> first, last;
  double lowest = reach;
  for (std::size_t j = 0; j < places.size(); ++j) {
    if (j > 0 && places[j - 1].along >= end) break;
    const auto height = [&](const Place& p) { return p.z + p.rise * p.radius * up; };
    const double here = height(places[j]);
    const double before = j > 0 ? height(places[j - 1]) : here;
    lowest = std::min(lowest, here);
    // A share of the way between the places lies below the reach.
    double begin = 0, stop = 1;
    if (before >= reach && here >= reach) continue;
    if (before >= reach) begin = (before - reach) / (before - here);
    if (here >= reach) stop = (reach - before) / (here - before);
    if (j == 0) {
      first = last = places[0];
      continue;
    }
    if (!first) first = begin > 0 ? between(j, begin) : places[j - 1];
    const double whole = places[j].along - places[j - 1].along;
    const double at_end = (end - places[j - 1].along) / whole;
    last = stop >= 1 && at_end >= 1 ? places[j] : between(j, std::min(stop, at_end));
  }
  if (!first || first->along > end) return std::nullopt;
  const auto at = [&](const Place& p) {
    return PaperPoint{p.x + p.lean * p.radius * up, p.half_width * side};
  };
  return Touch{
      at(*first), at(*last), 0, std::clamp(1 - lowest / reach, 0.0, 1.0) * depth / (depth + 0.10),
      std::max(0.00008, 0.5 * 0.11 * (1 - 0.6 * splitting) * (first->half_width + last->half_width))};
}

void expect_contact(int number, double depth, double wetness, double twist_rad) {
  SCOPED_TRACE(depth);
  const TuftForm form = *tuft_form(number);
  Tuft tuft(form, kBristles);
  tuft.set_wetness(wetness);
  tuft.reset(0);
  Swept swept;
  HolderPose pose;
  pose.twist_rad = twist_rad;
  pose.depth_m = -0.1 * form.hair_m;
  tuft.move_to(pose, swept);
  pose.depth_m = depth * form.hair_m;
  pose.time_s = 1;
  tuft.move_to(pose, swept);
  // Drawn backwards, so that it goes on pointing along +x.
  pose.at.x = -0.01;
  tuft.move_to(pose, swept);
  // Hair that lies nearly level comes to rest slowly.
  for (int i = 2; i < 8; ++i) {
    swept.clear();
    pose.time_s = i;
    tuft.move_to(pose, swept);
  }
  ASSERT_NEAR(tuft.points_to_rad(), 0, 1e-12);
  const double dry = std::max(0.0, (0.5 - wetness) / 0.5);
  const double splitting = dry * (0.6 + 0.4 * depth / (depth + 0.10));
  const auto places = places_of(tuft, depth, splitting);
  const double reach = 0.00015 + 0.12 * form.hair_m * depth / (1 + depth / 0.1);
  std::vector<Touch> wanted;
  for (int i = 0; i < kBristles; ++i) {
    const PaperPoint own = on_spiral(i, kBristles);
    PaperPoint clump = on_spiral(0, 9);
    for (int k = 1; k < 9; ++k)
      if (geometry::distance(own, on_spiral(k, 9)) < geometry::distance(own, clump)) clump = on_spiral(k, 9);
    const PaperPoint at = own + (clump - own) * (0.92 * splitting);
    const PaperPoint turned{std::cos(twist_rad) * at.x - std::sin(twist_rad) * at.y,
                            std::sin(twist_rad) * at.x + std::cos(twist_rad) * at.y};
    const double end = 1 - 0.06 * hashed(static_cast<std::uint32_t>(i));
    if (const auto touch = touch_of(places, turned, end, reach, depth, splitting)) wanted.push_back(*touch);
  }
  ASSERT_EQ(tuft.bristles_touching(), static_cast<int>(wanted.size()));
  ASSERT_EQ(swept.size(), wanted.size());
  double left = -1, right = 1, front = -1, back = 1;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Touch& want = wanted[i];
    const PaperPoint middle = pose.at + (want.first + want.last) * 0.5;
    EXPECT_NEAR(swept[i].to.x, middle.x, 2e-7) << i;
    EXPECT_NEAR(swept[i].to.y, middle.y, 2e-7) << i;
    EXPECT_NEAR(swept[i].pressure, want.pressure, 1e-4) << i;
    EXPECT_NEAR(swept[i].width_m, want.band, 1e-9) << i;
    EXPECT_NEAR(swept[i].length_m, geometry::distance(want.first, want.last), 1e-6) << i;
    for (const PaperPoint end : {want.first, want.last}) {
      left = std::max(left, end.y + want.band / 2);
      right = std::min(right, end.y - want.band / 2);
      front = std::max(front, end.x);
      back = std::min(back, end.x);
    }
  }
  EXPECT_NEAR(tuft.width_m(), left - right, 1e-7);
  EXPECT_NEAR(tuft.patch_m(), front - back, 1e-6);
  EXPECT_NEAR(tuft.reach_m(), (front + back) / 2, 1e-6);
}

TEST(TuftContact, OfEachBristleIsThatOfItsPlaceInTheSection) {
  for (const double depth : {0.04, 0.1, 0.2, 0.4})
    for (const double twist : {0.0, 0.7}) expect_contact(2, depth, 1, twist);
}

TEST(TuftContact, OfADryTuftIsThatOfItsClumps) {
  for (const double depth : {0.05, 0.3}) {
    expect_contact(4, depth, 0, 0.3);
    expect_contact(6, depth, 0.3, -0.4);
  }
}

TEST(TuftContact, IsTheSameWhetherTheHolderWasTurnedOrGivenSo) {
  const TuftForm form = *tuft_form(3);
  Swept turned, given;
  for (const double lean_to : {0.0, 2.5}) {
    Tuft one(form, kBristles), other(form, kBristles);
    HolderPose pose;
    pose.depth_m = -0.1 * form.hair_m;
    pose.lean_rad = 0.3;
    one.move_to(pose, turned);
    pose.twist_rad = 0.8;
    pose.lean_to_rad = lean_to;
    one.move_to(pose, turned);
    other.move_to(pose, given);
    pose.depth_m = 0.2 * form.hair_m;
    pose.time_s = 1;
    one.move_to(pose, turned);
    other.move_to(pose, given);
  }
  ASSERT_EQ(turned.size(), given.size());
  ASSERT_GT(given.size(), 100U);
  for (std::size_t i = 0; i < given.size(); ++i) {
    EXPECT_NEAR(geometry::distance(turned[i].to, given[i].to), 0, 1e-7) << i;
    EXPECT_NEAR(turned[i].width_m, given[i].width_m, 1e-9) << i;
  }
}

TEST(TuftContact, ALeanOutOfRangeCountsAsTheLastOneWithin) {
  const TuftForm form = *tuft_form(4);
  for (const auto& [given, taken] : {std::pair{2.0, 1.1}, {-0.7, 0.0}}) {
    Tuft one(form, kBristles), other(form, kBristles);
    Swept swept;
    HolderPose pose;
    for (const double depth : {-0.1, 0.15}) {
      pose.depth_m = depth * form.hair_m;
      pose.lean_rad = given;
      one.move_to(pose, swept);
      pose.lean_rad = taken;
      other.move_to(pose, swept);
    }
    EXPECT_EQ(one.push_n(), other.push_n());
    EXPECT_EQ(one.width_m(), other.width_m());
    for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(one.sections()[k].at, other.sections()[k].at) << k;
  }
}

TEST(TuftContact, APoseThatIsNoNumberIsAsIfItHadNotBeen) {
  const TuftForm form = *tuft_form(4);
  for (int i = 0; i < 7; ++i)
    for (const double none :
         {std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
      Tuft one(form, kBristles), other(form, kBristles);
      Swept swept, wanted;
      HolderPose pose;
      pose.depth_m = 0.1 * form.hair_m;
      one.move_to(pose, swept);
      other.move_to(pose, wanted);
      HolderPose wrong = pose;
      double* numbers[] = {&wrong.time_s,   &wrong.at.x,        &wrong.at.y,     &wrong.depth_m,
                           &wrong.lean_rad, &wrong.lean_to_rad, &wrong.twist_rad};
      *numbers[i] = none;
      one.move_to(wrong, swept);
      pose.at = {0.004, 0.003};
      pose.time_s = 0.1;
      one.move_to(pose, swept);
      other.move_to(pose, wanted);
      ASSERT_EQ(swept.size(), wanted.size()) << i;
      for (std::size_t k = 0; k < wanted.size(); ++k) {
        ASSERT_EQ(swept[k].to, wanted[k].to) << i;
        ASSERT_EQ(swept[k].speed_m_s, wanted[k].speed_m_s) << i;
      }
    }
}

TEST(TuftContact, HairThatIsDraggedAsideSweepsItsWholeLength) {
  // The tuft points along +x and is moved across that; what it sweeps is as long as its patch.
  for (const double side : {1.0, -1.0}) {
    const TuftForm form = *tuft_form(2);
    Tuft tuft(form);
    tuft.reset(0);
    Swept swept;
    HolderPose pose;
    pose.depth_m = 0.15 * form.hair_m;
    tuft.move_to(pose, swept);
    pose.at.x = -0.01;
    tuft.move_to(pose, swept);
    swept.clear();
    pose.at.y = 0.0003 * side;
    pose.time_s = 0.01;
    tuft.move_to(pose, swept);
    ASSERT_LT(std::abs(tuft.points_to_rad()), 0.1);
    double front = -1, back = 1;
    std::size_t parts = 0;
    for (const BristleSegment& s : swept) {
      front = std::max(front, s.to.x + s.width_m / 2);
      back = std::min(back, s.to.x - s.width_m / 2);
    }
    parts = swept.size() / static_cast<std::size_t>(tuft.bristles_touching());
    EXPECT_GE(parts, 2U);
    const double middle = tuft.patch_at().x;
    EXPECT_NEAR(front, middle + tuft.patch_m() / 2, 0.1 * tuft.patch_m());
    EXPECT_NEAR(back, middle - tuft.patch_m() / 2, 0.1 * tuft.patch_m());
  }
}

}  // namespace
}  // namespace nazori::brush
