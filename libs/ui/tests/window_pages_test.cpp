// SPDX-License-Identifier: Apache-2.0
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

#include "characters/characters.h"
#include "nazori/widgets/page/window_parts.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

/// Keys that the page for characters uses too.
class SundialActions final : public ActionSet {
 public:
  explicit SundialActions(QWidget* window) : ActionSet(window) {
    turn = make("sundial_turn", QStringLiteral("&Turn"), QStringLiteral("Turn it"), "S");
    add_group(QStringLiteral("S&undial"), {turn});
  }
  QAction* turn;
};

/// A page with the shared tablet and one panel, on the left.
class Sundial final : public Page {
 public:
  explicit Sundial(WindowParts& parts)
      : Page(parts, {QStringLiteral("sundial"),
                     QStringLiteral("&Sundial"),
                     QStringLiteral("The hour"),
                     Icon::reset_view,
                     {}}),
        actions_(new SundialActions(&parts.window())),
        panel_(new QWidget(&parts.window())) {
    panel_->setObjectName(QStringLiteral("sundial_panel"));
    connect(actions_->turn, &QAction::triggered, this, [this] { ++turns_; });
  }
  [[nodiscard]] Panel left() const override {
    return {panel_, QStringLiteral("Hours"), QStringLiteral("Hours")};
  }
  [[nodiscard]] ActionSet* actions() const override { return actions_; }
  [[nodiscard]] QList<Tool> tools() const override { return {{actions_->turn, true}}; }
  void enter() override {
    parts().tablet().set_tablet(nullptr);
    parts().announce(Feedback::hint, QStringLiteral("It is %1.").arg(turns_));
  }
  void save(QSettings& settings) const override { settings.setValue(QStringLiteral("turns"), turns_); }
  [[nodiscard]] bool opens(const QStringList& paths) const override {
    return paths.front().endsWith(QLatin1String(".sun"));
  }
  void open_files(const QStringList& paths) override { parts().announce(Feedback::good, paths.front()); }

 private:
  SundialActions* actions_;
  QWidget* panel_;
  int turns_ = 0;
};

/// A page with a widget instead of the tablet.
class Almanac final : public Page {
 public:
  explicit Almanac(WindowParts& parts)
      : Page(parts, {QStringLiteral("almanac"),
                     QStringLiteral("&Almanac"),
                     QStringLiteral("The days"),
                     Icon::library,
                     {}}),
        page_(new QPushButton(QStringLiteral("Day"))) {
    page_->setObjectName(QStringLiteral("almanac_page"));
    connect(page_, &QPushButton::clicked, this, [this] { this->parts().show_character(U'日'); });
  }
  [[nodiscard]] QWidget* instead_of_tablet() const override { return page_; }
  void enter() override {}

 private:
  QPushButton* page_;
};

template <class T>
std::unique_ptr<Page> make(WindowParts& parts) {
  return std::make_unique<T>(parts);
}

class PagesOfTheWindow : public WindowTest {
 protected:
  PagesOfTheWindow() { pages_ = {make<Characters>, make<Sundial>, make<Almanac>}; }

  QStringList menus() {
    QStringList titles;
    for (const auto* menu : find<QMenuBar>("menu_bar")->actions())
      titles.append(without_mnemonic(menu->text()));
    return titles;
  }
};

TEST_F(PagesOfTheWindow, AltAndTheirNumberGoesToThem) {
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_TRUE(find("sundial_panel")->isVisible());
  EXPECT_TRUE(find("tablet")->isVisible());
  EXPECT_FALSE(find("library_panel")->isVisible());
  EXPECT_FALSE(find("information_panel")->isVisible());
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("Sundial – Nazori"));
  press(Qt::Key_3, Qt::AltModifier);
  EXPECT_TRUE(find("almanac_page")->isVisible());
  EXPECT_FALSE(find("tablet")->isVisible());
  EXPECT_EQ(find("almanac_page")->width(), find("stage")->width());
  EXPECT_TRUE(find("feedback_line")->isVisible());
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_TRUE(find("tablet")->isVisible());
  EXPECT_TRUE(find("library_panel")->isVisible());
  EXPECT_TRUE(find("feedback_line")->isVisible());
}

TEST_F(PagesOfTheWindow, TheTabletOfCharactersIsThereAgainOnComingBack) {
  show(U'雨');
  press(Qt::Key_2, Qt::AltModifier);
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_EQ(text("stroke_label"), QStringLiteral("all 8 strokes"));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("雨 – Nazori"));
}

TEST_F(PagesOfTheWindow, TheSameKeyDoesWhatThePageInTheWindowMeans) {
  press(Qt::Key_2, Qt::AltModifier);
  press(Qt::Key_S);
  EXPECT_TRUE(action("strokes")->isChecked());
  press(Qt::Key_1, Qt::AltModifier);
  press(Qt::Key_S);
  EXPECT_FALSE(action("strokes")->isChecked());
  press(Qt::Key_2, Qt::AltModifier);
  window_->close();
  const QSettings saved(folder_.filePath(QStringLiteral("nazori.ini")), QSettings::IniFormat);
  EXPECT_EQ(saved.value(QStringLiteral("sundial/turns")).toInt(), 1);
}

TEST_F(PagesOfTheWindow, MenusAndToolsAreThoseOfThePage) {
  EXPECT_EQ(menus(), (QStringList{"File", "Learner", "Character", "Strokes", "Practice", "Writing",
                                  "Pen by keys", "Speech", "Study", "Tablet", "View", "Go", "Help"}));
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_EQ(menus(), (QStringList{"File", "Learner", "Sundial", "Tablet", "View", "Go", "Help"}));
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_NE(find<QToolButton>("tool_sundial_turn"), nullptr);
  EXPECT_EQ(find<QToolButton>("tool_snap"), nullptr);
  press(Qt::Key_3, Qt::AltModifier);
  EXPECT_EQ(menus(), (QStringList{"File", "Learner", "View", "Go", "Help"}));
  EXPECT_FALSE(action("left_panel")->isVisible());
}

TEST_F(PagesOfTheWindow, NoPageGivesAKeyTwice) {
  for (const auto number : {Qt::Key_1, Qt::Key_2, Qt::Key_3}) {
    press(number, Qt::AltModifier);
    QStringList keys;
    for (const auto* entry : window_->findChildren<QAction*>())
      if (entry->isVisible())
        for (const auto& key : entry->shortcuts()) keys.append(key.toString());
    EXPECT_GT(keys.size(), 10);
    EXPECT_EQ(keys.removeDuplicates(), 0);
  }
}

TEST_F(PagesOfTheWindow, TheLastOneIsThereAgainAfterARestart) {
  press(Qt::Key_3, Qt::AltModifier);
  window_->close();
  window_.reset();
  window_ = std::make_unique<MainWindow>(setup(), appearance_);
  window_->show();
  EXPECT_TRUE(find("almanac_page")->isVisible());
  EXPECT_TRUE(action("go_almanac")->isChecked());
}

TEST_F(PagesOfTheWindow, AnyOfThemCanPutACharacterOnTheTablet) {
  press(Qt::Key_3, Qt::AltModifier);
  QSignalSpy shown(window_.get(), &MainWindow::character_shown);
  find<QPushButton>("almanac_page")->click();
  ASSERT_TRUE(shown.wait(20000));
  EXPECT_TRUE(find("tablet")->isVisible());
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("日 – Nazori"));
}

TEST_F(PagesOfTheWindow, AFileGoesToTheOneThatOpensIt) {
  window_->open_files({QStringLiteral("noon.sun")});
  EXPECT_TRUE(find("sundial_panel")->isVisible());
  EXPECT_EQ(feedback(), QStringLiteral("noon.sun"));
  QFile file(folder_.filePath(QStringLiteral("own.raw")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QByteArray(64 * 64, '\x80'));
  file.close();
  window_->open_files({file.fileName()});
  EXPECT_TRUE(
      QTest::qWaitFor([this] { return feedback().contains(QStringLiteral("Opened own.raw")); }, 10000));
  EXPECT_TRUE(find("library_panel")->isVisible());
}

TEST_F(PagesOfTheWindow, TheRailNamesThemAndIsGoneInFullScreen) {
  auto* rail = find<QToolBar>("page_rail");
  ASSERT_TRUE(rail->isVisible());
  QStringList names;
  for (const auto* button : rail->findChildren<QToolButton*>())
    if (button->objectName().startsWith(QLatin1String("rail_"))) {
      names.append(button->accessibleName());
      EXPECT_EQ(button->focusPolicy(), Qt::TabFocus);
    }
  EXPECT_EQ(names, (QStringList{"Characters", "Sundial", "Almanac"}));
  press(Qt::Key_F11);
  EXPECT_FALSE(rail->isVisible());
  press(Qt::Key_Escape);
  EXPECT_TRUE(rail->isVisible());
}

TEST_F(PagesOfTheWindow, WhereThereIsOnlyOneThereIsNothingToChoose) {
  pages_ = {make<Characters>};
  open_window();
  EXPECT_FALSE(find<QToolBar>("page_rail")->isVisible());
  EXPECT_FALSE(menus().contains(QStringLiteral("Go")));
}

TEST_F(PagesOfTheWindow, WhatDoesNotFitInAMenuIsInASubmenuAtItsEndInItsOrder) {
  window_->move(0, 0);
  set_text_size(28);
  const auto names = [](const QMenu& menu) {
    QStringList all;
    for (const auto* one : menu.actions())
      if (!one->isSeparator() && one->menu() == nullptr) all.append(one->text());
    return all;
  };
  int divided = 0;
  const auto* bar = window_->menuBar();
  const int room =
      window_->screen()->availableGeometry().bottom() - bar->mapToGlobal(QPoint(0, bar->height())).y();
  for (auto* entry : bar->actions()) {
    auto* menu = entry->menu();
    const QStringList all = names(*menu);
    emit menu->aboutToShow();
    auto* last = menu->actions().constLast();
    auto* more = last->menu();
    if (more == nullptr) {
      EXPECT_EQ(names(*menu), all);
      continue;
    }
    ++divided;
    EXPECT_EQ(last->text(), QStringLiteral("More"));
    EXPECT_EQ(names(*menu) + names(*more), all);
    EXPECT_FALSE(more->actions().constFirst()->isSeparator()) << entry->text().toStdString();
    EXPECT_LE(menu->sizeHint().height(), room);
    // One more would not fit.
    menu->insertAction(last, more->actions().constFirst());
    EXPECT_GT(menu->sizeHint().height(), room) << entry->text().toStdString();
  }
  EXPECT_GE(divided, 1);
}

}  // namespace
}  // namespace nazori::ui
