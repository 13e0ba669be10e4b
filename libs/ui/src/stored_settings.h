// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSettings>

#include "nazori/base/settings.h"

namespace nazori::ui {

/// All settings of the group in which `settings` stands, as text.
[[nodiscard]] base::Settings read_settings(const QSettings& settings);

/// Makes that group hold `values`. Keys that are not among them go; what has not changed is not written.
void write_settings(QSettings& settings, const base::Settings& values);

}  // namespace nazori::ui
