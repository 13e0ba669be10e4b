// SPDX-License-Identifier: Apache-2.0
#include "tablet_picture.h"

#include <algorithm>
#include <map>
#include <numbers>

namespace nazori::cli {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// Lines and numbers are designed for a picture of this side and scaled with it.
constexpr double kNominalSide = 800;

}  // namespace

void add_look_options(CLI::App& verb, Look& look) {
  const std::string group = "Picture";
  static const std::map<std::string, view::Style> styles{{"default", view::Style::wood},
                                                         {"wood", view::Style::wood},
                                                         {"slate", view::Style::slate},
                                                         {"classic", view::Style::classic}};
  static const std::map<std::string, view::Theme> themes{{"light", view::Theme::light},
                                                         {"dark", view::Theme::dark}};
  verb.add_option("--size", look.size, "Width and height in pixels, such as 1280x800, or 600 for a square")
      ->capture_default_str()
      ->type_name("WxH")
      ->group(group);
  verb.add_option_function<std::string>(
          "--style", [&look](const std::string& name) { look.style = styles.at(name); },
          "wood, slate or classic (as in 2005)")
      ->check(CLI::IsMember({"default", "wood", "slate", "classic"}, CLI::ignore_case))
      ->default_str("wood")
      ->type_name("STYLE")
      ->group(group);
  verb.add_option_function<std::string>(
          "--theme", [&look](const std::string& name) { look.theme = themes.at(name); },
          "light or dark background")
      ->check(CLI::IsMember({"light", "dark"}, CLI::ignore_case))
      ->default_str("light")
      ->type_name("THEME")
      ->group(group);
  verb.add_option_function<double>(
          "--tilt", [&look](double degrees) { look.camera.tilt = degrees * kDegree; },
          "Tilt in degrees from straight above")
      ->check(within(0, 85))
      ->default_str("0")
      ->type_name("DEGREES")
      ->group(group);
  verb.add_option_function<double>(
          "--azimuth", [&look](double degrees) { look.camera.azimuth = degrees * kDegree; },
          "Rotation of the tablet in degrees")
      ->check(within(-360, 360))
      ->default_str("0")
      ->type_name("DEGREES")
      ->group(group);
  verb.add_option("--zoom", look.camera.zoom, "Zoom factor; 1 fits the tablet into the picture")
      ->check(within(0.2, 20))
      ->capture_default_str()
      ->type_name("FACTOR")
      ->group(group);
}

base::Result<TabletPainter> TabletPainter::create(const Look& look) {
  const auto size = parse_picture_size(look.size);
  if (!size) return tl::unexpected(size.error());
  auto context = view::OffscreenContext::create(size->width, size->height);
  if (!context) return tl::unexpected(std::move(context.error()));
  auto view = view::TabletView::create();
  if (!view) return tl::unexpected(std::move(view.error()));
  (*view)->set_style(look.style);
  (*view)->set_theme(look.theme);
  (*view)->set_camera(look.camera);
  return TabletPainter(*size, std::move(*context), std::move(*view));
}

view::Picture TabletPainter::paint(const tablet::CarvedTablet& tablet, const view::Overlay& overlay) {
  view_->set_height_map(tablet.height_map(), tablet.shape());
  view_->set_strokes(tablet::centre_lines(tablet.lines()));
  view_->set_labels(tablet.labels());
  const double scale = std::max(1.0, std::min(size_.width, size_.height) / kNominalSide);
  view_->draw(size_.width, size_.height, scale, overlay);
  return context_->read();
}

}  // namespace nazori::cli
