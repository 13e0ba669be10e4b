// SPDX-License-Identifier: Apache-2.0
#include "functions/plot_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <cmath>

#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::plot_words)
};

/// Four significant digits; "minus", because screen readers pass over a hyphen.
QString spoken(double value) {
  if (std::isinf(value)) return value > 0 ? Words::tr("infinity") : Words::tr("minus infinity");
  const double shown = std::abs(value) < 1e-12 ? 0 : value;
  const QString digits = number_text(std::abs(shown), 4);
  return shown < 0 ? Words::tr("minus %1").arg(digits) : digits;
}

/// The curve of this index in words.
QString curve_words(const functions::Plot& plot, int statement) {
  return localised(functions::in_words(plot.statements[static_cast<std::size_t>(statement)], plot_language(),
                                       plot_speech()));
}

/// What is at the location of an event.
QString spot_words(const functions::PlotEvent& event) {
  return event.point ? point_words(*event.point) : location_words(*event.location);
}

QString arrival_words(const QString& before, const functions::PlotEvent& event) {
  return QStringLiteral("%1: %2.").arg(before, spot_words(event));
}

}  // namespace

QString speech_words(functions::SpeechStyle style) {
  switch (style) {
    case functions::SpeechStyle::verbose:
      return Words::tr("Spoken form: verbose");
    case functions::SpeechStyle::brief:
      return Words::tr("Spoken form: brief");
    case functions::SpeechStyle::superbrief:
      return Words::tr("Spoken form: superbrief");
  }
  return {};
}

QString no_coordinate() { return QStringLiteral("–"); }

QString coordinate_text(double value, const std::string& exact_name) {
  if (std::isnan(value)) return no_coordinate();
  const QString number = number_text(std::abs(value) < 1e-12 ? 0 : value, 4);
  static const QRegularExpression whole(QStringLiteral("^-?\\d+$"));
  QString name = to_text(exact_name);
  if (name.isEmpty() || whole.match(name).hasMatch())
    return name.isEmpty() ? QStringLiteral("≈ ") + number : name;
  name.replace(QLatin1String("pi"), QStringLiteral("π"));
  name.replace(QLatin1String("sqrt"), QStringLiteral("√"));
  name.replace(QLatin1Char('*'), QStringLiteral("·"));
  return QStringLiteral("%1 ≈ %2").arg(name, number);
}

QString location_words(const functions::PlotLocation& location) {
  return localised(functions::place_in_words(location.x, location.y, plot_language()));
}

QString point_words(const functions::PointOfInterest& point) {
  return localised(functions::in_words(point, plot_language(), plot_speech()));
}

QString kind_words(functions::PointKind kind) { return to_text(functions::in_words(kind, plot_language())); }

QString slope_words(double slope) {
  if (std::isinf(slope)) return Words::tr("The curve is vertical here.");
  return Words::tr("slope %1").arg(spoken(slope));
}

QString window_words(const functions::Window& window) {
  return Words::tr("x from %1 to %2, one tick is %3; y from %4 to %5, one tick is %6")
      .arg(spoken(window.x0), spoken(window.x1), spoken(functions::tick_step(window.x0, window.x1)),
           spoken(window.y0), spoken(window.y1), spoken(functions::tick_step(window.y0, window.y1)));
}

QString event_words(const functions::PlotEvent& event, const functions::Plot& plot) {
  using Kind = functions::PlotEventKind;
  switch (event.kind) {
    case Kind::here:
    case Kind::point_reached:
      return spot_words(event) + QLatin1Char('.');
    case Kind::next_branch:
      return arrival_words(Words::tr("Next branch"), event);
    case Kind::end_of_branch:
      return arrival_words(Words::tr("End"), event);
    case Kind::other_branch:
      return arrival_words(curve_words(plot, event.statement), event);
    case Kind::beacon_reached:
      return arrival_words(Words::tr("Marker %1").arg(event.number), event);
    case Kind::beacon_dropped:
      return Words::tr("Marker %1 set: %2.").arg(event.number).arg(spot_words(event));
    case Kind::slope:
      return slope_words(event.slope);
    case Kind::curve_alone:
      return Words::tr("Only curve %1: %2.").arg(event.statement + 1).arg(curve_words(plot, event.statement));
    case Kind::all_curves:
      return Words::tr("All curves are shown.");
    case Kind::groove:
      return Words::tr("Branch %1 of %2: %3")
          .arg(event.number)
          .arg(event.count)
          .arg(curve_words(plot, event.statement));
    case Kind::all_grooves:
      return Words::tr("%n branches", nullptr, event.count);
    case Kind::speed:
      return Words::tr("Speed %1 of %2").arg(event.number).arg(event.count);
    case Kind::window_changed:
      return window_words(event.window) + QLatin1Char('.');
    case Kind::no_curve:
      return Words::tr("There is no curve to follow here.");
    case Kind::no_other_branch:
      return Words::tr("There is no other curve or branch.");
    case Kind::no_point:
      return Words::tr("There are no points of interest in this range.");
    case Kind::no_location:
      return Words::tr("First move to a point on a curve with the arrow keys.");
    case Kind::no_slope:
      return Words::tr("The curve has no slope here.");
    case Kind::no_beacon:
      return Words::tr("There are no markers yet. B: add one.");
    case Kind::only_one_curve:
      return Words::tr("There is only one curve.");
    case Kind::window_limit:
      return Words::tr("The range cannot be changed any further.");
  }
  return {};
}

QString file_filter(functions::PlotFile kind) {
  switch (kind) {
    case functions::PlotFile::document:
      return Words::tr("Plots (*.json)");
    case functions::PlotFile::raw:
      return Words::tr("Height maps (*.raw)");
    case functions::PlotFile::png:
    case functions::PlotFile::print:
      return Words::tr("Pictures (*.png)");
    case functions::PlotFile::sound:
      return Words::tr("Sounds (*.wav)");
  }
  return {};
}

}  // namespace nazori::ui
