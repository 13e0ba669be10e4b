// SPDX-License-Identifier: Apache-2.0
// Files of which the system refuses, interrupts or shortens a call.
#include "failing_calls.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

#include "nazori/base/file.h"

namespace nazori::base {
namespace {

namespace fs = std::filesystem;
using test::FailingCalls;

std::string reason(int error) { return std::generic_category().message(error); }

class FailingFiles : public testing::Test {
 protected:
  FailingFiles() {
    std::string pattern = (fs::temp_directory_path() / "nazori-failing-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    file_ = folder_ / "file";
    std::ofstream(file_) << "old";
  }
  ~FailingFiles() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string content() const {
    std::ifstream file(file_);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  [[nodiscard]] long entries() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
  [[nodiscard]] static mode_t mode_of(const fs::path& path) {
    struct stat status {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0);
    return status.st_mode & 07777U;
  }

  fs::path folder_, file_;
};

TEST_F(FailingFiles, AWriteGoesOnAfterInterruptionsAndShortWrites) {
  const std::string text(1000, 'x');
  FailingCalls calls;
  calls.interruptions = 3;
  calls.empty_writes = 2;
  calls.most_bytes = 7;
  ASSERT_TRUE(write_file(file_, text + "end"));
  EXPECT_EQ(content(), text + "end");
}

TEST_F(FailingFiles, AWriteThatAnyCallRefusesSaysWhyAndLeavesTheOldContent) {
  const long open = test::open_descriptors();
  for (const char* call : {"write", "fsync", "fchmod", "close", "rename"}) {
    std::optional<Result<void>> written;
    {
      const FailingCalls calls({{call, ENOSPC}});
      written = write_file(file_, "new");
    }
    ASSERT_FALSE(*written) << call;
    EXPECT_EQ(written->error(), (Error{Errc::io, "cannot be written: " + reason(ENOSPC), file_.string(), ""}))
        << call;
    EXPECT_EQ(content(), "old") << call;
    EXPECT_EQ(entries(), 1) << call;
    EXPECT_EQ(test::open_descriptors(), open) << call;
  }
}

TEST_F(FailingFiles, TheFirstRefusalIsTheOneThatIsTold) {
  for (const char* first : {"fsync", "fchmod"}) {
    FailingCalls calls({{first, EIO}, {"close", ENOSPC}, {"rename", EACCES}});
    EXPECT_EQ(write_file(file_, "new").error().what, "cannot be written: " + reason(EIO)) << first;
    EXPECT_EQ(calls.renames, 0) << "what was not flushed takes nobody's place";
  }
  FailingCalls calls({{"close", ENOSPC}, {"rename", EACCES}});
  EXPECT_EQ(write_file(file_, "new").error().what, "cannot be written: " + reason(ENOSPC));
  EXPECT_EQ(calls.renames, 0);
}

TEST_F(FailingFiles, OneThatCannotBeMadeSaysWhy) {
  const fs::path nowhere = folder_ / "none" / "file";
  const auto made = OutputFile::create(nowhere);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error(), (Error{Errc::io, "cannot be written: " + reason(ENOENT), nowhere.string(), ""}));
}

TEST_F(FailingFiles, ALinkToAFolderIsNotReplaced) {
  fs::create_directory(folder_ / "folder");
  fs::create_directory_symlink(folder_ / "folder", folder_ / "link");
  const auto written = write_file(folder_ / "link", "text");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().what, "cannot be written: " + reason(EISDIR));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(entries(), 3);
}

TEST_F(FailingFiles, ANewOneHasTheModeOfAnyNewFileAndAReplacedOneItsOwn) {
  const mode_t before = ::umask(027);
  ASSERT_TRUE(write_file(folder_ / "new", "text"));
  EXPECT_EQ(::umask(before), 027U) << "the mask of the program stays";
  EXPECT_EQ(mode_of(folder_ / "new"), 0640U);
  fs::permissions(file_, fs::perms(0751));
  ASSERT_TRUE(write_file(file_, "text"));
  EXPECT_EQ(mode_of(file_), 0751U);
}

TEST_F(FailingFiles, AReadGoesOnAfterInterruptionsAndShortReads) {
  std::ofstream(file_) << std::string(1000, 'x').append("end");
  FailingCalls calls;
  calls.interruptions = 3;
  calls.most_bytes = 7;
  const auto read = read_file(file_, 2000);
  ASSERT_TRUE(read);
  EXPECT_EQ(std::string(read->begin(), read->end()), std::string(1000, 'x').append("end"));
}

TEST_F(FailingFiles, OneThatBecameShorterWhileItWasReadIsWhatIsLeftOfIt) {
  std::ofstream(file_) << "0123456789";
  for (const std::size_t left : {std::size_t{0}, std::size_t{1}, std::size_t{4}}) {
    FailingCalls calls;
    calls.bytes_to_read = left;
    const auto read = read_file(file_, 100);
    ASSERT_TRUE(read);
    EXPECT_EQ(std::string(read->begin(), read->end()), std::string("0123456789").substr(0, left));
  }
}

TEST_F(FailingFiles, AReadThatIsRefusedSaysWhy) {
  const long open = test::open_descriptors();
  {
    const FailingCalls calls({{"read", EIO}});
    EXPECT_EQ(read_file(file_, 100).error(),
              (Error{Errc::io, "cannot be read: " + reason(EIO), file_.string(), ""}));
  }
  {
    const FailingCalls calls({{"fstat", EOVERFLOW}});
    EXPECT_EQ(InputFile::open(file_).error(), (Error{Errc::io, reason(EOVERFLOW), file_.string(), ""}));
  }
  const auto below_a_file = InputFile::open(file_ / "inner");
  EXPECT_EQ(below_a_file.error(),
            (Error{Errc::io, "cannot be read: " + reason(ENOTDIR), (file_ / "inner").string(), ""}));
  EXPECT_EQ(InputFile::open(folder_).error().what, "is a folder, not a file");
  EXPECT_EQ(InputFile::open("/dev/null").error().what, "is not a regular file");
  EXPECT_EQ(test::open_descriptors(), open) << "all are closed again";
}

TEST_F(FailingFiles, AreClosedOnceHoweverOftenTheyWereMoved) {
  const long open = test::open_descriptors();
  {
    auto input = InputFile::open(file_);
    ASSERT_TRUE(input);
    const InputFile moved(std::move(*input));
    auto output = OutputFile::create(file_);
    ASSERT_TRUE(output);
    const OutputFile other(std::move(*output));
    EXPECT_EQ(test::open_descriptors(), open + 2);
  }
  EXPECT_EQ(test::open_descriptors(), open);
}

using FailingFilesDeathTest = FailingFiles;

TEST_F(FailingFilesDeathTest, AreReadAndWrittenWhereTheProgramHasNoStandardInput) {
  // The first file that is opened then has the number 0.
  const auto without_input = [this] {
    (void)::close(STDIN_FILENO);
    const long open = test::open_descriptors();
    const bool written = write_file(file_, "new").has_value();
    { const auto begun = OutputFile::create(file_); }
    const auto read = read_file(file_, 100);
    const bool same = read && std::string(read->begin(), read->end()) == "new";
    ::_exit(!written ? 1 : !same ? 2 : test::open_descriptors() != open ? 3 : 7);
  };
  EXPECT_EXIT(without_input(), testing::ExitedWithCode(7), "");
  EXPECT_EQ(entries(), 1);
}

}  // namespace
}  // namespace nazori::base
