// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/font_models.h"

#include <gtest/gtest.h>

#include "characters.h"

namespace nazori::author::test {
namespace {

// Of fonts-kouzan-mouhitsu and fonts-aoyagi-kouzan-t.
const std::string kKouzan = "KouzanBrushFont";
const std::string kAoyagi = "AoyagiKouzanFontT";

class FontModelsTest : public testing::Test {
 protected:
  FontModelsTest() {
    models_.listed.connect([this](const std::vector<BrushFont>& fonts) { fonts_ = fonts.size(); });
    models_.made.connect([this](const MadeModel& made) {
      EXPECT_EQ(finished_, 0);
      EXPECT_EQ(made.model.has_value(), made.character != U'休');
      families_.push_back(made.family);
      made_.push_back(made.character);
    });
    models_.finished.connect([this] { ++finished_; });
  }

  base::Inbox inbox_;
  std::size_t fonts_ = 0;
  std::u32string made_;
  std::vector<std::string> families_;
  int finished_ = 0;
  FontModels models_{inbox_};
  const std::vector<KnownCharacter> some_{
      {U'三', kanjivg("三")}, {U'休', kanjivg("三")}, {U'十', kanjivg("十")}};
};

TEST_F(FontModelsTest, AreMadeInOrderAlsoAfterOneThatCannotBe) {
  EXPECT_FALSE(models_.is_busy());
  models_.make(kKouzan, some_);
  EXPECT_TRUE(models_.is_busy());
  inbox_.run_until([this] { return finished_ > 0; });
  EXPECT_EQ(made_, U"三休十");
  EXPECT_FALSE(models_.is_busy());
}

TEST_F(FontModelsTest, OnlyTheNewestRequestIsAnswered) {
  models_.make(kKouzan, some_);
  models_.make(kAoyagi, {some_[2]});
  inbox_.run_until([this] { return finished_ > 0; });
  EXPECT_EQ(made_, U"十");
  EXPECT_EQ(families_, std::vector{kAoyagi});
}

TEST_F(FontModelsTest, WhatIsCancelledIsNotAnswered) {
  models_.make(kKouzan, some_);
  models_.cancel();
  EXPECT_FALSE(models_.is_busy());
  models_.list();
  inbox_.run_until([this] { return fonts_ > 0; });
  EXPECT_TRUE(made_.empty());
  EXPECT_EQ(finished_, 0);
}

}  // namespace
}  // namespace nazori::author::test
