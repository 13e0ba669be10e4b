// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

namespace nazori::base {

/// The file of the running program, with links resolved; empty where the system cannot tell.
[[nodiscard]] std::filesystem::path program_file();

/// The folders of a program that runs in its build tree.
struct BuildTree {
  std::filesystem::path sources;  ///< the folder of the sources, CMAKE_HOME_DIRECTORY
  std::filesystem::path data;     ///< where `make run` puts kanji.db: build/data for build/release/bin/nazori
};

/// The build tree of a program: the program is in a folder called bin, and the folder around it contains the
/// CMakeCache.txt of a build of Nazori. nullopt for a program that is installed or was copied elsewhere.
[[nodiscard]] std::optional<BuildTree> build_tree_of(const std::filesystem::path& program);

/// nazori/ in XDG_DATA_HOME, else in ~/.local/share; empty where neither variable is set.
[[nodiscard]] std::filesystem::path user_data_folder();

}  // namespace nazori::base
