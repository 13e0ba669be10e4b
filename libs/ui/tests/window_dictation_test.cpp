// SPDX-License-Identifier: Apache-2.0
#include <QToolButton>
#include <set>

#include "characters/character_actions.h"
#include "characters/characters.h"
#include "characters/stage_table.h"
#include "characters/word_boxes.h"
#include "hand_under_test.h"
#include "nazori/practice/dictation_stage.h"
#include "nazori/practice/stage_table.h"
#include "nazori/widgets/page/window_parts.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

using practice::DictationStage;

WindowParts* parts_of_dictation = nullptr;

std::unique_ptr<Page> make_characters_for_dictation(WindowParts& parts) {
  parts_of_dictation = &parts;
  return std::make_unique<Characters>(parts);
}

class Dictation : public WindowTest {
 protected:
  Dictation() { pages_ = {make_characters_for_dictation}; }

  static DictationStage& stage() { return parts_of_dictation->practice().get<DictationStage>(); }
  void begin(char32_t character) {
    show(character);
    press(Qt::Key_F9);
    ASSERT_TRUE(wait());
  }
  /// Until nothing is being looked up or judged.
  static bool wait() {
    return QTest::qWaitFor([] { return !stage().is_busy(); }, 20000);
  }
  static void write(char32_t character) {
    double begin_s = 0;
    for (const auto& line : test::model(character)) {
      stage().add_stroke(test::hand_stroke(line, begin_s += 3));
      ASSERT_TRUE(wait());
    }
  }
  static void write_word() {
    const auto characters = stage().word()->characters;
    for (const char32_t character : characters) write(character);
  }
  QString boxes() { return find("word_boxes")->accessibleDescription(); }
};

TEST(StageRows, AreThoseOfPracticeInTheirOrderWithKeysOfTheirOwn) {
  const auto kinds = practice::stage_kinds();
  const auto rows = stage_rows();
  ASSERT_EQ(rows.size(), kinds.size());
  std::set<std::string> keys;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].id, kinds[i].id);
    EXPECT_TRUE(keys.insert(rows[i].key).second) << rows[i].id;
  }
}

TEST_F(Dictation, ShowsReadingAndMeaningAboveTheTabletAndNotTheWord) {
  show(U'休');
  EXPECT_FALSE(find("dictation_strip")->isVisible());
  press(Qt::Key_F9);
  ASSERT_TRUE(wait());
  EXPECT_TRUE(find("dictation_strip")->isVisible());
  EXPECT_EQ(text("dictation_reading").toStdString(), stage().word()->prompt());
  EXPECT_TRUE(
      text("dictation_meaning").startsWith(QString::fromStdString(stage().word()->word.glosses.front())));
  EXPECT_FALSE(find("dictation_verdict")->isVisible());
  EXPECT_TRUE(feedback().contains(QStringLiteral("Character 1 of 2"))) << feedback().toStdString();
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("Write from memory – Nazori"));
  EXPECT_FALSE(find("glyph")->isVisible()) << "its information would give the word away";
  EXPECT_EQ(boxes(), QStringLiteral("Character 1: being written; Character 2: empty"));
  press(Qt::Key_F6);
  EXPECT_FALSE(find("dictation_strip")->isVisible());
}

TEST_F(Dictation, FinishedCharactersAppearInTheirBoxesAndTheWordHasAVerdict) {
  begin(U'休');
  const auto word = *stage().word();
  write(word.characters[0]);
  EXPECT_EQ(boxes(), QStringLiteral("Character 1: right; Character 2: being written"));
  EXPECT_TRUE(feedback().contains(QStringLiteral("Character 2 of 2"))) << feedback().toStdString();
  write(word.characters[1]);
  EXPECT_EQ(boxes(), QStringLiteral("Character 1: right; Character 2: right"));
  EXPECT_TRUE(feedback().contains(QStringLiteral("is right"))) << feedback().toStdString();
  EXPECT_TRUE(text("dictation_verdict").startsWith(QStringLiteral("Correct")));
  EXPECT_TRUE(text("dictation_reading").contains(QString::fromStdString(word.word.text)));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("休 – Nazori"));
  press(Qt::Key_Return);
  ASSERT_TRUE(wait());
  EXPECT_NE(stage().word()->word.text, word.word.text) << "Enter goes on to the next word";
}

TEST_F(Dictation, InASessionTheQuestionOfTheSessionDoesNotGiveTheWordAway) {
  show(U'休');
  ASSERT_TRUE(parts_of_dictation->session().start_with({U'休'}));
  EXPECT_TRUE(action("watch")->isChecked()) << "what is on the tablet is studied at once";
  EXPECT_TRUE(find("question_view")->isVisible());
  press(Qt::Key_F9);
  ASSERT_TRUE(wait());
  EXPECT_FALSE(find("question_view")->isVisible());
  press(Qt::Key_F5);
  EXPECT_TRUE(find("question_view")->isVisible());
}

TEST_F(Dictation, IsWrittenWithThePenOnTheTablet) {
  begin(U'一');
  const char32_t first = stage().word()->characters.front();
  const auto line = test::model(first).front();
  test::write(parts_of_dictation->tablet(), line);
  ASSERT_TRUE(QTest::qWaitFor([] { return !stage().attempt().is_empty() || stage().position() > 0; }, 10000));
}

TEST_F(Dictation, MistakesAreToldForEachCharacter) {
  begin(U'十');
  const auto word = *stage().word();
  auto line = test::model(word.characters[0]).front();
  std::reverse(line.begin(), line.end());
  stage().add_stroke(test::hand_stroke(line));
  ASSERT_TRUE(wait());
  EXPECT_TRUE(feedback().contains(QStringLiteral("1"))) << feedback().toStdString();
  press(Qt::Key_Return);
  ASSERT_TRUE(wait());
  EXPECT_EQ(boxes(), QStringLiteral("Character 1: not right; Character 2: being written"));
  press(Qt::Key_G);
  press(Qt::Key_Return);
  ASSERT_TRUE(wait());
  EXPECT_TRUE(feedback().contains(QStringLiteral("not right yet"))) << feedback().toStdString();
  const QStringList lines = text("dictation_verdict").split(QLatin1Char('\n'));
  ASSERT_EQ(lines.size(), 3);
  EXPECT_TRUE(lines[0].startsWith(QStringLiteral("Not quite")));
  EXPECT_GT(lines[1].size(), 5);
  EXPECT_TRUE(lines[2].contains(QStringLiteral("shown"))) << lines[2].toStdString();
}

TEST_F(Dictation, KeysUndoClearHintSpeakAndAskForAnotherWord) {
  begin(U'休');
  EXPECT_TRUE(action("speak")->isEnabled());
  press(Qt::Key_H);
  EXPECT_TRUE(feedback().contains(QStringLiteral("blue"))) << feedback().toStdString();
  const auto word = *stage().word();
  stage().add_stroke(test::hand_stroke(test::model(word.characters[0])[0]));
  ASSERT_TRUE(wait());
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(stage().attempt().is_empty());
  stage().add_stroke(test::hand_stroke(test::model(word.characters[0])[0]));
  ASSERT_TRUE(wait());
  press(Qt::Key_Delete);
  EXPECT_TRUE(stage().attempt().is_empty());
  int spoken = 0;
  const base::Connection counting = stage().speech_wanted.connect([&](const std::string&) { ++spoken; });
  press(Qt::Key_V);
  EXPECT_EQ(spoken, 1);
  EXPECT_TRUE(feedback().startsWith(QString::fromStdString(word.prompt()))) << feedback().toStdString();
  press(Qt::Key_W);
  ASSERT_TRUE(wait());
  EXPECT_NE(stage().word()->word.text, word.word.text);
  press(Qt::Key_F8);
  EXPECT_TRUE(action("speak")->isEnabled()) << "every stage speaks";
  EXPECT_FALSE(action("next_word")->isEnabled());
}

TEST_F(Dictation, ACharacterWithoutAWordCannotBeDictatedAndTheWindowSaysWhy) {
  show(U'休');
  EXPECT_TRUE(action("dictation")->isEnabled());
  show(U'A');
  EXPECT_FALSE(action("dictation")->isEnabled());
  EXPECT_TRUE(action("dictation")->toolTip().startsWith(QStringLiteral("No word")));
  begin(U'休');
  show(U'A');
  EXPECT_FALSE(action("dictation")->isChecked()) << "who looks a character up sees it";
  EXPECT_FALSE(find("dictation_strip")->isVisible());
  EXPECT_FALSE(action("hint")->isEnabled());
  show(U'休');
  EXPECT_TRUE(action("dictation")->isEnabled());
  EXPECT_TRUE(action("dictation")->toolTip().endsWith(QStringLiteral("(F9)")));
}

TEST_F(Dictation, TheStageSurvivesARestartAndHasAButtonWithAPicture) {
  begin(U'休');
  EXPECT_FALSE(action("dictation")->icon().isNull());
  EXPECT_NE(find<QToolButton>("tool_dictation"), nullptr);
  window_->close();
  open_window();
  EXPECT_TRUE(action("dictation")->isChecked());
  EXPECT_TRUE(QTest::qWaitFor([this] { return find("dictation_strip")->isVisible(); }, 10000));
}

}  // namespace
}  // namespace nazori::ui
