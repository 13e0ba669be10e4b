// SPDX-License-Identifier: Apache-2.0
#include "nazori/print/picture_page.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace nazori::print {
namespace {

/// The streams of a PDF, inflated, in their order.
std::vector<std::string> streams(const std::string& pdf) {
  std::vector<std::string> all;
  std::size_t at = 0;
  while ((at = pdf.find("\nstream\n", at)) != std::string::npos) {
    at += 8;
    const std::size_t end = pdf.find("\nendstream", at);
    std::string text(1 << 20, '\0');
    uLongf length = text.size();
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(text.data()), &length,
                         reinterpret_cast<const Bytef*>(pdf.data() + at), static_cast<uLong>(end - at)),
              Z_OK);
    text.resize(length);
    all.push_back(std::move(text));
    at = end;
  }
  return all;
}

TEST(PicturePage, HasEveryPixelAtTheRealSizeInTheMiddleOfA4) {
  std::vector<std::uint8_t> rgb;
  for (int i = 0; i < 4 * 2 * 3; ++i) rgb.push_back(static_cast<std::uint8_t>(i * 7));
  const auto pdf = picture_page({4, 2, rgb, 100}, "書");
  ASSERT_TRUE(pdf);
  EXPECT_EQ(pdf->substr(0, 5), "%PDF-");
  EXPECT_NE(pdf->find("/MediaBox [0 0 595.2756 841.8898]"), std::string::npos);
  EXPECT_NE(pdf->find("/Width 4 /Height 2"), std::string::npos);
  EXPECT_NE(pdf->find("/PrintScaling /None"), std::string::npos);
  EXPECT_NE(pdf->find("<FEFF66F8>"), std::string::npos);
  const auto parts = streams(*pdf);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0], std::string(rgb.begin(), rgb.end()));
  double width = 0, height = 0, x = 0, y = 0;
  ASSERT_EQ(std::sscanf(parts[1].c_str(), "q %lf 0 0 %lf %lf %lf cm", &width, &height, &x, &y), 4);
  EXPECT_NEAR(width, 100 / 25.4 * 72, 1e-3);
  EXPECT_NEAR(height, 50 / 25.4 * 72, 1e-3);
  EXPECT_NEAR(x, 55 / 25.4 * 72, 1e-3);
  EXPECT_NEAR(y, 123.5 / 25.4 * 72, 1e-3);
}

TEST(PicturePage, RefusesWhatIsNoPictureAndWhatDoesNotFit) {
  const std::vector<std::uint8_t> rgb(4 * 2 * 3);
  EXPECT_FALSE(picture_page({0, 0, {}, 100}, ""));
  EXPECT_FALSE(picture_page({4, 3, rgb, 100}, ""));
  EXPECT_FALSE(picture_page({4, 2, rgb, 211}, ""));
  EXPECT_FALSE(picture_page({4, 2, rgb, 0}, ""));
  EXPECT_FALSE(picture_page({4, 2, rgb, std::nan("")}, ""));
  EXPECT_TRUE(picture_page({4, 2, rgb, 210}, ""));
  EXPECT_FALSE(picture_page({2, 4, rgb, 200}, ""));
}

TEST(PicturePage, RefusesAPictureWithoutWidthHeightOrSize) {
  const std::vector<std::uint8_t> rgb(2 * 3);
  PagePicture picture;
  picture.rgb = rgb;
  picture.height = 2;
  picture.width_mm = 10;
  EXPECT_FALSE(picture_page(picture, "")) << "no width";
  picture.width = 2;
  picture.height = PagePicture().height;
  EXPECT_FALSE(picture_page(picture, "")) << "no height";
  picture.height = 1;
  EXPECT_TRUE(picture_page(picture, ""));
  picture.width_mm = PagePicture().width_mm;
  EXPECT_FALSE(picture_page(picture, "")) << "no size on the page";
}

}  // namespace
}  // namespace nazori::print
