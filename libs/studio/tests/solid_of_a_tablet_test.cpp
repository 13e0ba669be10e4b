// SPDX-License-Identifier: Apache-2.0
// The dialog for a model to touch by itself, with one tablet.
#include <QBoxLayout>
#include <QFontInfo>
#include <QFormLayout>
#include <QScrollArea>
#include <QScrollBar>

#include "solid_under_test.h"
#include "two_sides.h"

namespace nazori::ui {
namespace {

class SolidOfATablet : public test::SolidDialogTest {
 protected:
  void open(const char* name = "一") {
    practice::LabelledTablet one;
    one.tablet.strokes.resize(1);
    one.tablet.strokes[0].points = {{20, 54.5}, {89, 54.5}};
    SolidDialogTest::open({QString::fromUtf8(name), {one}, {}});
  }
};

TEST_F(SolidOfATablet, BeginsAsModelsAreUsuallyMadeWithRoomAroundItsOptions) {
  open();
  EXPECT_EQ(dialog_->windowTitle(), QStringLiteral("Make a model to touch: 一"));
  EXPECT_EQ(words(), QStringLiteral("Making the model…"));
  EXPECT_FALSE(part<QPushButton>("solid_save").isEnabled());
  EXPECT_TRUE(part<QPushButton>("solid_save").isDefault());
  EXPECT_EQ(part<QComboBox>("solid_kind").currentIndex(), 0);
  EXPECT_EQ(part<QComboBox>("solid_kind").itemText(1), QStringLiteral("Grooves, for a stylus"));
  EXPECT_EQ(part<QComboBox>("solid_kind").minimumContentsLength(), 12);
  const auto& size = part<QSpinBox>("solid_size");
  EXPECT_EQ(size.value(), 100);
  EXPECT_EQ(size.minimum(), 10);
  EXPECT_EQ(size.maximum(), 500);
  EXPECT_EQ(size.suffix(), QStringLiteral(" mm"));
  for (const char* name : {"solid_numbers", "solid_dots", "solid_hole"})
    EXPECT_TRUE(part<QCheckBox>(name).isChecked()) << name;
  EXPECT_FALSE(part<QCheckBox>("solid_mould").isChecked());
  const auto& area = *dialog_->findChild<QScrollArea*>();
  EXPECT_EQ(area.frameShape(), QFrame::NoFrame);
  const auto& form = *static_cast<QFormLayout*>(area.widget()->layout());
  EXPECT_EQ(form.contentsMargins(), QMargins(0, 0, 8, 0));
  EXPECT_EQ(form.spacing(), 10);
  EXPECT_EQ(dialog_->layout()->contentsMargins(), QMargins(16, 16, 16, 12));
  const int em = QFontInfo(dialog_->font()).pixelSize();
  EXPECT_EQ(dialog_->size(), QSize(em * 54, em * 34).boundedTo(QSize(1140, 855)));
}

TEST_F(SolidOfATablet, ThePictureStandsBesideTheOptionsWhereThereIsRoom) {
  open();
  dialog_->show();
  test::expect_preview_beside_options(*dialog_);
}

TEST_F(SolidOfATablet, ShowsOnlyWhatChangesTheModelAndTellsItsFigures) {
  open();
  wait_for_model();
  // The square, a margin of 6 mm around it, and a strip with the hole.
  EXPECT_TRUE(words().startsWith(QStringLiteral("112 × "))) << words().toStdString();
  EXPECT_TRUE(words().endsWith(QStringLiteral(" · watertight")));
  EXPECT_FALSE(part<ReliefView>("solid_picture").picture().isNull());
  const auto hidden = [this](const char* name) { return part<QCheckBox>(name).isHidden(); };
  EXPECT_FALSE(hidden("solid_numbers") || hidden("solid_dots") || hidden("solid_hole"));
  part<QComboBox>("solid_kind").setCurrentIndex(1);
  EXPECT_FALSE(part<QPushButton>("solid_save").isEnabled()) << "the model is another one";
  EXPECT_TRUE(hidden("solid_numbers") && hidden("solid_dots"));
  EXPECT_FALSE(hidden("solid_hole"));
  part<QCheckBox>("solid_hole").setChecked(false);
  part<QSpinBox>("solid_size").setValue(60);
  wait_for_model();
  EXPECT_TRUE(words().startsWith(QStringLiteral("72 × 72 × 6.0 mm · "))) << words().toStdString();
  part<QCheckBox>("solid_mould").setChecked(true);
  EXPECT_TRUE(hidden("solid_hole"));
  wait_for_model();
  EXPECT_FALSE(words().contains(QStringLiteral(" × 6.0 mm"))) << words().toStdString();
}

TEST_F(SolidOfATablet, FilesForMachinesAreOfferedAsTheLinesAre) {
  open("a/b:c");
  wait_for_model();
  auto [kinds, name] = offered();
  EXPECT_EQ(kinds,
            (QStringList{QStringLiteral("3MF, with its size in millimetres (*.3mf)"),
                         QStringLiteral("STL (*.stl)"), QStringLiteral("PDF for swell paper (*.pdf)"),
                         QStringLiteral("BRF for a braille embosser (*.brf)"), QStringLiteral("brf")}));
  EXPECT_TRUE(name.startsWith(QStringLiteral("a-b-c"))) << name.toStdString();
  part<QComboBox>("solid_kind").setCurrentIndex(1);
  wait_for_model();
  EXPECT_EQ(offered().first.mid(2),
            (QStringList{QStringLiteral("G-code for a mill (*.nc)"),
                         QStringLiteral("SVG for a laser cutter (*.svg)"), QStringLiteral("svg")}));
}

TEST_F(SolidOfATablet, IsSavedWithTheChoiceForTheNextOne) {
  open();
  dialog_->save(file("early.stl"));
  EXPECT_FALSE(QFileInfo::exists(file("early.stl"))) << "there is no model yet";
  part<QComboBox>("solid_kind").setCurrentIndex(1);
  part<QSpinBox>("solid_size").setValue(60);
  for (const char* name : {"solid_numbers", "solid_hole"}) part<QCheckBox>(name).setChecked(false);
  wait_for_model();
  const int before = focused_;
  dialog_->save(file("none/a.stl"));
  ASSERT_TRUE(QTest::qWaitFor([this] { return words().startsWith(QStringLiteral("✗ ")); }, 20'000));
  EXPECT_TRUE(words().startsWith(QStringLiteral("✗ a.stl: "))) << words().toStdString();
  EXPECT_TRUE(words().endsWith(QStringLiteral(". Nothing was saved.")));
  EXPECT_TRUE(part<QPushButton>("solid_save").isEnabled());
  EXPECT_EQ(focused_, before);
  for (const char* name : {"a.stl", "a.nc"}) {
    said_.clear();
    dialog_->show();
    dialog_->save(file(name));
    ASSERT_TRUE(QTest::qWaitFor([this] { return !said_.isEmpty(); }, 20'000));
    EXPECT_EQ(said_, QStringList{QStringLiteral("Saved as %1.").arg(file(name))});
    EXPECT_TRUE(QFileInfo::exists(file(name)));
    EXPECT_EQ(dialog_->result(), QDialog::Accepted);
  }
  EXPECT_EQ(focused_, before + 2);
  open();
  EXPECT_EQ(part<QComboBox>("solid_kind").currentIndex(), 1);
  EXPECT_EQ(part<QSpinBox>("solid_size").value(), 60);
  EXPECT_FALSE(part<QCheckBox>("solid_numbers").isChecked());
  EXPECT_TRUE(part<QCheckBox>("solid_dots").isChecked());
  EXPECT_FALSE(part<QCheckBox>("solid_hole").isChecked());
  EXPECT_FALSE(part<QCheckBox>("solid_mould").isChecked());
  wait_for_model();
}

}  // namespace
}  // namespace nazori::ui
