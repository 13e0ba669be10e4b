// SPDX-License-Identifier: Apache-2.0
// Models to touch from the window: of a character, of a tablet of one's own, of a plot.
#include "nazori/studio/print/solid_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QPushButton>
#include <QSpinBox>
#include <QtEndian>
#include <cstring>

#include "functions_window.h"
#include "nazori/studio/print/relief_view.h"

namespace nazori::ui {
namespace {

/// What a binary STL holds.
struct Stl {
  quint32 triangles = 0;
  float width = 0;
  float thickness = 0;
};

Stl stl_of(const QString& path) {
  QFile file(path);
  Stl stl;
  if (!file.open(QIODevice::ReadOnly)) return stl;
  const QByteArray bytes = file.readAll();
  if (bytes.size() < 84) return stl;
  stl.triangles = qFromLittleEndian<quint32>(bytes.constData() + 80);
  EXPECT_EQ(bytes.size(), 84 + 50LL * stl.triangles);
  for (qsizetype t = 0; t < stl.triangles; ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      std::array<float, 3> p{};
      std::memcpy(p.data(), bytes.constData() + 84 + 50 * t + 12 + 12 * corner, sizeof p);
      stl.width = std::max(stl.width, p[0]);
      stl.thickness = std::max(stl.thickness, p[2]);
    }
  }
  return stl;
}

template <class Base>
class SolidDialogIn : public Base {
 protected:
  void open_dialog() {
    this->window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(this->window_.get()));
    this->press(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    dialog_ = this->template find<SolidDialog>("solid_dialog");
    ASSERT_NE(dialog_, nullptr) << this->feedback().toStdString();
    ASSERT_TRUE(wait_for_model());
  }
  template <class T>
  T* part(const char* name) {
    return dialog_->template findChild<T*>(QString::fromLatin1(name));
  }
  QString words() { return part<QLabel>("solid_words")->text(); }
  bool wait_for_model() {
    return QTest::qWaitFor([this] { return part<QPushButton>("solid_save")->isEnabled(); }, 20000);
  }
  void change(const std::function<void()>& what) {
    what();
    EXPECT_FALSE(part<QPushButton>("solid_save")->isEnabled());
    EXPECT_TRUE(wait_for_model()) << words().toStdString();
  }
  bool wait_for_end() {
    return QTest::qWaitFor([this] { return this->template find<SolidDialog>("solid_dialog") == nullptr; },
                           20000);
  }

  SolidDialog* dialog_ = nullptr;
};

using SolidDialogTest = SolidDialogIn<WindowTest>;
using SolidOfPlotTest = SolidDialogIn<test::FunctionsWindow>;

TEST_F(SolidDialogTest, TellsTheFiguresOfTheModelThatIsSaved) {
  open_dialog();
  EXPECT_EQ(dialog_->windowTitle(), QStringLiteral("Make a model to touch: 休"));
  change([this] { part<QSpinBox>("solid_size")->setValue(60); });
  EXPECT_TRUE(words().startsWith(QStringLiteral("72 × "))) << words().toStdString();
  EXPECT_TRUE(words().contains(QStringLiteral(" × 4.8 mm · ")));
  EXPECT_TRUE(words().contains(QStringLiteral(" · watertight")));
  const QString file = folder_.filePath(QStringLiteral("休.stl"));
  const QString told = words();
  dialog_->save(file);
  ASSERT_TRUE(wait_for_end());
  EXPECT_EQ(feedback(), QStringLiteral("Saved as %1.").arg(file));
  const Stl stl = stl_of(file);
  EXPECT_NEAR(stl.width, 72, 0.3);
  EXPECT_NEAR(stl.thickness, 4.8, 0.02);
  EXPECT_TRUE(told.contains(QLocale().toString(stl.triangles) + QStringLiteral(" triangles")))
      << told.toStdString();
}

TEST_F(SolidDialogTest, TheModelFollowsTheOptions) {
  open_dialog();
  const QImage before = part<ReliefView>("solid_picture")->picture();
  EXPECT_FALSE(before.isNull());
  change([this] { part<QCheckBox>("solid_dots")->setChecked(false); });
  EXPECT_TRUE(words().contains(QStringLiteral(" × 4.0 mm"))) << words().toStdString();
  change([this] { part<QComboBox>("solid_kind")->setCurrentIndex(1); });
  EXPECT_TRUE(words().contains(QStringLiteral(" × 6.0 mm"))) << words().toStdString();
  EXPECT_NE(part<ReliefView>("solid_picture")->picture(), before);
  EXPECT_FALSE(part<QCheckBox>("solid_numbers")->isVisible());
  change([this] { part<QCheckBox>("solid_hole")->setChecked(false); });
  EXPECT_TRUE(words().startsWith(QStringLiteral("112 × 112 × "))) << words().toStdString();
  change([this] { part<QCheckBox>("solid_mould")->setChecked(true); });
  EXPECT_FALSE(part<QCheckBox>("solid_hole")->isVisible());
  EXPECT_TRUE(words().contains(QStringLiteral(" × 11.0 mm"))) << words().toStdString();
}

TEST_F(SolidDialogTest, NumbersWithoutRoomAreTold) {
  show(U'鬱');
  open_dialog();
  change([this] { part<QSpinBox>("solid_size")->setValue(40); });
  EXPECT_TRUE(words().contains(QStringLiteral("No room for the numbers of strokes ")))
      << words().toStdString();
  change([this] { part<QCheckBox>("solid_numbers")->setChecked(false); });
  EXPECT_FALSE(words().contains(QStringLiteral("No room")));
}

TEST_F(SolidDialogTest, AThreeMfAndTheChoiceAreSaved) {
  open_dialog();
  change([this] { part<QComboBox>("solid_kind")->setCurrentIndex(1); });
  const QString path = folder_.filePath(QStringLiteral("休.3mf"));
  dialog_->save(path);
  ASSERT_TRUE(wait_for_end());
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.read(2), QByteArray("PK"));
  open_dialog();
  EXPECT_EQ(part<QComboBox>("solid_kind")->currentIndex(), 1);
}

TEST_F(SolidDialogTest, AFileThatCannotBeWrittenLeavesTheDialogOpen) {
  open_dialog();
  dialog_->save(folder_.filePath(QStringLiteral("missing/a.stl")));
  EXPECT_TRUE(
      QTest::qWaitFor([this] { return words().contains(QStringLiteral("Nothing was saved.")); }, 20000));
  EXPECT_TRUE(dialog_->isVisible());
  EXPECT_TRUE(part<QPushButton>("solid_save")->isEnabled());
}

TEST_F(SolidDialogTest, TheAnswerToAQuestionIsNotShown) {
  action("memory")->trigger();
  QCoreApplication::processEvents();
  press(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(find<SolidDialog>("solid_dialog"), nullptr);
  EXPECT_EQ(feedback(), QStringLiteral("Finish this character first: a model would show it."));
}

TEST_F(SolidOfPlotTest, APlotHasItsOwnSizeAndNoStrokes) {
  type(QStringLiteral("y = x^2/4"));
  open_dialog();
  EXPECT_FALSE(part<QComboBox>("solid_kind")->isVisible());
  EXPECT_FALSE(part<QCheckBox>("solid_numbers")->isVisible());
  EXPECT_FALSE(part<QCheckBox>("solid_hole")->isVisible());
  EXPECT_EQ(part<QSpinBox>("solid_size")->value(), 120);
  EXPECT_TRUE(words().contains(QStringLiteral(" × 4.0 mm"))) << words().toStdString();
  const QString file = folder_.filePath(QStringLiteral("plot.stl"));
  dialog_->save(file);
  ASSERT_TRUE(wait_for_end());
  const Stl stl = stl_of(file);
  EXPECT_NEAR(stl.thickness, 4, 0.02);
  EXPECT_GT(stl.width, 120 + 20);  // with the numbers beside it
}

}  // namespace
}  // namespace nazori::ui
