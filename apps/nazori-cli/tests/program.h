// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace nazori::cli::test {

class TemporaryFolder;

/// What a run of nazori-cli left behind.
struct Outcome {
  int code = -1;  ///< exit code; 128 + the signal's number where one ended it
  std::string out;
  std::string err;
};

/// Runs nazori-cli to its end with no terminal, in `folder`, and with changes to the environment
/// ("NAZORI_DATA=", empty value: not set).
Outcome nazori_cli(const std::vector<std::string>& arguments,
                   const std::vector<std::string>& environment = {},
                   const std::filesystem::path& folder = ".");

/// The same through the shell; "$NAZORI" in `script` is the program.
Outcome shell(const std::string& script);

/// nazori-cli while it runs, with a pipe for standard input into which nothing comes but what is written
/// here. Ended with the object.
class RunningProgram {
 public:
  explicit RunningProgram(const std::vector<std::string>& arguments,
                          const std::vector<std::string>& environment = {});
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Seconds of processor time that it has used.
  [[nodiscard]] double processor_s() const;
  /// How many threads it has now.
  [[nodiscard]] int threads() const;
  /// Whether it has a file of that name open.
  [[nodiscard]] bool has_open(const std::string& name) const;
  /// What it has printed so far.
  [[nodiscard]] std::string out() const;
  void write(const std::string& text) const;
  void signal(int number) const;
  /// Waits for its end.
  Outcome wait();

 private:
  std::unique_ptr<TemporaryFolder> channels_;
  int child_ = -1;
  int input_ = -1;
};

/// Looks again and again until `holds`, for two minutes at most. @return whether it did.
bool becomes_true(const std::function<bool()>& holds);

/// A folder of its own that is gone with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  /// Names of what lies in it, sorted.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

/// A copy of the program in a tree of its own that is gone with the object, run from another folder and
/// without a variable that says where data are.
class PlacedProgram {
 public:
  /// @param program where it lies in the tree. @param database where a link to the tests' kanji.db lies;
  /// empty: nowhere.
  explicit PlacedProgram(const std::string& program, const std::string& database = {});
  /// @param arguments as the shell reads them.
  [[nodiscard]] Outcome run(const std::string& arguments) const;
  /// The path of something in the tree.
  [[nodiscard]] std::string operator/(const std::string& name) const { return tree_ / name; }

 private:
  TemporaryFolder tree_;
  std::string program_;
};

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& path);
void write(const std::filesystem::path& path, const std::string& bytes);

/// The folder of the tests' kanji.db.
std::filesystem::path data_folder();

/// Fails the test unless the run ended with `code`, with no answer and one line of trouble that holds each of
/// `words`.
void expect_one_line(const Outcome& run, int code, const std::vector<std::string>& words);

}  // namespace nazori::cli::test
