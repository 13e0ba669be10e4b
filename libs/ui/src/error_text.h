// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "nazori/base/result.h"

namespace nazori::ui {

/// Why something failed, in the language of the interface: the kind of failure, then the exact words where
/// they are worth having.
[[nodiscard]] QString reason(const base::Error& error);

/// The sentence for a computer on which nothing can be heard, with what to do about it.
[[nodiscard]] QString no_sound(const base::Error& error);

}  // namespace nazori::ui
