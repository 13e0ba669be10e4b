// SPDX-License-Identifier: Apache-2.0
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

#include "nazori/kanji/stroke_order.h"
#include "nazori/practice/tablet_workshop.h"
#include "nazori/surface/height_map.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

class Files : public WindowTest {
 protected:
  QString write(const char* name, const QByteArray& bytes) {
    const QString path = folder_.filePath(QString::fromUtf8(name));
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    return path;
  }
  void open(const QStringList& paths) {
    const QString before = feedback();
    window_->open_files(paths);
    EXPECT_TRUE(QTest::qWaitFor([&] { return feedback() != before; }, 10000));
  }
  /// 休 as the program of 2005 had it, in its own format. @source A. D. Horne, West Virginia University,
  /// 2005.
  QString kyuu_2005() {
    using Points = kanji::StrokeOrder::Points;
    const kanji::StrokeOrder order({Points{{50, 21}, {19, 53}}, Points{{40, 40}, {38, 99}},
                                    Points{{63, 32}, {109, 31}}, Points{{85, 20}, {86, 97}},
                                    Points{{83, 41}, {72, 59}, {57, 74}},
                                    Points{{90, 41}, {103, 58}, {125, 70}}});
    const auto bytes = order.to_bytes();
    return write("0018.str", QByteArray(reinterpret_cast<const char*>(bytes.data()),
                                        static_cast<qsizetype>(bytes.size())));
  }
};

TEST_F(Files, ARawOfPerfectSquareLengthIsOpenedWithoutAsking) {
  open({write("own.raw", QByteArray(128 * 128, '\x80'))});
  EXPECT_TRUE(feedback().contains(QStringLiteral("Opened own.raw"))) << feedback().toStdString();
  EXPECT_TRUE(text("facts").contains(QStringLiteral("128 × 128")));
  EXPECT_EQ(text("stroke_label"), QStringLiteral("no strokes"));
}

TEST_F(Files, GivenAtTheStartAreShownInPlaceOfTheLastCharacter) {
  // A large file, so that the character is loaded first.
  for (const QString& path : {write("own.raw", QByteArray(2048 * 2048, '\x80')), kyuu_2005()}) {
    window_.reset();
    window_ = std::make_unique<MainWindow>(setup(), appearance_);
    window_->show();
    // As in the program: the last character was requested and is not loaded yet.
    window_->open_files({path});
    const QString name = QFileInfo(path).fileName();
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return feedback().startsWith(QStringLiteral("Opened ") + name); }, 20000))
        << feedback().toStdString();
    EXPECT_TRUE(window_->windowTitle().startsWith(name)) << window_->windowTitle().toStdString();
  }
}

TEST_F(Files, ABadFileAtTheStartLeavesTheLastCharacter) {
  const QString bad = write("bad.raw", QByteArray(16385, 'x'));
  window_.reset();
  window_ = std::make_unique<MainWindow>(setup(), appearance_);
  QSignalSpy shown(window_.get(), &MainWindow::character_shown);
  window_->show();
  window_->open_files({bad});
  EXPECT_TRUE(shown.wait(20000));
  EXPECT_TRUE(window_->windowTitle().startsWith(QStringLiteral("休")))
      << window_->windowTitle().toStdString();
}

TEST_F(Files, APictureIsKnownByWhatItHoldsWhateverItsName) {
  auto slope = *surface::HeightMap::create(32);
  slope.set(3, 5, 0.25F);
  const std::string picture = folder_.filePath(QStringLiteral("picture.raw")).toStdString();
  ASSERT_TRUE(surface::save_png(slope, picture, surface::PngDepth::bits_8));
  open({QString::fromStdString(picture)});
  EXPECT_TRUE(feedback().contains(QStringLiteral("Opened picture.raw"))) << feedback().toStdString();
  EXPECT_TRUE(text("facts").contains(QStringLiteral("32 × 32")));
}

TEST_F(Files, ABadFileIsExplainedAndTheTabletKept) {
  const QString bad = write("bad.raw", QByteArray(16385, 'x'));
  open({bad});
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("bad.raw: "))) << feedback().toStdString();
  EXPECT_TRUE(feedback().endsWith(QStringLiteral("The tablet was not changed.")));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("休 – Nazori"));
  EXPECT_EQ(text("stroke_label"), QStringLiteral("all 6 strokes"));
}

TEST_F(Files, EveryKindOfUnreadableFileIsRefusedInOneSentence) {
  for (const QString& path : {write("empty.raw", {}), write("short.str", QByteArray("\x06\x00\x00", 3)),
                              write("text.png", "no picture"), write("song.mp3", "x"),
                              folder_.filePath(QStringLiteral("missing.raw"))}) {
    open({path});
    EXPECT_TRUE(feedback().endsWith(QStringLiteral("The tablet was not changed.")))
        << feedback().toStdString();
    EXPECT_FALSE(feedback().contains(QLatin1Char('\n')));
    EXPECT_EQ(text("stroke_label"), QStringLiteral("all 6 strokes"));
  }
}

TEST_F(Files, TheStrokesOf2005AreCarvedWithoutAskingForTheirGrid) {
  open({kyuu_2005()});
  EXPECT_EQ(feedback(), QStringLiteral("Opened 0018.str."));
  EXPECT_EQ(text("stroke_label"), QStringLiteral("all 6 strokes"));
}

TEST_F(Files, AMapAndItsStrokesCanBeDroppedTogether) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(kyuu_2005()),
                QUrl::fromLocalFile(write("0018.raw", QByteArray(128 * 128, '\xff')))});
  const QString before = feedback();
  QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &drop);
  EXPECT_TRUE(QTest::qWaitFor([&] { return feedback() != before; }, 10000));
  EXPECT_EQ(feedback(), QStringLiteral("Opened 0018.raw + 0018.str."));
  EXPECT_EQ(text("stroke_label"), QStringLiteral("all 6 strokes"));
}

TEST_F(Files, StrokesAreLaidOverAMapThatIsAlreadyOpen) {
  open({write("0018.raw", QByteArray(128 * 128, '\xff'))});
  open({kyuu_2005()});
  EXPECT_EQ(feedback(), QStringLiteral("Opened 0018.raw + 0018.str."));
  EXPECT_TRUE(text("facts").contains(QStringLiteral("128 × 128")));
}

TEST_F(Files, ChoosingACharacterComesBackFromAMapOfOnesOwn) {
  open({write("own.raw", QByteArray(64 * 64, '\x80'))});
  show(U'木');
  EXPECT_EQ(text("stroke_label"), QStringLiteral("all 4 strokes"));
}

}  // namespace
}  // namespace nazori::ui
