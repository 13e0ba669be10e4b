// SPDX-License-Identifier: Apache-2.0
// The keys that move a pen: which ones, over which widget, and what they leave to others.
#include "nazori/studio/parts/key_writing.h"

#include <QKeyEvent>
#include <QMenu>

#include "page_under_test.h"

namespace nazori::ui {
namespace {

using test::sentence;

class KeysOfThePen : public test::PageTest {
 protected:
  KeysOfThePen() {
    qputenv("SDL_AUDIODRIVER", "dummy");
    on_.setCheckable(true);
    press_.setShortcut(QKeySequence(Qt::Key_U));
    next_.setShortcut(QKeySequence(Qt::Key_N));
    where_.setShortcut(QKeySequence(Qt::Key_K));
  }
  /// Sends a key to a widget. @return whether the pen took it.
  bool key(QObject& to, int which, Qt::KeyboardModifiers modifiers = {},
           QEvent::Type type = QEvent::KeyPress) {
    said_.clear();
    QKeyEvent event(type, which, modifiers);
    event.ignore();
    QCoreApplication::sendEvent(&to, &event);
    return event.isAccepted();
  }
  /// How far a key moves the pen [mm], to the right and up.
  std::pair<double, double> way(int which, Qt::KeyboardModifiers modifiers = {}) {
    const geometry::TabletPoint before = at_;
    EXPECT_TRUE(key(sheet_, which, modifiers)) << which;
    return {std::round((at_.x - before.x) * 1e4) / 10, std::round((at_.y - before.y) * 1e4) / 10};
  }
  using Way = std::pair<double, double>;

  QWidget sheet_{&window_}, other_{&window_};
  QAction on_, press_, next_, where_;
  geometry::TabletPoint at_{0, 0};
  bool down_ = false;
  int gone_ = 0;
  practice::SheetGround ground_{0.1,
                                [this](geometry::TabletPoint at, bool down, double) {
                                  at_ = at;
                                  down_ = down;
                                },
                                [this] { ++gone_; }};
  KeyWriting keys_{parts_,
                   ground_,
                   {&on_, &press_, &next_, &where_},
                   [this](const QObject* one) { return one == &sheet_; },
                   &window_};
};

TEST_F(KeysOfThePen, AreOffUntilTheyAreSwitchedOn) {
  EXPECT_FALSE(keys_.is_on());
  for (auto* action : {&press_, &next_, &where_}) EXPECT_FALSE(action->isEnabled());
  EXPECT_FALSE(key(sheet_, Qt::Key_Left));
  const int focused = focused_;
  EXPECT_EQ(focused, 0);
  on_.trigger();
  EXPECT_TRUE(keys_.is_on());
  EXPECT_EQ(focused_, 1);
  EXPECT_EQ(all_said(),
            sentence("The keys move the pen. Arrow keys: move. U: pen down or up. N: next start. K: where."));
  EXPECT_EQ(kind_, Feedback::hint);
  for (auto* action : {&press_, &next_, &where_}) EXPECT_TRUE(action->isEnabled());
  said_.clear();
  on_.trigger();
  EXPECT_EQ(all_said(), sentence("The keys no longer move the pen."));
  EXPECT_FALSE(keys_.is_on());
  EXPECT_EQ(gone_, 1);
  for (auto* action : {&press_, &next_, &where_}) EXPECT_FALSE(action->isEnabled());
  EXPECT_FALSE(key(sheet_, Qt::Key_Left));
  on_.trigger();
  keys_.end();
  EXPECT_FALSE(on_.isChecked());
}

TEST_F(KeysOfThePen, ArrowsAndTheNumberPadMoveItTheirWay) {
  on_.trigger();
  EXPECT_EQ(way(Qt::Key_Right), (Way{2, 0}));
  EXPECT_EQ(way(Qt::Key_Left), (Way{-2, 0}));
  EXPECT_EQ(way(Qt::Key_Up), (Way{0, 2}));
  EXPECT_EQ(way(Qt::Key_Down), (Way{0, -2}));
  EXPECT_EQ(way(Qt::Key_Right, Qt::ShiftModifier), (Way{0.5, 0}));
  const auto pad = Qt::KeypadModifier;
  const std::tuple<int, double, double> all[] = {
      {Qt::Key_1, -2, -2},   {Qt::Key_2, 0, -2},        {Qt::Key_3, 2, -2},    {Qt::Key_4, -2, 0},
      {Qt::Key_6, 2, 0},     {Qt::Key_7, -2, 2},        {Qt::Key_8, 0, 2},     {Qt::Key_9, 2, 2},
      {Qt::Key_End, -2, -2}, {Qt::Key_PageDown, 2, -2}, {Qt::Key_Home, -2, 2}, {Qt::Key_PageUp, 2, 2},
      {Qt::Key_Left, -2, 0}};
  for (const auto& [which, right, up] : all) EXPECT_EQ(way(which, pad), (Way{right, up})) << which;
  for (const int which : {Qt::Key_1, Qt::Key_5, Qt::Key_Home, Qt::Key_PageUp, Qt::Key_Clear, Qt::Key_A})
    EXPECT_FALSE(key(sheet_, which)) << which << ": not on the pad";
  EXPECT_FALSE(key(sheet_, Qt::Key_0, pad));
  EXPECT_EQ(all_said(), QString()) << "a step alone is not told";
}

TEST_F(KeysOfThePen, TheMiddleOfThePadPutsItDownAndLiftsIt) {
  on_.trigger();
  for (const int which : {Qt::Key_5, Qt::Key_Clear}) {
    EXPECT_TRUE(key(sheet_, which, Qt::KeypadModifier));
    EXPECT_TRUE(down_);
    EXPECT_EQ(all_said(), sentence("Pen down."));
    EXPECT_TRUE(key(sheet_, which, Qt::KeypadModifier));
    EXPECT_FALSE(down_);
    EXPECT_EQ(all_said(), sentence("Pen up."));
  }
  said_.clear();
  press_.trigger();
  EXPECT_EQ(all_said(), sentence("Pen down."));
}

TEST_F(KeysOfThePen, ItIsToldWhereItIsAndWhatItMeets) {
  ground_.set_strokes({{{-0.02, 0.03}, {0.02, 0.03}}, {{0, -0.01}, {0, -0.03}}});
  on_.trigger();
  const auto said_by = [this](QAction& action) {
    said_.clear();
    action.trigger();
    return all_said();
  };
  EXPECT_EQ(said_by(where_), sentence("No stroke here: 50% from the left, 50% from the top."));
  EXPECT_EQ(said_by(next_), sentence("Start of stroke 1."));
  EXPECT_NEAR(at_.x, -0.02, 1e-9);
  EXPECT_EQ(said_by(where_), sentence("Stroke 1, 0% of its length: 30% from the left, 20% from the top."));
  EXPECT_EQ(said_by(next_), sentence("Start of stroke 2."));
  EXPECT_EQ(kind_, Feedback::hint);
}

TEST_F(KeysOfThePen, OtherWidgetsOtherKeysAndWhatIsInFrontOfTheSheetGoOnAsBefore) {
  on_.trigger();
  const auto before = at_;
  EXPECT_FALSE(key(other_, Qt::Key_Left));
  EXPECT_FALSE(key(sheet_, Qt::Key_Left, Qt::ControlModifier));
  EXPECT_FALSE(key(sheet_, Qt::Key_Left, Qt::AltModifier));
  EXPECT_FALSE(key(sheet_, Qt::Key_Left, {}, QEvent::KeyRelease));
  // A shortcut of the same key must not come first, but it is no step yet.
  EXPECT_TRUE(key(sheet_, Qt::Key_Left, {}, QEvent::ShortcutOverride));
  EXPECT_EQ(at_, before);
  {
    QDialog dialog(&window_);
    dialog.setModal(true);
    dialog.show();
    EXPECT_FALSE(key(sheet_, Qt::Key_Left));
  }
  {
    QMenu menu(&window_);
    menu.addAction(QStringLiteral("One"));
    menu.popup({0, 0});
    ASSERT_EQ(QApplication::activePopupWidget(), &menu);
    EXPECT_FALSE(key(sheet_, Qt::Key_Left));
  }
  EXPECT_EQ(at_, before);
  EXPECT_TRUE(key(sheet_, Qt::Key_Left));
}

}  // namespace
}  // namespace nazori::ui
