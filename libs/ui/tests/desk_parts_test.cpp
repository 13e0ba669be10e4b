// SPDX-License-Identifier: Apache-2.0
// What stands behind the window: the colours of the desktop, the news of the desk, files of one's own.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDBusVariant>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "appearance.h"
#include "desk.h"
#include "nazori/kanji/stroke_order.h"
#include "palette.h"
#include "status_line.h"
#include "workshop.h"

namespace nazori::ui {
namespace {

void desktop_says(Appearance& appearance, const char* group, const char* key, const QVariant& value) {
  ASSERT_TRUE(QMetaObject::invokeMethod(
      &appearance, "desktop_setting_changed", Q_ARG(QString, QString::fromLatin1(group)),
      Q_ARG(QString, QString::fromLatin1(key)), Q_ARG(QDBusVariant, QDBusVariant(value))));
}

TEST(ColoursOfTheDesktop, AreTakenUpWhereTheLearnerLeavesThemToIt) {
  Appearance appearance;
  const bool at_first = appearance.is_dark();
  QSignalSpy changed(&appearance, &Appearance::changed);
  const auto scheme = [&](uint wish) {
    desktop_says(appearance, "org.freedesktop.appearance", "color-scheme", wish);
    return appearance.is_dark();
  };
  EXPECT_TRUE(scheme(1));
  EXPECT_EQ(changed.count(), 1);
  EXPECT_TRUE(is_dark(QApplication::palette()));
  EXPECT_FALSE(scheme(2));
  EXPECT_FALSE(is_dark(QApplication::palette()));
  EXPECT_EQ(scheme(0), at_first) << "left open";
  scheme(1);
  desktop_says(appearance, "org.freedesktop.appearance", "accent-color", 2U);
  desktop_says(appearance, "org.gnome.desktop", "color-scheme", 2U);
  EXPECT_TRUE(appearance.is_dark()) << "another setting";
  appearance.apply(ThemeChoice::light, 14);
  EXPECT_FALSE(appearance.is_dark()) << "the learner's word counts more";
  EXPECT_EQ(QApplication::font().pointSize(), 14);
  appearance.apply(ThemeChoice::dark, 12);
  scheme(2);
  EXPECT_TRUE(appearance.is_dark());
  EXPECT_EQ(QApplication::font().pointSize(), 12);
  // Answers to a question come wrapped twice.
  appearance.apply(ThemeChoice::desktop, 12);
  desktop_says(appearance, "org.freedesktop.appearance", "color-scheme",
               QVariant::fromValue(QDBusVariant(1U)));
  EXPECT_TRUE(appearance.is_dark());
}

class NewsOfTheDesk : public testing::Test {
 protected:
  NewsOfTheDesk() {
    QObject::connect(&desk_, &Desk::said, &desk_, [this](Feedback kind, const QString& sentence) {
      kinds_.push_back(kind);
      said_.append(sentence);
    });
  }
  QTemporaryDir folder_;
  QWidget window_;
  Desk desk_{window_,
             std::filesystem::path(qgetenv("NAZORI_DATA").toStdString()) / "kanji.db",
             folder_.filePath(QStringLiteral("nazori.ini")),
             {folder_.filePath(QStringLiteral("learners")).toStdString(), {}, {}}};
  std::vector<Feedback> kinds_;
  QStringList said_;
};

TEST_F(NewsOfTheDesk, WaitUntilTheWindowShowsSomethingAndThenTheGravestIsSaid) {
  const QSignalSpy opened(&desk_, &Desk::opened);
  desk_.tell(Feedback::good, QStringLiteral("good"));
  desk_.tell(Feedback::advice, QStringLiteral("first advice"));
  desk_.tell(Feedback::advice, QStringLiteral("second advice"));
  desk_.tell(Feedback::hint, QStringLiteral("hint"));
  EXPECT_TRUE(said_.isEmpty());
  emit desk_.character_shown(U'一');
  EXPECT_EQ(said_, QStringList{QStringLiteral("first advice")});
  EXPECT_EQ(kinds_, std::vector{Feedback::advice});
  EXPECT_EQ(opened.count(), 1);
  desk_.tell(Feedback::hint, QStringLiteral("now"));
  EXPECT_EQ(said_.back(), QStringLiteral("now")) << "at once from then on";
  emit desk_.character_shown(U'二');
  EXPECT_EQ(said_.size(), 2);
  EXPECT_EQ(opened.count(), 1);
}

TEST_F(NewsOfTheDesk, NothingIsSaidWhereThereIsNothingToSay) {
  emit desk_.character_shown(U'一');
  desk_.say(Feedback::hint, {});
  EXPECT_TRUE(said_.isEmpty());
}

class OwnFiles : public testing::Test {
 protected:
  OwnFiles() {
    QObject::connect(&workshop_, &Workshop::loaded, &workshop_,
                     [this](const OwnTablet& own) { loaded_.push_back(own); });
  }
  [[nodiscard]] QString path(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }
  /// A stroke file whose farthest point lies there.
  QString strokes(const char* name, std::int32_t x, std::int32_t y) {
    kanji::StrokeOrder order;
    order.add_stroke({{10, 10}, {x, y}});
    EXPECT_TRUE(order.save(path(name).toStdString()));
    return path(name);
  }
  OwnTablet load(const QString& map, const QString& order, const OwnTablet& onto = {}, int grid = 0) {
    loaded_.clear();
    workshop_.load(map, order, onto, grid);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !loaded_.empty(); }, 30'000));
    return loaded_.empty() ? OwnTablet{} : loaded_.front();
  }
  QTemporaryDir folder_;
  Workshop workshop_;
  std::vector<OwnTablet> loaded_;
};

TEST_F(OwnFiles, TheGridOfAStrokeFileIsThePowerOfTwoThatHoldsIt) {
  struct Expected {
    std::int32_t x, y;
    int side;
    bool certain;
  };
  const Expected all[] = {{63, 20, 128, false},  {64, 20, 128, true},    {20, 64, 128, true},
                          {127, 127, 128, true}, {128, 20, 256, false},  {20, 255, 256, false},
                          {256, 20, 512, false}, {20, 1000, 1024, false}};
  for (const auto& [x, y, side, certain] : all) {
    const auto guess = Workshop::guess_grid(strokes("a.str", x, y));
    ASSERT_TRUE(guess);
    EXPECT_EQ(guess->side, side) << x << ' ' << y;
    EXPECT_EQ(guess->certain, certain) << x << ' ' << y;
  }
  EXPECT_FALSE(Workshop::guess_grid(path("none.str")));
}

TEST_F(OwnFiles, StrokesAloneAreCarvedInTheWindowsSizeOnTheirGrid) {
  const auto own = load({}, strokes("a.str", 64, 64));
  ASSERT_TRUE(own.tablet);
  EXPECT_EQ(own.name, QStringLiteral("a.str"));
  EXPECT_TRUE(own.has_strokes);
  EXPECT_EQ(own.map_size, 0);
  EXPECT_EQ(own.tablet->height_map().size(), Workshop::kSize);
  // The same points on a grid of twice the side lie half as far.
  const auto wide = load({}, path("a.str"), {}, 256);
  ASSERT_TRUE(wide.tablet);
  const auto end = own.tablet->lines()[0].points.back();
  const auto wide_end = wide.tablet->lines()[0].points.back();
  EXPECT_NEAR(wide_end.x / end.x, 0.5, 0.02);
}

TEST_F(OwnFiles, AMapHasItsNameAndSizeAndStrokesAreLaidOverIt) {
  auto map = surface::HeightMap::create(64);
  ASSERT_TRUE(map);
  ASSERT_TRUE(surface::save_raw(*map, path("m.raw").toStdString()));
  const auto own = load(path("m.raw"), {});
  EXPECT_EQ(own.name, QStringLiteral("m.raw"));
  EXPECT_EQ(own.map_size, 64);
  EXPECT_FALSE(own.has_strokes);
  EXPECT_TRUE(own.tablet->lines().empty());
  const auto both = load({}, strokes("a.str", 40, 40), own);
  EXPECT_EQ(both.name, QStringLiteral("m.raw + a.str"));
  EXPECT_EQ(both.map_size, 64);
  EXPECT_EQ(both.tablet->height_map().size(), 64);
  EXPECT_EQ(both.tablet->lines().size(), 1U);
  const auto other = load({}, strokes("b.str", 50, 50), both);
  EXPECT_EQ(other.name, QStringLiteral("m.raw + b.str")) << "in place of those before";
  QSignalSpy failed(&workshop_, &Workshop::failed);
  workshop_.load({}, strokes("c.str", 64, 64), own);
  ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() == 1; }, 30'000)) << "they do not fit on the map";
  EXPECT_EQ(failed.at(0).at(0).toString(), path("c.str"));
}

TEST_F(OwnFiles, ATabletIsWrittenInTheSizeThatIsAskedForAndAMapInItsOwn) {
  const auto own = load({}, strokes("a.str", 100, 100));
  QSignalSpy saved(&workshop_, &Workshop::saved);
  const auto save = [&](const char* name, const OwnTablet& what, FileFormat format, int size) {
    workshop_.save(what.tablet, path(name), format, size, what.map_size > 0);
    const auto before = saved.count();
    EXPECT_TRUE(QTest::qWaitFor([&] { return saved.count() > before; }, 30'000));
    return path(name).toStdString();
  };
  const auto raw = surface::load_raw(save("b.raw", own, FileFormat::raw, 128));
  ASSERT_TRUE(raw);
  EXPECT_EQ(raw->size(), 128);
  const auto png = surface::load_png(save("b.png", own, FileFormat::png, 256));
  ASSERT_TRUE(png);
  EXPECT_EQ(png->size(), 256);
  const auto order = kanji::StrokeOrder::load(save("b.str", own, FileFormat::strokes, 128), 128);
  ASSERT_TRUE(order);
  ASSERT_EQ(order->count(), 1U);
  EXPECT_NEAR(order->stroke(1).back().x, 100, 1);
  const auto map = load(path("b.raw"), {});
  EXPECT_EQ(surface::load_raw(save("c.raw", map, FileFormat::raw, 512))->size(), 128);
}

TEST(StatusLine, TellsDepthInMillimetresWhileThereIsAny) {
  const QTemporaryDir folder;
  TabletController controller;
  const SessionRecording recording(controller.stylus(), folder.filePath(QStringLiteral("nazori.ini")));
  StatusLine line(controller, recording, nullptr);
  line.resize(2000, 30);
  line.show();
  const auto* depth = line.findChild<QLabel*>(QStringLiteral("depth"));
  EXPECT_FALSE(depth->isVisible());
  line.show_depth(0.00423);
  EXPECT_EQ(depth->text(), QStringLiteral("depth 4.2 mm"));
  EXPECT_TRUE(depth->isVisible());
  line.show_depth(0);
  EXPECT_FALSE(depth->isVisible());
  EXPECT_EQ(line.findChild<QLabel*>(QStringLiteral("device"))->text(),
            QStringLiteral("Mouse, pen or finger, without force"));
  EXPECT_EQ(line.findChild<QLabel*>(QStringLiteral("rate"))->text(), QStringLiteral("starting"));
  EXPECT_FALSE(line.findChild<QLabel*>(QStringLiteral("recording"))->isVisible());
  ASSERT_TRUE(controller.start());
  // While the stylus is awake a thousand times a second, and at rest when nothing moves.
  const auto* rate = line.findChild<QLabel*>(QStringLiteral("rate"));
  controller.move_stylus({0, 0}, true);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return rate->text().endsWith(QStringLiteral("times a second")); }, 20'000));
  controller.lift_stylus();
  EXPECT_TRUE(QTest::qWaitFor([&] { return rate->text() == QStringLiteral("at rest"); }, 20'000));
  line.resize(60, 30);
  EXPECT_FALSE(rate->isVisible());
  EXPECT_TRUE(line.findChild<QLabel*>(QStringLiteral("device"))->isVisible()) << "the last to go";
}

}  // namespace
}  // namespace nazori::ui
