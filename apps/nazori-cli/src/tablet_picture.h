// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "nazori/base/result.h"
#include "nazori/tablet/carved_tablet.h"
#include "nazori/view/offscreen.h"
#include "nazori/view/tablet_view.h"
#include "options.h"

namespace nazori::cli {

/// The look of a picture of a tablet.
struct Look {
  std::string size = "800x800";
  view::Style style = view::Style::wood;
  view::Theme theme = view::Theme::light;
  view::Camera camera;
};

/// --size, --style, --theme, --tilt, --azimuth, --zoom. `look` must outlive `verb`.
void add_look_options(CLI::App& verb, Look& look);

/// Draws tablets without a screen, one after the other, all of one size and look.
/// Thread rules: one thread.
class TabletPainter {
 public:
  /// @return Errc::bad_argument for the size, Errc::device without OpenGL.
  [[nodiscard]] static base::Result<TabletPainter> create(const Look& look);

  [[nodiscard]] view::Picture paint(const tablet::CarvedTablet& tablet, const view::Overlay& overlay);

 private:
  TabletPainter(PictureSize size, std::unique_ptr<view::OffscreenContext> context,
                std::unique_ptr<view::TabletView> view)
      : size_(size), context_(std::move(context)), view_(std::move(view)) {}

  PictureSize size_;
  std::unique_ptr<view::OffscreenContext> context_;
  std::unique_ptr<view::TabletView> view_;  // must be destroyed before its context
};

}  // namespace nazori::cli
