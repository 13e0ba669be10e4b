// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "nazori/base/latest.h"
#include "nazori/practice/tablet_workshop.h"

namespace nazori::practice {

/// What is carved of a character while it is written from memory: nothing, all of it, or each stroke once it
/// is written correctly. Carves behind the thread that asks. Thread: the owner of the inbox.
class WritingGroove {
 public:
  enum class Mode : std::uint8_t {
    hidden,   ///< the tablet is blank
    shown,    ///< all grooves
    appears,  ///< the grooves of the strokes that are written
  };

  /// @param inbox  outlives this. @param put  puts a tablet before the learner.
  WritingGroove(base::Inbox& inbox, std::function<void(const Tablet&)> put);

  /// Puts the tablet for writing a character. @param model  the character's own tablet; null: nothing
  /// happens.
  void begin(Mode mode, const Tablet& model);
  /// Carves the grooves of these strokes of the model, from 0, and no others, where grooves appear.
  void carve(std::vector<int> strokes);
  /// Another stage has the tablet: nothing more is put.
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
  base::Latest<std::vector<std::pair<int, kanji::StrokeLine>>, Carved> carver_;
};

}  // namespace nazori::practice
