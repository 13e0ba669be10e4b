// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "nazori/base/settings.h"
#include "nazori/functions/drawing.h"
#include "nazori/functions/plot_document.h"
#include "nazori/functions/plot_event.h"

namespace nazori::functions {

/// A number as it may be typed anywhere: "-2pi", "1/3", "1,5". @return nothing for anything else, and where
/// it is not finite.
[[nodiscard]] std::optional<double> read_number(const std::string& text, const ParseOptions& reading);

/// The state of a functions page that is worth saving: the expression, the visible part of the plane, the
/// carving settings and the speed of the sound. Thread: one.
class PlotModel {
 public:
  static constexpr Window kFirstWindow{-6, 6, -4, 4};
  static constexpr int kSlowest = 1;
  static constexpr int kFastest = 10;

  /// Parses an expression and shows all its curves. An expression that cannot be parsed changes nothing.
  [[nodiscard]] tl::expected<void, SyntaxError> read(const std::string& expression,
                                                     const ParseOptions& reading);
  /// The last expression that could be parsed, and its text as typed.
  [[nodiscard]] const std::optional<Plot>& plot() const { return plot_; }
  [[nodiscard]] const std::string& expression() const { return expression_; }
  /// Call it only if there is a plot.
  [[nodiscard]] PlotRequest request(Language language, SpeechStyle style = SpeechStyle::verbose) const {
    return {*plot_, window_, plate_, language, style};
  }

  [[nodiscard]] const Window& window() const { return window_; }
  /// Sets the window, which is also the one that reset_window() restores.
  /// @return the errors of Window::check; on an error nothing is changed.
  [[nodiscard]] base::Result<void> start_with(const Window& window);
  PlotEvent set_window(const Window& window);
  PlotEvent reset_window() { return set_window(first_window_); }
  /// @param about  the location that stays fixed; the middle if none is given.
  /// @param times  above 1 the curves become larger and a smaller part of the plane is shown.
  PlotEvent zoom(const std::optional<PlotLocation>& about, double times);
  /// Moves the window by shares of its sides, right and up.
  PlotEvent pan(double du, double dv) { return set_window(window_.moved(du, dv)); }

  [[nodiscard]] const PlateSettings& plate() const { return plate_; }
  /// Other settings for the same curves: PlateSettings::alone is kept.
  void set_plate(const PlateSettings& plate);
  /// Shows one statement without the others; -1: all. Call it only if there is a plot.
  PlotEvent show_alone(int statement);
  /// Shows the next statement alone; after the last one all. Call it only if there is a plot.
  PlotEvent show_next_alone();

  [[nodiscard]] int speed() const { return speed_; }
  PlotEvent change_speed(int by);
  /// Seconds per curve: 6 s at speed 1, 3 s at 3, 1.1 s at 10.
  [[nodiscard]] SoundSettings sound() const;

  /// Reads stored settings: the window ("x0", "x1", "y0", "y1"), the plate ("axes", "ticks", "grid", "rim",
  /// "half_width", "size") and the "speed". Invalid values keep their defaults, values out of range are
  /// limited to it, and an invalid window is ignored.
  void load(const base::Settings& settings);
  /// Stores all that load() reads; other keys are unchanged.
  void save(base::Settings& settings) const;
  /// The document to save. @param reading  how the expression was parsed.
  [[nodiscard]] PlotDocument document(const ParseOptions& reading) const;
  /// Adopts the settings of a document. Its expression is not parsed yet.
  /// @param reading  how expressions are parsed here.
  /// @return the expression as text with the same meaning here as in the document.
  [[nodiscard]] std::string open(const PlotDocument& document, const ParseOptions& reading);

 private:
  std::optional<Plot> plot_;
  std::string expression_;
  Window window_ = kFirstWindow;
  Window first_window_ = kFirstWindow;
  PlateSettings plate_;
  int speed_ = 2;
};

}  // namespace nazori::functions
