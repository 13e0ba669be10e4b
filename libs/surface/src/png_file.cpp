// SPDX-License-Identifier: Apache-2.0
#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>

#include "levels.h"
#include "nazori/base/file.h"
#include "nazori/surface/colour_picture.h"
#include "nazori/surface/height_map.h"

namespace nazori::surface {
namespace {

// 16-bit samples of the largest map and room for headers and text.
constexpr std::size_t kMaxFileBytes =
    std::size_t{2} * HeightMap::kMaxSize * HeightMap::kMaxSize + (1U << 20U);
// Deflate packs at most 1032 bytes into one: a file whose header requires more is truncated.
constexpr std::size_t kMostPixelBytesPerFileByte = 1040;
constexpr png_uint_32 kSide = HeightMap::kMaxSize;

/// The state of libpng for one picture. Its longjmp skips destructors, so everything that owns memory lives
/// in the callers of guarded().
struct Exchange {
  const std::uint8_t* next = nullptr;
  std::size_t left = 0;
  std::vector<std::uint8_t>* sink = nullptr;
  bool sink_is_full = false;
  char message[160] = {};
};

Exchange& exchange_of(png_structp png) { return *static_cast<Exchange*>(png_get_error_ptr(png)); }

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  Exchange& exchange = exchange_of(png);
  std::snprintf(exchange.message, sizeof exchange.message, "%s", message);
  png_longjmp(png, 1);
}

void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}

void on_read(png_structp png, png_bytep out, std::size_t count) {
  Exchange& exchange = exchange_of(png);
  if (count > exchange.left) png_error(png, "the file ends too early");
  std::memcpy(out, exchange.next, count);
  exchange.next += count;
  exchange.left -= count;
}

/// Appends without letting bad_alloc cross libpng's C frames.
bool append(std::vector<std::uint8_t>& sink, const std::uint8_t* data, std::size_t count) noexcept {
  try {
    sink.insert(sink.end(), data, data + count);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void on_write(png_structp png, png_bytep data, std::size_t count) {
  if (!append(*exchange_of(png).sink, data, count)) png_error(png, "there is not enough memory");
}

void on_flush(png_structp /*png*/) {}

/// Catches libpng's errors: runs `work`, which must have no variable with a destructor.
/// @return false where libpng failed; Exchange::message says why.
template <class Work>
bool guarded(png_structp png, const Work& work) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp)
  work();
  return true;
}

/// Owns libpng's reading state.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : exchange_{bytes.data(), bytes.size()} {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &exchange_, on_error, on_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  [[nodiscard]] bool is_ready() const { return info_ != nullptr; }
  [[nodiscard]] png_structp png() const { return png_; }
  [[nodiscard]] png_infop info() const { return info_; }
  [[nodiscard]] const char* message() const { return exchange_.message; }

 private:
  Exchange exchange_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

/// Owns libpng's writing state.
class Writer {
 public:
  explicit Writer(std::vector<std::uint8_t>& sink) {
    exchange_.sink = &sink;
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &exchange_, on_error, on_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png_, &info_); }
  [[nodiscard]] bool is_ready() const { return info_ != nullptr; }
  [[nodiscard]] png_structp png() const { return png_; }
  [[nodiscard]] png_infop info() const { return info_; }

 private:
  Exchange exchange_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

/// The content of a picture's header.
struct Head {
  png_uint_32 width = 0;
  png_uint_32 height = 0;
  int depth = 0;
  int colour = 0;
  int interlace = 0;
};

base::Error damaged(const Reader& reader) {
  return {base::Errc::parse, std::string("is not a whole PNG picture: ") + reader.message(), {}, {}};
}

/// Refuses pictures that are not height maps, from the header alone.
base::Result<void> check(const Head& head, std::size_t file_bytes) {
  if (head.colour != PNG_COLOR_TYPE_GRAY) {
    const bool alpha = head.colour == PNG_COLOR_TYPE_GRAY_ALPHA;
    return base::fail(
        base::Errc::schema,
        alpha ? "is a picture with transparency, a height map has none" : "is a picture in colour", {},
        "save it as greyscale without transparency");
  }
  const std::string size = std::to_string(head.width) + " x " + std::to_string(head.height);
  if (head.width != head.height)
    return base::fail(base::Errc::schema, "is " + size + ", a height map is square");
  if (head.width < HeightMap::kMinSize || head.width > kSide) {
    return base::fail(base::Errc::schema, "is " + size, {},
                      "a height map has " + std::to_string(HeightMap::kMinSize) + " to " +
                          std::to_string(HeightMap::kMaxSize) + " samples a side");
  }
  const std::size_t pixel_bytes =
      std::size_t{head.width} * head.height / 8 * static_cast<unsigned>(head.depth);
  if (pixel_bytes / kMostPixelBytesPerFileByte > file_bytes)
    return base::fail(base::Errc::parse, "is not a whole PNG picture: the file ends too early");
  return {};
}

template <class Pixel>
void to_heights(const std::vector<std::uint8_t>& row, float* heights, std::size_t count);

template <>
void to_heights<std::uint8_t>(const std::vector<std::uint8_t>& row, float* heights, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) heights[i] = static_cast<float>(row[i]) / 255.0F;
}

template <>
void to_heights<std::uint16_t>(const std::vector<std::uint8_t>& row, float* heights, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    heights[i] = static_cast<float>(row[2 * i] << 8U | row[2 * i + 1]) / 65535.0F;
}

void to_heights(const std::vector<std::uint8_t>& row, bool wide, std::span<float> heights) {
  if (wide)
    to_heights<std::uint16_t>(row, heights.data(), heights.size());
  else
    to_heights<std::uint8_t>(row, heights.data(), heights.size());
}

base::Result<HeightMap> read_picture(std::span<const std::uint8_t> bytes) {
  Reader reader(bytes);
  if (!reader.is_ready()) return base::fail(base::Errc::io, "there is not enough memory");
  png_structp png = reader.png();
  png_infop info = reader.info();
  Head head;
  const bool has_head = guarded(png, [&] {
    png_set_read_fn(png, png_get_error_ptr(png), on_read);
    // A side over the limit of a map must reach check(), which reports it; beyond that libpng's own limit
    // applies.
    png_set_chunk_malloc_max(png, 1U << 20U);
    png_set_chunk_cache_max(png, 64);
    png_read_info(png, info);
    png_get_IHDR(png, info, &head.width, &head.height, &head.depth, &head.colour, &head.interlace, nullptr,
                 nullptr);
  });
  if (!has_head) return tl::unexpected(damaged(reader));
  if (auto fit = check(head, bytes.size()); !fit) return tl::unexpected(std::move(fit).error());

  auto map = HeightMap::create(static_cast<int>(head.width));
  if (!map) return map;
  const std::size_t side = head.width;
  const bool wide = head.depth == 16;
  const std::size_t row_bytes = side * (wide ? 2U : 1U);
  const bool interlaced = head.interlace != PNG_INTERLACE_NONE;
  // An interlaced picture is complete only after its last pass, so all its rows are kept until then.
  std::vector<std::uint8_t> pixels(interlaced ? row_bytes * side : row_bytes);
  std::vector<std::uint8_t> row(interlaced ? row_bytes : 0);
  const bool has_pixels = guarded(png, [&] {
    png_set_expand_gray_1_2_4_to_8(png);
    const int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    for (int pass = 0; pass < passes; ++pass) {
      for (std::size_t y = 0; y < side; ++y) {
        png_read_row(png, pixels.data() + (interlaced ? y * row_bytes : 0), nullptr);
        if (!interlaced) to_heights(pixels, wide, map->samples().subspan(y * side, side));
      }
    }
    png_read_end(png, nullptr);
  });
  if (!has_pixels) return tl::unexpected(damaged(reader));
  for (std::size_t y = 0; interlaced && y < side; ++y) {
    std::memcpy(row.data(), pixels.data() + y * row_bytes, row_bytes);
    to_heights(row, wide, map->samples().subspan(y * side, side));
  }
  return map;
}

}  // namespace

base::Result<HeightMap> parse_png(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return base::fail(base::Errc::parse, "is empty", {}, "give a greyscale PNG picture");
  try {
    return read_picture(bytes);
  } catch (const std::bad_alloc&) {
    return base::fail(base::Errc::io, "there is not enough memory for the picture");
  }
}

std::vector<std::uint8_t> to_png(const HeightMap& map, PngDepth depth) {
  std::vector<std::uint8_t> bytes;
  if (!map.is_loaded()) return bytes;
  Writer writer(bytes);
  if (!writer.is_ready()) return bytes;
  png_structp png = writer.png();
  const std::size_t side = static_cast<std::size_t>(map.size());
  const bool wide = depth == PngDepth::bits_16;
  std::vector<std::uint8_t> row(side * (wide ? 2U : 1U));
  const bool done = guarded(png, [&] {
    png_set_write_fn(png, png_get_error_ptr(png), on_write, on_flush);
    const auto n = static_cast<png_uint_32>(side);
    png_set_IHDR(png, writer.info(), n, n, wide ? 16 : 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, writer.info());
    for (std::size_t y = 0; y < side; ++y) {
      const std::span<const float> heights = map.samples().subspan(y * side, side);
      for (std::size_t x = 0; x < side; ++x) {
        if (wide) {
          const unsigned level = level_of(heights[x], 65535.0F);
          row[2 * x] = static_cast<std::uint8_t>(level >> 8U);
          row[2 * x + 1] = static_cast<std::uint8_t>(level & 0xFFU);
        } else {
          row[x] = static_cast<std::uint8_t>(level_of(heights[x], 255.0F));
        }
      }
      png_write_row(png, row.data());
    }
    png_write_end(png, nullptr);
  });
  if (!done) bytes.clear();
  return bytes;
}

base::Result<HeightMap> load_png(const std::filesystem::path& path) {
  const auto bytes = base::read_file(path, kMaxFileBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto map = parse_png(*bytes);
  if (map) return map;
  base::Error error = std::move(map).error();
  error.where = path.string();
  return tl::unexpected(std::move(error));
}

base::Result<void> save_png(const HeightMap& map, const std::filesystem::path& path, PngDepth depth) {
  if (!map.is_loaded())
    return base::fail(base::Errc::bad_argument, "there is no height map to save", path.string());
  const std::vector<std::uint8_t> bytes = to_png(map, depth);
  if (bytes.empty()) return base::fail(base::Errc::io, "there is not enough memory to write", path.string());
  return base::write_file(path, bytes);
}

std::vector<std::uint8_t> to_png(const ColourPicture& picture) {
  std::vector<std::uint8_t> bytes;
  if (picture.width < 1 || picture.height < 1) return bytes;
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(picture.width);
  if (picture.rgb.size() != row_bytes * static_cast<std::size_t>(picture.height)) return bytes;
  Writer writer(bytes);
  if (!writer.is_ready()) return bytes;
  png_structp png = writer.png();
  const bool done = guarded(png, [&] {
    png_set_write_fn(png, png_get_error_ptr(png), on_write, on_flush);
    png_set_IHDR(png, writer.info(), static_cast<png_uint_32>(picture.width),
                 static_cast<png_uint_32>(picture.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, writer.info(), PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, writer.info());
    for (int y = 0; y < picture.height; ++y)
      png_write_row(png, picture.rgb.data() + static_cast<std::size_t>(y) * row_bytes);
    png_write_end(png, nullptr);
  });
  if (!done) bytes.clear();
  return bytes;
}

base::Result<void> save_png(const ColourPicture& picture, const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = to_png(picture);
  if (bytes.empty())
    return base::fail(base::Errc::bad_argument, "there is no picture to save", path.string());
  return base::write_file(path, bytes);
}

}  // namespace nazori::surface
