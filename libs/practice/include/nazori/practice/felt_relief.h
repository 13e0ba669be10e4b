// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "nazori/author/own_stroke.h"
#include "nazori/base/executor.h"
#include "nazori/carving/carve.h"
#include "nazori/practice/tablet_workshop.h"
#include "nazori/surface/height_map.h"

namespace nazori::practice {

/// The relief of a character in the making, to be felt while it is edited: after each edit only the samples
/// that it touched are copied to another thread, which makes the tablet there. Of edits that come faster than
/// tablets are made, only the last one is answered. Thread: the owner of the inbox.
class FeltRelief {
 public:
  /// @param inbox  outlives this. The thread starts with the first relief. @param put  gets each new tablet.
  FeltRelief(base::Inbox& inbox, std::function<void(const Tablet&)> put)
      : inbox_(inbox), put_(std::move(put)) {}

  /// Another document, or the first one. @param map  all of its relief. @param strokes  that it is carved of.
  void begin(const surface::HeightMap& map, const std::vector<author::OwnStroke>& strokes);
  /// An edit. @param map  of another size than before: it is taken whole. @param box  the samples that may
  /// have changed.
  void update(const surface::HeightMap& map, const carving::GridBox& box,
              const std::vector<author::OwnStroke>& strokes);
  /// Nothing is put any more, until begin().
  void end();
  /// Whether a tablet is to come.
  [[nodiscard]] bool is_busy() const { return is_begun_ && answered_ != *newest_; }

 private:
  struct Relief;
  void send(std::function<void(Relief&)> change, const std::vector<author::OwnStroke>& strokes);

  base::Inbox& inbox_;
  std::function<void(const Tablet&)> put_;
  bool is_begun_ = false;
  int size_ = 0;  ///< samples per side
  std::shared_ptr<std::atomic<std::uint64_t>> newest_ = std::make_shared<std::atomic<std::uint64_t>>(0);
  std::uint64_t answered_ = 0;
  std::shared_ptr<Relief> relief_;              ///< used by the other thread only
  std::optional<base::Background> background_;  // declared last, so that its thread ends first
};

}  // namespace nazori::practice
