// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/tablet_workshop.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nazori/kanji/stroke_order.h"
#include "nazori/practice/blank_tablet.h"
#include "nazori/surface/height_map_file.h"

namespace nazori::practice {
namespace {

namespace fs = std::filesystem;

/// A folder that is removed with its test.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "nazori-workshop-XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] fs::path operator/(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

/// A workshop, and all its answers.
struct WorkshopUnderTest {
  WorkshopUnderTest() {
    workshop.carved.connect(
        [this](char32_t character, const Tablet& tablet) { carved.emplace_back(character, tablet); });
    workshop.loaded.connect([this](const OwnTablet& own) { loaded.push_back(own); });
    workshop.saved.connect([this](const fs::path& path) { saved.push_back(path); });
    workshop.failed.connect([this](const fs::path& path, const base::Error&) { failed.push_back(path); });
  }
  template <class List>
  void wait_for(const List& list, std::size_t count) {
    inbox.run_until([&] { return list.size() >= count; });
  }

  std::vector<std::pair<char32_t, Tablet>> carved;
  std::vector<OwnTablet> loaded;
  std::vector<fs::path> saved, failed;
  base::Inbox inbox;
  TabletWorkshop workshop{inbox};
};

class OwnFiles : public testing::Test {
 protected:
  [[nodiscard]] fs::path path(const char* name) const { return folder_ / name; }
  /// A stroke file with its farthest point there.
  fs::path strokes(const char* name, std::int32_t x, std::int32_t y) {
    kanji::StrokeOrder order;
    order.add_stroke({{10, 10}, {x, y}});
    EXPECT_TRUE(order.save(path(name)));
    return path(name);
  }
  OwnTablet load(const fs::path& map, const fs::path& order, const OwnTablet& onto = {}, int grid = 0) {
    under_.loaded.clear();
    under_.workshop.load(map, order, onto, grid);
    under_.wait_for(under_.loaded, 1);
    return under_.loaded.front();
  }
  Folder folder_;
  WorkshopUnderTest under_;
};

TEST_F(OwnFiles, TheGridOfAStrokeFileIsThePowerOfTwoThatHoldsIt) {
  struct Expected {
    std::int32_t x, y;
    int side;
    bool certain;
  };
  const Expected all[] = {{63, 20, 128, false},  {64, 20, 128, true},    {20, 64, 128, true},
                          {127, 127, 128, true}, {128, 20, 256, false},  {20, 255, 256, false},
                          {256, 20, 512, false}, {20, 1000, 1024, false}};
  for (const auto& [x, y, side, certain] : all) {
    const auto guess = TabletWorkshop::guess_grid(strokes("a.str", x, y));
    ASSERT_TRUE(guess);
    EXPECT_EQ(guess->side, side) << x << ' ' << y;
    EXPECT_EQ(guess->certain, certain) << x << ' ' << y;
  }
  EXPECT_FALSE(TabletWorkshop::guess_grid(path("none.str")));
}

TEST_F(OwnFiles, StrokesAloneAreCarvedInTheWindowsSizeOnTheirGrid) {
  const auto own = load({}, strokes("a.str", 64, 64));
  ASSERT_TRUE(own.tablet);
  EXPECT_EQ(own.name, "a.str");
  EXPECT_TRUE(own.has_strokes);
  EXPECT_EQ(own.map_size, 0);
  EXPECT_EQ(own.tablet->height_map().size(), TabletWorkshop::kSize);
  // On a grid of twice the side, the same points are half as far away.
  const auto wide = load({}, path("a.str"), {}, 256);
  ASSERT_TRUE(wide.tablet);
  const auto end = own.tablet->lines()[0].points.back();
  const auto wide_end = wide.tablet->lines()[0].points.back();
  EXPECT_NEAR(wide_end.x / end.x, 0.5, 0.02);
}

TEST_F(OwnFiles, AMapHasItsNameAndSizeAndStrokesAreLaidOverIt) {
  auto map = surface::HeightMap::create(64);
  ASSERT_TRUE(map);
  ASSERT_TRUE(surface::save_raw(*map, path("m.raw")));
  const auto own = load(path("m.raw"), {});
  EXPECT_EQ(own.name, "m.raw");
  EXPECT_EQ(own.map_size, 64);
  EXPECT_FALSE(own.has_strokes);
  EXPECT_TRUE(own.tablet->lines().empty());
  const auto both = load({}, strokes("a.str", 40, 40), own);
  EXPECT_EQ(both.name, "m.raw + a.str");
  EXPECT_EQ(both.map_size, 64);
  EXPECT_EQ(both.tablet->height_map().size(), 64);
  EXPECT_EQ(both.tablet->lines().size(), 1U);
  const auto other = load({}, strokes("b.str", 50, 50), both);
  EXPECT_EQ(other.name, "m.raw + b.str") << "in place of those before";
  under_.workshop.load({}, strokes("c.str", 64, 64), own);
  under_.wait_for(under_.failed, 1);
  EXPECT_EQ(under_.failed.at(0), path("c.str")) << "they do not fit on the map";
}

TEST_F(OwnFiles, ATabletIsWrittenInTheSizeThatIsAskedForAndAMapInItsOwn) {
  const auto own = load({}, strokes("a.str", 100, 100));
  const auto save = [&](const char* name, const OwnTablet& what, FileFormat format, int size) {
    under_.workshop.save(what.tablet, path(name), format, size, what.map_size > 0);
    under_.wait_for(under_.saved, under_.saved.size() + 1);
    return path(name);
  };
  const auto raw = surface::load_raw(save("b.raw", own, FileFormat::raw, 128));
  ASSERT_TRUE(raw);
  EXPECT_EQ(raw->size(), 128);
  const auto png = surface::load_png(save("b.png", own, FileFormat::png, 256));
  ASSERT_TRUE(png);
  EXPECT_EQ(png->size(), 256);
  const auto order = kanji::StrokeOrder::load(save("b.str", own, FileFormat::strokes, 128), 128);
  ASSERT_TRUE(order);
  ASSERT_EQ(order->count(), 1U);
  EXPECT_NEAR(order->stroke(1).back().x, 100, 1);
  const auto map = load(path("b.raw"), {});
  EXPECT_EQ(surface::load_raw(save("c.raw", map, FileFormat::raw, 512))->size(), 128);
}

TEST(Saving, ACarvedTabletIsWrittenInEachFormatAndReadAgain) {
  const Folder folder;
  std::vector<kanji::StrokeLine> lines(1);
  lines[0].points = {{20, 54.5}, {89, 54.5}};
  const Tablet tablet = *tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 256);
  WorkshopUnderTest under;
  auto& workshop = under.workshop;
  const auto path = [&folder](const char* name) { return folder / name; };
  workshop.save(tablet, path("a.raw"), FileFormat::raw, 128, false);
  workshop.save(tablet, path("a.png"), FileFormat::png, 512, false);
  workshop.save(tablet, path("a.str"), FileFormat::strokes, 128, false);
  under.wait_for(under.saved, 3);
  const auto raw = surface::load_raw(path("a.raw"));
  ASSERT_TRUE(raw);
  EXPECT_EQ(raw->size(), 128);
  EXPECT_LT(raw->at(64, 63), 0.2F) << "the groove";
  EXPECT_GT(raw->at(64, 10), 0.99F) << "the plateau";
  const auto png = surface::load_png(path("a.png"));
  ASSERT_TRUE(png);
  EXPECT_EQ(png->size(), 512);
  const auto order = kanji::StrokeOrder::load(path("a.str"), 128);
  ASSERT_TRUE(order);
  EXPECT_EQ(order->count(), 1U);
}

TEST(Saving, AFolderThatCannotBeWrittenIsReported) {
  std::vector<kanji::StrokeLine> lines(1);
  lines[0].points = {{20, 54.5}, {89, 54.5}};
  const Tablet tablet = *tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 64);
  WorkshopUnderTest under;
  under.workshop.save(tablet, "/nonexistent/a.raw", FileFormat::raw, 64, false);
  under.wait_for(under.failed, 1);
  EXPECT_EQ(under.failed.at(0), fs::path("/nonexistent/a.raw"));
}

TEST(Carving, OfSeveralCharactersTheNewestIsAnsweredAndOneThatIsAtHandIsNotCarvedAgain) {
  WorkshopUnderTest under;
  const auto character = [](char32_t code_point, double x) {
    kanji::Character made;
    made.code_point = code_point;
    made.strokes.resize(1);
    made.strokes[0].line.points = {{20, 54.5}, {x, 54.5}};
    return made;
  };
  for (const char32_t one : {U'a', U'b', U'c'}) under.workshop.carve(character(one, 60));
  under.wait_for(under.carved, 1);
  while (under.carved.back().first != U'c') under.inbox.run_one();
  const Tablet first = under.carved.back().second;
  const std::size_t before = under.carved.size();
  under.workshop.carve(character(U'c', 89));
  under.wait_for(under.carved, before + 1);
  EXPECT_EQ(under.carved.back().second, first);
}

TEST(Carving, ATabletThatWasMadeElsewhereTakesThePlaceOfWhatWasAskedFor) {
  WorkshopUnderTest under;
  kanji::Character asked;
  asked.code_point = U'a';
  asked.strokes.resize(1);
  asked.strokes[0].line.points = {{20, 54.5}, {60, 54.5}};
  under.workshop.carve(asked);
  const Tablet made = blank_tablet();
  under.workshop.show({made, "sheet", 64, false});
  ASSERT_EQ(under.loaded.size(), 1U);
  EXPECT_EQ(under.loaded[0].tablet, made);
  EXPECT_EQ(under.loaded[0].name, "sheet");
  // What is asked for after it is answered, what was asked before is not.
  asked.code_point = U'b';
  under.workshop.carve(asked);
  under.wait_for(under.carved, 1);
  EXPECT_EQ(under.carved[0].first, U'b');
}

TEST(Carving, TheTwoTabletsThatWereCarvedLastStayAtHand) {
  WorkshopUnderTest under;
  const auto carve = [&](char32_t code_point) {
    kanji::Character made;
    made.code_point = code_point;
    made.strokes.resize(1);
    made.strokes[0].line.points = {{20, 54.5}, {60, 54.5}};
    under.carved.clear();
    under.workshop.carve(made);
    under.wait_for(under.carved, 1);
    return under.carved.back().second;
  };
  const Tablet first = carve(U'a'), second = carve(U'b');
  EXPECT_EQ(carve(U'a'), first);
  EXPECT_EQ(carve(U'b'), second);
  (void)carve(U'c');
  EXPECT_NE(carve(U'a'), first) << "the third before";
}

}  // namespace
}  // namespace nazori::practice
