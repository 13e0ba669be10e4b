// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "nazori/base/latest.h"
#include "nazori/practice/tablet_workshop.h"

namespace nazori::practice {

/// What is carved of a character while it is written from memory: nothing, all of it, or each stroke once it
/// is written correctly. Carves on a separate thread. Thread: the owner of the inbox.
class WritingGroove {
 public:
  enum class Mode : std::uint8_t {
    hidden,   ///< the tablet is blank
    shown,    ///< all grooves
    appears,  ///< the grooves of the strokes that are written
  };

  /// @param inbox  outlives this. @param put  shows a tablet to the learner.
  WritingGroove(base::Inbox& inbox, std::function<void(const Tablet&)> put);

  /// Puts the tablet for writing a character. @param model  the character's own tablet; null: nothing
  /// happens.
  void begin(Mode mode, const Tablet& model);
  /// Where grooves appear stroke by stroke: carves the grooves of exactly these strokes of the model, from 0.
  void carve(std::vector<int> strokes);
  /// Another stage uses the tablet now: no tablet is shown any more.
  void end();

 private:
  struct Carved {
    std::vector<int> strokes;
    Tablet tablet;  ///< null: they could not be carved
  };

  std::function<void(const Tablet&)> put_;
  Mode mode_ = Mode::hidden;
  Tablet model_;             ///< null: ended
  std::vector<int> carved_;  ///< strokes whose grooves have appeared
  base::Latest<std::vector<std::pair<int, tablet::TabletLine>>, Carved> carver_;
};

}  // namespace nazori::practice
