// SPDX-License-Identifier: Apache-2.0
#include "nazori/scan/sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "../src/strip.h"
#include "drawn_photo.h"

namespace nazori::scan {
namespace {

using testing::SizeIs;

TEST(PageMap, LeadsThroughItsFourPoints) {
  const std::array<print::PaperPoint, 4> page{{{10, 20}, {200, 25}, {190, 280}, {15, 270}}};
  const std::array<PhotoPoint, 4> photo{{{100, 80}, {900, 130}, {850, 1200}, {60, 1100}}};
  const PageMap map = PageMap::through(page, photo);
  for (std::size_t i = 0; i < 4; ++i) expect_near(map.at(page[i]), photo[i], 1e-7);
  EXPECT_EQ(map.matrix[8], 1);
}

TEST(PageMap, KeepsLinesStraight) {
  // The map (x, y) to (2x + y + 3, x - y + 1) / (x / 10 + y / 20 + 1), by its definition.
  const auto seen = [](print::PaperPoint p) {
    const double w = p.x / 10 + p.y / 20 + 1;
    return PhotoPoint{(2 * p.x + p.y + 3) / w, (p.x - p.y + 1) / w};
  };
  const std::array<print::PaperPoint, 4> page{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
  std::array<PhotoPoint, 4> photo;
  for (std::size_t i = 0; i < 4; ++i) photo[i] = seen(page[i]);
  const PageMap map = PageMap::through(page, photo);
  const std::array<double, 9> matrix{2, 1, 3, 1, -1, 1, 0.1, 0.05, 1};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(map.matrix[i], matrix[i], 1e-9) << i;
  for (const print::PaperPoint p : {print::PaperPoint{3, 7}, {20, -5}, {0.5, 40}})
    expect_near(map.at(p), seen(p), 1e-9);
}

TEST(PageMap, WithoutPointsChangesNothing) {
  const PhotoPoint p = PageMap{}.at({3, 4});
  EXPECT_EQ(p, (PhotoPoint{3, 4}));
}

constexpr double kWidth_mm = 210;
constexpr double kHeight_mm = 297;
constexpr int kPerMm = 5;  // pixels

PageMap from_above() { return {{kPerMm, 0, 0, 0, kPerMm, 0, 0, 0, 1}}; }

print::SheetMark a_mark(int page = 1) {
  print::SheetMark mark;
  mark.width_mm = kWidth_mm;
  mark.height_mm = kHeight_mm;
  mark.cell_mm = 15;
  mark.copies = 2;
  mark.page = page;
  mark.runs = {{0, 2, {U'休'}}, {40, 1, {U'日'}}};
  return mark;
}

std::vector<std::uint8_t> bytes_of(const print::SheetMark& mark) {
  return print::mark_bytes(mark, print::mark_room(mark.width_mm)).value();
}

/// A page of white paper, seen from above in the corner of the photograph.
class Page : public Drawn {
 public:
  explicit Page(std::uint8_t paper = 220, int pixels_wide = 1050, int pixels_high = 1485)
      : Drawn(pixels_wide, pixels_high, paper) {}
  /// @param slip_mm  how far a column is moved to the right and down
  template <class Slip>
  void strip(const std::vector<std::uint8_t>& bytes, const Slip& slip_mm, std::uint8_t ink = 20) {
    for (int column = 0; column < print::mark_columns(bytes.size()); ++column)
      for (int row = 0; row <= print::kMarkRows; ++row) {
        const auto bit = static_cast<std::size_t>(column * print::kMarkRows + row - 1);
        const bool dark =
            row == 0 ? column % 2 == 0 : bit / 8 < bytes.size() && (bytes[bit / 8] & 0x80U >> bit % 8) != 0;
        if (dark) module(column, row, slip_mm(column), ink);
      }
  }
  void module(int column, int row, std::array<double, 2> slip, std::uint8_t ink) {
    const print::PaperPoint centre = print::module_centre(kHeight_mm, column, row);
    const int left = static_cast<int>(std::lround((centre.x + slip[0]) * kPerMm)) - 2;
    const int top = static_cast<int>(std::lround((centre.y + slip[1]) * kPerMm)) - 2;
    block(left, top, left + 3, top + 3, ink);
  }
  void discs(std::uint8_t ink = 20) {
    for (const print::PaperPoint c : print::disc_centres(kWidth_mm, kHeight_mm))
      disc({c.x * kPerMm, c.y * kPerMm}, print::kDisc_mm / 2 * kPerMm, ink);
  }
};

constexpr auto kLiesStill = [](int) { return std::array{0.0, 0.0}; };

std::optional<base::Result<print::SheetMark>> read(const Page& page) {
  return read_strip(page.photo(), from_above(), kWidth_mm, kHeight_mm);
}

TEST(Strip, IsReadWhereItIsExpected) {
  Page page;
  page.strip(bytes_of(a_mark()), kLiesStill);
  const auto mark = read(page);
  ASSERT_TRUE(mark);
  ASSERT_TRUE(*mark) << base::to_line(mark->error());
  EXPECT_EQ(**mark, a_mark());
}

TEST(Strip, IsReadALittleBesideThat) {
  for (const auto& slip : {std::array{0.3, 0.0}, {-0.3, 0.2}, {0.0, -0.3}, {0.0, 0.3}}) {
    Page page;
    page.strip(bytes_of(a_mark()), [&](int) { return slip; });
    const auto mark = read(page);
    ASSERT_TRUE(mark) << slip[0] << " " << slip[1];
    ASSERT_TRUE(*mark) << slip[0] << " " << slip[1];
    EXPECT_EQ(**mark, a_mark());
  }
}

TEST(Strip, OfBentPaperIsFollowed) {
  // From column to column a little farther: 1.6 mm in all, two modules.
  const auto columns = static_cast<double>(print::mark_columns(bytes_of(a_mark()).size()));
  for (const double way : {-1.0, 1.0}) {
    Page page;
    page.strip(bytes_of(a_mark()), [&](int column) { return std::array{0.0, way * 1.6 * column / columns}; });
    const auto mark = read(page);
    ASSERT_TRUE(mark);
    ASSERT_TRUE(*mark) << way << " " << base::to_line(mark->error());
    EXPECT_EQ(**mark, a_mark());
  }
}

TEST(Strip, OfEveryLengthIsRead) {
  std::set<std::size_t> lengths;
  for (std::size_t runs = 0; runs < 12; ++runs) {
    print::SheetMark mark = a_mark();
    mark.runs.clear();
    for (std::size_t i = 0; i < runs; ++i)
      mark.runs.push_back({static_cast<double>(i) * 15, 1, {U'一' + static_cast<char32_t>(i)}});
    const auto bytes = bytes_of(mark);
    lengths.insert(bytes.size());
    Page page;
    page.strip(bytes, kLiesStill);
    const auto found = read(page);
    ASSERT_TRUE(found);
    ASSERT_TRUE(*found) << runs << " " << base::to_line(found->error());
    EXPECT_EQ(**found, mark);
  }
  EXPECT_GT(lengths.size(), 4U);
}

TEST(Strip, OnEmptyPaperIsNone) {
  EXPECT_FALSE(read(Page()));
  Page black(0);
  EXPECT_FALSE(read(black));
}

TEST(Strip, ThatIsTooFaintIsNone) {
  for (const auto& [ink, counts] : {std::pair{160, true}, {180, false}}) {
    Page page(200);
    page.strip(bytes_of(a_mark()), kLiesStill, static_cast<std::uint8_t>(ink));
    EXPECT_EQ(read(page).has_value(), counts) << ink;
  }
}

TEST(Strip, WithAnotherContentCannotBeRead) {
  std::vector<std::uint8_t> bytes(print::kFewestMarkBytes);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(37 * i + 11);
  Page page;
  page.strip(bytes, kLiesStill);
  const auto mark = read(page);
  ASSERT_TRUE(mark);
  ASSERT_FALSE(*mark);
  EXPECT_EQ(mark->error().code, base::Errc::parse);
}

std::vector<std::uint8_t> of_another_version(std::size_t content) {
  std::vector<std::uint8_t> bytes(content, 0x11);
  bytes[0] = 0x20;
  return print::sealed_mark(bytes);
}

TEST(Strip, OfAnotherVersionIsToldAsSuch) {
  for (const std::size_t content : {5U, 40U}) {
    Page page;
    page.strip(of_another_version(content), kLiesStill);
    const auto mark = read(page);
    ASSERT_TRUE(mark);
    ASSERT_FALSE(*mark);
    EXPECT_EQ(mark->error().code, base::Errc::schema) << content;
    EXPECT_THAT(mark->error().what, testing::HasSubstr("version 2"));
  }
}

TEST(Sheets, APageOfDiscsAndStripIsFound) {
  Page page;
  page.discs();
  page.strip(bytes_of(a_mark()), kLiesStill);
  const auto sheets = find_sheets(page.photo());
  ASSERT_TRUE(sheets) << base::to_line(sheets.error());
  ASSERT_THAT(*sheets, SizeIs(1));
  EXPECT_EQ(sheets->front().mark, a_mark());
  for (const print::PaperPoint p : {print::PaperPoint{20, 30}, {150, 200}})
    expect_near(sheets->front().map.at(p), {p.x * kPerMm, p.y * kPerMm}, 0.3);
}

TEST(Sheets, TwoPagesOfOnePhotographAreFound) {
  Page both(220, 2500);
  const auto copy = [&](int page, int shift) {
    Page one;
    one.discs();
    one.strip(bytes_of(a_mark(page)), kLiesStill);
    for (int y = 0; y < one.photo().height; ++y)
      for (int x = 0; x < one.photo().width; ++x) both.at(x + shift, y) = one.at(x, y);
  };
  copy(3, 0);
  copy(4, 1450);
  const auto sheets = find_sheets(both.photo());
  ASSERT_TRUE(sheets) << base::to_line(sheets.error());
  ASSERT_THAT(*sheets, SizeIs(2));
  for (const FoundSheet& sheet : *sheets) {
    EXPECT_TRUE(sheet.mark.page == 3 || sheet.mark.page == 4);
    expect_near(sheet.map.at({20, 30}), {100.0 + (sheet.mark.page == 4 ? 1450 : 0), 150}, 0.5);
  }
  EXPECT_NE(sheets->at(0).mark.page, sheets->at(1).mark.page);
}

TEST(Sheets, WithThreeDiscsOrOneOfAnotherSizeAreNotFound) {
  for (const double radius : {0.0, 4.0, 23.0}) {
    Page page;
    page.strip(bytes_of(a_mark()), kLiesStill);
    const auto centres = print::disc_centres(kWidth_mm, kHeight_mm);
    for (std::size_t i = 0; i < 4; ++i)
      if (i != 1 || radius > 0)
        page.disc({centres[i].x * kPerMm, centres[i].y * kPerMm}, i == 1 ? radius : 10);
    const auto sheets = find_sheets(page.photo());
    ASSERT_FALSE(sheets) << radius;
    EXPECT_EQ(sheets.error().code, base::Errc::not_found) << radius;
  }
}

TEST(Sheets, WithoutAStripAreNotFound) {
  Page page;
  page.discs();
  EXPECT_EQ(find_sheets(page.photo()).error().code, base::Errc::not_found);
}

TEST(Sheets, AMarkOfAnotherVersionIsToldAsSuch) {
  Page page;
  page.discs();
  page.strip(of_another_version(5), kLiesStill);
  const auto sheets = find_sheets(page.photo());
  ASSERT_FALSE(sheets);
  EXPECT_EQ(sheets.error().code, base::Errc::schema);
}

TEST(Sheets, AReadablePageBesideAnUnreadableOneIsFound) {
  Page both(220, 2100);
  for (const int page : {0, 1}) {
    Page one;
    one.discs();
    one.strip(page == 0 ? of_another_version(5) : bytes_of(a_mark(7)), kLiesStill);
    for (int y = 0; y < one.photo().height; ++y)
      for (int x = 0; x < one.photo().width; ++x) both.at(x + 1050 * page, y) = one.at(x, y);
  }
  const auto sheets = find_sheets(both.photo());
  ASSERT_TRUE(sheets) << base::to_line(sheets.error());
  ASSERT_THAT(*sheets, SizeIs(1));
  EXPECT_EQ(sheets->front().mark.page, 7);
}

}  // namespace
}  // namespace nazori::scan
