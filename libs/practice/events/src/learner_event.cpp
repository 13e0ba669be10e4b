// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/learner_event.h"

#include <unistd.h>

#include <utility>

namespace nazori::practice {
namespace {

namespace fs = std::filesystem;

/// With less than this not even the index of a write-ahead log can be made.
constexpr std::uintmax_t kLeastRoom = 65'536;

bool is_writable(const fs::path& path) { return access(path.c_str(), W_OK) == 0; }

}  // namespace

LearnerEvent with_cause(LearnerEvent event, const fs::path& file) {
  std::error_code ignored;
  event.folder = file.parent_path();
  while (event.folder.has_relative_path() && !fs::exists(event.folder, ignored))
    event.folder = event.folder.parent_path();
  std::error_code unknown;
  const fs::space_info disk = fs::space(event.folder, unknown);
  if (!unknown && disk.available < kLeastRoom)
    event.cause = LearnerEvent::Cause::disk_full;
  else if ((fs::exists(file, ignored) && !is_writable(file)) || !is_writable(event.folder))
    event.cause = LearnerEvent::Cause::not_allowed;
  else
    event.cause = LearnerEvent::Cause::other;
  return event;
}

}  // namespace nazori::practice
