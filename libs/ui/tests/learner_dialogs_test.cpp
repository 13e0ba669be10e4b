// SPDX-License-Identifier: Apache-2.0
// What the dialogs for learners and backups list, allow and say, without a window around them.
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>
#include <QTest>
#include <QTimer>
#include <fstream>

#include "learners/anki_dialog.h"
#include "learners/backups_dialog.h"
#include "learners/exchange_progress.h"
#include "learners/learners_dialog.h"
#include "nazori/study/backups.h"
#include "nazori/study/exchange.h"
#include "nazori/study/profiles.h"
#include "session_under_test.h"
#include "study/settings_progress.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

using Format = practice::LearnerExchange::Format;

class LearnerDialogs : public SessionTest {
 protected:
  void SetUp() override { install_language(QStringLiteral("en")); }

  void write(char32_t character) {
    study::Writing writing;
    writing.result.duration = std::chrono::seconds(5);
    ASSERT_TRUE(learner_->report(learner_->store().add_writing(character, 1, writing)));
  }
  template <class T>
  static T* part(QWidget& dialog, const char* name) {
    return dialog.findChild<T*>(QString::fromLatin1(name));
  }
  static std::string words(QWidget& dialog, const char* label) {
    return part<QLabel>(dialog, label)->text().toStdString();
  }
  /// An exchange of the learner with its dialog.
  struct Exchange : practice::LearnerExchange {
    explicit Exchange(LearnerDialogs& test)
        : LearnerExchange(test.inbox_.inbox(), *test.learner_), progress(*this, &test.window_) {
      QObject::connect(&progress, &ExchangeProgress::announced, &test.window_,
                       [&test](Feedback kind, const QString& sentence) {
                         test.kind_ = kind;
                         test.told_ = sentence;
                       });
    }
    ExchangeProgress progress;
  };
  void wait_for(const Exchange& exchange) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !exchange.is_busy(); }, 20'000));
  }
  [[nodiscard]] std::filesystem::path path(const char* name) const {
    return folder_.filePath(QString::fromUtf8(name)).toStdString();
  }

  QWidget window_;
  Feedback kind_ = Feedback::hint;
  QString told_;
};

class LearnersList : public LearnerDialogs {
 protected:
  LearnersList() {
    QObject::connect(&dialog_, &LearnersDialog::announced, &window_,
                     [this](Feedback, const QString& sentence) { told_ = sentence; });
  }
  QStringList names() {
    QStringList all;
    for (int row = 0; row < list_->count(); ++row) all.append(list_->item(row)->text());
    return all;
  }
  void type(const char* name) { name_->setText(QString::fromUtf8(name)); }
  void press(const char* button) { part<QPushButton>(dialog_, button)->click(); }
  std::string says() { return words(dialog_, "learners_words"); }
  void choose(const char* name) {
    for (int row = 0; row < list_->count(); ++row)
      if (list_->item(row)->data(Qt::UserRole).toString() == QString::fromUtf8(name))
        list_->setCurrentRow(row);
  }
  LearnersDialog dialog_{*learner_, &window_};
  QListWidget* list_ = part<QListWidget>(dialog_, "learners_list");
  QLineEdit* name_ = part<QLineEdit>(dialog_, "learner_name");
};

TEST_F(LearnersList, TheCurrentLearnerIsMarkedAndAllAreListed) {
  EXPECT_EQ(says(), "Each learner has their own study history, settings and backups.");
  EXPECT_EQ(names(), QStringList{QStringLiteral("✓ learner (current)")});
  EXPECT_EQ(list_->currentRow(), 0);
  type(" Mari ");
  press("learner_add");
  EXPECT_EQ(says(), "Now studying as Mari.");
  EXPECT_EQ(told_, QStringLiteral("Now studying as Mari."));
  EXPECT_TRUE(name_->text().isEmpty());
  EXPECT_EQ(names().size(), 2);
  EXPECT_TRUE(names().contains(QStringLiteral("✓ Mari (current)")));
  EXPECT_TRUE(names().contains(QStringLiteral("learner")));
  EXPECT_EQ(list_->currentItem()->data(Qt::UserRole).toString(), QStringLiteral("Mari"));
}

TEST_F(LearnersList, ChoosingSwitchesAndClosesIt) {
  ASSERT_TRUE(learner_->switch_profile("Mari"));
  LearnersDialog dialog(*learner_, &window_);
  QSignalSpy said(&dialog, &LearnersDialog::announced);
  auto* list = part<QListWidget>(dialog, "learners_list");
  QSignalSpy closed(&dialog, &QDialog::accepted);
  emit list->itemActivated(list->currentItem());
  EXPECT_EQ(closed.count(), 1);
  EXPECT_EQ(said.count(), 0) << "it is who studies already";
  for (int row = 0; row < list->count(); ++row)
    if (list->item(row)->data(Qt::UserRole) == QStringLiteral("learner")) list->setCurrentRow(row);
  part<QPushButton>(dialog, "learner_choose")->click();
  EXPECT_EQ(closed.count(), 2);
  ASSERT_EQ(said.count(), 1);
  EXPECT_EQ(said.at(0).at(1).toString(), QStringLiteral("Now studying as learner."));
}

TEST_F(LearnersList, ANameThatCanBeNoneOrIsTakenIsExplained) {
  for (const char* name : {"", "  ", ".x", "a/b"})
    for (const char* button : {"learner_add", "learner_rename"}) {
      type(name);
      press(button);
      EXPECT_EQ(says(),
                "Type a name first: at most 60 letters (20 in Japanese), no “/”, and no dot at the start.");
    }
  type("learner");
  press("learner_add");
  EXPECT_EQ(says(), "learner already exists. Type another name.");
  press("learner_rename");
  EXPECT_EQ(says(), "learner already exists. Type another name.");
  EXPECT_EQ(learner_->profile(), "learner");
}

TEST_F(LearnersList, AnotherLearnerIsRenamedWithoutASwitch) {
  write(U'一');
  ASSERT_TRUE(learner_->switch_profile("Mari"));
  type("x");
  press("learner_add");
  choose("learner");
  type("Aiko");
  press("learner_rename");
  EXPECT_EQ(says(), "Renamed learner to Aiko.");
  EXPECT_TRUE(name_->text().isEmpty());
  EXPECT_EQ(learner_->profile(), "x");
  const auto all = study::profiles(learner_->folder());
  EXPECT_NE(std::find(all.begin(), all.end(), "Aiko"), all.end());
  EXPECT_EQ(std::find(all.begin(), all.end(), "learner"), all.end());
}

TEST_F(LearnersList, RemovingAsksAndSaysWhereTheFolderLies) {
  write(U'一');
  ASSERT_TRUE(learner_->switch_profile("Mari"));
  type("x");
  press("learner_add");
  choose("Mari");
  for (const bool yes : {false, true}) {
    QTimer::singleShot(0, &dialog_, [yes] {
      auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(question, nullptr);
      EXPECT_EQ(question->objectName(), QStringLiteral("learner_remove_question"));
      EXPECT_EQ(question->text(),
                QStringLiteral(
                    "Remove Mari, with all reviews, handwriting and backups, from the list of learners?"));
      EXPECT_TRUE(question->informativeText().startsWith(QStringLiteral("Nothing is deleted")));
      EXPECT_EQ(question->defaultButton(), question->button(QMessageBox::Cancel));
      if (!yes) return question->reject();
      for (auto* button : question->buttons())
        if (button->objectName() == QStringLiteral("learner_remove_yes")) button->click();
    });
    press("learner_remove");
  }
  EXPECT_EQ(says(), "Removed Mari. The folder is now in " +
                        (learner_->folder() / ".removed" / "Mari").string() + ".");
  EXPECT_EQ(learner_->profile(), "x") << "who studies goes on";
  EXPECT_EQ(names().size(), 2);
}

class BackupsList : public LearnerDialogs {
 protected:
  void put(const char* name, bool sound) {
    const auto folder = study::backup_folder(learner_->file());
    std::filesystem::create_directories(folder);
    if (sound)
      ASSERT_TRUE(learner_->store().copy_to(folder / name));
    else
      std::ofstream(folder / name) << "do nothing";
  }
};

TEST_F(BackupsList, EachHasItsKindAndWhatItHolds) {
  ASSERT_TRUE(QTest::qWaitFor([&] { return !learner_->keeps_up(); }, 20'000));
  std::filesystem::remove_all(study::backup_folder(learner_->file()));
  write(U'一');
  write(U'二');
  put("daily-2026-02-01.db", true);
  put("own-2026-02-02-100000.db", true);
  put("before-restore-2026-02-03-100000.db", true);
  put("daily-2026-01-31.db", false);
  Exchange exchange(*this);
  BackupsDialog dialog(inbox_.inbox(), *learner_, exchange, exchange.progress, &window_);
  EXPECT_EQ(dialog.windowTitle(), QStringLiteral("Backups of learner"));
  auto* table = part<QTableWidget>(dialog, "backups_table");
  const auto listed = study::backups_of(learner_->file());
  ASSERT_EQ(table->rowCount(), static_cast<int>(listed.size()));
  EXPECT_EQ(table->currentRow(), 0);
  EXPECT_FALSE(part<QPushButton>(dialog, "backup_restore")->isEnabled()) << "not read yet";
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        for (int row = 0; row < table->rowCount(); ++row)
          if (table->item(row, 1)->text() == QStringLiteral("…")) return false;
        return true;
      },
      20'000));
  QStringList rows;
  for (int row = 0; row < table->rowCount(); ++row)
    rows.append(table->item(row, 3)->data(Qt::AccessibleTextRole).toString());
  rows.sort();
  EXPECT_EQ(
      rows,
      (QStringList{
          QStringLiteral("Daily (1 Feb 2026), last study day 2 Mar 2026, times written: 2, characters: 2"),
          QStringLiteral(
              "Daily (31 Jan 2026), last study day cannot be used, times written: –, characters: –"),
          QStringLiteral("Made by you, last study day 2 Mar 2026, times written: 2, characters: 2"),
          QStringLiteral(
              "Saved before a restore, last study day 2 Mar 2026, times written: 2, characters: 2")}));
  for (int row = 0; row < table->rowCount(); ++row) {
    table->setCurrentCell(row, 0);
    EXPECT_EQ(part<QPushButton>(dialog, "backup_restore")->isEnabled(),
              table->item(row, 1)->text() != QStringLiteral("cannot be used"));
  }
  EXPECT_TRUE(words(dialog, "backups_words")
                  .starts_with("One is made by itself on each day of study; seven are kept."));
  part<QPushButton>(dialog, "backup_now")->click();
  wait_for(exchange);
  EXPECT_TRUE(words(dialog, "backups_words").starts_with("Backed up as own-"));
  EXPECT_EQ(table->rowCount(), 5);
}

TEST_F(BackupsList, WithoutAnyItSaysWhenOneIsMade) {
  ASSERT_TRUE(QTest::qWaitFor([&] { return !learner_->keeps_up(); }, 20'000));
  std::filesystem::remove_all(study::backup_folder(learner_->file()));
  Exchange exchange(*this);
  BackupsDialog dialog(inbox_.inbox(), *learner_, exchange, exchange.progress, &window_);
  EXPECT_TRUE(words(dialog, "backups_words").starts_with("No backups yet."));
  EXPECT_FALSE(part<QPushButton>(dialog, "backup_restore")->isEnabled());
}

TEST_F(LearnerDialogs, OneThingAtATimeIsWrittenOrRead) {
  write(U'一');
  Exchange exchange(*this);
  int finished = 0;
  exchange.finished.connect([&finished] { ++finished; });
  const QString first = folder_.filePath(QStringLiteral("a.json"));
  exchange.write(Format::json, path("a.json"));
  EXPECT_TRUE(exchange.is_busy());
  const QString busy =
      QStringLiteral("An export, import or backup is already running. Wait for it or stop it.");
  for (const auto& again : std::initializer_list<std::function<void()>>{
           [&] { exchange.write(Format::csv, path("b.csv")); }, [&] { exchange.read(path("a.json")); },
           [&] { exchange.back_up(); }, [&] { exchange.restore("x"); }}) {
    told_.clear();
    again();
    EXPECT_EQ(told_, busy);
    EXPECT_EQ(kind_, Feedback::advice);
  }
  wait_for(exchange);
  EXPECT_EQ(finished, 1);
  EXPECT_EQ(told_, QStringLiteral("Saved as %1.").arg(first));
  EXPECT_EQ(kind_, Feedback::good);
  EXPECT_FALSE(QFile::exists(folder_.filePath(QStringLiteral("b.csv"))));
}

TEST_F(LearnerDialogs, WhatFailsIsNamedWithItsFile) {
  write(U'一');
  Exchange exchange(*this);
  for (const auto kind : {Format::json, Format::csv, Format::anki}) {
    exchange.write(kind, path("no/such/folder/a.x"));
    wait_for(exchange);
    EXPECT_EQ(kind_, Feedback::wrong);
    EXPECT_TRUE(told_.startsWith(QStringLiteral("a.x: "))) << told_.toStdString();
    EXPECT_TRUE(told_.endsWith(QStringLiteral(". Nothing was changed."))) << told_.toStdString();
  }
  exchange.read(path("none.json"));
  wait_for(exchange);
  EXPECT_TRUE(told_.startsWith(QStringLiteral("none.json: "))) << told_.toStdString();
  exchange.restore(path("none.db"));
  wait_for(exchange);
  EXPECT_TRUE(told_.startsWith(QStringLiteral("The backup could not be restored: "))) << told_.toStdString();
  EXPECT_TRUE(learner_->can_write());
  EXPECT_TRUE(learner_->store().cards().contains(U'一'));
}

TEST_F(LearnerDialogs, AnImportSaysForWhomAndHowMuch) {
  write(U'一');
  write(U'二');
  Exchange exchange(*this);
  const std::filesystem::path file = path("..Mari.json");
  exchange.write(Format::json, file);
  wait_for(exchange);
  exchange.read(file);
  wait_for(exchange);
  EXPECT_EQ(told_, QStringLiteral("Imported 2 characters for learner 2. Now studying as learner 2."))
      << "the name of the file can be none";
  ASSERT_TRUE(learner_->switch_profile("noted"));
  ASSERT_TRUE(learner_->store().save_list({"mine", {U'一'}}));
  exchange.read(file);
  wait_for(exchange);
  EXPECT_EQ(learner_->profile(), "learner 3") << "a list is something to keep";
}

TEST_F(LearnerDialogs, WhatCannotBeBackedUpIsExplained) {
  ASSERT_TRUE(learner_->switch_profile("fresh"));
  Exchange exchange(*this);
  exchange.back_up();
  EXPECT_EQ(told_, QStringLiteral("Nothing studied yet, so there is nothing to back up."));
  EXPECT_EQ(kind_, Feedback::advice);
  learner_->let_go(practice::LearnerEvent::Kind::replacing);
  exchange.back_up();
  EXPECT_EQ(told_, replaced().replace(QStringLiteral("learner"), QStringLiteral("fresh")));
  EXPECT_EQ(kind_, Feedback::wrong);
  EXPECT_FALSE(exchange.is_busy());
}

TEST_F(LearnerDialogs, AnAnkiPackageIsOfWhatWasMetWithUpToTwentyWords) {
  write(U'一');
  AnkiDialog dialog(learner_->store(), &window_);
  EXPECT_EQ(dialog.choice().list, "");
  EXPECT_EQ(dialog.choice().deck, "Nazori");
  auto* count = part<QSpinBox>(dialog, "anki_words");
  EXPECT_EQ(count->minimum(), 0);
  EXPECT_EQ(count->maximum(), 20);
  count->setValue(7);
  part<QLineEdit>(dialog, "anki_deck")->setText(QStringLiteral("  Mine "));
  EXPECT_EQ(dialog.choice().words, 7);
  EXPECT_EQ(dialog.choice().deck, "Mine");
  part<QLineEdit>(dialog, "anki_deck")->setText(QString(60, QLatin1Char('x')));
  EXPECT_EQ(dialog.choice().deck.size(), 40);
}

TEST_F(LearnerDialogs, SettingsThatChangeEveryCharacterAreWorkedOutBehindTheWindow) {
  write(U'一');
  auto wanted = learner_->store().settings();
  wanted.new_per_day = 3;
  EXPECT_FALSE(practice::SettingsChange::takes_long(learner_->store(), wanted));
  wanted.fsrs.weights.front() = 0.5;
  EXPECT_FALSE(practice::SettingsChange::takes_long(learner_->store(), wanted)) << "of one writing";
  practice::SettingsChange change(inbox_.inbox(), *learner_);
  const auto begin = [&] {
    auto* progress = new SettingsProgress(change, wanted, &window_);
    QObject::connect(progress, &SettingsProgress::announced, &window_,
                     [this](Feedback kind, const QString& sentence) {
                       kind_ = kind;
                       told_ = sentence;
                     });
  };
  begin();
  EXPECT_FALSE(learner_->can_write());
  EXPECT_EQ(LearnerWords::sentence(learner_->trouble()),
            QStringLiteral(
                "Every character of learner is being worked out anew. Nothing is kept until that is done."));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !told_.isEmpty(); }, 20'000));
  EXPECT_EQ(told_, QStringLiteral("Settings saved."));
  EXPECT_EQ(kind_, Feedback::good);
  EXPECT_TRUE(learner_->can_write());
  EXPECT_EQ(learner_->store().settings(), wanted);
  told_.clear();
  wanted.new_per_day = 5000;
  begin();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !told_.isEmpty(); }, 20'000));
  EXPECT_EQ(kind_, Feedback::wrong);
  EXPECT_TRUE(told_.startsWith(QStringLiteral("The study settings were not kept: "))) << told_.toStdString();
  EXPECT_EQ(learner_->store().settings().new_per_day, 3);
}

}  // namespace
}  // namespace nazori::ui
