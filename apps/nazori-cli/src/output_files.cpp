// SPDX-License-Identifier: Apache-2.0
#include "output_files.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <map>
#include <system_error>
#include <utility>

#include "options.h"

namespace nazori::cli {
namespace {

namespace fs = std::filesystem;
using base::Errc;

std::string listed(const std::vector<std::string>& extensions) {
  std::string text;
  for (const std::string& extension : extensions) text += (text.empty() ? "" : " or ") + extension;
  return text;
}

base::Result<void> check(const OutputRequest& request, const fs::path& path) {
  const std::string where = fmt::format("{} {}", request.option, path.string());
  std::error_code error;
  if (std::none_of(request.extensions.begin(), request.extensions.end(),
                   [&path](const std::string& extension) { return has_extension(path, extension); })) {
    return base::fail(Errc::bad_argument, "has an unsupported file type", where,
                      "use a name that ends in " + listed(request.extensions));
  }
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    return base::fail(Errc::bad_argument, fmt::format("the folder {} does not exist", folder.string()), where,
                      "create it first, or choose another folder");
  }
  if (fs::is_directory(path, error)) {
    return base::fail(Errc::bad_argument, "is a folder, not a file", where, "give a file name");
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    return base::fail(Errc::io, fmt::format("cannot write to the folder {}", folder.string()), where,
                      "choose another folder");
  }
  return {};
}

fs::path with_name(const OutputRequest& request, const CharacterName& character, bool folder) {
  if (folder) return fs::path(request.text) / (character.file_name() + request.extensions.front());
  std::string text = request.text;
  for (std::size_t at = text.find("{}"); at != std::string::npos; at = text.find("{}", at)) {
    const std::string name = character.file_name();
    text.replace(at, 2, name);
    at += name.size();
  }
  return text;
}

/// Identifies a file whatever its name: by its path, and if it exists by the file itself.
std::vector<std::string> marks_of(const std::string& name) {
  std::error_code error;
  std::vector<std::string> marks;
  const fs::path path = fs::weakly_canonical(fs::absolute(name, error), error);
  marks.push_back("path " + (error ? name : path.string()));
  struct stat status {};
  if (::stat(name.c_str(), &status) == 0 && S_ISREG(status.st_mode))
    marks.push_back(fmt::format("file {} {}", status.st_dev, status.st_ino));
  return marks;
}

}  // namespace

base::Result<OutputPlace> OutputPlace::console(const std::string& extension) {
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  std::string name = (folder / ("nazori-XXXXXX" + extension)).string();
  int number = 0;
  auto unfinished = base::UnfinishedFile::made_by([&]() -> fs::path {
    const int file = ::mkstemps(name.data(), static_cast<int>(extension.size()));
    number = errno;
    if (file < 0) return {};
    (void)::close(file);
    return name;
  });
  if (!fs::exists(name, error)) {
    return base::fail(Errc::io, "cannot be written: " + std::generic_category().message(number),
                      folder.string(), "set TMPDIR to a folder with room");
  }
  OutputPlace place{fs::path(name)};
  place.is_console_ = true;
  place.unfinished_ = std::move(unfinished);
  return place;
}

base::Result<void> OutputPlace::deliver(Console& console) const {
  if (!is_console_) return {};
  std::ifstream file(path_, std::ios::binary);
  std::array<char, 1 << 16> bytes{};
  while (file) {
    file.read(bytes.data(), bytes.size());
    console.print_file({bytes.data(), static_cast<std::size_t>(file.gcount())});
  }
  if (!file.eof()) return base::fail(Errc::io, "cannot be read again", path_.string());
  return {};
}

base::Result<std::vector<OutputPlace>> output_files(const OutputRequest& request,
                                                    std::span<const CharacterName> characters) {
  std::error_code error;
  const bool folder = request.text.ends_with('/') || fs::is_directory(request.text, error);
  const bool pattern = request.text.find("{}") != std::string::npos;
  if (characters.size() > 1 && !folder && !pattern) {
    return base::fail(
        Errc::bad_argument, fmt::format("one file cannot hold {} characters", characters.size()),
        fmt::format("{} {}", request.option, request.text),
        fmt::format("give a folder, or a name with {{}} in it such as {{}}{}", request.extensions.front()));
  }
  std::vector<OutputPlace> places;
  for (const CharacterName& character : characters) {
    if (request.text == kConsoleFile) {
      auto place = OutputPlace::console(request.extensions.front());
      if (!place) return tl::unexpected(std::move(place.error()));
      places.push_back(std::move(*place));
      continue;
    }
    fs::path path = with_name(request, character, folder);
    if (auto ok = check(request, path); !ok) return tl::unexpected(std::move(ok.error()));
    places.emplace_back(std::move(path));
  }
  return places;
}

base::Result<OutputPlace> output_file(const OutputRequest& request) {
  if (request.text == kConsoleFile) return OutputPlace::console(request.extensions.front());
  fs::path path = request.text;
  if (auto ok = check(request, path); !ok) return tl::unexpected(std::move(ok.error()));
  return OutputPlace(std::move(path));
}

base::Result<void> check_distinct(std::span<const NamedFile> files, bool json) {
  std::map<std::string, const NamedFile*> seen;
  const NamedFile* to_console = nullptr;
  for (const NamedFile& file : files) {
    if (file.name.empty()) continue;
    if (file.name == kConsoleFile) {
      if (file.use == NamedFile::Use::read) continue;
      if (json) {
        return base::fail(Errc::bad_argument, "standard output cannot hold both the file and JSON",
                          file.option, "write to a file, or omit --json");
      }
      if (to_console != nullptr) {
        return base::fail(Errc::bad_argument,
                          fmt::format("standard output is taken by {}", to_console->option), file.option,
                          "write one of them to a file");
      }
      to_console = &file;
      continue;
    }
    for (std::string& mark : marks_of(file.name)) {
      const auto [other, first] = seen.emplace(std::move(mark), &file);
      if (first || other->second == &file) continue;
      const NamedFile& before = *other->second;
      if (before.use == NamedFile::Use::read && file.use == NamedFile::Use::read) continue;
      const bool overwrites = before.use != file.use;
      return base::fail(Errc::bad_argument,
                        fmt::format("is the same file as {} {}{}", before.option, before.name,
                                    overwrites ? ", which is read" : ""),
                        fmt::format("{} {}", file.option, file.name),
                        overwrites ? "write to another file" : "give each a name of its own");
    }
  }
  return {};
}

}  // namespace nazori::cli
