// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/profiles.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "nazori/study/learner_store.h"

namespace nazori::study {
namespace {

namespace fs = std::filesystem;
using base::Errc;

constexpr const char* kFile = "learner.db";
constexpr std::size_t kLongestProfile = 60;

/// The folder of an existing profile that is not in use.
base::Result<fs::path> free_profile(const fs::path& folder, std::string_view profile) {
  const auto file = learner_file(folder, profile);
  if (!file) return tl::unexpected(file.error());
  std::error_code ignored;
  if (!fs::exists(*file, ignored)) {
    return base::fail(Errc::not_found, "this profile does not exist", std::string(profile));
  }
  if (LearnerStore::in_use(*file)) {
    return base::fail(Errc::in_use, "is open in another Nazori window", std::string(profile),
                      "close it there first");
  }
  return file->parent_path();
}

}  // namespace

base::Result<fs::path> profiles_folder() {
  const auto variable = [](const char* name) -> fs::path {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
  };
  if (const fs::path own = variable("NAZORI_LEARNERS"); !own.empty()) return own;
  if (const fs::path data = variable("XDG_DATA_HOME"); data.is_absolute())
    return data / "nazori" / "learners";
  if (const fs::path home = variable("HOME"); !home.empty()) {
    return home / ".local" / "share" / "nazori" / "learners";
  }
  return base::fail(Errc::not_found, "there is no folder for study data", "HOME", "set NAZORI_LEARNERS");
}

bool can_be_profile(std::string_view name) {
  return can_be_name(name) && name.size() <= kLongestProfile && name.front() != '.' &&
         name.find('/') == std::string_view::npos;
}

base::Result<fs::path> learner_file(const fs::path& folder, std::string_view profile) {
  if (!can_be_profile(profile)) {
    return base::fail(Errc::bad_argument, "is not a valid profile name", std::string(profile),
                      "give 1 to 60 bytes without '/' that do not start with a dot");
  }
  return folder / fs::path(profile) / kFile;
}

std::vector<std::string> profiles(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (can_be_profile(name) && fs::exists(entry.path() / kFile, error)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

base::Result<void> rename_profile(const fs::path& folder, std::string_view from, std::string_view to) {
  const auto old = free_profile(folder, from);
  if (!old) return tl::unexpected(old.error());
  const auto file = learner_file(folder, to);
  if (!file) return tl::unexpected(file.error());
  std::error_code error;
  if (fs::exists(file->parent_path(), error)) {
    return base::fail(Errc::bad_argument, "already exists", std::string(to), "give another name");
  }
  fs::rename(*old, file->parent_path(), error);
  if (error) return base::fail(Errc::io, "cannot be renamed: " + error.message(), old->string());
  return {};
}

base::Result<fs::path> remove_profile(const fs::path& folder, std::string_view profile) {
  const auto old = free_profile(folder, profile);
  if (!old) return tl::unexpected(old.error());
  std::error_code error;
  fs::create_directories(folder / ".removed", error);
  fs::path to = folder / ".removed" / fs::path(profile);
  for (int copy = 2; fs::exists(to, error); ++copy) {
    to = folder / ".removed" / (std::string(profile) + " " + std::to_string(copy));
  }
  fs::rename(*old, to, error);
  if (error) return base::fail(Errc::io, "cannot be moved: " + error.message(), old->string());
  return to;
}

}  // namespace nazori::study
