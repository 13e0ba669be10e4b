// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace nazori::functions {
namespace {

using testing::HasSubstr;

TEST(PlotDocument, ComesBackAsItWasSaved) {
  PlotDocument d;
  d.expression = "y = tan(x); y = 1,5x  ";
  d.title = "Übung 3 \"Tangens\"\n正接";
  d.reading.decimal_comma = true;
  d.window = {-0.1, 1.0 / 3, 1e-9, 2e5};
  d.plate.size = 1024;
  d.plate.half_width = 0.02;
  d.plate.layers = {true, false, true, false};
  d.plate.heights = HeightRange{-2.5, 7};
  d.sound = {48'000, 6.5, 110, 880, 0.25, false};
  const auto back = parse_document(to_json(d));
  ASSERT_TRUE(back) << back.error().what;
  EXPECT_EQ(back->expression, d.expression);
  EXPECT_EQ(back->title, d.title);
  EXPECT_TRUE(back->reading.decimal_comma);
  EXPECT_EQ(back->window, d.window);
  EXPECT_EQ(back->plate.size, 1024);
  EXPECT_EQ(back->plate.half_width, 0.02);
  EXPECT_TRUE(back->plate.layers.axes && back->plate.layers.grid);
  EXPECT_FALSE(back->plate.layers.ticks || back->plate.layers.rim);
  ASSERT_TRUE(back->plate.heights);
  EXPECT_EQ(back->plate.heights->low, -2.5);
  EXPECT_EQ(back->sound.sample_rate, 48'000);
  EXPECT_EQ(back->sound.lowest_hz, 110);
  EXPECT_EQ(back->sound.volume, 0.25);
  EXPECT_FALSE(back->sound.earcons);
  EXPECT_EQ(to_json(*back), to_json(d));
}

TEST(PlotDocument, WhatIsLeftOutKeepsItsDefaultAndWhatIsUnknownIsPassedOver) {
  const auto d = parse_document(
      R"({"nazori_plot": 1, "expression": "y = x", "colour": "red", "plate": {"rim": false}})");
  ASSERT_TRUE(d) << d.error().what;
  EXPECT_EQ(d->window, Window{});
  EXPECT_EQ(d->plate.size, PlateSettings{}.size);
  EXPECT_FALSE(d->plate.layers.rim);
}

TEST(PlotDocument, EveryMistakeIsNamedWithItsPlace) {
  struct Mistake {
    const char* text;
    base::Errc code;
    const char* where;
  };
  const Mistake mistakes[] = {
      {"{\n  \"nazori_plot\": 1,\n  \"expression\": }", base::Errc::parse, "line 3"},
      {"", base::Errc::parse, "line 1"},
      {"[1, 2]", base::Errc::schema, "nazori_plot"},
      {R"({"expression": "y = x"})", base::Errc::schema, "nazori_plot"},
      {R"({"nazori_plot": 2, "expression": "y = x"})", base::Errc::schema, "nazori_plot"},
      {R"({"nazori_plot": 1})", base::Errc::bad_argument, "expression"},
      {R"({"nazori_plot": 1, "expression": 7})", base::Errc::bad_argument, "expression"},
      {R"({"nazori_plot": 1, "expression": "y = 2 +"})", base::Errc::parse, "expression, column 8"},
      {R"({"nazori_plot": 1, "expression": "y = x", "window": [1, 2, 3]})", base::Errc::bad_argument,
       "window"},
      {R"({"nazori_plot": 1, "expression": "y = x", "window": [2, 1, 0, 1]})", base::Errc::bad_argument,
       "window"},
      {R"({"nazori_plot": 1, "expression": "y = x", "plate": {"size": 31}})", base::Errc::bad_argument,
       "plate.size"},
      {R"({"nazori_plot": 1, "expression": "y = x", "plate": 3})", base::Errc::bad_argument, "plate"},
      {R"({"nazori_plot": 1, "expression": "y = x", "sound": {"volume": "loud"}})", base::Errc::bad_argument,
       "sound.volume"},
      {R"({"nazori_plot": 1, "expression": "y = x", "sound": {"lowest_hz": 900, "highest_hz": 300}})",
       base::Errc::bad_argument, "sound.highest_hz"},
  };
  for (const Mistake& m : mistakes) {
    const auto d = parse_document(m.text);
    ASSERT_FALSE(d) << m.text;
    EXPECT_EQ(d.error().code, m.code) << m.text;
    EXPECT_THAT(d.error().where, HasSubstr(m.where)) << m.text;
    EXPECT_FALSE(d.error().what.empty());
    EXPECT_EQ(d.error().what.find('\n'), std::string::npos);
  }
  EXPECT_FALSE(parse_document(std::string(100'000, '[')));
}

TEST(PlotDocument, AFileIsWrittenAndReadAndAMissingOneNamed) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "nazori_plot_document_test.json";
  PlotDocument d;
  d.expression = "r = 1 + cos(θ)";
  ASSERT_TRUE(save_document(d, file));
  const auto back = load_document(file);
  ASSERT_TRUE(back) << back.error().what;
  EXPECT_EQ(back->expression, d.expression);
  std::ofstream(file) << "not json";
  const auto broken = load_document(file);
  ASSERT_FALSE(broken);
  EXPECT_THAT(broken.error().where, HasSubstr(file.string()));
  std::filesystem::remove(file);
  EXPECT_EQ(load_document(file).error().code, base::Errc::not_found);
}

}  // namespace
}  // namespace nazori::functions
