// SPDX-License-Identifier: Apache-2.0
#include "program.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "test_paths.h"

namespace nazori::cli::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// @param input  what becomes its standard input.
pid_t start(const std::vector<std::string>& command, const std::vector<std::string>& environment,
            const fs::path& folder, const TemporaryFolder& channels, int input) {
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
    if (::dup2(input, STDIN_FILENO) < 0 || ::freopen(out.c_str(), "w", stdout) == nullptr ||
        ::freopen(err.c_str(), "w", stderr) == nullptr || ::chdir(folder.c_str()) != 0) {
      ::_exit(126);
    }
    ::execv(argv.front(), argv.data());
    ::_exit(127);
  }
  return child;
}

Outcome outcome_of(pid_t child, const TemporaryFolder& channels) {
  int status = 0;
  if (::waitpid(child, &status, 0) != child)
    throw std::system_error(errno, std::generic_category(), "waitpid");
  Outcome run;
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = text_of(channels / "out");
  run.err = text_of(channels / "err");
  return run;
}

Outcome execute(const std::vector<std::string>& command, const std::vector<std::string>& environment,
                const fs::path& folder) {
  const TemporaryFolder channels;
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const pid_t child = start(command, environment, folder, channels, nothing);
  ::close(nothing);
  return outcome_of(child, channels);
}

std::vector<std::string> command_of(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{test_paths::kCommandLine};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

}  // namespace

Outcome nazori_cli(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                   const fs::path& folder) {
  return execute(command_of(arguments), environment, folder);
}

RunningProgram::RunningProgram(const std::vector<std::string>& arguments,
                               const std::vector<std::string>& environment)
    : channels_(std::make_unique<TemporaryFolder>()) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  child_ = start(command_of(arguments), environment, ".", *channels_, pipe[0]);
  ::close(pipe[0]);
  input_ = pipe[1];
}

RunningProgram::~RunningProgram() {
  ::close(input_);
  if (child_ < 0) return;
  (void)::kill(child_, SIGKILL);
  (void)::waitpid(child_, nullptr, 0);
}

double RunningProgram::processor_s() const {
  const std::string text = text_of("/proc/" + std::to_string(child_) + "/stat");
  // After the name in parentheses; user and system time are the 14th and 15th field.
  std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 1)));
  std::string skipped;
  for (int i = 3; i < 14; ++i) fields >> skipped;
  double user = 0;
  double system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

int RunningProgram::threads() const {
  std::error_code error;
  const fs::directory_iterator tasks("/proc/" + std::to_string(child_) + "/task", error);
  return error ? 0 : static_cast<int>(std::distance(begin(tasks), end(tasks)));
}

bool RunningProgram::has_open(const std::string& name) const {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc/" + std::to_string(child_) + "/fd", error)) {
    if (fs::read_symlink(entry.path(), error).filename() == name) return true;
  }
  return false;
}

std::string RunningProgram::out() const { return text_of(*channels_ / "out"); }

void RunningProgram::write(const std::string& text) const {
  if (::write(input_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    throw std::system_error(errno, std::generic_category(), "write");
}

void RunningProgram::signal(int number) const { (void)::kill(child_, number); }

Outcome RunningProgram::wait() { return outcome_of(std::exchange(child_, -1), *channels_); }

bool becomes_true(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
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
