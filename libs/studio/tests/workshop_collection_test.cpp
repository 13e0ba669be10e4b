// SPDX-License-Identifier: Apache-2.0
// Characters that the learner keeps from the workshop: beside published ones, instead of them, and taken out.
#include "nazori/author/character_file.h"
#include "nazori/author/collection.h"
#include "workshop_page_under_test.h"

namespace nazori::ui {
namespace {

using test::sentence;

class KeptFromTheWorkshop : public test::WorkshopPageTest {
 protected:
  KeptFromTheWorkshop() {
    QObject::connect(&parts_, &WindowParts::own_characters_changed, &window_, [this] { ++changes_; });
  }
  [[nodiscard]] author::Collection collection() const {
    return author::Collection(file("own").toStdString());
  }
  [[nodiscard]] std::vector<char32_t> kept() const {
    std::vector<char32_t> code_points;
    const auto content = collection().read();
    for (const auto& one : content->characters) code_points.push_back(one.code_point);
    return code_points;
  }
  /// A character of one stroke with this name.
  void make(const char* called) {
    place({{20, 40}, {80, 40}});
    name(called);
  }
  QString by_keeping() {
    said_.clear();
    actions().keep->trigger();
    return said_of_files();
  }
  static author::OwnCharacter sign(const char* called) {
    author::OwnCharacter made;
    made.facts.name = called;
    made.facts.meanings = {"kept before"};
    made.strokes.push_back({{{{20, 30}, 3, 1}, {{90, 35}, 3, 1}}, kanji::StrokeEnding::stop, {}});
    return made;
  }
  /// Opens a kept character in the workshop.
  void open_kept(char32_t code_point) {
    parts_.preferences().kanji = code_point;
    said_.clear();
    actions().copy->trigger();
    ASSERT_TRUE(said_of_files().startsWith(sentence("Opened "))) << all_said().toStdString();
  }
  int changes_ = 0;
};

TEST_F(KeptFromTheWorkshop, NeedANameAndAStroke) {
  EXPECT_EQ(by(actions().keep), sentence("Give the character a name first."));
  EXPECT_EQ(kind_, Feedback::wrong);
  name("our sign");
  EXPECT_EQ(by(actions().keep), sentence("Draw a stroke first: there is nothing yet that could be written."));
  EXPECT_EQ(kind_, Feedback::wrong);
  EXPECT_TRUE(kept().empty());
  EXPECT_EQ(changes_, 0);
}

TEST_F(KeptFromTheWorkshop, AreAmongTheCharactersAndSavedInTheirPlace) {
  make("our sign");
  EXPECT_EQ(by_keeping(),
            sentence("“our sign” is among your characters now: in lists, search, study and worksheets."));
  EXPECT_EQ(kind_, Feedback::good);
  EXPECT_EQ(changes_, 1);
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_TRUE(bench().editor().state().is_saved);
  EXPECT_EQ(page_->title(), sentence("our sign")) << "its name, not that of its file";
  // To save is to keep it in its place.
  place({{20, 60}, {80, 60}});
  page_->ask_and_save();
  said_of_files();
  EXPECT_EQ(changes_, 2);
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_EQ(collection().find(kept().front())->strokes.size(), 2U);
  // A copy has a name of its own.
  choose_file({}, [](QFileDialog& dialog) {
    EXPECT_EQ(QFileInfo(dialog.selectedFiles().value(0)).completeBaseName(), sentence("our sign"));
  });
  actions().save_copy->trigger();
}

TEST_F(KeptFromTheWorkshop, ADocumentElsewhereStaysTheDocument) {
  make("our sign");
  page_->write(file("one.nazori"));
  said_of_files();
  EXPECT_EQ(changes_, 0) << "a file elsewhere is no kept character";
  by_keeping();
  EXPECT_EQ(page_->title(), sentence("one.nazori"));
  EXPECT_EQ(kept().size(), 1U);
}

TEST_F(KeptFromTheWorkshop, WithTheNameOfAnotherTheyTakeItsPlaceOrStandBesideIt) {
  ASSERT_TRUE(collection().keep(sign("our sign")));
  make("our sign");
  page_->write(file("one.nazori"));
  said_of_files();
  const auto meanings = [this] { return collection().find(kept().front())->facts.meanings; };
  const int focused = focused_;
  answer("same_name_box", "Go back");
  actions().keep->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return focused_ > focused && !page_->is_busy_with_files(); }, 20'000));
  EXPECT_EQ(meanings(), std::vector<std::string>{"kept before"});
  answer("same_name_box", "Replace it");
  by_keeping();
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_TRUE(meanings().empty());
  answer("same_name_box", "Keep both");
  by_keeping();
  EXPECT_EQ(kept().size(), 2U);
}

TEST_F(KeptFromTheWorkshop, AreTakenOutAndStayInTheWorkshop) {
  EXPECT_EQ(by(actions().remove_kept),
            sentence("This is not one of your kept characters. Open one of them with C first."));
  EXPECT_EQ(kind_, Feedback::hint);
  open_kept(collection().keep(sign("our sign")).value());
  EXPECT_EQ(bench().character(), sign("our sign"));
  answer("remove_kept_box", "Go back");
  int focused = focused_;
  EXPECT_EQ(by(actions().remove_kept), QString());
  EXPECT_EQ(focused_, focused + 1);
  EXPECT_EQ(kept().size(), 1U);
  answer("remove_kept_box", "Take it out");
  said_.clear();
  actions().remove_kept->trigger();
  EXPECT_EQ(said_of_files(), sentence("“our sign” is no longer among your characters. A keeps it again."));
  EXPECT_EQ(changes_, 1);
  EXPECT_TRUE(kept().empty());
  EXPECT_EQ(bench().character(), sign("our sign"));
  by_keeping();
  EXPECT_EQ(kept().size(), 1U);
}

TEST_F(KeptFromTheWorkshop, AFormIsUsedInsteadOfThePublishedCharacterUntilItIsTakenOut) {
  make("永");
  page_->write(file("one.nazori"));
  said_of_files();
  answer("use_form_box", "Go back");
  EXPECT_EQ(by(actions().keep), QString());
  EXPECT_TRUE(kept().empty());
  answer("use_form_box", "Use it instead");
  said_.clear();
  const int focused = focused_;
  actions().keep->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return said_.size() > 1 && !page_->is_busy_with_files(); }, 20'000));
  EXPECT_EQ(focused_, focused + 1);
  EXPECT_EQ(said_.back(),
            sentence("Your form is used instead of the published 永 now: in lists, search, study "
                     "and worksheets."));
  EXPECT_TRUE(actions().instead->isChecked());
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_EQ(collection().find(kept().front())->facts.instead_of, U'永');
  // The file it was saved in follows the answer, because nothing else changed.
  EXPECT_EQ(author::load_character(file("one.nazori").toStdString())->facts.instead_of, U'永');
  EXPECT_TRUE(bench().editor().state().is_saved);
  open_kept(kept().front());
  answer("remove_kept_box", "Take it out");
  said_.clear();
  actions().remove_kept->trigger();
  EXPECT_EQ(said_of_files(),
            sentence("The published 永 is used again. Your form is still here; A keeps it again."));
}

TEST_F(KeptFromTheWorkshop, WhatWasNotSavedIsNotSavedByTheAnswer) {
  make("永");
  page_->write(file("one.nazori"));
  said_of_files();
  place({{20, 60}, {80, 60}});
  answer("use_form_box", "Use it instead");
  actions().keep->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return kept().size() == 1 && !page_->is_busy_with_files(); }, 20'000));
  EXPECT_EQ(author::load_character(file("one.nazori").toStdString())->strokes.size(), 1U);
  EXPECT_FALSE(bench().editor().state().is_saved);
}

TEST_F(KeptFromTheWorkshop, AFormBesideThePublishedOneIsNotUsedInsteadOfIt) {
  make("永");
  answer("use_form_box", "Keep it beside");
  EXPECT_EQ(by_keeping(),
            sentence("“永” is among your characters now: in lists, search, study and worksheets."));
  EXPECT_FALSE(collection().find(kept().front())->facts.instead_of);
  // The choice has a key, and holds once it is kept.
  EXPECT_EQ(by(actions().instead),
            sentence("Details changed.|Once kept (A), it is used instead of the published 永."));
  EXPECT_EQ(kind_, Feedback::good);
  EXPECT_TRUE(actions().instead->isChecked());
  EXPECT_FALSE(collection().find(kept().front())->facts.instead_of);
  by_keeping();
  EXPECT_EQ(collection().find(kept().front())->facts.instead_of, U'永') << "it was kept already: not asked";
  EXPECT_EQ(by(actions().instead),
            sentence("Details changed.|Once kept (A), it stands beside the published 永."));
  EXPECT_FALSE(actions().instead->isChecked());
}

TEST_F(KeptFromTheWorkshop, OnlyAFormOfAPublishedCharacterCanTakeItsPlace) {
  for (const char* called : {"our sign", "", "\U000F1A2B"}) {
    name(called);
    EXPECT_EQ(by(actions().instead),
              sentence("Only a form of a published character can be used instead of it: "
                       "give it that name. D: name."));
    EXPECT_EQ(kind_, Feedback::hint);
    EXPECT_FALSE(actions().instead->isChecked());
  }
}

}  // namespace
}  // namespace nazori::ui
