// SPDX-License-Identifier: Apache-2.0
// Characters made in the workshop and kept: the window lists, shows and studies them.
#include <QComboBox>
#include <QLabel>
#include <QListView>

#include "nazori/author/character_file.h"
#include "nazori/author/collection.h"
#include "workshop_window.h"

namespace nazori::ui {
namespace {

class CollectionWindow : public WorkshopWindow {
 protected:
  void SetUp() override {
    own_characters_ = folder_.filePath(QStringLiteral("characters"));
    WorkshopWindow::SetUp();
  }

  [[nodiscard]] author::Collection collection() const {
    return author::Collection(own_characters_.toStdString());
  }
  static author::OwnCharacter sign(const std::string& name) {
    author::OwnCharacter made;
    made.facts.name = name;
    made.facts.meanings = {"a sign of ours"};
    made.strokes.push_back({{{{20, 30}, 3, 1}, {{90, 35}, 3, 1}}, kanji::StrokeEnding::stop, {}});
    return made;
  }
  void open(const author::OwnCharacter& character) {
    const QString path = folder_.filePath(QStringLiteral("sign.nazori"));
    ASSERT_TRUE(author::save_character(character, path.toStdString()));
    WorkshopWindow::open(path);
  }
  std::vector<char32_t> kept() {
    std::vector<char32_t> code_points;
    const auto content = collection().read();
    for (const auto& one : content->characters) code_points.push_back(one.code_point);
    return code_points;
  }
};

TEST_F(CollectionWindow, AnOwnCharacterIsKeptAndIsInTheListAndOnTheTablet) {
  open(sign("our sign"));
  press_and_finish(Qt::Key_A);
  EXPECT_EQ(
      feedback(),
      QStringLiteral("“our sign” is among your characters now: in lists, search, study and worksheets."));
  ASSERT_EQ(kept().size(), 1U);
  const char32_t code_point = kept().front();
  press(Qt::Key_1, Qt::AltModifier);
  auto* lists = find<QComboBox>("lists");
  const int own = lists->findText(QStringLiteral("My characters"));
  ASSERT_GE(own, 0);
  lists->setCurrentIndex(own);
  emit lists->activated(own);
  auto* grid = find<QListView>("character_grid");
  ASSERT_TRUE(QTest::qWaitFor([grid] { return grid->model()->rowCount() == 1; }));
  show(code_point);
}

TEST_F(CollectionWindow, ANameIsAskedForFirst) {
  open(sign(""));
  press_and_finish(Qt::Key_A);
  EXPECT_EQ(feedback(), QStringLiteral("Give the character a name first."));
  EXPECT_TRUE(kept().empty());
}

TEST_F(CollectionWindow, WithTheSameNameItIsReplacedOrKeptBesideOrNot) {
  ASSERT_TRUE(collection().keep(sign("our sign")));
  author::OwnCharacter other = sign("our sign");
  other.facts.meanings = {"another"};
  open(other);
  answer_with(QStringLiteral("Go back"));
  action("workshop_keep")->trigger();
  finish_files();
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_EQ(collection().find(kept().front())->facts.meanings.front(), "a sign of ours");
  answer_with(QStringLiteral("Replace it"));
  action("workshop_keep")->trigger();
  finish_files();
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_EQ(collection().find(kept().front())->facts.meanings.front(), "another");
  answer_with(QStringLiteral("Keep both"));
  action("workshop_keep")->trigger();
  finish_files();
  EXPECT_EQ(kept().size(), 2U);
}

TEST_F(CollectionWindow, AKeptCharacterIsOpenedChangedAndSavedInItsPlace) {
  const char32_t code_point = collection().keep(sign("our sign")).value();
  show(code_point);
  press(Qt::Key_2, Qt::AltModifier);
  press_and_finish(Qt::Key_C);
  EXPECT_EQ(character(), sign("our sign"));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("our sign – Nazori"));
  press(Qt::Key_3);
  press(Qt::Key_N);
  press(Qt::Key_R);
  press_and_finish(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(kept(), std::vector<char32_t>{code_point});
  EXPECT_EQ(collection().find(code_point)->strokes.front().points.front().at, (geometry::GlyphPoint{90, 35}));
}

TEST_F(CollectionWindow, AKeptCharacterIsTakenOutAndStaysInTheWorkshop) {
  const char32_t code_point = collection().keep(sign("our sign")).value();
  action("workshop_remove_kept")->trigger();
  finish_files();
  EXPECT_EQ(feedback(),
            QStringLiteral("This is not one of your kept characters. Open one of them with C first."));
  show(code_point);
  press(Qt::Key_2, Qt::AltModifier);
  press_and_finish(Qt::Key_C);
  answer_with(QStringLiteral("Go back"));
  action("workshop_remove_kept")->trigger();
  finish_files();
  EXPECT_EQ(kept().size(), 1U);
  answer_with(QStringLiteral("Take it out"));
  action("workshop_remove_kept")->trigger();
  finish_files();
  EXPECT_TRUE(kept().empty());
  EXPECT_EQ(character(), sign("our sign"));
  EXPECT_EQ(feedback(), QStringLiteral("“our sign” is no longer among your characters. A keeps it again."));
}

TEST_F(CollectionWindow, ANameThatAnotherProgramTookMeanwhileIsAskedAbout) {
  open(sign("our sign"));
  ASSERT_TRUE(collection().keep(sign("our sign")));
  answer_with(QStringLiteral("Keep both"));
  press_and_finish(Qt::Key_A);
  EXPECT_EQ(kept().size(), 2U);
}

class FormWindow : public CollectionWindow {
 protected:
  /// A copy of 永 as somebody corrects it: without its last stroke.
  static author::OwnCharacter form() {
    author::OwnCharacter made = sign("永");
    made.strokes.push_back({{{{30, 50}, 3, 1}, {{90, 95}, 3, 1}}, kanji::StrokeEnding::taper, {}});
    return made;
  }
  void keep(const QString& answer) {
    answer_with(answer);
    press_and_finish(Qt::Key_A);
    // Without a screen nobody gives the focus back after a question.
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitFor([this] { return window_->isActiveWindow(); }));
  }
};

TEST_F(FormWindow, IsUsedInsteadOfThePublishedCharacterUntilItIsTakenOut) {
  open(form());
  keep(QStringLiteral("Use it instead"));
  EXPECT_EQ(feedback(), QStringLiteral("Your form is used instead of the published 永 now: in lists, search, "
                                       "study and worksheets."));
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_EQ(collection().find(kept().front())->facts.instead_of, U'永');
  EXPECT_TRUE(action("workshop_instead")->isChecked());
  EXPECT_TRUE(description().contains(QStringLiteral("Used instead of the published 永.")));
  show(U'永');
  EXPECT_TRUE(find<QLabel>("facts")->text().contains(
      QStringLiteral("2 strokes here, 5 in the dictionary · your own form instead of the published one")))
      << find<QLabel>("facts")->text().toStdString();
  press(Qt::Key_2, Qt::AltModifier);
  // The file that it was opened from has the choice, too.
  EXPECT_TRUE(workshop->bench().editor().state().is_saved);
  const auto file = author::load_character(folder_.filePath(QStringLiteral("sign.nazori")).toStdString());
  EXPECT_EQ(file->facts.instead_of, U'永');
  press_and_finish(Qt::Key_C);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Opened ")))
      << "its own form, no copy; " << feedback().toStdString();
  EXPECT_EQ(character().strokes, form().strokes);
  answer_with(QStringLiteral("Take it out"));
  action("workshop_remove_kept")->trigger();
  finish_files();
  EXPECT_EQ(feedback(),
            QStringLiteral("The published 永 is used again. Your form is still here; A keeps it again."));
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_TRUE(QTest::qWaitFor(
      [this] { return find<QLabel>("facts")->text().startsWith(QStringLiteral("5 strokes")); }, 20000))
      << find<QLabel>("facts")->text().toStdString();
  EXPECT_FALSE(find<QLabel>("facts")->text().contains(QStringLiteral("your own form")));
}

TEST_F(FormWindow, WhatWasNotSavedIsNotSavedByKeepingIt) {
  open(form());
  drag({20, 60}, {90, 60});
  keep(QStringLiteral("Use it instead"));
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_FALSE(workshop->bench().editor().state().is_saved);
  const auto file = author::load_character(folder_.filePath(QStringLiteral("sign.nazori")).toStdString());
  EXPECT_EQ(file->strokes.size(), 2U);
  EXPECT_FALSE(file->facts.instead_of);
}

TEST_F(FormWindow, StandsBesideWhereThatIsTheAnswerAndNothingIsKeptAfterGoBack) {
  open(form());
  keep(QStringLiteral("Go back"));
  EXPECT_TRUE(kept().empty());
  keep(QStringLiteral("Keep it beside"));
  ASSERT_EQ(kept().size(), 1U) << feedback().toStdString();
  EXPECT_FALSE(collection().find(kept().front())->facts.instead_of);
  EXPECT_FALSE(action("workshop_instead")->isChecked());
  show(U'永');
  EXPECT_TRUE(find<QLabel>("facts")->text().startsWith(QStringLiteral("5 strokes")));
}

TEST_F(FormWindow, TheChoiceHasAKeyIsUndoneAndHoldsOnceItIsKept) {
  const char32_t code_point = collection().keep(form()).value();
  show(code_point);
  press(Qt::Key_2, Qt::AltModifier);
  press_and_finish(Qt::Key_C);
  press(Qt::Key_A, Qt::ShiftModifier);
  EXPECT_EQ(feedback(), QStringLiteral("Once kept (A), it is used instead of the published 永."));
  EXPECT_TRUE(action("workshop_instead")->isChecked());
  EXPECT_FALSE(collection().find(code_point)->facts.instead_of);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(action("workshop_instead")->isChecked());
  press(Qt::Key_A, Qt::ShiftModifier);
  press_and_finish(Qt::Key_A);
  EXPECT_EQ(collection().find(code_point)->facts.instead_of, U'永') << "not asked: it was kept already";
  press(Qt::Key_A, Qt::ShiftModifier);
  EXPECT_EQ(feedback(), QStringLiteral("Once kept (A), it stands beside the published 永."));
  press_and_finish(Qt::Key_A);
  EXPECT_FALSE(collection().find(code_point)->facts.instead_of);
}

TEST_F(FormWindow, OnlyAFormOfAPublishedCharacterCanTakeItsPlace) {
  open(sign("our sign"));
  press(Qt::Key_A, Qt::ShiftModifier);
  EXPECT_EQ(feedback(), QStringLiteral("Only a form of a published character can be used instead of it: give "
                                       "it that name. D: name."));
  EXPECT_FALSE(action("workshop_instead")->isChecked());
  EXPECT_FALSE(character().facts.instead_of);
}

}  // namespace
}  // namespace nazori::ui
