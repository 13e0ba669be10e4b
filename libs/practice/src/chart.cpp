// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/chart.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace nazori::practice {
namespace {

/// A round upper end of an axis: 1, 2, 4 or 5 times a power of ten, not below the value.
double nice_over(double value, bool whole) {
  if (value <= 0) return 1;
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 4.0, 5.0, 10.0})
    if (factor * power >= value) return whole ? std::max(1.0, std::ceil(factor * power)) : factor * power;
  return 10 * power;
}

int decimals_for(double step) {
  const auto divides = [step](double by) { return std::abs(by * step - std::round(by * step)) < 1e-9; };
  return divides(1) ? 0 : divides(10) ? 1 : 2;
}

/// Periods from the left end of the chart to the right one.
double width_of(const Chart& chart) { return chart.positions.back() + 1; }

}  // namespace

SeriesLook bars_look() {
  return {SeriesLook::Form::bars,
          {ColourRole::accent},
          {ColourRole::surface, ColourRole::accent, 0.55},
          false,
          SeriesLook::Mark::none};
}

SeriesLook first_line_look() {
  return {SeriesLook::Form::line, {ColourRole::text}, {ColourRole::text}, false, SeriesLook::Mark::disc};
}

SeriesLook second_line_look() {
  return {
      SeriesLook::Form::line, {ColourRole::accent}, {ColourRole::surface}, true, SeriesLook::Mark::square};
}

int row_count(const Chart& chart) { return static_cast<int>(chart.positions.size()); }

std::optional<ValueAxis> value_axis(const Chart& chart, Side side) {
  const auto series = std::find_if(chart.series.begin(), chart.series.end(),
                                   [side](const Series& one) { return one.side == side; });
  if (series == chart.series.end()) return std::nullopt;
  const Column& column = chart.columns[series->column];
  if (column.values.empty()) return std::nullopt;
  const auto [least, most] = std::minmax_element(column.values.begin(), column.values.end());
  const bool whole = series->look.form == SeriesLook::Form::bars;
  ValueAxis axis;
  axis.low = *least < 0 ? -nice_over(-*least, false) : 0.0;
  axis.high = *most <= 0 && axis.low < 0 ? 0.0 : nice_over(*most, whole);
  if (side == Side::left && chart.left_range) std::tie(axis.low, axis.high) = *chart.left_range;
  const double span = axis.high - axis.low;
  axis.ticks = whole && span < 4 ? static_cast<int>(span) + 1 : 5;
  axis.numbers = {decimals_for(span / (axis.ticks - 1)), format_of(column.quantity).percent};
  axis.grid = side == Side::left;
  return axis;
}

double share_of_row(const Chart& chart, int row) {
  return (chart.positions[static_cast<std::size_t>(row)] + 0.5) / width_of(chart);
}

double share_of_period(const Chart& chart) { return 1 / width_of(chart); }

int row_near(const Chart& chart, double share) {
  if (chart.positions.empty()) return -1;
  const double x = share * width_of(chart) - 0.5;
  const auto nearest =
      std::min_element(chart.positions.begin(), chart.positions.end(),
                       [x](double a, double b) { return std::abs(a - x) < std::abs(b - x); });
  return static_cast<int>(nearest - chart.positions.begin());
}

std::vector<int> named_rows(const Chart& chart, int most) {
  std::vector<int> rows;
  if (chart.positions.empty()) return rows;
  const double apart = width_of(chart) / std::max(1, most);
  double next = chart.positions.front();
  for (int row = 0; row < row_count(chart); ++row) {
    const double position = chart.positions[static_cast<std::size_t>(row)];
    if (position < next) continue;
    next = position + apart;
    rows.push_back(row);
  }
  return rows;
}

bool has_marks(const Chart& chart, const Series& series) {
  return series.look.mark != SeriesLook::Mark::none && row_count(chart) <= kMostMarkedRows;
}

int row_after(const Chart& chart, int row, RowStep step) {
  const int last = row_count(chart) - 1;
  if (last < 0) return -1;
  switch (step) {
    case RowStep::previous:
      return row < 0 ? last : std::max(0, row - 1);
    case RowStep::next:
      return std::min(last, row + 1);
    case RowStep::first:
      return 0;
    case RowStep::last:
      return last;
  }
  return row;
}

}  // namespace nazori::practice
