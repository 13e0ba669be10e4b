// SPDX-License-Identifier: Apache-2.0
#include "options.h"
#include "nazori/surface/ball_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

namespace nazori::cli {
namespace {

using carving::CrossSection;

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

char small_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

CLI::Validator within(double lowest, double highest) {
  const std::string range = fmt::format("{}..{}", lowest, highest);
  return {[lowest, highest, range](std::string& text) {
            double value = 0;
            if (!CLI::detail::lexical_cast(text, value)) return fmt::format("'{}' is not a number", text);
            return value >= lowest && value <= highest
                       ? std::string()
                       : fmt::format("{} is not in the range {}", text, range);
          },
          range};
}

void add_brush_options(CLI::App& verb, carving::Brush& brush) {
  const std::string group = "Brush";
  verb.add_option_function<double>(
          "--width",
          [&brush](double width) {
            brush.width = width;
            brush.fit = false;
          },
          "Groove width in units of 1/109 of the tablet's side (default: 7, less where strokes are close)")
      ->check(within(0.5, 40))
      ->type_name("UNITS")
      ->group(group);
  verb.add_option("--depth", brush.depth, "Groove depth as a fraction of the tablet's depth")
      ->check(within(0.01, 1))
      ->capture_default_str()
      ->type_name("FRACTION")
      ->group(group);
  static const std::map<std::string, CrossSection> sections{
      {"rounded", CrossSection::rounded}, {"v", CrossSection::v_shaped}, {"flat", CrossSection::flat_bottom}};
  verb.add_option_function<std::string>(
          "--cross-section", [&brush](const std::string& name) { brush.cross_section = sections.at(name); },
          "Cross-section of the groove: rounded, v or flat")
      ->check(CLI::IsMember({"rounded", "v", "flat"}, CLI::ignore_case))
      ->default_str("rounded")
      ->type_name("SHAPE")
      ->group(group);
  verb.add_flag_callback(
          "--no-endings", [&brush] { brush.endings = false; },
          "Carve strokes without endings (no stop, hook or sweep)")
      ->group(group);
}

void add_database_option(CLI::App& verb, std::string& path) {
  verb.add_option("--database", path, "Kanji database to use (see: nazori-cli database path)")
      ->type_name("FILE");
}

void add_device_option(CLI::App& verb, devices::SimulatedHardware& hardware, const std::string& description) {
  static const std::map<std::string, devices::SimulatedHardware> devices_by_name{
      {"touch", devices::SimulatedHardware::touch()},
      {"touch-x", devices::SimulatedHardware::touch_x()},
      {"falcon", devices::SimulatedHardware::falcon()},
      {"omega3", devices::SimulatedHardware::omega_3()},
      {"inverse3", devices::SimulatedHardware::inverse3()}};
  verb.add_option_function<std::string>(
          "--device", [&hardware](const std::string& name) { hardware = devices_by_name.at(name); },
          description + ": touch, touch-x, falcon, omega3 or inverse3")
      ->check(CLI::IsMember({"touch", "touch-x", "falcon", "omega3", "inverse3"}))
      ->default_str("touch")
      ->type_name("DEVICE");
}

void add_tip_option(CLI::App& verb, double& radius_m) {
  verb.add_option_function<double>(
          "--tip-radius-mm", [&radius_m](double mm) { radius_m = mm / 1000; },
          "Radius of the ball at the tip of the stylus; 0: a point")
      ->check(within(0, 1000 * surface::kLargestBall_m))
      ->default_str("0")
      ->type_name("MM");
}

base::Result<PictureSize> parse_picture_size(std::string_view text) {
  const std::size_t cross = text.find('x');
  const auto width = whole_number(text.substr(0, cross));
  const auto height = cross == std::string_view::npos ? width : whole_number(text.substr(cross + 1));
  const auto fits = [](std::optional<int> n) { return n && *n >= 16 && *n <= 8192; };
  if (!fits(width) || !fits(height)) {
    return base::fail(base::Errc::bad_argument, fmt::format("'{}' is not a valid picture size", text),
                      "--size", "give WIDTHxHEIGHT such as 1280x800, each 16..8192");
  }
  return PictureSize{*width, *height};
}

bool has_extension(const std::filesystem::path& path, std::string_view extension) {
  std::string own = path.extension().string();
  std::transform(own.begin(), own.end(), own.begin(), small_letter);
  return own == extension;
}

}  // namespace nazori::cli
