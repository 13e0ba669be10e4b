// SPDX-License-Identifier: Apache-2.0
// The model on the page for the brush: its characters, its place, its font, and the brush that follows it.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

#include "brush_page_under_test.h"

namespace nazori::ui {
namespace {

using test::sentence;

class ModelForTheBrush : public test::BrushPageTest {
 protected:
  [[nodiscard]] QString model_words() const { return find<QLabel>("model_words").text(); }
  /// The right and the left edge of the model [m].
  [[nodiscard]] std::pair<double, double> sides() const {
    double left = 1, right = -1;
    for (const auto& stroke : paper().model())
      for (const auto p : stroke.points) {
        left = std::min(left, p.x);
        right = std::max(right, p.x);
      }
    return {left, right};
  }
  [[nodiscard]] QComboBox& fonts() const { return find<QComboBox>("brush_font_box"); }
  void wait_for_fonts() {
    wait_until([this] { return !page_->awaits_models(); });
  }
  const QString kFont = sentence("KouzanBrushFont");
};

TEST_F(ModelForTheBrush, IsTheCharacterThatIsShownUnlessATextIsTyped) {
  wait_until([this] { return paper().model().size() == 6; });
  EXPECT_EQ(model_words(), sentence("Model beneath: 休."));
  take_model(" 十 ", 2);
  EXPECT_EQ(model_words(), sentence("Model beneath: 十."));
  const int before = saves_;
  emit panel().text_typed(sentence("  "));
  EXPECT_EQ(saves_, before + 1);
  EXPECT_EQ(model_words(), sentence("Model beneath: 休."));
  EXPECT_EQ(paper().model().size(), 6U);
  const int focused = focused_;
  said_.clear();
  emit panel().text_entered();
  EXPECT_EQ(focused_, focused + 1);
  EXPECT_EQ(all_said(), sentence("Model beneath: 休."));
}

TEST_F(ModelForTheBrush, StandsWhereItIsChosen) {
  const auto& box = find<QComboBox>("brush_model_box");
  const std::tuple<QAction*, const char*, ModelPlace> all[] = {
      {actions().model_beside, "Model beside: 休.", ModelPlace::beside},
      {actions().model_none, "No model.", ModelPlace::none},
      {actions().model_beneath, "Model beneath: 休.", ModelPlace::beneath}};
  for (const auto& [action, words, place] : all) {
    const int before = saves_;
    EXPECT_EQ(by(action), sentence(words));
    EXPECT_EQ(saves_, before + 1);
    EXPECT_EQ(box.currentData().toInt(), static_cast<int>(place));
    EXPECT_EQ(model_words(), sentence(words));
    EXPECT_TRUE(paper().accessibleDescription().contains(sentence(words)));
  }
  emit panel().place_chosen(ModelPlace::none);
  EXPECT_TRUE(actions().model_none->isChecked());
  EXPECT_FALSE(actions().model_beneath->isChecked());
}

TEST_F(ModelForTheBrush, ALongTextIsShownInPartsThatFollowEachOtherInARing) {
  take_model("一十三", 1);
  EXPECT_EQ(model_words(), sentence("Model beneath: 一. Part 1 of 3."));
  EXPECT_EQ(by(actions().next_model), sentence("Model beneath: 十. Part 2 of 3."));
  wait_until([this] { return paper().model().size() == 2; });
  EXPECT_EQ(by(actions().next_model), sentence("Model beneath: 三. Part 3 of 3."));
  EXPECT_EQ(by(actions().next_model), sentence("Model beneath: 一. Part 1 of 3."));
  EXPECT_EQ(by(actions().previous_model), sentence("Model beneath: 三. Part 3 of 3."));
  EXPECT_EQ(by(actions().previous_model), sentence("Model beneath: 十. Part 2 of 3."));
  EXPECT_EQ(kind_, Feedback::hint);
  emit panel().text_typed(sentence("三一"));
  EXPECT_EQ(model_words(), sentence("Model beneath: 三. Part 1 of 2."))
      << "another text begins with its start";
  actions().next_model->trigger();
  emit panel().ruling_chosen(1);
  EXPECT_EQ(model_words(), sentence("Model beneath: 三. Part 1 of 2.")) << "a ruling, too";
  emit panel().ruling_chosen(2);
  EXPECT_EQ(model_words(), sentence("Model beneath: 三一."));
  for (auto* action : {actions().next_model, actions().previous_model})
    EXPECT_EQ(by(action), sentence("The whole model text is on this sheet."));
  emit panel().ruling_chosen(0);
  EXPECT_EQ(model_words(), sentence("Model beneath: 三. Part 1 of 2.")) << "without squares as with one";
  EXPECT_EQ(by(actions().next_model), sentence("Model beneath: 一. Part 2 of 2."));
}

TEST_F(ModelForTheBrush, ARulingHasItsBrushAndAsManyModels) {
  take_model("一", 1);
  const auto [left, right] = sides();
  EXPECT_NEAR((left + right) / 2, 0, 0.003) << "in the middle of the sheet";
  const std::tuple<const char*, const char*, int> all[] = {{"Small", "2 characters", 2},
                                                           {"Small", "4 characters", 4},
                                                           {"Fine", "6 characters", 6},
                                                           {"Medium", "No ruling", 0},
                                                           {"Medium", "1 characters", 1}};
  for (const auto& [size, name, count] : all) {
    const int before = saves_;
    EXPECT_EQ(by(actions().next_ruling),
              sentence("Brush: %1, Mixed.|%2").arg(sentence(size), sentence(name)));
    EXPECT_EQ(saves_, before + 1);
    EXPECT_EQ(find<QComboBox>("brush_ruling_box").currentData().toInt(), count);
    EXPECT_EQ(paper().model().size(), static_cast<std::size_t>(std::max(count, 1)));
  }
  emit panel().size_chosen(calligraphy::BrushSize::large);
  said_.clear();
  emit panel().ruling_chosen(1);
  settle();
  EXPECT_EQ(all_said(), QString()) << "the same one";
  EXPECT_EQ(state().brush.size, calligraphy::BrushSize::large) << "leaves the brush";
}

TEST_F(ModelForTheBrush, EveryCharacterThatIsNotKnownYetIsAskedForAndStandsInItsSquare) {
  emit panel().ruling_chosen(4);
  take_model("一十三一", 1 + 2 + 3 + 1);
  // The right column first: 一 and 十, then 三 and 一.
  const auto& model = paper().model();
  const auto middle = [&model](std::size_t stroke) {
    return (model[stroke].points.front() + model[stroke].points.back()) * 0.5;
  };
  EXPECT_NEAR(middle(0).x, 0.0235, 0.002);
  EXPECT_NEAR(middle(0).y, 0.0235, 0.004);
  EXPECT_NEAR(middle(6).x, -0.0235, 0.002);
  EXPECT_NEAR(middle(6).y, -0.0235, 0.004);
  // What the database does not have leaves its square empty.
  take_model("☃十", 2 + 2);
  EXPECT_EQ(model_words(), sentence("Model beneath: ☃十☃十."));
}

TEST_F(ModelForTheBrush, KeysGoToItsStrokesOnlyWhileItIsShown) {
  take_model("十", 2);
  EXPECT_EQ(by(actions().by_key),
            sentence("The keys move the pen. Arrow keys: move. U: pen down or up. N: next "
                     "start. K: where."));
  EXPECT_EQ(by(actions().next_start), sentence("Start of stroke 1."));
  EXPECT_EQ(by(actions().next_start), sentence("Start of stroke 2."));
  const auto start = paper().model()[1].points.front();
  EXPECT_EQ(by(actions().where), sentence("Stroke 2, 0% of its length: %1% from the left, %2% from the top.")
                                     .arg(std::lround(100 * (0.5 + start.x / 0.1024)))
                                     .arg(std::lround(100 * (0.5 - start.y / 0.1024))));
  actions().model_none->trigger();
  EXPECT_EQ(by(actions().next_start), sentence("There are no strokes to go to."));
  EXPECT_EQ(by(actions().by_key), sentence("The keys no longer move the pen."));
}

TEST_F(ModelForTheBrush, KeysPressTheBrushInTenths) {
  EXPECT_FALSE(actions().harder->isEnabled());
  EXPECT_FALSE(actions().softer->isEnabled());
  actions().by_key->trigger();
  EXPECT_TRUE(actions().harder->isEnabled());
  EXPECT_TRUE(actions().softer->isEnabled());
  for (const int percent : {60, 70, 80, 90, 100})
    EXPECT_EQ(by(actions().harder), sentence("Pressure: %1%.").arg(percent));
  EXPECT_EQ(by(actions().harder), sentence("The brush cannot be pressed harder."));
  for (const int percent : {90, 80, 70, 60, 50, 40, 30, 20, 10})
    EXPECT_EQ(by(actions().softer), sentence("Pressure: %1%.").arg(percent));
  EXPECT_EQ(by(actions().softer), sentence("The brush cannot be pressed more softly."));
  EXPECT_EQ(kind_, Feedback::hint);
  std::vector<brush::PenSample> samples;
  QObject::connect(&paper(), &PaperView::pen_moved, &window_,
                   [&](const brush::PenSample& sample) { samples.push_back(sample); });
  EXPECT_EQ(by(actions().press), sentence("Pen down."));
  by(actions().harder);
  EXPECT_EQ(by(actions().press), sentence("Pen up."));
  ASSERT_EQ(samples.size(), 3U);
  EXPECT_NEAR(samples[0].pressure.value_or(0), 0.1, 1e-9);
  EXPECT_NEAR(samples[1].pressure.value_or(0), 0.2, 1e-9);
  EXPECT_NEAR(samples[0].at.x, 0, 1e-6);
  EXPECT_FALSE(samples[2].down);
  actions().by_key->trigger();
  EXPECT_FALSE(actions().harder->isEnabled());
}

TEST_F(ModelForTheBrush, HasTheLinesOfTheFontThatIsChosenAndPrintedOnesAfterTheLast) {
  wait_for_fonts();
  take_model("三", 3);
  ASSERT_GT(fonts().count(), 2) << "the brush fonts are not installed";
  EXPECT_EQ(fonts().itemText(0), sentence("Printed lines"));
  const auto points = [this] { return paper().model()[0].points.size(); };
  const std::size_t printed = points();
  const int count = fonts().count();
  for (int i = 1; i <= count; ++i) {
    const int before = saves_;
    const QString name = i < count ? fonts().itemText(i) : sentence("Printed lines");
    EXPECT_EQ(by(actions().next_font), sentence("Model: %1.").arg(name));
    EXPECT_EQ(saves_, before + 1);
    wait_for_fonts();
    EXPECT_EQ(fonts().currentIndex(), i % count);
    const QString font = i < count ? sentence(" Font: %1.").arg(name) : QString();
    EXPECT_EQ(model_words(), sentence("Model beneath: 三.") + font);
  }
  EXPECT_EQ(points(), printed);
  emit panel().font_chosen(kFont);
  wait_for_fonts();
  ASSERT_EQ(paper().model().size(), 3U);
  EXPECT_NE(points(), printed);
  EXPECT_EQ(fonts().currentData().toString(), kFont);
}

TEST_F(ModelForTheBrush, ACharacterThatItsFontLacksKeepsPrintedLinesAndThisIsSaid) {
  wait_for_fonts();
  emit panel().ruling_chosen(2);
  take_model("剝一", 10 + 1);
  said_.clear();
  emit panel().font_chosen(kFont);
  wait_for_fonts();
  EXPECT_EQ(said_.back(),
            sentence("剝 has printed lines: KouzanBrushFont does not have it with the same strokes."));
  EXPECT_EQ(kind_, Feedback::advice);
  EXPECT_EQ(paper().model().size(), 11U);
  said_.clear();
  emit panel().text_typed(sentence("剝二"));
  wait_until([this] { return paper().model().size() == 12; });
  wait_for_fonts();
  EXPECT_EQ(all_said(), QString()) << "said once";
}

TEST_F(ModelForTheBrush, PrintedLinesAreNotShownBeforeTheFontThatIsKept) {
  emit panel().text_typed(sentence("三"));
  emit panel().font_chosen(kFont);
  wait_for_fonts();
  keep_settings(*page_);
  page_.reset();
  std::size_t shown = 0;
  page_ = std::make_unique<BrushPage>(parts_, kCells);
  page_->enter();
  parts_.library().request_characters({U'三'});
  wait_until([&] {
    const bool knows_fonts = fonts().count() > 1;
    if (!knows_fonts) shown = std::max(shown, paper().model().size());
    return !page_->awaits_models() && paper().model().size() == 3;
  });
  EXPECT_EQ(shown, 0U);
  EXPECT_EQ(fonts().currentData().toString(), kFont);
}

}  // namespace
}  // namespace nazori::ui
