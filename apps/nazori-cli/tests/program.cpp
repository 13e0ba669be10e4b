// SPDX-License-Identifier: Apache-2.0
#include "program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "test_paths.h"

namespace nazori::cli::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Outcome execute(const std::vector<std::string>& command, const std::vector<std::string>& environment,
                const fs::path& folder) {
  const TemporaryFolder channels;
  const std::string out = channels / "out";
  const std::string err = channels / "err";
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    for (const std::string& entry : environment) {
      const std::size_t equals = entry.find('=');
      const std::string name = entry.substr(0, equals);
      const std::string value = entry.substr(equals + 1);
      if (value.empty()) {
        ::unsetenv(name.c_str());
      } else {
        ::setenv(name.c_str(), value.c_str(), 1);
      }
    }
    std::vector<char*> argv;
    for (const std::string& part : command) argv.push_back(const_cast<char*>(part.c_str()));
    argv.push_back(nullptr);
    if (::freopen("/dev/null", "r", stdin) == nullptr || ::freopen(out.c_str(), "w", stdout) == nullptr ||
        ::freopen(err.c_str(), "w", stderr) == nullptr || ::chdir(folder.c_str()) != 0) {
      ::_exit(126);
    }
    ::execv(argv.front(), argv.data());
    ::_exit(127);
  }
  int status = 0;
  if (::waitpid(child, &status, 0) != child)
    throw std::system_error(errno, std::generic_category(), "waitpid");
  Outcome run;
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = text_of(out);
  run.err = text_of(err);
  return run;
}

}  // namespace

Outcome nazori_cli(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                   const fs::path& folder) {
  std::vector<std::string> command{test_paths::kCommandLine};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return execute(command, environment, folder);
}

Outcome shell(const std::string& script) {
  return execute({"/bin/sh", "-c", script}, {std::string("NAZORI=") + test_paths::kCommandLine}, ".");
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "nazori-test-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::system_error(errno, std::generic_category(), pattern);
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

PlacedProgram::PlacedProgram(const std::string& program, const std::string& database)
    : program_(tree_ / program) {
  fs::create_directories(fs::path(program_).parent_path());
  fs::copy_file(test_paths::kCommandLine, program_);
  if (database.empty()) return;
  const fs::path link = tree_ / database;
  fs::create_directories(link.parent_path());
  fs::create_symlink(fs::absolute(data_folder() / "kanji.db"), link);
}

Outcome PlacedProgram::run(const std::string& arguments) const {
  return shell("cd / && unset NAZORI_DATA XDG_DATA_HOME && export XDG_DATA_DIRS=/nowhere HOME='" +
               tree_ / "home" + "' && '" + program_ + "' " + arguments);
}

std::vector<std::uint8_t> bytes_of(const fs::path& path) {
  const std::string text = text_of(path);
  return {text.begin(), text.end()};
}

void write(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

fs::path data_folder() {
  const char* folder = std::getenv("NAZORI_DATA");
  if (folder == nullptr) throw std::runtime_error("NAZORI_DATA names the folder of kanji.db; ctest sets it");
  return folder;
}

void expect_one_line(const Outcome& run, int code, const std::vector<std::string>& words) {
  EXPECT_EQ(run.code, code) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_TRUE(run.err.starts_with("nazori-cli")) << run.err;
  for (const std::string& word : words) EXPECT_THAT(run.err, testing::HasSubstr(word));
}

}  // namespace nazori::cli::test
