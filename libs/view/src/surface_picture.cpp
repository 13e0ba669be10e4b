// SPDX-License-Identifier: Apache-2.0
#include "surface_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <mutex>

#include "exposure.h"
#include "material.h"
#include "nazori/base/bands.h"
#include "projection.h"
#include "relief.h"

namespace nazori::view {
namespace {

constexpr int kShadedSize = 1024;
constexpr int kMaxShadedSize = 2048;
constexpr int kGreyMaxSize = 2048;
/// Ambient and key light; together 1 on the plateau.
constexpr float kAmbient = 0.40F;
constexpr float kKey = 1 - kAmbient;
constexpr glm::vec3 kKeyTint{1.02F, 1.0F, 0.965F};
constexpr glm::vec3 kSkyTint{0.985F, 1.0F, 1.025F};
/// Light between the walls of a groove that sees no sky.
constexpr float kBounce = 0.42F;
/// From this height on the face is drawn as not carved: a thousandth of the depth is not visible.
constexpr float kPlainHeight = 0.9995F;
/// The tablet of MaterialRow.
constexpr float kWidth_m = 0.1F;

/// Runs `work(first, last)` over the rows of a picture on a few threads.
template <class Work>
void in_bands(int rows, const Work& work) {
  const base::Bands bands(rows, 1);
  bands.run([&](int band) { work(bands.first(band), bands.last(band)); });
}

/// 8-bit sRGB of linear values 0..1 through a table.
class GammaCoder {
 public:
  GammaCoder() {
    for (std::size_t i = 0; i < table_.size(); ++i) {
      const float value = static_cast<float>(i) / static_cast<float>(table_.size() - 1);
      table_[i] = static_cast<std::uint8_t>(std::lround(srgb_from_linear(value) * 255));
    }
  }
  [[nodiscard]] std::uint8_t operator()(float linear) const {
    const float held = std::clamp(linear, 0.0F, 1.0F);
    return table_[static_cast<std::size_t>(held * static_cast<float>(table_.size() - 1))];
  }

 private:
  std::array<std::uint8_t, 8192> table_{};
};

const GammaCoder& gamma_coder() {
  static const GammaCoder coder;
  return coder;
}

/// Lights the carved texels of one row after another.
class RowPainter {
 public:
  RowPainter(const Relief& relief, const Exposure& exposure, const geometry::TabletShape& shape,
             const PlainFace& plain)
      : relief_(relief),
        plain_(plain),
        exposure_(exposure, relief.size),
        material_(plain.look.style, plain.look.theme),
        light_(light_direction(plain.look.hand)),
        step_m_(kWidth_m / static_cast<float>(relief.size - 1)),
        depth_m_(kWidth_m * static_cast<float>(shape.depth_m / shape.width_m)),
        points_(static_cast<std::size_t>(relief.size)),
        columns_(points_.x_m.size()),
        heights_(points_.x_m.size()),
        right_(points_.x_m.size()),
        up_(points_.x_m.size()),
        key_(points_.x_m.size()),
        sky_(points_.x_m.size()) {}

  void paint(int row, SurfacePicture& picture) {
    find_carved(row);
    if (points_.count == 0) return;
    const std::size_t first =
        static_cast<std::size_t>(row + plain_.rim) * static_cast<std::size_t>(plain_.size) +
        static_cast<std::size_t>(plain_.rim);
    points_.y_m = kWidth_m / 2 - static_cast<float>(row) * step_m_;
    for (std::size_t i = 0; i < points_.count; ++i) {
      const int column = columns_[i];
      points_.x_m[i] = static_cast<float>(column) * step_m_ - kWidth_m / 2;
      points_.set_grain(i, plain_.grain[first + static_cast<std::size_t>(column)].at(points_.x_m[i]));
    }
    for (std::size_t i = 0; i < points_.count; ++i) {
      points_.z_m[i] = (heights_[i] - 1) * depth_m_;
      points_.carved[i] = 1 - heights_[i];
    }
    material_.colour(points_);
    light(row);
    const GammaCoder& code = gamma_coder();
    for (std::size_t i = 0; i < points_.count; ++i) {
      const std::size_t texel = first + static_cast<std::size_t>(columns_[i]);
      std::uint8_t* rgba = picture.rgba.data() + texel * 4;
      rgba[0] = code(points_.red[i]);
      rgba[1] = code(points_.green[i]);
      rgba[2] = code(points_.blue[i]);
      rgba[3] = code(key_[i]);
      picture.heights[texel] = static_cast<std::uint8_t>(std::lround(heights_[i] * 255));
    }
  }

 private:
  /// Texels that are looked at together first.
  static constexpr int kBlock = 32;
  /// Where all are this high neither their heights nor their slopes are carved.
  static constexpr float kLevelHeight = (1 + kPlainHeight) / 2;

  /// The texels that lie lower than the plateau or beside it, and their slopes.
  void find_carved(int row) {
    const int last = relief_.size - 1;
    const float* here =
        &relief_.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(relief_.size)];
    const float* above = row > 0 ? here - relief_.size : here;
    const float* below = row < last ? here + relief_.size : here;
    std::size_t count = 0;
    const auto consider = [&](int column, int left, int right) {
      const float height = here[column];
      const float rise_right = here[right] - here[left];
      const float rise_up = above[column] - below[column];
      columns_[count] = column;
      heights_[count] = height;
      right_[count] = rise_right;
      up_[count] = rise_up;
      const bool plain =
          height >= kPlainHeight && std::abs(rise_right) + std::abs(rise_up) < 1 - kPlainHeight;
      // The next texel takes the place of a plain one.
      count += plain ? 0 : 1;
    };
    for (int first = 0; first <= last; first += kBlock) {
      const int end = std::min(first + kBlock, last + 1);
      const int from = std::max(first - 1, 0);
      const int to = std::min(end + 1, last + 1);
      int low = 0;
      for (int i = from; i < to; ++i) low |= static_cast<int>(here[i] < kLevelHeight);
      for (int i = first; i < end; ++i)
        low |= static_cast<int>(above[i] < kLevelHeight) | static_cast<int>(below[i] < kLevelHeight);
      if (low == 0) continue;
      for (int column = first; column < end; ++column)
        consider(column, std::max(column - 1, 0), std::min(column + 1, last));
    }
    points_.count = count;
  }

  /// Turns the reflectance of the points into what is seen of it, and `key_` into the light that falls there,
  /// over kLightRange.
  void light(int row) {
    exposure_.set_row(row);
    for (std::size_t i = 0; i < points_.count; ++i) {
      const Exposed exposed = exposure_.at(columns_[i]);
      key_[i] = exposed.key;
      sky_[i] = exposed.sky;
    }
    const float slope = depth_m_ / (2 * step_m_);
    for (std::size_t i = 0; i < points_.count; ++i) {
      const float across = -right_[i] * slope;
      const float along = -up_[i] * slope;
      const float facing =
          (across * light_.x + along * light_.y + light_.z) / std::sqrt(across * across + along * along + 1);
      const float lit = kKey * key_[i] * std::max(facing, 0.0F) / light_.z;
      const float ambient = kAmbient * sky_[i];
      // Light that reaches a deep place was reflected by the walls and has their colour.
      const float bounce = (1 - sky_[i]) * kBounce;
      const auto seen = [&](float tone, float key_tint, float sky_tint) {
        return tone * (key_tint * lit + sky_tint * ambient + tone * bounce);
      };
      points_.red[i] = seen(points_.red[i], kKeyTint.x, kSkyTint.x);
      points_.green[i] = seen(points_.green[i], kKeyTint.y, kSkyTint.y);
      points_.blue[i] = seen(points_.blue[i], kKeyTint.z, kSkyTint.z);
      key_[i] = (lit + ambient) / kLightRange;
    }
  }

  const Relief& relief_;
  const PlainFace& plain_;
  ExposureRow exposure_;
  Material material_;
  glm::vec3 light_;
  float step_m_;
  float depth_m_;
  MaterialRow points_;
  std::vector<int> columns_;
  std::vector<float> heights_;
  std::vector<float> right_;  ///< how much higher the texel to the right is than that to the left
  std::vector<float> up_;     ///< and the texel above than that below
  std::vector<float> key_;
  std::vector<float> sky_;
};

}  // namespace

glm::vec3 light_direction(Hand hand) {
  return glm::normalize(glm::vec3(hand == Hand::right ? -0.50F : 0.50F, 0.56F, 0.86F));
}

float open_light(glm::vec3 normal, Hand hand) {
  const glm::vec3 light = light_direction(hand);
  // The table reflects light onto the sides.
  return kAmbient * (0.80F + 0.20F * normal.z) + 0.12F * (1 - normal.z) +
         kKey * std::max(glm::dot(normal, light), 0.0F) / light.z;
}

int shaded_size(int map_size) { return std::clamp(map_size, kShadedSize, kMaxShadedSize); }

PlainFace make_plain_face(const Look& look, int samples) {
  PlainFace plain;
  plain.look = look;
  plain.rim = static_cast<int>(std::lround(samples * kRimFraction));
  plain.size = samples + 2 * plain.rim;
  const std::size_t texels = static_cast<std::size_t>(plain.size) * static_cast<std::size_t>(plain.size);
  plain.rgba.resize(texels * 4);
  plain.grain.resize(texels);
  const Material material(look.style, look.theme);
  const GammaCoder& code = gamma_coder();
  const std::uint8_t light = code(1 / kLightRange);
  const glm::vec3 tint = kKeyTint * kKey + kSkyTint * kAmbient;
  const float step_m = kWidth_m / static_cast<float>(samples - 1);
  const auto place = [&](int texel) { return static_cast<float>(texel - plain.rim) * step_m - kWidth_m / 2; };
  in_bands(plain.size, [&](int first, int last) {
    GrainLine line(look.style, place(0), place(plain.size - 1));
    MaterialRow row(static_cast<std::size_t>(plain.size));
    row.count = row.x_m.size();
    for (std::size_t i = 0; i < row.count; ++i) row.x_m[i] = place(static_cast<int>(i));
    std::size_t out = static_cast<std::size_t>(first) * row.count;
    for (int y = first; y < last; ++y) {
      row.y_m = -place(y);
      line.set_y(row.y_m);
      for (std::size_t i = 0; i < row.count; ++i) {
        const Grain grain = line.at(row.x_m[i]);
        row.set_grain(i, grain);
        plain.grain[out + i] = {grain, row.x_m[i]};
      }
      material.colour(row);
      for (std::size_t i = 0; i < row.count; ++i, ++out) {
        plain.rgba[out * 4] = code(row.red[i] * tint.x);
        plain.rgba[out * 4 + 1] = code(row.green[i] * tint.y);
        plain.rgba[out * 4 + 2] = code(row.blue[i] * tint.z);
        plain.rgba[out * 4 + 3] = light;
      }
    }
  });
  return plain;
}

std::shared_ptr<const PlainFace> shared_plain_face(const Look& look, int samples) {
  static std::mutex making;
  static std::array<std::shared_ptr<const PlainFace>, 2> kept;
  const std::lock_guard lock(making);
  const auto is_it = [&](const auto& face) {
    return face && face->look == look && face->size == samples + 2 * face->rim;
  };
  const auto found = std::find_if(kept.begin(), kept.end(), is_it);
  if (found != kept.end()) {
    std::rotate(kept.begin(), found, found + 1);
  } else {
    kept = {std::make_shared<const PlainFace>(make_plain_face(look, samples)), kept[0]};
  }
  return kept[0];
}

SurfacePicture lit_picture(const surface::HeightMap& map, const geometry::TabletShape& shape,
                           const PlainFace& plain) {
  const Relief relief = resampled(map, plain.size - 2 * plain.rim);
  const Exposure exposure = make_exposure(relief, shape, plain.look.hand);
  SurfacePicture picture{plain.size, plain.rim, plain.rgba, {}};
  picture.heights.assign(picture.rgba.size() / 4, 255);
  in_bands(relief.size, [&](int first, int last) {
    RowPainter painter(relief, exposure, shape, plain);
    for (int row = first; row < last; ++row) painter.paint(row, picture);
  });
  return picture;
}

SurfacePicture grey_picture(const surface::HeightMap& map) {
  const Relief relief = resampled(map, std::min(map.size(), kGreyMaxSize));
  SurfacePicture picture;
  picture.size = relief.size;
  picture.rgba.reserve(relief.heights.size() * 4);
  picture.heights.reserve(relief.heights.size());
  for (const float height : relief.heights) {
    const auto grey = static_cast<std::uint8_t>(std::lround(height * 255));
    picture.rgba.insert(picture.rgba.end(), {grey, grey, grey, 255});
    picture.heights.push_back(grey);
  }
  return picture;
}

}  // namespace nazori::view
