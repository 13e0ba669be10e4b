// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <thread>
#include <vector>

namespace nazori::base {

/// Rows of a picture or a map cut into bands, one for each thread: as many as there are cores, four at most.
/// Thread-safe.
class Bands {
 public:
  /// @param rows  from 0 on. @param least_rows  fewer are not worth a thread; at least 1.
  Bands(int rows, int least_rows)
      : rows_(rows),
        // To ask for the number of cores takes longer than a small map does.
        count_(rows < 2 * least_rows
                   ? 1
                   : std::clamp(
                         std::min(static_cast<int>(std::thread::hardware_concurrency()), rows / least_rows),
                         1, kMost)) {}

  /// How many bands there are, 1..4.
  [[nodiscard]] int count() const { return count_; }
  /// The first row of a band. @param band  0..count() - 1.
  [[nodiscard]] int first(int band) const { return rows_ * band / count_; }
  /// The row after a band.
  [[nodiscard]] int last(int band) const { return first(band + 1); }

  /// Runs work(band) for all bands at once and waits for them. @param work  throws nothing.
  template <class Work>
  void run(const Work& work) const {
    std::vector<std::thread> others;
    for (int band = 1; band < count_; ++band) others.emplace_back([&work, band] { work(band); });
    work(0);
    for (std::thread& thread : others) thread.join();
  }

 private:
  static constexpr int kMost = 4;
  int rows_, count_;
};

}  // namespace nazori::base
