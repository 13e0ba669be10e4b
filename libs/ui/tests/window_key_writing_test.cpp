// SPDX-License-Identifier: Apache-2.0
// Exploring and writing without a mouse, a pen or a device: the keys move the pen.
#include <QAction>

#include "characters/characters.h"
#include "nazori/studio/parts/key_writing.h"
#include "nazori/widgets/page/window_parts.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

WindowParts* key_parts = nullptr;

class KeyWritingInTheWindow : public WindowTest {
 protected:
  KeyWritingInTheWindow() {
    pages_ = {[](WindowParts& parts) -> std::unique_ptr<Page> {
      key_parts = &parts;
      return std::make_unique<Characters>(parts);
    }};
    qputenv("SDL_AUDIODRIVER", "dummy");
  }

  /// A key on the tablet, as the window system sends it.
  void on_tablet(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier, int times = 1) {
    auto* tablet = find("tablet");
    for (int i = 0; i < times; ++i) QTest::keyClick(tablet, key, modifiers);
  }
  bool says(const char* words) {
    return QTest::qWaitFor([&] { return feedback().contains(QString::fromUtf8(words)); }, 20'000);
  }
  /// Waits until the stylus of the servo lies where the keys put it.
  static bool arrives(double x_m, double y_m) {
    return QTest::qWaitFor(
        [&] {
          const auto& at = key_parts->tablet().latest().device_m;
          return std::hypot(at.x - x_m, at.y - y_m) < 2e-4;
        },
        20'000);
  }
};

TEST_F(KeyWritingInTheWindow, StrokesAreExploredByKeyAndNamed) {
  show(U'十');
  for (const char* name : {"pen_down", "pen_start", "pen_where"})
    EXPECT_FALSE(action(name)->isEnabled()) << name;
  press(Qt::Key_M);
  EXPECT_TRUE(says("The keys move the pen"));
  EXPECT_TRUE(find("tablet")->hasFocus());
  press(Qt::Key_T);
  EXPECT_TRUE(says("Start of stroke 1.")) << feedback().toStdString();
  on_tablet(Qt::Key_Up, Qt::NoModifier, 3);
  EXPECT_TRUE(says("Beside stroke 1.")) << feedback().toStdString();
  on_tablet(Qt::Key_Down, Qt::NoModifier, 2);
  EXPECT_TRUE(says("Start of stroke 1.")) << feedback().toStdString();
  press(Qt::Key_T);
  EXPECT_TRUE(says("Start of stroke 2.")) << feedback().toStdString();
  press(Qt::Key_I);
  EXPECT_TRUE(says("Stroke 2, 0% of its length: 48% from the left, 11% from the top."))
      << feedback().toStdString();
  on_tablet(Qt::Key_4, Qt::KeypadModifier, 60);
  EXPECT_TRUE(says("This is the edge.")) << feedback().toStdString();
  press(Qt::Key_M);
  EXPECT_TRUE(says("The keys no longer move the pen."));
  EXPECT_FALSE(action("pen_down")->isEnabled());
}

TEST_F(KeyWritingInTheWindow, TheNumberPadMovesDiagonallyAndItsMiddlePutsThePenDown) {
  show(U'十');
  press(Qt::Key_M);
  on_tablet(Qt::Key_7, Qt::KeypadModifier);
  ASSERT_TRUE(arrives(-2e-3, 2e-3));
  on_tablet(Qt::Key_3, Qt::KeypadModifier, 3);
  ASSERT_TRUE(arrives(4e-3, -4e-3));
  on_tablet(Qt::Key_9, Qt::KeypadModifier);
  on_tablet(Qt::Key_1, Qt::KeypadModifier, 2);
  ASSERT_TRUE(arrives(2e-3, -6e-3));
  on_tablet(Qt::Key_8, Qt::KeypadModifier);
  on_tablet(Qt::Key_6, Qt::KeypadModifier);
  on_tablet(Qt::Key_Right, Qt::ShiftModifier);
  ASSERT_TRUE(arrives(4.5e-3, -4e-3));
  on_tablet(Qt::Key_5, Qt::KeypadModifier);
  EXPECT_TRUE(says("Pen down."));
  EXPECT_TRUE(key_parts->tablet().is_pressed());
  on_tablet(Qt::Key_5, Qt::KeypadModifier);
  EXPECT_TRUE(says("Pen up."));
  // Digits above the letters are not the number pad.
  on_tablet(Qt::Key_2);
  EXPECT_TRUE(arrives(4.5e-3, -4e-3));
}

TEST_F(KeyWritingInTheWindow, WhatIsWrittenByKeyFromMemoryIsJudged) {
  show(U'一');
  press(Qt::Key_F8);
  press(Qt::Key_M);
  press(Qt::Key_T);
  EXPECT_TRUE(says("There are no strokes to go to.")) << feedback().toStdString();
  on_tablet(Qt::Key_Left, Qt::NoModifier, 20);
  ASSERT_TRUE(arrives(-40e-3, 0));
  press(Qt::Key_P);
  ASSERT_TRUE(QTest::qWaitFor([] { return key_parts->tablet().latest().touching; }, 20'000));
  for (int i = 1; i <= 40; ++i) {
    on_tablet(Qt::Key_Right);
    ASSERT_TRUE(arrives(-40e-3 + i * 2e-3, 0)) << i;
  }
  press(Qt::Key_P);
  EXPECT_TRUE(says("of 5 stars")) << feedback().toStdString();
}

TEST_F(KeyWritingInTheWindow, AnotherStrokeThanTheRightOneIsRefused) {
  show(U'一');
  press(Qt::Key_F8);
  press(Qt::Key_M);
  on_tablet(Qt::Key_Up, Qt::NoModifier, 20);
  ASSERT_TRUE(arrives(0, 40e-3));
  press(Qt::Key_P);
  ASSERT_TRUE(QTest::qWaitFor([] { return key_parts->tablet().latest().touching; }, 20'000));
  for (int i = 1; i <= 40; ++i) {
    on_tablet(Qt::Key_Down);
    ASSERT_TRUE(arrives(0, 40e-3 - i * 2e-3)) << i;
  }
  press(Qt::Key_P);
  ASSERT_TRUE(QTest::qWaitFor(
      [] {
        const auto writing = key_parts->tablet().overlay().writing;
        return writing.size() == 1 && writing[0].verdict == view::Verdict::wrong;
      },
      20'000))
      << feedback().toStdString();
}

TEST_F(KeyWritingInTheWindow, WithoutItArrowKeysKeepTheirMeaning) {
  show(U'十');
  press(Qt::Key_F5);
  ASSERT_TRUE(key_parts->practice().watch().is_entered());
  press(Qt::Key_M);
  on_tablet(Qt::Key_Right);
  ASSERT_TRUE(arrives(2e-3, 0));
  press(Qt::Key_M);
  EXPECT_FALSE(key_parts->tablet().is_pressed());
  press(Qt::Key_Right);
  EXPECT_TRUE(says("Stroke")) << feedback().toStdString();
}

TEST(KeyPenWords, EachThingThatAKeyDoesHasASentenceOfItsOwn) {
  using practice::KeyPenDid;
  practice::KeyPenEvent event;
  event.place.stroke = 3;
  event.left = 7;
  const std::pair<KeyPenDid, const char*> table[] = {
      {KeyPenDid::moved, ""},
      {KeyPenDid::met_stroke, "Stroke 3."},
      {KeyPenDid::at_start, "Start of stroke 3."},
      {KeyPenDid::at_end, "End of stroke 3."},
      {KeyPenDid::left_stroke, "Beside stroke 7."},
      {KeyPenDid::at_border, "This is the edge."},
      {KeyPenDid::put_down, "Pen down."},
      {KeyPenDid::lifted, "Pen up."},
      {KeyPenDid::no_strokes, "There are no strokes to go to."},
  };
  for (const auto& [did, words] : table) {
    event.did = did;
    EXPECT_EQ(key_pen_words(event).toStdString(), words);
  }
}

TEST(KeyPenWords, APlaceIsSaidInPercentOfTheTablet) {
  practice::KeyPenPlace place;
  place.from_left = 0.304;
  place.from_top = 0.996;
  EXPECT_EQ(key_pen_words(place).toStdString(), "No stroke here: 30% from the left, 100% from the top.");
  place.stroke = 2;
  place.along = 0.25;
  EXPECT_EQ(key_pen_words(place).toStdString(),
            "Stroke 2, 25% of its length: 30% from the left, 100% from the top.");
}

}  // namespace
}  // namespace nazori::ui
