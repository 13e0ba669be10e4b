// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "nazori/study/exchange.h"

namespace nazori::study::test {

/// The export of a learner of many years, generated while it is read and never in memory as a whole: the
/// tenth year has 296,000 entries. 2,000 characters in turn, a review every half minute for an hour a day,
/// ink on 23 of 25.
class BigLearner {
 public:
  /// @param entries  of the log; 0 for one that never ends.
  explicit BigLearner(std::int64_t entries);

  /// The text, from its beginning. This must outlive it.
  [[nodiscard]] TextSource json();

 private:
  [[nodiscard]] std::string piece();
  [[nodiscard]] std::string entry(std::int64_t id) const;

  std::int64_t entries_;
  std::array<std::string, 16> inks_;  ///< in base64
  std::int64_t next_ = 0;
  std::string rest_;
};

}  // namespace nazori::study::test
