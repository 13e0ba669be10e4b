// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "nazori/functions/drawing.h"
#include "nazori/functions/plot_document.h"
#include "nazori/functions/plot_event.h"

namespace nazori::functions {

/// What was typed, which part of the plane is shown, how it is carved and how fast it is played: everything
/// of a page for functions that is worth saving. Thread: one.
class PlotModel {
 public:
  static constexpr Window kFirstWindow{-6, 6, -4, 4};
  static constexpr int kSlowest = 1;
  static constexpr int kFastest = 10;

  /// Reads an expression; all its curves are shown then. What cannot be read changes nothing.
  [[nodiscard]] tl::expected<void, SyntaxError> read(const std::string& expression,
                                                     const ParseOptions& reading);
  /// The last expression that could be read, and its text as it was typed.
  [[nodiscard]] const std::optional<Plot>& plot() const { return plot_; }
  [[nodiscard]] const std::string& expression() const { return expression_; }
  /// Only where there is a plot.
  [[nodiscard]] PlotRequest request(Language language) const { return {*plot_, window_, plate_, language}; }

  [[nodiscard]] const Window& window() const { return window_; }
  /// The window that reset_window() goes back to, and that is shown now.
  /// @return the errors of Window::check; nothing is changed then.
  [[nodiscard]] base::Result<void> start_with(const Window& window);
  PlotEvent set_window(const Window& window);
  PlotEvent reset_window() { return set_window(first_window_); }
  /// @param about  the location that stays where it is; the middle where there is none.
  /// @param times  above 1 the curves are drawn larger, so a smaller part of the plane is shown.
  PlotEvent zoom(const std::optional<PlotLocation>& about, double times);
  /// By parts of its own sides, right and up.
  PlotEvent pan(double du, double dv) { return set_window(window_.moved(du, dv)); }

  [[nodiscard]] const PlateSettings& plate() const { return plate_; }
  /// Other settings for the same curves: PlateSettings::alone is kept.
  void set_plate(const PlateSettings& plate);
  /// Shows one statement without the others; -1: all. Only where there is a plot.
  PlotEvent show_alone(int statement);
  /// The statement after the one that is alone; after the last one all. Only where there is a plot.
  PlotEvent show_next_alone();

  [[nodiscard]] int speed() const { return speed_; }
  PlotEvent change_speed(int by);
  /// From 6 s a curve at speed 1 through 3 s at 3 to 1.1 s at 10.
  [[nodiscard]] SoundSettings sound() const;

  /// Settings of an earlier day; what is out of range is brought into it, a bad window is left out.
  void restore(const Window& window, const PlateSettings& plate, int speed);
  /// As a file. @param reading  how the expression was read.
  [[nodiscard]] PlotDocument document(const ParseOptions& reading) const;
  /// Shows what a document says. The expression is not read yet.
  /// @param reading  how expressions are read here.
  /// @return the expression as text that means here what the document means.
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
