// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nazori::ui {

/// Buttons of which one of a group is on, as pages and stages, are radio buttons for assistive technology. Qt
/// calls them check boxes, which promises that each can be switched by itself. For the whole program; calling
/// it again changes nothing. Thread: interface.
void describe_choices();

}  // namespace nazori::ui
