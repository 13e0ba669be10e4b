// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "nazori/studio/brush/brush_actions.h"
#include "nazori/studio/brush/brush_page.h"
#include "nazori/studio/brush/tools_panel.h"
#include "page_under_test.h"

namespace nazori::ui::test {

/// The page for the brush, with a coarse sheet, whose grain is made sooner.
class BrushPageTest : public PageTest {
 protected:
  static constexpr int kCells = 256;
  BrushPageTest() {
    qputenv("SDL_AUDIODRIVER", "dummy");
    window_.resize(1000, 700);
    open_page();
  }
  /// Opens the page as the window does when it starts.
  void open_page() {
    page_.reset();
    said_.clear();
    page_ = std::make_unique<BrushPage>(parts_, kCells);
    page_->instead_of_tablet()->resize(window_.size());
    page_->enter();
    settle();
  }
  [[nodiscard]] BrushActions& actions() const { return *static_cast<BrushActions*>(page_->actions()); }
  template <class Widget>
  [[nodiscard]] Widget& find(const char* name) const {
    return *page_->instead_of_tablet()->findChild<Widget*>(QString::fromLatin1(name));
  }
  [[nodiscard]] PaperView& paper() const { return find<PaperView>("paper_view"); }
  [[nodiscard]] BrushToolsPanel& panel() const { return find<BrushToolsPanel>("brush_tools_panel"); }
  [[nodiscard]] const calligraphy::SheetState& state() const { return page_->writing()->state(); }
  void wait_until(const std::function<bool()>& met) {
    EXPECT_TRUE(QTest::qWaitFor(met, 20'000)) << all_said().toStdString();
  }
  /// Waits for what was asked of the other thread.
  void settle() {
    wait_until([this] { return !page_->writing()->is_waiting(); });
  }
  /// What an action says.
  QString by(QAction* action) {
    said_.clear();
    action->trigger();
    settle();
    return all_said();
  }
  /// Writes a stroke from left to right. @param from, to  ends in metres from the middle of the sheet.
  void write(geometry::PaperPoint from = {-0.03, 0}, geometry::PaperPoint to = {0.03, 0}) {
    const int before = state().strokes;
    constexpr int kMoves = 40;
    for (int i = 0; i <= kMoves + 1; ++i) {
      brush::PenSample sample;
      sample.time_s = time_s_ += 0.02;
      sample.at = from + (to - from) * std::min(i / static_cast<double>(kMoves), 1.0);
      sample.down = i <= kMoves;
      emit paper().pen_moved(sample);
    }
    wait_until([&] { return state().strokes == before + 1 && !state().is_writing; });
    settle();
    said_.clear();
  }
  /// Types the text of the model and waits until the strokes of all that is shown are known.
  void take_model(const char* text, std::size_t strokes) {
    emit panel().text_typed(sentence(text));
    wait_until([&] { return paper().model().size() == strokes; });
    settle();
    said_.clear();
  }

  std::unique_ptr<BrushPage> page_;
  double time_s_ = 1000;
};

}  // namespace nazori::ui::test
