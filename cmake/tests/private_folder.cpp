// SPDX-License-Identifier: Apache-2.0
// Gives every test program a folder for temporary files of its own. Tests run beside each other, and two that
// wrote a file of the same name in /tmp would meet only sometimes.
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>

namespace {

class PrivateFolder {
 public:
  PrivateFolder() {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "nazori-run-XXXXXX").string();
    if (error || ::mkdtemp(name.data()) == nullptr) {
      std::fputs("nazori: no folder for the temporary files of this test; TMPDIR must name one\n", stderr);
      std::_Exit(2);
    }
    folder_ = name;
    // Tests that give up the rights of root must still reach their files.
    if (::chmod(name.c_str(), 0755) != 0) std::perror(name.c_str());
    ::setenv("TMPDIR", name.c_str(), 1);               // NOLINT(concurrency-mt-unsafe)
    ::setenv("TEST_TMPDIR", (name + "/").c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
  }
  ~PrivateFolder() {
    // A forked copy of the program that ends must not take the folder away from the test.
    std::error_code left;
    if (::getpid() == owner_) std::filesystem::remove_all(folder_, left);
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

 private:
  const pid_t owner_ = ::getpid();
  std::filesystem::path folder_;
};

const PrivateFolder kFolder;

}  // namespace
