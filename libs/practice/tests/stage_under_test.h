// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "database_under_test.h"
#include "nazori/base/clock.h"
#include "nazori/geometry/frames.h"
#include "nazori/geometry/polyline.h"
#include "nazori/practice/practice_stage.h"

namespace nazori::practice {

/// A hand on the tablet, sample by sample as a servo would see it, on a clock of its own.
class TestHand {
 public:
  explicit TestHand(TabletControl& tablet) : tablet_(tablet) {}

  /// Writes along a line and lifts the pen at its end.
  void write(const std::vector<geometry::TabletPoint>& line) {
    hover(line.front());
    const double length_m = geometry::arc_length<geometry::TabletFrame>(line);
    const int steps = std::max(2, static_cast<int>(std::ceil(length_m / 0.0008)));
    for (int i = 0; i <= steps; ++i)
      sample(geometry::point_at<geometry::TabletFrame>(line, length_m * i / steps), true);
    for (int i = 0; i < 12; ++i) sample(line.back(), true);  // a stop
    hover(line.back());
  }
  /// Touches the tablet over a distance too short for a stroke.
  void hover(geometry::TabletPoint at) { sample(at, false); }
  void sample(geometry::TabletPoint at, bool touching, std::uint16_t events = 0) {
    haptics::ServoSample sample;
    sample.time_s = time_s_ += 0.008;
    sample.touching = touching;
    sample.events = events;
    sample.proxy_m = {at.x, at.y, touching ? -0.005 : 0.01};
    sample.device_m = {at.x, at.y, touching ? -0.011 : 0.01};
    tablet_.follow(std::span(&sample, 1));
  }

 private:
  TabletControl& tablet_;
  double time_s_ = 0;
};

/// The tablet without a device, the subject of a stage, and what the stage reports.
class StageTest : public testing::Test {
 protected:
  /// 三: three level strokes from left to right, the topmost first, as the learner's own tablet has them.
  static StageSubject three() {
    std::vector<kanji::StrokeLine> lines(3);
    for (int i = 0; i < 3; ++i)
      lines[static_cast<std::size_t>(i)].points = {{20, 24.5 + 30 * i}, {89, 24.5 + 30 * i}};
    lines[2].ending = kanji::StrokeEnding::taper;
    return {nullptr, *tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 128)};
  }
  /// A character of the database, with its tablet.
  static StageSubject character(char32_t code_point) {
    auto sheet = std::make_shared<CharacterSheet>();
    sheet->character = *kanji::KanjiDatabase::open(test::database())->find(code_point);
    return {sheet, *tablet::CarvedTablet::from_lines(tablet::tablet_lines(sheet->character.lines()), 128)};
  }
  /// The centre line of a stroke of the subject, from 1.
  static std::vector<geometry::TabletPoint> line(const StageSubject& subject, int stroke) {
    std::vector<geometry::TabletPoint> points;
    for (const auto& p : subject.tablet->paths()[static_cast<std::size_t>(stroke - 1)].points)
      points.push_back({p.x, p.y});
    return points;
  }
  static std::vector<geometry::TabletPoint> reversed(std::vector<geometry::TabletPoint> points) {
    std::reverse(points.begin(), points.end());
    return points;
  }
  void listen(PracticeStage& stage) {
    stage.feedback.connect([this](const StageFeedback& what) { reports_.push_back(what); });
    stage.finished.connect([this](const study::WritingResult& result) { results_.push_back(result); });
  }
  /// What was reported since the last call.
  [[nodiscard]] std::vector<StageEvent> events() {
    std::vector<StageEvent> all;
    for (const auto& report : std::exchange(reports_, {})) all.push_back(report.event);
    return all;
  }
  [[nodiscard]] const StageFeedback& last() const { return reports_.back(); }

  base::Inbox inbox_;
  base::ManualClock clock_{base::Clock::Calendar{std::chrono::hours(400'000)}};
  TabletControl tablet_{inbox_, clock_, {}};
  TestHand hand_{tablet_};
  std::vector<StageFeedback> reports_;
  std::vector<study::WritingResult> results_;
};

}  // namespace nazori::practice
