// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "nazori/geometry/frames.h"
#include "nazori/geometry/point.h"
#include "nazori/practice/tablet_control.h"

namespace nazori::practice {

/// What the pen of the keyboard moves over: a square with strokes on it. Places are in metres from its
/// middle, y up. Thread: that of its owner.
class KeyPenGround {
 public:
  using Line = geometry::Polyline<geometry::TabletFrame>;

  KeyPenGround() = default;
  KeyPenGround(const KeyPenGround&) = delete;
  KeyPenGround& operator=(const KeyPenGround&) = delete;
  virtual ~KeyPenGround() = default;

  [[nodiscard]] virtual double side_m() const = 0;
  /// How many strokes may be named; none where nothing may be told.
  [[nodiscard]] virtual int stroke_count() const = 0;
  /// The stroke that is shown alone, from 1; 0: all are shown.
  [[nodiscard]] virtual int only_stroke() const = 0;
  /// The centre line of a stroke, in writing direction. @param number  1..stroke_count().
  [[nodiscard]] virtual Line line(int number) const = 0;
  /// Of the relief: 0 on the plateau, 1 at the bottom of the deepest groove.
  [[nodiscard]] virtual double depth(geometry::TabletPoint at) const = 0;

  virtual void move_pen(geometry::TabletPoint at, bool is_down) = 0;
  /// The pen is no longer shown; it was lifted before.
  virtual void take_pen_away() = 0;
};

/// The tablet.
class TabletGround final : public KeyPenGround {
 public:
  /// @param tablet  outlives this.
  explicit TabletGround(TabletControl& tablet) : tablet_(tablet) {}

  [[nodiscard]] double side_m() const override;
  [[nodiscard]] int stroke_count() const override { return tablet_.stroke_count(); }
  [[nodiscard]] int only_stroke() const override { return tablet_.current_stroke(); }
  [[nodiscard]] Line line(int number) const override;
  [[nodiscard]] double depth(geometry::TabletPoint at) const override;
  void move_pen(geometry::TabletPoint at, bool is_down) override;
  void take_pen_away() override { tablet_.lift_stylus(); }

 private:
  [[nodiscard]] geometry::TabletShape shape() const;
  TabletControl& tablet_;
};

/// A sheet of paper, on which keys also say how hard the brush presses.
class SheetGround final : public KeyPenGround {
 public:
  /// Where the brush is, and how hard it presses: 0..1, only while it is down.
  using Write = std::function<void(geometry::TabletPoint at, bool is_down, double pressure)>;
  static constexpr double kPressureStep = 0.1;

  SheetGround(double side_m, Write write, std::function<void()> take_away)
      : side_m_(side_m), write_(std::move(write)), take_away_(std::move(take_away)) {}

  /// The strokes of the models that are shown.
  void set_strokes(std::vector<Line> strokes) { strokes_ = std::move(strokes); }
  [[nodiscard]] double pressure() const { return pressure_; }
  /// Presses harder or softer, at once where the brush is down. @param steps  of kPressureStep. @return
  /// whether it could.
  bool press_harder(int steps);

  [[nodiscard]] double side_m() const override { return side_m_; }
  [[nodiscard]] int stroke_count() const override { return static_cast<int>(strokes_.size()); }
  [[nodiscard]] int only_stroke() const override { return 0; }
  [[nodiscard]] Line line(int number) const override {
    return strokes_[static_cast<std::size_t>(number - 1)];
  }
  [[nodiscard]] double depth(geometry::TabletPoint /*at*/) const override { return 0; }
  void move_pen(geometry::TabletPoint at, bool is_down) override;
  void take_pen_away() override { take_away_(); }

 private:
  double side_m_;
  Write write_;
  std::function<void()> take_away_;
  std::vector<Line> strokes_;
  double pressure_ = 0.5;
  geometry::TabletPoint at_{0, 0};
  bool is_down_ = false;
};

}  // namespace nazori::practice
