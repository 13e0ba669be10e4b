// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QTest>
#include <memory>
#include <vector>

#include "nazori/studio/workshop/character_canvas.h"
#include "nazori/studio/workshop/workshop_actions.h"
#include "nazori/studio/workshop/workshop_page.h"
#include "nazori/studio/workshop/workshop_panel.h"
#include "page_under_test.h"

namespace nazori::ui::test {

/// The page of the workshop.
class WorkshopPageTest : public PageTest {
 protected:
  WorkshopPageTest() { open_page(); }
  void open_page() {
    page_.reset();
    page_ = std::make_unique<WorkshopPage>(parts_);
    page_->enter();
  }
  [[nodiscard]] WorkshopActions& actions() const { return *static_cast<WorkshopActions*>(page_->actions()); }
  [[nodiscard]] CharacterCanvas& canvas() const {
    return *page_->instead_of_tablet()->findChild<CharacterCanvas*>();
  }
  [[nodiscard]] WorkshopPanel& panel() const {
    return *page_->instead_of_tablet()->findChild<WorkshopPanel*>();
  }
  [[nodiscard]] const author::Workbench& bench() const { return page_->bench(); }
  [[nodiscard]] const author::OwnStroke& stroke(std::size_t number) const {
    return bench().character().strokes.at(number);
  }
  void click(geometry::GlyphPoint at) {
    for (const bool down : {true, false}) emit canvas().pen_moved({at, time_s_ += 0.02}, down);
  }
  /// Makes a stroke of placed points and chooses it.
  void place(const std::vector<geometry::GlyphPoint>& points) {
    actions().tools[static_cast<std::size_t>(author::Tool::place)]->trigger();
    for (const auto& point : points) click(point);
    actions().finish->trigger();
    said_.clear();
  }
  void choose(author::Tool tool) {
    actions().tools[static_cast<std::size_t>(tool)]->trigger();
    said_.clear();
  }
  void name(const char* text) {
    auto facts = bench().character().facts;
    facts.name = text;
    emit panel().facts_typed(facts);
    said_.clear();
  }
  /// What an action says.
  QString by(QAction* action) {
    said_.clear();
    action->trigger();
    return all_said();
  }
  /// Waits for files, and for what is said of them. That a slow disk takes its time is left out.
  QString said_of_files() {
    EXPECT_TRUE(QTest::qWaitFor(
        [this] {
          said_.removeIf([](const QString& one) { return one.endsWith(QChar(0x2026)); });
          return !page_->is_busy_with_files() && !said_.isEmpty();
        },
        20'000));
    return all_said();
  }

  std::unique_ptr<WorkshopPage> page_;
  double time_s_ = 1;
};

}  // namespace nazori::ui::test
