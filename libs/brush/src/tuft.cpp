// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/tuft.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace nazori::brush {
namespace {

using geometry::BristleSegment;
using geometry::PaperPoint;

constexpr double kPi = std::numbers::pi;
constexpr double kTooth_m = 0.00015;  // hair that is at most so high touches: tooth of the paper, film of ink
constexpr double kCrushed = 0.12;     // of the depth: hair that is higher by so little is bent down as well
constexpr double kMostCrushed = 0.1;  // depth at which that is half as much [L]
constexpr double kThinnest_m = 0.00008;  // of a bristle
constexpr double kCovers = 0.11;         // breadth of a bristle over the half breadth of the tuft
constexpr double kMostSpread = 0.7;      // of the tuft, under a deep press
constexpr double kHalfSpread = 0.25;     // depth at which it is half of that [L]
constexpr double kHalfPressure = 0.10;   // depth at which a bristle has half of its pressure [L]
constexpr double kPoint = 0.04;          // radius of a wet tuft at its tip, over that at its root
constexpr double kBlunt = 0.20;          // more for a dry one
constexpr double kSplitsBelow = 0.5;     // wetness
constexpr double kJoins = 0.92;          // how near the hairs of a clump come to its centre
constexpr double kThinner = 0.6;         // a bristle without the film of ink around it
constexpr int kClumps = 9;
constexpr double kLeans_rad = 0.05;                           // a holder that leans less is upright
constexpr double kTurned_rad = kPi * (3 - 2.23606797749979);  // golden angle
constexpr int kMostSteps = 32;
constexpr int kStepsPerSweep = 2;  // within a report of the pen
constexpr int kTowParts = 4;
constexpr double kRests_m = 1e-6;    // a bristle that moves by less in a step rests
constexpr double kWidestPart = 2.5;  // of a bristle that is dragged aside, over the breadth of the bristle
constexpr int kMostParts = 12;       // of a bristle that is dragged aside
constexpr std::size_t kBetween = 2;  // stations on each segment of the spine

/// Points spread evenly over the unit circle. @source H. Vogel, Mathematical Biosciences 44, 1979.
PaperPoint vogel(int i, int count) {
  const double radius = std::sqrt((i + 0.5) / count);
  return {radius * std::cos(kTurned_rad * i), radius * std::sin(kTurned_rad * i)};
}

/// 0..1, the same for the same number.
double scattered(std::uint32_t number) {
  number = (number ^ 61U) ^ (number >> 16U);
  number *= 9U;
  number ^= number >> 4U;
  number *= 0x27d4eb2dU;
  number ^= number >> 15U;
  return number / 4294967296.0;
}

bool usable(const HolderPose& pose) {
  return std::isfinite(pose.time_s) && std::isfinite(pose.at.x) && std::isfinite(pose.at.y) &&
         std::isfinite(pose.depth_m) && std::isfinite(pose.lean_rad) && std::isfinite(pose.lean_to_rad) &&
         std::isfinite(pose.twist_rad);
}

PaperPoint direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// The way from angle `a` to angle `b` by the shorter side.
double turn_between(double a, double b) { return std::remainder(b - a, 2 * kPi); }

}  // namespace

/// A place on the spine at which bristles are looked at; lengths in metres.
struct Tuft::Station {
  double along;       // of the length of the hair
  double x, z;        // in the plane of the bend
  double lean, rise;  // of the hair there: cosine and sine of its angle from upright
  double half_width, radius;
};

Tuft::Tuft(const TuftForm& form, int bristles) : form_(form), spine_(form.spine, form.friction(1)) {
  assert(bristles > 0 && form.hair_m > 0);
  for (int i = 0; i < bristles; ++i) {
    const PaperPoint at = vogel(i, bristles);
    PaperPoint centre;
    double nearest = 9;
    for (int k = 0; k < kClumps; ++k) {
      const PaperPoint clump = vogel(k, kClumps);
      const double far = geometry::distance(at, clump);
      if (far >= nearest) continue;
      nearest = far;
      centre = clump;
    }
    places_.push_back({at.x, at.y, centre.x, centre.y, 1 - 0.06 * scattered(static_cast<std::uint32_t>(i))});
  }
  before_.resize(places_.size());
  now_.resize(places_.size());
  reset();
}

void Tuft::set_wetness(double wetness) noexcept {
  wetness_ = std::isfinite(wetness) ? std::clamp(wetness, 0.0, 1.0) : 0.0;
  spine_.set_friction(form_.friction(wetness_));
}

void Tuft::set_pigment(double pigment) noexcept {
  pigment_ = std::isfinite(pigment) ? std::clamp(pigment, 0.0, 1.0) : 0.0;
}

void Tuft::reset(double points_to_rad) noexcept {
  azimuth_ = points_to_rad;
  spine_.place({{0, 1.5}, 0});
  placed_ = false;
  touching_ = 0;
  width_m_ = patch_m_ = reach_m_ = 0;
  for (Contact& contact : now_) contact.pressure = -1;
}

double Tuft::push_n() const noexcept { return spine_.push() * form_.force_unit_n(); }

PaperPoint Tuft::patch_at() const noexcept { return pose_.at + direction(azimuth_) * reach_m_; }

double Tuft::depth() const noexcept { return std::max(0.0, pose_.depth_m / form_.hair_m); }

double Tuft::spread() const noexcept { return 1 + kMostSpread * depth() / (depth() + kHalfSpread); }

double Tuft::splitting() const noexcept {
  const double dry = std::clamp((kSplitsBelow - wetness_) / kSplitsBelow, 0.0, 1.0);
  return dry * (0.6 + 0.4 * depth() / (depth() + kHalfPressure));
}

double Tuft::radius_m(double along) const noexcept {
  const double tip = kPoint + kBlunt * splitting();
  return form_.root_radius_m * (tip + (1 - tip) * (1 - std::pow(along, form_.spine.bulge)));
}

/// The pose in the plane of the bend, whose x is 0 at the holder's foot.
SpinePose Tuft::spine_pose(const HolderPose& pose) const noexcept {
  const double tilt = -std::atan(std::tan(pose.lean_rad) * std::cos(pose.lean_to_rad - azimuth_));
  const double height = std::max(kLowestRoot, std::cos(tilt) - pose.depth_m / form_.hair_m);
  return {{-height * std::tan(tilt), height}, tilt};
}

/// The foot moves by `by`; friction holds the patch back, so the plane of the bend turns to it.
void Tuft::tow(PaperPoint by) noexcept {
  double push = 0, moment = 0;
  for (std::size_t k = 0; k < spine_.nodes().size(); ++k) {
    push += spine_.pushes()[k];
    moment += spine_.pushes()[k] * spine_.nodes()[k].x;
  }
  if (push <= 0) return;
  double reach = moment / push;
  if (reach < 0) {
    spine_.mirror();
    azimuth_ += kPi;
    reach = -reach;
  }
  // The patch slides along the tow while the foot moves on. In parts of a step this is exact enough.
  PaperPoint tow = direction(azimuth_) * (reach * form_.hair_m);
  double drawn = 0;
  for (int part = 0; part < kTowParts; ++part) {
    tow = tow - by * (1.0 / kTowParts);
    const double now = geometry::length(tow) / form_.hair_m;
    drawn += now - reach;
    if (now > 1e-9) tow = tow * (reach / now);
  }
  if (reach > 1e-9) azimuth_ = std::atan2(tow.y, tow.x);
  spine_.shift(drawn);
}

void Tuft::step_to(const HolderPose& pose) {
  tow(pose.at - pose_.at);
  // In the air nothing holds the hair; the tip lies on the far side of a leaning holder.
  if (spine_.push() <= 0 && pose.lean_rad > kLeans_rad) azimuth_ = pose.lean_to_rad + kPi;
  const SpinePose spine = spine_pose(pose);
  // Far above the paper nothing is to be computed in small steps.
  if (spine.root.z > 1.3)
    spine_.place({{spine.root.x, 1.3}, spine.tilt_rad});
  else
    (void)spine_.move_to(spine);
  pose_ = pose;
}

void Tuft::touch(std::vector<Contact>& contacts) {
  constexpr std::size_t kMost = kBetween * Spine::kMostSegments + 1;
  std::array<Station, kMost> stations;
  std::size_t count = 0;
  bool reached = false;
  const auto nodes = spine_.nodes();
  const auto along = spine_.along();
  const double hair = form_.hair_m, spreads = spread();
  // The fine hair at the tip is softer than a segment of the spine tells.
  const double reach = kTooth_m + kCrushed * hair * depth() / (1 + depth() / kMostCrushed);
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    const double length = along[k + 1] - along[k];
    const double lean = (nodes[k].z - nodes[k + 1].z) / length, rise = (nodes[k + 1].x - nodes[k].x) / length;
    const bool last = k + 2 == nodes.size();
    for (std::size_t i = 0; i < kBetween + (last ? 1 : 0); ++i) {
      const double t = static_cast<double>(i) / kBetween;
      const double z = hair * (nodes[k].z + t * (nodes[k + 1].z - nodes[k].z));
      const double s = along[k] + t * length;
      const double x = hair * (nodes[k].x + t * (nodes[k + 1].x - nodes[k].x));
      const double radius = radius_m(s);
      const Station station{s, x, z, lean, std::abs(rise), radius * spreads, radius / spreads};
      reached = reached || z < reach + station.rise * station.radius;
      // Of the stations at which no hair can touch, only the last is needed.
      if (!reached) count = 0;
      stations[count++] = station;
    }
  }
  const double push = spine_.push();
  const double pressed = depth() / (depth() + kHalfPressure);
  const double split = splitting() * kJoins;
  const double covers = 0.5 * kCovers * (1 - kThinner * splitting());
  const PaperPoint ahead = direction(azimuth_), left{-ahead.y, ahead.x};
  // The section turns with the holder; the plane of the bend does not.
  const double turned = pose_.twist_rad - azimuth_;
  const double cosine = std::cos(turned), sine = std::sin(turned);
  touching_ = 0;
  double left_most = 0, right_most = 0, front = 0, back = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& place = places_[i];
    Contact& contact = contacts[i];
    contact.pressure = -1;
    if (push <= 0) continue;
    const double px = place.x + split * (place.clump_x - place.x);
    const double py = place.y + split * (place.clump_y - place.y);
    const double up = cosine * px - sine * py, side = sine * px + cosine * py;
    double from = 2, lowest = reach, before = 0;
    Station first{}, final{};
    for (std::size_t j = 0; j < count; ++j) {
      const Station& station = stations[j];
      if (j > 0 && stations[j - 1].along >= place.end) break;
      const double height = station.z + station.rise * station.radius * up;
      const bool touches = height < reach;
      const auto between = [&](double t) {
        const Station& a = stations[j - 1];
        return Station{a.along + t * (station.along - a.along),
                       a.x + t * (station.x - a.x),
                       0,
                       station.lean,
                       station.rise,
                       a.half_width + t * (station.half_width - a.half_width),
                       a.radius + t * (station.radius - a.radius)};
      };
      // The bristle may end within this part of the spine.
      const double whole =
          j > 0 ? (place.end - stations[j - 1].along) / (station.along - stations[j - 1].along) : 1.0;
      if (touches) {
        if (from > 1) {
          first = j > 0 ? between((before - reach) / (before - height)) : station;
          from = first.along;
        }
        final = whole < 1 ? between(whole) : station;
        lowest = std::min(lowest, height);
      } else if (j > 0 && before < reach) {
        final = between(std::min(whole, (reach - before) / (height - before)));
      }
      before = height;
    }
    if (from > place.end) continue;
    const auto on_paper = [&](const Station& s) {
      return pose_.at + ahead * (s.x + s.lean * s.radius * up) + left * (s.half_width * side);
    };
    const PaperPoint root_side = on_paper(first), tip_side = on_paper(final);
    contact.middle = (root_side + tip_side) * 0.5;
    contact.half = (tip_side - root_side) * 0.5;
    contact.reach_m = std::sqrt(geometry::dot(contact.half, contact.half));
    contact.pressure = std::clamp(1 - lowest / reach, 0.0, 1.0) * pressed;
    contact.band_m = std::max(kThinnest_m, covers * (first.half_width + final.half_width));
    for (const Station* end : {&first, &final}) {
      const double y = end->half_width * side;
      const double x = end->x + end->lean * end->radius * up;
      const double half_band = contact.band_m / 2;
      if (touching_ == 0 && end == &first) {
        left_most = y + half_band;
        right_most = y - half_band;
        front = back = x;
      }
      left_most = std::max(left_most, y + half_band);
      right_most = std::min(right_most, y - half_band);
      front = std::max(front, x);
      back = std::min(back, x);
    }
    ++touching_;
  }
  width_m_ = left_most - right_most;
  patch_m_ = front - back;
  reach_m_ = (front + back) / 2;
}

void Tuft::sweep(double seconds, std::vector<BristleSegment>& swept) const {
  const double per_s = seconds > 0 ? 1 / seconds : 0.0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Contact& now = now_[i];
    const Contact& before = before_[i];
    if (now.pressure < 0) continue;
    const PaperPoint way = before.pressure >= 0 ? now.middle - before.middle : PaperPoint{};
    const double far2 = geometry::dot(way, way);
    const double length = 2 * now.reach_m;
    if (far2 < kRests_m * kRests_m) {
      swept.push_back({now.middle, now.middle, now.pressure, now.band_m, length, std::sqrt(far2) * per_s,
                       wetness_, pigment_});
      continue;
    }
    const double reach = 0.5 * (now.reach_m + before.reach_m);
    const double far = std::sqrt(far2);
    const PaperPoint half = (now.half + before.half) * 0.5;
    const double along = reach > 1e-9 ? std::clamp(geometry::dot(way, half) / (far * reach), -1.0, 1.0) : 0.0;
    // The end that goes ahead comes first to new paper.
    const PaperPoint from = before.middle + before.half * along, to = now.middle + now.half * along;
    const double speed = std::sqrt(geometry::dot(to - from, to - from)) * per_s;
    // Hair that is dragged aside sweeps with its whole length, as several bristles side by side.
    const double aside = std::sqrt(1 - along * along);
    const double breadth = 2 * reach * aside;
    if (breadth <= kWidestPart * now.band_m) {
      swept.push_back(
          {from, to, now.pressure, std::max(now.band_m, breadth), length, speed, wetness_, pigment_});
      continue;
    }
    const int parts = std::min(kMostParts, 1 + static_cast<int>(breadth / (kWidestPart * now.band_m)));
    for (int part = 0; part < parts; ++part) {
      const double t = aside * ((2 * part + 1.0) / parts - 1);
      swept.push_back({from + before.half * t, to + now.half * t, now.pressure,
                       std::max(now.band_m, breadth / parts), length / parts, speed, wetness_, pigment_});
    }
  }
}

void Tuft::move_to(const HolderPose& pose, std::vector<BristleSegment>& swept) {
  if (!usable(pose)) return;
  HolderPose to = pose;
  to.depth_m = std::min(to.depth_m, kMostDepth * form_.hair_m);
  to.lean_rad = std::clamp(to.lean_rad, 0.0, kMostLean_rad);
  if (!placed_) {
    // Comes down from above the paper where it is.
    pose_ = to;
    pose_.depth_m = std::min(to.depth_m, -0.05 * form_.hair_m);
    if (to.lean_rad > kLeans_rad) azimuth_ = to.lean_to_rad + kPi;
    spine_.place(spine_pose(pose_));
    placed_ = true;
  }
  const HolderPose from = pose_;
  const double hair = form_.hair_m;
  const double turn = turn_between(from.lean_to_rad, to.lean_to_rad);
  const double twist = turn_between(from.twist_rad, to.twist_rad);
  const bool touches = touching_ > 0 || to.depth_m > 0;
  const double needed =
      touches ? std::max({geometry::distance(from.at, to.at) / (hair * Spine::kStep),
                          std::abs(to.depth_m - std::max(from.depth_m, -0.02 * hair)) / (hair * Spine::kStep),
                          std::abs(to.lean_rad - from.lean_rad) / Spine::kTurn_rad,
                          std::abs(turn) * std::sin(to.lean_rad) / Spine::kTurn_rad,
                          std::abs(twist) / Spine::kTurn_rad})
              : 1.0;
  const int steps = static_cast<int>(std::clamp(std::ceil(needed), 1.0, static_cast<double>(kMostSteps)));
  const double seconds = std::max(0.0, to.time_s - from.time_s) / steps;
  int unswept = 0;
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    HolderPose next;
    next.time_s = from.time_s + t * (to.time_s - from.time_s);
    next.at = from.at + (to.at - from.at) * t;
    next.depth_m = from.depth_m + t * (to.depth_m - from.depth_m);
    next.lean_rad = from.lean_rad + t * (to.lean_rad - from.lean_rad);
    next.lean_to_rad = from.lean_to_rad + t * turn;
    next.twist_rad = from.twist_rad + t * twist;
    step_to(next);
    ++unswept;
    if (unswept < kStepsPerSweep && i < steps) continue;
    std::swap(before_, now_);
    touch(now_);
    sweep(seconds * unswept, swept);
    unswept = 0;
  }
}

std::vector<TuftSection> Tuft::sections() const {
  std::vector<TuftSection> made;
  const auto nodes = spine_.nodes();
  const double hair = form_.hair_m;
  const PaperPoint ahead = direction(azimuth_), left{-ahead.y, ahead.x};
  // A holder that leans across the plane of the bend takes the upper part of the tuft with it.
  const double across = std::tan(pose_.lean_rad) * std::sin(pose_.lean_to_rad - azimuth_);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const std::size_t a = k > 0 ? k - 1 : 0, b = k > 0 ? k : 1;
    TuftSection section;
    section.at = pose_.at + ahead * (hair * nodes[k].x) + left * (hair * nodes[k].z * across);
    section.z_m = hair * nodes[k].z;
    section.rise_rad = std::atan2(nodes[a].z - nodes[b].z, nodes[b].x - nodes[a].x);
    const double radius = radius_m(spine_.along()[k]);
    section.half_width_m = radius * spread();
    section.thickness_m = 2 * radius / spread();
    made.push_back(section);
  }
  return made;
}

}  // namespace nazori::brush
