// SPDX-License-Identifier: Apache-2.0
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>

#include "nazori/author/character_file.h"
#include "workshop_window.h"

namespace nazori::ui {
namespace {

TEST_F(WorkshopWindow, AStrokeIsDrawnWithTheMouseListedAndUndone) {
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("Workshop – Nazori"));
  drag({20, 40}, {90, 40});
  ASSERT_EQ(character().strokes.size(), 1U);
  EXPECT_EQ(feedback(), QStringLiteral("Stroke drawn."));
  const auto* list = find<QListWidget>("workshop_strokes_list");
  ASSERT_EQ(list->count(), 1);
  EXPECT_EQ(list->currentRow(), 0);
  EXPECT_EQ(list->item(0)->text(), QStringLiteral("1  stop"));
  EXPECT_EQ(description(), QStringLiteral("No name yet: 1 stroke."));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(feedback(), QStringLiteral("Undone: stroke drawn."));
  EXPECT_EQ(list->count(), 0);
  EXPECT_FALSE(action("workshop_undo")->isEnabled());
  press(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(feedback(), QStringLiteral("Redone: stroke drawn."));
  EXPECT_EQ(character().strokes.size(), 1U);
}

TEST_F(WorkshopWindow, AStrokeIsMadeAndChangedByKeysAlone) {
  press(Qt::Key_2);
  EXPECT_EQ(feedback(), QStringLiteral("Tool: Place points."));
  press(Qt::Key_Return);
  EXPECT_EQ(feedback(), QStringLiteral("Place at least two points first: the start and the end."));
  canvas()->setFocus();
  press(Qt::Key_Space);
  EXPECT_EQ(feedback(), QStringLiteral("Point 1 placed. Enter: finish the stroke."));
  for (int i = 0; i < 30; ++i) press(Qt::Key_Right);
  press(Qt::Key_Space);
  press(Qt::Key_Return);
  ASSERT_EQ(character().strokes.size(), 1U);
  EXPECT_EQ(character().strokes[0].points.back().at, (geometry::GlyphPoint{84.5, 54.5}));
  press(Qt::Key_3);
  press(Qt::Key_N);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Stroke 1 of 1, stop, "))) << feedback().toStdString();
  press(Qt::Key_E);
  EXPECT_EQ(feedback(), QStringLiteral("Ending: hook."));
  EXPECT_EQ(character().strokes[0].ending, kanji::StrokeEnding::hook);
  press(Qt::Key_Period);
  EXPECT_TRUE(feedback().contains(QStringLiteral("Start: 54.5 from the left"))) << feedback().toStdString();
  press(Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_NEAR(character().strokes[0].points[0].at.y, 54.7, 1e-9);
  press(Qt::Key_Delete);
  press(Qt::Key_N);
  press(Qt::Key_Delete);
  EXPECT_EQ(feedback(), QStringLiteral("Stroke deleted."));
  press(Qt::Key_R);
  EXPECT_EQ(feedback(), QStringLiteral("Choose a stroke first. N: next stroke. Full stop: next point."));
}

TEST_F(WorkshopWindow, TheReliefIsChangedByHand) {
  press(Qt::Key_4);
  drag({20, 80}, {90, 80});
  EXPECT_EQ(feedback(), QStringLiteral("Groove cut."));
  EXPECT_FALSE(character().hand.is_untouched());
  EXPECT_EQ(description(), QStringLiteral("No name yet: no strokes. The relief was changed by hand."));
  press(Qt::Key_Delete, Qt::ControlModifier);
  EXPECT_TRUE(character().hand.is_untouched());
}

// What the device feels is the tablet of the window.
TEST_F(WorkshopWindow, WhatIsMadeIsFeltAfterEachEdit) {
  const auto feels = [](std::size_t strokes) {
    return QTest::qWaitFor(
        [&] {
          const auto& felt = workshop_parts->tablet().tablet();
          return felt && felt->lines().size() == strokes &&
                 felt->height_map() == workshop->bench().editor().map();
        },
        20000);
  };
  EXPECT_TRUE(feels(0));
  drag({20, 40}, {90, 40});
  EXPECT_TRUE(feels(1));
  press(Qt::Key_4);
  drag({20, 80}, {90, 80});
  EXPECT_TRUE(feels(1));
  press(Qt::Key_Z, Qt::ControlModifier);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(feels(0));
  press(Qt::Key_1);
  drag({20, 40}, {90, 40});
  EXPECT_TRUE(feels(1));
  press(Qt::Key_3);
  press(Qt::Key_N);
  press(Qt::Key_R);
  EXPECT_TRUE(QTest::qWaitFor([] {
    const auto& paths = workshop_parts->tablet().tablet()->paths();
    return paths.size() == 1 && paths[0].points.front().x > paths[0].points.back().x;
  })) << "the direction is felt, too";
  press(Qt::Key_1, Qt::AltModifier);
  const auto other = workshop_parts->tablet().tablet();
  QTest::qWait(50);
  EXPECT_EQ(workshop_parts->tablet().tablet(), other) << "the other page has its own tablet";
}

TEST_F(WorkshopWindow, ACopyOfTheCharacterShownKeepsItsLicence) {
  press(Qt::Key_C);
  EXPECT_TRUE(QTest::qWaitFor([this] { return !character().strokes.empty(); }, 20000));
  EXPECT_FALSE(character().facts.name.empty());
  EXPECT_EQ(find<QLineEdit>("workshop_licence")->text(), QStringLiteral("CC-BY-SA-3.0"));
  EXPECT_TRUE(find<QLineEdit>("workshop_licence")->isReadOnly());
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("A copy of "))) << feedback().toStdString();
}

TEST_F(WorkshopWindow, ADocumentIsSavedAndOpensAgainWithTheSameBytes) {
  drag({20, 40}, {90, 40});
  auto* name = find<QLineEdit>("workshop_name");
  name->setText(QStringLiteral("our sign"));
  emit name->editingFinished();
  EXPECT_EQ(character().facts.name, "our sign");
  const QString path = folder_.filePath(QStringLiteral("sign.nazori"));
  write(path);
  EXPECT_EQ(feedback(), QStringLiteral("Saved sign.nazori."));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("sign.nazori – Nazori"));
  press(Qt::Key_N, Qt::ControlModifier);
  EXPECT_TRUE(character().strokes.empty());
  press(Qt::Key_1, Qt::AltModifier);
  window_->open_files({path});
  finish_files();
  EXPECT_TRUE(canvas()->isVisible());
  EXPECT_EQ(feedback(), QStringLiteral("Opened sign.nazori."));
  EXPECT_EQ(character().facts.name, "our sign");
  ASSERT_EQ(character().strokes.size(), 1U);
  const QString again = folder_.filePath(QStringLiteral("again.nazori"));
  write(again);
  QFile first(path), second(again);
  ASSERT_TRUE(first.open(QIODevice::ReadOnly));
  ASSERT_TRUE(second.open(QIODevice::ReadOnly));
  const QByteArray bytes = first.readAll();
  EXPECT_GT(bytes.size(), 200);
  EXPECT_EQ(bytes, second.readAll());
}

TEST_F(WorkshopWindow, ADocumentThatAnotherWindowEditsIsNotOpenedNorReplaced) {
  drag({20, 40}, {90, 40});
  const QString path = folder_.filePath(QStringLiteral("sign.nazori"));
  write(path);
  press(Qt::Key_N, Qt::ControlModifier);
  finish_files();
  std::optional<author::Recovery> recovery;
  auto other = author::CharacterEditor::open(path.toStdString(), recovery, 64);
  ASSERT_TRUE(other);
  ASSERT_TRUE(other->autosave_to(author::journal_path(path.toStdString())));
  open(path);
  EXPECT_TRUE(
      feedback().startsWith(QStringLiteral("Could not open sign.nazori: another program is using it")))
      << feedback().toStdString();
  EXPECT_TRUE(character().strokes.empty());
  EXPECT_TRUE(workshop->bench().editor().state().is_autosaved) << "what stays is still kept for an emergency";
  write(path);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Could not save sign.nazori: ")));
  other->close_journal();
  open(path);
  EXPECT_EQ(character().strokes.size(), 1U);
  // The document that is open here may be opened again.
  drag({20, 60}, {90, 60});
  answer_with(QStringLiteral("Do not save"));
  open(path);
  EXPECT_EQ(character().strokes.size(), 1U) << feedback().toStdString();
}

/// Another window has work without a name.
class SecondWorkshopWindow : public WorkshopWindow {
 protected:
  void SetUp() override {
    journal_ = folder_.filePath(QStringLiteral("workshop.nazori.journal")).toStdString();
    ASSERT_TRUE(other_.autosave_to(journal_));
    ASSERT_TRUE(other_.draw_stroke({{.at = {20, 20}, .pressure = 1.0}, {.at = {80, 30}, .pressure = 0.5}}));
    WorkshopWindow::SetUp();
    finish_files();
  }
  author::CharacterEditor other_ = author::CharacterEditor::create({}, 64).value();
  std::filesystem::path journal_;
};

TEST_F(SecondWorkshopWindow, HasAJournalOfItsOwn) {
  EXPECT_TRUE(character().strokes.empty()) << "what the other window does is not work to bring back";
  drag({20, 40}, {90, 40});
  EXPECT_TRUE(other_.state().is_autosaved);
  author::Recovery recovery;
  EXPECT_FALSE(author::CharacterEditor::recover(journal_, recovery, 64));
  EXPECT_TRUE(
      author::is_being_edited(folder_.filePath(QStringLiteral("workshop-2.nazori.journal")).toStdString()));
}

TEST_F(WorkshopWindow, CopiesAreSavedInOtherFormats) {
  drag({20, 40}, {90, 40});
  for (const char* name : {"a.svg", "a.str", "a.raw", "a.png"}) {
    write(folder_.filePath(QString::fromLatin1(name)));
    EXPECT_EQ(feedback(), QStringLiteral("Saved a copy as %1.").arg(QString::fromLatin1(name)));
    EXPECT_TRUE(QFile::exists(folder_.filePath(QString::fromLatin1(name))));
  }
  EXPECT_FALSE(workshop->bench().editor().state().is_saved) << "a copy is not the document";
  write(folder_.filePath(QStringLiteral("a.txt")));
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Could not save a.txt: "))) << feedback().toStdString();
}

TEST_F(WorkshopWindow, ACheckSaysWhatItFindsAndAClickShowsIt) {
  press(Qt::Key_K);
  EXPECT_TRUE(feedback().contains(QStringLiteral("There are no strokes."))) << feedback().toStdString();
  drag({20, 40}, {90, 40});
  EXPECT_FALSE(action("workshop_check")->isChecked()) << "what was found is no longer true";
  drag({20, 44}, {90, 44});
  press(Qt::Key_K);
  auto* findings = find<QListWidget>("workshop_findings");
  ASSERT_GT(findings->count(), 0);
  int wall = -1;
  for (int i = 0; i < findings->count(); ++i)
    if (findings->item(i)->text().contains(QStringLiteral("wall between strokes 1 and 2"))) wall = i;
  ASSERT_GE(wall, 0) << feedback().toStdString();
  press(Qt::Key_P);
  emit findings->itemClicked(findings->item(wall));
  EXPECT_EQ(workshop->bench().selection().stroke, 0U);
}

TEST_F(WorkshopWindow, UnsavedWorkIsAskedAboutBeforeItIsReplaced) {
  drag({20, 40}, {90, 40});
  answer_with(QStringLiteral("Go back"));
  action("workshop_new")->trigger();
  EXPECT_EQ(character().strokes.size(), 1U);
  answer_with(QStringLiteral("Do not save"));
  action("workshop_new")->trigger();
  EXPECT_TRUE(character().strokes.empty());
}

TEST_F(WorkshopWindow, StrokesOfAFontAreFoundAndGetTheirOrder) {
  workshop->trace_font(QStringLiteral("Klee One"), U'三');
  EXPECT_TRUE(QTest::qWaitFor([] { return !workshop->is_tracing(); }, 30000));
  ASSERT_EQ(character().strokes.size(), 3U) << feedback().toStdString();
  EXPECT_EQ(character().facts.name, "三");
  EXPECT_LT(character().strokes[0].points[0].at.y, character().strokes[1].points[0].at.y);
  EXPECT_LT(character().strokes[1].points[0].at.y, character().strokes[2].points[0].at.y);
  for (const auto& stroke : character().strokes)
    EXPECT_LT(stroke.points.front().at.x + 20, stroke.points.back().at.x);
}

TEST_F(WorkshopWindow, APictureThatCannotBeReadChangesNothing) {
  drag({20, 40}, {90, 40});
  workshop->trace_picture(folder_.filePath(QStringLiteral("missing.png")), 0);
  EXPECT_TRUE(QTest::qWaitFor([] { return !workshop->is_tracing(); }, 30000));
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("No strokes were found: "))) << feedback().toStdString();
  EXPECT_EQ(character().strokes.size(), 1U);
}

TEST_F(WorkshopWindow, TheWheelZoomsAroundThePointer) {
  const QPointF at = canvas()->to_widget({30, 30});
  QWheelEvent in(at, canvas()->mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                 false);
  QCoreApplication::sendEvent(canvas(), &in);
  EXPECT_NEAR(canvas()->zoomed(), 1.44, 1e-9);
  EXPECT_NEAR(canvas()->to_glyph(at).x, 30, 1);
  press(Qt::Key_0);
  EXPECT_EQ(canvas()->zoomed(), 1);
}

TEST_F(WorkshopWindow, ACharacterInTheMakingBecomesTheTabletThatIsFelt) {
  drag({20, 40}, {90, 40});
  press(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(window_->windowTitle().startsWith(QStringLiteral("Own character")))
      << window_->windowTitle().toStdString();
}

}  // namespace
}  // namespace nazori::ui
