// SPDX-License-Identifier: Apache-2.0
#include <SQLiteCpp/SQLiteCpp.h>

#include <QApplication>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>

#include "characters/characters.h"
#include "learners/anki_dialog.h"
#include "learners/backups_dialog.h"
#include "learners/exchange_progress.h"
#include "learners/learner_menu.h"
#include "learners/learners_dialog.h"
#include "nazori/practice/list_members.h"
#include "nazori/study/backups.h"
#include "nazori/study/exchange.h"
#include "nazori/study/profiles.h"
#include "nazori/widgets/controls/list_choice.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/learner_words.h"
#include "study/study_dialogs.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

using Format = practice::LearnerExchange::Format;

WindowParts* the_parts = nullptr;

std::unique_ptr<Page> make_characters(WindowParts& parts) {
  the_parts = &parts;
  return std::make_unique<Characters>(parts);
}

class LearnersTest : public WindowTest {
 protected:
  LearnersTest() {
    pages_ = {make_characters};
    clock_ = [] { return *study::parse_time("2026-03-01T09:00:00Z"); };
  }

  [[nodiscard]] practice::Learner& learner() const { return the_parts->learner(); }
  [[nodiscard]] std::vector<std::string> names() const { return study::profiles(learner().folder()); }

  void write(char32_t character) {
    study::Writing writing;
    writing.result.duration = std::chrono::seconds(5);
    ASSERT_TRUE(learner().report(learner().store().add_writing(character, 1, writing)));
  }

  template <class T>
  static T* part(QWidget& dialog, const char* name) {
    return dialog.findChild<T*>(QString::fromLatin1(name));
  }
  /// Presses a button that opens a question, and answers it.
  static void answer(QPushButton* button, const char* yes) {
    QTimer::singleShot(0, button, [yes] {
      auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(question, nullptr);
      for (auto* one : question->buttons())
        if (yes == nullptr ? question->standardButton(one) == QMessageBox::Cancel
                           : one->objectName() == QLatin1String(yes))
          one->click();
    });
    button->click();
  }
  /// An exchange of the learner with its dialog.
  struct Exchange : practice::LearnerExchange {
    explicit Exchange(QWidget* window)
        : LearnerExchange(the_parts->inbox(), the_parts->learner()), progress(*this, window) {}
    ExchangeProgress progress;
  };
  void wait_for(const Exchange& exchange) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !exchange.is_busy(); }, 20'000));
  }
};

TEST_F(LearnersTest, ALearnerIsAddedChosenAndRemembered) {
  write(U'一');
  {
    LearnersDialog dialog(learner(), window_.get());
    part<QLineEdit>(dialog, "learner_name")->setText(QStringLiteral("花子"));
    part<QPushButton>(dialog, "learner_add")->click();
    EXPECT_EQ(learner().profile(), "花子");
    EXPECT_TRUE(learner().store().cards().empty());
    auto* list = part<QListWidget>(dialog, "learners_list");
    ASSERT_EQ(list->count(), 2);
    EXPECT_EQ(list->currentItem()->data(Qt::UserRole).toString(), QStringLiteral("花子"));
  }
  window_->close();
  open_window();
  EXPECT_EQ(learner().profile(), "花子");
  LearnersDialog dialog(learner(), window_.get());
  auto* list = part<QListWidget>(dialog, "learners_list");
  for (int row = 0; row < list->count(); ++row)
    if (list->item(row)->data(Qt::UserRole) == QStringLiteral("learner")) list->setCurrentRow(row);
  part<QPushButton>(dialog, "learner_choose")->click();
  EXPECT_EQ(learner().profile(), "learner");
  EXPECT_TRUE(learner().store().cards().contains(U'一'));
}

TEST_F(LearnersTest, ANameThatIsTakenOrCanBeNoneIsRefusedInWords) {
  write(U'一');
  LearnersDialog dialog(learner(), window_.get());
  for (const char* name : {"", ".hidden", "a/b", "learner"}) {
    part<QLineEdit>(dialog, "learner_name")->setText(QString::fromLatin1(name));
    part<QPushButton>(dialog, "learner_add")->click();
    EXPECT_FALSE(part<QLabel>(dialog, "learners_words")->text().isEmpty());
    EXPECT_EQ(learner().profile(), "learner") << name;
  }
  EXPECT_EQ(names().size(), 1U);
}

TEST_F(LearnersTest, TheLearnerAtHandKeepsEverythingUnderAnotherName) {
  write(U'一');
  LearnersDialog dialog(learner(), window_.get());
  part<QLineEdit>(dialog, "learner_name")->setText(QStringLiteral("Mari"));
  part<QPushButton>(dialog, "learner_rename")->click();
  EXPECT_EQ(learner().profile(), "Mari");
  EXPECT_TRUE(learner().can_write());
  EXPECT_TRUE(learner().store().cards().contains(U'一'));
  EXPECT_EQ(names(), std::vector<std::string>{"Mari"});
}

TEST_F(LearnersTest, ARemovedLearnerIsMovedAsideAfterAQuestion) {
  write(U'一');
  ASSERT_TRUE(learner().switch_profile("Mari"));
  write(U'二');
  LearnersDialog dialog(learner(), window_.get());
  answer(part<QPushButton>(dialog, "learner_remove"), nullptr);
  EXPECT_EQ(names().size(), 2U);
  answer(part<QPushButton>(dialog, "learner_remove"), "learner_remove_yes");
  EXPECT_EQ(names(), std::vector<std::string>{"learner"});
  EXPECT_EQ(learner().profile(), "learner");
  EXPECT_TRUE(learner().store().cards().contains(U'一'));
  EXPECT_TRUE(std::filesystem::exists(learner().folder() / ".removed" / "Mari" / "learner.db"));
}

TEST_F(LearnersTest, ABackupIsMadeListedAndRestored) {
  write(U'一');
  action("back_up")->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return feedback().startsWith(QStringLiteral("Backed up as")); }, 20'000))
      << feedback().toStdString();
  write(U'二');
  Exchange exchange(window_.get());
  BackupsDialog dialog(the_parts->inbox(), learner(), exchange, exchange.progress, window_.get());
  auto* table = part<QTableWidget>(dialog, "backups_table");
  ASSERT_EQ(table->rowCount(), 1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return table->item(0, 2)->text() == QStringLiteral("1"); }, 20'000));
  EXPECT_EQ(table->item(0, 1)->text(), QStringLiteral("1 Mar 2026"));
  table->setCurrentCell(0, 0);
  answer(part<QPushButton>(dialog, "backup_restore"), nullptr);
  EXPECT_TRUE(learner().store().cards().contains(U'二'));
  answer(part<QPushButton>(dialog, "backup_restore"), "backup_yes");
  // The window does not wait, and meanwhile says why nothing is saved.
  EXPECT_TRUE(exchange.is_busy());
  EXPECT_FALSE(learner().can_write());
  EXPECT_TRUE(learner().trouble());
  wait_for(exchange);
  EXPECT_TRUE(learner().can_write());
  EXPECT_TRUE(learner().store().cards().contains(U'一'));
  EXPECT_FALSE(learner().store().cards().contains(U'二'));
  // The replaced store is a backup now, with both characters.
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        for (int row = 0; row < table->rowCount(); ++row)
          if (table->item(row, 2)->text() == QStringLiteral("2")) return true;
        return false;
      },
      20'000));
}

TEST_F(LearnersTest, AWindowClosedWhileABackupIsRestoredLeavesAWholeStore) {
  write(U'一');
  const auto backup = study::make_backup(learner().store(), learner().file());
  ASSERT_TRUE(backup);
  write(U'二');
  const auto file = learner().file();
  for (int round = 0; round < 20; ++round) {
    {
      Exchange exchange(window_.get());
      exchange.restore(*backup);
      QTest::qWait(round / 4);
    }
    // If the backup was restored by then, the window has opened it. let_go() closes it too.
    learner().let_go(practice::LearnerEvent::Kind::replacing);
    const auto store = study::LearnerStore::open(file, study::Access::write);
    ASSERT_TRUE(store) << base::to_line(store.error());
    // Either the old store or the backup, nothing else.
    EXPECT_EQ(store->last_entry(), store->cards().contains(U'二') ? 2 : 1);
    EXPECT_TRUE(store->cards().contains(U'一'));
  }
}

TEST_F(LearnersTest, ABackupThatFailedStaysSaidUntilOneIsMade) {
  write(U'一');
  const auto backups = study::backup_folder(learner().file());
  std::filesystem::remove_all(backups);
  QFile in_the_way(QString::fromStdString(backups.string()));
  ASSERT_TRUE(in_the_way.open(QIODevice::WriteOnly));
  in_the_way.close();
  ASSERT_TRUE(learner().open_again());
  ASSERT_TRUE(QTest::qWaitFor([this] { return learner().backup_trouble().has_value(); }, 20'000));
  EXPECT_TRUE(
      LearnerWords::sentence(learner().backup_trouble()).startsWith(QStringLiteral("Today's backup failed")));
  write(U'二');
  EXPECT_TRUE(learner().backup_trouble());
  EXPECT_FALSE(learner().trouble()) << "studying works";
  ASSERT_TRUE(in_the_way.remove());
  ASSERT_TRUE(learner().open_again());
  ASSERT_TRUE(QTest::qWaitFor([this] { return !study::backups_of(learner().file()).empty(); }, 20'000));
  EXPECT_FALSE(learner().backup_trouble());
}

TEST_F(LearnersTest, TagsThatCannotBeReadAreNotReplacedByNone) {
  write(U'一');
  const std::vector<std::string> tags{"exam"};
  ASSERT_TRUE(learner().report(learner().store().set_tags(U'一', tags)));
  const auto rename = [&](const char* from, const char* to) {
    SQLite::Database(learner().file().string(), SQLite::OPEN_READWRITE, 1'000)
        .exec(std::string("ALTER TABLE ") + from + " RENAME TO " + to);
  };
  rename("tag", "gone");
  // If a dialog opens, accept it with the values that it shows.
  QTimer::singleShot(0, window_.get(), [] {
    if (auto* asked = qobject_cast<QDialog*>(QApplication::activeModalWidget())) asked->accept();
  });
  ask_tags(*the_parts, U'一');
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("The study data cannot be read")))
      << feedback().toStdString();
  rename("gone", "tag");
  EXPECT_EQ(*learner().store().tags_of(U'一'), tags);
}

TEST_F(LearnersTest, ListsThatCannotBeReadAreSaidWhereOneIsChosen) {
  write(U'一');
  ListChoice choice;
  choice.fill(learner().store());
  const int before = choice.count();
  SQLite::Database(learner().file().string(), SQLite::OPEN_READWRITE, 1'000)
      .exec("ALTER TABLE list RENAME TO gone");
  choice.fill(learner().store());
  ASSERT_EQ(choice.count(), before + 1);
  EXPECT_TRUE(choice.itemText(before).startsWith(QStringLiteral("Your lists and tags cannot be read")));
  choice.setCurrentIndex(before);
  EXPECT_FALSE(choice.model()->flags(choice.model()->index(before, 0)).testFlag(Qt::ItemIsEnabled));
  // If a list cannot be read, the export must not contain all studied characters instead.
  EXPECT_FALSE(practice::list_members("list:trees", learner().lists(), learner().store()));
  EXPECT_EQ(practice::list_members({}, learner().lists(), learner().store())->size(), 1U);
}

TEST_F(LearnersTest, ABackupThatCannotBeUsedCannotBeChosen) {
  write(U'一');
  std::filesystem::create_directories(study::backup_folder(learner().file()));
  QFile broken(
      QString::fromStdString((study::backup_folder(learner().file()) / "daily-2026-02-01.db").string()));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("no database at all");
  broken.close();
  Exchange exchange(window_.get());
  BackupsDialog dialog(the_parts->inbox(), learner(), exchange, exchange.progress, window_.get());
  auto* table = part<QTableWidget>(dialog, "backups_table");
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return table->item(0, 1)->text() == QStringLiteral("cannot be used"); }, 20'000));
  EXPECT_FALSE(part<QPushButton>(dialog, "backup_restore")->isEnabled());
}

TEST_F(LearnersTest, WhatIsExportedIsImportedWholeForANewLearner) {
  write(U'一');
  write(U'二');
  Exchange exchange(window_.get());
  const QString file = folder_.filePath(QStringLiteral("Mari.json"));
  exchange.write(Format::json, file.toStdString());
  wait_for(exchange);
  const auto exported = study::export_json(learner().store());
  exchange.read(file.toStdString());
  wait_for(exchange);
  EXPECT_EQ(learner().profile(), "Mari");
  EXPECT_TRUE(learner().can_write());
  EXPECT_EQ(*study::export_json(learner().store()), *exported);
  // The second time the name is taken, so it gets a number.
  exchange.read(file.toStdString());
  wait_for(exchange);
  EXPECT_EQ(learner().profile(), "Mari 2");
  // If the learner has not studied anything, the import goes to this learner.
  ASSERT_TRUE(learner().switch_profile("empty"));
  exchange.read(file.toStdString());
  wait_for(exchange);
  EXPECT_EQ(learner().profile(), "empty");
  EXPECT_EQ(*study::export_json(learner().store()), *exported);
}

TEST_F(LearnersTest, WhatCannotBeImportedLeavesNoLearnerBehind) {
  write(U'一');
  QFile file(folder_.filePath(QStringLiteral("bad.json")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"format\": \"nazori-learner\", \"version\": 1,\n\"entries\": [{\"id\": 7}]}");
  file.close();
  Exchange exchange(window_.get());
  QString said;
  Feedback kind = Feedback::hint;
  QObject::connect(&exchange.progress, &ExchangeProgress::announced, window_.get(),
                   [&](Feedback how, const QString& sentence) {
                     kind = how;
                     said = sentence;
                   });
  exchange.read(file.fileName().toStdString());
  wait_for(exchange);
  EXPECT_EQ(kind, Feedback::wrong);
  EXPECT_TRUE(said.startsWith(QStringLiteral("bad.json: "))) << said.toStdString();
  EXPECT_TRUE(said.endsWith(QStringLiteral("Nothing was changed."))) << said.toStdString();
  EXPECT_EQ(names(), std::vector<std::string>{"learner"});
  EXPECT_EQ(learner().profile(), "learner");
}

TEST_F(LearnersTest, WorkThatIsStoppedWritesNothing) {
  write(U'一');
  Exchange exchange(window_.get());
  QString said;
  QObject::connect(&exchange.progress, &ExchangeProgress::announced, window_.get(),
                   [&](Feedback, const QString& sentence) { said = sentence; });
  const QString file = folder_.filePath(QStringLiteral("a.apkg"));
  exchange.write(Format::anki, file.toStdString(), {"secondary", "Deck", 4});
  exchange.stop();
  wait_for(exchange);
  EXPECT_EQ(said, QStringLiteral("Stopped. Nothing was changed."));
  EXPECT_FALSE(QFile::exists(file));
}

TEST_F(LearnersTest, TablesAndAnkiPackagesAreWritten) {
  write(U'一');
  Exchange exchange(window_.get());
  const QString table = folder_.filePath(QStringLiteral("a.csv"));
  exchange.write(Format::csv, table.toStdString());
  wait_for(exchange);
  QFile csv(table);
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  EXPECT_EQ(csv.readAll().toStdString(), *study::export_csv(learner().store()));
  const QString package = folder_.filePath(QStringLiteral("a.apkg"));
  exchange.write(Format::anki, package.toStdString());
  wait_for(exchange);
  QFile zip(package);
  ASSERT_TRUE(zip.open(QIODevice::ReadOnly));
  EXPECT_TRUE(zip.read(2) == QByteArray("PK"));
}

TEST_F(LearnersTest, AnkiIsOfferedAListWhereNothingIsMet) {
  const AnkiDialog dialog(learner().store(), window_.get());
  EXPECT_EQ(dialog.choice().list, "grade-1");
  EXPECT_EQ(dialog.choice().words, 4);
}

TEST_F(LearnersTest, TheMenuIsThereWithAKeyForEachEntry) {
  for (const char* name :
       {"learners", "back_up", "restore", "export_json", "export_csv", "export_anki", "import_json"}) {
    ASSERT_NE(action(name), nullptr) << name;
    EXPECT_TRUE(action(name)->isVisible()) << name;
    EXPECT_FALSE(action(name)->shortcut().isEmpty()) << name;
  }
  action("back_up")->trigger();
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Nothing studied yet"))) << feedback().toStdString();
}

}  // namespace
}  // namespace nazori::ui
