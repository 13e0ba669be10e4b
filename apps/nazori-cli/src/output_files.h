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

/// Stands for standard output where a file is named, and for standard input.
inline constexpr std::string_view kConsoleFile = "-";

/// What an option for output files asks for.
struct OutputRequest {
  std::string option;  ///< "--output", for messages
  std::string text;    ///< as given: a file, a name with {} for the character, a folder, or "-"
  std::vector<std::string> extensions;  ///< allowed ones, the first being what files in a folder get
};

/// A file to write: the one that was named, or one that goes to standard output when it is whole.
class OutputPlace {
 public:
  explicit OutputPlace(std::filesystem::path path) : path_(std::move(path)) {}
  /// For standard output. @param extension  of the file that is made meanwhile: ".png".
  [[nodiscard]] static base::Result<OutputPlace> console(const std::string& extension);

  /// Where to write the file.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] bool is_console() const { return is_console_; }
  /// The name for an answer, "-" for standard output.
  [[nodiscard]] std::string name() const { return is_console_ ? std::string(kConsoleFile) : path_.string(); }
  /// Sends the file to standard output where that was asked for. Once, when it is written.
  [[nodiscard]] base::Result<void> deliver(Console& console) const;

 private:
  std::filesystem::path path_;
  bool is_console_ = false;
  base::UnfinishedFile unfinished_;
};

/// The file for each of the characters, checked before any work is done: the folder is there and may be
/// written to, the kind of file is one that can be made, several characters get several files.
[[nodiscard]] base::Result<std::vector<OutputPlace>> output_files(const OutputRequest& request,
                                                                  std::span<const CharacterName> characters);

/// The same for one file that belongs to no character.
[[nodiscard]] base::Result<OutputPlace> output_file(const OutputRequest& request);

/// A file that the command line names.
struct NamedFile {
  enum class Use { read, write };
  std::string option;  ///< "--output"; what an argument without dashes is called, such as "file"
  std::string name;    ///< may be empty: none; "-" for standard input and output
  Use use = Use::write;
};

/// Refuses a file that would be written and is named twice, under whatever names, and a file for standard
/// output where the answer in JSON goes.
[[nodiscard]] base::Result<void> check_distinct(std::span<const NamedFile> files, bool json);

}  // namespace nazori::cli
