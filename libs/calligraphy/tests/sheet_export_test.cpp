// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/sheet_export.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "editor_under_test.h"

namespace nazori::calligraphy {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

int count_of(const std::string& text, const std::string& what) {
  int count = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++count;
  return count;
}

/// The points of the first path of an SVG.
std::vector<geometry::PaperPoint> first_path(const std::string& svg) {
  std::vector<geometry::PaperPoint> points;
  const char* at = svg.c_str() + svg.find(" d=\"") + 4;
  while (*at == 'M' || *at == 'L') {
    char* end = nullptr;
    const double x = std::strtod(at + 1, &end);
    const double y = std::strtod(end + 1, &end);
    points.push_back({x, y});
    at = end;
  }
  EXPECT_EQ(*at, 'Z');
  return points;
}

TEST(SheetExport, SvgHasOnePathForEachStrokeInMillimetresDownwards) {
  SheetEditor e = test::editor();
  test::line(e, {-0.03, 0.02}, {0.03, 0.02});
  test::line(e, {0, 0.04}, {0, -0.04});
  const std::string svg = to_svg(e.written());
  EXPECT_EQ(count_of(svg, "<path "), 2);
  EXPECT_NE(svg.find("id=\"stroke-2\""), std::string::npos);
  EXPECT_NE(svg.find("width=\"102.4mm\" height=\"102.4mm\" viewBox=\"0 0 102.4 102.4\""), std::string::npos);
  const auto points = first_path(svg);
  ASSERT_GT(points.size(), 10U);
  const auto [left, right] =
      std::minmax_element(points.begin(), points.end(), [](auto a, auto b) { return a.x < b.x; });
  EXPECT_NEAR(left->x, 51.2 - 30, 4);
  EXPECT_NEAR(right->x, 51.2 + 30, 4);
  // In the middle the width is that of the brush.
  double high = 1000, low = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto from = points[i], to = points[(i + 1) % points.size()];
    if ((from.x < 51.2) == (to.x < 51.2)) continue;
    const double y = from.y + (to.y - from.y) * (51.2 - from.x) / (to.x - from.x);
    high = std::min(high, y);
    low = std::max(low, y);
  }
  const BrushPoint& middle = e.written()[0][e.written()[0].size() / 2];
  EXPECT_NEAR((high + low) / 2, 51.2 - 1000 * middle.at.y, 0.2);
  EXPECT_NEAR(middle.at.y, 0.02, 0.001);
  EXPECT_NEAR(low - high, 2000 * middle.half_width_m, 0.2);
}

TEST(SheetExport, SvgWithoutStrokesIsRefused) {
  const fs::path path = fs::path(testing::TempDir()) / "none.svg";
  const auto saved = save_svg({}, path);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().code, base::Errc::not_found);
  EXPECT_FALSE(fs::exists(path));
}

TEST(SheetExport, FilesAreWritten) {
  SheetEditor e = test::editor();
  test::line(e, {-0.03, 0.02}, {0.03, 0.02});
  const fs::path folder = testing::TempDir();
  ASSERT_TRUE(save_svg(e.written(), folder / "one.svg"));
  EXPECT_EQ(text_of(folder / "one.svg"), to_svg(e.written()));
  ASSERT_TRUE(save_pdf(e.sheet(), "一", folder / "one.pdf"));
  const std::string pdf = text_of(folder / "one.pdf");
  EXPECT_NE(pdf.find("/Width 128 /Height 128"), std::string::npos);
  EXPECT_NE(pdf.find("<FEFF4E00>"), std::string::npos);
  EXPECT_FALSE(save_pdf(e.sheet(), "", folder / "no" / "one.pdf"));
  fs::remove(folder / "one.svg");
  fs::remove(folder / "one.pdf");
}

}  // namespace
}  // namespace nazori::calligraphy
