// SPDX-License-Identifier: Apache-2.0
#include "child_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace nazori::speech {
namespace {

constexpr int kLook_ms = 20;                 ///< between two looks at a running program
constexpr std::size_t kMostComplaint = 400;  ///< bytes of standard error that are read

class Fd {
 public:
  explicit Fd(int fd) : fd_(fd) {}
  ~Fd() { ::close(fd_); }  // does nothing with -1
  Fd(const Fd&) = delete;
  Fd& operator=(const Fd&) = delete;
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool is_open() const { return fd_ >= 0; }

 private:
  int fd_;
};

int memory_file(const char* name) { return static_cast<int>(::memfd_create(name, MFD_CLOEXEC)); }

std::size_t size_of(const Fd& fd) {
  struct stat found {};
  return ::fstat(fd.get(), &found) == 0 ? static_cast<std::size_t>(found.st_size) : 0;
}

// Files in memory are read and written whole by one call.
std::vector<std::uint8_t> content_of(const Fd& fd, std::size_t most) {
  std::vector<std::uint8_t> bytes(std::min(size_of(fd), most));
  const ssize_t got = ::pread(fd.get(), bytes.data(), bytes.size(), 0);
  bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  return bytes;
}

bool fill(const Fd& fd, std::string_view text) {
  return ::pwrite(fd.get(), text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
}

/// The settings of posix_spawn, given back when this ends.
struct SpawnSettings {
  SpawnSettings() {
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
    // A group of its own, so that what it starts ends with it; no signal is blocked or ignored.
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes, &signals);
    sigaddset(&signals, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  posix_spawn_file_actions_t files{};
  posix_spawnattr_t attributes{};
};

std::string first_line(const std::vector<std::uint8_t>& bytes) {
  return {bytes.begin(), std::find(bytes.begin(), bytes.end(), std::uint8_t{'\n'})};
}

tl::unexpected<base::Error> system_failure(const ChildProgram& child, int number) {
  return base::fail(base::Errc::io, std::strerror(number), child.program.string());
}

enum class End { by_itself, too_long, too_much, unwanted };

/// Waits for the end of a process, or ends it. @param status  as waitpid() gives it.
End wait_for(pid_t process, const ChildProgram& child, const Fd& output,
             const std::function<bool()>& is_wanted, int& status) {
  const Fd watch(static_cast<int>(::syscall(SYS_pidfd_open, process, 0)));
  const auto begin = std::chrono::steady_clock::now();
  auto end = End::by_itself;
  while (true) {
    if (::waitpid(process, &status, WNOHANG) != 0) return end;
    if (size_of(output) > child.most_output)
      end = End::too_much;
    else if (is_wanted && !is_wanted())
      end = End::unwanted;
    else if (std::chrono::steady_clock::now() - begin > child.most_time)
      end = End::too_long;
    if (end != End::by_itself) {
      ::kill(-process, SIGKILL);
      while (::waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
      return end;
    }
    pollfd entry{watch.get(), POLLIN, 0};
    (void)::poll(&entry, watch.is_open() ? 1 : 0, kLook_ms);
  }
}

}  // namespace

base::Result<std::vector<std::uint8_t>> run(const ChildProgram& child,
                                            const std::function<bool()>& is_wanted) {
  const Fd input(memory_file("input"));
  const Fd output(memory_file("output"));
  const Fd complaint(memory_file("complaint"));
  if (!input.is_open() || !output.is_open() || !complaint.is_open() || !fill(input, child.input))
    return system_failure(child, errno);
  SpawnSettings settings;
  posix_spawn_file_actions_adddup2(&settings.files, input.get(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&settings.files, output.get(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&settings.files, complaint.get(), STDERR_FILENO);
  std::vector<std::string> words{child.program.string()};
  words.insert(words.end(), child.arguments.begin(), child.arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t process = 0;
  const int failed = posix_spawn(&process, child.program.c_str(), &settings.files, &settings.attributes,
                                 argv.data(), environ);
  if (failed != 0)
    return base::fail(base::Errc::not_found, std::string("cannot be started: ") + std::strerror(failed),
                      child.program.string());
  int status = 0;
  switch (wait_for(process, child, output, is_wanted, status)) {
    case End::unwanted:
      return base::fail(base::Errc::cancelled, "no longer wanted", child.program.string());
    case End::too_long:
      return base::fail(base::Errc::io, "takes too long", child.program.string());
    case End::too_much:
      return base::fail(base::Errc::io, "writes too much", child.program.string());
    case End::by_itself:
      break;
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    const std::string said = first_line(content_of(complaint, kMostComplaint));
    return base::fail(base::Errc::io, said.empty() ? "failed" : said, child.program.string());
  }
  if (size_of(output) > child.most_output)
    return base::fail(base::Errc::io, "writes too much", child.program.string());
  return content_of(output, child.most_output);
}

}  // namespace nazori::speech
