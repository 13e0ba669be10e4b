// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/store_upkeep.h"

namespace nazori::practice {

StoreUpkeep::StoreUpkeep(base::Inbox& inbox)
    : work_(
          "upkeep", inbox,
          [](const Request& request, const auto& run) {
            return study::keep_up(request.learner, request.day,
                                  [&run](double, std::string_view) { return run.is_wanted(); });
          },
          [this](const Answer& answer) {
            if (answer)
              done(*answer);
            else
              failed(answer.error());
          }) {}

void StoreUpkeep::request(const std::filesystem::path& learner, study::Day day) {
  work_.request({learner, day});
}

void StoreUpkeep::stop() {
  if (work_.is_busy()) work_.cancel_and_wait();
}

}  // namespace nazori::practice
