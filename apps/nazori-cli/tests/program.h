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

/// The result of a run of nazori-cli.
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

/// nazori-cli while it runs, with a pipe for standard input into which only the test writes. Ended with the
/// object.
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

/// Repeats the check until `holds` is true, for two minutes at most. @return whether it became true.
bool becomes_true(const std::function<bool()>& holds);

/// A temporary folder that is removed with the object.
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

/// A copy of the program in a temporary tree that is removed with the object, run from another folder and
/// without an environment variable for the data.
class PlacedProgram {
 public:
  /// @param program its path in the tree. @param database the path of a link to the tests' kanji.db; empty:
  ///   none.
  explicit PlacedProgram(const std::string& program, const std::string& database = {});
  /// @param arguments in shell syntax.
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

/// Fails the test unless the run ended with `code`, with no answer and an error message of one line that
/// contains each of `words`.
void expect_one_line(const Outcome& run, int code, const std::vector<std::string>& words);

}  // namespace nazori::cli::test
