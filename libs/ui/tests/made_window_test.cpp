// SPDX-License-Identifier: Apache-2.0
// What stands where in the window around the tablet and in the panels that need the whole window, and how
// each part is made.
#include <QMenu>
#include <QScrollBar>
#include <QToolBar>

#include "characters/characters.h"
#include "characters/library_panel.h"
#include "described_widget.h"
#include "start/check_page.h"
#include "study/home.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

using test::expect_laid_out;
using test::expect_made;

class MadeWindow : public WindowTest {
 protected:
  MadeWindow() {
    pages_ = {[](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<Home>(parts); },
              [](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<Characters>(parts); },
              [](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<CheckPage>(parts); }};
  }
  int em() const { return QFontInfo(window_->font()).pixelSize(); }
};

TEST_F(MadeWindow, TheTabletHasTheRoomThatItsBarsLeave) {
  expect_laid_out(
      *window_,
      {{"middle",
        "column 0 0 0 0 gap 0: check_bar, QWidget, tablet_frame*1, feedback_line, session_answers, "
        "check_buttons"},
       {"around question_view",
        "column 0 0 0 0 gap 0: (column: session_bar, question_view*1), dictation_strip"},
       {"left_side", "column 0 0 0 0 gap 0: draw_panel*1, library_panel*1"},
       {"right_side", "column 0 0 0 0 gap 0: writing_panel, information_panel*1"},
       {"dictation_strip",
        "row 12 8 12 8 gap 12: word_boxes top, (column gap 2: dictation_reading, dictation_meaning, "
        "dictation_verdict, stretch*1)*1"},
       {"library_panel",
        "column 12 12 6 0 gap 8: (row 0 0 6 0 gap 4: search*1, search_conditions), table_picker*2, "
        "(row 0 0 6 0: lists*1, list_count), QStackedWidget*3"},
       {"draw_panel",
        "column 12 12 6 12 gap 8: drawing_pad, (flow gap 6 6: draw_undo, draw_clear, draw_close), "
        "draw_among, "
        "candidates*1, draw_words"},
       {"check_bar", "column 16 8 16 8: check_progress, check_line, check_question"},
       {"check_buttons", "column 16 8 16 8: QWidget"},
       {"around check_done_button",
        "flow 0 0 0 0 gap 10 10: check_done_button, button_check_unknown, button_check_end"}});
  EXPECT_EQ(window_->minimumSize(), QSize(560, 420));
  EXPECT_TRUE(window_->acceptDrops());
  EXPECT_EQ(window_->contextMenuPolicy(), Qt::NoContextMenu);
  const auto* tablet = find<QLabel>("tablet");
  EXPECT_EQ(tablet->contentsMargins(), QMargins(40, 40, 40, 40));
  EXPECT_EQ(tablet->minimumSize(), QSize(260, 200));
  EXPECT_EQ(tablet->alignment(), Qt::AlignCenter);
  EXPECT_TRUE(tablet->wordWrap());
  EXPECT_EQ(tablet->sizePolicy().horizontalPolicy(), QSizePolicy::Expanding);
  EXPECT_EQ(tablet->sizePolicy().verticalPolicy(), QSizePolicy::Expanding);
  EXPECT_EQ(tablet->accessibleName(), QStringLiteral("Carved tablet"));
  EXPECT_TRUE(
      tablet->accessibleDescription().startsWith(QStringLiteral("The character as grooves to trace.")));
  EXPECT_TRUE(
      tablet->text().startsWith(QStringLiteral("The tablet cannot be shown: OpenGL 3.3 is missing.")));
}

TEST_F(MadeWindow, BarsStayWhereTheyAreAndTheirButtonsAreReachedByTab) {
  expect_made(
      *window_,
      {{"tool_bar", "contextMenuPolicy PreventContextMenu; no floatable; no movable; windowTitle Toolbar"},
       {"page_rail",
        "accessibleName Pages; contextMenuPolicy PreventContextMenu; no floatable; no movable; "
        "orientation Vertical; sizePolicy Fixed Preferred; toolButtonStyle ToolButtonTextUnderIcon; "
        "windowTitle Pages"}});
  const auto* style = find<QToolButton>("tool_style");
  EXPECT_EQ(style->popupMode(), QToolButton::InstantPopup);
  EXPECT_EQ(style->focusPolicy(), Qt::TabFocus);
  EXPECT_EQ(style->toolButtonStyle(), Qt::ToolButtonTextOnly);
  EXPECT_EQ(style->toolTip(), QStringLiteral("Tablet style (Ctrl+1, 2, 3)"));
  EXPECT_EQ(style->text(), QStringLiteral("Wood  ▾"));
  EXPECT_EQ(style->accessibleName(), QStringLiteral("Tablet style: Wood"));
  action("slate")->trigger();
  EXPECT_EQ(style->text(), QStringLiteral("Slate  ▾"));
  EXPECT_EQ(style->accessibleName(), QStringLiteral("Tablet style: Slate"));
  EXPECT_EQ(find<QToolBar>("tool_bar")->iconSize(), QSize(em() * 5 / 4, em() * 5 / 4));
  EXPECT_EQ(find<QToolBar>("page_rail")->iconSize(), QSize(em() * 3 / 2, em() * 3 / 2));
  for (const char* bar : {"tool_bar", "page_rail"}) {
    int buttons = 0;
    for (auto* entry : find<QToolBar>(bar)->actions()) {
      const auto* button = qobject_cast<QToolButton*>(find<QToolBar>(bar)->widgetForAction(entry));
      if (button == nullptr || button == style) continue;
      ++buttons;
      EXPECT_EQ(button->focusPolicy(), Qt::TabFocus) << button->objectName().toStdString();
      EXPECT_EQ(button->accessibleName(), entry->iconText());
      EXPECT_EQ(button->accessibleDescription(), entry->statusTip());
      EXPECT_EQ(button->objectName(),
                (bar[0] == 't' ? QStringLiteral("tool_") : QStringLiteral("rail_")) + entry->objectName());
    }
    EXPECT_GE(buttons, bar[0] == 't' ? 8 : 2) << bar;
  }
  resize(72 * em(), 800);
  EXPECT_EQ(find<QToolBar>("page_rail")->toolButtonStyle(), Qt::ToolButtonTextUnderIcon);
  resize(72 * em() - 1, 800);
  EXPECT_EQ(find<QToolBar>("page_rail")->toolButtonStyle(), Qt::ToolButtonIconOnly);
}

TEST_F(MadeWindow, TheListOfCharactersIsMadeForWhatItIs) {
  const std::string conditions = "Search by strokes, radical, parts or code";
  expect_made(
      *window_,
      {{"library_panel", "accessibleName Characters; styled"},
       {"search_conditions", ("accessibleName " + conditions +
                              "; mouseTracking; popupMode InstantPopup; text ⋯; toolTip " + conditions)
                                 .c_str()},
       {"character_grid",
        "accessibleName Characters in the list; editTriggers NoEditTriggers; flow LeftToRight; "
        "horizontalScrollBarPolicy ScrollBarAlwaysOff; isWrapping; mouseTracking; resizeMode Adjust; styled; "
        "uniformItemSizes; verticalScrollBarPolicy ScrollBarAlwaysOn; verticalScrollMode ScrollPerPixel"},
       {"draw_panel", "accessibleName Draw to find; hidden; styled"}});
  const auto* lists = find<QComboBox>("lists");
  EXPECT_EQ(lists->accessibleName(), QStringLiteral("List of characters"));
  EXPECT_EQ(lists->maxVisibleItems(), 13);
  EXPECT_EQ(lists->minimumContentsLength(), 5);
  EXPECT_EQ(lists->placeholderText(), QStringLiteral("Search results"));
  QStringList names;
  for (int i = 0; i < 17; ++i) names.append(lists->itemText(i));
  EXPECT_EQ(
      names.join(u'|').toStdString(),
      "Grade 1|Grade 2|Grade 3|Grade 4|Grade 5|Grade 6|Secondary school|Kanji for names|Hiragana|Katakana|"
      "Letters and digits|My characters|All characters|Old JLPT level 4 (before 2010)|Old JLPT level 3 "
      "(before 2010)|Old JLPT level 2 (before 2010)|Old JLPT level 1 (before 2010)");
  auto* search = find<QLineEdit>("search");
  EXPECT_EQ(search->accessibleName(), QStringLiteral("Find a character"));
  EXPECT_TRUE(search->isClearButtonEnabled());
  EXPECT_EQ(search->placeholderText(), QStringLiteral("休, yasumu, rest …"));
  EXPECT_EQ(
      search->toolTip(),
      QStringLiteral("Search by character, by reading (kana or romaji) or by English meaning (Ctrl+F)"));
  const auto* nothing = find<QLabel>("nothing_found");
  EXPECT_EQ(nothing->contentsMargins(), QMargins(6, 10, 6, 6));
  EXPECT_EQ(nothing->alignment(), Qt::AlignTop | Qt::AlignLeft);
  QSignalSpy chosen(find<LibraryPanel>("library_panel"), &LibraryPanel::character_chosen);
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(chosen.count(), 0) << "nothing is searched";
  // Each entry of the menu begins a condition behind what is typed already.
  const char* const begun[] = {"strokes:", "skip:", "corner:", "grade:", "jlpt:", "freq:"};
  const auto entries = find<QToolButton>("search_conditions")->menu()->actions();
  ASSERT_EQ(entries.size(), 9);
  EXPECT_EQ(entries[0]->text(), QStringLiteral("Parts…"));
  EXPECT_EQ(entries[1]->text(), QStringLiteral("Radical…"));
  EXPECT_TRUE(entries[2]->isSeparator());
  for (int i = 0; i < 6; ++i) {
    const QString key = QString::fromLatin1(begun[i]);
    EXPECT_TRUE(entries[3 + i]->text().endsWith(u'\t' + key)) << begun[i];
    search->setText(QStringLiteral(" rest "));
    find<QWidget>("character_grid")->setFocus();
    entries[3 + i]->trigger();
    EXPECT_EQ(search->text(), QStringLiteral("rest ") + key);
    EXPECT_TRUE(search->hasFocus());
    search->clear();
    entries[3 + i]->trigger();
    EXPECT_EQ(search->text(), key);
  }
}

TEST_F(MadeWindow, TilesFillTheListAndRowsOfASearchAreAsWideAsIt) {
  auto* grid = find<QListView>("character_grid");
  const int wished = 3 * em();
  for (const int width : {150, 211, 300, 377, 600}) {
    test::resize_unseen(*grid->viewport(), {width, 400});
    const int room = width - 1;
    // As many as fit where they may be 15 % smaller than wished.
    const int columns = std::max(1, static_cast<int>(room / (0.85 * wished)));
    const int side = std::clamp(room / columns, wished / 2, wished * 3 / 2);
    EXPECT_EQ(grid->gridSize(), QSize(side, side)) << width;
    EXPECT_EQ(grid->verticalScrollBar()->singleStep(), side / 2);
  }
  EXPECT_EQ(grid->flow(), QListView::LeftToRight);
  EXPECT_TRUE(grid->isWrapping());
  find<QLineEdit>("search")->setText(QStringLiteral("rest"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("list_count").endsWith(QStringLiteral(" found")); }, 20'000));
  test::resize_unseen(*grid->viewport(), {300, 400});
  EXPECT_EQ(grid->gridSize(), QSize(299, em() * 10 / 3));
  EXPECT_EQ(grid->verticalScrollBar()->singleStep(), em() * 10 / 3 / 2);
  EXPECT_EQ(grid->flow(), QListView::TopToBottom);
  EXPECT_FALSE(grid->isWrapping());
  EXPECT_EQ(find<QComboBox>("lists")->currentIndex(), -1) << "it is no list";
  find<QLineEdit>("search")->clear();
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("list_count") == QStringLiteral("80"); }, 20'000));
  EXPECT_EQ(find<QLabel>("list_count")->accessibleName(), QStringLiteral("80 characters"));
  EXPECT_EQ(find<QComboBox>("lists")->currentText(), QStringLiteral("Grade 1"));
  EXPECT_TRUE(grid->isWrapping());
}

TEST_F(MadeWindow, ThePanelToDrawInIsMadeForWhatItIs) {
  action("draw_to_find")->trigger();
  resize(1280, 800);
  const auto* list = find<QListWidget>("candidates");
  EXPECT_EQ(list->viewMode(), QListView::IconMode);
  EXPECT_EQ(list->flow(), QListView::LeftToRight);
  EXPECT_EQ(list->movement(), QListView::Static);
  EXPECT_EQ(list->resizeMode(), QListView::Adjust);
  EXPECT_TRUE(list->uniformItemSizes());
  EXPECT_EQ(list->horizontalScrollBarPolicy(), Qt::ScrollBarAlwaysOff);
  EXPECT_EQ(list->accessibleName(), QStringLiteral("Similar characters"));
  EXPECT_EQ(list->gridSize(), QSize(em() * 9 / 2, em() * 4));
  EXPECT_NEAR(list->font().pointSizeF(), 1.8 * QFontInfo(window_->font()).pointSizeF(), 0.01);
  const auto* among = find<QComboBox>("draw_among");
  EXPECT_EQ(among->accessibleName(), QStringLiteral("Search among"));
  EXPECT_EQ(among->toolTip(), QStringLiteral("Which characters are searched (Page Up, Page Down)"));
  QStringList names;
  for (int i = 0; i < among->count(); ++i) names.append(among->itemText(i));
  EXPECT_EQ(names.join(u'|'), QStringLiteral("All characters|Kana|Kanji|Letters and digits"));
  auto* panel = find("draw_panel");
  test::resize_unseen(*panel, {300, 26 * em()});
  EXPECT_FALSE(find("draw_words")->isHidden());
  test::resize_unseen(*panel, {300, 26 * em() - 1});
  EXPECT_TRUE(find("draw_words")->isHidden()) << "the candidates need the room more";
}

}  // namespace
}  // namespace nazori::ui
