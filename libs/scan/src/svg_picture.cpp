// SPDX-License-Identifier: Apache-2.0
#include "svg_picture.h"

#include <librsvg/rsvg.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace nazori::scan {
namespace {

constexpr std::size_t kHead = 4096;  ///< of a file, where its root is looked for

template <auto destroy>
struct Destroy {
  template <class T>
  void operator()(T* one) const {
    destroy(one);
  }
};
using Handle = std::unique_ptr<RsvgHandle, Destroy<g_object_unref>>;
using Surface = std::unique_ptr<cairo_surface_t, Destroy<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Destroy<cairo_destroy>>;

/// The message of an error, which is freed.
std::string taken(GError* error) {
  std::string text = error != nullptr ? error->message : "it has nothing to draw";
  g_clear_error(&error);
  std::ranges::replace(text, '\n', ' ');
  return text;
}

/// Width over height; 1 where the drawing does not say.
double shape_of(RsvgHandle* handle) {
  double width = 0;
  double height = 0;
  if (rsvg_handle_get_intrinsic_size_in_pixels(handle, &width, &height) == FALSE) {
    gboolean has_width = FALSE;
    gboolean has_height = FALSE;
    gboolean has_box = FALSE;
    RsvgLength of_width;
    RsvgLength of_height;
    RsvgRectangle box{};
    rsvg_handle_get_intrinsic_dimensions(handle, &has_width, &of_width, &has_height, &of_height, &has_box,
                                         &box);
    if (has_box != FALSE) {
      width = box.width;
      height = box.height;
    }
  }
  const bool is_known = std::isfinite(width) && std::isfinite(height) && width > 0 && height > 0;
  return is_known ? width / height : 1;
}

}  // namespace

bool is_svg(std::span<const std::uint8_t> bytes) {
  const std::string_view head(reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), kHead));
  const std::size_t first = head.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  return first != std::string_view::npos && head[first] == '<' && head.find("<svg") != std::string_view::npos;
}

base::Result<Photo> parse_svg(std::span<const std::uint8_t> bytes) {
  const auto refuse = [](const std::string& why) {
    return base::fail(base::Errc::parse, "is not a drawing that can be read: " + why);
  };
  GError* error = nullptr;
  const Handle handle(rsvg_handle_new_from_data(bytes.data(), bytes.size(), &error));
  if (!handle) return refuse(taken(error));
  // A line is no picture.
  const double shape = std::clamp(shape_of(handle.get()), 1.0 / 16, 16.0);
  Photo photo;
  photo.width = static_cast<int>(std::lround(kSvgPixels * std::min(1.0, shape)));
  photo.height = static_cast<int>(std::lround(kSvgPixels / std::max(1.0, shape)));
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, photo.width, photo.height));
  const Context context(cairo_create(surface.get()));
  cairo_set_source_rgb(context.get(), 1, 1, 1);
  cairo_paint(context.get());
  const RsvgRectangle paper{0, 0, static_cast<double>(photo.width), static_cast<double>(photo.height)};
  if (rsvg_handle_render_document(handle.get(), context.get(), &paper, &error) == FALSE)
    return refuse(taken(error));
  cairo_surface_flush(surface.get());
  const unsigned char* const rows = cairo_image_surface_get_data(surface.get());
  if (rows == nullptr || cairo_status(context.get()) != CAIRO_STATUS_SUCCESS)
    return refuse(cairo_status_to_string(cairo_status(context.get())));
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  photo.grey.reserve(static_cast<std::size_t>(photo.width) * static_cast<std::size_t>(photo.height));
  for (int y = 0; y < photo.height; ++y) {
    const auto* const row =
        reinterpret_cast<const std::uint32_t*>(rows + static_cast<std::size_t>(y) * stride);
    for (int x = 0; x < photo.width; ++x) {
      const std::uint32_t rgb = row[x];
      // The brightness of Rec. 601, as JPEG has it.
      const double grey = 0.299 * (rgb >> 16U & 0xFFU) + 0.587 * (rgb >> 8U & 0xFFU) + 0.114 * (rgb & 0xFFU);
      photo.grey.push_back(static_cast<std::uint8_t>(std::lround(grey)));
    }
  }
  return photo;
}

}  // namespace nazori::scan
