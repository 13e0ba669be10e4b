// SPDX-License-Identifier: Apache-2.0
// Which actions of a session are enabled in each state, and which keys they have.
#include <QWidget>

#include "characters/character_actions.h"
#include "session_under_test.h"
#include "study/session_actions.h"

namespace nazori::ui {
namespace {

QStringList keys(const QAction* action) {
  QStringList all;
  for (const auto& key : action->shortcuts()) all.append(key.toString(QKeySequence::PortableText));
  return all;
}
QStringList list(std::initializer_list<const char*> all) {
  QStringList made;
  for (const char* one : all) made.append(QString::fromLatin1(one));
  return made;
}

class SessionActionsTest : public SessionTest {
 protected:
  void show(bool can_write = true) { actions_.show_state(*session_, can_write); }
  QString enabled() const {
    QString all;
    for (const auto& [action, sign] :
         {std::pair(actions_.start, 's'), std::pair(actions_.go_on, 'g'), std::pair(actions_.rate[0], '1'),
          std::pair(actions_.rate[1], '2'), std::pair(actions_.rate[2], '3'),
          std::pair(actions_.rate[3], '4'), std::pair(actions_.undo, 'u'), std::pair(actions_.postpone, 'p'),
          std::pair(actions_.pause, 'a'), std::pair(actions_.reset, 'r'), std::pair(actions_.tags, 't'),
          std::pair(actions_.end, 'e')})
      if (action->isEnabled()) all += QLatin1Char(sign);
    return all;
  }
  QWidget window_;
  SessionActions actions_{&window_};
  CharacterActions characters_{&window_};
};

TEST_F(SessionActionsTest, EachMeansSomethingAtItsTime) {
  EXPECT_FALSE(actions_.go_on->isEnabled());
  show();
  EXPECT_EQ(enabled(), QStringLiteral("supart"));
  show(false);
  EXPECT_EQ(enabled(), QString());
  ASSERT_TRUE(session_->start());
  bring(session_->character());
  show();
  EXPECT_EQ(enabled(), QStringLiteral("uparte"));
  show(false);
  EXPECT_EQ(enabled(), QStringLiteral("e"));
  session_->finish_stage(study::Stage::watch, {});
  show();
  EXPECT_EQ(enabled(), QStringLiteral("guparte")) << "offered";
  session_->go_on();
  bring(U'雨');
  show();
  EXPECT_EQ(enabled(), QStringLiteral("guparte")) << "away";
  bring(session_->character());
  session_->finish_stage(study::Stage::trace, {});
  session_->go_on();
  session_->finish_stage(study::Stage::guided, {});
  session_->go_on();
  write(true);
  show();
  EXPECT_EQ(enabled(), QStringLiteral("g1234uparte")) << "judged";
  bring(U'雨');
  show();
  EXPECT_EQ(enabled(), QStringLiteral("guparte")) << "judged, but another is shown";
}

TEST_F(SessionActionsTest, OneHandReachesEveryKeyAndLosesNoneOfTheUsual) {
  const struct {
    QAction* action;
    QStringList usual;
    const char* left;
    const char* right;
  } all[] = {{actions_.rate[0], list({"1"}), nullptr, "7"},
             {actions_.rate[1], list({"2"}), nullptr, "8"},
             {actions_.rate[2], list({"3"}), nullptr, "9"},
             {actions_.rate[3], list({"4"}), nullptr, "0"},
             {characters_.done, list({"Return", "Enter"}), "E", "K"},
             {characters_.hint, list({"H"}), "W", "U"},
             {characters_.undo_stroke, list({"Ctrl+Z", "Backspace"}), "X", nullptr},
             {actions_.undo, list({"Ctrl+Shift+Z"}), "Shift+X", "Shift+Backspace"}};
  const auto choose = [&](OneHand hand) {
    actions_.set_one_hand(hand, characters_.hint, characters_.undo_stroke, characters_.done);
  };
  for (const auto& one : all) EXPECT_EQ(keys(one.action), one.usual);
  for (const OneHand hand : {OneHand::left, OneHand::right, OneHand::none, OneHand::right, OneHand::left}) {
    choose(hand);
    for (const auto& one : all) {
      QStringList expected = one.usual;
      const char* more = hand == OneHand::left ? one.left : one.right;
      if (hand != OneHand::none && more != nullptr) expected.append(QString::fromLatin1(more));
      EXPECT_EQ(keys(one.action), expected) << one.action->objectName().toStdString();
    }
  }
}

TEST_F(SessionActionsTest, TheKeysOfDoneGoOnWhereNothingWaitsToBeJudged) {
  EXPECT_EQ(keys(actions_.go_on), list({"Shift+Return"}));
  actions_.set_has_unjudged(true);  // before it knows of them
  actions_.set_has_unjudged(false);
  actions_.set_one_hand(OneHand::left, characters_.hint, characters_.undo_stroke, characters_.done);
  const QStringList done = list({"Return", "Enter", "E"});
  const QStringList both = list({"Shift+Return", "Return", "Enter", "E"});
  EXPECT_EQ(keys(characters_.done), done);
  EXPECT_EQ(keys(actions_.go_on), list({"Shift+Return"}));
  ASSERT_TRUE(session_->start());
  bring(session_->character());
  session_->finish_stage(study::Stage::watch, {});
  show();
  EXPECT_EQ(keys(actions_.go_on), both);
  EXPECT_EQ(keys(characters_.done), QStringList());
  actions_.set_has_unjudged(true);
  EXPECT_EQ(keys(actions_.go_on), list({"Shift+Return"}));
  EXPECT_EQ(keys(characters_.done), done);
  actions_.set_has_unjudged(false);
  EXPECT_EQ(keys(actions_.go_on), both);
  session_->go_on();
  show();
  EXPECT_EQ(keys(characters_.done), done);
}

}  // namespace
}  // namespace nazori::ui
