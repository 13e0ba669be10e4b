// SPDX-License-Identifier: Apache-2.0
// What is announced for a stroke in the wrong order, at once and with the numbers of the model.
#include "characters/characters.h"
#include "hand_under_test.h"
#include "nazori/widgets/page/window_parts.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

WindowParts* the_parts = nullptr;
Characters* the_characters = nullptr;

std::unique_ptr<Page> make_characters(WindowParts& parts) {
  the_parts = &parts;
  auto made = std::make_unique<Characters>(parts);
  the_characters = made.get();
  return made;
}

class Order : public WindowTest {
 protected:
  Order() { pages_ = {make_characters}; }

  /// Strokes of the model as if written by hand, without waiting.
  void add(char32_t character, std::initializer_list<int> numbers) {
    const auto lines = test::model(character);
    for (const int number : numbers) add(lines[static_cast<std::size_t>(number - 1)]);
  }
  void add(const test::Points& line) {
    practice::HandStroke made;
    for (double at = 0; at <= geometry::arc_length<geometry::GlyphFrame>(line); at += 1)
      made.push_back({geometry::glyph_to_tablet(geometry::point_at<geometry::GlyphFrame>(line, at), {}),
                      time_s_ += 0.01, 0.5});
    the_parts->practice().memory().add_stroke(made);
  }

  bool says(const char* words) {
    return QTest::qWaitFor([&] { return feedback() == QString::fromUtf8(words); }, 20000);
  }
  std::vector<view::Verdict> seen_verdicts() {
    std::vector<view::Verdict> out;
    for (const auto& stroke : the_parts->tablet().overlay().writing) out.push_back(stroke.verdict);
    return out;
  }

  double time_s_ = 1;
};

TEST_F(Order, FromMemoryTheStrokeToComeFirstIsNamedAtOnceAndIsRightThen) {
  show(U'年');
  press(Qt::Key_F8);
  add(U'年', {1, 2, 3, 4});
  ASSERT_TRUE(says("Stroke 4 is correct. 2 to go.")) << feedback().toStdString();
  add(U'年', {6});
  ASSERT_TRUE(says("Stroke 5 comes first.")) << feedback().toStdString();
  EXPECT_EQ(seen_verdicts().back(), view::Verdict::wrong);
  add(U'年', {5});
  ASSERT_TRUE(says("Stroke 5 is correct. Enter: finish.")) << feedback().toStdString();
  EXPECT_EQ(seen_verdicts().back(), view::Verdict::right);
  press(Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return feedback().contains(QStringLiteral("Stroke 5 comes before stroke 6.")); }, 20000))
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
  ASSERT_TRUE(says("Stroke 1 is correct. 1 to go.")) << feedback().toStdString();
  action("judge_each")->trigger();  // else the second stroke ends it
  add(second);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return feedback().contains(QStringLiteral("2 strokes written")); }, 20000));
  action("judge_each")->trigger();
  add(U'人', {2});
  EXPECT_TRUE(says("Your stroke 3 isn't part of this character.")) << feedback().toStdString();
}

TEST_F(Order, TracedTheStrokeToComeFirstStaysNamedWhenTheStrokeEnds) {
  for (const auto key : {Qt::Key_F6, Qt::Key_F7}) {
    show(U'十');
    press(key);
    QStringList said;
    const auto heard =
        QObject::connect(the_parts, &WindowParts::announced, [&said](Feedback kind, const QString& sentence) {
          if (!sentence.isEmpty())
            said.append(QStringLiteral("%1 %2").arg(static_cast<int>(kind)).arg(sentence));
        });
    const auto lines = test::model(U'十');
    test::write(the_parts->tablet(), lines[1]);
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
  test::write(the_parts->tablet(), most);
  EXPECT_EQ(feedback(),
            QStringLiteral("Stroke 1 is not finished: the blue bit is missing. Draw on from there."));
  ASSERT_EQ(seen_verdicts(), (std::vector{view::Verdict::shown}));
  const auto& bit = the_parts->tablet().overlay().writing.front().points;
  const auto end = geometry::glyph_to_tablet(lines[0].back(), {});
  EXPECT_NEAR(geometry::distance(bit.back().at, end), 0, 1e-4);
  EXPECT_NEAR(geometry::distance(bit.front().at, end), 0.013, 0.004);
  test::write(the_parts->tablet(), lines[1]);
  EXPECT_EQ(feedback(),
            QStringLiteral("Stroke 2 is written, but stroke 1 is not finished: the blue bit is missing."));
  test::Points rest;
  for (double at = length - 14; at <= length; at += 1)
    rest.push_back(geometry::point_at<geometry::GlyphFrame>(half, at));
  test::write(the_parts->tablet(), rest);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("All 2 strokes written"))) << feedback().toStdString();
  EXPECT_TRUE(seen_verdicts().empty());
}

}  // namespace
}  // namespace nazori::ui
