// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QProgressDialog;
class QWidget;

namespace nazori::ui {

/// A dialog for work behind the window, in percent with a way to stop it. It appears when the work lasts, and
/// stays until its owner deletes it.
[[nodiscard]] QProgressDialog* make_work_dialog(const QString& name, const QString& words,
                                                const QString& stop, QWidget* parent);

}  // namespace nazori::ui
