// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "nazori/base/result.h"

namespace nazori::ui {

/// Whether the interface speaks English. The messages of libraries are English: elsewhere they are left out
/// of sentences.
[[nodiscard]] bool is_english();

/// Why something failed, in the language of the interface: the kind of failure, then in brackets the exact
/// message and its remedy; in other languages than English the line of the file in their place, if it is
/// known.
[[nodiscard]] QString reason(const base::Error& error);

/// The sentence for a computer that cannot play sound, with what to do about it.
[[nodiscard]] QString no_sound(const base::Error& error);

}  // namespace nazori::ui
