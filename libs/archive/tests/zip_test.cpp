// SPDX-License-Identifier: Apache-2.0
#include "nazori/archive/zip.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <ctime>
#include <string_view>

namespace nazori::archive {
namespace {

std::vector<std::uint8_t> zip_of(const std::vector<std::pair<std::string, std::string>>& files) {
  ZipWriter writer;
  for (const auto& [name, content] : files) writer.add(name, content);
  auto bytes = writer.finish();
  if (!bytes) ADD_FAILURE() << base::to_line(bytes.error());
  return bytes.value_or(std::vector<std::uint8_t>{});
}

std::string text(const ZipMember& member) { return {member.content.begin(), member.content.end()}; }

std::string why_not(std::span<const std::uint8_t> bytes, const ZipLimits& limits = {}) {
  const auto members = read_zip(bytes, limits);
  return members ? std::string() : base::to_line(members.error());
}

TEST(Zip, WhatIsWrittenIsRead) {
  const auto bytes = zip_of({{"a.txt", "one"}, {"dir/b", std::string(100'000, 'x')}, {"empty", ""}});
  EXPECT_LT(bytes.size(), 2'000U);
  const auto members = read_zip(bytes);
  ASSERT_TRUE(members) << base::to_line(members.error());
  ASSERT_EQ(members->size(), 3U);
  EXPECT_EQ((*members)[0].name, "a.txt");
  EXPECT_EQ(text((*members)[0]), "one");
  EXPECT_EQ((*members)[1].name, "dir/b");
  EXPECT_EQ(text((*members)[1]), std::string(100'000, 'x'));
  EXPECT_TRUE((*members)[2].content.empty());
}

/// A number of `size` bytes, the lowest first, so far behind a mark.
std::uint32_t number_behind(const std::vector<std::uint8_t>& bytes, std::string_view mark, std::size_t behind,
                            std::size_t size) {
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t at = all.find(mark);
  if (at == std::string_view::npos || at + behind + size > bytes.size()) return 0xFFFFFFFFU;
  std::uint32_t number = 0;
  for (std::size_t i = size; i > 0; --i) number = number << 8U | bytes[at + behind + i - 1];
  return number;
}

// Places of the fields: PKWARE, APPNOTE.TXT 6.3.9, sections 4.3.7 and 4.3.12; Info-ZIP's extra field "UT".
TEST(Zip, OtherProgramsFindAPlainFileWithItsSizeAndTime) {
  constexpr std::time_t kTime = 1'790'000'001;
  ZipWriter writer(9, kTime);
  writer.add("a.txt", "twelve bytes");
  const auto bytes = writer.finish().value();
  EXPECT_EQ(number_behind(bytes, "PK\x03\x04", 22, 4), 12U) << "unpacked, in front of the content";
  EXPECT_EQ(number_behind(bytes, "PK\x01\x02", 24, 4), 12U) << "unpacked, in the directory";
  EXPECT_EQ(number_behind(bytes, "PK\x01\x02", 38, 4) >> 16U, 0100644U) << "a file that all may read";
  EXPECT_EQ(number_behind(bytes, "UT", 5, 4), static_cast<std::uint32_t>(kTime));
  // The end of the directory, 22 bytes, is the end of the file.
  EXPECT_EQ(number_behind(bytes, "PK\x05\x06", 20, 2), 0U);
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  EXPECT_EQ(all.find("PK\x05\x06") + 22, bytes.size());
}

TEST(Zip, OneMemberIsAZipAndSoAreAHundred) {
  EXPECT_EQ(why_not(zip_of({{"only", "1"}})), "");
  std::vector<std::pair<std::string, std::string>> files;
  for (int i = 0; i < 100; ++i) files.emplace_back("m" + std::to_string(i), "x");
  EXPECT_EQ(why_not(zip_of(files)), "");
  files.emplace_back("one more", "x");
  EXPECT_EQ(why_not(zip_of(files)), "has too many members");
  EXPECT_EQ(ZipLimits().bytes, 67'108'864U);
}

TEST(Zip, OnlyTheWantedMembersAreUnpacked) {
  const auto bytes = zip_of({{"a", "1"}, {"large", std::string(1000, 'x')}, {"b", "2"}});
  const auto members = read_zip(bytes, {.bytes = 10, .only = {"b", "missing", "a"}});
  ASSERT_TRUE(members) << base::to_line(members.error());
  ASSERT_EQ(members->size(), 2U);
  EXPECT_EQ((*members)[0].name, "a");
  EXPECT_EQ(text((*members)[1]), "2");
}

TEST(Zip, TheSameFilesAreTheSameBytes) {
  EXPECT_EQ(zip_of({{"a", "1"}, {"b", "2"}}), zip_of({{"a", "1"}, {"b", "2"}}));
  EXPECT_NE(zip_of({{"a", "1"}, {"b", "2"}}), zip_of({{"a", "1"}, {"b", "3"}}));
}

TEST(Zip, ADamagedOneIsRefused) {
  const auto bytes = zip_of({{"a.txt", "one hundred"}});
  EXPECT_EQ(why_not({}), "is not a ZIP");
  EXPECT_EQ(why_not(std::vector<std::uint8_t>(100, 'x')), "is not a ZIP");
  // The content of the member lies behind its header of 30 bytes and its name.
  bool found = false;
  for (std::size_t i = 35; i < 60; ++i) {
    auto other = bytes;
    other[i] ^= 0x20U;
    found = found || !why_not(other).empty();
  }
  EXPECT_TRUE(found);
  auto cut = bytes;
  cut.resize(40);
  EXPECT_FALSE(why_not(cut).empty());
}

TEST(Zip, LimitsHold) {
  const auto bytes = zip_of({{"a", std::string(1'000, 'x')}, {"b", std::string(1'000, 'y')}});
  EXPECT_EQ(why_not(bytes, {2, 2'000}), "");
  EXPECT_EQ(why_not(bytes, {1, 2'000}), "has too many members");
  EXPECT_EQ(why_not(bytes, {2, 1'999}), "b: unpacks to too much");
  EXPECT_EQ(why_not(bytes, {2, 999}), "a: unpacks to too much");
}

TEST(Zip, AMemberThatIsReadInPiecesMeetsTheLimitInAnyOfThem) {
  const auto bytes = zip_of({{"a", std::string(200'000, 'x')}});
  EXPECT_EQ(why_not(bytes, {1, 200'000}), "");
  EXPECT_EQ(why_not(bytes, {1, 199'999}), "a: unpacks to too much");
  EXPECT_EQ(why_not(bytes, {1, 100'000}), "a: unpacks to too much");
}

TEST(Zip, ACutOneIsRefusedWithTheReasonOfTheLibrary) {
  std::string noise;
  for (std::uint32_t n = 1; noise.size() < 5'000; n = n * 1'664'525U + 1'013'904'223U)
    noise.push_back(static_cast<char>(n >> 24U));
  auto bytes = zip_of({{"a", noise}});
  bytes.resize(2'000);
  const std::string why = why_not(bytes);
  EXPECT_EQ(why.find("a: is damaged: "), 0U) << why;
  EXPECT_EQ(why.find("it cannot be read"), std::string::npos) << why;
  EXPECT_GT(why.size(), std::string_view("a: is damaged: ").size());
}

TEST(Zip, TwoMembersOfOneNameAreRefused) {
  EXPECT_EQ(why_not(zip_of({{"a", "1"}, {"a", "2"}})), "a: is damaged: there are two members of one name");
}

}  // namespace
}  // namespace nazori::archive
