// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "nazori/scan/sheet.h"

namespace nazori::scan {

/// A drawn photograph: nothing in it is read by other programs.
class Drawn {
 public:
  Drawn(int width, int height, std::uint8_t brightness) : photo_{width, height, {}} {
    photo_.grey.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), brightness);
  }
  /// An ellipse with soft edges, its axes level and upright.
  void ellipse(PhotoPoint centre, double rx, double ry, std::uint8_t brightness = 20) {
    for (int y = static_cast<int>(centre.y - ry) - 2; y <= static_cast<int>(centre.y + ry) + 2; ++y)
      for (int x = static_cast<int>(centre.x - rx) - 2; x <= static_cast<int>(centre.x + rx) + 2; ++x) {
        if (x < 0 || y < 0 || x >= photo_.width || y >= photo_.height) continue;
        int inside = 0;
        for (int part = 0; part < 64; ++part) {
          const double u = (x + (part % 8 + 0.5) / 8 - 0.5 - centre.x) / rx;
          const double v = (y + (part / 8 + 0.5) / 8 - 0.5 - centre.y) / ry;
          inside += u * u + v * v <= 1 ? 1 : 0;
        }
        std::uint8_t& grey = at(x, y);
        grey = static_cast<std::uint8_t>(grey + (brightness - grey) * inside / 64);
      }
  }
  void disc(PhotoPoint centre, double radius, std::uint8_t brightness = 20) {
    ellipse(centre, radius, radius, brightness);
  }
  /// Pixels from a corner to the other, with both.
  void block(int left, int top, int right, int bottom, std::uint8_t brightness) {
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) at(x, y) = brightness;
  }
  std::uint8_t& at(int x, int y) {
    return photo_.grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(photo_.width) +
                       static_cast<std::size_t>(x)];
  }
  [[nodiscard]] const Photo& photo() const { return photo_; }

 private:
  Photo photo_;
};

inline void expect_near(PhotoPoint p, PhotoPoint q, double near) {
  EXPECT_NEAR(p.x, q.x, near);
  EXPECT_NEAR(p.y, q.y, near);
}

}  // namespace nazori::scan
