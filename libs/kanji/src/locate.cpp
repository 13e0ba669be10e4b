// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/kanji/kanji_database.h"

namespace nazori::kanji {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing here sets variables
  return value == nullptr ? std::string() : std::string(value);
}

std::vector<fs::path> candidates() {
  constexpr const char* kFile = "kanji.db";
  std::vector<fs::path> out;
  if (const std::string folder = environment("NAZORI_DATA"); !folder.empty()) {
    out.push_back(fs::path(folder) / kFile);
  }
  std::error_code ignored;
  if (const fs::path program = fs::read_symlink("/proc/self/exe", ignored); !program.empty()) {
    out.push_back(program.parent_path() / kFile);
  }
  const std::string home = environment("HOME");
  std::string data_home = environment("XDG_DATA_HOME");
  // The specification tells to ignore paths that are not absolute.
  if (!fs::path(data_home).is_absolute()) data_home = home.empty() ? "" : home + "/.local/share";
  if (!data_home.empty()) out.push_back(fs::path(data_home) / "nazori" / kFile);
  std::string folders = environment("XDG_DATA_DIRS");
  if (folders.empty()) folders = "/usr/local/share:/usr/share";
  std::string_view rest = folders;
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    if (fs::path(folder).is_absolute()) out.push_back(fs::path(folder) / "nazori" / kFile);
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
  }
  return out;
}

}  // namespace

base::Result<fs::path> KanjiDatabase::locate() {
  for (const fs::path& path : candidates()) {
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored)) return path;
  }
  return base::fail(base::Errc::not_found, "no kanji database was found", "kanji.db",
                    "build one: nazori-cli database build");
}

}  // namespace nazori::kanji
