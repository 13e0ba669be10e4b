// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nazori::functions {
namespace {

/// Seconds of a sweep of one curve, to be divided by the speed plus one.
constexpr double kSweepSeconds = 12.0;

}  // namespace

tl::expected<void, SyntaxError> PlotModel::read(const std::string& expression, const ParseOptions& reading) {
  auto plot = parse(expression, reading);
  if (!plot) return tl::unexpected(plot.error());
  plot_ = std::move(*plot);
  expression_ = expression;
  plate_.alone = -1;
  return {};
}

base::Result<void> PlotModel::start_with(const Window& window) {
  if (auto good = window.check(); !good) return good;
  window_ = first_window_ = window;
  return {};
}

PlotEvent PlotModel::set_window(const Window& window) {
  PlotEvent event;
  event.kind = window.check() ? PlotEventKind::window_changed : PlotEventKind::window_limit;
  if (event.kind == PlotEventKind::window_changed) window_ = window;
  event.window = window_;
  return event;
}

PlotEvent PlotModel::zoom(const std::optional<PlotLocation>& about, double times) {
  const PlatePoint fixed =
      about ? PlatePoint{window_.u(about->x), window_.v(about->y)} : PlatePoint{0.5, 0.5};
  return set_window(window_.zoomed(fixed, times));
}

void PlotModel::set_plate(const PlateSettings& plate) {
  const int alone = plate_.alone;
  plate_ = plate;
  plate_.alone = alone;
}

PlotEvent PlotModel::show_alone(int statement) {
  const bool several = plot_->statements.size() > 1;
  plate_.alone = several && statement >= 0 ? statement : -1;
  PlotEvent event;
  event.kind = !several           ? PlotEventKind::only_one_curve
               : plate_.alone < 0 ? PlotEventKind::all_curves
                                  : PlotEventKind::curve_alone;
  event.statement = plate_.alone;
  return event;
}

PlotEvent PlotModel::show_next_alone() {
  const int count = static_cast<int>(plot_->statements.size());
  return show_alone(plate_.alone + 1 < count ? plate_.alone + 1 : -1);
}

PlotEvent PlotModel::change_speed(int by) {
  speed_ = std::clamp(speed_ + by, kSlowest, kFastest);
  PlotEvent event;
  event.kind = PlotEventKind::speed;
  event.number = speed_;
  event.count = kFastest;
  return event;
}

SoundSettings PlotModel::sound() const {
  SoundSettings settings;
  settings.seconds = kSweepSeconds / (speed_ + 1);
  settings.volume = 1;
  return settings;
}

void PlotModel::restore(const Window& window, const PlateSettings& plate, int speed) {
  if (window.check()) window_ = window;
  first_window_ = window_;
  plate_ = plate;
  plate_.half_width = std::clamp(plate.half_width, 0.002, 0.05);
  plate_.size = std::clamp(plate.size, 128, 2048);
  speed_ = std::clamp(speed, kSlowest, kFastest);
}

PlotDocument PlotModel::document(const ParseOptions& reading) const {
  PlotDocument document;
  document.expression = expression_;
  document.reading = reading;
  document.window = window_;
  document.plate = plate_;
  document.sound = sound();
  return document;
}

std::string PlotModel::open(const PlotDocument& document, const ParseOptions& reading) {
  window_ = first_window_ = document.window;
  plate_ = document.plate;
  speed_ = std::clamp(static_cast<int>(std::lround(kSweepSeconds / document.sound.seconds)) - 1, kSlowest,
                      kFastest);
  if (document.reading.decimal_comma == reading.decimal_comma) return document.expression;
  // Saved where commas have another meaning: use the canonical text, which means the same everywhere.
  const auto plot = parse(document.expression, document.reading);
  return plot ? canonical(*plot) : document.expression;
}

}  // namespace nazori::functions
