// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "nazori/base/result.h"

namespace nazori::ui {

/// Why something failed, in the language of the interface: the kind of failure, then the exact message if it
/// helps.
[[nodiscard]] QString reason(const base::Error& error);

/// The sentence for a computer that cannot play sound, with what to do about it.
[[nodiscard]] QString no_sound(const base::Error& error);

}  // namespace nazori::ui
