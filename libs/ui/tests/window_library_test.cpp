// SPDX-License-Identifier: Apache-2.0
#include <QComboBox>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>

#include "window_under_test.h"

namespace nazori::ui {
namespace {

class Finding : public WindowTest {
 protected:
  QAbstractItemModel* tiles() { return find<QListView>("character_grid")->model(); }
  QString tile(int row) { return tiles()->index(row, 0).data().toString(); }

  void search(const QString& words) {
    auto* box = find<QLineEdit>("search");
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, words);
    ASSERT_TRUE(
        QTest::qWaitFor([this] { return text("list_count").contains(QStringLiteral("found")); }, 5000));
    QTest::qWait(150);
  }
};

TEST_F(Finding, TheFirstListIsTheEightyKanjiOfGradeOne) {
  EXPECT_TRUE(QTest::qWaitFor([this] { return tiles()->rowCount() == 80; }, 5000));
  EXPECT_EQ(text("list_count"), QStringLiteral("80"));
}

TEST_F(Finding, AllListsTheSixThousandSevenHundredAndTwo) {
  auto* lists = find<QComboBox>("lists");
  const int all = lists->findText(QStringLiteral("All characters"));
  lists->setCurrentIndex(all);
  emit lists->activated(all);
  EXPECT_TRUE(QTest::qWaitFor([this] { return tiles()->rowCount() == 6702; }, 5000)) << tiles()->rowCount();
}

TEST_F(Finding, OldJlptLevelsAreLists) {
  auto* lists = find<QComboBox>("lists");
  const int easiest = lists->findText(QStringLiteral("Old JLPT level 4 (before 2010)"));
  ASSERT_GE(easiest, 0);
  emit lists->activated(easiest);
  EXPECT_EQ(find<QLineEdit>("search")->text(), QStringLiteral("jlpt:4"));
  // KANJIDIC2 has 103 kanji of this level.
  EXPECT_TRUE(QTest::qWaitFor([this] { return tiles()->rowCount() == 103; }, 5000)) << tiles()->rowCount();
}

TEST_F(Finding, RomajiEnglishKanaAndTheCharacterItselfAllFindKyuu) {
  for (const auto* words : {"yasumu", "day off"}) {
    search(QString::fromUtf8(words));
    bool found = false;
    for (int row = 0; row < tiles()->rowCount(); ++row) found = found || tile(row) == QStringLiteral("休");
    EXPECT_TRUE(found) << words;
  }
  for (const auto* words : {"休", "やすむ"}) {
    auto* box = find<QLineEdit>("search");
    box->setText(QString::fromUtf8(words));
    EXPECT_TRUE(QTest::qWaitFor([this] { return tile(0) == QStringLiteral("休"); }, 5000)) << words;
  }
}

TEST_F(Finding, AWordIsFoundByItsReadingRomajiAndMeaning) {
  for (const auto* words : {"きゅうじつ", "kyuujitsu", "holiday"}) {
    auto* box = find<QLineEdit>("search");
    box->setText(QString::fromUtf8(words));
    EXPECT_TRUE(QTest::qWaitFor(
        [this] {
          for (int row = 0; row < tiles()->rowCount(); ++row)
            if (tile(row) == QStringLiteral("休日")) return true;
          return false;
        },
        5000))
        << words;
  }
}

TEST_F(Finding, PartsAndRadicalsAreChosenInTables) {
  auto* by_parts = find<QAction>("find_by_parts");
  by_parts->trigger();
  QPushButton* tree = nullptr;
  ASSERT_TRUE(QTest::qWaitFor([&] { return (tree = find<QPushButton>("table_part_木")) != nullptr; }, 5000));
  tree->click();
  EXPECT_EQ(find<QLineEdit>("search")->text(), QStringLiteral("parts:木"));
  find<QPushButton>("table_part_亻")->click();
  EXPECT_TRUE(QTest::qWaitFor(
      [this] {
        for (int row = 0; row < tiles()->rowCount(); ++row)
          if (tile(row) == QStringLiteral("休")) return true;
        return false;
      },
      5000));
  find<QAction>("find_by_radical")->trigger();
  EXPECT_FALSE(by_parts->isChecked()) << "one table at a time";
  find<QPushButton>("table_radical_9")->click();
  EXPECT_TRUE(find<QLineEdit>("search")->text().contains(QStringLiteral("radical:9")));
}

TEST_F(Finding, ATableHasTheKeyboardWhileItIsOpen) {
  const auto has_keyboard = [this](const QString& name) {
    return QTest::qWaitFor(
        [&] {
          const auto* with_it = window_->focusWidget();
          return with_it != nullptr && with_it->objectName().startsWith(name);
        },
        20'000);
  };
  auto* by_parts = find<QAction>("find_by_parts");
  by_parts->trigger();
  EXPECT_TRUE(has_keyboard(QStringLiteral("table_part_"))) << "the tables arrive after the panel is open";
  by_parts->trigger();
  EXPECT_TRUE(has_keyboard(QStringLiteral("search")));
  find<QAction>("find_by_radical")->trigger();
  EXPECT_TRUE(has_keyboard(QStringLiteral("table_radical_1")));
}

TEST_F(Finding, EnterShowsTheBestFind) {
  QSignalSpy shown(window_.get(), &MainWindow::character_shown);
  auto* box = find<QLineEdit>("search");
  box->setFocus();
  QTest::keyClicks(box, QStringLiteral("tree"));
  QTest::keyClick(box, Qt::Key_Return);
  ASSERT_TRUE(shown.wait(10000));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("木 – Nazori"));
}

TEST_F(Finding, NothingFoundSaysWhatToTry) {
  search(QStringLiteral("zzzzqq"));
  EXPECT_TRUE(find("nothing_found")->isVisible());
  EXPECT_TRUE(text("nothing_found").contains(QStringLiteral("zzzzqq")));
  press(Qt::Key_Escape);
  EXPECT_TRUE(find<QLineEdit>("search")->text().isEmpty());
  EXPECT_TRUE(QTest::qWaitFor([this] { return find("character_grid")->isVisible(); }, 5000));
}

TEST_F(Finding, BackGoesToTheCharacterBefore) {
  show(U'木');
  QSignalSpy shown(window_.get(), &MainWindow::character_shown);
  action("back")->trigger();
  ASSERT_TRUE(shown.wait(10000));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("休 – Nazori"));
  action("forward")->trigger();
  ASSERT_TRUE(shown.wait(10000));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("木 – Nazori"));
}

}  // namespace
}  // namespace nazori::ui
