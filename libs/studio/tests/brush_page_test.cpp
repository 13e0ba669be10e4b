// SPDX-License-Identifier: Apache-2.0
// What is chosen on the page for the brush, what is said of it, and what is there the next time.
#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>

#include "brush_page_under_test.h"

namespace nazori::ui {
namespace {

using test::sentence;
using PageForTheBrush = test::BrushPageTest;

TEST_F(PageForTheBrush, BeginsWithAnEmptySheetAndSaysWhatCanBeDone) {
  EXPECT_EQ(
      said_.front(),
      sentence("Write on the sheet with mouse, pen or finger, or by keys (M). I: ink. W: water. S: what "
               "is on the sheet."));
  EXPECT_EQ(said_.size(), 1) << "the ink it begins with is not told";
  EXPECT_EQ(kind_, Feedback::hint);
  EXPECT_EQ(page_->id(), sentence("brush"));
  EXPECT_EQ(page_->name(), sentence("&Brush"));
  EXPECT_EQ(page_->purpose(), sentence("Write with brush and ink on paper"));
  EXPECT_EQ(page_->drawing(), Icon::brush);
  EXPECT_TRUE(page_->has_files());
  EXPECT_EQ(page_->title(), QString());
  auto* row = static_cast<QBoxLayout*>(page_->instead_of_tablet()->layout());
  EXPECT_EQ(row->contentsMargins(), QMargins());
  EXPECT_EQ(row->spacing(), 0);
  EXPECT_EQ(row->stretch(0), 1);
  EXPECT_EQ(row->itemAt(1)->widget(), &panel());
  EXPECT_EQ(row->direction(), QBoxLayout::LeftToRight);
  auto* column = static_cast<QBoxLayout*>(row->itemAt(0)->layout());
  EXPECT_EQ(column->spacing(), 0);
  EXPECT_EQ(column->itemAt(0)->widget(), &find<QWidget>("brush_review_bar"));
  EXPECT_EQ(column->itemAt(1)->widget(), &paper());
  EXPECT_EQ(column->stretch(1), 1);
  EXPECT_EQ(page_->instead_of_tablet()->focusProxy(), &paper());
  EXPECT_EQ(test::tools_of(*page_),
            sentence("brush_ink* brush_water* brush_wipe* - brush_undo* brush_redo* - brush_dry* brush_new* "
                     "- brush_tools"));
  EXPECT_EQ(state().paper, "hanshi");
  EXPECT_EQ(state().ink, "sumi");
  EXPECT_EQ(state().brush, calligraphy::BrushChoice());
  EXPECT_EQ(paper().picture().size(), QSize(kCells, kCells));
  for (auto* action : {actions().undo, actions().redo, actions().dry}) EXPECT_FALSE(action->isEnabled());
  EXPECT_TRUE(actions().model_beneath->isChecked());
  EXPECT_TRUE(actions().guess_pressure->isChecked());
  EXPECT_FALSE(actions().left_hand->isChecked());
  EXPECT_TRUE(actions().show_brush->isChecked());
  EXPECT_TRUE(actions().tools->isChecked());
  EXPECT_EQ(find<QComboBox>("brush_ruling_box").currentData().toInt(), 1);
  parts_.preferences().left_handed = true;
  page_->enter();
  EXPECT_EQ(row->direction(), QBoxLayout::RightToLeft);
}

TEST_F(PageForTheBrush, TellsTheWindowOnceThatItIsOpen) {
  QWidget window;
  WindowParts parts(window, file("other.ini"), {file("others").toStdString(), {}, {}});
  int opened = 0;
  QObject::connect(&parts, &WindowParts::opened, &window, [&opened] { ++opened; });
  BrushPage page(parts);
  EXPECT_EQ(opened, 0);
  EXPECT_EQ(page.writing(), nullptr);
  EXPECT_TRUE(page.may_close(true)) << "nothing was written";
  page.enter();
  EXPECT_EQ(opened, 1);
  ASSERT_NE(page.writing(), nullptr);
  EXPECT_EQ(page.writing()->size(), 1024) << "a tenth of a millimetre";
}

TEST_F(PageForTheBrush, EachPaperFollowsTheOneBeforeAndIsANewSheet) {
  const std::pair<const char*, const char*> all[] = {{"gasenshi", "Gasenshi (bleeds fast)"},
                                                     {"gasenshi-slow", "Gasenshi (bleeds slowly)"},
                                                     {"board", "Board (hardly bleeds)"},
                                                     {"water", "Water paper (fades as it dries)"},
                                                     {"hanshi", "Hanshi (practice paper)"}};
  for (const auto& [id, name] : all) {
    const int before = saves_;
    EXPECT_EQ(by(actions().next_paper),
              sentence("New sheet: %1. Ctrl+Z brings the old one back.").arg(sentence(name)));
    EXPECT_EQ(state().paper, id);
    EXPECT_EQ(saves_, before + 1);
    EXPECT_EQ(find<QComboBox>("brush_paper_box").currentData().toString(), sentence(id));
  }
  emit panel().paper_chosen(sentence("board"));
  settle();
  EXPECT_EQ(by(actions().new_sheet),
            sentence("New sheet: Board (hardly bleeds). Ctrl+Z brings the old one back."));
  EXPECT_EQ(by(actions().undo), sentence("The sheet before is back: 0 strokes."));
}

TEST_F(PageForTheBrush, EachInkFollowsTheOneBefore) {
  for (const auto& [id, name] :
       {std::pair("sumi-blue", "Sumi, bluish"), std::pair("sumi-brown", "Sumi, brownish"),
        std::pair("vermilion", "Vermilion"), std::pair("water", "Water only"),
        std::pair("sumi", "Sumi, black")}) {
    const int before = saves_;
    EXPECT_EQ(by(actions().next_ink), sentence("Ink: %1.").arg(sentence(name)));
    EXPECT_EQ(state().ink, id);
    EXPECT_EQ(saves_, before + 1);
    EXPECT_EQ(find<QComboBox>("brush_ink_box").currentData().toString(), sentence(id));
  }
  said_.clear();
  emit panel().ink_chosen(sentence("vermilion"));
  settle();
  EXPECT_EQ(all_said(), sentence("Ink: Vermilion."));
  EXPECT_EQ(by(actions().next_ink), sentence("Ink: Water only."));
}

TEST_F(PageForTheBrush, AThickerBrushAndAThinnerOneEndWithTheLargestAndTheFinest) {
  using Size = calligraphy::BrushSize;
  const auto expect = [this](QAction* action, const char* name, Size size) {
    const int before = saves_;
    EXPECT_EQ(by(action), sentence("Brush: %1, Mixed.").arg(sentence(name)));
    EXPECT_EQ(state().brush.size, size);
    EXPECT_EQ(saves_, before + 1);
    EXPECT_EQ(find<QComboBox>("brush_size_box").currentData().toInt(), static_cast<int>(size));
  };
  for (int i = 0; i < 2; ++i) expect(actions().thicker, "Large", Size::large);
  expect(actions().thinner, "Medium", Size::medium);
  expect(actions().thinner, "Small", Size::small);
  for (int i = 0; i < 2; ++i) expect(actions().thinner, "Fine", Size::fine);
  said_.clear();
  emit panel().size_chosen(Size::small);
  settle();
  EXPECT_EQ(all_said(), sentence("Brush: Small, Mixed."));
  for (const char* hair : {"Weasel (stiff)", "Goat (soft)", "Mixed", "Weasel (stiff)"}) {
    EXPECT_EQ(by(actions().next_hair), sentence("Brush: Small, %1.").arg(sentence(hair)));
    EXPECT_EQ(find<QComboBox>("brush_hair_box").currentText(), sentence(hair));
  }
  EXPECT_EQ(state().brush, (calligraphy::BrushChoice{Size::small, brush::Hair::weasel}));
  said_.clear();
  emit panel().hair_chosen(brush::Hair::goat);
  settle();
  EXPECT_EQ(all_said(), sentence("Brush: Small, Goat (soft)."));
  EXPECT_EQ(kind_, Feedback::hint);
}

TEST_F(PageForTheBrush, InkWaterAndClothChangeWhatIsInTheBrush) {
  const auto& words = find<QLabel>("brush_words");
  EXPECT_EQ(by(actions().dip_in_water), sentence("Dipped in water: the ink is paler."));
  EXPECT_EQ(words.text(), sentence("Brush: 100% full, ink 50%."));
  EXPECT_EQ(by(actions().wipe), sentence("Wiped: half of the ink is gone."));
  EXPECT_EQ(words.text(), sentence("Brush: 50% full, ink 50%."));
  EXPECT_EQ(by(actions().dip_in_ink), sentence("Dipped in ink."));
  EXPECT_GT(state().strength, 0.5);
  EXPECT_NEAR(state().fullness, 1, 1e-6);
  EXPECT_EQ(kind_, Feedback::hint);
}

TEST_F(PageForTheBrush, ABrushThatIsAlmostDryIsToldOfOnceUntilItIsDipped) {
  const QString dry = sentence("The brush is almost dry. I: dip it in ink.");
  for (int time = 0; time < 2; ++time) {
    QStringList all;
    // An eighth of the ink is enough, a sixteenth is not.
    for (int i = 0; i < 6; ++i)
      all.append(by(actions().wipe).contains(dry) ? sentence("dry") : sentence("-"));
    EXPECT_EQ(all.join(QLatin1Char(' ')), sentence("- - - dry - -"));
    actions().dip_in_ink->trigger();
    settle();
  }
  QString said;
  Feedback kind = Feedback::hint;
  QObject::connect(&parts_, &WindowParts::announced, &window_, [&](Feedback of, const QString& words) {
    said = words;
    kind = of;
  });
  for (int i = 0; i < 4; ++i) by(actions().wipe);
  EXPECT_EQ(said, dry);
  EXPECT_EQ(kind, Feedback::advice);
}

TEST_F(PageForTheBrush, WhatIsOnTheSheetIsToldWholeAndToAScreenReader) {
  take_model("一", 1);
  const QString empty = sentence(
      "Nothing is written yet. Hanshi (practice paper). Model beneath: 一. Brush: 100% "
      "full, ink 100%.");
  EXPECT_EQ(by(actions().describe), empty);
  EXPECT_EQ(paper().accessibleDescription(), empty);
  EXPECT_EQ(find<QLabel>("paper_words").text(), sentence("Nothing is written yet."));
  write();
  EXPECT_TRUE(
      paper().accessibleDescription().startsWith(sentence("1 strokes, wet. Hanshi (practice paper).")));
  EXPECT_EQ(by(actions().dry), sentence("The sheet is dry."));
  EXPECT_TRUE(by(actions().describe).startsWith(sentence("1 strokes, dry. Hanshi")));
  EXPECT_FALSE(actions().dry->isEnabled());
  // As where it dries while the key is pressed.
  actions().dry->setEnabled(true);
  EXPECT_EQ(by(actions().dry), sentence("The sheet was dry already."));
}

TEST_F(PageForTheBrush, TheHandAndTheBrushAreShownAsChosen) {
  window_.show();
  const QPointF middle = paper().place().rect.center();
  double leans_to = 0;
  QObject::connect(&paper(), &PaperView::pen_moved, &window_,
                   [&](const brush::PenSample& sample) { leans_to = sample.lean_to_rad; });
  const auto mouse = [&](QEvent::Type type, Qt::MouseButton button) {
    QMouseEvent event(type, middle, middle, button, button, {});
    QCoreApplication::sendEvent(&paper(), &event);
  };
  const auto click = [&] {
    mouse(QEvent::MouseButtonPress, Qt::LeftButton);
    mouse(QEvent::MouseButtonRelease, Qt::LeftButton);
    mouse(QEvent::MouseMove, Qt::NoButton);
    settle();
  };
  click();
  EXPECT_EQ(leans_to, calligraphy::assumed_tilt(false).lean_to_rad);
  EXPECT_EQ(paper().cursor().shape(), Qt::BlankCursor);
  const int before = saves_;
  actions().left_hand->trigger();
  actions().show_brush->trigger();
  EXPECT_EQ(saves_, before + 2);
  click();
  EXPECT_EQ(leans_to, calligraphy::assumed_tilt(true).lean_to_rad);
  EXPECT_EQ(paper().cursor().shape(), Qt::CrossCursor);
  keep_settings(*page_);
  open_page();
  click();
  EXPECT_EQ(leans_to, calligraphy::assumed_tilt(true).lean_to_rad) << "also the next time";
  find<QCheckBox>("box_brush_left_hand").click();
  EXPECT_FALSE(actions().left_hand->isChecked()) << "the box is the action";
  actions().show_brush->trigger();
  EXPECT_TRUE(find<QCheckBox>("box_brush_shown").isChecked());
}

TEST_F(PageForTheBrush, ALeftHandedLearnerBeginsWithTheBrushInTheLeftHand) {
  parts_.preferences().left_handed = true;
  open_page();
  EXPECT_TRUE(actions().left_hand->isChecked());
}

TEST_F(PageForTheBrush, TheSpeedOfAMouseIsItsPressureWhereThatIsGuessed) {
  const auto darkness = [this](int moves) {
    by(actions().new_sheet);
    by(actions().dip_in_ink);
    for (int i = 0; i <= moves + 1; ++i) {
      brush::PenSample sample;
      sample.time_s = time_s_ += 0.02;
      sample.at = {-0.03 + 0.06 * std::min(i, moves) / moves, 0};
      sample.down = i <= moves;
      emit paper().pen_moved(sample);
    }
    wait_until([&] { return state().strokes == 1 && !state().is_writing; });
    by(actions().dry);
    int dark = 0;
    for (int y = 0; y < paper().picture().height(); ++y)
      dark += qGray(paper().picture().pixel(kCells / 2, y)) < 120 ? 1 : 0;
    return dark;
  };
  const int slow = darkness(60), fast = darkness(8);
  EXPECT_GT(slow, fast + 2);
  const int before = saves_;
  actions().guess_pressure->trigger();
  EXPECT_EQ(saves_, before + 1);
  EXPECT_LT(std::abs(darkness(60) - darkness(8)), slow - fast) << "they press alike";
  EXPECT_EQ(find<QCheckBox>("box_brush_guess").isChecked(), false);
}

TEST_F(PageForTheBrush, ThePanelIsHiddenByItsKeyAndGivesTheKeyboardBack) {
  window_.show();
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  const int saved = saves_;
  paper().setFocus();
  int focused = focused_;
  actions().tools->trigger();
  EXPECT_TRUE(panel().isHidden());
  EXPECT_EQ(saves_, saved + 1);
  EXPECT_EQ(focused_, focused) << "the sheet has it already";
  actions().tools->trigger();
  EXPECT_FALSE(panel().isHidden());
  find<QLineEdit>("brush_text").setFocus();
  focused = focused_;
  actions().tools->trigger();
  EXPECT_EQ(focused_, focused + 1);
  // Typing a text needs the panel.
  find<QLineEdit>("brush_text").setText(sentence("山川"));
  actions().model_text->trigger();
  EXPECT_FALSE(panel().isHidden());
  EXPECT_TRUE(find<QLineEdit>("brush_text").hasFocus());
  EXPECT_EQ(find<QLineEdit>("brush_text").selectedText(), sentence("山川"));
  actions().model_text->trigger();
  EXPECT_FALSE(panel().isHidden()) << "it stays";
}

TEST_F(PageForTheBrush, KeepsWhatIsChosenForTheNextTime) {
  emit panel().text_typed(sentence("日本"));
  emit panel().paper_chosen(sentence("board"));
  emit panel().ink_chosen(sentence("vermilion"));
  emit panel().ruling_chosen(4);
  emit panel().size_chosen(calligraphy::BrushSize::fine);
  emit panel().hair_chosen(brush::Hair::goat);
  emit panel().place_chosen(ModelPlace::beside);
  emit panel().font_chosen(sentence("KouzanBrushFont"));
  for (auto* action : {actions().guess_pressure, actions().left_hand, actions().show_brush, actions().tools})
    action->trigger();
  settle();
  keep_settings(*page_);
  const QSettings stored(parts_.settings_file(), QSettings::IniFormat);
  const std::pair<const char*, const char*> all[] = {{"paper", "board"},
                                                     {"ink", "vermilion"},
                                                     {"ruling", "4"},
                                                     {"size", "fine"},
                                                     {"hair", "goat"},
                                                     {"model", "beside"},
                                                     {"font", "KouzanBrushFont"},
                                                     {"text", "日本"},
                                                     {"guess_pressure", "false"},
                                                     {"left_hand", "true"},
                                                     {"show_brush", "false"},
                                                     {"show_tools", "false"}};
  for (const auto& [key, value] : all)
    EXPECT_EQ(stored.value(sentence("brush/") + sentence(key)).toString(), sentence(value)) << key;
  open_page();
  EXPECT_EQ(said_.size(), 1) << all_said().toStdString();
  EXPECT_EQ(state().paper, "board");
  EXPECT_EQ(state().ink, "vermilion");
  EXPECT_EQ(state().brush, (calligraphy::BrushChoice{calligraphy::BrushSize::fine, brush::Hair::goat}));
  EXPECT_EQ(find<QComboBox>("brush_ruling_box").currentData().toInt(), 4);
  EXPECT_TRUE(actions().model_beside->isChecked());
  EXPECT_EQ(find<QComboBox>("brush_model_box").currentData().toInt(), static_cast<int>(ModelPlace::beside));
  EXPECT_EQ(find<QLineEdit>("brush_text").text(), sentence("日本"));
  EXPECT_FALSE(actions().guess_pressure->isChecked());
  EXPECT_TRUE(actions().left_hand->isChecked());
  EXPECT_FALSE(actions().show_brush->isChecked());
  EXPECT_FALSE(actions().tools->isChecked());
  EXPECT_TRUE(panel().isHidden());
  wait_until([this] { return !page_->awaits_models(); });
  EXPECT_EQ(find<QComboBox>("brush_font_box").currentData().toString(), sentence("KouzanBrushFont"));
}

TEST_F(PageForTheBrush, AWaterPaperBeginsWithWater) {
  emit panel().paper_chosen(sentence("water"));
  settle();
  emit panel().ink_chosen(sentence("vermilion"));
  settle();
  keep_settings(*page_);
  open_page();
  EXPECT_EQ(state().paper, "water");
  EXPECT_EQ(state().ink, "water");
}

TEST_F(PageForTheBrush, WhatNoVersionCouldHaveKeptIsLeftOut) {
  const auto open_with = [this](const std::vector<std::pair<const char*, const char*>>& values) {
    {
      QSettings stored(parts_.settings_file(), QSettings::IniFormat);
      for (const auto& [key, value] : values)
        stored.setValue(sentence("brush/") + sentence(key), sentence(value));
    }
    open_page();
  };
  open_with({{"paper", "cardboard"},
             {"ink", "blood"},
             {"size", "huge"},
             {"hair", "steel"},
             {"ruling", "many"},
             {"model", "above"},
             {"font", "Comic"}});
  EXPECT_EQ(state().paper, "hanshi");
  EXPECT_EQ(state().ink, "sumi");
  EXPECT_EQ(state().brush, calligraphy::BrushChoice());
  EXPECT_TRUE(actions().model_beneath->isChecked());
  const auto& ruling = find<QComboBox>("brush_ruling_box");
  EXPECT_EQ(ruling.currentData().toInt(), 1);
  wait_until([this] { return !page_->awaits_models(); });
  EXPECT_EQ(said_.size(), 1) << "no font is missed";
  keep_settings(*page_);
  EXPECT_EQ(QSettings(parts_.settings_file(), QSettings::IniFormat).value(sentence("brush/font")).toString(),
            QString());
  for (const auto& [kept, shown] :
       {std::pair("6", 6), std::pair("0", 0), std::pair("7", 6), std::pair("-1", 0)}) {
    open_with({{"ruling", kept}});
    EXPECT_EQ(find<QComboBox>("brush_ruling_box").currentData().toInt(), shown) << kept;
  }
}

TEST_F(PageForTheBrush, LeavingItEndsTheStrokeAndTheKeysOfThePen) {
  actions().by_key->trigger();
  by(actions().press);
  wait_until([this] { return state().is_writing; });
  page_->leave();
  wait_until([this] { return !state().is_writing; });
  EXPECT_FALSE(actions().by_key->isChecked());
  EXPECT_FALSE(actions().press->isEnabled());
  page_->enter();
  brush::PenSample down;
  down.time_s = 1;
  emit paper().pen_moved(down);
  wait_until([this] { return state().is_writing; });
  emit paper().pen_lost();
  wait_until([this] { return !state().is_writing; });
}

}  // namespace
}  // namespace nazori::ui
