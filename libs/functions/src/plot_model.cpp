// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace nazori::functions {
namespace {

/// Seconds of a sweep of one curve, to be divided by the speed plus one.
constexpr double kSweepSeconds = 12.0;

// Of stored settings.
constexpr double kFarthest = std::numeric_limits<double>::max();
constexpr double kThinnest = 0.002, kThickest = 0.05;  // half of a groove's width, of the plate's side
constexpr double kFewest = 128, kMost = 2048;          // samples of a side

/// The borders of a window by the names under which they are stored.
template <class W>
auto borders(W& w) {
  return std::array{std::pair{"x0", &w.x0}, std::pair{"x1", &w.x1}, std::pair{"y0", &w.y0},
                    std::pair{"y1", &w.y1}};
}

/// Likewise what is carved beside the curves.
template <class L>
auto layers(L& l) {
  return std::array{std::pair{"axes", &l.axes}, std::pair{"ticks", &l.ticks}, std::pair{"grid", &l.grid},
                    std::pair{"rim", &l.rim}};
}

}  // namespace

std::optional<double> read_number(const std::string& text, const ParseOptions& reading) {
  const auto plot = parse(text, reading);
  if (!plot || plot->statements.size() != 1) return std::nullopt;
  const auto& statement = plot->statements.front();
  if (statement.kind != StatementKind::explicit_y || !variables_of(statement.terms[0]).empty())
    return std::nullopt;
  const double value = constant_value(statement.terms[0]);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

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

void PlotModel::load(const base::Settings& settings) {
  Window window = kFirstWindow;
  for (auto [key, border] : borders(window))
    *border = base::number_setting(settings, key, *border, -kFarthest, kFarthest);
  if (window.check()) window_ = window;
  first_window_ = window_;
  plate_ = {};
  for (auto [key, on] : layers(plate_.layers)) *on = base::flag_setting(settings, key, *on);
  plate_.half_width = base::number_setting(settings, "half_width", plate_.half_width, kThinnest, kThickest);
  plate_.size = static_cast<int>(base::number_setting(settings, "size", plate_.size, kFewest, kMost));
  speed_ = static_cast<int>(base::number_setting(settings, "speed", speed_, kSlowest, kFastest));
}

void PlotModel::save(base::Settings& settings) const {
  for (auto [key, border] : borders(window_)) base::set_number(settings, key, *border);
  for (auto [key, on] : layers(plate_.layers)) base::set_flag(settings, key, *on);
  base::set_number(settings, "half_width", plate_.half_width);
  base::set_number(settings, "size", plate_.size);
  base::set_number(settings, "speed", speed_);
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
