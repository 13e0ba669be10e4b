// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "functions/plotter.h"

namespace nazori::ui::test {

/// A plot as the plotter hands it over, without a thread.
inline std::shared_ptr<Drawing> draw(const std::string& expression, const functions::Window& window) {
  auto drawing = std::make_shared<Drawing>();
  auto plot = functions::parse(expression);
  EXPECT_TRUE(plot) << expression;
  functions::PlateSettings plate;
  plate.size = 256;
  drawing->asked = {*plot, window, plate, functions::Language::english};
  auto picture = functions::draw(*plot, window, plate);
  EXPECT_TRUE(picture) << expression;
  drawing->picture = std::move(*picture);
  drawing->points = functions::points_of_interest(*plot, drawing->picture.tracing);
  drawing->summary =
      functions::summary(*plot, drawing->picture.tracing, drawing->points, functions::Language::english);
  drawing->final = true;
  return drawing;
}

}  // namespace nazori::ui::test
