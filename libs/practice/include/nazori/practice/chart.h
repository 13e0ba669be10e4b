// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "nazori/study/periods.h"

/// Charts as data, without words and without a toolkit: what to draw, in which role colours, on which axes. A
/// window paints it and adds names in its language; a web page can do the same.
namespace nazori::practice {

/// The available charts. Each has a row in chart_kinds() (study_charts.h).
enum class ChartId : std::uint8_t { forecast, retention, activity, motion };

/// What a column of numbers counts or measures.
enum class Quantity : std::uint8_t {
  reviews,     ///< from memory
  practices,   ///< in other stages
  introduced,  ///< new characters
  minutes,
  recalled,    ///< percent of the reviews
  predicted,   ///< percent: the mean chance of recall
  writings,    ///< with ink
  speed,       ///< character widths a second
  smoothness,  ///< spectral arc length, closer to 0 is smoother
};

/// The format of a number.
struct NumberFormat {
  int decimals = 0;
  bool percent = false;  ///< the value is a percentage, 0..100

  friend bool operator==(const NumberFormat&, const NumberFormat&) = default;
};
/// The format of the numbers of a table.
[[nodiscard]] NumberFormat format_of(Quantity quantity);

/// One quantity, with one value per row of the chart.
struct Column {
  Quantity quantity{};
  std::vector<double> values;

  friend bool operator==(const Column&, const Column&) = default;
};

/// The roles of colours; the painter chooses the palette.
enum class ColourRole : std::uint8_t {
  paper,    ///< behind everything
  surface,  ///< of cards and fields
  line,     ///< axes and grids
  text,
  muted,    ///< text of second rank
  accent,   ///< what is chosen
  warning,  ///< what went wrong
};

/// A colour by role: `role`, mixed with the share `share` of `over`.
struct Colour {
  ColourRole role = ColourRole::text;
  ColourRole over = role;
  double share = 0;  ///< 0..1

  friend bool operator==(const Colour&, const Colour&) = default;
};

/// How a series is drawn. Form, dashes and marks distinguish series; the colour only supports this.
struct SeriesLook {
  enum class Form : std::uint8_t { bars, line };
  enum class Mark : std::uint8_t { none, disc, square };

  Form form = Form::line;
  Colour edge;  ///< the line, or the edge of bars
  Colour fill;  ///< of bars and marks
  bool dashed = false;
  Mark mark = Mark::disc;

  friend bool operator==(const SeriesLook&, const SeriesLook&) = default;
};
/// The look of bars.
[[nodiscard]] SeriesLook bars_look();
/// The look of the first line of a chart: solid, with discs.
[[nodiscard]] SeriesLook first_line_look();
/// The look of the second line of a chart: dashed, with squares.
[[nodiscard]] SeriesLook second_line_look();

/// The side of a series's axis.
enum class Side : std::uint8_t { left, right };

/// A column of numbers that is drawn.
struct Series {
  std::size_t column = 0;  ///< index in Chart::columns
  SeriesLook look;
  Side side = Side::left;

  friend bool operator==(const Series&, const Series&) = default;
};

/// What a chart shows, for a sentence above it.
struct ForecastSummary {
  int reviews = 0;  ///< in kForecastDays days
  int today = 0;
  study::Day fullest{};  ///< the first of the days with the most reviews
  int most = 0;          ///< reviews of that day
};
/// As ForecastSummary.
struct ActivitySummary {
  int reviews = 0;
  std::chrono::milliseconds time{0};
  int days = 0;  ///< with study
  double reviews_per_day = 0;
  double minutes_per_day = 0;
};
/// As ForecastSummary: all reviews after a day or more.
struct RetentionSummary {
  study::Retention retention;
};
/// As ForecastSummary: the first and the last row.
struct MotionSummary {
  double first_speed = 0, last_speed = 0;  ///< character widths a second
  double first_smoothness = 0, last_smoothness = 0;
};
/// Nothing: without rows.
using ChartSummary =
    std::variant<std::monostate, ForecastSummary, ActivitySummary, RetentionSummary, MotionSummary>;

/// Everything that a chart shows. Its rows are in order of time.
struct Chart {
  ChartId id{};
  study::Period period{};                               ///< of each row
  std::vector<study::Day> days;                         ///< the first day of each row
  std::vector<double> positions;                        ///< x of each row, in periods from the first row
  std::vector<Column> columns;                          ///< all numbers; present even without rows
  std::vector<Series> series;                           ///< the drawn ones, from back to front
  std::optional<std::pair<double, double>> left_range;  ///< of the left axis, if it does not start at 0
  ChartSummary summary;
};

/// Rows are numbered from 0.
[[nodiscard]] int row_count(const Chart& chart);

/// An axis of values.
struct ValueAxis {
  double low = 0;
  double high = 1;
  int ticks = 5;  ///< equally spaced from `low` to `high`, both included
  NumberFormat numbers;
  bool grid = true;  ///< a line across the chart at each tick

  /// The value of a tick, 0..ticks - 1.
  [[nodiscard]] double value(int tick) const { return low + (high - low) * tick / (ticks - 1); }
};
/// The axis of one side. Its range fits the first series of that side and ends at a round number; for bars
/// that count, ticks are whole numbers. Only the left axis has a grid, because two grids would cross.
/// @return nothing where no series uses that side, or where there are no rows.
[[nodiscard]] std::optional<ValueAxis> value_axis(const Chart& chart, Side side);

/// The position of a row between the left and the right end of the chart, 0..1. Half a period is left on both
/// sides.
[[nodiscard]] double share_of_row(const Chart& chart, int row);
/// The width of a period as a share of the width of the chart.
[[nodiscard]] double share_of_period(const Chart& chart);
/// The row nearest to a share; -1 without rows.
[[nodiscard]] int row_near(const Chart& chart, double share);

/// The rows to be labelled below the chart, from the first one on.
/// @param most  number of labels that fit, at least 1. Rows may be unevenly spaced, because days without
///   study may be left out. So labels keep the distance that `most` equally spaced ones would have.
[[nodiscard]] std::vector<int> named_rows(const Chart& chart, int most);

/// Lines with more rows than this have no marks, because they would touch each other.
inline constexpr int kMostMarkedRows = 62;
/// Whether a mark is drawn at each row of the series.
[[nodiscard]] bool has_marks(const Chart& chart, const Series& series);

/// Keyboard steps of the selected row.
enum class RowStep : std::uint8_t { previous, next, first, last };
/// The row after a step. @param row  -1: none is selected yet; then "previous" is the last and "next" the
/// first.
/// @return -1 without rows.
[[nodiscard]] int row_after(const Chart& chart, int row, RowStep step);

}  // namespace nazori::practice
