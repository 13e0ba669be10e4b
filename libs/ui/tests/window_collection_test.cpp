// SPDX-License-Identifier: Apache-2.0
// Characters made in the workshop and kept: the window lists, shows and studies them.
#include <QComboBox>
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
    workshop->open_files({path});
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
  press(Qt::Key_A);
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
  press(Qt::Key_A);
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
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_EQ(collection().find(kept().front())->facts.meanings.front(), "a sign of ours");
  answer_with(QStringLiteral("Replace it"));
  action("workshop_keep")->trigger();
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_EQ(collection().find(kept().front())->facts.meanings.front(), "another");
  answer_with(QStringLiteral("Keep both"));
  action("workshop_keep")->trigger();
  EXPECT_EQ(kept().size(), 2U);
}

TEST_F(CollectionWindow, AKeptCharacterIsOpenedChangedAndSavedInItsPlace) {
  const char32_t code_point = collection().keep(sign("our sign")).value();
  show(code_point);
  press(Qt::Key_2, Qt::AltModifier);
  press(Qt::Key_C);
  EXPECT_EQ(character(), sign("our sign"));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("our sign – Nazori"));
  press(Qt::Key_3);
  press(Qt::Key_N);
  press(Qt::Key_R);
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(kept(), std::vector<char32_t>{code_point});
  EXPECT_EQ(collection().find(code_point)->strokes.front().points.front().at, (geometry::GlyphPoint{90, 35}));
}

TEST_F(CollectionWindow, AKeptCharacterIsTakenOutAndStaysInTheWorkshop) {
  const char32_t code_point = collection().keep(sign("our sign")).value();
  action("workshop_remove_kept")->trigger();
  EXPECT_EQ(feedback(),
            QStringLiteral("This is not one of your kept characters. Open one of them with C first."));
  show(code_point);
  press(Qt::Key_2, Qt::AltModifier);
  press(Qt::Key_C);
  answer_with(QStringLiteral("Go back"));
  action("workshop_remove_kept")->trigger();
  EXPECT_EQ(kept().size(), 1U);
  answer_with(QStringLiteral("Take it out"));
  action("workshop_remove_kept")->trigger();
  EXPECT_TRUE(kept().empty());
  EXPECT_EQ(character(), sign("our sign"));
  EXPECT_EQ(feedback(), QStringLiteral("“our sign” is no longer among your characters. A keeps it again."));
}

}  // namespace
}  // namespace nazori::ui
