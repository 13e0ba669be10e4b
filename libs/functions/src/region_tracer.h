// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/functions/tape.h"
#include "nazori/functions/tracing.h"
#include "work_progress.h"

namespace nazori::functions {

/// A conjunction of conditions on x and y: each expression positive, or not negative where `strict` is false.
struct Condition {
  Expression expression;
  bool strict = false;
};

/// Covers where all conditions hold with rectangles: whole boxes where that is certain, down to boxes of half
/// a cell, whose centres decide. `guard` must also be defined, if given.
class RegionTracer {
 public:
  RegionTracer(const std::vector<Condition>& conditions, const Expression& guard, int statement,
               const TraceSettings& settings, Tracing& out, WorkProgress& progress);
  /// @return false when it was stopped.
  bool run();
  /// Whether the conditions hold at a point of the plate.
  [[nodiscard]] bool holds(PlatePoint p);

 private:
  struct Test {
    Tape tape;
    bool strict = false;
    bool only_defined = false;
  };
  enum class Answer : std::uint8_t { no, maybe, yes };
  [[nodiscard]] Answer ask(const Test& test, double u, double v, double side);
  void visit(double u, double v, double side, int level);

  std::vector<Test> tests_;
  int statement_;
  Tracing& out_;
  WorkProgress& progress_;
  int finest_level_ = 0;
  std::vector<double> values_;
  std::vector<Interval> intervals_;
  double done_ = 0;
};

}  // namespace nazori::functions
