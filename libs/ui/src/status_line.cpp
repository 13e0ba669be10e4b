// SPDX-License-Identifier: Apache-2.0
#include "status_line.h"

#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <cmath>

#include "kanji_text.h"
#include "tablet_controller.h"

namespace nazori::ui {
namespace {

constexpr int kLook_ms = 1000;

}  // namespace

StatusLine::StatusLine(TabletController& controller, QWidget* parent)
    : QStatusBar(parent),
      controller_(controller),
      device_(new QLabel(this)),
      rate_(new QLabel(this)),
      timing_(new QLabel(this)),
      missed_(new QLabel(this)),
      depth_(new QLabel(this)) {
  setObjectName(QStringLiteral("status_line"));
  setSizeGripEnabled(false);
  device_->setObjectName(QStringLiteral("device"));
  rate_->setObjectName(QStringLiteral("rate"));
  timing_->setObjectName(QStringLiteral("timing"));
  missed_->setObjectName(QStringLiteral("missed"));
  depth_->setObjectName(QStringLiteral("depth"));
  rate_->setToolTip(tr("How often a second the stylus is felt"));
  timing_->setToolTip(tr(
      "How long a moment of feeling takes to compute on average, how late one came at most since the start, "
      "and how old the drawn stylus was at most in the last second"));
  missed_->setToolTip(tr("Moments of feeling that came too late or not at all, since the start"));
  for (auto* label : {depth_, device_, rate_, timing_, missed_}) addPermanentWidget(label);
  const auto device = controller_.stylus().describe();
  // The window names what it knows; a device of another maker keeps its own name.
  QString name = to_text(device.name);
  if (name == QLatin1String("Mouse") || name == QLatin1String("Pointer") ||
      name == QLatin1String("Mouse or pen"))
    name = tr("Mouse or pen");
  device_->setText(device.has_force ? name : tr("%1, without force").arg(name));
  since_.start();
  connect(&timer_, &QTimer::timeout, this, &StatusLine::look);
  timer_.start(kLook_ms);
  look();
}

void StatusLine::show_depth(double depth_m) {
  const QString text =
      depth_m > 0 ? tr("depth %1 mm").arg(QLocale().toString(depth_m * 1000, 'f', 1)) : QString();
  if (depth_->text() != text) depth_->setText(text);
}

void StatusLine::changeEvent(QEvent* event) {
  QStatusBar::changeEvent(event);
  // Its height comes from its labels, whose text grows only after its own.
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
    QTimer::singleShot(0, this, [this] { reformat(); });
}

void StatusLine::look() {
  const auto timing = controller_.stylus().timing();
  const double seconds = static_cast<double>(since_.restart()) / 1000;
  if (ticks_ > 0 && seconds > 0.2) {
    // To tens: the last digit is only the stopwatch.
    const double rate_hz = std::round(static_cast<double>(timing.ticks - ticks_) / seconds / 10) * 10;
    rate_->setText(tr("%1 times a second").arg(QLocale().toString(rate_hz, 'f', 0)));
  } else {
    rate_->setText(tr("starting"));
  }
  ticks_ = timing.ticks;
  const QLocale locale;
  QString times = tr("tick %1 µs, late %2 ms")
                      .arg(locale.toString(timing.mean_tick_s * 1e6, 'f', 1),
                           locale.toString(timing.max_lateness_s * 1e3, 'f', 1));
  if (const double age_s = controller_.take_drawn_age_s(); age_s > 0)
    times = tr("%1, seen after %2 ms").arg(times, locale.toString(age_s * 1e3, 'f', 0));
  timing_->setText(times);
  const auto missed = timing.missed_ticks + timing.dropped_samples;
  missed_->setText(tr("%1 missed").arg(QLocale().toString(static_cast<qulonglong>(missed))));
}

}  // namespace nazori::ui
