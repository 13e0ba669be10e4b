// SPDX-License-Identifier: Apache-2.0
// The lines below the tablet: feedback, what is only spoken, and the status.
#include <gtest/gtest.h>

#include <QApplication>
#include <QBoxLayout>
#include <QFontInfo>
#include <QLabel>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "nazori/widgets/controls/feedback_line.h"
#include "nazori/widgets/controls/input_watch.h"
#include "nazori/widgets/controls/spoken_line.h"
#include "nazori/widgets/controls/status_line.h"
#include "nazori/widgets/events/event_loop_inbox.h"
#include "nazori/widgets/look/icons.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "nazori/widgets/tablet/window_tablet.h"
#include "nazori/widgets/words/line_stretch.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

QString said(const char* text) { return QString::fromUtf8(text); }

class LineOfFeedback : public testing::Test {
 protected:
  LineOfFeedback() {
    font_.setPointSizeF(20);
    line_.setFont(font_);
    line_.resize(300, 900);
    line_.show();
  }
  QFont font_;
  FeedbackLine line_;
  QLabel& text_ = *line_.findChild<QLabel*>(QStringLiteral("feedback_text"));
  QLabel& sign_ = *line_.findChild<QLabel*>(QStringLiteral("feedback_sign"));
  SpokenLine& spoken_ = *line_.findChild<SpokenLine*>();
};

TEST_F(LineOfFeedback, HasItsNameAndItsSignBesideTheWords) {
  EXPECT_EQ(line_.objectName(), said("feedback_line"));
  EXPECT_EQ(line_.accessibleName(), said("Feedback"));
  EXPECT_EQ(text_.textInteractionFlags(), Qt::TextSelectableByMouse);
  EXPECT_EQ(line_.sizePolicy(), QSizePolicy(QSizePolicy::Expanding, QSizePolicy::Minimum));
  const auto* row = qobject_cast<QBoxLayout*>(line_.layout());
  ASSERT_EQ(row->count(), 2);
  EXPECT_EQ(row->spacing(), 10);
  EXPECT_EQ(row->itemAt(0)->widget(), &sign_);
  EXPECT_EQ(row->itemAt(0)->alignment(), Qt::AlignVCenter);
  EXPECT_EQ(row->itemAt(1)->widget(), &text_);
  EXPECT_EQ(row->stretch(0), 0);
  EXPECT_EQ(row->stretch(1), 1);
}

TEST_F(LineOfFeedback, HasRoomForTwoLinesInAWindowOfThirtyTwoLettersHeight) {
  const int em = QFontInfo(font_).pixelSize();
  const int line = text_.fontMetrics().lineSpacing();
  line_.resize(300, 32 * em);
  EXPECT_EQ(text_.minimumHeight(), 2 * line);
  line_.resize(300, 32 * em - 1);
  EXPECT_EQ(text_.minimumHeight(), line);
}

/// Whether two lines of the width hold these words.
bool fits(const QLabel& label, double size_pt) {
  QFont font = label.font();
  font.setPointSizeF(size_pt);
  const QFontMetrics metrics(font);
  const int high =
      metrics.boundingRect(QRect(0, 0, label.width(), 9999), Qt::TextWordWrap, label.text()).height();
  return high <= 2 * metrics.boundingRect(QRect(0, 0, 9999, 9999), 0, label.text()).height();
}

TEST_F(LineOfFeedback, CompactWordsShrinkInSmallStepsUntilTwoLinesHoldThem) {
  const double first = 20 * 0.72 / line_stretch(font_);
  line_.announce(Feedback::hint, said("Short."));
  line_.set_compact(true);
  EXPECT_NEAR(text_.font().pointSizeF(), first, 0.02);
  // Longer and longer: the first size of the steps that fits, or the first below a half.
  int smaller = 0;
  QString sentence = said("Words");
  for (int i = 0; i < 14; ++i) {
    sentence += said(" and words and more");
    line_.announce(Feedback::hint, sentence);
    double size = first;
    while (size > 10 && !fits(text_, size)) size *= 0.94;
    EXPECT_NEAR(text_.font().pointSizeF(), size, 0.02) << i;
    smaller += size < first ? 1 : 0;
  }
  EXPECT_GT(smaller, 5);
  EXPECT_NEAR(text_.font().pointSizeF(),
              first * std::pow(0.94, std::ceil(std::log(first / 10) / -std::log(0.94))), 0.02)
      << "the first below a half of 20";
  line_.announce(Feedback::hint, said("Short."));
  EXPECT_NEAR(text_.font().pointSizeF(), first, 0.02) << "short ones are larger again";
  line_.set_compact(false);
  EXPECT_NEAR(text_.font().pointSizeF(), 20, 0.02);
}

TEST_F(LineOfFeedback, CompactItFollowsItsWidthAndItsFont) {
  line_.set_compact(true);
  line_.announce(Feedback::hint, said("As many words as need several lines of a narrow window, and more"));
  const double narrow = text_.font().pointSizeF();
  line_.resize(2000, 900);
  QCoreApplication::sendPostedEvents();
  EXPECT_GT(text_.width(), 1000);
  line_.resize(2001, 900);
  EXPECT_GT(text_.font().pointSizeF(), narrow);
  const int margin = line_.layout()->contentsMargins().top();
  EXPECT_EQ(margin, 3);
  font_.setPointSizeF(30);
  line_.setFont(font_);
  EXPECT_NEAR(text_.font().pointSizeF(), 30 * 0.72 / line_stretch(font_), 0.02);
}

TEST_F(LineOfFeedback, ItsSignIsDrawnAnewWithTheTextAndTheColours) {
  line_.announce(Feedback::good, said("Good."));
  const auto side = [this] { return sign_.pixmap().width(); };
  const int before = side();
  EXPECT_EQ(before, QFontInfo(font_).pixelSize() * 5 / 4);
  font_.setPointSizeF(40);
  line_.setFont(font_);
  EXPECT_EQ(side(), QFontInfo(font_).pixelSize() * 5 / 4);
  const QPalette light = QApplication::palette();
  QApplication::setPalette(make_palette(is_dark(light) ? light_colours() : dark_colours()));
  QCoreApplication::sendPostedEvents();
  EXPECT_EQ(sign_.pixmap().toImage(),
            sign(Icon::tick, current_colours().moss, side(), line_.devicePixelRatioF()).toImage());
  QApplication::setPalette(light);
}

TEST_F(LineOfFeedback, SpeaksAHintLaterAndAVerdictAtOnceButNeverNothing) {
  QStringList spoken;
  QObject::connect(&spoken_, &SpokenLine::spoken, &line_, [&](const QString& text) { spoken.append(text); });
  line_.announce(Feedback::good, said("Good."));
  EXPECT_EQ(spoken, QStringList{said("Good.")});
  EXPECT_EQ(text_.accessibleName(), said("Good."));
  EXPECT_EQ(line_.accessibleDescription(), said("Good."));
  line_.announce(Feedback::hint, said("Hint."));
  EXPECT_EQ(spoken.size(), 1);
  EXPECT_EQ(line_.times_spoken(), 2);
  line_.announce(Feedback::good, QString());
  EXPECT_EQ(line_.times_spoken(), 2) << "an empty line is silent";
  EXPECT_EQ(line_.sentence(), QString());
  line_.respond(Feedback::advice, said("Advice."));
  EXPECT_EQ(line_.kind(), Feedback::advice);
  EXPECT_EQ(spoken.back(), said("Advice."));
  line_.respond(Feedback::wrong, said("Advice."));
  EXPECT_EQ(line_.kind(), Feedback::wrong);
  EXPECT_EQ(line_.times_spoken(), 4);
  EXPECT_EQ(sign_.pixmap().toImage(),
            sign(Icon::cross, current_colours().vermilion, sign_.pixmap().width(), line_.devicePixelRatioF())
                .toImage());
}

TEST(LineThatIsSpoken, IsAPointThatNothingReachesButAScreenReader) {
  const SpokenLine line(nullptr, 7);
  EXPECT_EQ(line.objectName(), said("spoken_line"));
  EXPECT_EQ(line.minimumSize(), QSize(1, 1));
  EXPECT_EQ(line.maximumSize(), QSize(1, 1));
  EXPECT_TRUE(line.testAttribute(Qt::WA_TransparentForMouseEvents));
  EXPECT_EQ(line.focusPolicy(), Qt::NoFocus);
}

TEST(LineThatIsSpoken, SpeaksWhatWaitedOnceAfterTheLastOfIt) {
  SpokenLine line(nullptr, 0);
  QStringList spoken;
  QObject::connect(&line, &SpokenLine::spoken, &line, [&](const QString& text) { spoken.append(text); });
  line.speak(Urgency::queued, said("One."));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !spoken.isEmpty(); }, 20'000));
  EXPECT_EQ(line.accessibleName(), said("One."));
  for (int i = 0; i < 20; ++i) QCoreApplication::processEvents();
  EXPECT_EQ(spoken.size(), 1) << "only once";
}

/// A status line of a tablet that does not run yet, wide enough for everything.
class LineOfStatus : public testing::Test {
 protected:
  LineOfStatus() {
    // Another test may have written with a pen.
    QMouseEvent mouse(QEvent::MouseMove, QPointF(), QPointF(), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&line_, &mouse);
    line_.resize(3000, 30);
    line_.show();
    line_.show_figures(true);
  }
  QLabel& label(const char* name) { return *line_.findChild<QLabel*>(QString::fromLatin1(name)); }
  QTemporaryDir folder_;
  WindowTablet controller_;
  EventLoopInbox loop_;
  practice::TabletRecording recording_{loop_.inbox(), controller_.device(),
                                       unfinished_recordings(folder_.filePath(QStringLiteral("nazori.ini")))};
  StatusLine line_{controller_, recording_, nullptr};
};

TEST_F(LineOfStatus, ItsFiguresSayWhatTheyAreAndNeverWidenTheWindow) {
  EXPECT_EQ(line_.objectName(), said("status_line"));
  EXPECT_FALSE(line_.isSizeGripEnabled());
  EXPECT_EQ(label("rate").toolTip(), said("Force updates per second"));
  EXPECT_EQ(label("timing").toolTip(),
            said("Average time per update, longest delay of an update since the start, and longest delay of "
                 "the display in the last second"));
  EXPECT_EQ(label("missed").toolTip(), said("Updates that were late or missing since the start"));
  EXPECT_EQ(label("device").toolTip(), InputWatch::of_program().sentence({}));
  int before = -1;
  for (const char* name : {"recording", "depth", "device", "rate", "timing", "missed"}) {
    EXPECT_EQ(label(name).minimumWidth(), 1) << name;
    if (label(name).isVisible()) {
      EXPECT_GT(label(name).x(), before) << name;
      before = label(name).x();
    }
  }
}

TEST_F(LineOfStatus, AtTheStartNothingWasMeasured) {
  EXPECT_EQ(label("rate").text(), said("starting"));
  EXPECT_EQ(label("timing").text(), said("update 0.0 µs, delay 0.0 ms"));
  EXPECT_EQ(label("missed").text(), said("0 missed"));
  EXPECT_EQ(label("depth").text(), QString());
  EXPECT_FALSE(label("depth").isVisible());
  line_.show_depth(0.055);
  EXPECT_EQ(label("depth").text(), said("depth 55.0 mm"));
  line_.show_depth(-0.001);
  EXPECT_EQ(label("depth").text(), QString());
}

TEST_F(LineOfStatus, APassingMessageIsReadWholeAndTheFiguresComeBackAfterIt) {
  const QString words = said("The device you feel the tablet with, and the material of the tablet");
  const int message = line_.fontMetrics().horizontalAdvance(words);
  const auto visible = [this] {
    QStringList names;
    for (const char* name : {"depth", "device", "rate", "missed", "timing"})
      if (label(name).isVisible()) names.append(QString::fromLatin1(name));
    return names;
  };
  const QStringList all = visible();
  line_.showMessage(words);
  EXPECT_EQ(visible(), all) << "there is room for both";
  for (const int width : {message + 400, message + 40}) {
    line_.clearMessage();
    line_.resize(width, 30);
    const QStringList before = visible();
    line_.showMessage(words);
    QCoreApplication::sendPostedEvents();
    for (const QString& name : visible())
      EXPECT_GE(label(qPrintable(name)).x(), message) << width << " " << name.toStdString();
    line_.clearMessage();
    EXPECT_EQ(visible(), before) << width;
  }
  line_.showMessage(words);
  EXPECT_EQ(visible(), QStringList()) << "not even the device fits beside it";
}

TEST_F(LineOfStatus, ARecordingIsNamedWithItsSecondsWhileItRuns) {
  EXPECT_FALSE(label("recording").isVisible());
  const auto file = std::filesystem::path(folder_.path().toStdString()) / "session.nzr";
  ASSERT_TRUE(recording_.start(file, "休", {}));
  EXPECT_EQ(label("recording").text(), said("● session.nzr, 0 s"));
  EXPECT_EQ(label("recording").toolTip(),
            said("Recording pen motion to ") + QString::fromStdString(file.string()));
  EXPECT_TRUE(label("recording").isVisible());
  line_.show_figures(false);
  EXPECT_TRUE(label("recording").isVisible()) << "it is no figure";
  recording_.export_progressed("/a/table.csv", 0.5);
  EXPECT_EQ(label("recording").text(), said("● session.nzr, 0 s")) << "what runs comes first";
  ASSERT_TRUE(recording_.finish());
  EXPECT_FALSE(label("recording").isVisible());
  recording_.export_progressed("/a/table.csv", 0.97);
  EXPECT_EQ(label("recording").text(), said("Writing table.csv: 97 %"));
  EXPECT_EQ(label("recording").toolTip(), said("/a/table.csv"));
  EXPECT_FALSE(label("recording").isVisible()) << "no table is being written";
}

TEST_F(LineOfStatus, ATableThatIsWrittenIsShownUntilItIsComplete) {
  const auto file = std::filesystem::path(folder_.path().toStdString()) / "table.csv";
  ASSERT_TRUE(recording_.start(file, "休", {}));
  ASSERT_TRUE(recording_.finish());
  if (recording_.is_exporting()) {
    recording_.export_progressed(file, 0);
    EXPECT_EQ(label("recording").text(), said("Writing table.csv: 0 %"));
    EXPECT_TRUE(label("recording").isVisible());
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return !recording_.is_exporting(); }, 20'000));
  line_.show_figures(true);
  EXPECT_FALSE(label("recording").isVisible());
}

TEST_F(LineOfStatus, WhatTheServoMeasuredIsInMicrosecondsAndMilliseconds) {
  ASSERT_TRUE(controller_.start());
  controller_.move_stylus({0, 0}, true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return controller_.device().timing().ticks > 20; }, 20'000));
  controller_.lift_stylus();
  // The servo may tick once more between the two looks.
  const auto shows_it = [this] {
    controller_.device().changed();
    const auto timing = controller_.device().timing();
    const QString measured = said("update %1 µs, delay %2 ms")
                                 .arg(timing.mean_tick_s * 1e6, 0, 'f', 1)
                                 .arg(timing.max_lateness_s * 1e3, 0, 'f', 1);
    const QString missed = said("%1 missed").arg(timing.missed_ticks + timing.dropped_samples);
    return timing.mean_tick_s > 0 && label("timing").text() == measured && label("missed").text() == missed;
  };
  EXPECT_TRUE(QTest::qWaitFor(shows_it, 5'000)) << label("timing").text().toStdString();
}

TEST_F(LineOfStatus, LargerLettersPushFiguresOut) {
  const auto needed = [this] {
    int width = 8;
    for (const char* name : {"device", "rate", "missed", "timing"})
      width += label(name).sizeHint().width() + 8;
    return width;
  };
  line_.resize(needed(), 30);
  EXPECT_TRUE(label("timing").isVisible());
  QFont font = line_.font();
  font.setPointSizeF(font.pointSizeF() * 1.5);
  line_.setFont(font);
  EXPECT_TRUE(QTest::qWaitFor([this] { return !label("timing").isVisible(); }, 20'000));
  EXPECT_TRUE(label("device").isVisible());
}

}  // namespace
}  // namespace nazori::ui
