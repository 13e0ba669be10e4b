// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plotter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "nazori/functions/plot_export.h"

namespace nazori::functions {
namespace {

class Plots : public testing::Test {
 protected:
  Plots() {
    plotter_.drawn.connect([this](const SharedDrawing& drawing) { drawn_.push_back(drawing); });
    plotter_.progressed.connect([this](double done) { progress_.push_back(done); });
    plotter_.rested.connect([this] { ++rested_; });
    plotter_.failed.connect([this](const base::Error& error) { failed_.push_back(error); });
  }
  static PlotRequest request(const std::string& expression, const Window& window, int size = 128) {
    PlotRequest made;
    made.plot = *parse(expression);
    made.window = window;
    made.plate.size = size;
    return made;
  }
  void wait_for_rest() {
    inbox_.run_until([this] { return !plotter_.is_busy(); });
  }
  SharedDrawing last(const PlotRequest& wanted) {
    drawn_.clear();
    plotter_.draw(wanted);
    EXPECT_TRUE(plotter_.is_busy());
    wait_for_rest();
    EXPECT_FALSE(drawn_.empty());
    return drawn_.empty() ? SharedDrawing() : drawn_.back();
  }
  std::vector<SharedDrawing> drawn_;
  std::vector<double> progress_;
  int rested_ = 0;
  std::vector<base::Error> failed_;
  base::Inbox inbox_;
  Plotter<SharedDrawing> plotter_{inbox_, [](Drawing&& drawing) -> base::Result<SharedDrawing> {
                                    return std::make_shared<const Drawing>(std::move(drawing));
                                  }};
};

TEST_F(Plots, OnlyTheLastPictureIsTheFinalOneWithItsPoints) {
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
  EXPECT_EQ(rested_, 1);
  EXPECT_EQ(failed_.size(), 0U);
  plotter_.stop();
  EXPECT_EQ(rested_, 1) << "there was nothing to stop";
}

TEST_F(Plots, OfManyPiecesTheLongest300AreKept) {
  const auto drawing = last(request("y = floor(60x)/60; y = 3.5", {-3, 3, -4, 4}));
  ASSERT_TRUE(drawing);
  ASSERT_GT(drawing->picture.tracing.branches.size(), 310U);
  ASSERT_EQ(drawing->grooves.size(), 300U);
  EXPECT_EQ(drawing->grooves.front().statement, 1) << "the longest is the level line";
  EXPECT_EQ(std::count_if(drawing->grooves.begin(), drawing->grooves.end(),
                          [](const TabletCurve& groove) { return groove.statement == 1; }),
            1);
  const auto few = last(request("y = tan(2x); y = 2", {-6, 6, -4, 4}));
  ASSERT_TRUE(few);
  EXPECT_EQ(few->grooves.front().statement, 0) << "in their order where there are few";
  EXPECT_EQ(few->grooves.back().statement, 1);
}

TEST_F(Plots, OfOneCurveAloneOnlyItsOwnPointsAreKept) {
  auto wanted = request("y = x; y = 2 - x", {-3, 3, -3, 3});
  const auto all = last(wanted);
  ASSERT_TRUE(all);
  const auto crossings = [](const SharedDrawing& drawing) {
    return std::count_if(drawing->points.begin(), drawing->points.end(),
                         [](const auto& point) { return point.kind == PointKind::crossing; });
  };
  EXPECT_EQ(crossings(all), 1);
  wanted.plate.alone = 1;
  const auto alone = last(wanted);
  ASSERT_TRUE(alone);
  ASSERT_FALSE(alone->points.empty());
  EXPECT_EQ(crossings(alone), 0) << "the other curve was not found";
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
  const PlateFriction& friction = drawing->friction;
  ASSERT_EQ(friction.added.size(), 1U);
  EXPECT_GT(friction.added[0], 0.1);
  const auto n = static_cast<std::size_t>(drawing->picture.plate.heights.size());
  for (std::size_t row = 0; row < n; ++row) {
    EXPECT_EQ(static_cast<int>(friction.zone[row * n]), 1) << row;
    EXPECT_EQ(static_cast<int>(friction.zone[row * n + n / 4]), 1) << row;
    EXPECT_EQ(static_cast<int>(friction.zone[row * n + 3 * n / 4]), 0) << row;
    EXPECT_EQ(static_cast<int>(friction.zone[row * n + n - 1]), 0) << row;
  }
}

TEST_F(Plots, AStoppedDrawingIsNeitherShownNorAFailure) {
  plotter_.draw(request("e^(sin x + cos y) = sin(e^(x + y))", {-6, 6, -4, 4}, 512));
  plotter_.stop();
  EXPECT_FALSE(plotter_.is_busy());
  EXPECT_EQ(rested_, 1);
  drawn_.clear();
  // The next one comes only after the thread has released the first one.
  const auto next = last(request("y = 1", {-6, 6, -4, 4}));
  ASSERT_TRUE(next);
  for (const auto& one : drawn_) EXPECT_EQ(canonical(one->request.plot), "y = 1");
  EXPECT_EQ(failed_.size(), 0U);
  EXPECT_EQ(rested_, 2);
}

TEST_F(Plots, WhatCannotBeDrawnIsAFailureAndThenThereIsRest) {
  auto wanted = request("y = x", {3, -3, -1, 1});
  plotter_.draw(wanted);
  wait_for_rest();
  EXPECT_EQ(failed_.size(), 1U);
  EXPECT_TRUE(drawn_.empty());
}

TEST_F(Plots, ProgressBeginsAtNothingAndGoesForwards) {
  // The number of reports depends on the time; the beginning is always reported.
  last(request("e^(sin x + cos y) = sin(e^(x + y))", {-2, 2, -2, 2}, 256));
  ASSERT_FALSE(progress_.empty());
  EXPECT_EQ(progress_.front(), 0);
  EXPECT_TRUE(std::is_sorted(progress_.begin(), progress_.end()));
  EXPECT_LE(progress_.back(), 1);
}

TEST_F(Plots, TheSweepThatIsWantedLastIsTheOneThatIsHeard) {
  const auto drawing = last(request("y = x", {-1, 1, -1, 1}));
  ASSERT_TRUE(drawing);
  PlotExport exporter(inbox_);
  std::vector<std::size_t> heard;
  exporter.composed.connect([&](const Sound& sound) { heard.push_back(sound.samples.size()); });
  SoundSettings slow;
  slow.seconds = 4;
  SoundSettings fast;
  fast.seconds = 1;
  exporter.compose(drawing, slow);
  exporter.compose(drawing, fast);
  inbox_.run_until([&] { return !heard.empty(); });
  ASSERT_EQ(heard.size(), 1U);
  const auto expected = sweep(drawing->request.plot, drawing->picture.tracing, drawing->points, fast);
  ASSERT_TRUE(expected);
  EXPECT_EQ(heard[0], expected->samples.size());
  // A cancelled one is not reported; the next one shows that the thread has passed it.
  exporter.compose(drawing, slow);
  exporter.forget_sound();
  exporter.compose(drawing, fast);
  inbox_.run_until([&] { return heard.size() > 1; });
  EXPECT_EQ(heard.size(), 2U);
  EXPECT_EQ(heard[1], expected->samples.size());
}

TEST_F(Plots, AreStoppedByTheNextAndByTheEndOfThePlotter) {
  plotter_.draw(request("y = sin(100 x)", {-10, 10, -10, 10}, 64));
  plotter_.draw(request("y = x", {-10, 10, -10, 10}, 64));
  inbox_.run_until([this] { return !drawn_.empty() && drawn_.back()->final; });
  for (const auto& one : drawn_) EXPECT_EQ(canonical(one->request.plot), "y = x");
  wait_for_rest();
  EXPECT_EQ(rested_, 1);
  plotter_.draw(request("y = sin(x)", {-10, 10, -10, 10}, 64));
  plotter_.stop();
  EXPECT_FALSE(plotter_.is_busy());
  EXPECT_EQ(rested_, 2);
  plotter_.draw(request("y = sin(1/x)", {-10, 10, -10, 10}, 64));  // ended in the middle
}

TEST_F(Plots, WhatCannotBeFinishedIsAFailure) {
  Plotter<int> refusing(inbox_, [](Drawing&&) -> base::Result<int> {
    return base::fail(base::Errc::bad_argument, "no tablet today", "tablet");
  });
  std::vector<std::string> failures;
  bool rested = false;
  refusing.failed.connect([&](const base::Error& error) { failures.push_back(error.what); });
  refusing.rested.connect([&] { rested = true; });
  refusing.draw(request("y = x", {-1, 1, -1, 1}));
  inbox_.run_until([&] { return rested; });
  EXPECT_FALSE(refusing.is_busy());
  EXPECT_EQ(failures, std::vector<std::string>{"no tablet today"});
}

TEST_F(Plots, AreWrittenAsFilesOfEachKindThatTheyHave) {
  const auto drawing = last(request("y = x", {-1, 1, -1, 1}));
  ASSERT_TRUE(drawing);
  PlotExport exporter(inbox_);
  const auto folder = std::filesystem::path(testing::TempDir()) / "nazori_plot_export";
  std::filesystem::create_directories(folder);
  std::vector<std::filesystem::path> expected;
  std::vector<std::filesystem::path> written;
  std::vector<std::filesystem::path> failed;
  exporter.written.connect([&](const std::filesystem::path& path) { written.push_back(path); });
  exporter.failed.connect(
      [&](const std::filesystem::path& path, const base::Error&) { failed.push_back(path); });
  PlotDocument document;
  document.expression = "y = x";
  int number = 0;
  for (const PlotFile kind :
       {PlotFile::document, PlotFile::raw, PlotFile::png, PlotFile::print, PlotFile::sound}) {
    const auto path = folder / (std::to_string(++number) + "." + std::string(extension_of(kind)));
    expected.push_back(path);
    exporter.write(kind, path, drawing, document);
  }
  const auto nowhere = folder / "no such folder" / "plot.png";
  exporter.write(PlotFile::png, nowhere, drawing, document);
  inbox_.run_until([&] { return written.size() + failed.size() == expected.size() + 1; });
  EXPECT_EQ(written, expected);
  for (const auto& path : written) EXPECT_GT(std::filesystem::file_size(path), 0U) << path;
  EXPECT_EQ(failed, std::vector{nowhere});
  const auto again = load_document(expected.front());
  ASSERT_TRUE(again);
  EXPECT_EQ(again->expression, "y = x");
  std::filesystem::remove_all(folder);
}

TEST(PlotFiles, ASurfaceHasNothingToPrintOrToPlay) {
  const Plot surface = *parse("z = x*y");
  const Plot curve = *parse("y = x");
  for (const PlotFile kind : {PlotFile::document, PlotFile::raw, PlotFile::png}) {
    EXPECT_TRUE(can_be_written(surface, kind));
    EXPECT_TRUE(can_be_written(curve, kind));
  }
  for (const PlotFile kind : {PlotFile::print, PlotFile::sound}) {
    EXPECT_FALSE(can_be_written(surface, kind));
    EXPECT_TRUE(can_be_written(curve, kind));
  }
}

TEST(PlotFiles, EachKindHasItsExtension) {
  EXPECT_EQ(extension_of(PlotFile::document), "json");
  EXPECT_EQ(extension_of(PlotFile::raw), "raw");
  EXPECT_EQ(extension_of(PlotFile::png), "png");
  EXPECT_EQ(extension_of(PlotFile::print), "png");
  EXPECT_EQ(extension_of(PlotFile::sound), "wav");
}

}  // namespace
}  // namespace nazori::functions
