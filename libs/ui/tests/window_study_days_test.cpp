// SPDX-License-Identifier: Apache-2.0
// Study over many days: coming back, undo of other days, backups, a second window, settings and lists.
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <functional>
#include <map>

#include "nazori/study/backups.h"
#include "study_under_test.h"

namespace nazori::ui {
namespace {

using study::Rating;
using StudyDays = StudyTest;

TEST_F(StudyDays, UndoFromHomeTakesBackReviewsOfOtherDaysToo) {
  start();
  learn();
  press(Qt::Key_4);
  ASSERT_EQ(reviews_in_log(), 1);
  now_ += std::chrono::days(1);
  open_home();
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(feedback().contains(QStringLiteral("Undone: the last entry for 一")))
      << feedback().toStdString();
  EXPECT_EQ(reviews_in_log(), 0);
  EXPECT_EQ(store().card(U'一').next_stage, study::Stage::memory);
}

TEST_F(StudyDays, ASecondWindowIsToldAndChangesNothing) {
  start();
  learn();
  press(Qt::Key_4);
  MainWindow::Setup second_setup = setup();
  second_setup.settings_file = folder_.filePath(QStringLiteral("second.ini"));
  WindowParts* const first_parts = the_parts;
  Characters* const first_characters = the_characters;
  {
    MainWindow second(second_setup, appearance_);
    second.show();
    const auto* trouble = second.findChild<QLabel*>(QStringLiteral("home_trouble"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return trouble->isVisible(); }));
    EXPECT_TRUE(trouble->text().contains(QStringLiteral("another Nazori window")))
        << trouble->text().toStdString();
    EXPECT_FALSE(second.findChild<QPushButton*>(QStringLiteral("home_start"))->isVisible());
    EXPECT_TRUE(second.findChild<QPushButton*>(QStringLiteral("home_try_again"))->isVisible());
    EXPECT_EQ(the_parts->learner().store().card(U'一').memory.reps, 1) << "reading is possible";
  }
  the_parts = first_parts;
  the_characters = first_characters;
  EXPECT_TRUE(the_parts->learner().can_write());
}

TEST_F(StudyDays, ABackupThatFailedStaysSaidAtHome) {
  window_.reset();
  const auto backups = learner_file().parent_path() / "backups";
  std::filesystem::remove_all(backups);
  std::filesystem::copy_file(learner_file(), backups);
  open_home();
  ASSERT_TRUE(QTest::qWaitFor([this] { return find("home_trouble")->isVisible(); }, 20'000));
  EXPECT_TRUE(text("home_trouble").startsWith(QStringLiteral("Today's backup failed")));
  EXPECT_TRUE(find("home_trouble")->isVisible());
  EXPECT_TRUE(find<QPushButton>("home_start")->isVisible()) << "studying works";
  emit the_parts->learner().changed();
  EXPECT_TRUE(find("home_trouble")->isVisible());
  window_.reset();
  std::filesystem::remove(backups);
  open_home();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !study::backups_of(learner_file()).empty(); }, 20'000));
  EXPECT_FALSE(find("home_trouble")->isVisible());
}

TEST_F(StudyDays, AWindowThatStaysOpenOverMidnightBacksUpEachDayOnce) {
  const auto backups = [this] { return study::backups_of(learner_file()).size(); };
  const auto look = [] {
    the_parts->learner().tick();
    return QTest::qWaitFor([] { return !the_parts->learner().keeps_up(); }, 20'000);
  };
  ASSERT_TRUE(look());
  ASSERT_EQ(backups(), 1U);
  now_ += std::chrono::days(1);
  ASSERT_TRUE(look());
  EXPECT_EQ(backups(), 2U);
  now_ += std::chrono::hours(1);
  ASSERT_TRUE(look());
  EXPECT_EQ(backups(), 2U);
}

TEST_F(StudyDays, AfterAMonthAwayThereIsAPlanAndNoWall) {
  start();
  learn();
  press(Qt::Key_4);
  auto settings = store().settings();
  settings.reviews_per_day = 1;
  settings.new_per_day = 4;
  ASSERT_TRUE(store().change_settings(settings));
  for (const char32_t character : {U'二', U'十', U'人'}) {
    study::Writing writing;
    writing.rating = Rating::easy;
    ASSERT_TRUE(store().add_writing(character, 2, writing));
  }
  now_ += std::chrono::days(40);
  open_home();
  EXPECT_TRUE(find("home_start")->accessibleName().startsWith(QStringLiteral("Start: 1 review ·")));
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("4 reviews are waiting")))
      << text("home_advice").toStdString();
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("4 days")));
}

TEST_F(StudyDays, AWeekThroughTheWindowAndAMonthAwayLoseNothingThatWasRatedWhateverEndsThem) {
  int rated = 0;
  std::map<char32_t, int> seen;
  for (int day = 0; day < 7; ++day) {
    now_ = *study::parse_time("2026-03-02T10:00Z") + std::chrono::days(day);
    open_home();
    ASSERT_EQ(reviews_in_log(), rated) << "day " << day;
    ASSERT_TRUE(find<QPushButton>("home_start")->isVisible()) << "day " << day;
    shown_character_ = 0;
    start();
    int steps = 0;
    while (session().is_running() && ++steps < 60) {
      ASSERT_TRUE(is_shown());
      const char32_t character = session().character();
      if (session().stage() == study::Stage::memory) {
        // On the fourth day one is forgotten.
        write_from_memory(!(day == 3 && steps == 1));
        ASSERT_FALSE(HasFatalFailure());
        ++seen[character];
        ++rated;
        shown_character_ = 0;
        press(Qt::Key_Return);
        if (session().is_running() && session().character() == character &&
            session().stage() != study::Stage::memory)
          shown_character_ = character;
      } else {
        do_stage();
        ASSERT_FALSE(HasFatalFailure()) << "day " << day << ", step " << steps;
        go_on();
      }
      // On the third day the window is closed in the middle of a stage.
      if (day == 2 && rated > 0 && steps == 2) break;
    }
    if (day != 2) {
      EXPECT_FALSE(session().is_running());
      EXPECT_TRUE(find("home_page")->isVisible());
    }
    window_.reset();
  }
  open_home();
  EXPECT_EQ(reviews_in_log(), rated);
  EXPECT_EQ(seen.size(), 7U) << "one new a day";
  EXPECT_TRUE(text("home_day").endsWith(QStringLiteral("7 days in a row"))) << text("home_day").toStdString();
  const auto rebuilt = store().rebuild();
  ASSERT_TRUE(rebuilt);
  EXPECT_EQ(rebuilt->differences, 0);

  // Six weeks later, with a limit of four reviews a day, half of the limit is asked on the first day.
  auto settings = store().settings();
  settings.reviews_per_day = 4;
  settings.new_per_day = 2;
  ASSERT_TRUE(store().change_settings(settings));
  now_ = *study::parse_time("2026-04-20T10:00Z");
  open_home();
  EXPECT_TRUE(find("home_start")->accessibleName().startsWith(QStringLiteral("Start: 2 reviews ·")));
  EXPECT_FALSE(text("home_day").contains(QStringLiteral("in a row")));
  // The seven reviews are spread over three days: two, three and two.
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("7 reviews are waiting. No hurry: do 2 today")))
      << text("home_advice").toStdString();
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("You will catch up in 3 days")))
      << text("home_advice").toStdString();
  shown_character_ = 0;
  start();
  for (int review = 0; review < 2; ++review) {
    ASSERT_TRUE(session().is_running());
    ASSERT_TRUE(is_shown());
    EXPECT_EQ(session().task().kind, study::TaskKind::review);
    write_from_memory(true);
    ASSERT_FALSE(HasFatalFailure());
    ++rated;
    shown_character_ = 0;
    press(Qt::Key_Return);
  }
  EXPECT_FALSE(session().is_running());
  EXPECT_EQ(text("home_written"), QStringLiteral("2 written, 2 right · less than a minute"));
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("you have reached your daily limit")))
      << text("home_advice").toStdString();
  EXPECT_EQ(reviews_in_log(), rated);

  // Every one of them can be taken back, to the first.
  int taken_back = 0;
  while (reviews_in_log() > 0 && taken_back < 500) {
    press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    ++taken_back;
  }
  EXPECT_GE(taken_back, rated);
}

/// Does something with a modal dialog as soon as it is there.
void with_dialog(const char* name, const std::function<void(QWidget*)>& what) {
  auto* timer = new QTimer;
  timer->setInterval(20);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, name, what] {
    auto* dialog = QApplication::activeModalWidget();
    if (dialog == nullptr || dialog->objectName() != QString::fromLatin1(name)) return;
    timer->deleteLater();
    timer->stop();
    what(dialog);
  });
  timer->start();
}

TEST_F(StudyDays, SettingsAreChosenInTheWindowAndHoldAtOnce) {
  with_dialog("study_settings_dialog", [](QWidget* dialog) {
    dialog->findChild<QSpinBox*>(QStringLiteral("study_new"))->setValue(3);
    dialog->findChild<QSpinBox*>(QStringLiteral("study_reviews"))->setValue(40);
    auto* order = dialog->findChild<QComboBox*>(QStringLiteral("study_order"));
    order->setCurrentIndex(order->findData(static_cast<int>(study::NewOrder::strokes)));
    const auto* workload = dialog->findChild<QLabel*>(QStringLiteral("study_workload"));
    EXPECT_TRUE(workload->text().contains(QStringLiteral("3 new characters a day")))
        << workload->text().toStdString();
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  });
  press(Qt::Key_Comma, Qt::ControlModifier);
  EXPECT_EQ(store().settings().new_per_day, 3);
  EXPECT_EQ(store().settings().reviews_per_day, 40);
  EXPECT_EQ(store().settings().new_order, study::NewOrder::strokes);
  EXPECT_TRUE(find("home_start")->accessibleName().startsWith(QStringLiteral("Start: 3 new characters ·")));
}

TEST_F(StudyDays, AListFromTextIsTakenAndABadLineRefusedWithItsNumber) {
  with_dialog("study_settings_dialog", [](QWidget* dialog) {
    with_dialog("new_list_dialog", [](QWidget* list) {
      list->findChild<QLineEdit*>(QStringLiteral("new_list_name"))->setText(QStringLiteral("week"));
      auto* words = list->findChild<QPlainTextEdit*>(QStringLiteral("new_list_text"));
      words->setPlainText(QStringLiteral("月火水\n월木"));
      list->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
      const auto* trouble = list->findChild<QLabel*>(QStringLiteral("new_list_trouble"));
      EXPECT_TRUE(trouble->text().contains(QLatin1Char('2'))) << trouble->text().toStdString();
      words->setPlainText(QStringLiteral("月火水 # three days\n木"));
      list->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    });
    dialog->findChild<QPushButton*>(QStringLiteral("list_new"))->click();
    auto* lists = dialog->findChild<QListWidget*>(QStringLiteral("study_lists"));
    EXPECT_EQ(lists->currentItem()->text(), QStringLiteral("My list: week"));
    EXPECT_EQ(lists->currentItem()->checkState(), Qt::Checked);
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  });
  press(Qt::Key_Comma, Qt::ControlModifier);
  EXPECT_EQ(store().settings().new_lists, (std::vector<std::string>{"list:few", "list:week"}));
}

TEST_F(StudyDays, ALeftHandedLayoutChangesSides) {
  press(Qt::Key_2, Qt::AltModifier);
  ASSERT_TRUE(QTest::qWaitFor([&] { return shown_character_ != 0; }, 20000));
  const auto x_of = [this](const char* name) { return find(name)->mapTo(window_.get(), QPoint()).x(); };
  EXPECT_LT(x_of("library_panel"), x_of("information_panel"));
  press(Qt::Key_F, Qt::ControlModifier | Qt::AltModifier);
  QCoreApplication::processEvents();
  EXPECT_TRUE(the_parts->preferences().left_handed);
  EXPECT_GT(x_of("library_panel"), x_of("information_panel"));
  EXPECT_GE(find("tablet")->width(), 639);
  ASSERT_TRUE(session().start());
  ASSERT_TRUE(QTest::qWaitFor([&] { return find("session_next")->isVisible(); }, 20000));
  QCoreApplication::processEvents();
  EXPECT_LT(x_of("session_next"), find("tablet")->mapTo(window_.get(), QPoint()).x() + 100)
      << "near the left hand";
  press(Qt::Key_F, Qt::ControlModifier | Qt::AltModifier);
  QCoreApplication::processEvents();
  EXPECT_GT(x_of("session_next"), 700);
}

}  // namespace
}  // namespace nazori::ui
