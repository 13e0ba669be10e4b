// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/program_folders.h"

#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace nazori::base {
namespace {

namespace fs = std::filesystem;

fs::path folder_in(const char* variable) {
  const char* const value =
      std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nothing here sets variables
  return value == nullptr ? fs::path() : fs::path(value);
}

/// The source folder that a CMakeCache.txt names; empty for a build of another project.
fs::path sources_in(const fs::path& cache) {
  constexpr std::string_view kProject = "CMAKE_PROJECT_NAME:STATIC=nazori";
  constexpr std::string_view kSources = "CMAKE_HOME_DIRECTORY:INTERNAL=";
  std::ifstream file(cache);
  fs::path sources;
  bool ours = false;
  for (std::string line; std::getline(file, line);) {
    ours = ours || line == kProject;
    if (line.starts_with(kSources)) sources = line.substr(kSources.size());
  }
  return ours ? sources : fs::path();
}

}  // namespace

fs::path program_file() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored);
}

std::optional<BuildTree> build_tree_of(const fs::path& program) {
  const fs::path programs = program.parent_path();
  if (programs.filename() != "bin") return std::nullopt;
  const fs::path build = programs.parent_path();
  const fs::path sources = sources_in(build / "CMakeCache.txt");
  if (sources.empty()) return std::nullopt;
  // Presets build in build/PRESET and share build/data. A build folder directly in the sources has data of
  // its own.
  const bool is_preset = build.parent_path() != sources;
  return BuildTree{sources, (is_preset ? build.parent_path() : build) / "data"};
}

fs::path user_data_folder() {
  // The specification requires paths that are not absolute to be ignored.
  if (const fs::path data = folder_in("XDG_DATA_HOME"); data.is_absolute()) return data / "nazori";
  if (const fs::path home = folder_in("HOME"); !home.empty()) return home / ".local/share/nazori";
  return {};
}

}  // namespace nazori::base
