// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

namespace nazori::base {

/// The file of the running program, links resolved; empty where the system does not say.
[[nodiscard]] std::filesystem::path program_file();

/// The folders that belong to a program that runs where it was built.
struct BuildTree {
  std::filesystem::path sources;  ///< the folder of the sources, CMAKE_HOME_DIRECTORY
  std::filesystem::path data;     ///< where `make run` puts kanji.db: build/data for build/release/bin/nazori
};

/// The build tree of a program: its folder is called bin, and beside that folder lies the CMakeCache.txt of a
/// build of Nazori. nullopt for a program that is installed or was copied elsewhere.
[[nodiscard]] std::optional<BuildTree> build_tree_of(const std::filesystem::path& program);

/// nazori/ in XDG_DATA_HOME, else in ~/.local/share; empty where neither variable is set.
[[nodiscard]] std::filesystem::path user_data_folder();

}  // namespace nazori::base
