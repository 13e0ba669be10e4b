// SPDX-License-Identifier: Apache-2.0
// Writing from memory without a session, going from character to character, and finding one: states and
// sentences.
#include <QComboBox>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>

#include "characters/characters.h"
#include "characters/draw_panel.h"
#include "characters/drawing_pad.h"
#include "hand_under_test.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/kanji_text.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

class Writing : public WindowTest {
 protected:
  Writing() { pages_ = {make}; }
  static std::unique_ptr<Page> make(WindowParts& parts) {
    parts_of_writing = &parts;
    auto made = std::make_unique<Characters>(parts);
    characters_of_writing = made.get();
    return made;
  }
  static practice::MemoryStage& memory() { return parts_of_writing->practice().memory(); }
  std::string said() { return feedback().toStdString(); }
  void begin(char32_t character) {
    show(character);
    action("memory")->trigger();
  }
  /// Writes a stroke of the character and waits for the announcement.
  void put(char32_t character, std::size_t stroke) {
    parts_of_writing->announce(Feedback::hint, QStringLiteral("not judged yet"));
    memory().add_stroke(test::hand_stroke(test::model(character)[stroke], static_cast<double>(stroke) * 3));
    ASSERT_TRUE(QTest::qWaitFor([&] { return feedback() != QStringLiteral("not judged yet"); }, 20'000));
  }
  QString enabled() {
    QStringList all;
    for (const char* name :
         {"undo_stroke", "done", "hint", "give_up", "compare_over", "compare_beside", "play"})
      if (action(name)->isEnabled()) all.append(QString::fromLatin1(name));
    return all.join(QLatin1Char(' '));
  }
  bool says(const char* words) {
    return QTest::qWaitFor([&] { return feedback().contains(QString::fromUtf8(words)); }, 20'000);
  }
  /// Waits until another character is shown.
  void after(const std::function<void()>& what) {
    QSignalSpy shown(window_.get(), &MainWindow::character_shown);
    what();
    ASSERT_TRUE(shown.count() > 0 || shown.wait(20'000)) << said();
  }
  static inline WindowParts* parts_of_writing = nullptr;
  static inline Characters* characters_of_writing = nullptr;
};

TEST_F(Writing, EveryStepHasItsActionsAndItsSentence) {
  begin(U'十');
  const auto entry =
      kanji::KanjiDatabase::open(std::filesystem::path(qgetenv("NAZORI_DATA").toStdString()) / "kanji.db")
          ->find(U'十')
          ->entry;
  EXPECT_EQ(feedback(), QStringLiteral("%1, %2: Write the character (2 strokes). H: hint. Enter: finish.")
                            .arg(kun_plain(kanji::split_kun(entry.kun_readings.front())),
                                 to_text(entry.meanings.front().text)));
  EXPECT_EQ(enabled(), QStringLiteral("done hint give_up"));
  action("done")->trigger();
  EXPECT_EQ(said(), "Nothing written yet. H: show the first stroke.");
  action("hint")->trigger();
  EXPECT_EQ(said(), "Stroke 1 is shown in blue. H again: show all remaining strokes.");
  action("hint")->trigger();
  EXPECT_EQ(said(), "All remaining strokes are shown in blue.");
  put(U'十', 0);
  EXPECT_EQ(said(), "Stroke 1 is correct. 1 to go.");
  EXPECT_EQ(enabled(), QStringLiteral("undo_stroke done hint give_up compare_over compare_beside play"));
  action("hint")->trigger();
  EXPECT_EQ(said(), "Stroke 2 is shown in blue. H again: show all remaining strokes.")
      << "counted anew after a stroke";
  action("undo_stroke")->trigger();
  EXPECT_EQ(said(), "Undone. 0 strokes written.");
  EXPECT_EQ(enabled(), QStringLiteral("done hint give_up"));
  put(U'十', 0);
  memory().add_stroke(test::hand_stroke(test::model(U'十')[1], 3));
  ASSERT_TRUE(says("of 5 stars"));
  EXPECT_EQ(enabled(), QStringLiteral("undo_stroke hint give_up compare_over compare_beside play"));
  action("hint")->trigger();
  EXPECT_EQ(said(), "All strokes written. Enter: finish.");
  action("give_up")->trigger();
  EXPECT_EQ(said(), "This is how it is written. Delete: clear and try again.");
  EXPECT_FALSE(memory().has_unjudged());
}

TEST_F(Writing, JudgedAtTheEndNothingIsMarkedBefore) {
  begin(U'十');
  action("judge_each")->trigger();
  EXPECT_EQ(said(), "Your writing is checked at the end: press Enter.");
  put(U'十', 0);
  EXPECT_EQ(said(), "1 stroke written. Enter: finish.");
  const auto verdict = [] { return parts_of_writing->tablet().overlay().writing.front().verdict; };
  EXPECT_EQ(verdict(), view::Verdict::none);
  action("judge_each")->trigger();
  EXPECT_EQ(said(), "Each stroke is checked as you finish it.");
  EXPECT_EQ(verdict(), view::Verdict::right);
  EXPECT_TRUE(memory().has_unjudged());
  action("judge_each")->trigger();
  action("done")->trigger();
  ASSERT_TRUE(says("D: show it.")) << said();
  EXPECT_EQ(verdict(), view::Verdict::right) << "judged as a whole, it is seen";
  EXPECT_FALSE(memory().has_unjudged());
}

TEST_F(Writing, ATabletThatIsFullTakesNoMore) {
  begin(U'十');
  const practice::HandStroke stroke{{{0, 0}, 0, 0.5}, {{0.01, 0}, 0.1, 0.5}};
  for (std::size_t i = 0; i < writing::kMaxInkStrokes; ++i) memory().add_stroke(stroke);
  EXPECT_EQ(memory().strokes().size(), writing::kMaxInkStrokes);
  memory().add_stroke(stroke);
  EXPECT_EQ(memory().strokes().size(), writing::kMaxInkStrokes);
  EXPECT_EQ(said(), "The tablet is full. Delete: clear it.");
  action("clear_ink")->trigger();
  EXPECT_TRUE(memory().strokes().empty());
  EXPECT_TRUE(parts_of_writing->tablet().overlay().writing.empty());
}

TEST_F(Writing, TheEraserAndTheKeyTakeBackOneStrokeEach) {
  begin(U'十');
  put(U'十', 0);
  memory().add_stroke(test::hand_stroke(test::model(U'休')[0], 5));
  parts_of_writing->tablet().eraser_used();
  EXPECT_EQ(said(), "Undone. 1 stroke written.");
  EXPECT_EQ(memory().strokes().size(), 1U);
  int back = 0;
  const base::Connection counting = memory().continued.connect([&] { ++back; });
  action("undo_stroke")->trigger();
  parts_of_writing->tablet().eraser_used();
  EXPECT_EQ(back, 1) << "there was nothing left";
}

TEST_F(Writing, HowItIsJudgedIsChosenAndRemembered) {
  begin(U'十');
  auto* slider = find<QSlider>("strictness");
  const auto checked = [this] {
    return QStringLiteral("%1%2%3")
        .arg(action("lenient")->isChecked())
        .arg(action("normal")->isChecked())
        .arg(action("strict")->isChecked());
  };
  EXPECT_EQ(checked(), QStringLiteral("010"));
  action("lenient")->trigger();
  EXPECT_EQ(slider->value(), 0);
  EXPECT_EQ(checked(), QStringLiteral("100"));
  EXPECT_EQ(said(), "Strictness: lenient.");
  action("more_strict")->trigger();
  EXPECT_EQ(slider->value(), 1);
  EXPECT_EQ(checked(), QStringLiteral("000"));
  action("strict")->trigger();
  EXPECT_EQ(slider->value(), 20);
  action("more_lenient")->trigger();
  EXPECT_EQ(slider->value(), 19);
  action("normal")->trigger();
  EXPECT_EQ(slider->value(), 10);
  EXPECT_EQ(checked(), QStringLiteral("010"));
  action("strict")->trigger();
  action("judge_each")->trigger();
  action("groove_appears")->trigger();
  window_->close();
  open_window();
  EXPECT_EQ(find<QSlider>("strictness")->value(), 20);
  EXPECT_EQ(checked(), QStringLiteral("001"));
  EXPECT_FALSE(action("judge_each")->isChecked());
  EXPECT_TRUE(action("groove_appears")->isChecked());
  action("groove_hidden")->trigger();
  window_->close();
  QSettings(folder_.filePath(QStringLiteral("nazori.ini")), QSettings::IniFormat)
      .setValue(QStringLiteral("characters/strictness"), 1.5);
  open_window();
  EXPECT_TRUE(action("groove_hidden")->isChecked());
  EXPECT_EQ(find<QSlider>("strictness")->value(), 10) << "what makes no sense is not taken";
}

TEST_F(Writing, BackAndForwardGoAlongTheWayUntilAnotherIsTaken) {
  const auto here = [this] { return window_->windowTitle().section(QLatin1Char(' '), 0, 0); };
  ASSERT_EQ(here(), QStringLiteral("休"));
  QSignalSpy shown(window_.get(), &MainWindow::character_shown);
  action("back")->trigger();
  action("forward")->trigger();
  show(U'木');
  show(U'雨');
  EXPECT_EQ(shown.count(), 2) << "there was no way to go";
  after([&] { action("back")->trigger(); });
  EXPECT_EQ(here(), QStringLiteral("木"));
  after([&] { action("back")->trigger(); });
  EXPECT_EQ(here(), QStringLiteral("休"));
  after([&] { action("forward")->trigger(); });
  EXPECT_EQ(here(), QStringLiteral("木"));
  show(U'水');
  shown.clear();
  action("forward")->trigger();
  after([&] { action("back")->trigger(); });
  EXPECT_EQ(shown.count(), 1) << "what lay ahead is forgotten";
  EXPECT_EQ(here(), QStringLiteral("木"));
}

TEST_F(Writing, NextAndPreviousAreThoseOfTheList) {
  auto* tiles = find<QListView>("character_grid")->model();
  ASSERT_TRUE(QTest::qWaitFor([&] { return tiles->rowCount() == 80; }, 5'000));
  const auto tile = [&](int row) { return tiles->index(row, 0).data().toString(); };
  const auto here = [this] { return window_->windowTitle().section(QLatin1Char(' '), 0, 0); };
  show(tile(4).toUcs4().front());
  EXPECT_EQ(find<QListView>("character_grid")->currentIndex().row(), 4);
  after([&] { action("next_character")->trigger(); });
  EXPECT_EQ(here(), tile(5));
  after([&] { action("previous_character")->trigger(); });
  after([&] { action("previous_character")->trigger(); });
  EXPECT_EQ(here(), tile(3));
  show(tile(79).toUcs4().front());
  QSignalSpy shown(window_.get(), &MainWindow::character_shown);
  action("next_character")->trigger();
  show(U'龍');
  EXPECT_EQ(shown.count(), 1) << "after the last there is none";
  after([&] { action("next_character")->trigger(); });
  EXPECT_EQ(here(), tile(0)) << "from outside to the first";
}

TEST_F(Writing, WithoutASessionTheShownCharacterIsPutAside) {
  auto& store = parts_of_writing->learner().store();
  show(U'木');
  action("study_pause")->trigger();
  EXPECT_EQ(said(), "Suspended 木 until you resume it.");
  EXPECT_TRUE(store.card(U'木').paused);
  action("study_pause")->trigger();
  EXPECT_EQ(said(), "Resumed 木.");
  EXPECT_FALSE(store.card(U'木').paused);
  action("study_postpone")->trigger();
  EXPECT_EQ(said(), "Postponed 木 to tomorrow.");
  EXPECT_EQ(store.card(U'木').postponed_until, store.today() + std::chrono::days(1));
  study::Writing writing;
  ASSERT_TRUE(store.add_writing(U'木', 4, writing));
  action("study_reset")->trigger();
  EXPECT_EQ(said(), "Started 木 over as a new character. Ctrl+Shift+Z: undo.");
  EXPECT_EQ(store.card(U'木').memory.reps, 0);
  action("study_undo")->trigger();
  EXPECT_EQ(said(), "Undone: your progress with 木 is back.");
}

TEST_F(Writing, TakesPicturesAndStrokesFromFilesAndNothingElse) {
  const auto opens = [](std::initializer_list<const char*> names) {
    QStringList paths;
    for (const char* name : names) paths.append(QString::fromLatin1(name));
    return characters_of_writing->opens(paths);
  };
  for (const char* name : {"/a/b.png", "b.RAW", "b.str"}) EXPECT_TRUE(opens({name})) << name;
  EXPECT_TRUE(opens({"a.png", "a.str"}));
  EXPECT_FALSE(opens({"a.png", "a.txt"}));
  EXPECT_FALSE(opens({"a"}));
}

TEST_F(Writing, TheListsAreNamedAndOneIsShownUntilSomethingIsSearched) {
  auto* lists = find<QComboBox>("lists");
  QStringList names;
  for (int i = 0; i < lists->count(); ++i) names.append(lists->itemText(i));
  EXPECT_EQ(
      names.join(QLatin1Char('|')),
      QStringLiteral(
          "Grade 1|Grade 2|Grade 3|Grade 4|Grade 5|Grade 6|Secondary school|Kanji for names|Hiragana|"
          "Katakana|Letters and digits|My characters|All characters|Old JLPT level 4 (before 2010)|"
          "Old JLPT level 3 (before 2010)|Old JLPT level 2 (before 2010)|Old JLPT level 1 (before 2010)"));
  lists->setCurrentIndex(8);
  emit lists->activated(8);
  auto* tiles = find<QListView>("character_grid")->model();
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return tiles->index(0, 0).data().toString() == QStringLiteral("あ"); }, 5'000));
  EXPECT_EQ(parts_of_writing->preferences().list, kanji::List::hiragana);
  EXPECT_EQ(text("list_count"), QString::number(tiles->rowCount()));
  EXPECT_EQ(find<QLabel>("list_count")->accessibleName(),
            QStringLiteral("%1 characters").arg(tiles->rowCount()));
  action("find")->trigger();
  auto* search = find<QLineEdit>("search");
  EXPECT_TRUE(search->hasFocus());
  search->setText(QStringLiteral(" 休 "));
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("list_count").endsWith(QStringLiteral("found")); }, 5'000));
  EXPECT_EQ(lists->currentIndex(), -1);
  EXPECT_EQ(tiles->index(0, 0).data().toString(), QStringLiteral("休"));
  QTest::keyClick(search, Qt::Key_Down);
  EXPECT_TRUE(find<QListView>("character_grid")->hasFocus());
  EXPECT_TRUE(find<QListView>("character_grid")->currentIndex().isValid());
  QTest::keyClick(search, Qt::Key_Escape);
  EXPECT_TRUE(search->text().isEmpty());
  ASSERT_TRUE(QTest::qWaitFor([&] { return lists->currentIndex() == 8; }, 5'000));
  show(U'か');
  after([&] { emit find<QListView>("character_grid")->clicked(tiles->index(2, 0)); });
  EXPECT_EQ(window_->windowTitle().section(QLatin1Char(' '), 0, 0), tiles->index(2, 0).data().toString());
}

TEST_F(Writing, WhatIsDrawnIsFoundAndChosenByKeyOrPointer) {
  action("draw_to_find")->trigger();
  EXPECT_EQ(said(), "Draw the character you are looking for. Stroke order and direction hardly matter.");
  auto* pad = find<DrawingPad>("drawing_pad");
  EXPECT_TRUE(pad->hasFocus());
  auto* found = find<QListWidget>("candidates");
  const double side = std::min(pad->width(), pad->height());
  for (const auto& line : test::model(U'木')) {
    const auto at = [&](geometry::GlyphPoint p) {
      return QPoint(int(p.x / 109 * side), int(p.y / 109 * side));
    };
    QTest::mousePress(pad, Qt::LeftButton, {}, at(line.front()));
    for (std::size_t i = 1; i < line.size(); ++i) {
      QMouseEvent move(QEvent::MouseMove, at(line[i]), at(line[i]), Qt::NoButton, Qt::LeftButton, {});
      QCoreApplication::sendEvent(pad, &move);
    }
    QTest::mouseRelease(pad, Qt::LeftButton, {}, at(line.back()));
  }
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return found->count() > 3 && found->item(0)->text() == QStringLiteral("木"); }, 60'000));
  EXPECT_EQ(said(), "Best match: 木 (kanji, tree). Enter: open it.");
  EXPECT_LE(found->count(), DrawPanel::kMostCandidates);
  QTest::keyClick(pad, Qt::Key_Right);
  EXPECT_EQ(feedback(), QStringLiteral("%1, 2 of %2.").arg(found->item(1)->toolTip()).arg(found->count()));
  QTest::keyClick(pad, Qt::Key_Down);
  const int below = found->currentRow();
  EXPECT_GT(below, 2) << "a row below";
  EXPECT_GT(found->visualItemRect(found->item(below)).top(), found->visualItemRect(found->item(1)).top());
  QTest::keyClick(pad, Qt::Key_Up);
  EXPECT_EQ(found->currentRow(), 1);
  QTest::keyClick(pad, Qt::Key_Up);
  EXPECT_EQ(found->currentRow(), 0);
  QTest::keyClick(pad, Qt::Key_Z);
  EXPECT_EQ(pad->ink().strokes.size(), 4U) << "only with Control";
  QTest::keyClick(pad, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(pad->ink().strokes.size(), 3U);
  QTest::keyClick(pad, Qt::Key_Backspace);
  EXPECT_EQ(pad->ink().strokes.size(), 2U);
  find<QPushButton>("draw_undo")->click();
  EXPECT_EQ(pad->ink().strokes.size(), 1U);
  find<QPushButton>("draw_clear")->click();
  EXPECT_TRUE(pad->ink().strokes.empty());
  EXPECT_EQ(found->count(), 0);
  QTest::keyClick(pad, Qt::Key_Return);
  EXPECT_TRUE(find("draw_panel")->isVisible()) << "there is nothing to take";
  find<QPushButton>("draw_close")->click();
  EXPECT_FALSE(find("draw_panel")->isVisible());
  EXPECT_EQ(said(), "Closed. The tablet was not changed.");
  EXPECT_FALSE(action("draw_to_find")->isChecked());
  action("draw_to_find")->trigger();
  action("find")->trigger();
  EXPECT_FALSE(find("draw_panel")->isVisible()) << "searching takes its place";
  EXPECT_TRUE(find("library_panel")->isVisible());
}

}  // namespace
}  // namespace nazori::ui
