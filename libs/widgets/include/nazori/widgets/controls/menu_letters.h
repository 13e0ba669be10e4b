// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QList>

namespace nazori::ui {

/// Gives each entry of a menu a letter of its own to choose it by (underlined, after `&` in its text). The
/// first entry with a letter keeps it; one whose letter is taken, or that has none, gets the first free
/// letter of a word of its text, else any free letter of it, else one in brackets at its end as Japanese
/// menus have it. Where all 26 are taken it has none.
/// @param entries  in order; separators are passed over.
void give_own_letters(const QList<QAction*>& entries);

}  // namespace nazori::ui
