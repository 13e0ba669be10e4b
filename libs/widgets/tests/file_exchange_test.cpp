// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/dialogs/file_exchange.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "nazori/kanji/stroke_order.h"
#include "nazori/surface/height_map_file.h"
#include "nazori/widgets/dialogs/save_dialog.h"
#include "nazori/widgets/events/event_loop_inbox.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

class OwnFilesOfTheLearner : public testing::Test {
 protected:
  OwnFilesOfTheLearner() {
    QObject::connect(&files_, &FileExchange::announced, &window_, [this](Feedback kind, const QString& what) {
      kinds_.push_back(kind);
      said_.append(what);
    });
    QObject::connect(&files_, &FileExchange::folder_changed, &window_,
                     [this](const QString& folder) { folders_.append(folder); });
    workshop_.loaded.connect([this](const practice::OwnTablet& own) { loaded_.push_back(own); });
    files_.set_folder(folder_.path());
  }
  QString path(const char* name) const { return folder_.filePath(QString::fromUtf8(name)); }
  QString write(const char* name, const QByteArray& bytes) {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    return path(name);
  }
  QString raw(const char* name, int side) { return write(name, QByteArray(side * side, '\x80')); }
  /// One stroke from the left to the right, up to `far` samples.
  QString strokes(const char* name, int far) {
    using Points = kanji::StrokeOrder::Points;
    EXPECT_TRUE(kanji::StrokeOrder({Points{{8, 20}, {far, 20}}}).save(path(name).toStdString()));
    return path(name);
  }
  /// Does something with the dialog that opens next.
  template <class Dialog>
  void then(std::function<void(Dialog&)> what) {
    QTimer::singleShot(0, &window_, [this, what] {
      auto* opened = qobject_cast<Dialog*>(QApplication::activeModalWidget());
      ++dialogs_;
      if (opened != nullptr) return what(*opened);
      ADD_FAILURE() << "another dialog is open";
      if (auto* other = qobject_cast<QDialog*>(QApplication::activeModalWidget())) other->reject();
    });
  }
  /// Ends a dialog of files as its button does.
  static void choose(QFileDialog& dialog, const QString& file) {
    dialog.selectFile(file);
    static_cast<QDialog&>(dialog).done(QDialog::Accepted);
  }
  [[nodiscard]] bool comes() {
    return QTest::qWaitFor([&] { return !loaded_.empty(); }, 20'000);
  }
  practice::OwnTablet opened(const QStringList& paths, const practice::OwnTablet& onto = {}) {
    loaded_.clear();
    EXPECT_TRUE(files_.open(paths, onto));
    EXPECT_TRUE(comes());
    return loaded_.empty() ? practice::OwnTablet() : loaded_.back();
  }

  QTemporaryDir folder_;
  QWidget window_;
  EventLoopInbox loop_;
  practice::TabletWorkshop workshop_{loop_.inbox()};
  FileExchange files_{&workshop_, &window_};
  std::vector<Feedback> kinds_;
  QStringList said_, folders_;
  std::vector<practice::OwnTablet> loaded_;
  int dialogs_ = 0;
};

TEST_F(OwnFilesOfTheLearner, AMapAndItsStrokesAreOpenedTogetherInEitherOrder) {
  const QString map = raw("A.RAW", 64);
  const QString order = strokes("b.str", 50);
  for (const QStringList& both : {QStringList{map, order}, QStringList{order, map}}) {
    const auto own = opened(both);
    EXPECT_EQ(own.map_size, 64);
    EXPECT_TRUE(own.has_strokes);
    EXPECT_EQ(own.name, "A.RAW + b.str");
  }
  EXPECT_EQ(folders_, (QStringList{folder_.path(), folder_.path()}));
  EXPECT_TRUE(said_.isEmpty());
}

TEST_F(OwnFilesOfTheLearner, OneFileTooManyAndOtherKindsOfFilesAreRefused) {
  const std::pair<QStringList, const char*> all[] = {
      {{path("a.raw"), path("b.png")},
       "b.png is one file too many: open one height map and one stroke order file. The tablet was not "
       "changed."},
      {{path("a.str"), path("c.raw"), path("b.str")},
       "b.str is one file too many: open one height map and one stroke order file. The tablet was not "
       "changed."},
      {{path("song.mp3")}, "song.mp3 is not a RAW, PNG or .str file. The tablet was not changed."},
      {{path("a.png"), path("none")}, "none is not a RAW, PNG or .str file. The tablet was not changed."}};
  for (const auto& [paths, sentence] : all) {
    said_.clear();
    EXPECT_FALSE(files_.open(paths, {}));
    EXPECT_EQ(said_, QStringList{QString::fromUtf8(sentence)});
    EXPECT_EQ(kinds_.back(), Feedback::wrong);
  }
  said_.clear();
  EXPECT_FALSE(files_.open({}, {}));
  EXPECT_TRUE(said_.isEmpty());
  EXPECT_TRUE(folders_.isEmpty()) << "nothing was opened";
}

TEST_F(OwnFilesOfTheLearner, StrokesAloneAreAskedForTheirGridWhereItIsNotPlain) {
  const auto width = [](const practice::OwnTablet& own) {
    const auto& line = own.tablet->lines().at(0).points;
    return line.back().x - line.front().x;
  };
  // 40 of 128: the grid may as well be smaller.
  const QString few = strokes("few.str", 40);
  const auto answer = [this](std::optional<int> side) {
    then<QInputDialog>([side](QInputDialog& asked) {
      EXPECT_EQ(asked.windowTitle(), QStringLiteral("Grid size"));
      EXPECT_EQ(asked.labelText(),
                QStringLiteral("few.str does not contain its grid size.\nColumns and rows:"));
      EXPECT_EQ(asked.intValue(), 128);
      EXPECT_EQ(asked.intMinimum(), surface::HeightMap::kMinSize);
      EXPECT_EQ(asked.intMaximum(), surface::HeightMap::kMaxSize);
      EXPECT_EQ(asked.intStep(), 1);
      if (side) asked.setIntValue(*side);
      asked.done(side ? QDialog::Accepted : QDialog::Rejected);
    });
  };
  answer(128);
  const auto classic = opened({few});
  answer(64);
  const auto smaller = opened({few});
  EXPECT_EQ(classic.map_size, 0);
  EXPECT_NEAR(width(smaller) / width(classic), 127.0 / 63, 1e-6) << "between the first and the last column";
  loaded_.clear();
  answer({});
  EXPECT_FALSE(files_.open({few}, {}));
  EXPECT_EQ(dialogs_, 3);
  // Strokes that fill the grid of 2005, and strokes for a map that is open, need no question.
  EXPECT_EQ(opened({strokes("far.str", 100)}).map_size, 0);
  const auto onto = opened({raw("map.raw", 64)});
  EXPECT_EQ(opened({few}, onto).map_size, 64);
  EXPECT_EQ(dialogs_, 3);
}

TEST_F(OwnFilesOfTheLearner, WhatTheWorkshopAnswersIsSaid) {
  workshop_.failed("/a/bad.raw", {base::Errc::parse, "it is too short", "/a/bad.raw", {}});
  workshop_.failed({}, {base::Errc::not_found, {}, {}, {}});
  workshop_.saved("/a/b.png");
  EXPECT_EQ(said_, (QStringList{QStringLiteral("bad.raw: the file format is not valid (it is too short). The "
                                               "tablet was not changed."),
                                QStringLiteral("The character: it does not exist. The tablet was not "
                                               "changed."),
                                QStringLiteral("Saved as /a/b.png.")}));
  EXPECT_EQ(kinds_, (std::vector{Feedback::wrong, Feedback::wrong, Feedback::good}));
}

TEST_F(OwnFilesOfTheLearner, AreChosenInTheFolderOfTheLastTime) {
  const QString map = raw("map.raw", 64);
  then<QFileDialog>([&](QFileDialog& dialog) {
    EXPECT_EQ(dialog.windowTitle(), QStringLiteral("Open a height map, a stroke order file, or both"));
    EXPECT_EQ(dialog.directory().absolutePath(), folder_.path());
    EXPECT_EQ(dialog.nameFilters(),
              (QStringList{QStringLiteral("Height maps and stroke order files (*.raw *.png *.str)"),
                           QStringLiteral("All files (*)")}));
    EXPECT_EQ(dialog.fileMode(), QFileDialog::ExistingFiles);
    choose(dialog, map);
  });
  EXPECT_TRUE(files_.ask_and_open({}));
  ASSERT_TRUE(comes());
  EXPECT_EQ(loaded_.back().name, "map.raw");
  EXPECT_EQ(folders_, QStringList{folder_.path()});
  then<QFileDialog>([](QFileDialog& dialog) { static_cast<QDialog&>(dialog).reject(); });
  EXPECT_FALSE(files_.ask_and_open({}));
}

TEST_F(OwnFilesOfTheLearner, ATabletIsSavedInTheFormatAndSizeThatAreChosen) {
  files_.ask_and_save(nullptr, {}, QStringLiteral("x"));
  EXPECT_EQ(said_, QStringList{QStringLiteral("There is no tablet to save yet.")});
  EXPECT_EQ(kinds_.back(), Feedback::advice);
  std::vector<kanji::StrokeLine> lines(1);
  lines[0].points = {{20, 54.5}, {89, 54.5}};
  const auto tablet = *tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 64);
  ASSERT_TRUE(QDir(folder_.path()).mkdir(QStringLiteral("in")));
  const QString inside = path("in");
  // A dialog for the format, then one for the file.
  const auto save = [&](int format, const QString& as, const practice::OwnTablet& own) {
    then<SaveDialog>([&, format](SaveDialog& dialog) {
      EXPECT_EQ(dialog.findChild<QComboBox*>(QStringLiteral("save_format"))->count(), 3);
      dialog.findChild<QComboBox*>(QStringLiteral("save_format"))->setCurrentIndex(format);
      if (own.map_size == 0) dialog.findChild<QComboBox*>(QStringLiteral("save_size"))->setCurrentIndex(1);
      then<QFileDialog>([&](QFileDialog& files) {
        EXPECT_EQ(files.windowTitle(), QStringLiteral("Save as"));
        EXPECT_EQ(files.acceptMode(), QFileDialog::AcceptSave);
        EXPECT_EQ(files.nameFilters(), QStringList{SaveDialog::filter(dialog.format())});
        EXPECT_EQ(QFileInfo(files.selectedFiles().value(0)).fileName(),
                  QStringLiteral("mine.") + SaveDialog::suffix(dialog.format()));
        if (as.isEmpty())
          static_cast<QDialog&>(files).reject();
        else
          choose(files, as);
      });
      dialog.accept();
    });
    said_.clear();
    files_.ask_and_save(tablet, own, QStringLiteral("mine"));
    return as.isEmpty() || QTest::qWaitFor([&] { return !said_.isEmpty(); }, 20'000);
  };
  ASSERT_TRUE(save(1, inside + QStringLiteral("/picture"), {}));
  EXPECT_EQ(said_.back(), QStringLiteral("Saved as %1.").arg(inside + QStringLiteral("/picture.png")))
      << "the ending is added";
  const auto map = surface::load_height_map((inside + QStringLiteral("/picture.png")).toStdString());
  ASSERT_TRUE(map);
  EXPECT_EQ(map->size(), 256) << "the second of the sizes";
  EXPECT_EQ(folders_, QStringList{inside});
  ASSERT_TRUE(save(0, inside + QStringLiteral("/own.map"), {tablet, "own", 64, true}));
  EXPECT_EQ(QFileInfo(inside + QStringLiteral("/own.map")).size(), 64 * 64) << "its own size, its own ending";
  folders_.clear();
  ASSERT_TRUE(save(2, {}, {}));
  EXPECT_TRUE(folders_.isEmpty()) << "no file was chosen";
  const int before = dialogs_;
  then<SaveDialog>([](SaveDialog& dialog) { dialog.reject(); });
  files_.ask_and_save(tablet, {}, QStringLiteral("mine"));
  EXPECT_EQ(dialogs_, before + 1) << "no second question";
  EXPECT_TRUE(said_.isEmpty());
}

}  // namespace
}  // namespace nazori::ui
