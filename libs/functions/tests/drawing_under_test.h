// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "nazori/functions/drawing.h"

namespace nazori::functions::test {

/// A plot as the plotter shows it, without a thread.
inline std::shared_ptr<Drawing> draw(const std::string& expression, const Window& window) {
  auto drawing = std::make_shared<Drawing>();
  auto plot = parse(expression);
  EXPECT_TRUE(plot) << expression;
  PlateSettings plate;
  plate.size = 256;
  drawing->request = {*plot, window, plate, Language::english};
  auto picture = draw(*plot, window, plate);
  EXPECT_TRUE(picture) << expression;
  drawing->picture = std::move(*picture);
  drawing->points = points_of_interest(*plot, drawing->picture.tracing);
  drawing->summary = summary(*plot, drawing->picture.tracing, drawing->points, Language::english);
  drawing->final = true;
  return drawing;
}

}  // namespace nazori::functions::test
