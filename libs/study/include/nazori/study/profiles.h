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

/// The profile that is there without asking.
inline constexpr std::string_view kDefaultProfile = "learner";

/// The folder of all profiles: the environment variable NAZORI_LEARNERS, else nazori/learners in
/// XDG_DATA_HOME, else in ~/.local/share. @return Errc::not_found where none of these is known.
[[nodiscard]] base::Result<std::filesystem::path> profiles_folder();

/// Whether a text can be the name of a profile: as can_be_name(), at most 60 bytes, without '/' and not
/// beginning with a dot.
[[nodiscard]] bool can_be_profile(std::string_view name);

/// The learner.db of a profile, there or not. @return Errc::bad_argument for what can be no name.
[[nodiscard]] base::Result<std::filesystem::path> learner_file(const std::filesystem::path& folder,
                                                               std::string_view profile);

/// Profiles that have a file, sorted.
[[nodiscard]] std::vector<std::string> profiles(const std::filesystem::path& folder);

/// Gives a profile another name. @return Errc::not_found; Errc::bad_argument for a name that is taken or can
/// be none; Errc::io; Errc::in_use.
[[nodiscard]] base::Result<void> rename_profile(const std::filesystem::path& folder, std::string_view from,
                                                std::string_view to);

/// Moves a profile out of sight, into the folder ".removed"; nothing is deleted.
/// @return where it is now; Errc::not_found; Errc::io; Errc::in_use.
[[nodiscard]] base::Result<std::filesystem::path> remove_profile(const std::filesystem::path& folder,
                                                                 std::string_view profile);

}  // namespace nazori::study
