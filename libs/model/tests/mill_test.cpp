// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/mill.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>

namespace nazori::model {
namespace {

using testing::HasSubstr;

constexpr double kThickness_mm = 6;

/// A plate whose depth is a function of the place.
Plate plate_of(double width, double height, double step, const std::function<double(double, double)>& depth) {
  const double side = std::max(width, height);
  Plate plate = Plate::create(width, height, step, kThickness_mm).value();
  const int size = static_cast<int>(std::lround(side / step)) + 1;
  auto map = surface::HeightMap::create(size, 1.0F).value();
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      map.set(column, row, static_cast<float>(1 - depth(column * step, side - row * step) / 5));
  plate.sink(map, {0, 0}, side, 5);
  return plate;
}

/// What a machine does with a program: an independent reading of the words.
struct Machine {
  struct Move {
    double x0, y0, z0, x1, y1, z1, feed;
    bool rapid;
  };
  std::vector<Move> moves;
  std::vector<std::string> codes;

  explicit Machine(const std::string& program) {
    std::istringstream lines(program);
    std::string line;
    std::map<char, double> at{{'X', 0}, {'Y', 0}, {'Z', 100}, {'F', 0}};
    while (std::getline(lines, line)) {
      if (line.starts_with('(')) {
        EXPECT_TRUE(line.ends_with(')'));
        continue;
      }
      std::istringstream words(line);
      std::string word;
      const auto before = at;
      std::string code;
      bool has_place = false;
      while (words >> word) {
        if (word[0] == 'G' || word[0] == 'M') {
          code = word;
        } else {
          at[word[0]] = std::stod(word.substr(1));
          has_place = has_place || std::string("XYZ").find(word[0]) != std::string::npos;
        }
      }
      codes.push_back(code);
      if (!has_place) continue;
      EXPECT_TRUE(code == "G0" || code == "G1") << line;
      moves.push_back({before.at('X'), before.at('Y'), before.at('Z'), at.at('X'), at.at('Y'), at.at('Z'),
                       at.at('F'), code == "G0"});
    }
  }
};

/// Material that a ball is swept through.
class Block {
 public:
  Block(const Plate& like, double radius)
      : columns_(like.columns()),
        rows_(like.rows()),
        step_(like.step_mm()),
        radius_(radius),
        heights_(static_cast<std::size_t>(columns_ * rows_), 0.0) {}

  /// @return the deepest that the ball was in material [mm].
  double run(const Machine::Move& m) {
    const double length = std::hypot(m.x1 - m.x0, m.y1 - m.y0, m.z1 - m.z0);
    const int steps = static_cast<int>(length / 0.04) + 1;
    double engaged = 0;
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      engaged = std::max(engaged,
                         put(m.x0 + t * (m.x1 - m.x0), m.y0 + t * (m.y1 - m.y0), m.z0 + t * (m.z1 - m.z0)));
    }
    return engaged;
  }
  [[nodiscard]] double at(int column, int row) const {
    return heights_[static_cast<std::size_t>(row * columns_ + column)];
  }

 private:
  double put(double x, double y, double tip) {
    double engaged = 0;
    if (tip >= 0) return engaged;
    const auto low = [&](double v) {
      return std::max(0, static_cast<int>(std::ceil((v - radius_) / step_)));
    };
    const auto high = [&](double v, int count) {
      return std::min(count - 1, static_cast<int>(std::floor((v + radius_) / step_)));
    };
    for (int row = low(y); row <= high(y, rows_); ++row) {
      for (int column = low(x); column <= high(x, columns_); ++column) {
        const double d2 = std::pow(column * step_ - x, 2) + std::pow(row * step_ - y, 2);
        if (d2 > radius_ * radius_) continue;
        double& height = heights_[static_cast<std::size_t>(row * columns_ + column)];
        const double ball = tip + radius_ - std::sqrt(radius_ * radius_ - d2);
        engaged = std::max(engaged, height - ball);
        height = std::min(height, ball);
      }
    }
    return engaged;
  }

  int columns_, rows_;
  double step_, radius_;
  std::vector<double> heights_;
};

struct Cut {
  Block block;
  double rapid_engagement = 0;
  double deepest_engagement = 0;
};

Cut cut(const Plate& plate, const std::string& program, double radius) {
  Cut made{Block(plate, radius)};
  for (const Machine::Move& move : Machine(program).moves) {
    const double engaged = made.block.run(move);
    if (move.rapid) made.rapid_engagement = std::max(made.rapid_engagement, engaged);
    made.deepest_engagement = std::max(made.deepest_engagement, engaged);
  }
  return made;
}

/// A groove from left to right whose floor is a cylinder of this radius, its ends pieces of a ball.
double trough(double x, double y, double radius, double depth, double from, double to, double middle) {
  const double d = std::hypot(y - middle, x - std::clamp(x, from, to));
  const double floor = radius * radius - d * d;
  return floor <= 0 ? 0 : std::max(0.0, std::sqrt(floor) - (radius - depth));
}

TEST(Mill, ARoundGrooveWiderThanTheBallComesOutAsItIs) {
  const Plate plate =
      plate_of(40, 20, 0.1, [](double x, double y) { return trough(x, y, 4, 2.5, 10, 30, 10); });
  const MillGuide guide{{{10, 10}, {30, 10}}, 3.8};
  MillSettings settings;
  settings.cutter_mm = 3;
  const auto path = mill_path(plate, {&guide, 1}, settings);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->passes, 2);
  EXPECT_NEAR(path->deepest_mm, 2.5, 0.02);
  const Cut made = cut(plate, to_gcode(*path, settings, "trough"), 1.5);
  double gouge = 0;
  double left_in_middle = 0;
  double left = 0;
  for (int row = 0; row < plate.rows(); ++row) {
    for (int column = 0; column < plate.columns(); ++column) {
      const double more =
          made.block.at(column, row) - (static_cast<double>(plate.at(column, row)) - kThickness_mm);
      gouge = std::max(gouge, -more);
      // The wall meets the face at about 68 degrees: there a little beside is much below.
      left = std::max(left, more);
      if (std::abs(row * 0.1 - 10) < 2.5 && column > 80 && column < 320)
        left_in_middle = std::max(left_in_middle, more);
    }
  }
  EXPECT_LE(gouge, 0.002);
  EXPECT_LE(left_in_middle, 0.03);
  EXPECT_LE(left, 0.08);
  EXPECT_EQ(made.rapid_engagement, 0);
}

TEST(Mill, ABallGoesAsDeepAsItFitsIntoANarrowGroove) {
  // A ball of radius r rests on the walls of a groove with a right angle r (sqrt(2) - 1) above its bottom,
  // and on the rims of a slot of width w at the depth r - sqrt(r^2 - w^2/4).
  const auto v = [](double, double y) { return std::max(0.0, 3 - std::abs(y - 10)); };
  const auto slot = [](double, double y) { return std::abs(y - 10) <= 1 + 1e-9 ? 3.0 : 0.0; };
  const MillGuide guide{{{5, 10}, {15, 10}}, 3};
  MillSettings settings;
  settings.cutter_mm = 4;
  const auto v_path = mill_path(plate_of(20, 20, 0.1, v), {&guide, 1}, settings);
  ASSERT_TRUE(v_path);
  EXPECT_NEAR(v_path->deepest_mm, 3 - 2 * (std::sqrt(2) - 1), 0.02);
  const auto slot_path = mill_path(plate_of(20, 20, 0.1, slot), {&guide, 1}, settings);
  ASSERT_TRUE(slot_path);
  // The wall of the slot lies between two samples.
  EXPECT_NEAR(slot_path->deepest_mm, 2 - std::sqrt(4 - 1.05 * 1.05), 0.04);
}

TEST(Mill, CrossingAndThinningGroovesAreCutToWhatTheBallReaches) {
  constexpr double kRadius = 1;
  const auto depth = [](double x, double y) {
    const double across = trough(x, y, 3, 2, 6, 24, 15);
    // A stroke that thins out to a point.
    const double t = std::clamp((y - 4) / 22, 0.0, 1.0);
    const double along = trough(y, x, 3, 2 * (1 - 0.9 * t), 4, 26, 15);
    return std::max(across, along);
  };
  const Plate plate = plate_of(30, 30, 0.15, depth);
  const std::vector<MillGuide> guides{{{{6, 15}, {24, 15}}, 3}, {{{15, 4}, {15, 26}}, 3}};
  MillSettings settings;
  settings.cutter_mm = 2 * kRadius;
  settings.pass_depth_mm = 0.8;
  const auto path = mill_path(plate, guides, settings);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->passes, 3);
  const Cut made = cut(plate, to_gcode(*path, settings, "cross"), kRadius);
  // What a ball can reach: the lowest that it stands at any place, computed for each sample.
  const int n = plate.columns();
  const int reach = static_cast<int>(kRadius / 0.15);
  const auto cap = [&](int dx, int dy) { return kRadius * kRadius - 0.0225 * (dx * dx + dy * dy); };
  std::vector<double> tip(static_cast<std::size_t>(n * n), 0);
  std::vector<double> best(tip);
  const auto for_ball = [&](int x, int y, const std::function<void(int, int, double)>& use) {
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx)
        if (cap(dx, dy) >= 0 && x + dx >= 0 && y + dy >= 0 && x + dx < n && y + dy < n)
          use(x + dx, y + dy, std::sqrt(cap(dx, dy)));
  };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      double highest = -100;
      for_ball(x, y, [&](int px, int py, double ball) {
        highest = std::max(highest, static_cast<double>(plate.at(px, py)) - kThickness_mm + ball - kRadius);
      });
      tip[static_cast<std::size_t>(y * n + x)] = highest;
    }
  double gouge = 0;
  double most = 0;
  double sum = 0;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      double reachable = 0;
      for_ball(x, y, [&](int px, int py, double ball) {
        reachable = std::min(reachable, tip[static_cast<std::size_t>(py * n + px)] + kRadius - ball);
      });
      gouge = std::max(gouge, static_cast<double>(plate.at(x, y)) - kThickness_mm - made.block.at(x, y));
      most = std::max(most, std::abs(made.block.at(x, y) - reachable));
      sum += std::abs(made.block.at(x, y) - reachable);
    }
  EXPECT_LE(gouge, 0.002);
  EXPECT_LE(most, 0.1);
  EXPECT_LE(sum / (n * n), 0.01);
  EXPECT_EQ(made.rapid_engagement, 0);
  // A pass takes off its depth and what the coarser lines of the pass before it left between them.
  EXPECT_LE(made.deepest_engagement, 0.8 + 0.25);
}

TEST(Mill, WithoutMiddleLinesTheWholePlateIsCutLineByLine) {
  const Plate plate = plate_of(20, 12, 0.2, [](double x, double y) { return trough(x, y, 3, 1, 6, 14, 6); });
  MillSettings settings;
  settings.cutter_mm = 2;
  const auto path = mill_path(plate, {}, settings);
  ASSERT_TRUE(path);
  const Cut made = cut(plate, to_gcode(*path, settings, "relief"), 1);
  for (int column = 30; column <= 70; ++column) EXPECT_NEAR(made.block.at(column, 30), -1, 0.03);
  EXPECT_EQ(made.rapid_engagement, 0);
}

TEST(Mill, TheProgramSaysItsUnitsSpeedsAndEnd) {
  const Plate plate = plate_of(20, 12, 0.2, [](double x, double y) { return trough(x, y, 3, 1, 6, 14, 6); });
  const MillGuide guide{{{6, 6}, {14, 6}}, 2.5};
  MillSettings settings;
  settings.cutter_mm = 2;
  settings.safe_mm = 7;
  settings.feed_mm_min = 450;
  settings.plunge_mm_min = 120;
  settings.spindle_rpm = 9000;
  const auto path = mill_path(plate, {&guide, 1}, settings);
  ASSERT_TRUE(path);
  const std::string program = to_gcode(*path, settings, "休 (a;b%) U+4F11");
  EXPECT_THAT(program, HasSubstr("(Nazori  ab U+4F11)"));
  EXPECT_TRUE(std::all_of(program.begin(), program.end(),
                          [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
  EXPECT_THAT(program, HasSubstr("\nM3 S9000\n"));
  const Machine machine(program);
  EXPECT_EQ(machine.codes[0], "G21");
  EXPECT_EQ(machine.codes[1], "G90");
  EXPECT_TRUE(program.ends_with("G0 Z7.000\nM5\nG0 X0 Y0\nM30\n"));
  double length = 0;
  double minutes = 0;
  for (const Machine::Move& m : machine.moves) {
    const double d = std::hypot(m.x1 - m.x0, m.y1 - m.y0, m.z1 - m.z0);
    if (m.rapid) {
      // Up or down on the spot, or sideways at the safe height.
      EXPECT_TRUE((m.x0 == m.x1 && m.y0 == m.y1) || (m.z0 >= 7 && m.z1 >= 7));
      EXPECT_GE(m.z1, 7);
      continue;
    }
    EXPECT_EQ(m.feed, m.z0 >= 7 ? 120 : 450);
    length += d;
    minutes += d / m.feed;
  }
  EXPECT_NEAR(length, path->cut_length_mm, 0.01 * length);
  EXPECT_NEAR(minutes, path->minutes, 0.01 * minutes);
}

TEST(Mill, WhatCannotBeCutIsRefused) {
  const Plate flat = Plate::create(20, 20, 0.2, kThickness_mm).value();
  const MillGuide guide{{{6, 6}, {14, 6}}, 2.5};
  EXPECT_FALSE(mill_path(flat, {&guide, 1}));
  const auto refused = [&](const std::function<void(MillSettings&)>& change) {
    MillSettings settings;
    change(settings);
    const auto path = mill_path(
        plate_of(20, 20, 0.2, [](double, double y) { return y > 8 && y < 12 ? 1.0 : 0; }), {}, settings);
    return !path && path.error().code == base::Errc::bad_argument;
  };
  EXPECT_FALSE(refused([](MillSettings&) {}));
  EXPECT_TRUE(refused([](MillSettings& s) { s.cutter_mm = 0.1; }));
  EXPECT_TRUE(refused([](MillSettings& s) { s.cutter_mm = std::nan(""); }));
  EXPECT_TRUE(refused([](MillSettings& s) { s.step_over_mm = 0; }));
  EXPECT_TRUE(refused([](MillSettings& s) { s.pass_depth_mm = 0; }));
  EXPECT_TRUE(refused([](MillSettings& s) { s.safe_mm = 0; }));
  EXPECT_TRUE(refused([](MillSettings& s) { s.feed_mm_min = 0; }));
  EXPECT_TRUE(refused([](MillSettings& s) { s.plunge_mm_min = 0; }));
  EXPECT_TRUE(refused([](MillSettings& s) { s.spindle_rpm = -1; }));
}

}  // namespace
}  // namespace nazori::model
