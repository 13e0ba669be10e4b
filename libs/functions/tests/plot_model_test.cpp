// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_model.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string_view>

#include "nazori/functions/plot_examples.h"

namespace nazori::functions {
namespace {

using Kind = PlotEventKind;

TEST(PlotModel, WhatCannotBeReadChangesNothing) {
  PlotModel model;
  EXPECT_FALSE(model.plot());
  ASSERT_TRUE(model.read("y = x; y = 1", {}));
  model.show_alone(1);
  EXPECT_FALSE(model.read("y = x +", {}));
  EXPECT_EQ(model.expression(), "y = x; y = 1");
  EXPECT_EQ(model.plot()->statements.size(), 2U);
  EXPECT_EQ(model.plate().alone, 1);
  ASSERT_TRUE(model.read("y = 2", {}));
  EXPECT_EQ(model.plate().alone, -1) << "another expression is shown whole";
}

TEST(PlotModel, AWindowZoomsAboutTheLocationAndComesBack) {
  PlotModel model;
  ASSERT_TRUE(model.start_with({-4, 4, -2, 2}));
  PlotLocation location;
  location.x = 1;
  location.y = -1;
  const auto event = model.zoom(location, 2);
  EXPECT_EQ(event.kind, Kind::window_changed);
  EXPECT_EQ(event.window, (Window{-1.5, 2.5, -1.5, 0.5}));
  EXPECT_EQ(model.window(), event.window);
  EXPECT_EQ(model.pan(0.25, -0.25).window, (Window{-0.5, 3.5, -2, 0}));
  EXPECT_EQ(model.reset_window().window, (Window{-4, 4, -2, 2}));
  EXPECT_EQ(model.zoom({}, 0.5).window, (Window{-8, 8, -4, 4}));
}

TEST(PlotModel, AWindowThatDoublesCannotHoldIsRefused) {
  PlotModel model;
  Kind last = Kind::window_changed;
  for (int i = 0; i < 2000 && last == Kind::window_changed; ++i) last = model.zoom({}, 2).kind;
  EXPECT_EQ(last, Kind::window_limit);
  EXPECT_TRUE(model.window().check()) << "the last good one stays";
  const auto before = model.window();
  EXPECT_FALSE(model.start_with({3, -3, -1, 1}));
  EXPECT_EQ(model.window(), before);
}

TEST(PlotModel, OneCurveAfterTheOtherIsAloneThenAll) {
  PlotModel model;
  ASSERT_TRUE(model.read("y = x; y = 1", {}));
  auto event = model.show_next_alone();
  EXPECT_EQ(event.kind, Kind::curve_alone);
  EXPECT_EQ(event.statement, 0);
  EXPECT_EQ(model.show_next_alone().statement, 1);
  EXPECT_EQ(model.request(Language::english).plate.alone, 1);
  PlateSettings plate = model.plate();
  plate.alone = -1;
  plate.size = 256;
  model.set_plate(plate);
  EXPECT_EQ(model.plate().alone, 1) << "other settings for the same curve";
  EXPECT_EQ(model.plate().size, 256);
  EXPECT_EQ(model.show_next_alone().kind, Kind::all_curves);
  ASSERT_TRUE(model.read("y = x", {}));
  EXPECT_EQ(model.show_alone(0).kind, Kind::only_one_curve);
  EXPECT_EQ(model.plate().alone, -1);
}

TEST(PlotModel, TheSpeedStaysBetweenOneAndTen) {
  PlotModel model;
  for (int i = 0; i < 20; ++i) model.change_speed(-1);
  EXPECT_EQ(model.speed(), 1);
  EXPECT_DOUBLE_EQ(model.sound().seconds, 6);
  const auto event = model.change_speed(2);
  EXPECT_EQ(event.kind, Kind::speed);
  EXPECT_EQ(event.number, 3);
  EXPECT_EQ(event.count, 10);
  EXPECT_DOUBLE_EQ(model.sound().seconds, 3);
  for (int i = 0; i < 20; ++i) model.change_speed(1);
  EXPECT_EQ(model.speed(), 10);
}

TEST(PlotModel, ComesBackFromItsDocument) {
  PlotModel model;
  ASSERT_TRUE(model.read("y = 1,5x; y = x", {true}));
  ASSERT_TRUE(model.start_with({-1, 2, -3, 4}));
  model.show_alone(1);
  model.change_speed(3);
  const auto document = model.document({true});
  PlotModel other;
  EXPECT_EQ(other.open(document, {true}), "y = 1,5x; y = x");
  EXPECT_EQ(other.window(), model.window());
  EXPECT_EQ(other.plate().alone, 1);
  EXPECT_EQ(other.speed(), 5);
  const std::string here = other.open(document, {false});
  const auto plot = parse(here, {false});
  ASSERT_TRUE(plot) << here;
  EXPECT_EQ(canonical(*plot), canonical(*model.plot())) << "where a comma has another meaning";
}

TEST(PlotModel, SettingsOfAnEarlierDayAreBroughtIntoTheirRange) {
  PlotModel model;
  model.load({{"x0", "3"},
              {"x1", "-3"},
              {"y0", "0"},
              {"y1", "1"},
              {"size", "7"},
              {"half_width", "3"},
              {"speed", "99"}});
  EXPECT_EQ(model.window(), PlotModel::kFirstWindow);
  EXPECT_EQ(model.plate().size, 128);
  EXPECT_EQ(model.plate().half_width, 0.05);
  EXPECT_EQ(model.speed(), 10);
  model.load({{"x0", "-2"},
              {"x1", "2"},
              {"y0", "-1"},
              {"y1", "1"},
              {"size", "9999"},
              {"half_width", "0"},
              {"speed", "-4"}});
  EXPECT_EQ(model.window(), (Window{-2, 2, -1, 1}));
  EXPECT_EQ(model.reset_window().window, (Window{-2, 2, -1, 1}));
  EXPECT_EQ(model.plate().size, 2048);
  EXPECT_EQ(model.plate().half_width, 0.002);
  EXPECT_EQ(model.speed(), 1);
}

TEST(PlotModel, SettingsThatCannotBeReadAreTheFirstOnes) {
  PlotModel model;
  model.load({{"x0", "left"}, {"grid", "perhaps"}, {"rim", ""}, {"size", "many"}, {"speed", "fast"}});
  EXPECT_EQ(model.window(), PlotModel::kFirstWindow);
  EXPECT_TRUE(model.plate().layers.axes);
  EXPECT_TRUE(model.plate().layers.ticks);
  EXPECT_FALSE(model.plate().layers.grid);
  EXPECT_TRUE(model.plate().layers.rim);
  EXPECT_EQ(model.plate().size, 512);
  EXPECT_EQ(model.plate().half_width, 0.0125);
  EXPECT_EQ(model.speed(), 2);
}

TEST(PlotModel, StoredSettingsComeBack) {
  PlotModel model;
  ASSERT_TRUE(model.start_with({-0.1, 0.3, 2, 7.25}));
  PlateSettings plate;
  plate.layers = {false, false, true, false};
  plate.half_width = 0.01;
  plate.size = 256;
  model.set_plate(plate);
  (void)model.change_speed(+3);
  base::Settings settings{{"volume", "30"}};
  model.save(settings);
  EXPECT_EQ(settings["volume"], "30") << "of another object";
  PlotModel other;
  other.load(settings);
  EXPECT_EQ(other.window(), model.window());
  EXPECT_EQ(other.plate().size, 256);
  EXPECT_EQ(other.plate().half_width, 0.01);
  EXPECT_FALSE(other.plate().layers.axes);
  EXPECT_FALSE(other.plate().layers.ticks);
  EXPECT_TRUE(other.plate().layers.grid);
  EXPECT_FALSE(other.plate().layers.rim);
  EXPECT_EQ(other.speed(), model.speed());
}

TEST(PlotModel, ANumberIsReadAsItMayBeTypedAnywhere) {
  EXPECT_EQ(*read_number("-2", {}), -2);
  EXPECT_NEAR(*read_number("-2pi", {}), -6.283185307179586, 1e-15);
  EXPECT_NEAR(*read_number("1/3", {}), 1.0 / 3, 1e-16);
  EXPECT_EQ(*read_number("1,5", {true}), 1.5);
  for (const char* text : {"", "x", "y = x", "1; 2", "1/0", "2 +", "x = 3"})
    EXPECT_FALSE(read_number(text, {})) << text;
}

TEST(PlotExamples, CanBeDrawnAsTheyAre) {
  EXPECT_EQ(plot_examples().size(), 14U);
  for (const auto& example : plot_examples()) {
    PlotModel model;
    EXPECT_TRUE(model.read(std::string(example.expression), {})) << example.expression;
    EXPECT_TRUE(model.start_with(example.window)) << example.expression;
  }
}

TEST(PlotExamples, AreSeenWholeAndInTheMiddle) {
  const auto window_of = [](std::string_view expression) {
    for (const auto& example : plot_examples())
      if (example.expression == expression) return example.window;
    ADD_FAILURE() << expression;
    return Window{};
  };
  // Around the whole curve: a circle of radius 2, a Lissajous figure within 1, a rose within 2.
  const auto square = [](double half) { return Window{-half, half, -half, half}; };
  EXPECT_EQ(window_of("x^2 + y^2 = 4"), square(3));
  EXPECT_EQ(window_of("x = cos(3t); y = sin(2t); 0 <= t <= 2π"), square(1.5));
  EXPECT_EQ(window_of("r = 2cos(3θ); 0 <= θ <= π"), square(2.5));
  EXPECT_EQ(window_of("z = sin(x) cos(y)"), square(std::numbers::pi)) << "a whole wave";
  // Odd and even functions are seen as far to either side.
  for (const auto& example : plot_examples()) {
    if (example.expression == "y^2 = x^3 - x") continue;  // its branch runs to the right
    EXPECT_EQ(example.window.x0, -example.window.x1) << example.expression;
  }
  for (const char* odd : {"y = sin x", "y = x^3 - 3x", "y = 1/x", "y^2 = x^3 - x", "y = e^x; y = ln x"})
    EXPECT_EQ(window_of(odd).y0, -window_of(odd).y1) << odd;
}

}  // namespace
}  // namespace nazori::functions
