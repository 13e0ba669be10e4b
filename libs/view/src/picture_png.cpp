// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <png.h>

#include <cstddef>
#include <cstdint>

#include "nazori/base/file.h"
#include "nazori/view/offscreen.h"

namespace nazori::view {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{256} << 20;
constexpr png_uint_32 kMaxSide = 16384;

std::size_t pixel_count(const Picture& picture) {
  return static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
}

}  // namespace

base::Result<void> save_png(const Picture& picture, const std::filesystem::path& path) {
  if (picture.width < 1 || picture.height < 1 || picture.rgba.size() != pixel_count(picture) * 4)
    return base::fail(base::Errc::bad_argument, "the picture has no pixels or too few", path.string());
  std::vector<std::uint8_t> rgb;
  rgb.reserve(pixel_count(picture) * 3);
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    rgb.push_back(picture.rgba[i]);
    rgb.push_back(picture.rgba[i + 1]);
    rgb.push_back(picture.rgba[i + 2]);
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t length = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<std::uint8_t> bytes(length);
  if (png_image_write_to_memory(&image, bytes.data(), &length, 0, rgb.data(), 0, nullptr) == 0) {
    const std::string reason = image.message;
    png_image_free(&image);
    return base::fail(base::Errc::io, fmt::format("the picture cannot be coded as PNG: {}", reason),
                      path.string());
  }
  bytes.resize(length);
  return base::write_file(path, bytes);
}

base::Result<Picture> load_picture_png(const std::filesystem::path& path) {
  auto bytes = base::read_file(path, kMaxFileBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes->data(), bytes->size()) == 0) {
    const std::string reason = image.message;
    png_image_free(&image);
    return base::fail(base::Errc::parse, fmt::format("not a PNG picture: {}", reason), path.string());
  }
  if (image.width > kMaxSide || image.height > kMaxSide) {
    const std::string what = fmt::format("the picture has {} x {} pixels", image.width, image.height);
    png_image_free(&image);
    return base::fail(base::Errc::schema, what, path.string(),
                      fmt::format("at most {} a side can be read", kMaxSide));
  }
  image.format = PNG_FORMAT_RGBA;
  Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.rgba.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr) == 0) {
    const std::string reason = image.message;
    png_image_free(&image);
    return base::fail(base::Errc::parse, fmt::format("the PNG picture is damaged: {}", reason),
                      path.string());
  }
  return picture;
}

}  // namespace nazori::view
