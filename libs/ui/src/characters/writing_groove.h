// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "worker.h"
#include "workshop.h"

namespace nazori::ui {

class TabletController;

/// What is carved of a character while it is written from memory: nothing, all of it, or each stroke once it
/// is written right. Thread: interface; carving is done behind it.
class WritingGroove {
 public:
  enum class Way : std::uint8_t { hidden, shown, appears };

  explicit WritingGroove(TabletController& controller) : controller_(controller) {}

  /// Puts a tablet on the desk for a character to be written.
  void put(Way way, const Tablet& model);
  /// Where grooves appear: those of these strokes of the model, from 0, and no others.
  void carve(std::vector<int> strokes);
  /// The tablet belongs to somebody else now.
  void leave();

 private:
  TabletController& controller_;
  Way way_ = Way::hidden;
  Tablet model_;             ///< null: left
  std::vector<int> carved_;  ///< strokes whose grooves have appeared
  Worker carver_{QStringLiteral("carver")};
};

}  // namespace nazori::ui
