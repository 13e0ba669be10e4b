// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSettings>

#include "nazori/base/settings.h"
#include "nazori/practice/tablet_recording.h"

namespace nazori::ui {

/// All settings of the current group of `settings`, as text.
[[nodiscard]] base::Settings read_settings(const QSettings& settings);

/// Writes `values` into that group. Keys that are not among them are removed; unchanged values are not
/// written.
void write_settings(QSettings& settings, const base::Settings& values);

/// The list of recordings that are not finished, in the settings file. Thread: interface.
[[nodiscard]] practice::TabletRecording::UnfinishedFiles unfinished_recordings(const QString& settings_file);

}  // namespace nazori::ui
