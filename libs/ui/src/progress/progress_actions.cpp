// SPDX-License-Identifier: Apache-2.0
#include "progress/progress_actions.h"

namespace nazori::ui {

ProgressActions::ProgressActions(QWidget* window) : ActionSet(window) {
  const auto key = [](const char* text) { return QStringList{QString::fromLatin1(text)}; };
  forecast = make("progress_forecast", tr("Reviews to &come"), tr("Go to the reviews to come"), key("1"));
  retention = make("progress_retention", tr("&Recalled, and predicted"),
                   tr("Go to what was recalled and predicted"), key("2"));
  activity =
      make("progress_activity", tr("Reviews and &minutes"), tr("Go to the reviews and minutes"), key("3"));
  motion = make("progress_motion", tr("&Speed and smoothness"), tr("Go to how the pen moved"), key("4"));
  characters =
      make("progress_characters", tr("&Every character"), tr("Go to the grid of characters"), key("5"));
  hard_strokes =
      make("progress_hard_strokes", tr("&Hardest strokes"), tr("Go to the strokes that go wrong"), key("6"));
  numbers = make("progress_numbers", tr("&Numbers or drawing"),
                 tr("Show the chart at hand as a table, or as a drawing again"), key("N"));
  copy = make("progress_copy", tr("Co&py the numbers"), tr("Copy the numbers of the chart at hand"),
              key("Ctrl+C"));
  longer = make("progress_longer", tr("&Longer time"), tr("Show a longer time"), key("L"));
  shorter = make("progress_shorter", tr("Shorter &time"), tr("Show a shorter time"), key("K"));
  draw(numbers, Icon::numbers);
  draw(copy, Icon::copy);
  add_group(tr("&Progress"), {forecast, retention, activity, motion, characters, hard_strokes, nullptr,
                              numbers, copy, nullptr, longer, shorter});
}

}  // namespace nazori::ui
