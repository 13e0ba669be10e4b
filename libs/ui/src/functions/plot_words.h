// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "nazori/functions/plot_event.h"
#include "nazori/functions/plot_export.h"
#include "nazori/widgets/words/plot_text.h"

namespace nazori::ui {

/// "Spoken form: brief".
[[nodiscard]] QString speech_words(functions::SpeechStyle style);
/// A coordinate to read: "π/2 ≈ 1.571", or only the number if no exact name is known.
[[nodiscard]] QString coordinate_text(double value, const std::string& exact_name);

/// The text for a coordinate that does not exist.
[[nodiscard]] QString no_coordinate();

/// To be spoken: "x = 1.5; y = minus 2".
[[nodiscard]] QString location_words(const functions::PlotLocation& location);
[[nodiscard]] QString point_words(const functions::PointOfInterest& point);
[[nodiscard]] QString kind_words(functions::PointKind kind);
[[nodiscard]] QString slope_words(double slope);
/// "x from minus 6 to 6, one tick is 1; y from minus 4 to 4, one tick is 1".
[[nodiscard]] QString window_words(const functions::Window& window);
/// The sentence that announces an event. @param plot  the plot of the event.
[[nodiscard]] QString event_words(const functions::PlotEvent& event, const functions::Plot& plot);

/// For the file dialog: "Plots (*.json)".
[[nodiscard]] QString file_filter(functions::PlotFile kind);

}  // namespace nazori::ui
