// SPDX-License-Identifier: Apache-2.0
// The smallest parts of pages, each alone: actions, labels, buttons, sliders, rows, and what they do with
// keys.
#include <gtest/gtest.h>

#include <QActionGroup>
#include <QComboBox>
#include <QDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QSlider>
#include <QTableWidget>
#include <QTest>
#include <QUrl>
#include <QWindow>
#include <memory>

#include "nazori/widgets/controls/action_set.h"
#include "nazori/widgets/controls/feedback_line.h"
#include "nazori/widgets/controls/field_row.h"
#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/focus_frame.h"
#include "nazori/widgets/controls/input_pause.h"
#include "nazori/widgets/controls/number_slider.h"
#include "nazori/widgets/controls/panes.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/look/icons.h"
#include "nazori/widgets/look/palette.h"
#include "painting_under_test.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

/// A set of actions like those of a page.
class SomeActions final : public ActionSet {
 public:
  explicit SomeActions(QWidget* window) : ActionSet(window) {
    save = make("save", QStringLiteral("&Save as…"), QStringLiteral("Save it"), "Ctrl+S Ctrl+Shift+S");
    grid = make("grid", QStringLiteral("格子(&G)"), QStringLiteral("Show the grid"), "G", true, Icon::pen);
    undo = make("undo", QStringLiteral("&Undo"), QStringLiteral("Undo it"), "Ctrl+Z", Icon::undo);
    add_group(QStringLiteral("&File"), {save, nullptr, grid});
    add_group(QStringLiteral("&Edit"), {});
    add_to_group(1, undo);
  }
  using ActionSet::make_exclusive;
  QAction *save, *grid, *undo;
};

TEST(ActionsOfASet, HaveTheirNameTheirWordsTheirKeysAndTheirPicture) {
  QWidget window;
  SomeActions actions(&window);
  EXPECT_EQ(actions.save->objectName(), QStringLiteral("save"));
  EXPECT_EQ(actions.save->text(), QStringLiteral("&Save as…"));
  EXPECT_EQ(actions.save->iconText(), QStringLiteral("Save as"));
  EXPECT_EQ(actions.save->statusTip(), QStringLiteral("Save it"));
  EXPECT_EQ(actions.save->toolTip(), QStringLiteral("Save it (Ctrl+S)"));
  EXPECT_EQ(actions.save->shortcuts(), (QList<QKeySequence>{QKeySequence(QStringLiteral("Ctrl+S")),
                                                            QKeySequence(QStringLiteral("Ctrl+Shift+S"))}));
  EXPECT_FALSE(actions.save->isCheckable());
  EXPECT_FALSE(actions.save->isIconVisibleInMenu());
  EXPECT_EQ(actions.undo->objectName(), QStringLiteral("undo"));
  EXPECT_EQ(actions.undo->text(), QStringLiteral("&Undo"));
  EXPECT_FALSE(actions.undo->isCheckable());
  EXPECT_TRUE(actions.grid->isCheckable());
  EXPECT_EQ(actions.grid->iconText(), QStringLiteral("格子"));
  EXPECT_EQ(window.actions(), (QList{actions.save, actions.grid, actions.undo}))
      << "their keys work without a menu";
  EXPECT_TRUE(actions.undo->icon().isNull());
  actions.draw_icons();
  EXPECT_TRUE(actions.save->icon().isNull());
  const auto seen = [](const QIcon& icon, QIcon::State state) {
    return icon.pixmap(QSize(24, 24), 1.0, QIcon::Normal, state).toImage();
  };
  const Colours& c = current_colours();
  EXPECT_EQ(seen(actions.grid->icon(), QIcon::Off), seen(icon(Icon::pen, c.ink, c.indigo), QIcon::Off));
  EXPECT_EQ(seen(actions.grid->icon(), QIcon::On), seen(icon(Icon::pen, c.ink, c.indigo), QIcon::On));
  EXPECT_EQ(seen(actions.undo->icon(), QIcon::Off), seen(icon(Icon::undo, c.ink, c.indigo), QIcon::Off));
}

TEST(ActionsOfASet, AreInGroupsAndInForceTogether) {
  QWidget window;
  SomeActions actions(&window);
  ASSERT_EQ(actions.groups().size(), 2);
  EXPECT_EQ(actions.groups()[0].title, QStringLiteral("&File"));
  EXPECT_EQ(actions.groups()[0].actions, (QList<QAction*>{actions.save, nullptr, actions.grid}));
  EXPECT_EQ(actions.groups()[1].actions, QList<QAction*>{actions.undo});
  actions.set_in_force(false);
  for (const auto* one : {actions.save, actions.grid, actions.undo}) EXPECT_FALSE(one->isVisible());
  ActionSet::set_in_force(actions.groups()[1], true);
  EXPECT_FALSE(actions.save->isVisible());
  EXPECT_TRUE(actions.undo->isVisible());
  actions.set_in_force(true);
  EXPECT_TRUE(actions.save->isVisible());
  SomeActions others(&window);
  actions.adopt(others);
  ASSERT_EQ(actions.groups().size(), 4);
  EXPECT_EQ(actions.groups()[3].actions, QList<QAction*>{others.undo});
}

TEST(ActionsOfASet, ExcludeEachOtherWhereTheyAreAskedTo) {
  QWidget window;
  SomeActions actions(&window);
  actions.save->setCheckable(true);
  actions.make_exclusive({actions.save, actions.grid});
  actions.save->setChecked(true);
  actions.grid->setChecked(true);
  EXPECT_FALSE(actions.save->isChecked());
  EXPECT_EQ(actions.undo->actionGroup(), nullptr);
}

TEST(WithoutMnemonic, TheLetterOfAMenuIsTakenOutInBothLanguages) {
  EXPECT_EQ(without_mnemonic(QStringLiteral("&Open…")), QStringLiteral("Open…"));
  EXPECT_EQ(without_mnemonic(QStringLiteral("T&hinner")), QStringLiteral("Thinner"));
  EXPECT_EQ(without_mnemonic(QStringLiteral("開く(&O)…")), QStringLiteral("開く…"));
  EXPECT_EQ(without_mnemonic(QStringLiteral("開く (&O)")), QStringLiteral("開く"));
}

TEST(PartsOfPages, LabelsShowTheirTextAsItIsAndWrap) {
  QWidget window;
  const auto* plain = text_label("plain", &window);
  EXPECT_EQ(plain->objectName(), QStringLiteral("plain"));
  EXPECT_TRUE(plain->wordWrap());
  EXPECT_EQ(plain->textFormat(), Qt::PlainText);
  EXPECT_FALSE(plain->property("role").isValid());
  EXPECT_EQ(text_label("muted", &window, "muted")->property("role").toString(), QStringLiteral("muted"));
  const auto* sentence = sentence_label("sentence", &window, "muted");
  EXPECT_EQ(sentence->textInteractionFlags(), Qt::TextSelectableByMouse);
  EXPECT_EQ(sentence->property("role").toString(), QStringLiteral("muted"));
  const auto* title = heading(QStringLiteral("Title"), &window);
  EXPECT_EQ(title->text(), QStringLiteral("Title"));
  EXPECT_EQ(title->property("role").toString(), QStringLiteral("heading"));
  EXPECT_TRUE(title->wordWrap());
  EXPECT_EQ(title->parentWidget(), &window);
}

TEST(PartsOfPages, AButtonDoesWhatItsActionDoes) {
  QWidget window;
  QAction action;
  action.setObjectName(QStringLiteral("go"));
  action.setToolTip(QStringLiteral("Go on (G)"));
  auto* button = action_button(&action, QStringLiteral("Go"), &window);
  EXPECT_EQ(button->objectName(), QStringLiteral("button_go"));
  EXPECT_EQ(button->toolTip(), QStringLiteral("Go on (G)"));
  EXPECT_EQ(button->text(), QStringLiteral("Go"));
  const QSignalSpy triggered(&action, &QAction::triggered);
  button->click();
  EXPECT_EQ(triggered.count(), 1);
  auto* spoken = named(new QPushButton(&window), "spoken", QStringLiteral("Said"));
  EXPECT_EQ(spoken->accessibleName(), QStringLiteral("Said"));
}

TEST(PartsOfPages, ABoxIsAsNarrowAsItsLettersAndATableIsReadByRows) {
  QComboBox box;
  make_narrow(&box, 7);
  EXPECT_EQ(box.minimumContentsLength(), 7);
  EXPECT_EQ(box.sizeAdjustPolicy(), QComboBox::AdjustToMinimumContentsLengthWithIcon);
  QTableWidget table(2, 2);
  make_row_table(&table);
  EXPECT_EQ(table.editTriggers(), QAbstractItemView::NoEditTriggers);
  EXPECT_EQ(table.selectionBehavior(), QAbstractItemView::SelectRows);
  EXPECT_EQ(table.selectionMode(), QAbstractItemView::SingleSelection);
  EXPECT_FALSE(table.tabKeyNavigation());
  EXPECT_FALSE(table.showGrid());
  EXPECT_TRUE(table.verticalHeader()->isHidden());
  EXPECT_TRUE(table.horizontalHeader()->stretchLastSection());
  EXPECT_EQ(table.horizontalHeader()->defaultAlignment(), Qt::AlignLeft | Qt::AlignVCenter);
}

TEST(PartsOfPages, WhatScrollsDoesSoUpAndDownOnThePaperOfThePage) {
  QScrollArea area;
  auto* content = new QWidget;
  make_scrolling(&area, content);
  EXPECT_EQ(area.widget(), content);
  EXPECT_TRUE(area.widgetResizable());
  EXPECT_EQ(area.horizontalScrollBarPolicy(), Qt::ScrollBarAlwaysOff);
  EXPECT_FALSE(area.viewport()->autoFillBackground());
  EXPECT_FALSE(content->autoFillBackground());
}

TEST(PartsOfPages, ALayoutIsEmptiedAtOnce) {
  QWidget window;
  auto* row = new QHBoxLayout(&window);
  QPointer<QLabel> label = new QLabel(&window);
  row->addWidget(label);
  row->addStretch(1);
  window.show();
  clear_layout(row);
  EXPECT_EQ(row->count(), 0);
  ASSERT_NE(label, nullptr);
  EXPECT_TRUE(label->isHidden());
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_EQ(label, nullptr);
}

TEST(PartsOfPages, TheButtonsOfADialogEndIt) {
  QDialog dialog;
  auto* buttons = dialog_buttons(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
  dialog.show();
  buttons->button(QDialogButtonBox::Ok)->click();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  dialog.show();
  buttons->button(QDialogButtonBox::Cancel)->click();
  EXPECT_EQ(dialog.result(), QDialog::Rejected);
}

TEST(PartsOfPages, APanelHasTheKeyboardWhileAFieldInsideHasIt) {
  QWidget window;
  auto* panel = new QWidget(&window);
  auto* inside = new QLineEdit(panel);
  auto* outside = new QLineEdit(&window);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  outside->setFocus();
  EXPECT_FALSE(has_keyboard(*panel));
  inside->setFocus();
  EXPECT_TRUE(has_keyboard(*panel));
  panel->hide();
  EXPECT_FALSE(has_keyboard(*panel));
}

TEST(PartsOfPages, TheTabletIsKnownByItsNames) {
  QObject one;
  for (const auto& [name, is] : {std::pair("tablet", true), std::pair("tablet_window", true),
                                 std::pair("tablet_frame", false), std::pair("", false)}) {
    one.setObjectName(QString::fromLatin1(name));
    EXPECT_EQ(is_tablet(&one), is) << name;
  }
}

TEST(PartsOfPages, OfWhatIsDroppedOnlyFilesOfThisComputerAreTaken) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QStringLiteral("/a.str")), QUrl(QStringLiteral("https://example.org/b")),
                QUrl::fromLocalFile(QStringLiteral("/c.png"))});
  EXPECT_EQ(local_files(&data), (QStringList{QStringLiteral("/a.str"), QStringLiteral("/c.png")}));
}

TEST(PartsOfPages, AWindowInsideThatHasTheKeyboardKeepsIt) {
  QWidget window;
  QLineEdit container(&window), other(&window);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  other.setFocus();
  focus_window_container(container, window.windowHandle());
  EXPECT_TRUE(other.hasFocus()) << "that window has it";
  const QWindow elsewhere;
  focus_window_container(container, &elsewhere);
  EXPECT_TRUE(container.hasFocus());
}

TEST(FlowOfItems, WordsThatAreWiderThanTheLineWrapAndTakeTheHeightTheyNeed) {
  QWidget holder;
  auto* flow = new FlowLayout(5, 4, &holder);
  auto* label = new QLabel(QStringLiteral("one two three four five six seven eight nine ten"), &holder);
  label->setWordWrap(true);
  auto* below = new QLabel(QStringLiteral("below"), &holder);
  flow->addWidget(label);
  flow->addWidget(below);
  holder.show();
  const int width = label->fontMetrics().horizontalAdvance(QStringLiteral("three four"));
  const int high = label->heightForWidth(width);
  ASSERT_GT(high, 3 * label->fontMetrics().height());
  EXPECT_EQ(flow->heightForWidth(width), high + 4 + below->sizeHint().height());
  flow->setGeometry({0, 0, width, 1000});
  EXPECT_EQ(label->geometry(), QRect(0, 0, width, high));
  EXPECT_EQ(below->geometry().topLeft(), QPoint(0, high + 4));
}

/// Panes with a panel on both sides, where both wish for more than there is.
class WidthsOfPanes : public testing::Test {
 protected:
  WidthsOfPanes() {
    panes_.set_panels(&left_, &right_);
    panes_.show();
  }
  std::pair<int, int> widths(int window, int text_pt) {
    panes_.resize(window, 600);
    panes_.fit(window, text_pt);
    return {left_.width(), right_.width()};
  }
  using Two = std::pair<int, int>;
  QWidget owner_;
  QLabel &tablet_ = *new QLabel(&owner_), &left_ = *new QLabel(&owner_), &right_ = *new QLabel(&owner_);
  Panes panes_{&tablet_, nullptr};
};

TEST_F(WidthsOfPanes, GrowWithTheTextUpToTheirShareOfTheWindow) {
  panes_.wish(5000, 5000);
  EXPECT_EQ(widths(1600, 12), Two(320, 400));
  EXPECT_EQ(widths(2400, 12), Two(320, 400));
  EXPECT_EQ(widths(1200, 12), Two(260, 332)) << "0.22 and 0.28 of the window, less 4 pixels";
  EXPECT_EQ(widths(2400, 28), Two(320 + 16 * 9, 400 + 16 * 11)) << "9 and 11 pixels a point";
  EXPECT_EQ(widths(1600, 28), Two(348, 444)) << "but not more than their share";
  EXPECT_EQ(widths(2400, 10), Two(320, 400)) << "12 points are the least";
}

TEST_F(WidthsOfPanes, LargeTextHasARoomOfItsOwnWhateverWasWished) {
  panes_.wish(0, 0);
  EXPECT_EQ(widths(2400, 28), Two(11 * 37, 15 * 37)) << "11 and 15 letters of 28 points";
  EXPECT_EQ(widths(2400, 18), Two(11 * 24, 15 * 24));
  panes_.wish(300, 400);
  EXPECT_EQ(widths(2400, 18), Two(300, 400));
  EXPECT_EQ(panes_.left_wish(), 300);
  EXPECT_EQ(panes_.right_wish(), 400);
}

TEST_F(WidthsOfPanes, ADrawerHasAtMostHalfOfTheWindow) {
  panes_.wish(5000, 5000);
  panes_.resize(700, 600);
  panes_.fit(700, 28);
  EXPECT_EQ(left_.parentWidget()->maximumWidth(), 344) << "half of the window, less 6";
  EXPECT_EQ(right_.parentWidget()->maximumWidth(), 344);
  panes_.fit(999, 12);
  EXPECT_EQ(left_.parentWidget()->maximumWidth(), 320);
  EXPECT_EQ(right_.parentWidget()->maximumWidth(), 400);
}

TEST_F(WidthsOfPanes, WhatIsDraggedIsTheWishFromThenOn) {
  widths(1600, 12);
  panes_.handle(1)->setAttribute(Qt::WA_UnderMouse);
  QTest::mousePress(panes_.handle(1), Qt::LeftButton, {}, {0, 100});
  QMouseEvent move(QEvent::MouseMove, QPointF(-30, 100), panes_.handle(1)->mapToGlobal(QPointF(-30, 100)),
                   Qt::NoButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(panes_.handle(1), &move);
  QTest::mouseRelease(panes_.handle(1), Qt::LeftButton);
  EXPECT_EQ(panes_.left_wish(), left_.width());
  EXPECT_EQ(panes_.right_wish(), right_.width());
}

TEST_F(WidthsOfPanes, APanelThatIsFoldedByThePageIsNotForgotten) {
  widths(1600, 12);
  panes_.fold(true, false);
  EXPECT_EQ(panes_.shown_left(), nullptr);
  EXPECT_EQ(panes_.shown_right(), &right_);
  EXPECT_TRUE(panes_.left_wanted());
  panes_.open_left(true);
  EXPECT_EQ(panes_.shown_left(), &left_);
  panes_.close_drawers();
  EXPECT_EQ(panes_.shown_left(), nullptr);
  panes_.fold(false, true);
  EXPECT_EQ(panes_.shown_left(), &left_);
  EXPECT_EQ(panes_.shown_right(), nullptr);
  panes_.open_right(true);
  panes_.open_right(false);
  EXPECT_TRUE(panes_.right_wanted());
  panes_.fold(false, false);
  EXPECT_EQ(panes_.shown_right(), &right_);
}

TEST_F(WidthsOfPanes, TheKeyboardGoesToTheFirstFieldOfAPanelOrToTheOneThatHadIt) {
  auto* first = new QLineEdit(&left_);
  auto* second = new QLineEdit(&left_);
  auto* off = new QLineEdit(&right_);
  auto* on = new QLineEdit(&right_);
  off->setEnabled(false);
  for (auto* one : {first, second, off, on}) one->show();
  widths(1600, 12);
  panes_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panes_));
  panes_.give_keyboard_left();
  EXPECT_TRUE(first->hasFocus());
  second->setFocus();
  panes_.give_keyboard_right();
  EXPECT_TRUE(on->hasFocus());
  panes_.give_keyboard_left();
  EXPECT_TRUE(second->hasFocus());
  const QSignalSpy closing(&panes_, &Panes::keyboard_closing);
  panes_.open_right(false);
  EXPECT_EQ(closing.count(), 0);
  panes_.open_left(false);
  EXPECT_EQ(closing.count(), 1);
}

class PausedButton : public testing::Test {
 protected:
  PausedButton() {
    QObject::connect(&inner_, &QPushButton::clicked, &inner_, [this] { ++inside_; });
    QObject::connect(&other_, &QPushButton::clicked, &other_, [this] { ++outside_; });
    window_.show();
  }
  void click_both() {
    QTest::mouseClick(&inner_, Qt::LeftButton);
    QTest::mouseClick(&other_, Qt::LeftButton);
    QTest::keyClick(&inner_, Qt::Key_Space);
  }
  QWidget window_;
  QWidget& panel_ = *new QWidget(&window_);
  QPushButton &inner_ = *new QPushButton(&panel_), &other_ = *new QPushButton(&window_);
  int inside_ = 0, outside_ = 0;
};

TEST_F(PausedButton, DoesNothingForAMomentAndThenWorksAgain) {
  InputPause pause(&panel_);
  click_both();
  EXPECT_EQ(inside_, 2);
  EXPECT_EQ(outside_, 1);
  EXPECT_FALSE(pause.is_on());
  pause.begin(std::chrono::hours(1));
  EXPECT_TRUE(pause.is_on());
  click_both();
  EXPECT_EQ(inside_, 2) << "neither by mouse nor by key";
  EXPECT_EQ(outside_, 2) << "what is beside it goes on";
  pause.begin(std::chrono::milliseconds(1));
  EXPECT_TRUE(pause.is_on());
  ASSERT_TRUE(QTest::qWaitFor([&pause] { return !pause.is_on(); }, 20'000));
  click_both();
  EXPECT_EQ(inside_, 4);
  EXPECT_EQ(outside_, 3);
}

TEST_F(PausedButton, OtherEventsAndHiddenWidgetsAreLeftAlone) {
  InputPause pause(&panel_);
  pause.begin(std::chrono::hours(1));
  QAction action;
  action.setShortcut(Qt::Key_F12);
  window_.addAction(&action);
  int done = 0;
  QObject::connect(&action, &QAction::triggered, &window_, [&done] { ++done; });
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  QTest::keyClick(&window_, Qt::Key_F12);
  EXPECT_EQ(done, 0) << "no action has a key for a moment";
  panel_.hide();
  QTest::keyClick(&window_, Qt::Key_F12);
  EXPECT_EQ(done, 1);
}

TEST(SignOfFeedback, IsThatOfItsKindInItsColourAndAsLargeAsTheText) {
  FeedbackLine line;
  const int side = QFontInfo(line.font()).pixelSize() * 5 / 4;
  const Colours& c = current_colours();
  const auto* label = line.findChild<QLabel*>(QStringLiteral("feedback_sign"));
  const std::tuple<Feedback, Icon, QColor> all[] = {{Feedback::good, Icon::tick, c.moss},
                                                    {Feedback::hint, Icon::hint, c.muted},
                                                    {Feedback::advice, Icon::advice, c.amber},
                                                    {Feedback::wrong, Icon::cross, c.vermilion}};
  EXPECT_EQ(label->pixmap().toImage(), sign(Icon::hint, c.muted, side, 1).toImage()) << "to begin with";
  for (const auto& [kind, icon, colour] : all) {
    line.announce(kind, QStringLiteral("Same."));
    EXPECT_EQ(label->pixmap().toImage(), sign(icon, colour, side, 1).toImage()) << static_cast<int>(kind);
  }
  EXPECT_EQ(line.times_spoken(), 1) << "one sentence";
  line.speak_unseen(QStringLiteral("Other."));
  EXPECT_EQ(line.times_spoken(), 2);
  EXPECT_EQ(line.sentence(), QStringLiteral("Same."));
}

TEST(SignOfFeedback, ACompactLineHasThirdOfTheMarginsAndSmallerWordsTheMoreThereAre) {
  FeedbackLine line;
  QFont font;
  font.setPointSizeF(20);
  line.setFont(font);
  line.resize(300, 900);
  line.show();
  const auto* text = line.findChild<QLabel*>(QStringLiteral("feedback_text"));
  line.announce(Feedback::hint, QStringLiteral("Short."));
  EXPECT_EQ(line.layout()->contentsMargins(), QMargins(16, 9, 16, 9));
  EXPECT_NEAR(text->font().pointSizeF(), 20, 0.01);
  line.set_compact(true);
  EXPECT_EQ(line.layout()->contentsMargins(), QMargins(16, 3, 16, 3));
  const double compact = text->font().pointSizeF();
  EXPECT_LE(compact, 20 * 0.72 + 0.01);
  EXPECT_GT(compact, 20 * 0.5);
  line.announce(Feedback::hint, QStringLiteral("A sentence that is very much longer than what two lines of "
                                               "this narrow window hold with letters of that size."));
  EXPECT_LT(text->font().pointSizeF(), compact);
  EXPECT_GT(text->font().pointSizeF(), 20 * 0.5 * 0.93) << "half of the size, and less than a step below";
  line.set_compact(false);
  EXPECT_NEAR(text->font().pointSizeF(), 20, 0.01);
  EXPECT_EQ(line.layout()->contentsMargins(), QMargins(16, 9, 16, 9));
}

TEST(SliderForANumber, GoesInStepsAndTellsItsValueWithItsUnit) {
  NumberSlider number(QStringLiteral("Force"), QStringLiteral("force"), 0.5, 2.5, 0.1, QStringLiteral("%1 N"),
                      1, nullptr);
  auto* slider = number.findChild<QSlider*>(QStringLiteral("force"));
  const auto* words = number.findChild<QLabel*>(QStringLiteral("force_value"));
  ASSERT_NE(slider, nullptr);
  EXPECT_EQ(slider->accessibleName(), QStringLiteral("Force"));
  EXPECT_EQ(slider->minimum(), 0);
  EXPECT_EQ(slider->maximum(), 20);
  EXPECT_EQ(slider->pageStep(), 2);
  EXPECT_EQ(words->text(), QStringLiteral("0.5 N"));
  const QSignalSpy moved(&number, &NumberSlider::moved);
  number.set_value(1.16);
  EXPECT_EQ(slider->value(), 7);
  EXPECT_NEAR(number.value(), 1.2, 1e-9);
  EXPECT_EQ(words->text(), QStringLiteral("1.2 N"));
  EXPECT_EQ(slider->accessibleDescription(), QStringLiteral("1.2 N"));
  EXPECT_EQ(moved.count(), 0) << "only a hand moves it";
  slider->setValue(8);
  ASSERT_EQ(moved.count(), 1);
  EXPECT_NEAR(moved.at(0).at(0).toDouble(), 1.3, 1e-9);
  number.set_range(1, 1.4);
  EXPECT_EQ(slider->maximum(), 4);
  EXPECT_EQ(slider->pageStep(), 1) << "one step at least";
  EXPECT_EQ(words->text(), QStringLiteral("1.4 N"));
  EXPECT_EQ(moved.count(), 1);
}

TEST(RowsOfFields, StandInColumnsOrBelowTheirNames) {
  QWidget window;
  window.resize(400, 200);
  auto* column = new QVBoxLayout(&window);
  auto *one = new QLineEdit, *two = new QLineEdit;
  auto* first = new FieldRow(QStringLiteral("A"), one, &window);
  auto* second = new FieldRow(QStringLiteral("A much longer name"), two, &window);
  column->addWidget(first);
  column->addWidget(second);
  window.show();
  FieldRow::arrange({first, second}, false);
  QCoreApplication::sendPostedEvents();
  QCoreApplication::processEvents();
  const auto* name = second->findChild<QLabel*>();
  EXPECT_EQ(name->buddy(), two);
  EXPECT_EQ(one->x(), two->x());
  EXPECT_EQ(two->x(), name->sizeHint().width() + 6);
  EXPECT_FALSE(name->wordWrap());
  FieldRow::arrange({first, second}, true);
  QCoreApplication::sendPostedEvents();
  QCoreApplication::processEvents();
  EXPECT_EQ(two->x(), 0);
  EXPECT_EQ(two->y(), name->height());
  EXPECT_TRUE(name->wordWrap());
  EXPECT_EQ(name->minimumWidth(), 0);
}

TEST(RingAroundTheTablet, IsShownWhereItHasTheKeyboardAndWasReachedByKey) {
  QWidget window;
  auto* inner = new QLineEdit;
  FocusFrame frame(inner, &window);
  auto* other = new QLineEdit(&window);
  frame.resize(100, 60);
  window.resize(300, 200);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  other->setFocus();
  QTest::keyClick(other, Qt::Key_A);
  EXPECT_FALSE(frame.shows_ring());
  inner->setFocus();
  EXPECT_TRUE(frame.shows_ring());
  EXPECT_EQ(frame.layout()->contentsMargins(), QMargins(2, 2, 2, 2));
  const auto boxes = test::drawn_by(frame).boxes();
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_EQ(boxes[0].pen_words(), QStringLiteral("indigo 4"));
  EXPECT_NEAR(boxes[0].box.width(), 100, 1);
  QTest::mouseClick(inner, Qt::LeftButton);
  EXPECT_FALSE(frame.shows_ring());
  EXPECT_TRUE(test::drawn_by(frame).boxes().empty());
  QTest::keyClick(inner, Qt::Key_B);
  EXPECT_TRUE(frame.shows_ring());
  other->setFocus();
  EXPECT_FALSE(frame.shows_ring());
}

}  // namespace
}  // namespace nazori::ui
