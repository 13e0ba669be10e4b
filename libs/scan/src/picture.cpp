// SPDX-License-Identifier: Apache-2.0
#include "nazori/scan/picture.h"

#include <png.h>
#include <turbojpeg.h>

#include <algorithm>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "nazori/base/file.h"
#include "orientation.h"
#include "svg_picture.h"

namespace nazori::scan {
namespace {

constexpr std::size_t kMostFileBytes = 256U << 20U;

base::Result<Photo> room_for(long width, long height) {
  if (width < kFewestPixels || height < kFewestPixels || width > kMostPixels || height > kMostPixels ||
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > kMostPhotoPixels)
    return base::fail(base::Errc::schema,
                      "is " + std::to_string(width) + " x " + std::to_string(height) + " pixels", {},
                      "scan the page with 100 to 300 dots per inch");
  Photo photo;
  photo.width = static_cast<int>(width);
  photo.height = static_cast<int>(height);
  photo.grey.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return photo;
}

base::Result<Photo> parse_png(std::span<const std::uint8_t> bytes) {
  struct Image : png_image {
    Image() : png_image{} { version = PNG_IMAGE_VERSION; }
    Image(const Image&) = delete;
    Image& operator=(const Image&) = delete;
    ~Image() { png_image_free(this); }
  } image;
  const auto damaged = [&] {
    return base::fail(base::Errc::parse, std::string("is not a whole PNG picture: ") + image.message);
  };
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) return damaged();
  auto photo = room_for(static_cast<long>(image.width), static_cast<long>(image.height));
  if (!photo) return photo;
  image.format = PNG_FORMAT_GRAY;
  const png_color white{255, 255, 255};
  if (png_image_finish_read(&image, &white, photo->grey.data(), 0, nullptr) == 0) return damaged();
  return photo;
}

base::Result<Photo> parse_jpeg(std::span<const std::uint8_t> bytes) {
  const std::unique_ptr<void, int (*)(tjhandle)> reader(tjInitDecompress(), &tjDestroy);
  if (!reader) return base::fail(base::Errc::io, "there is not enough memory");
  const auto damaged = [&] {
    return base::fail(base::Errc::parse,
                      std::string("is not a whole JPEG picture: ") + tjGetErrorStr2(reader.get()));
  };
  int width = 0;
  int height = 0;
  int sampling = 0;
  int colours = 0;
  const auto size = static_cast<unsigned long>(bytes.size());
  if (tjDecompressHeader3(reader.get(), bytes.data(), size, &width, &height, &sampling, &colours) != 0)
    return damaged();
  // A header that is cut off gives no size, and no error.
  if (width == 0 || height == 0) return base::fail(base::Errc::parse, "is not a whole JPEG picture");
  auto photo = room_for(width, height);
  if (!photo) return photo;
  if (colours == TJCS_CMYK || colours == TJCS_YCCK)
    return base::fail(base::Errc::schema, "is a JPEG picture in the colours of printing", {},
                      "save it in RGB");
  if (tjDecompress2(reader.get(), bytes.data(), size, photo->grey.data(), width, 0, height, TJPF_GRAY,
                    TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS) != 0)
    return damaged();
  return upright(*std::move(photo), exif_orientation(bytes));
}

}  // namespace

float Photo::sample(double x, double y) const {
  const double fx = std::clamp(x, 0.0, width - 1.0);
  const double fy = std::clamp(y, 0.0, height - 1.0);
  const int column = std::min(static_cast<int>(fx), width - 2);
  const int row = std::min(static_cast<int>(fy), height - 2);
  const auto u = static_cast<float>(fx - column);
  const auto v = static_cast<float>(fy - row);
  const float upper =
      static_cast<float>(at(column, row)) * (1 - u) + static_cast<float>(at(column + 1, row)) * u;
  const float lower =
      static_cast<float>(at(column, row + 1)) * (1 - u) + static_cast<float>(at(column + 1, row + 1)) * u;
  return upper * (1 - v) + lower * v;
}

base::Result<Photo> parse_photo(std::span<const std::uint8_t> bytes) {
  try {
    if (bytes.size() >= 8 && bytes[0] == 0x89 && bytes[1] == 'P') return parse_png(bytes);
    if (bytes.size() >= 4 && bytes[0] == 0xFF && bytes[1] == 0xD8) return parse_jpeg(bytes);
    if (is_svg(bytes)) return parse_svg(bytes);
  } catch (const std::bad_alloc&) {
    return base::fail(base::Errc::io, "there is not enough memory for the picture");
  }
  return base::fail(base::Errc::parse, "is neither a PNG nor a JPEG picture, nor a drawing in SVG", {},
                    "save the photograph as PNG or JPEG");
}

base::Result<Photo> load_photo(const std::filesystem::path& path) {
  const auto bytes = base::read_file(path, kMostFileBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto photo = parse_photo(*bytes);
  if (photo) return photo;
  base::Error error = std::move(photo).error();
  error.where = path.string();
  return tl::unexpected(std::move(error));
}

}  // namespace nazori::scan
