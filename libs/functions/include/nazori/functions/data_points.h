// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/functions/fit.h"

namespace nazori::functions {

/// Rows of data at most.
inline constexpr std::size_t kMostDataPoints = 1000;

/// Reads CSV with the columns x and y: separated by a comma, a semicolon, a tab or spaces, with or without
/// quotes. A first line without numbers is a header; empty lines and lines that begin with "#" are passed
/// over.
/// @param decimal_comma  1,5 is a number; columns are then not separated by commas.
/// @return the points in the order of the text. Errc::parse with "line 3" where a line does not have two
/// finite numbers, where there are none, or more than kMostDataPoints.
[[nodiscard]] base::Result<std::vector<DataPoint>> parse_data_points(std::string_view text,
                                                                     bool decimal_comma = false);

/// The same from a file of at most 1 MB. Errors name the file: "data.csv: line 3".
[[nodiscard]] base::Result<std::vector<DataPoint>> load_data_points(const std::filesystem::path& path,
                                                                    bool decimal_comma = false);

}  // namespace nazori::functions
