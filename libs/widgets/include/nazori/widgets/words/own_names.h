// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <map>

namespace nazori::ui {

/// Sets the names of the learner's own characters. Their letters are of no script, so a screen reader cannot
/// read them. Thread: interface.
void set_own_names(std::map<char32_t, QString> names);

/// A text as it is to be spoken: each own character in it is its name in quotation marks; one without a name
/// is "own character". Thread: interface.
[[nodiscard]] QString spoken_text(const QString& text);

}  // namespace nazori::ui
