// SPDX-License-Identifier: Apache-2.0
#include "nazori/archive/zip.h"

#include <gtest/gtest.h>

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

TEST(Zip, TwoMembersOfOneNameAreRefused) {
  EXPECT_EQ(why_not(zip_of({{"a", "1"}, {"a", "2"}})), "a: is damaged: there are two members of one name");
}

}  // namespace
}  // namespace nazori::archive
