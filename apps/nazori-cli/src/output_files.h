// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "characters.h"
#include "console.h"
#include "nazori/base/result.h"
#include "nazori/base/unfinished_file.h"

namespace nazori::cli {

/// The file name that means standard output or standard input.
inline constexpr std::string_view kConsoleFile = "-";

/// The value of an option for output files.
struct OutputRequest {
  std::string option;  ///< "--output", for messages
  std::string text;    ///< as typed: a file, a name with {} for the character, a folder, or "-"
  std::vector<std::string> extensions;  ///< allowed ones; files in a folder get the first
};

/// A file to write: the named one, or a temporary one that goes to standard output when it is complete.
class OutputPlace {
 public:
  explicit OutputPlace(std::filesystem::path path) : path_(std::move(path)) {}
  /// For standard output. @param extension  of the temporary file: ".png".
  [[nodiscard]] static base::Result<OutputPlace> console(const std::string& extension);

  /// Where to write the file.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] bool is_console() const { return is_console_; }
  /// The name to print in an answer, "-" for standard output.
  [[nodiscard]] std::string name() const { return is_console_ ? std::string(kConsoleFile) : path_.string(); }
  /// Sends the file to standard output if requested. Call it once, when the file is written.
  [[nodiscard]] base::Result<void> deliver(Console& console) const;

 private:
  std::filesystem::path path_;
  bool is_console_ = false;
  base::UnfinishedFile unfinished_;
};

/// The file for each of the characters, checked before any work is done: the folder exists and is writable,
/// the file type is supported, several characters get several files.
[[nodiscard]] base::Result<std::vector<OutputPlace>> output_files(const OutputRequest& request,
                                                                  std::span<const CharacterName> characters);

/// The same for one file that belongs to no character.
[[nodiscard]] base::Result<OutputPlace> output_file(const OutputRequest& request);

/// A file named on the command line.
struct NamedFile {
  enum class Use { read, write };
  std::string option;  ///< "--output"; or the name of an argument without dashes, such as "file"
  std::string name;    ///< may be empty: none; "-" for standard input and output
  Use use = Use::write;
};

/// Refuses an output file that is named twice, under whatever names, and a file for standard output together
/// with an answer in JSON.
[[nodiscard]] base::Result<void> check_distinct(std::span<const NamedFile> files, bool json);

}  // namespace nazori::cli
