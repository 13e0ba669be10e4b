// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "nazori/base/result.h"
#include "nazori/speech/sound.h"

namespace nazori::speech {

/// The endings of recorded files, in the order in which they are looked for.
inline constexpr std::array kRecordingEndings{".wav", ".flac", ".ogg", ".opus", ".mp3"};

/// The file that a folder has for kana: its name is the kana in hiragana or in katakana, or in hiragana with
/// sound marks as characters of their own, as some systems write file names.
/// @param name  SpokenKana::name. @return empty where there is none.
[[nodiscard]] std::filesystem::path recording_of(const std::filesystem::path& folder,
                                                 const std::string& name);

}  // namespace nazori::speech
