// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace nazori::ui {

class WindowParts;

/// Shows the study settings and saves what was chosen. Blocks until the dialog is closed.
void ask_study_settings(WindowParts& parts);

/// Asks for the tags of a character: words of the learner's own. A tag can be studied like a list.
void ask_tags(WindowParts& parts, char32_t character);

/// Asks for one of the learner's lists and puts a character into it, or takes it out.
void ask_list(WindowParts& parts, char32_t character);

}  // namespace nazori::ui
