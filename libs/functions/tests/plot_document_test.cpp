// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "test_paths.h"

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

// The same file is compared with docs/schemas/plots.json.
TEST(PlotDocument, IsWrittenAsInTheFileOfTheSchemas) {
  PlotDocument d;
  d.expression = "z = sin(x)cos(y)";
  d.title = "A surface";
  d.window = {-3, 3, -2, 2};
  d.plate.size = 256;
  d.plate.heights = HeightRange{-1, 1};
  std::ifstream file(std::string(test_paths::kFixtures) + "/plot.json");
  EXPECT_EQ(to_json(d), std::string(std::istreambuf_iterator<char>(file), {}));
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
      {R"({"nazori_plot": 1})", base::Errc::parse, "expression"},
      {R"({"nazori_plot": 1, "expression": 7})", base::Errc::parse, "expression"},
      {R"({"nazori_plot": 1, "expression": "y = 2 +"})", base::Errc::parse, "expression, column 8"},
      {R"({"nazori_plot": 1, "expression": "y = x", "window": [1, 2, 3]})", base::Errc::parse, "window"},
      {R"({"nazori_plot": 1, "expression": "y = x", "window": [2, 1, 0, 1]})", base::Errc::parse, "window"},
      {R"({"nazori_plot": 1, "expression": "y = x", "plate": {"size": 31}})", base::Errc::parse,
       "line 1, plate/size"},
      {R"({"nazori_plot": 1, "expression": "y = x", "plate": 3})", base::Errc::parse, "plate"},
      {R"({"nazori_plot": 1, "expression": "y = x", "sound": {"volume": "loud"}})", base::Errc::parse,
       "sound/volume"},
      {R"({"nazori_plot": 1, "expression": "y = x", "sound": {"lowest_hz": 900, "highest_hz": 300}})",
       base::Errc::parse, "sound/highest_hz"},
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

/// A saved plot with one member in one of its objects.
base::Result<PlotDocument> with(const std::string& member) {
  return parse_document(R"({"nazori_plot": 1, "expression": "y = x", )" + member + "}");
}

TEST(PlotDocument, NumbersAreTakenUpToTheirBoundsAndNoFurther) {
  struct Bound {
    const char* object;
    const char* name;
    const char* good[2];
    const char* bad[2];
  };
  const Bound bounds[] = {{"plate", "size", {"32", "4096"}, {"31", "4097"}},
                          {"plate", "half_width", {"0.001", "0.2"}, {"0.0009", "0.21"}},
                          {"sound", "sample_rate", {"8000", "192000"}, {"7999", "192001"}},
                          {"sound", "seconds", {"0.2", "60"}, {"0.19", "60.1"}},
                          {"sound", "lowest_hz", {"20", "999"}, {"19", "20001"}},
                          {"sound", "highest_hz", {"201", "20000"}, {"200", "20001"}},
                          {"sound", "volume", {"0", "1"}, {"-0.1", "1.1"}}};
  for (const Bound& b : bounds) {
    const auto written = [&](const char* value) {
      return std::string("\"") + b.object + "\": {\"" + b.name + "\": " + value + "}";
    };
    for (const char* value : b.good) EXPECT_TRUE(with(written(value))) << b.name << ' ' << value;
    for (const char* value : {b.bad[0], b.bad[1], "\"2\"", "null", "true", "[1]"}) {
      const auto d = with(written(value));
      ASSERT_FALSE(d) << b.name << ' ' << value;
      EXPECT_EQ(d.error().code, base::Errc::parse);
      EXPECT_EQ(d.error().where, std::string("line 1, ") + b.object + "/" + b.name) << value;
    }
  }
  EXPECT_FALSE(with(R"("plate": {"size": 64.5})"));
  EXPECT_EQ(with(R"("plate": {"size": 64})")->plate.size, 64);
  EXPECT_EQ(with(R"("plate": {"half_width": 0.03})")->plate.half_width, 0.03);
  EXPECT_EQ(with(R"("sound": {"sample_rate": 8000})")->sound.sample_rate, 8000);
  EXPECT_EQ(with(R"("sound": {"seconds": 7})")->sound.seconds, 7);
  EXPECT_EQ(with(R"("sound": {"highest_hz": 700})")->sound.highest_hz, 700);
  EXPECT_EQ(with(R"("sound": {"lowest_hz": 70})")->sound.lowest_hz, 70);
  EXPECT_EQ(with(R"("sound": {"volume": 0.7})")->sound.volume, 0.7);
  EXPECT_FALSE(with(R"("sound": {"earcons": false})")->sound.earcons);
  for (const char* name : {"axes", "ticks", "grid", "rim"}) {
    EXPECT_FALSE(with(std::string(R"("plate": {")") + name + R"(": 1})")) << name;
    const auto off = with(std::string(R"("plate": {")") + name + R"(": false})");
    const auto on = with(std::string(R"("plate": {")") + name + R"(": true})");
    ASSERT_TRUE(off && on);
    const auto is_on = [&](const PlotDocument& d) {
      const Layers& l = d.plate.layers;
      return name[0] == 'a' ? l.axes : name[0] == 't' ? l.ticks : name[0] == 'g' ? l.grid : l.rim;
    };
    EXPECT_FALSE(is_on(*off)) << name;
    EXPECT_TRUE(is_on(*on)) << name;
  }
}

TEST(PlotDocument, WindowsRangesAndNestsAreChecked) {
  EXPECT_EQ(with(R"("window": [1, 2, 3, 5])")->window, (Window{1, 2, 3, 5}));
  for (const char* wrong :
       {"[1, 2, 3]", "[1, 2, 3, 4, 5]", "[2, 1, 3, 4]", "[1, 2, 3, 3]", "[1, 2, 3, \"4\"]", "{}", "7"}) {
    const auto d = with(std::string("\"window\": ") + wrong);
    ASSERT_FALSE(d) << wrong;
    EXPECT_EQ(d.error().where, "line 1, window") << wrong;
  }
  const auto heights = with(R"("plate": {"heights": [-1, 3]})");
  ASSERT_TRUE(heights);
  EXPECT_EQ(heights->plate.heights->low, -1);
  EXPECT_EQ(heights->plate.heights->high, 3);
  for (const char* wrong : {"[1]", "[3, 3]", "[1, 2, 3]", "\"high\""}) {
    const auto d = with(std::string(R"("plate": {"heights": )") + wrong + "}");
    ASSERT_FALSE(d) << wrong;
    EXPECT_EQ(d.error().where, "line 1, plate/heights") << wrong;
  }
  EXPECT_EQ(with(R"("sound": [])").error().where, "line 1, sound");
  EXPECT_EQ(with(R"("decimal_comma": 1)").error().where, "line 1, decimal_comma");
  EXPECT_EQ(with(R"("title": 1)").error().where, "line 1, title");
  // The first mistake is the one that is told.
  EXPECT_EQ(with(R"("title": 1, "plate": {"size": 1}, "sound": {"volume": 3})").error().where,
            "line 1, title");
  EXPECT_EQ(with(R"("plate": {"size": 1, "half_width": 9}, "sound": {"volume": 3})").error().where,
            "line 1, plate/size");
  const auto nested = [](int depth) {
    return with("\"unknown\": " + std::string(static_cast<std::size_t>(depth), '[') +
                std::string(static_cast<std::size_t>(depth), ']'));
  };
  EXPECT_TRUE(nested(90));
  EXPECT_FALSE(nested(110));
  EXPECT_FALSE(with(R"("window": [1, 2, 3, 1e999])"));
  for (const char* version : {"0", "-1", "1.5", "\"1\"", "2"})
    EXPECT_EQ(parse_document(std::string(R"({"nazori_plot": )") + version + R"(, "expression": "y = x"})")
                  .error()
                  .code,
              base::Errc::schema)
        << version;
}

TEST(PlotDocument, TheLineAndColumnOfAMistakeAreTold) {
  EXPECT_EQ(parse_document("{\n  \"nazori_plot\": 1,\n  \"expression\": }").error().where,
            "line 3, column 17");
  EXPECT_EQ(parse_document("[1, }").error().where, "line 1, column 5");
}

TEST(PlotDocument, AFileOfAMillionBytesIsReadAndNoLargerOne) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "nazori_plot_document_size.json";
  PlotDocument d;
  d.expression = "y = x";
  const std::string text = to_json(d);
  for (const std::size_t size : {std::size_t{1'000'000}, std::size_t{1'000'001}}) {
    std::ofstream(file) << text << std::string(size - text.size(), ' ');
    EXPECT_EQ(load_document(file).has_value(), size == 1'000'000) << size;
  }
  std::filesystem::remove(file);
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
