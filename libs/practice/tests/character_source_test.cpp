// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/character_source.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "database_under_test.h"
#include "nazori/author/collection.h"
#include "temporary_folder.h"

namespace nazori::practice {
namespace {

namespace fs = std::filesystem;

author::OwnCharacter bar_called(const std::string& name) {
  author::OwnCharacter sign;
  sign.facts.name = name;
  sign.strokes = {{{{{20, 50}, 3, 1}, {{90, 50}, 3, 1}}, kanji::StrokeEnding::stop, {}}};
  return sign;
}

class CharacterBookTest : public testing::Test {
 protected:
  [[nodiscard]] fs::path own() const { return folder_ / "characters"; }
  [[nodiscard]] author::Collection collection() const { return author::Collection(own()); }
  /// Whether the database is another one; nothing where it cannot be opened.
  static std::optional<bool> look(CharacterBook& book) {
    const auto seen = book.look();
    return seen ? std::optional(*seen) : std::nullopt;
  }
  nazori::test::TemporaryFolder folder_;
  CharacterBook book_{{test::database(), own()}};
};

TEST_F(CharacterBookTest, IsOpenedByTheFirstLookAndOnlyThen) {
  EXPECT_EQ(book_.database(), nullptr);
  EXPECT_EQ(look(book_), true);
  ASSERT_NE(book_.database(), nullptr);
  EXPECT_TRUE(book_.database()->find(U'休'));
  EXPECT_EQ(look(book_), false);
  EXPECT_EQ(book_.source().own, own());
  EXPECT_EQ(book_.source().database, test::database());
}

TEST_F(CharacterBookTest, IsReadAgainAfterEachChangeAtTheSamePlace) {
  ASSERT_EQ(look(book_), true);
  const kanji::KanjiDatabase* const place = book_.database();
  const char32_t sign = collection().keep(bar_called("our bar")).value();
  EXPECT_FALSE(book_.database()->find(sign)) << "not before it is looked into";
  EXPECT_EQ(look(book_), true);
  EXPECT_EQ(book_.database(), place);
  EXPECT_TRUE(book_.database()->find(sign));
  EXPECT_EQ(look(book_), false);
  ASSERT_TRUE(collection().keep(bar_called("another name"), sign));
  EXPECT_EQ(look(book_), true);
  EXPECT_EQ(book_.database()->summary(sign)->meaning, "another name");
  ASSERT_TRUE(collection().remove(sign));
  EXPECT_EQ(look(book_), true);
  EXPECT_FALSE(book_.database()->find(sign));
  EXPECT_EQ(look(book_), false);
}

TEST_F(CharacterBookTest, HasTheFormsThatTakeThePlaceOfPublishedOnes) {
  author::OwnCharacter form = bar_called("休");
  form.facts.instead_of = U'休';
  const char32_t code_point = collection().keep(form).value();
  ASSERT_EQ(look(book_), true);
  EXPECT_EQ(book_.database()->find(U'休')->own_form, code_point);
  EXPECT_EQ(book_.database()->find(U'休')->strokes.size(), 1U);
}

TEST_F(CharacterBookTest, WithoutAFolderHasThePublishedCharactersAlone) {
  ASSERT_TRUE(collection().keep(bar_called("our bar")));
  CharacterBook published{test::database()};
  EXPECT_EQ(look(published), true);
  EXPECT_TRUE(published.database()->list(kanji::List::own).empty());
  EXPECT_EQ(look(published), false);
}

TEST_F(CharacterBookTest, TriesAgainWhereItCannotBeOpened) {
  const fs::path database = folder_ / "kanji.db";
  CharacterBook book{{database, own()}};
  const auto missing = book.look();
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, base::Errc::not_found);
  EXPECT_EQ(book.database(), nullptr);
  fs::create_symlink(test::database(), database);
  EXPECT_EQ(look(book), true);
  EXPECT_NE(book.database(), nullptr);
  // A change that cannot be read takes the old content away, and it comes back.
  fs::remove(database);
  EXPECT_EQ(look(book), false) << "nothing has changed";
  ASSERT_TRUE(collection().keep(bar_called("our bar")));
  EXPECT_EQ(look(book), std::nullopt);
  EXPECT_EQ(book.database(), nullptr);
  fs::create_symlink(test::database(), database);
  EXPECT_EQ(look(book), true);
  EXPECT_EQ(book.database()->list(kanji::List::own).size(), 1U);
}

}  // namespace
}  // namespace nazori::practice
