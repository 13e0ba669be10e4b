// SPDX-License-Identifier: Apache-2.0
// Models to touch from the window: of a character, of a tablet of one's own, of a plot.
#include "nazori/studio/print/solid_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTimer>
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

TEST_F(SolidDialogTest, MachinesGetTheirFiles) {
  const auto saved = [this](const QString& name) {
    open_dialog();
    const QString path = folder_.filePath(name);
    dialog_->save(path);
    EXPECT_TRUE(wait_for_end());
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return QString::fromUtf8(file.readAll());
  };
  EXPECT_TRUE(saved(QStringLiteral("休.PDF")).startsWith(QStringLiteral("%PDF-")));
  const QString braille = saved(QStringLiteral("休.brf"));
  EXPECT_TRUE(braille.contains(QStringLiteral("REST"), Qt::CaseInsensitive)) << braille.toStdString();
  const QString laser = saved(QStringLiteral("休.svg"));
  EXPECT_TRUE(laser.contains(QStringLiteral("<svg")));
  EXPECT_TRUE(laser.contains(QStringLiteral("width=\"112."))) << "raised lines are cut as grooves, too";
  EXPECT_TRUE(saved(QStringLiteral("休.nc")).contains(QStringLiteral("G21")));
}

TEST_F(SolidDialogTest, MachinesThatCutAreOfferedForGroovesAndPaperForRaisedLines) {
  open_dialog();
  const auto offered = [this] {
    QStringList kinds;
    QTimer::singleShot(0, qApp, [&] {
      auto* files = find<QFileDialog>("solid_file_dialog");
      ASSERT_NE(files, nullptr);
      for (const QString& filter : files->nameFilters())
        kinds << filter.section(QLatin1Char('.'), -1).remove(QLatin1Char(')'));
      files->reject();
    });
    part<QPushButton>("solid_save")->click();
    return kinds.join(QLatin1Char(' '));
  };
  EXPECT_EQ(offered(), QStringLiteral("3mf stl pdf brf"));
  change([this] { part<QComboBox>("solid_kind")->setCurrentIndex(1); });
  EXPECT_EQ(offered(), QStringLiteral("3mf stl nc svg"));
}

TEST_F(SolidDialogTest, FilesAreMadeForTheMachinesThatWereChosen) {
  const auto saved = [this](const QString& name) {
    const QString path = folder_.filePath(name);
    dialog_->save(path);
    EXPECT_TRUE(wait_for_end());
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return QString::fromUtf8(file.readAll());
  };
  open_dialog();
  EXPECT_FALSE(part<QSpinBox>("solid_layers")->isVisible());
  EXPECT_TRUE(part<QComboBox>("solid_paper")->isVisible());
  part<QComboBox>("solid_english")->setCurrentIndex(1);
  part<QSpinBox>("solid_columns")->setValue(20);
  part<QSpinBox>("solid_lines")->setValue(30);
  EXPECT_EQ(saved(QStringLiteral("b.brf")).section(QLatin1Char('\f'), 0, 0).count(QLatin1Char('\n')), 30);
  open_dialog();
  EXPECT_EQ(part<QSpinBox>("solid_columns")->value(), 20);
  EXPECT_EQ(part<QSpinBox>("solid_lines")->value(), 30);
  part<QSpinBox>("solid_columns")->setValue(40);
  EXPECT_TRUE(saved(QStringLiteral("a.brf")).contains(QStringLiteral("\nRE/  ")));  // rest, with its st
  open_dialog();
  EXPECT_EQ(part<QComboBox>("solid_english")->currentIndex(), 1);
  part<QComboBox>("solid_paper")->setCurrentIndex(2);
  EXPECT_TRUE(saved(QStringLiteral("a.pdf")).contains(QStringLiteral("612"))) << "Letter is 612 points wide";
  open_dialog();
  change([this] { part<QComboBox>("solid_kind")->setCurrentIndex(1); });
  EXPECT_FALSE(part<QComboBox>("solid_paper")->isVisible());
  part<QSpinBox>("solid_layers")->setValue(4);
  const QString laser = saved(QStringLiteral("a.svg"));
  EXPECT_TRUE(laser.contains(QStringLiteral("id=\"layer-4\"")));
  EXPECT_FALSE(laser.contains(QStringLiteral("id=\"layer-5\"")));
  open_dialog();
  EXPECT_EQ(part<QSpinBox>("solid_layers")->value(), 4);
  part<QDoubleSpinBox>("solid_cutter")->setValue(1);
  part<QDoubleSpinBox>("solid_pass")->setValue(0.5);
  part<QDoubleSpinBox>("solid_feed")->setValue(430);
  part<QDoubleSpinBox>("solid_plunge")->setValue(170);
  part<QDoubleSpinBox>("solid_safe")->setValue(7);
  part<QDoubleSpinBox>("solid_spindle")->setValue(9000);
  change([this] { part<QDoubleSpinBox>("solid_depth")->setValue(2); });
  const QString mill = saved(QStringLiteral("a.nc"));
  const auto deepest = [&mill] {
    double lowest = 0;
    const QStringList words = mill.split(QRegularExpression(QStringLiteral("\\s")));
    for (const QString& word : words)
      if (word.startsWith(QLatin1Char('Z'))) lowest = std::min(lowest, word.mid(1).toDouble());
    return lowest;
  };
  EXPECT_NEAR(deepest(), -2, 0.1);
  for (const char* word : {"F430", "F170", "Z7", "S9000"})
    EXPECT_TRUE(mill.contains(QString::fromLatin1(word))) << word;
  open_dialog();
  EXPECT_EQ(part<QDoubleSpinBox>("solid_feed")->value(), 430);
  // Lines of the last pass that are farther apart make a shorter program.
  EXPECT_EQ(part<QDoubleSpinBox>("solid_depth")->value(), 2);
  part<QDoubleSpinBox>("solid_step_over")->setValue(0.6);
  EXPECT_LT(saved(QStringLiteral("b.nc")).size(), mill.size());
}

TEST_F(SolidDialogTest, MachinesHaveTheRangesOfTheCommandLine) {
  open_dialog();
  const auto range = [this](const char* name) {
    const auto* spin = part<QDoubleSpinBox>(name);
    return std::pair(spin->minimum(), spin->maximum());
  };
  EXPECT_EQ(range("solid_cutter"), std::pair(0.2, 20.0));
  EXPECT_EQ(range("solid_pass"), std::pair(0.05, 50.0));
  EXPECT_EQ(range("solid_step_over"), std::pair(0.02, 5.0));
  EXPECT_EQ(range("solid_safe"), std::pair(1.0, 100.0));
  EXPECT_EQ(range("solid_feed"), std::pair(10.0, 20'000.0));
  EXPECT_EQ(range("solid_plunge"), std::pair(10.0, 20'000.0));
  EXPECT_EQ(range("solid_spindle"), std::pair(0.0, 60'000.0));
  for (const char* name : {"solid_columns", "solid_lines"}) {
    EXPECT_EQ(part<QSpinBox>(name)->minimum(), 12) << name;
    EXPECT_EQ(part<QSpinBox>(name)->maximum(), 100) << name;
  }
  EXPECT_EQ(part<QSpinBox>("solid_layers")->minimum(), 1);
  EXPECT_EQ(part<QSpinBox>("solid_layers")->maximum(), 64);
  EXPECT_EQ(part<QComboBox>("solid_paper")->count(), 3);
}

TEST_F(SolidDialogTest, APageThatIsTooSmallIsSaidAndNothingIsSaved) {
  open_dialog();
  change([this] { part<QSpinBox>("solid_size")->setValue(250); });
  const QString path = folder_.filePath(QStringLiteral("large.pdf"));
  dialog_->save(path);
  EXPECT_TRUE(QTest::qWaitFor([this] { return words().startsWith(QStringLiteral("✗ large.pdf: ")); }, 20000))
      << words().toStdString();
  EXPECT_FALSE(QFile::exists(path));
  EXPECT_TRUE(part<QPushButton>("solid_save")->isEnabled());
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

TEST_F(SolidOfPlotTest, APlotIsSavedForPaper) {
  const auto saved = [this](const QString& name) {
    open_dialog();
    EXPECT_TRUE(part<QComboBox>("solid_paper")->isVisible());
    EXPECT_FALSE(part<QComboBox>("solid_english")->isVisible());
    const QString path = folder_.filePath(name);
    dialog_->save(path);
    EXPECT_TRUE(wait_for_end());
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return QString::fromUtf8(file.readAll());
  };
  type(QStringLiteral("y = x"));
  EXPECT_TRUE(saved(QStringLiteral("a.brf")).contains(QStringLiteral("\n;;;Y \"7 X;'\r\n")));
  EXPECT_TRUE(saved(QStringLiteral("a.pdf")).startsWith(QStringLiteral("%PDF-")));
}

TEST_F(SolidOfPlotTest, ASurfaceHasNoPaper) {
  type(QStringLiteral("z = x y"));
  open_dialog();
  EXPECT_FALSE(part<QComboBox>("solid_paper")->isVisible());
  const QString path = folder_.filePath(QStringLiteral("a.brf"));
  dialog_->save(path);
  EXPECT_TRUE(QTest::qWaitFor([this] { return words().startsWith(QStringLiteral("✗ a.brf: ")); }, 20000));
  EXPECT_FALSE(QFile::exists(path));
}

}  // namespace
}  // namespace nazori::ui
