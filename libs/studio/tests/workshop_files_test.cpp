// SPDX-License-Identifier: Apache-2.0
// Files of the workshop: documents and copies, work that was interrupted, and strokes that are found
// elsewhere.
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QPainter>

#include "nazori/author/character_file.h"
#include "nazori/studio/workshop/trace_dialog.h"
#include "workshop_page_under_test.h"

namespace nazori::ui {
namespace {

using test::sentence;

class FilesOfTheWorkshop : public test::WorkshopPageTest {
 protected:
  QString by_writing(const QString& path) {
    said_.clear();
    page_->write(path);
    return said_of_files();
  }
  QString by_opening(const QString& path) {
    said_.clear();
    page_->open_files({path});
    return said_of_files();
  }
  void wait_until(const std::function<bool()>& met) {
    EXPECT_TRUE(QTest::qWaitFor(met, 20'000)) << all_said().toStdString();
  }
  void wait_for_files() {
    wait_until([this] { return !page_->is_busy_with_files(); });
  }
  [[nodiscard]] bool is_saved() const { return bench().editor().state().is_saved; }
};

TEST_F(FilesOfTheWorkshop, ADocumentIsSavedOpenedAndNamesThePage) {
  place({{20, 40}, {80, 40}});
  name("山");
  EXPECT_EQ(page_->title(), sentence("山"));
  int titles = 0;
  QObject::connect(page_.get(), &Page::title_changed, &window_, [&titles] { ++titles; });
  EXPECT_EQ(by_writing(file("one.nazori")), sentence("Saved one.nazori."));
  EXPECT_EQ(kind_, Feedback::good);
  EXPECT_GT(titles, 0);
  EXPECT_EQ(page_->title(), sentence("one.nazori"));
  EXPECT_TRUE(is_saved());
  const auto character = bench().character();
  EXPECT_EQ(by(actions().start_empty), sentence("An empty tablet. Draw the first stroke."));
  EXPECT_EQ(page_->title(), QString());
  EXPECT_TRUE(bench().character().strokes.empty());
  int focused = focused_;
  EXPECT_EQ(by_opening(file("one.nazori")), sentence("Opened one.nazori."));
  EXPECT_EQ(kind_, Feedback::good);
  EXPECT_EQ(focused_, focused + 1);
  EXPECT_EQ(bench().character(), character);
  EXPECT_EQ(page_->title(), sentence("one.nazori"));
  EXPECT_TRUE(by_opening(file("none.nazori")).startsWith(sentence("Could not open none.nazori: ")));
  EXPECT_EQ(kind_, Feedback::wrong);
  EXPECT_EQ(bench().character(), character);
  EXPECT_TRUE(bench().editor().state().is_autosaved) << "its journal goes on";
}

TEST_F(FilesOfTheWorkshop, ACopyLeavesTheDocumentAsItIs) {
  place({{20, 40}, {80, 40}});
  for (const char* copy : {"a.svg", "a.str", "a.raw", "a.png"}) {
    EXPECT_EQ(by_writing(file(copy)), sentence("Saved a copy as %1.").arg(sentence(copy)));
    EXPECT_EQ(kind_, Feedback::good);
    EXPECT_FALSE(is_saved());
    EXPECT_EQ(page_->title(), QString());
  }
  const int side = bench().editor().map().size();
  EXPECT_EQ(QImage(file("a.png")).size(), QSize(side, side));
  EXPECT_EQ(QFileInfo(file("a.raw")).size(), qint64{side} * side);
  const QString refused = by_writing(file("a.txt"));
  EXPECT_TRUE(refused.startsWith(sentence("Could not save a.txt: "))) << refused.toStdString();
  EXPECT_TRUE(refused.contains(sentence(".nazori, .svg, .str, .raw and .png are"))) << refused.toStdString();
  EXPECT_EQ(kind_, Feedback::wrong);
  for (const char* nowhere : {"no/a.svg", "no/a.nazori"})
    EXPECT_TRUE(by_writing(file(nowhere)).startsWith(sentence("Could not save a.")))
        << all_said().toStdString();
  EXPECT_FALSE(is_saved());
  // Strokes are no document: their file has no name for the page.
  answer("unsaved_character_box", "Do not save");
  EXPECT_EQ(by_opening(file("a.svg")), sentence("Opened a.svg."));
  EXPECT_EQ(bench().character().strokes.size(), 1U);
  EXPECT_NE(page_->title(), sentence("a.svg"));
}

TEST_F(FilesOfTheWorkshop, OnlyOneFileOfAKnownKindIsOpened) {
  EXPECT_TRUE(page_->opens({sentence("x/a.NAZORI")}));
  EXPECT_TRUE(page_->opens({sentence("a.svg")}));
  EXPECT_FALSE(page_->opens({sentence("a.png")}));
  EXPECT_FALSE(page_->opens({sentence("a.svg"), sentence("b.svg")}));
  EXPECT_FALSE(page_->opens({}));
  int wanted = 0;
  QObject::connect(page_.get(), &Page::wants_to_be_entered, &window_, [&wanted] { ++wanted; });
  by_opening(file("none.svg"));
  EXPECT_EQ(wanted, 0) << "it is shown";
}

TEST_F(FilesOfTheWorkshop, WhatIsNotSavedIsAskedAbout) {
  EXPECT_TRUE(page_->may_close(true)) << "it is empty";
  place({{20, 40}, {80, 40}});
  answer("unsaved_character_box", "Go back");
  EXPECT_FALSE(page_->may_close(true));
  answer("unsaved_character_box", "Go back");
  EXPECT_EQ(by(actions().start_empty), QString());
  EXPECT_EQ(bench().character().strokes.size(), 1U);
  answer("unsaved_character_box", "Save…");
  choose_file({});
  EXPECT_FALSE(page_->may_close(true)) << "no file was chosen";
  answer("unsaved_character_box", "Save…");
  choose_file(file("one.nazori"));
  EXPECT_TRUE(page_->may_close(true));
  EXPECT_TRUE(QFileInfo::exists(file("one.nazori")));
  EXPECT_FALSE(bench().editor().state().is_autosaved) << "there is nothing to bring back";
  place({{20, 60}, {80, 60}});
  answer("unsaved_character_box", "Do not save");
  EXPECT_TRUE(page_->may_close(true));
  EXPECT_EQ(author::load_character(file("one.nazori").toStdString())->strokes.size(), 1U);
}

TEST_F(FilesOfTheWorkshop, WhatIsDrawnWhileAFileIsReadIsAskedAbout) {
  place({{20, 40}, {80, 40}});
  by_writing(file("one.nazori"));
  by(actions().start_empty);
  for (const char* button : {"Go back", "Do not save"}) {
    page_->open_files({file("one.nazori")});
    place({{20, 60}, {80, 60}});
    answer("unsaved_character_box", button);
    wait_for_files();
    EXPECT_EQ(page_->title(), button[0] == 'G' ? QString() : sentence("one.nazori")) << button;
    if (button[0] == 'G') {
      answer("unsaved_character_box", "Do not save");
      by(actions().start_empty);
    }
  }
  EXPECT_EQ(bench().character().strokes.size(), 1U);
  EXPECT_EQ(stroke(0).points.front().at.y, 40);
}

TEST_F(FilesOfTheWorkshop, AreChosenInDialogsThatKnowTheFolderAndTheName) {
  const auto expect_proposed = [this](QAction* action, const char* wanted, const QString& title) {
    choose_file({}, [=](QFileDialog& dialog) {
      EXPECT_EQ(dialog.objectName(), sentence("workshop_file_dialog"));
      EXPECT_EQ(dialog.windowTitle(), title);
      EXPECT_EQ(dialog.acceptMode(), QFileDialog::AcceptSave);
      EXPECT_EQ(QFileInfo(dialog.selectedFiles().value(0)).completeBaseName(), sentence(wanted));
    });
    const int saves = saves_, focused = focused_;
    if (action == nullptr)
      page_->ask_and_save();
    else
      action->trigger();
    EXPECT_EQ(saves_, saves);
    EXPECT_EQ(focused_, focused + 1);
  };
  const QString whole = sentence("Save the character"), copy = sentence("Save a copy");
  place({{20, 40}, {80, 40}});
  expect_proposed(nullptr, "character", whole);
  name("a/b");
  expect_proposed(actions().save_copy, "a-b", copy);
  name("12345678901234567890123456789012345678901234567890");
  expect_proposed(nullptr, "1234567890123456789012345678901234567890", whole);
  const int saves = saves_;
  choose_file(file("kept"), [](QFileDialog& dialog) {
    EXPECT_EQ(dialog.nameFilters(), QStringList{sentence("Character (*.nazori)")});
  });
  page_->ask_and_save();
  EXPECT_EQ(said_of_files(), sentence("Saved kept.nazori."));
  EXPECT_EQ(saves_, saves + 1);
  EXPECT_EQ(parts_.preferences().folder, folder_.path());
  expect_proposed(actions().save_copy, "kept", copy);
  said_.clear();
  choose_file(file("strokes"), [](QFileDialog& dialog) {
    EXPECT_EQ(dialog.nameFilters(),
              (QStringList{sentence("Strokes as a drawing (*.svg)"), sentence("Stroke order of 2005 (*.str)"),
                           sentence("Height map, 8 bits (*.raw)"), sentence("Height map, 16 bits (*.png)")}));
    EXPECT_EQ(dialog.defaultSuffix(), sentence("svg"));
    emit dialog.filterSelected(dialog.nameFilters()[1]);
    EXPECT_EQ(dialog.defaultSuffix(), sentence("str"));
  });
  actions().save_copy->trigger();
  EXPECT_EQ(said_of_files(), sentence("Saved a copy as strokes.str."));
  parts_.preferences().folder.clear();
  choose_file({}, [](QFileDialog& dialog) {
    EXPECT_EQ(dialog.windowTitle(), sentence("Open a character"));
    EXPECT_EQ(dialog.nameFilters().size(), 4);
  });
  page_->ask_and_open();
  EXPECT_EQ(parts_.preferences().folder, QString());
  said_.clear();
  choose_file(file("kept.nazori"));
  page_->ask_and_open();
  EXPECT_EQ(said_of_files(), sentence("Opened kept.nazori."));
  EXPECT_EQ(parts_.preferences().folder, folder_.path());
}

TEST_F(FilesOfTheWorkshop, WorkThatWasInterruptedIsBack) {
  wait_for_files();
  place({{20, 40}, {80, 40}});
  place({{20, 60}, {80, 60}});
  const auto character = bench().character();
  EXPECT_TRUE(QFileInfo::exists(file("workshop.nazori.journal")));
  // As after a loss of power: the journal is there, and nobody writes it.
  QFile::copy(file("workshop.nazori.journal"), file("copy"));
  page_.reset();
  QFile::remove(file("workshop.nazori.journal"));
  QFile::rename(file("copy"), file("workshop.nazori.journal"));
  said_.clear();
  open_page();
  EXPECT_EQ(said_.back(), sentence("Your work that was interrupted is back: 2 changes."));
  EXPECT_EQ(kind_, Feedback::good);
  EXPECT_EQ(bench().character(), character);
  // Another window has a file of its own.
  WorkshopPage other(parts_);
  other.enter();
  EXPECT_TRUE(QTest::qWaitFor([&other] { return !other.is_busy_with_files(); }, 20'000));
  EXPECT_TRUE(other.bench().character().strokes.empty());
  EXPECT_TRUE(QFileInfo::exists(file("workshop-2.nazori.journal")));
}

TEST_F(FilesOfTheWorkshop, AJournalThatCannotBeReadIsToldAndANewOneBegins) {
  wait_for_files();
  page_.reset();
  {
    QFile damaged(file("workshop.nazori.journal"));
    ASSERT_TRUE(damaged.open(QIODevice::WriteOnly));
    damaged.write("no journal");
  }
  said_.clear();
  open_page();
  EXPECT_TRUE(said_.back().startsWith(sentence("Work that was interrupted could not be brought back: ")))
      << all_said().toStdString();
  EXPECT_EQ(kind_, Feedback::advice);
  wait_until([this] { return bench().editor().state().is_autosaved; });
}

TEST_F(FilesOfTheWorkshop, ACharacterOfTheDatabaseIsCopied) {
  actions().copy->trigger();
  wait_until([this] { return !bench().character().strokes.empty(); });
  EXPECT_EQ(said_.back(), sentence("A copy of 休. Change what you like."));
  EXPECT_EQ(kind_, Feedback::good);
  EXPECT_EQ(bench().character().strokes.size(), 6U);
  EXPECT_EQ(page_->title(), sentence("休"));
  parts_.preferences().kanji = U'☃';
  said_.clear();
  actions().copy->trigger();
  wait_until([this] { return !said_.isEmpty(); });
  EXPECT_EQ(all_said(), sentence("The database has no strokes of ☃."));
  EXPECT_EQ(kind_, Feedback::wrong);
  EXPECT_EQ(bench().character().strokes.size(), 6U);
}

TEST_F(FilesOfTheWorkshop, TheStrokesOfAPictureAreFoundWithOrWithoutItsCharacter) {
  QImage picture(300, 300, QImage::Format_RGB32);
  picture.fill(Qt::white);
  {
    QPainter painter(&picture);
    painter.setPen(QPen(Qt::black, 16, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(40, 130, 260, 130);
    painter.drawLine(150, 30, 150, 270);
  }
  ASSERT_TRUE(picture.save(file("ten.png")));
  const auto traced = [this](char32_t character) {
    said_.clear();
    page_->trace_picture(file("ten.png"), character);
    EXPECT_TRUE(page_->is_tracing());
    EXPECT_EQ(all_said(), sentence("Looking for strokes…"));
    wait_until([this] { return !page_->is_tracing() && said_.size() > 1; });
    return said_.back();
  };
  EXPECT_TRUE(traced(U'十').startsWith(sentence("2 strokes found in ten.png."))) << all_said().toStdString();
  EXPECT_EQ(kind_, Feedback::good);
  EXPECT_EQ(bench().character().facts.name, "十");
  EXPECT_EQ(bench().character().facts.rights.source, "ten.png");
  EXPECT_EQ(bench().character().strokes.size(), 2U);
  EXPECT_FALSE(all_said().contains(sentence("Look at these")));
  EXPECT_TRUE(traced(0).contains(sentence(" strokes found in ten.png.")));
  EXPECT_EQ(bench().character().facts.name, "");
  const auto character = bench().character();
  said_.clear();
  page_->trace_picture(file("none.png"), 0);
  wait_until([this] { return said_.size() > 1; });
  EXPECT_TRUE(said_.back().startsWith(sentence("No strokes were found: ")));
  EXPECT_TRUE(said_.back().endsWith(sentence(". The character was not changed.")));
  EXPECT_EQ(kind_, Feedback::wrong);
  EXPECT_EQ(bench().character(), character);
}

TEST_F(FilesOfTheWorkshop, TheQuestionsBeforeStrokesAreFoundProposeWhatIsShown) {
  choose_file({});
  EXPECT_EQ(by(actions().from_picture), QString());
  name("木");
  QImage white(64, 64, QImage::Format_RGB32);
  white.fill(Qt::white);
  ASSERT_TRUE(white.save(file("white.png")));
  choose_file(file("white.png"), [](QFileDialog& dialog) {
    EXPECT_EQ(dialog.nameFilters(), QStringList{sentence("Pictures (*.png *.jpg *.jpeg *.svg)")});
  });
  with_dialog<TraceDialog>([](TraceDialog& dialog) {
    EXPECT_EQ(dialog.character(), U'木');
    EXPECT_EQ(dialog.windowTitle(), sentence("Strokes of a picture"));
    static_cast<QDialog&>(dialog).reject();
  });
  const int focused = focused_;
  EXPECT_EQ(by(actions().from_picture), QString());
  EXPECT_EQ(focused_, focused + 1);
  EXPECT_EQ(parts_.preferences().folder, folder_.path());
  with_dialog<TraceDialog>([](TraceDialog& dialog) {
    EXPECT_EQ(dialog.character(), U'休');
    EXPECT_EQ(dialog.windowTitle(), sentence("Strokes of a font"));
    static_cast<QDialog&>(dialog).reject();
  });
  EXPECT_EQ(by(actions().from_font), QString());
  EXPECT_EQ(focused_, focused + 2);
  EXPECT_FALSE(page_->is_tracing());
}

TEST_F(FilesOfTheWorkshop, TheStrokesOfAFontAreFound) {
  page_->trace_font(sentence("KouzanBrushFont"), U'一');
  wait_until([this] { return !page_->is_tracing() && said_.size() > 1; });
  EXPECT_TRUE(said_.back().startsWith(sentence("1 strokes found in "))) << all_said().toStdString();
  EXPECT_EQ(bench().character().facts.name, "一");
}

}  // namespace
}  // namespace nazori::ui
