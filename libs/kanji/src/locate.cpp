// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "database_places.h"
#include "nazori/base/program_folders.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::kanji {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "kanji.db";

std::string environment(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing here sets variables
  return value == nullptr ? std::string() : std::string(value);
}

}  // namespace

std::vector<fs::path> database_places(const fs::path& program) {
  std::vector<fs::path> out;
  if (const std::string folder = environment("NAZORI_DATA"); !folder.empty()) {
    out.push_back(fs::path(folder) / kFile);
  }
  if (!program.empty()) out.push_back(program.parent_path() / kFile);
  if (const auto tree = base::build_tree_of(program)) out.push_back(tree->data / kFile);
  if (const fs::path own = base::user_data_folder(); !own.empty()) out.push_back(own / kFile);
  std::string folders = environment("XDG_DATA_DIRS");
  if (folders.empty()) folders = "/usr/local/share:/usr/share";
  std::string_view rest = folders;
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    if (fs::path(folder).is_absolute()) out.push_back(fs::path(folder) / "nazori" / kFile);
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
  }
  if (const fs::path programs = program.parent_path(); programs.filename() == "bin") {
    out.push_back(programs.parent_path() / "share" / "nazori" / kFile);
  }
  return out;
}

base::Result<fs::path> locate_for(const fs::path& program) {
  for (const fs::path& path : database_places(program)) {
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored)) return path;
  }
  return base::fail(base::Errc::not_found, "no kanji database was found", kFile,
                    "build one: nazori-cli database build");
}

base::Result<fs::path> place_to_build_for(const fs::path& program) {
  if (const std::string folder = environment("NAZORI_DATA"); !folder.empty()) return fs::path(folder) / kFile;
  if (const auto tree = base::build_tree_of(program)) return tree->data / kFile;
  if (const fs::path own = base::user_data_folder(); !own.empty()) return own / kFile;
  return base::fail(base::Errc::not_found, "no folder to write it to: HOME is not set", kFile,
                    "name a file with --output");
}

base::Result<fs::path> KanjiDatabase::locate() { return locate_for(base::program_file()); }

base::Result<fs::path> KanjiDatabase::place_to_build() { return place_to_build_for(base::program_file()); }

}  // namespace nazori::kanji
