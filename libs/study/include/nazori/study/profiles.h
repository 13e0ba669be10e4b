// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"

namespace nazori::study {

/// The learners of one computer account: each has a folder of its own with a learner.db, its lock and its
/// backups.

/// The default profile.
inline constexpr std::string_view kDefaultProfile = "learner";

/// The folder of all profiles: the environment variable NAZORI_LEARNERS, else nazori/learners in
/// XDG_DATA_HOME, else in ~/.local/share. @return Errc::not_found where none of these is known.
[[nodiscard]] base::Result<std::filesystem::path> profiles_folder();

/// Whether a text can be the name of a profile: as can_be_name(), at most 60 bytes, without '/' and not
/// beginning with a dot.
[[nodiscard]] bool can_be_profile(std::string_view name);

/// The learner.db of a profile, whether it exists or not. @return Errc::bad_argument for an invalid name.
[[nodiscard]] base::Result<std::filesystem::path> learner_file(const std::filesystem::path& folder,
                                                               std::string_view profile);

/// Profiles that have a file, sorted.
[[nodiscard]] std::vector<std::string> profiles(const std::filesystem::path& folder);

/// Renames a profile. @return Errc::not_found; Errc::bad_argument for a name that is invalid or in use;
/// Errc::io; Errc::in_use.
[[nodiscard]] base::Result<void> rename_profile(const std::filesystem::path& folder, std::string_view from,
                                                std::string_view to);

/// Moves a profile into the folder ".removed"; nothing is deleted.
/// @return its new folder; Errc::not_found; Errc::io; Errc::in_use.
[[nodiscard]] base::Result<std::filesystem::path> remove_profile(const std::filesystem::path& folder,
                                                                 std::string_view profile);

}  // namespace nazori::study
