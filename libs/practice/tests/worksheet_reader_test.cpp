// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/worksheet_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <optional>

#include "learner_under_test.h"
#include "nazori/practice/worksheet_maker.h"

namespace nazori::practice {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class WorksheetReaderTest : public LearnerTest {
 protected:
  WorksheetReaderTest() {
    reader_.was_read.connect(
        [this](const std::shared_ptr<const WorksheetsRead>& photo) { read_.push_back(photo); });
    reader_.saved.connect([this](const fs::path& path) { saved_ = path; });
    reader_.refused.connect([this](const fs::path& path, const base::Error& error) {
      refused_.push_back(path.filename().string());
      error_ = error;
    });
  }
  void wait() {
    inbox_.run_until([&] { return reader_.waiting() == 0; });
  }
  /// A printed page with four cells for 休 as a picture.
  fs::path printed() {
    WorksheetMaker maker(inbox_, kanji_db());
    std::optional<std::size_t> pages;
    maker.saved.connect([&](const fs::path&, std::size_t count) { pages = count; });
    WorksheetRequest request;
    request.characters = {U'休'};
    request.choice.sheet.rows = 1;
    request.choice.sheet.copies = 0;
    maker.save(request, folder_ / "a.pdf");
    inbox_.run_until([&] { return pages.has_value(); });
    const std::string command =
        "pdftoppm -r 100 -png '" + (folder_ / "a.pdf").string() + "' '" + (folder_ / "photo").string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);  // NOLINT(concurrency-mt-unsafe)
    return folder_ / "photo-1.png";
  }

  std::vector<std::shared_ptr<const WorksheetsRead>> read_;
  fs::path saved_;
  std::vector<std::string> refused_;
  base::Error error_;
  WorksheetReader reader_{inbox_, kanji_db()};
};

TEST_F(WorksheetReaderTest, ReadsEachPhotographAndShowsItsCells) {
  const fs::path photo = printed();
  reader_.read(photo);
  reader_.read(photo);
  EXPECT_EQ(reader_.waiting(), 2);
  wait();
  ASSERT_EQ(read_.size(), 2U);
  EXPECT_EQ(read_[0]->photo, photo);
  ASSERT_EQ(read_[0]->sheets.size(), 1U);
  const auto& cells = read_[0]->sheets[0].cells;
  ASSERT_FALSE(cells.empty());
  for (const auto& cell : cells) {
    EXPECT_EQ(cell.box.character, U'休');
    EXPECT_EQ(cell.state, scan::CellState::empty);
  }
  const auto& picture = read_[0]->picture;
  EXPECT_EQ(picture.rgb.size(), 3U * static_cast<std::size_t>(picture.width * picture.height));
  EXPECT_TRUE(refused_.empty());
}

TEST_F(WorksheetReaderTest, SavesThePictureWhole) {
  reader_.read(printed());
  wait();
  ASSERT_EQ(read_.size(), 1U);
  const fs::path to = folder_ / "checked.png";
  reader_.save({read_[0], &read_[0]->picture}, to);
  wait();
  EXPECT_EQ(saved_, to);
  const auto bytes = surface::to_png(read_[0]->picture);
  EXPECT_EQ(fs::file_size(to), bytes.size());
}

TEST_F(WorksheetReaderTest, WhatCannotBeReadIsRefused) {
  std::ofstream(folder_ / "text.png") << "no picture";
  reader_.read(folder_ / "none.jpg");
  reader_.read(folder_ / "text.png");
  wait();
  EXPECT_THAT(refused_, ElementsAre("none.jpg", "text.png"));
  EXPECT_EQ(error_.code, base::Errc::parse);
}

TEST_F(WorksheetReaderTest, ReadsOnAfterARefusal) {
  reader_.read(folder_ / "none.jpg");
  reader_.read(printed());
  wait();
  EXPECT_THAT(refused_, ElementsAre("none.jpg"));
  EXPECT_EQ(read_.size(), 1U);
}

TEST_F(WorksheetReaderTest, AFolderThatIsMissingIsRefusedWhenSaving) {
  reader_.save(std::make_shared<surface::ColourPicture>(surface::ColourPicture{1, 1, {1, 2, 3}}),
               folder_ / "no" / "where.png");
  wait();
  EXPECT_THAT(refused_, ElementsAre("where.png"));
}

}  // namespace
}  // namespace nazori::practice
