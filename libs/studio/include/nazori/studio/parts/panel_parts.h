// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>

class QAction;
class QFormLayout;
class QVBoxLayout;
class QWidget;

namespace nazori::ui {

/// An empty column for the contents of a panel.
[[nodiscard]] QVBoxLayout* make_panel_column(QWidget* content);
/// A form at the end of a column. Its rows wrap where the panel is narrow.
[[nodiscard]] QFormLayout* add_form(QVBoxLayout* column);
/// Buttons for actions at the end of a column, in as many rows as they need.
void add_buttons(QVBoxLayout* column, const QList<QAction*>& actions, QWidget* content);

/// Space between the parts of a panel [px].
inline constexpr int kPanelGap = 6;

}  // namespace nazori::ui
