// SPDX-License-Identifier: Apache-2.0
// What is said of a stroke out of its turn, at once and by the numbers of the model.
#include "characters/characters.h"
#include "characters/memory_stage.h"
#include "desk.h"
#include "hand_under_test.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

Desk* the_desk = nullptr;
Characters* the_characters = nullptr;

std::unique_ptr<Workplace> make_characters(Desk& desk) {
  the_desk = &desk;
  auto made = std::make_unique<Characters>(desk);
  the_characters = made.get();
  return made;
}

class Order : public WindowTest {
 protected:
  Order() { workplaces_ = {make_characters}; }

  /// Strokes of the model as the hand wrote them, without waiting for a hand.
  void add(char32_t character, std::initializer_list<int> numbers) {
    const auto lines = test::model(character);
    for (const int number : numbers) add(lines[static_cast<std::size_t>(number - 1)]);
  }
  void add(const test::Points& line) {
    practice::HandStroke made;
    for (double at = 0; at <= geometry::arc_length<geometry::GlyphFrame>(line); at += 1)
      made.push_back({geometry::glyph_to_tablet(geometry::point_at<geometry::GlyphFrame>(line, at), {}),
                      time_s_ += 0.01, 0.5});
    the_characters->findChild<MemoryStage*>()->add_stroke(made);
  }

  bool says(const char* words) {
    return QTest::qWaitFor([&] { return feedback() == QString::fromUtf8(words); }, 20000);
  }
  std::vector<view::Verdict> seen_verdicts() {
    std::vector<view::Verdict> out;
    for (const auto& stroke : the_desk->tablet().overlay().writing) out.push_back(stroke.verdict);
    return out;
  }

  double time_s_ = 1;
};

TEST_F(Order, FromMemoryTheStrokeToComeFirstIsNamedAtOnceAndIsRightThen) {
  show(U'年');
  press(Qt::Key_F8);
  add(U'年', {1, 2, 3, 4});
  ASSERT_TRUE(says("Stroke 4 is right. 2 to go.")) << feedback().toStdString();
  add(U'年', {6});
  ASSERT_TRUE(says("Stroke 5 comes first.")) << feedback().toStdString();
  EXPECT_EQ(seen_verdicts().back(), view::Verdict::wrong);
  add(U'年', {5});
  ASSERT_TRUE(says("Stroke 5 is right. Enter is done.")) << feedback().toStdString();
  EXPECT_EQ(seen_verdicts().back(), view::Verdict::right);
  press(Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return feedback().contains(QStringLiteral("Stroke 6 was drawn before stroke 5.")); }, 20000))
      << feedback().toStdString();
}

TEST_F(Order, FromMemoryWhatWasPassedOverIsNamedUntilItIsThere) {
  show(U'休');
  press(Qt::Key_F8);
  add(U'休', {1, 2, 4});
  ASSERT_TRUE(says("Stroke 3 comes first.")) << feedback().toStdString();
  add(U'休', {5});
  EXPECT_TRUE(says("Stroke 5 is right. Stroke 3 is still missing.")) << feedback().toStdString();
}

TEST_F(Order, FromMemoryAStrokeTooManyIsNeverRight) {
  show(U'人');
  press(Qt::Key_F8);
  auto second = test::model(U'人')[1];
  for (auto& p : second) p = {p.x + 4, p.y - 3};
  add(U'人', {1});
  ASSERT_TRUE(says("Stroke 1 is right. 1 to go.")) << feedback().toStdString();
  action("judge_each")->trigger();  // else the second stroke ends it
  add(second);
  ASSERT_TRUE(QTest::qWaitFor([&] { return feedback().contains(QStringLiteral("2 strokes are")); }, 20000));
  action("judge_each")->trigger();
  add(U'人', {2});
  EXPECT_TRUE(says("The stroke you wrote as number 3 does not belong here.")) << feedback().toStdString();
}

TEST_F(Order, TracedTheStrokeToComeFirstStaysNamedWhenTheStrokeEnds) {
  for (const auto key : {Qt::Key_F6, Qt::Key_F7}) {
    show(U'十');
    press(key);
    QStringList said;
    const auto heard =
        QObject::connect(the_desk, &Desk::said, [&said](Feedback kind, const QString& sentence) {
          if (!sentence.isEmpty())
            said.append(QStringLiteral("%1 %2").arg(static_cast<int>(kind)).arg(sentence));
        });
    const auto lines = test::model(U'十');
    test::write(the_desk->tablet(), lines[1]);
    EXPECT_EQ(feedback(), QStringLiteral("Stroke 2 is written, but stroke 1 comes first. Write it now."));
    const QString advice = QStringLiteral("%1 ").arg(static_cast<int>(Feedback::advice));
    EXPECT_EQ(said, (QStringList{advice + QStringLiteral("Stroke 1 comes before stroke 2."),
                                 advice + QStringLiteral("Stroke 2 is written, but stroke 1 comes first. "
                                                         "Write it now.")}));
    QObject::disconnect(heard);
  }
}

TEST_F(Order, ATracedStrokeThatIsLeftBeforeItsEndIsNotPraisedAndItsBitIsShown) {
  show(U'十');
  press(Qt::Key_F6);
  const auto lines = test::model(U'十');
  auto half = lines[0];
  const double length = geometry::arc_length<geometry::GlyphFrame>(half);
  test::Points most;
  for (double at = 0; at <= length - 14; at += 1)
    most.push_back(geometry::point_at<geometry::GlyphFrame>(half, at));
  test::write(the_desk->tablet(), most);
  EXPECT_EQ(feedback(),
            QStringLiteral("Stroke 1 is not finished: the blue bit is missing. Draw on from there."));
  ASSERT_EQ(seen_verdicts(), (std::vector{view::Verdict::shown}));
  const auto& bit = the_desk->tablet().overlay().writing.front().points;
  const auto end = geometry::glyph_to_tablet(lines[0].back(), {});
  EXPECT_NEAR(geometry::distance(bit.back().at, end), 0, 1e-4);
  EXPECT_NEAR(geometry::distance(bit.front().at, end), 0.013, 0.004);
  test::write(the_desk->tablet(), lines[1]);
  EXPECT_EQ(feedback(),
            QStringLiteral("Stroke 2 is written, but stroke 1 is not finished: the blue bit is missing."));
  test::Points rest;
  for (double at = length - 14; at <= length; at += 1)
    rest.push_back(geometry::point_at<geometry::GlyphFrame>(half, at));
  test::write(the_desk->tablet(), rest);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("All 2 strokes are written"))) << feedback().toStdString();
  EXPECT_TRUE(seen_verdicts().empty());
}

}  // namespace
}  // namespace nazori::ui
