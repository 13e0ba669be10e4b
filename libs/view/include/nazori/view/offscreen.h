// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "nazori/base/result.h"

namespace nazori::view {

/// 8-bit RGBA, row 0 at the top.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// An OpenGL 3.3 core context with a framebuffer of its own, through EGL on a surfaceless display: needs no
/// screen. The context is current on the creating thread from creation to destruction, unless another is made
/// meanwhile; destroying one does not affect another one that is current.
class OffscreenContext {
 public:
  /// @return Errc::device with the reason and the Debian package to install.
  [[nodiscard]] static base::Result<std::unique_ptr<OffscreenContext>> create(int width, int height);
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  /// The drawn picture (multisampling resolved). Makes this context current if necessary.
  [[nodiscard]] Picture read() const;

 private:
  struct Inside;
  explicit OffscreenContext(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

/// Writes an 8-bit RGB PNG under a temporary name and renames it.
[[nodiscard]] base::Result<void> save_png(const Picture& picture, const std::filesystem::path& path);
[[nodiscard]] base::Result<Picture> load_picture_png(const std::filesystem::path& path);

}  // namespace nazori::view
