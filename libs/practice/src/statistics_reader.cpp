// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/statistics_reader.h"

#include <utility>

#include "nazori/study/learner_store.h"

namespace nazori::practice {

StatisticsReader::StatisticsReader(base::Inbox& inbox)
    : work_(
          "statistics", inbox,
          [](const Request& request, const auto& run) -> Answer {
            const auto store = study::LearnerStore::open(request.learner, study::Access::read,
                                                         [now = request.now] { return now; });
            if (!store) return tl::unexpected(store.error());
            auto found = study::statistics_of(*store, [&run](double done, std::string_view) {
              if (!run.is_wanted()) return false;
              run.report(done);
              return true;
            });
            if (!found) return tl::unexpected(std::move(found.error()));
            return std::make_shared<const study::Statistics>(*std::move(found));
          },
          [this](const Answer& answer) {
            if (answer)
              ready(*answer);
            else
              failed(answer.error());
          },
          [this](double done) { progressed(done); }) {}

void StatisticsReader::request(const std::filesystem::path& learner, study::Time now) {
  work_.request({learner, now});
}

}  // namespace nazori::practice
