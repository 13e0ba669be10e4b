// SPDX-License-Identifier: Apache-2.0
// Services of the window without widgets of their own: the colours of the desktop, announcements, the
// learner's own files.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDBusVariant>
#include <QLabel>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "nazori/kanji/stroke_order.h"
#include "nazori/practice/tablet_workshop.h"
#include "nazori/widgets/controls/status_line.h"
#include "nazori/widgets/look/appearance.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/settings/stored_settings.h"

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

class AnnouncementsOfTheWindow : public testing::Test {
 protected:
  AnnouncementsOfTheWindow() {
    QObject::connect(&parts_, &WindowParts::announced, &parts_,
                     [this](Feedback kind, const QString& sentence) {
                       kinds_.push_back(kind);
                       said_.append(sentence);
                     });
  }
  QTemporaryDir folder_;
  QWidget window_;
  WindowParts parts_{window_,
                     folder_.filePath(QStringLiteral("nazori.ini")),
                     {folder_.filePath(QStringLiteral("learners")).toStdString(),
                      std::filesystem::path(qgetenv("NAZORI_DATA").toStdString()) / "kanji.db",
                      {}}};
  std::vector<Feedback> kinds_;
  QStringList said_;
};

TEST_F(AnnouncementsOfTheWindow, WaitUntilTheWindowShowsSomethingAndThenTheMostSeriousIsAnnounced) {
  const QSignalSpy opened(&parts_, &WindowParts::opened);
  parts_.announce_when_open(Feedback::good, QStringLiteral("good"));
  parts_.announce_when_open(Feedback::advice, QStringLiteral("first advice"));
  parts_.announce_when_open(Feedback::advice, QStringLiteral("second advice"));
  parts_.announce_when_open(Feedback::hint, QStringLiteral("hint"));
  EXPECT_TRUE(said_.isEmpty());
  emit parts_.character_shown(U'一');
  EXPECT_EQ(said_, QStringList{QStringLiteral("first advice")});
  EXPECT_EQ(kinds_, std::vector{Feedback::advice});
  EXPECT_EQ(opened.count(), 1);
  parts_.announce_when_open(Feedback::hint, QStringLiteral("now"));
  EXPECT_EQ(said_.back(), QStringLiteral("now")) << "at once from then on";
  emit parts_.character_shown(U'二');
  EXPECT_EQ(said_.size(), 2);
  EXPECT_EQ(opened.count(), 1);
}

TEST_F(AnnouncementsOfTheWindow, AnEmptySentenceIsNotAnnounced) {
  emit parts_.character_shown(U'一');
  parts_.announce(Feedback::hint, {});
  EXPECT_TRUE(said_.isEmpty());
}

TEST_F(AnnouncementsOfTheWindow, OfTheLearnerWaitAndThoseOfASessionDoNot) {
  practice::LearnerEvent event;
  event.kind = practice::LearnerEvent::Kind::opened_again;
  event.profile = "Mari";
  parts_.learner().announced(event);
  EXPECT_TRUE(said_.isEmpty());
  practice::SessionFeedback feedback;
  feedback.kind = practice::SessionFeedback::Kind::nothing_due;
  parts_.session().announced(feedback);
  EXPECT_EQ(said_, QStringList{QStringLiteral("Nothing is due now.")});
  feedback.kind = practice::SessionFeedback::Kind::all_done;
  feedback.stage = study::Stage::brush;
  parts_.brush_session().announced(feedback);
  EXPECT_EQ(said_.back(), QStringLiteral("All done with the brush for now. Every rating is saved."));
  EXPECT_EQ(kinds_, (std::vector{Feedback::hint, Feedback::good}));
  parts_.note_opened();
  EXPECT_EQ(said_.back(), QStringLiteral("“Mari” is now open here. Everything is saved again."));
  EXPECT_EQ(kinds_.back(), Feedback::good);
}

TEST_F(AnnouncementsOfTheWindow, NothingThatWaitsIsAnnouncedAsNothing) {
  const QSignalSpy opened(&parts_, &WindowParts::opened);
  parts_.note_opened();
  EXPECT_EQ(opened.count(), 1);
  EXPECT_TRUE(said_.isEmpty());
}

TEST_F(AnnouncementsOfTheWindow, AnotherLearnerIsRemembered) {
  const QSignalSpy save(&parts_, &WindowParts::save_later);
  EXPECT_EQ(parts_.learner().profile(), "learner");
  ASSERT_TRUE(parts_.learner().switch_profile("Mari"));
  EXPECT_EQ(parts_.preferences().profile, QStringLiteral("Mari"));
  EXPECT_GE(save.count(), 1);
}

TEST(PartsOfTheWindow, BeginWithTheSettingsOfTheFileAndALearnerWhoseNameCanBe) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("nazori.ini"));
  Preferences stored;
  stored.style = view::Style::slate;
  stored.profile = QStringLiteral("a/b");
  ASSERT_TRUE(stored.save(file));
  QWidget window;
  const auto place = [&] {
    return practice::Learner::Place{folder.filePath(QStringLiteral("learners")).toStdString(),
                                    std::filesystem::path(qgetenv("NAZORI_DATA").toStdString()) / "kanji.db",
                                    {}};
  };
  {
    WindowParts parts(window, file, place());
    EXPECT_EQ(parts.settings_file(), file);
    EXPECT_EQ(parts.tablet().style(), view::Style::slate);
    EXPECT_EQ(parts.learner().profile(), "learner") << "no such name can be";
  }
  stored.profile = QStringLiteral("Mari");
  ASSERT_TRUE(stored.save(file));
  WindowParts parts(window, file, place());
  EXPECT_EQ(parts.learner().profile(), "Mari");
  EXPECT_EQ(WindowParts(window, {}, place()).settings_file(), Preferences::default_file());
}

TEST(StatusLine, TellsDepthInMillimetresWhileThereIsAny) {
  const QTemporaryDir folder;
  WindowTablet controller;
  EventLoopInbox loop;
  practice::TabletRecording recording(loop.inbox(), controller.device(),
                                      unfinished_recordings(folder.filePath(QStringLiteral("nazori.ini"))));
  StatusLine line(controller, recording, nullptr);
  // Another test may have written with a pen.
  QMouseEvent mouse(QEvent::MouseMove, QPointF(), QPointF(), Qt::NoButton, Qt::NoButton, {});
  QCoreApplication::sendEvent(&line, &mouse);
  line.resize(2000, 30);
  line.show();
  const auto* depth = line.findChild<QLabel*>(QStringLiteral("depth"));
  EXPECT_FALSE(depth->isVisible());
  line.show_depth(0.00423);
  EXPECT_FALSE(depth->isVisible()) << "without figures";
  line.show_figures(true);
  EXPECT_EQ(depth->text(), QStringLiteral("depth 4.2 mm"));
  EXPECT_TRUE(depth->isVisible());
  line.show_depth(0);
  EXPECT_FALSE(depth->isVisible());
  EXPECT_TRUE(line.findChild<QLabel*>(QStringLiteral("device"))
                  ->text()
                  .startsWith(QStringLiteral("You are writing with the mouse.")));
  EXPECT_EQ(line.findChild<QLabel*>(QStringLiteral("rate"))->text(), QStringLiteral("starting"));
  EXPECT_FALSE(line.findChild<QLabel*>(QStringLiteral("recording"))->isVisible());
  ASSERT_TRUE(controller.start());
  // The servo runs a thousand times per second while the stylus moves, and rests otherwise.
  const auto* rate = line.findChild<QLabel*>(QStringLiteral("rate"));
  controller.move_stylus({0, 0}, true);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return rate->text().endsWith(QStringLiteral("times per second")); }, 20'000));
  controller.lift_stylus();
  EXPECT_TRUE(QTest::qWaitFor([&] { return rate->text() == QStringLiteral("at rest"); }, 20'000));
  line.resize(60, 30);
  EXPECT_FALSE(rate->isVisible());
  EXPECT_TRUE(line.findChild<QLabel*>(QStringLiteral("device"))->isVisible()) << "the last to go";
}

}  // namespace
}  // namespace nazori::ui
