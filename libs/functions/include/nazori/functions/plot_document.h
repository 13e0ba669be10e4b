// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "nazori/functions/plate.h"
#include "nazori/functions/sound.h"

namespace nazori::functions {

/// Everything that brings a plot back as it was: what was typed and how it was shown and played.
struct PlotDocument {
  std::string expression;  ///< as typed
  ParseOptions reading;
  Window window;
  PlateSettings plate;
  SoundSettings sound;
  std::string title;  ///< may be empty
};

/// The version that to_json() writes; older ones are read, newer ones refused.
inline constexpr int kPlotDocumentVersion = 1;

/// JSON with the members of PlotDocument under their own names, and "nazori_plot" with the version.
[[nodiscard]] std::string to_json(const PlotDocument& document);

/// Reads what to_json() wrote. Members that are left out keep their defaults, "expression" must be there;
/// unknown members are passed over. The expression must be readable, the window and the settings in range.
/// @return Errc::parse for text that is no JSON (with line and column) and for a member with a wrong value
/// (with line and path, "line 3, plate/size"), Errc::schema for another kind or a newer version.
[[nodiscard]] base::Result<PlotDocument> parse_document(std::string_view json);

/// The same in a file, at most 1 MB, written whole or not at all. Errors name the file.
[[nodiscard]] base::Result<PlotDocument> load_document(const std::filesystem::path& path);
[[nodiscard]] base::Result<void> save_document(const PlotDocument& document,
                                               const std::filesystem::path& path);

}  // namespace nazori::functions
