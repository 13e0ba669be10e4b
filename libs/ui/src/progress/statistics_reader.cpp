// SPDX-License-Identifier: Apache-2.0
#include "progress/statistics_reader.h"

#include <utility>

namespace nazori::ui {

StatisticsReader::StatisticsReader(QObject* parent) : QObject(parent) {}

// What runs now sees that it is not wanted any more.
StatisticsReader::~StatisticsReader() { ++newest_; }

void StatisticsReader::request(const std::filesystem::path& learner, study::Time now) {
  const std::uint64_t number = ++newest_;
  busy_ = true;
  worker_.post([this, learner, now, number] {
    if (number != newest_) return;
    const auto progress = [this, number](double done, std::string_view) {
      if (number != newest_) return false;
      worker_.answer([this, number, done] {
        if (number == newest_ && busy_) emit came_along(done);
      });
      return true;
    };
    auto found = [&]() -> base::Result<study::Statistics> {
      const auto store = study::LearnerStore::open(learner, study::Access::read, [now] { return now; });
      if (!store) return tl::unexpected(store.error());
      return study::statistics_of(*store, progress);
    }();
    worker_.answer([this, number, found = std::move(found)] {
      if (number != newest_) return;
      busy_ = false;
      if (found)
        emit ready(std::make_shared<const study::Statistics>(*found));
      else
        emit failed(found.error());
    });
  });
}

}  // namespace nazori::ui
