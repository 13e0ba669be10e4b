// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLineEdit>
#include <memory>
#include <utility>

#include "characters/characters.h"
#include "functions/functions_page.h"
#include "nazori/widgets/page/window_parts.h"
#include "window_under_test.h"

namespace nazori::ui::test {

inline FunctionsPage* the_functions = nullptr;
inline WindowParts* the_functions_parts = nullptr;

/// The real window on the page for functions, with a sound card that only counts.
class FunctionsWindow : public WindowTest {
 protected:
  FunctionsWindow() {
    pages_ = {[](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<Characters>(parts); },
              [](WindowParts& parts) -> std::unique_ptr<Page> {
                auto page = std::make_unique<FunctionsPage>(parts);
                the_functions = page.get();
                the_functions_parts = &parts;
                return page;
              }};
    qputenv("SDL_AUDIODRIVER", "dummy");
  }

  void SetUp() override {
    WindowTest::SetUp();
    press(Qt::Key_2, Qt::AltModifier);
    ASSERT_TRUE(wait_for_drawing());
  }

  bool wait_for_drawing() {
    return QTest::qWaitFor(
        [] {
          return the_functions->shown() && the_functions->shown()->final && !the_functions->is_drawing();
        },
        30000);
  }

  void type(const QString& expression) {
    auto* line = find<QLineEdit>("expression");
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, expression);
    ASSERT_TRUE(wait_for_drawing());
  }

  void window(double x0, double x1, double y0, double y1) {
    const std::pair<const char*, double> borders[] = {
        {"window_x0", x0}, {"window_x1", x1}, {"window_y0", y0}, {"window_y1", y1}};
    for (const auto& [name, value] : borders) {
      auto* border = find<QLineEdit>(name);
      border->setFocus();
      border->selectAll();
      QTest::keyClicks(border, QString::number(value));
      QTest::keyClick(border, Qt::Key_Return);
    }
    ASSERT_TRUE(wait_for_drawing());
  }

  void to_tablet() {
    find("tablet")->setFocus();
    QCoreApplication::processEvents();
  }

  [[nodiscard]] const functions::Drawing& shown() const { return *the_functions->shown(); }
  [[nodiscard]] const tablet::CarvedTablet& carved() const { return *the_functions->tablet(); }
};

}  // namespace nazori::ui::test
