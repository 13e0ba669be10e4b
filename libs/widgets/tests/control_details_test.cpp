// SPDX-License-Identifier: Apache-2.0
// Rooms, order and keyboard of the controls that pages are made of.
#include <gtest/gtest.h>

#include <QAccessible>
#include <QActionGroup>
#include <QApplication>
#include <QBoxLayout>
#include <QInputDevice>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTabletEvent>
#include <QTest>
#include <QToolButton>
#include <QTouchEvent>

#include "nazori/widgets/controls/choice_access.h"
#include "nazori/widgets/controls/field_row.h"
#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/focus_frame.h"
#include "nazori/widgets/controls/input_pause.h"
#include "nazori/widgets/controls/input_watch.h"
#include "nazori/widgets/controls/key_guard.h"
#include "nazori/widgets/controls/number_slider.h"
#include "nazori/widgets/controls/panes.h"
#include "nazori/widgets/controls/parts.h"
#include "painting_under_test.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

QString said(const char* text) { return QString::fromUtf8(text); }

class PanesInDetail : public testing::Test {
 protected:
  PanesInDetail() {
    panes_.set_panels(&left_, &right_);
    panes_.resize(1600, 600);
    panes_.show();
    panes_.fit(1600, 12);
  }
  QWidget& holder(const QWidget& panel) { return *panel.parentWidget(); }
  void activate() {
    panes_.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&panes_));
  }
  QWidget owner_;
  QLabel &tablet_ = *new QLabel(&owner_), &left_ = *new QLabel(&owner_), &right_ = *new QLabel(&owner_);
  Panes panes_{&tablet_, nullptr};
};

TEST_F(PanesInDetail, StandSideBySideWithAThinHandleAndNoMargins) {
  EXPECT_EQ(panes_.objectName(), said("panes"));
  EXPECT_EQ(panes_.orientation(), Qt::Horizontal);
  EXPECT_EQ(panes_.handleWidth(), 1);
  EXPECT_FALSE(panes_.childrenCollapsible());
  ASSERT_EQ(panes_.count(), 3);
  EXPECT_EQ(panes_.widget(0), &holder(left_));
  EXPECT_EQ(panes_.widget(1), &tablet_);
  EXPECT_EQ(panes_.widget(2), &holder(right_));
  EXPECT_EQ(holder(left_).minimumWidth(), 180);
  EXPECT_EQ(holder(right_).minimumWidth(), 240);
  for (const auto* panel : {&left_, &right_}) {
    EXPECT_EQ(holder(*panel).layout()->contentsMargins(), QMargins());
    EXPECT_EQ(holder(*panel).layout()->count(), 1);
  }
}

TEST_F(PanesInDetail, TheTabletTakesWhatTheWindowGrows) {
  panes_.wish(200, 260);
  panes_.fit(1600, 12);
  const int before = tablet_.width();
  panes_.resize(1700, 600);
  QCoreApplication::sendPostedEvents();
  EXPECT_EQ(tablet_.width(), before + 100);
  EXPECT_EQ(left_.width(), 200);
  EXPECT_EQ(right_.width(), 260);
}

TEST_F(PanesInDetail, ChangingSidesKeepsWhatEachPanelHas) {
  panes_.wish(200, 260);
  panes_.fit(1600, 12);
  const QList<int> before = panes_.sizes();
  panes_.set_mirrored(true);
  EXPECT_EQ(panes_.widget(0), &holder(right_));
  EXPECT_EQ(panes_.widget(1), &tablet_);
  EXPECT_EQ(panes_.widget(2), &holder(left_));
  EXPECT_EQ(panes_.sizes(), (QList<int>{before[2], before[1], before[0]}));
  panes_.set_mirrored(false);
  EXPECT_EQ(panes_.widget(0), &holder(left_));
  EXPECT_EQ(panes_.sizes(), before);
}

TEST_F(PanesInDetail, APanelThatIsSetAgainStaysOnceInItsPlace) {
  panes_.set_panels(&left_, &right_);
  EXPECT_EQ(holder(left_).layout()->count(), 1);
  EXPECT_TRUE(left_.isVisible());
  panes_.set_panels(nullptr, &right_);
  EXPECT_FALSE(left_.isVisible());
  EXPECT_EQ(panes_.shown_left(), nullptr);
  panes_.open_left(true);
  EXPECT_EQ(panes_.shown_left(), nullptr) << "there is none";
  panes_.give_keyboard_left();
}

TEST_F(PanesInDetail, OfBothFoldedPanelsEachComesBackByItself) {
  int told = 0;
  QObject::connect(&panes_, &Panes::opened, &panes_, [&told] { ++told; });
  panes_.fold(true, true);
  EXPECT_EQ(panes_.shown_left(), nullptr);
  EXPECT_EQ(panes_.shown_right(), nullptr);
  EXPECT_EQ(told, 1);
  panes_.fold(true, true);
  EXPECT_EQ(told, 1) << "as it was";
  panes_.open_right(true);
  panes_.close_drawers();
  EXPECT_EQ(panes_.shown_right(), nullptr) << "open for a moment only";
  panes_.fold(true, false);
  EXPECT_EQ(panes_.shown_right(), &right_);
  panes_.fold(false, false);
  EXPECT_EQ(panes_.shown_left(), &left_);
  panes_.open_right(false);
  panes_.fold(true, false);
  panes_.fold(false, false);
  EXPECT_EQ(panes_.shown_right(), nullptr) << "it was closed before";
  EXPECT_EQ(panes_.shown_left(), &left_);
}

TEST_F(PanesInDetail, OneFoldedPanelGoesAgainWithTheDrawers) {
  panes_.fold(false, true);
  panes_.open_right(true);
  EXPECT_EQ(panes_.shown_right(), &right_);
  panes_.close_drawers();
  EXPECT_EQ(panes_.shown_right(), nullptr);
  EXPECT_EQ(panes_.shown_left(), &left_);
  panes_.fold(true, false);
  panes_.open_left(true);
  EXPECT_EQ(panes_.shown_left(), &left_);
  panes_.close_drawers();
  EXPECT_EQ(panes_.shown_left(), nullptr);
  EXPECT_EQ(panes_.shown_right(), &right_);
}

TEST_F(PanesInDetail, ADrawerThatIsDraggedIsNoWish) {
  panes_.wish(200, 260);
  panes_.resize(900, 600);
  panes_.fit(900, 12);
  panes_.open_left(true);
  QMetaObject::invokeMethod(&panes_, "splitterMoved", Q_ARG(int, 230), Q_ARG(int, 1));
  EXPECT_EQ(panes_.left_wish(), 200);
  EXPECT_EQ(panes_.right_wish(), 260);
  panes_.resize(1600, 600);
  panes_.fit(1600, 12);
  panes_.open_left(false);
  QMetaObject::invokeMethod(&panes_, "splitterMoved", Q_ARG(int, 230), Q_ARG(int, 1));
  EXPECT_EQ(panes_.left_wish(), 200) << "it is closed";
  panes_.open_left(true);
  panes_.open_right(false);
  QMetaObject::invokeMethod(&panes_, "splitterMoved", Q_ARG(int, 230), Q_ARG(int, 1));
  EXPECT_EQ(panes_.right_wish(), 260);
}

TEST_F(PanesInDetail, TheKeyboardGoesToWhatTabReaches) {
  auto* hidden = new QLineEdit(&left_);
  auto* by_mouse = new QLineEdit(&left_);
  auto* shown = new QLineEdit(&left_);
  by_mouse->setFocusPolicy(Qt::ClickFocus);
  hidden->hide();
  by_mouse->show();
  shown->show();
  activate();
  panes_.give_keyboard_left();
  EXPECT_TRUE(shown->hasFocus());
  // A panel without fields takes it itself where it can, else nobody does.
  panes_.give_keyboard_right();
  EXPECT_TRUE(shown->hasFocus());
  right_.setFocusPolicy(Qt::StrongFocus);
  panes_.give_keyboard_right();
  EXPECT_TRUE(right_.hasFocus());
  const QSignalSpy closing(&panes_, &Panes::keyboard_closing);
  panes_.open_left(false);
  EXPECT_EQ(closing.count(), 0);
  panes_.open_right(false);
  EXPECT_EQ(closing.count(), 1);
}

TEST(SliderInDetail, ItsNameAndItsValueStandAboveIt) {
  NumberSlider number(said("&Force of the hand that leads"), said("force"), 1, 3, 0.05, said("%1 N"), 2,
                      nullptr);
  const auto* slider = number.findChild<QSlider*>();
  const auto* words = number.findChild<QLabel*>(said("force_value"));
  const QLabel* name = nullptr;
  for (const auto* label : number.findChildren<QLabel*>())
    if (label != words) name = label;
  ASSERT_NE(name, nullptr);
  EXPECT_EQ(name->text(), said("&Force of the hand that leads"));
  EXPECT_EQ(name->buddy(), slider);
  EXPECT_TRUE(name->wordWrap());
  EXPECT_EQ(slider->orientation(), Qt::Horizontal);
  EXPECT_EQ(slider->maximum(), 40);
  EXPECT_EQ(slider->pageStep(), 4);
  EXPECT_EQ(slider->accessibleDescription(), said("1.00 N"));
  EXPECT_EQ(number.layout()->contentsMargins(), QMargins());
  EXPECT_EQ(number.layout()->spacing(), 0);
  number.resize(400, 100);
  number.show();
  QCoreApplication::sendPostedEvents();
  EXPECT_EQ(words->x(), name->geometry().right() + 1 + 8);
  EXPECT_GE(slider->y(), words->geometry().bottom() + 1);
  // Too narrow for both: one below the other.
  number.resize(words->width() + 10, 200);
  QCoreApplication::sendPostedEvents();
  number.layout()->activate();
  EXPECT_EQ(words->x(), 0);
  EXPECT_EQ(words->y(), name->geometry().bottom() + 1);
}

TEST(SliderInDetail, AnotherRangeMovesNothingByHandAndAValueBelowItIsItsLowEnd) {
  NumberSlider number(said("Force"), said("force"), 0, 10, 1, said("%1"), 0, nullptr);
  const QSignalSpy moved(&number, &NumberSlider::moved);
  number.set_value(10);
  number.set_range(2, 4);
  EXPECT_EQ(moved.count(), 0);
  EXPECT_EQ(number.value(), 4);
  number.set_value(-3);
  EXPECT_EQ(number.value(), 2);
  EXPECT_EQ(moved.count(), 0);
  number.findChild<QSlider*>()->setValue(1);
  EXPECT_EQ(moved.count(), 1) << "a hand is heard again";
  EXPECT_EQ(moved.at(0).at(0).toDouble(), 3);
  EXPECT_EQ(number.findChild<QLabel*>(said("force_value"))->text(), said("3"));
}

TEST(RowOfAField, HasNoMarginsAndTheFieldTakesTheRoom) {
  auto* field = new QLineEdit;
  FieldRow row(said("A"), field, nullptr);
  const auto* layout = qobject_cast<QBoxLayout*>(row.layout());
  EXPECT_EQ(layout->contentsMargins(), QMargins());
  EXPECT_EQ(layout->spacing(), 6);
  ASSERT_EQ(layout->count(), 2);
  EXPECT_EQ(layout->stretch(0), 0);
  EXPECT_EQ(layout->stretch(1), 1);
  EXPECT_EQ(layout->direction(), QBoxLayout::LeftToRight);
  auto* name = qobject_cast<QLabel*>(layout->itemAt(0)->widget());
  ASSERT_NE(name, nullptr);
  EXPECT_EQ(name->text(), said("A"));
  FieldRow::arrange({&row}, true);
  EXPECT_EQ(layout->direction(), QBoxLayout::TopToBottom);
  EXPECT_EQ(layout->spacing(), 0);
  EXPECT_EQ(name->minimumWidth(), 0);
  EXPECT_TRUE(name->wordWrap());
  FieldRow::arrange({&row}, false);
  EXPECT_EQ(layout->direction(), QBoxLayout::LeftToRight);
  EXPECT_EQ(layout->spacing(), 6);
  EXPECT_FALSE(name->wordWrap());
  EXPECT_EQ(name->minimumWidth(), name->sizeHint().width());
}

TEST(FlowInDetail, StartsWithoutMarginsAndMeasuresWithoutMoving) {
  QWidget holder;
  auto* flow = new FlowLayout(5, 4, &holder);
  EXPECT_EQ(flow->contentsMargins(), QMargins());
  EXPECT_EQ(flow->heightForWidth(100), 0) << "nothing in it";
  auto* one = new QLabel(said("one"), &holder);
  flow->addWidget(one);
  holder.show();
  flow->setGeometry({3, 4, 200, 100});
  EXPECT_EQ(flow->geometry(), QRect(3, 4, 200, 100));
  const QRect before = one->geometry();
  EXPECT_EQ(before.topLeft(), QPoint(3, 4));
  EXPECT_EQ(flow->heightForWidth(1), one->sizeHint().height());
  EXPECT_EQ(one->geometry(), before);
  // Taken from the beginning, too.
  const std::unique_ptr<QLayoutItem> taken(flow->takeAt(0));
  ASSERT_NE(taken, nullptr);
  EXPECT_EQ(taken->widget(), one);
  EXPECT_EQ(flow->takeAt(0), nullptr);
}

TEST(RingInDetail, IsHiddenByEveryPointerAndComesBackWithAShortcut) {
  QWidget window;
  window.setAttribute(Qt::WA_AcceptTouchEvents);
  auto* inner = new QLineEdit;
  FocusFrame frame(inner, &window);
  EXPECT_EQ(frame.objectName(), said("tablet_frame"));
  frame.resize(100, 60);
  window.resize(300, 200);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  inner->setFocus();
  const auto shortcut = [&] {
    QKeyEvent key(QEvent::ShortcutOverride, Qt::Key_F5, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &key);
  };
  shortcut();
  EXPECT_TRUE(frame.shows_ring());
  const QPointingDevice pen(said("pen"), 31, QInputDevice::DeviceType::Stylus,
                            QPointingDevice::PointerType::Pen, QInputDevice::Capability::Position, 1, 1);
  QTabletEvent touch(QEvent::TabletPress, &pen, QPointF(), QPointF(), 1, 0, 0, 0, 0, 0, Qt::NoModifier,
                     Qt::LeftButton, Qt::LeftButton);
  QCoreApplication::sendEvent(&window, &touch);
  EXPECT_FALSE(frame.shows_ring()) << "a pen";
  shortcut();
  EXPECT_TRUE(frame.shows_ring());
  const QPointingDevice screen(said("screen"), 32, QInputDevice::DeviceType::TouchScreen,
                               QPointingDevice::PointerType::Finger, QInputDevice::Capability::Position, 2,
                               0);
  QTouchEvent finger(QEvent::TouchBegin, &screen);
  QCoreApplication::sendEvent(&window, &finger);
  EXPECT_FALSE(frame.shows_ring()) << "a finger";
  QKeyEvent key(QEvent::KeyPress, Qt::Key_F5, Qt::NoModifier);
  QCoreApplication::sendEvent(&window, &key);
  EXPECT_TRUE(frame.shows_ring());
  // The window inside has the keyboard now: no widget has it.
  emit qApp->focusChanged(inner, nullptr);
  EXPECT_TRUE(frame.shows_ring());
  emit qApp->focusChanged(nullptr, &window);
  EXPECT_FALSE(frame.shows_ring());
}

TEST(RingInDetail, IsPaintedAnewWithTheFocusAndWithTheKeys) {
  QWidget window;
  auto* inner = new QLineEdit;
  auto* frame = new FocusFrame(inner, &window);
  auto* other = new QLineEdit(&window);
  frame->resize(100, 60);
  window.resize(300, 200);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  other->setFocus();
  QTest::keyClick(other, Qt::Key_A);
  /// Counts how often the frame is painted.
  class Count final : public QObject {
   public:
    int painted = 0;
    bool eventFilter(QObject*, QEvent* event) override {
      painted += event->type() == QEvent::Paint ? 1 : 0;
      return false;
    }
  } count;
  frame->installEventFilter(&count);
  const auto painted_by = [&](const std::function<void()>& change) {
    for (int i = 0; i < 10; ++i) QCoreApplication::processEvents();
    count.painted = 0;
    change();
    return QTest::qWaitFor([&] { return count.painted > 0; }, 1000);
  };
  EXPECT_TRUE(painted_by([&] { emit qApp->focusChanged(other, inner); }));
  QKeyEvent key(QEvent::ShortcutOverride, Qt::Key_F5, Qt::NoModifier);
  QMouseEvent mouse(QEvent::MouseButtonPress, QPointF(), QPointF(), Qt::LeftButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(frame, &mouse);
  EXPECT_TRUE(painted_by([&] { QCoreApplication::sendEvent(other, &key); }));
}

TEST(ChoiceInDetail, OnlyAButtonOfAGroupThatExcludesIsOneOfSeveral) {
  describe_choices();
  QWidget window;
  QActionGroup group(&window), loose(&window);
  loose.setExclusionPolicy(QActionGroup::ExclusionPolicy::None);
  QAction plain(said("Plain")), chosen(said("Chosen")), loosely(said("Free"));
  group.addAction(&plain);
  for (auto* action : {&chosen, &loosely}) action->setCheckable(true);
  group.addAction(&chosen);
  loose.addAction(&loosely);
  const auto role_of = [&](QAction* action) {
    auto* button = new QToolButton(&window);
    if (action != nullptr) button->setDefaultAction(action);
    return QAccessible::queryAccessibleInterface(button)->role();
  };
  EXPECT_EQ(role_of(&chosen), QAccessible::RadioButton);
  EXPECT_NE(role_of(&plain), QAccessible::RadioButton) << "cannot be checked";
  EXPECT_NE(role_of(&loosely), QAccessible::RadioButton) << "excludes nothing";
  EXPECT_NE(role_of(nullptr), QAccessible::RadioButton) << "has no action";
  QPushButton other(&window);
  EXPECT_NE(QAccessible::queryAccessibleInterface(&other)->role(), QAccessible::RadioButton);
}

TEST(ChoiceInDetail, TakesTheKeyboardWhereItIsAskedTo) {
  describe_choices();
  QWidget window;
  QActionGroup group(&window);
  QAction one(said("One"));
  one.setCheckable(true);
  group.addAction(&one);
  auto* button = new QToolButton(&window);
  button->setDefaultAction(&one);
  button->setFocusPolicy(Qt::StrongFocus);
  auto* other = new QLineEdit(&window);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  other->setFocus();
  auto* part = QAccessible::queryAccessibleInterface(button);
  part->actionInterface()->doAction(QAccessibleActionInterface::setFocusAction());
  EXPECT_TRUE(button->hasFocus());
  EXPECT_FALSE(one.isChecked());
  EXPECT_EQ(part->text(QAccessible::Help), QString());
  button->setToolTip(QString());
  EXPECT_EQ(part->text(QAccessible::Value), QString()) << "only a name and a key";
}

TEST(KeysInDetail, WhileAMenuIsOpenItHasThem) {
  QMenu menu;
  menu.addAction(said("One"));
  QSlider slider;
  menu.popup(QPoint());
  ASSERT_EQ(QApplication::activePopupWidget(), &menu);
  KeyGuard guard;
  QKeyEvent event(QEvent::ShortcutOverride, Qt::Key_Left, Qt::NoModifier);
  event.ignore();
  EXPECT_FALSE(static_cast<QObject&>(guard).eventFilter(&slider, &event));
  EXPECT_FALSE(event.isAccepted());
  menu.close();
  EXPECT_TRUE(static_cast<QObject&>(guard).eventFilter(&slider, &event));
  EXPECT_TRUE(event.isAccepted());
}

TEST(PauseInDetail, EndsForGoodWhenItIsEnded) {
  QWidget window;
  QPushButton button(&window);
  window.show();
  int clicked = 0;
  QObject::connect(&button, &QPushButton::clicked, &button, [&clicked] { ++clicked; });
  InputPause pause(&window);
  pause.begin(std::chrono::milliseconds(1));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !pause.is_on(); }, 20'000));
  QTest::mouseClick(&button, Qt::LeftButton);
  EXPECT_EQ(clicked, 1);
  pause.begin(std::chrono::hours(1));
  // A double click, a pen and a finger are presses, too; a move and a release are not.
  const auto passes = [&](QEvent::Type type) {
    QMouseEvent event(type, QPointF(1, 1), QPointF(1, 1), Qt::LeftButton, Qt::LeftButton, {});
    return !static_cast<QObject&>(pause).eventFilter(&button, &event);
  };
  EXPECT_FALSE(passes(QEvent::MouseButtonPress));
  EXPECT_FALSE(passes(QEvent::MouseButtonDblClick));
  EXPECT_FALSE(passes(QEvent::TabletPress));
  EXPECT_FALSE(passes(QEvent::TouchBegin));
  EXPECT_FALSE(passes(QEvent::KeyPress));
  EXPECT_TRUE(passes(QEvent::MouseMove));
  EXPECT_TRUE(passes(QEvent::MouseButtonRelease));
  QMouseEvent press(QEvent::MouseButtonPress, QPointF(), QPointF(), Qt::LeftButton, Qt::LeftButton, {});
  EXPECT_TRUE(static_cast<QObject&>(pause).eventFilter(&window, &press)) << "the widget itself";
  QWidget elsewhere;
  EXPECT_FALSE(static_cast<QObject&>(pause).eventFilter(&elsewhere, &press));
  QObject none;
  EXPECT_FALSE(static_cast<QObject&>(pause).eventFilter(&none, &press)) << "no widget at all";
}

}  // namespace
}  // namespace nazori::ui
