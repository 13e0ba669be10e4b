// SPDX-License-Identifier: Apache-2.0
#include "output_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

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
    return base::fail(Errc::bad_argument, "is not a kind of file this writes", where,
                      "end the name with " + listed(request.extensions));
  }
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    return base::fail(Errc::bad_argument, fmt::format("there is no folder {}", folder.string()), where,
                      "make it first, or write elsewhere");
  }
  if (fs::is_directory(path, error)) {
    return base::fail(Errc::bad_argument, "is a folder, not a file", where, "give a file name");
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    return base::fail(Errc::io, fmt::format("the folder {} cannot be written to", folder.string()), where,
                      "write elsewhere");
  }
  return {};
}

}  // namespace

base::Result<std::vector<fs::path>> output_files(const OutputRequest& request,
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
  std::vector<fs::path> paths;
  for (const CharacterName& character : characters) {
    fs::path path;
    if (folder) {
      path = fs::path(request.text) / (character.file_name() + request.extensions.front());
    } else {
      std::string text = request.text;
      for (std::size_t at = text.find("{}"); at != std::string::npos; at = text.find("{}", at)) {
        const std::string name = character.file_name();
        text.replace(at, 2, name);
        at += name.size();
      }
      path = text;
    }
    if (auto ok = check(request, path); !ok) return tl::unexpected(std::move(ok.error()));
    paths.push_back(std::move(path));
  }
  return paths;
}

base::Result<fs::path> output_file(const OutputRequest& request) {
  fs::path path = request.text;
  if (auto ok = check(request, path); !ok) return tl::unexpected(std::move(ok.error()));
  return path;
}

}  // namespace nazori::cli
