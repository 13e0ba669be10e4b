// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/mistake_kind.h"

#include <gtest/gtest.h>

#include <array>

namespace nazori::kanji {
namespace {

/// As docs/file-formats.md names them in learner.db and in exported files.
constexpr std::array<std::string_view, 9> kSaved{"order", "reversed", "missing", "extra", "joined",
                                                 "split", "wrong",    "other",   "ending"};

TEST(MistakeKind, KeepsTheNamesAndNumbersThatAreSaved) {
  for (std::size_t number = 0; number < kSaved.size(); ++number) {
    const auto kind = static_cast<MistakeKind>(number);
    EXPECT_EQ(name_of(kind), kSaved[number]);
    EXPECT_EQ(mistake_named(kSaved[number]), kind);
  }
  EXPECT_EQ(MistakeKind::order, MistakeKind{0});
  EXPECT_EQ(MistakeKind::wrong, MistakeKind{6});
  EXPECT_EQ(MistakeKind::ending, MistakeKind{8});
}

TEST(MistakeKind, OtherTextAndNumbersAreNoKind) {
  EXPECT_EQ(mistake_named(""), std::nullopt);
  EXPECT_EQ(mistake_named("Wrong"), std::nullopt);
  EXPECT_EQ(mistake_named("wrong "), std::nullopt);
  EXPECT_EQ(mistake_named("fault"), std::nullopt);
  EXPECT_EQ(name_of(MistakeKind{9}), "");
  EXPECT_EQ(name_of(MistakeKind{255}), "");
}

}  // namespace
}  // namespace nazori::kanji
