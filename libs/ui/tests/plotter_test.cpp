// SPDX-License-Identifier: Apache-2.0
#include "functions/plotter.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "functions/plot_export.h"
#include "nazori/geometry/polyline.h"

namespace nazori::ui {
namespace {

class Plots : public testing::Test {
 protected:
  Plots() {
    QObject::connect(&plotter_, &Plotter::drawn, &plotter_,
                     [this](const SharedDrawing& drawing) { drawn_.push_back(drawing); });
    QObject::connect(&plotter_, &Plotter::progressed, &plotter_,
                     [this](double done) { progress_.push_back(done); });
  }
  static PlotRequest request(const std::string& expression, const functions::Window& window, int size = 128) {
    PlotRequest made;
    made.plot = *functions::parse(expression);
    made.window = window;
    made.plate.size = size;
    return made;
  }
  SharedDrawing last(const PlotRequest& wanted) {
    drawn_.clear();
    plotter_.draw(wanted);
    EXPECT_TRUE(plotter_.is_busy());
    EXPECT_TRUE(QTest::qWaitFor([&] { return !plotter_.is_busy(); }, 60'000));
    EXPECT_FALSE(drawn_.empty());
    return drawn_.empty() ? SharedDrawing() : drawn_.back();
  }
  std::vector<SharedDrawing> drawn_;
  std::vector<double> progress_;
  Plotter plotter_;
};

TEST_F(Plots, OnlyTheLastPictureIsTheFinalOneWithItsPoints) {
  QSignalSpy rested(&plotter_, &Plotter::rested);
  QSignalSpy failed(&plotter_, &Plotter::failed);
  const auto drawing = last(request("y = x^2 - 1", {-3, 3, -3, 3}));
  ASSERT_TRUE(drawing);
  EXPECT_TRUE(drawing->final);
  EXPECT_FALSE(drawing->points.empty());
  EXPECT_EQ(drawing->summary.find("y equals x squared minus 1"), 0U) << drawing->summary;
  for (const auto& one : drawn_) {
    if (one == drawing) continue;
    EXPECT_FALSE(one->final);
    EXPECT_TRUE(one->points.empty());
  }
  EXPECT_EQ(rested.count(), 1);
  EXPECT_EQ(failed.count(), 0);
  plotter_.stop();
  EXPECT_EQ(rested.count(), 1) << "there was nothing to stop";
}

TEST_F(Plots, OfManyPiecesTheLongest300AreKept) {
  const auto drawing = last(request("y = floor(60x)/60; y = 3.5", {-3, 3, -4, 4}));
  ASSERT_TRUE(drawing);
  ASSERT_GT(drawing->picture.tracing.branches.size(), 310U);
  EXPECT_EQ(drawing->tablet->lines().size(), 300U);
  ASSERT_EQ(drawing->statements.size(), 300U);
  EXPECT_EQ(drawing->statements.front(), 1) << "the longest is the level line";
  EXPECT_EQ(std::count(drawing->statements.begin(), drawing->statements.end(), 1), 1);
  const auto few = last(request("y = tan(2x); y = 2", {-6, 6, -4, 4}));
  ASSERT_TRUE(few);
  EXPECT_EQ(few->statements.front(), 0) << "in their order where there are few";
  EXPECT_EQ(few->statements.back(), 1);
}

TEST_F(Plots, OfOneCurveAloneOnlyItsOwnPointsAreKept) {
  auto wanted = request("y = x; y = 2 - x", {-3, 3, -3, 3});
  const auto all = last(wanted);
  ASSERT_TRUE(all);
  const auto crossings = [](const SharedDrawing& drawing) {
    return std::count_if(drawing->points.begin(), drawing->points.end(),
                         [](const auto& point) { return point.kind == functions::PointKind::crossing; });
  };
  EXPECT_EQ(crossings(all), 1);
  wanted.plate.alone = 1;
  const auto alone = last(wanted);
  ASSERT_TRUE(alone);
  ASSERT_FALSE(alone->points.empty());
  EXPECT_EQ(crossings(alone), 0) << "the other curve is not there";
  for (const auto& point : alone->points) EXPECT_EQ(point.statement, 1);
  EXPECT_EQ(alone->summary.find("y equals 2 minus x"), 0U) << alone->summary;
  wanted.plate.alone = 0;
  const auto first = last(wanted);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->summary.find("y equals x"), 0U) << first->summary;
}

TEST_F(Plots, WhatASurfaceLeavesUndefinedFeelsRougher) {
  const auto drawing = last(request("z = sqrt(x)", {-1, 1, -1, 1}));
  ASSERT_TRUE(drawing);
  const auto& zones = drawing->tablet->friction();
  ASSERT_TRUE(zones);
  ASSERT_EQ(zones->added.size(), 1U);
  EXPECT_GT(zones->added[0], 0.1);
  const auto n = static_cast<std::size_t>(zones->size);
  for (std::size_t row = 0; row < n; ++row) {
    EXPECT_EQ(static_cast<int>(zones->zone[row * n]), 1) << row;
    EXPECT_EQ(static_cast<int>(zones->zone[row * n + n / 4]), 1) << row;
    EXPECT_EQ(static_cast<int>(zones->zone[row * n + 3 * n / 4]), 0) << row;
    EXPECT_EQ(static_cast<int>(zones->zone[row * n + n - 1]), 0) << row;
  }
}

TEST_F(Plots, AStoppedDrawingIsNeitherShownNorAFailure) {
  QSignalSpy rested(&plotter_, &Plotter::rested);
  QSignalSpy failed(&plotter_, &Plotter::failed);
  plotter_.draw(request("e^(sin x + cos y) = sin(e^(x + y))", {-6, 6, -4, 4}, 512));
  plotter_.stop();
  EXPECT_FALSE(plotter_.is_busy());
  EXPECT_EQ(rested.count(), 1);
  drawn_.clear();
  // The next one comes only after the thread has let the first one go.
  const auto next = last(request("y = 1", {-6, 6, -4, 4}));
  ASSERT_TRUE(next);
  for (const auto& one : drawn_) EXPECT_EQ(functions::canonical(one->asked.plot), "y = 1");
  EXPECT_EQ(failed.count(), 0);
  EXPECT_EQ(rested.count(), 2);
}

TEST_F(Plots, WhatCannotBeDrawnIsAFailureAndThenThereIsRest) {
  QSignalSpy failed(&plotter_, &Plotter::failed);
  auto wanted = request("y = x", {3, -3, -1, 1});
  plotter_.draw(wanted);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !plotter_.is_busy(); }, 60'000));
  EXPECT_EQ(failed.count(), 1);
  EXPECT_TRUE(drawn_.empty());
}

TEST_F(Plots, ProgressBeginsAtNothingAndGoesForwards) {
  // How often it is told depends on the time; the beginning is told always.
  last(request("e^(sin x + cos y) = sin(e^(x + y))", {-2, 2, -2, 2}, 256));
  ASSERT_FALSE(progress_.empty());
  EXPECT_EQ(progress_.front(), 0);
  EXPECT_TRUE(std::is_sorted(progress_.begin(), progress_.end()));
  EXPECT_LE(progress_.back(), 1);
}

TEST_F(Plots, TheSweepThatIsWantedLastIsTheOneThatIsHeard) {
  const auto drawing = last(request("y = x", {-1, 1, -1, 1}));
  ASSERT_TRUE(drawing);
  PlotExport exporter;
  std::vector<std::size_t> heard;
  QObject::connect(&exporter, &PlotExport::composed, &exporter,
                   [&](const functions::Sound& sound) { heard.push_back(sound.samples.size()); });
  functions::SoundSettings slow;
  slow.seconds = 4;
  functions::SoundSettings fast;
  fast.seconds = 1;
  exporter.compose(drawing, slow);
  exporter.compose(drawing, fast);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !heard.empty(); }, 30'000));
  ASSERT_EQ(heard.size(), 1U);
  const auto expected =
      functions::sweep(drawing->asked.plot, drawing->picture.tracing, drawing->points, fast);
  ASSERT_TRUE(expected);
  EXPECT_EQ(heard[0], expected->samples.size());
  // What is forgotten is not heard; the next one shows that the thread came past it.
  exporter.compose(drawing, slow);
  exporter.forget_sound();
  exporter.compose(drawing, fast);
  ASSERT_TRUE(QTest::qWaitFor([&] { return heard.size() > 1; }, 30'000));
  EXPECT_EQ(heard.size(), 2U);
  EXPECT_EQ(heard[1], expected->samples.size());
}

}  // namespace
}  // namespace nazori::ui
