// SPDX-License-Identifier: Apache-2.0
#include "source_files.h"

#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace nazori::ingest {
namespace {

namespace fs = std::filesystem;
using base::Errc;
using testing::ElementsAre;
using testing::HasSubstr;

class SourceFiles : public testing::Test {
 protected:
  SourceFiles() {
    std::string pattern = (fs::temp_directory_path() / "nazori-sources-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    file_ = folder_ / "file";
  }
  ~SourceFiles() override { fs::remove_all(folder_); }
  void write(const std::string& bytes) const { std::ofstream(file_, std::ios::binary) << bytes; }
  void write_gz(const std::string& text) const {
    gzFile file = gzopen(file_.c_str(), "wb1");
    (void)gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
    gzclose(file);
  }
  fs::path folder_, file_;
};

/// Larger than any buffer, also when compressed.
std::string long_text(std::size_t size) {
  std::string text;
  std::uint32_t state = 1;
  while (text.size() < size) {
    state = state * 1664525U + 1013904223U;
    text += static_cast<char>('a' + (state >> 24U) % 26);
  }
  return text;
}

TEST_F(SourceFiles, Sha256OfAMillionLettersIsThatOfThePublishedVector) {
  write(std::string(1'000'000, 'a'));  // FIPS 180-4
  EXPECT_EQ(sha256_of(file_), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_F(SourceFiles, WhatIsNoFileIsRefusedByWhatItIs) {
  const auto error = [this](Errc code, const char* what) {
    return base::Error{code, what, file_.string(), ""};
  };
  EXPECT_EQ(sha256_of(file_).error(), error(Errc::not_found, "does not exist"));
  EXPECT_EQ(read_gzip(file_, 10).error(), error(Errc::not_found, "does not exist"));
  fs::create_directory(file_);
  EXPECT_EQ(sha256_of(file_).error(), error(Errc::io, "is not a regular file"));
  fs::remove(file_);
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  EXPECT_EQ(read_gzip(file_, 10).error(), error(Errc::io, "is not a regular file"));
}

TEST_F(SourceFiles, AGzipIsUnpackedWholeUpToTheLimit) {
  for (const std::size_t size : {0U, 1U, 128U * 1024, 128U * 1024 + 1, 1'000'000U}) {
    const std::string text = long_text(size);
    write_gz(text);
    const auto read = read_gzip(file_, size);
    ASSERT_TRUE(read) << size << ": " << base::to_line(read.error());
    EXPECT_TRUE(*read == text) << size;
    if (size > 0) {
      EXPECT_EQ(read_gzip(file_, size - 1).error(),
                (base::Error{Errc::parse, "is damaged: it unpacks to too much", file_.string(), ""}));
    }
  }
}

TEST_F(SourceFiles, AGzipThatIsNoneOrCutOffIsDamaged) {
  write("plain text, no gzip");
  EXPECT_EQ(read_gzip(file_, 100).error().code, Errc::parse);
  write_gz(long_text(300'000));
  for (const auto length :
       {fs::file_size(file_) - 1, fs::file_size(file_) / 2, std::uintmax_t{15}, std::uintmax_t{0}}) {
    fs::resize_file(file_, length);
    EXPECT_EQ(read_gzip(file_, 1'000'000).error().what, "is damaged: it is cut off") << length;
  }
}

TEST_F(SourceFiles, EucJpOfAnyLengthBecomesUtf8) {
  // 休 is BB 59 in JIS, with both high bits set B5 D9; a kana takes two bytes too.
  std::string euc, utf8;
  for (int i = 0; i < 100'000; ++i) {
    euc += "a\xB5\xD9\n";
    utf8 += "a休\n";
  }
  write(euc);
  const auto read = read_euc_jp(file_, euc.size());
  ASSERT_TRUE(read);
  EXPECT_TRUE(*read == utf8);
  EXPECT_EQ(read_euc_jp(file_, euc.size() - 1).error().code, Errc::io);
  write(euc + "b\xFF");
  EXPECT_EQ(read_euc_jp(file_, 1'000'000).error(),
            (base::Error{Errc::parse, "is damaged: not EUC-JP text", file_.string() + ":100001", ""}));
  write("");
  EXPECT_EQ(read_euc_jp(file_, 10), "");
}

TEST_F(SourceFiles, ATextThatFillsEachPieceToItsLastByteIsRead) {
  // Pieces are of 128 KiB; the sizes end at and beside their borders.
  for (const std::size_t size : {131'071U, 131'072U, 131'073U, 262'143U, 262'144U, 262'145U}) {
    const std::string text = long_text(size);
    write_gz(text);
    const auto read = read_gzip(file_, size);
    ASSERT_TRUE(read) << size;
    EXPECT_EQ(read->size(), size);
    EXPECT_TRUE(*read == text) << size;
  }
}

struct Member {
  std::string name, content;
  mode_t type = AE_IFREG;
};
void write_tgz(const fs::path& path, const std::vector<Member>& members) {
  archive* const tar = archive_write_new();
  archive_write_add_filter_gzip(tar);
  archive_write_set_format_ustar(tar);
  ASSERT_EQ(archive_write_open_filename(tar, path.c_str()), ARCHIVE_OK);
  for (const auto& m : members) {
    archive_entry* const entry = archive_entry_new();
    archive_entry_set_pathname(entry, m.name.c_str());
    archive_entry_set_filetype(entry, m.type);
    archive_entry_set_perm(entry, 0644);
    if (m.type == AE_IFLNK) archive_entry_set_symlink(entry, "elsewhere");
    archive_entry_set_size(entry, static_cast<la_int64_t>(m.content.size()));
    archive_write_header(tar, entry);
    archive_write_data(tar, m.content.data(), m.content.size());
    archive_entry_free(entry);
  }
  archive_write_free(tar);
}

TEST_F(SourceFiles, OfAnArchiveTheWantedFilesAreTakenInTheirOrder) {
  const std::string large = long_text(300'000);
  write_tgz(file_, {{"a/1", "one"},
                    {"a", "", AE_IFDIR},
                    {"a/2", large},
                    {"b/3", "other"},
                    {"a/link", "", AE_IFLNK},
                    {"a/4", ""}});
  std::vector<std::string> received;
  const auto wanted = [](std::string_view name) { return name.starts_with("a"); };
  const auto take = [&](std::string_view name, const std::string& content) -> base::Result<void> {
    received.push_back(std::string(name) + (content == large ? "=large" : "=" + content));
    return {};
  };
  ASSERT_TRUE(read_tgz(file_, large.size(), wanted, take));
  EXPECT_THAT(received, ElementsAre("a/1=one", "a/2=large", "a/4="));
  const auto too_large = read_tgz(file_, large.size() - 1, wanted, take);
  ASSERT_FALSE(too_large);
  EXPECT_EQ(too_large.error(), (base::Error{Errc::parse, "is too large", file_.string() + ":a/2", ""}));
  received.clear();
  const auto stopped = read_tgz(file_, large.size(), wanted,
                                [&](std::string_view name, const std::string&) -> base::Result<void> {
                                  received.emplace_back(name);
                                  return base::fail(Errc::cancelled, "enough");
                                });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().what, "enough");
  EXPECT_THAT(received, ElementsAre("a/1"));
}

TEST_F(SourceFiles, AnArchiveThatIsNoneOrCutOffIsDamaged) {
  const auto error = [this] {
    const auto read = read_tgz(
        file_, 1'000'000, [](std::string_view) { return true; },
        [](std::string_view, const std::string&) -> base::Result<void> { return {}; });
    return read ? base::Error{} : read.error();
  };
  write_tgz(file_, {{"a", long_text(300'000)}});
  EXPECT_EQ(error(), base::Error{});
  fs::resize_file(file_, fs::file_size(file_) / 2);
  EXPECT_EQ(error(), (base::Error{Errc::parse, "is damaged: it is cut off", file_.string(), ""}));
  write_gz(long_text(5000));
  EXPECT_EQ(error().code, Errc::parse) << "a gzip of no tar";
  write("no gzip");
  EXPECT_EQ(error().code, Errc::parse);
}

}  // namespace
}  // namespace nazori::ingest
