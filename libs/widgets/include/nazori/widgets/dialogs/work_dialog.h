// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QProgressDialog;
class QWidget;

namespace nazori::ui {

/// A dialog with a percentage and a button to stop, for work in the background. It appears when the work
/// takes long, and stays until its owner deletes it.
[[nodiscard]] QProgressDialog* make_work_dialog(const QString& name, const QString& words,
                                                const QString& stop, QWidget* parent);

}  // namespace nazori::ui
