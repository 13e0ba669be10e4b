// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/tracer.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace nazori::author {
namespace {

TraceRequest of_font(char32_t character) {
  TraceRequest request;
  request.family = "Klee One";
  request.glyph = character;
  return request;
}

kanji::StrokeLine line(double x0, double y0, double x1, double y1) {
  kanji::StrokeLine made;
  made.points = {{x0, y0}, {x1, y1}};
  return made;
}

TEST(TraceRequest, FindsTheStrokesOfAFontWithFewPoints) {
  const auto found = trace_request(of_font(U'二'));
  ASSERT_TRUE(found) << found.error().what;
  ASSERT_EQ(found->strokes.size(), 2U);
  EXPECT_EQ(found->source, "Klee One");
  for (const OwnStroke& stroke : found->strokes) EXPECT_LT(stroke.points.size(), 40U);
  EXPECT_TRUE(found->unsure.empty());
}

TEST(TraceRequest, TheStrokesOfAKnownCharacterComeInItsOrder) {
  TraceRequest request = of_font(U'二');
  request.known = {line(15, 85, 95, 85), line(30, 30, 80, 28)};  // the lower one first
  const auto found = trace_request(request);
  ASSERT_TRUE(found) << found.error().what;
  ASSERT_EQ(found->strokes.size(), 2U);
  EXPECT_GT(found->strokes[0].points[0].at.y, found->strokes[1].points[0].at.y + 20);
  EXPECT_TRUE(found->unsure.empty());
}

TEST(TraceRequest, AStrokeWithoutInkIsUnsure) {
  TraceRequest request = of_font(U'二');
  request.known = {line(30, 30, 80, 28), line(15, 85, 95, 85), line(54, 10, 54, 100)};
  const auto found = trace_request(request);
  ASSERT_TRUE(found) << found.error().what;
  EXPECT_EQ(found->unsure, std::vector<std::size_t>{2});
}

TEST(TraceRequest, AnErrorNamesThePicture) {
  const auto path = std::filesystem::path(testing::TempDir()) / "text.png";
  std::ofstream(path) << "no picture";
  TraceRequest request;
  request.picture = path;
  const auto refused = trace_request(request);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().where.find("text.png"), std::string::npos);
}

class TracerTest : public testing::Test {
 protected:
  TracerTest() {
    tracer_.traced.connect([this](const Traced& found) { strokes_.push_back(found.strokes.size()); });
    tracer_.failed.connect([this](const base::Error&) { ++failures_; });
  }
  void wait() {
    inbox_.run_until([this] { return !tracer_.is_busy(); });
  }

  base::Inbox inbox_;
  std::vector<std::size_t> strokes_;
  int failures_ = 0;
  Tracer tracer_{inbox_};
};

TEST_F(TracerTest, AnswersOnTheOwnersThread) {
  EXPECT_FALSE(tracer_.is_busy());
  tracer_.trace(of_font(U'三'));
  EXPECT_TRUE(tracer_.is_busy());
  EXPECT_TRUE(strokes_.empty());
  wait();
  EXPECT_EQ(strokes_, std::vector<std::size_t>{3});
  EXPECT_EQ(failures_, 0);
}

TEST_F(TracerTest, OnlyTheNewestRequestIsAnswered) {
  tracer_.trace(of_font(U'三'));
  tracer_.trace(of_font(U'一'));
  wait();
  EXPECT_EQ(strokes_, std::vector<std::size_t>{1});
}

TEST_F(TracerTest, AFailureIsToldAndTheNextRequestWorks) {
  TraceRequest missing;
  missing.picture = "/no/such/picture.png";
  tracer_.trace(missing);
  wait();
  EXPECT_EQ(failures_, 1);
  tracer_.trace(of_font(U'一'));
  wait();
  EXPECT_EQ(strokes_, std::vector<std::size_t>{1});
}

}  // namespace
}  // namespace nazori::author
