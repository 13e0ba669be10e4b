// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/worksheet_maker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <optional>

#include "learner_under_test.h"

namespace nazori::practice {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class WorksheetMakerTest : public LearnerTest {
 protected:
  WorksheetMakerTest() {
    maker_.shown.connect([this](const WorksheetView& view) { view_ = view, ++answers_; });
    maker_.refused.connect([this](const base::Error& error, std::size_t characters) {
      error_ = error;
      refused_ = characters;
      ++answers_;
    });
    maker_.saved.connect([this](const std::filesystem::path& path, std::size_t pages) {
      saved_ = path;
      pages_ = pages;
      ++answers_;
    });
    maker_.not_saved.connect([this](const std::filesystem::path&, const base::Error& error) {
      error_ = error;
      ++answers_;
    });
    maker_.progressed.connect([this](int percent) { percents_.push_back(percent); });
  }
  void wait(int answers = 1) {
    inbox_.run_until([&] { return answers_ >= answers; });
    answers_ = 0;
  }
  static WorksheetRequest request(std::vector<char32_t> characters) {
    WorksheetRequest made;
    made.characters = std::move(characters);
    made.choice.sheet.whole_page = true;
    return made;
  }
  static std::string content(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::optional<WorksheetView> view_;
  std::optional<base::Error> error_;
  std::filesystem::path saved_;
  std::size_t pages_ = 0;
  std::vector<int> percents_;
  std::size_t refused_ = 99;
  int answers_ = 0;
  WorksheetMaker maker_{inbox_, kanji_db()};
};

TEST_F(WorksheetMakerTest, ShowsThePageThatIsAskedFor) {
  maker_.show(request({U'休', U'永', U'\U0010FFFF'}), 1);
  wait();
  ASSERT_TRUE(view_);
  EXPECT_EQ(view_->pages, 2U);
  EXPECT_EQ(view_->page, 1U);
  EXPECT_EQ(view_->characters, 2U);
  EXPECT_THAT(view_->missing, ElementsAre(U'\U0010FFFF'));
  EXPECT_THAT(view_->drawing->text, HasSubstr("永\n"));
  EXPECT_THAT(view_->drawing->text, Not(HasSubstr("休\n")));
}

TEST_F(WorksheetMakerTest, AfterTheLastPageComesTheLastOne) {
  maker_.show(request({U'休', U'永'}), 7);
  wait();
  ASSERT_TRUE(view_);
  EXPECT_EQ(view_->page, 1U);
}

TEST_F(WorksheetMakerTest, OnlyTheNewestOfSeveralRequestsIsAnswered) {
  for (const char32_t c : {U'休', U'永', U'日'}) maker_.show(request({c}), 0);
  wait();
  EXPECT_THAT(view_->drawing->text, HasSubstr("日\n"));
  maker_.show(request({U'一'}), 0);
  wait();
  EXPECT_THAT(view_->drawing->text, HasSubstr("一\n"));
}

TEST_F(WorksheetMakerTest, ATextGivesItsCharactersOrIsTracedOnManuscriptPaper) {
  WorksheetRequest text = request({});
  text.choice.source = WorksheetSource::text;
  text.choice.text = "休む日";
  maker_.show(text, 0);
  wait();
  ASSERT_TRUE(view_) << base::to_line(*error_);
  EXPECT_EQ(view_->characters, 2U);
  text.choice.sheet.layout = print::Layout::manuscript;
  maker_.show(text, 0);
  wait();
  EXPECT_EQ(view_->characters, 0U);
  EXPECT_THAT(view_->drawing->text, HasSubstr("む\n"));
}

TEST_F(WorksheetMakerTest, SaysWhyThereIsNoSheet) {
  maker_.show(request({}), 0);
  wait();
  EXPECT_FALSE(view_);
  ASSERT_TRUE(error_);
  EXPECT_EQ(error_->code, base::Errc::bad_argument);
  EXPECT_EQ(refused_, 0U);
  WorksheetRequest large = request({U'休', U'永'});
  large.choice.sheet.whole_page = false;
  large.choice.sheet.rows = print::kMostRows;
  maker_.show(large, 0);
  wait();
  EXPECT_FALSE(view_);
  EXPECT_EQ(error_->code, base::Errc::bad_argument);
  EXPECT_EQ(refused_, 2U);
}

TEST_F(WorksheetMakerTest, WritesWhatItShows) {
  const WorksheetRequest both = request({U'休', U'永'});
  const auto file = folder_ / "sheet.pdf";
  maker_.save(both, file);
  EXPECT_TRUE(maker_.is_saving());
  wait();
  EXPECT_FALSE(maker_.is_saving());
  EXPECT_EQ(saved_, file);
  EXPECT_EQ(pages_, 2U);
  const auto database = kanji::KanjiDatabase::open(kanji_db());
  const std::vector<kanji::CharacterName> names{{U'休', {}}, {U'永', {}}};
  const auto expected =
      print::worksheet_pdf(sheet_characters(*database, names, both.choice.sheet).found, both.choice.sheet);
  EXPECT_TRUE(content(file) == expected.value());
  ASSERT_FALSE(percents_.empty());
  EXPECT_TRUE(std::is_sorted(percents_.begin(), percents_.end()));
}

TEST_F(WorksheetMakerTest, AFileThatCannotBeWrittenIsReported) {
  maker_.save(request({U'休'}), folder_ / "missing" / "sheet.pdf");
  wait();
  ASSERT_TRUE(error_);
  EXPECT_TRUE(saved_.empty());
}

TEST_F(WorksheetMakerTest, AStoppedFileIsNotWritten) {
  const auto file = folder_ / "sheet.pdf";
  maker_.save(request({U'休'}), file);
  maker_.stop();
  EXPECT_FALSE(maker_.is_saving());
  // The same thread answers this after it has ended the other.
  maker_.show(request({U'永'}), 0);
  wait();
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_TRUE(saved_.empty());
}

}  // namespace
}  // namespace nazori::practice
