// SPDX-License-Identifier: Apache-2.0
// No key is silence: what nothing else is said about is spoken by name.
#include "window/spoken_actions.h"

#include <QSignalSpy>

#include "characters/characters.h"
#include "nazori/widgets/controls/spoken_line.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

class SpokenKeys : public WindowTest {
 protected:
  SpokenKeys() {
    pages_ = {
        [](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<Characters>(parts); }};
  }
  bool hears(Qt::Key key, Qt::KeyboardModifiers modifiers, const QString& awaited) {
    return spoken_after(key, modifiers, awaited).contains(awaited);
  }
  /// Presses a key and waits until this is spoken. @return all that was spoken meanwhile.
  QString spoken_after(Qt::Key key, Qt::KeyboardModifiers modifiers, const QString& awaited) {
    QSignalSpy spoken(find<SpokenLine>("spoken_line"), &SpokenLine::spoken);
    press(key, modifiers);
    QString all;
    (void)QTest::qWaitFor(
        [&] {
          all.clear();
          for (const auto& one : spoken) all += one.front().toString() + QLatin1Char('|');
          return all.contains(awaited);
        },
        20'000);
    return all;
  }
};

TEST_F(SpokenKeys, WhatIsSwitchedIsSpokenWithItsState) {
  show(U'十');
  EXPECT_TRUE(hears(Qt::Key_N, {}, QStringLiteral("Numbers: off")));
  EXPECT_TRUE(hears(Qt::Key_N, {}, QStringLiteral("Numbers: on")));
}

TEST_F(SpokenKeys, OneOfSeveralAndWhatIsDoneOnceAreSpokenByName) {
  show(U'十');
  EXPECT_TRUE(hears(Qt::Key_2, Qt::ControlModifier, QStringLiteral("Slate")));
  EXPECT_TRUE(hears(Qt::Key_Left, Qt::ControlModifier, QStringLiteral("Turn left")));
}

TEST_F(SpokenKeys, WhatHasASentenceOfItsOwnIsNotNamedToo) {
  show(U'十');
  const QString heard = spoken_after(Qt::Key_F, {}, QStringLiteral("Snapping"));
  EXPECT_TRUE(heard.contains(QStringLiteral("Snapping"))) << heard.toStdString();
  EXPECT_FALSE(heard.contains(QStringLiteral("Snap:"))) << heard.toStdString();
}

TEST_F(SpokenKeys, WhatIsChosenWithoutItsKeyWasReadInItsMenu) {
  show(U'十');
  QSignalSpy spoken(find<SpokenLine>("spoken_line"), &SpokenLine::spoken);
  action("numbers")->trigger();
  EXPECT_TRUE(hears(Qt::Key_A, {}, QStringLiteral("Arrows: off")));
  for (const auto& one : spoken) EXPECT_FALSE(one.front().toString().contains(QStringLiteral("Numbers")));
}

TEST_F(SpokenKeys, APanelThatIsFoldedAwayGivesTheKeyboardToTheTablet) {
  show(U'十');
  press(Qt::Key_F, Qt::ControlModifier);
  ASSERT_TRUE(find("library_panel")->isAncestorOf(window_->focusWidget()));
  press(Qt::Key_F2);
  EXPECT_FALSE(find("library_panel")->isVisible());
  EXPECT_EQ(window_->focusWidget(), find("tablet"));
}

TEST_F(SpokenKeys, APanelThatIsFoldedAwayWithoutTheKeyboardDoesNotMoveIt) {
  show(U'十');
  press(Qt::Key_F, Qt::ControlModifier);
  auto* before = window_->focusWidget();
  press(Qt::Key_F3);
  EXPECT_EQ(window_->focusWidget(), before);
}

TEST(SpokenName, SaysTheStateOnlyOfWhatHasOne) {
  QAction action(QStringLiteral("Numbers"));
  EXPECT_EQ(spoken_name(action), QStringLiteral("Numbers"));
  action.setCheckable(true);
  EXPECT_EQ(spoken_name(action), QStringLiteral("Numbers: off"));
  action.setChecked(true);
  EXPECT_EQ(spoken_name(action), QStringLiteral("Numbers: on"));
}

}  // namespace
}  // namespace nazori::ui
