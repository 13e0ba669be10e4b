// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <string_view>

#include "nazori/base/result.h"
#include "nazori/carving/carve.h"
#include "nazori/devices/simulated_device.h"

namespace nazori::cli {

/// A number within lowest..highest; nothing else, also not NaN.
[[nodiscard]] CLI::Validator within(double lowest, double highest);

/// --width, --depth, --cross-section, --no-endings. `brush` must outlive `verb`.
void add_brush_options(CLI::App& verb, carving::Brush& brush);

/// --database. `path` stays empty if the option is not given: KanjiDatabase::locate() then decides.
void add_database_option(CLI::App& verb, std::string& path);

/// --device: one of the simulated presets. `hardware` must outlive `verb`.
void add_device_option(CLI::App& verb, devices::SimulatedHardware& hardware, const std::string& description);

/// --tip-radius-mm: the ball at the tip of the stylus. `radius_m` must outlive `verb`.
void add_tip_option(CLI::App& verb, double& radius_m);

/// Width and height of a picture.
struct PictureSize {
  int width = 0;
  int height = 0;
};
/// "1280x800", or "600" for a square one; 16..8192 each.
[[nodiscard]] base::Result<PictureSize> parse_picture_size(std::string_view text);

/// Whether the name of a file ends with `extension` (".png"), in upper or lower case.
[[nodiscard]] bool has_extension(const std::filesystem::path& path, std::string_view extension);

}  // namespace nazori::cli
