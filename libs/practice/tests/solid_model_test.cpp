// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/solid_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

#include "learner_under_test.h"
#include "nazori/functions/drawing.h"
#include "nazori/practice/solid_maker.h"

namespace nazori::practice {
namespace {

using testing::IsEmpty;

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// One stroke from left to right in the middle, as 一.
SolidTablet bar(kanji::StrokeEnding ending = kanji::StrokeEnding::stop) {
  kanji::StrokeLine line;
  line.points = {{20, 54.5}, {90, 54.5}};
  line.ending = ending;
  return {{line}, {}};
}

Solid solid(const SolidTablet& tablet, const SolidSettings& settings) {
  const auto plate = tablet_plate({&tablet, 1}, settings);
  EXPECT_TRUE(plate) << (plate ? "" : base::to_line(plate.error()));
  return solid_of(*plate).value();
}

TEST(SolidTablets, HaveTheirSizeInMillimetres) {
  SolidSettings settings;
  settings.plate.side_mm = 60;
  settings.plate.hanging_hole = false;
  const Solid raised = solid(bar(), settings);
  EXPECT_NEAR(raised.width_mm, 72, 0.3);
  EXPECT_NEAR(raised.height_mm, 72, 0.3);
  // The plate, a line and the dot at its start.
  EXPECT_NEAR(raised.thickness_mm, 3 + 1 + 0.8, 0.02);
  EXPECT_LE(raised.error_mm, 0.02);
  EXPECT_TRUE(raised.is_watertight());
  settings.raised = false;
  const Solid grooved = solid(bar(), settings);
  EXPECT_NEAR(grooved.thickness_mm, 6, 1e-3);
  EXPECT_LE(grooved.error_mm, 0.01);
  EXPECT_LT(model::volume_mm3(grooved.mesh), 72.3 * 72.3 * 6);
  settings.thickness_mm = 8;
  EXPECT_NEAR(solid(bar(), settings).thickness_mm, 8, 1e-3);
}

TEST(SolidTablets, AMouldIsTheNegativeWithoutAHole) {
  SolidSettings settings;
  settings.plate.side_mm = 50;
  settings.mould = true;
  const SolidTablet tablet = bar();
  const auto plate = tablet_plate({&tablet, 1}, settings);
  ASSERT_TRUE(plate);
  EXPECT_THAT(plate->plate.holes(), IsEmpty());
  EXPECT_NEAR(plate->plate.height_mm(), 62, 0.3);  // no strip for a hole
  settings.mould = false;
  const auto tablet_itself = tablet_plate({&tablet, 1}, settings);
  EXPECT_EQ(tablet_itself->plate.holes().size(), 1U);
  EXPECT_GT(tablet_itself->plate.height_mm(), 65);
  // In the middle of the stroke the tablet is high and the mould is deep.
  const auto middle = [](const model::Plate& of) {
    return of.at(of.columns() / 2, static_cast<int>(31 / of.step_mm()));
  };
  const auto corner = [](const model::Plate& of) {
    return of.at(of.columns() / 4, static_cast<int>(15 / of.step_mm()));
  };
  EXPECT_GT(middle(tablet_itself->plate), corner(tablet_itself->plate) + 0.8F);
  EXPECT_LT(middle(plate->plate), corner(plate->plate) - 0.8F);
}

TEST(SolidTablets, SweepsAndHooksSinkAndStopsDoNot) {
  using kanji::StrokeEnding;
  const auto end_of = [](StrokeEnding ending) { return raised_strokes(bar(ending).strokes).front().end; };
  EXPECT_EQ(end_of(StrokeEnding::stop), model::LineEnd::full);
  EXPECT_EQ(end_of(StrokeEnding::taper), model::LineEnd::sinks);
  EXPECT_EQ(end_of(StrokeEnding::hook), model::LineEnd::sinks);
  const auto line = raised_strokes(bar().strokes).front().line;
  EXPECT_NEAR(line.front().x, 20.0 / 109, 1e-9);
  EXPECT_NEAR(line.front().y, 0.5, 1e-9);  // y up
}

TEST(SolidTablets, WhatHasNoLinesCannotBeRaised) {
  const SolidTablet map{{}, surface::HeightMap::create(64).value()};
  SolidSettings settings;
  const auto raised = tablet_plate({&map, 1}, settings);
  ASSERT_FALSE(raised);
  EXPECT_EQ(raised.error().code, base::Errc::bad_argument);
  settings.raised = false;
  EXPECT_TRUE(tablet_plate({&map, 1}, settings));
  EXPECT_FALSE(tablet_plate({}, settings));
}

TEST(ReliefPicture, ShowsASlopeTowardsTheLightBrighterThanOneAwayFromIt) {
  SolidSettings settings;
  settings.plate.side_mm = 60;
  settings.plate.strokes.numbers = false;
  const SolidTablet tablet = bar();
  const auto plate = tablet_plate({&tablet, 1}, settings);
  const ReliefPicture picture = relief_picture(plate->plate, 200);
  ASSERT_EQ(picture.grey.size(),
            static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  EXPECT_LE(std::max(picture.width, picture.height), 200);
  EXPECT_GT(std::max(picture.width, picture.height), 90);
  const auto grey = [&](int x, int y) {
    return picture.grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                        static_cast<std::size_t>(x)];
  };
  // Down the middle the bar's upper flank is bright, its lower flank dark, all else flat.
  int brightest = 0;
  int darkest = 0;
  for (int y = picture.height / 4; y < picture.height * 9 / 10; ++y) {
    if (grey(picture.width / 2, y) > grey(picture.width / 2, brightest)) brightest = y;
    if (grey(picture.width / 2, y) < grey(picture.width / 2, darkest)) darkest = y;
  }
  EXPECT_LT(brightest, darkest);
  EXPECT_LT(darkest - brightest, picture.height / 10);
  const int flat = grey(picture.width / 10, picture.height * 8 / 10);
  EXPECT_GT(grey(picture.width / 2, brightest), flat + 20);
  EXPECT_LT(grey(picture.width / 2, darkest), flat - 20);
  // The hole for hanging is at the top, in the middle.
  int holes = 0;
  for (int y = 0; y < picture.height / 4; ++y) holes += grey(picture.width / 2, y) < 40 ? 1 : 0;
  EXPECT_GT(holes, 2);
}

TEST(ReliefPicture, IsOfTheGreyThatASlopeHasInLightFromTheUpperLeft) {
  // 10 x 6 mm with a sample each half millimetre; the map rises by its whole height over 10 mm.
  const auto picture = [](double rise_right_mm, double rise_up_mm) {
    auto plate = model::Plate::create(10, 6, 0.5, 3).value();
    auto map = surface::HeightMap::create(21).value();
    for (int row = 0; row < 21; ++row)
      for (int column = 0; column < 21; ++column)
        map.set(column, row,
                static_cast<float>((rise_right_mm * column + rise_up_mm * (20 - row)) / 20 / 10));
    plate.put(map, {0, 0}, 10, 10);
    return relief_picture(plate, 100);
  };
  const auto flat = picture(0, 0);
  EXPECT_EQ(flat.width, 20);
  EXPECT_EQ(flat.height, 12);
  ASSERT_EQ(flat.grey.size(), 240U);
  // 0.72 of white on level ground; a slope of 1 turns the light by 45 degrees.
  EXPECT_EQ(flat.grey[35], 184);
  EXPECT_EQ(picture(10, 0).grey[35], std::lround((0.72 + 0.4 / 2) * 255));
  EXPECT_EQ(picture(0, 10).grey[35], std::lround((0.72 - 0.4 / 2) * 255));
  EXPECT_EQ(picture(5, 5).grey[35], 184) << "as much towards the light as away from it";
}

TEST(ReliefPicture, HasAsManySamplesAsAreAskedForAtMost) {
  const auto plate = model::Plate::create(20, 10, 0.5, 3).value();  // 41 x 21 samples
  for (const auto& [most, step] : {std::pair{41, 1}, {100, 1}, {40, 2}, {21, 2}, {20, 3}}) {
    const auto picture = relief_picture(plate, most);
    EXPECT_EQ(picture.width, 40 / step) << most;
    EXPECT_EQ(picture.height, 20 / step) << most;
    EXPECT_EQ(picture.grey.size(), static_cast<std::size_t>((40 / step) * (20 / step)));
  }
}

TEST(ReliefPicture, AHoleIsDarkAndInItsPlaceFromTheTop) {
  auto plate = model::Plate::create(30, 20, 0.25, 3).value();
  ASSERT_TRUE(plate.add_hole({{8, 15}, 2}));
  const auto picture = relief_picture(plate, 1000);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      // The sample at the lower left of each square of the picture.
      const double dx = 0.25 * x - 8, dy = 20 - 0.25 * (y + 1) - 15;
      ASSERT_EQ(picture.grey[static_cast<std::size_t>(y * picture.width + x)],
                dx * dx + dy * dy < 4 ? 26 : 184)
          << x << " " << y;
    }
}

class SolidMakerTest : public LearnerTest {
 protected:
  SolidMakerTest() {
    maker_.shown.connect([this](const SolidView& view) { view_ = view, ++answers_; });
    maker_.refused.connect([this](const base::Error& error) { error_ = error, ++answers_; });
    maker_.saved.connect([this](const std::filesystem::path& path) { saved_ = path, ++answers_; });
    maker_.not_saved.connect(
        [this](const std::filesystem::path&, const base::Error& error) { error_ = error, ++answers_; });
  }
  void wait() {
    inbox_.run_until([this] { return answers_ > 0; });
    answers_ = 0;
  }
  static SolidRequest request(double side_mm) {
    SolidRequest made;
    made.tablets = {bar()};
    made.settings.plate.side_mm = side_mm;
    return made;
  }

  std::optional<SolidView> view_;
  std::optional<base::Error> error_;
  std::filesystem::path saved_;
  int answers_ = 0;
  SolidMaker maker_{inbox_};
};

TEST_F(SolidMakerTest, ShowsTheNewestAndWritesWhatItShows) {
  maker_.show(request(30));
  maker_.show(request(40));
  wait();
  ASSERT_TRUE(view_);
  EXPECT_NEAR(view_->solid->width_mm, 52, 0.3);
  EXPECT_TRUE(view_->is_watertight);
  EXPECT_GT(view_->picture.width, 0);
  maker_.save(view_->solid, folder_ / "a.stl", "一");
  wait();
  EXPECT_EQ(saved_, folder_ / "a.stl");
  EXPECT_EQ(content(saved_).size(), 84 + 50 * view_->solid->mesh.triangles.size());
  maker_.save(view_->solid, folder_ / "a.3MF", "一");
  wait();
  EXPECT_EQ(content(saved_).substr(0, 2), "PK");
}

TEST_F(SolidMakerTest, SaysWhatCannotBeMadeOrWritten) {
  SolidRequest thin = request(40);
  thin.settings.raised = false;
  thin.settings.thickness_mm = 3;  // as deep as the groove
  maker_.show(thin);
  wait();
  ASSERT_TRUE(error_);
  EXPECT_EQ(error_->code, base::Errc::bad_argument);
  EXPECT_FALSE(view_);
  error_.reset();
  maker_.show(request(40));
  wait();
  maker_.save(view_->solid, folder_ / "missing" / "a.stl", "一");
  wait();
  EXPECT_TRUE(error_);
  EXPECT_TRUE(saved_.empty());
}

TEST_F(SolidMakerTest, APlotBecomesASolidAndAMouldOfIt) {
  functions::PlotRequest asked;
  asked.plot = *functions::parse("y = x^2/4");
  asked.window = {-4, 4, -4, 4};
  std::optional<functions::Drawing> drawing;
  ASSERT_TRUE(functions::draw_plot(asked, [&](functions::Drawing&& drawn) {
    drawing = std::move(drawn);
    return true;
  }));
  SolidRequest made;
  made.plot = std::make_shared<const functions::Drawing>(*std::move(drawing));
  made.settings.plate.side_mm = 80;
  maker_.show(made);
  wait();
  ASSERT_TRUE(view_) << base::to_line(*error_);
  EXPECT_NEAR(view_->solid->thickness_mm, 4, 0.02);
  EXPECT_GT(view_->solid->width_mm, 80 + 30);  // with the labels in braille
  EXPECT_TRUE(view_->is_watertight);
  const double width = view_->solid->width_mm;
  made.settings.mould = true;
  maker_.show(made);
  wait();
  EXPECT_NEAR(view_->solid->width_mm, width, 0.01);
  EXPECT_GT(view_->solid->thickness_mm, 5);
}

}  // namespace
}  // namespace nazori::practice
