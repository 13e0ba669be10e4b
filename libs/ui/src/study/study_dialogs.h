// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace nazori::ui {

class Desk;

/// Asks how the learner wants to study and keeps what was chosen. Blocks until the dialog is closed.
void ask_study_settings(Desk& desk);

/// Asks for a character's tags: words of the learner's own, by which it can be learnt.
void ask_tags(Desk& desk, char32_t character);

}  // namespace nazori::ui
