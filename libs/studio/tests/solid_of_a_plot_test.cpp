// SPDX-License-Identifier: Apache-2.0
// The dialog for a model to touch with a plot: what it offers for curves and for a surface, and what it
// keeps.
#include <QFormLayout>

#include "nazori/functions/plot_model.h"
#include "solid_under_test.h"

namespace nazori::ui {
namespace {

using test::sentence;

class SolidOfAPlot : public test::SolidDialogTest {
 protected:
  void open(const char* expression) {
    functions::PlotModel model;
    ASSERT_TRUE(model.read(expression, {}));
    auto request = model.request(functions::Language::english);
    request.plate.size = 128;
    functions::SharedDrawing drawing;
    ASSERT_TRUE(functions::draw_plot(request, [&drawing](functions::Drawing&& drawn) {
      drawing = std::make_shared<const functions::Drawing>(std::move(drawn));
      return true;
    }));
    SolidDialogTest::open({QString::fromUtf8(expression), {}, drawing});
  }
  /// Whether a row of the form is there.
  bool has(const char* name) {
    auto& field = part<QWidget>(name);
    return static_cast<QFormLayout*>(field.parentWidget()->layout())->isRowVisible(&field);
  }
};

TEST_F(SolidOfAPlot, OfCurvesHasNoStrokesAndIsAlsoPrintedOnPaper) {
  open("y = x/2");
  EXPECT_EQ(dialog_->windowTitle(), sentence("Make a model to touch: y = x/2"));
  EXPECT_FALSE(has("solid_kind"));
  for (const char* name : {"solid_numbers", "solid_dots", "solid_hole"})
    EXPECT_TRUE(part<QCheckBox>(name).isHidden()) << name;
  EXPECT_FALSE(part<QCheckBox>("solid_mould").isHidden());
  for (const char* name : {"solid_paper", "solid_columns", "solid_lines"}) EXPECT_TRUE(has(name)) << name;
  for (const char* name : {"solid_english", "solid_depth", "solid_layers"}) EXPECT_FALSE(has(name)) << name;
  EXPECT_EQ(part<QSpinBox>("solid_size").value(), static_cast<int>(model::RaisedPlotSettings().side_mm));
  wait_for_model();
  EXPECT_FALSE(part<ReliefView>("solid_picture").picture().isNull());
  const auto [kinds, name] = offered();
  EXPECT_EQ(kinds, (QStringList{sentence("3MF, with its size in millimetres (*.3mf)"),
                                sentence("STL (*.stl)"), sentence("PDF for swell paper (*.pdf)"),
                                sentence("BRF for a braille embosser (*.brf)"), sentence("brf")}));
  EXPECT_TRUE(name.startsWith(sentence("y = x-2"))) << name.toStdString();
  for (const char* made : {"a.brf", "a.pdf", "a.3mf"}) {
    dialog_->show();
    said_.clear();
    dialog_->save(file(made));
    EXPECT_FALSE(part<QPushButton>("solid_save").isEnabled());
    ASSERT_TRUE(QTest::qWaitFor([this] { return !said_.isEmpty(); }, 20'000));
    EXPECT_EQ(all_said(), sentence("Saved as %1.").arg(file(made)));
    EXPECT_EQ(kind_, Feedback::good);
  }
}

TEST_F(SolidOfAPlot, OfASurfaceIsOnlyASolid) {
  open("z = x*y");
  for (const char* name : {"solid_paper", "solid_columns", "solid_lines", "solid_english", "solid_depth"})
    EXPECT_FALSE(has(name)) << name;
  wait_for_model();
  EXPECT_EQ(offered().first, (QStringList{sentence("3MF, with its size in millimetres (*.3mf)"),
                                          sentence("STL (*.stl)"), sentence("stl")}));
}

TEST_F(SolidOfAPlot, KeepsASizeOfItsOwn) {
  open("y = x");
  part<QSpinBox>("solid_size").setValue(150);
  part<QCheckBox>("solid_mould").setChecked(true);
  dialog_->reject();
  practice::LabelledTablet one;
  one.tablet.strokes.resize(1);
  one.tablet.strokes[0].points = {{20, 54.5}, {89, 54.5}};
  SolidDialogTest::open({sentence("一"), {one}, {}});
  EXPECT_EQ(part<QSpinBox>("solid_size").value(), 100);
  EXPECT_TRUE(part<QCheckBox>("solid_mould").isChecked());
  EXPECT_TRUE(has("solid_kind"));
  wait_for_model();
  EXPECT_TRUE(words().contains(sentence(" × "))) << words().toStdString();
  open("y = x");
  EXPECT_EQ(part<QSpinBox>("solid_size").value(), 150);
  wait_for_model();
}

TEST_F(SolidOfAPlot, WhereThereIsNoModelTheReasonIsSaid) {
  SolidDialogTest::open({sentence("nothing"), {}, {}});
  ASSERT_TRUE(QTest::qWaitFor([this] { return words().startsWith(sentence("✗ ")); }, 20'000));
  EXPECT_TRUE(words().startsWith(sentence("✗ There is no model: "))) << words().toStdString();
  EXPECT_TRUE(part<ReliefView>("solid_picture").picture().isNull());
  EXPECT_FALSE(part<QPushButton>("solid_save").isEnabled());
}

TEST_F(SolidOfAPlot, IsMadeFromTheWindowAndGoesWithItsDialog) {
  practice::LabelledTablet one;
  one.tablet.strokes.resize(1);
  one.tablet.strokes[0].points = {{20, 54.5}, {89, 54.5}};
  ask_solid(parts_, {sentence("一"), {one}, {}});
  auto* dialog = window_.findChild<SolidDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->isVisible());
  EXPECT_TRUE(dialog->testAttribute(Qt::WA_DeleteOnClose));
}

}  // namespace
}  // namespace nazori::ui
