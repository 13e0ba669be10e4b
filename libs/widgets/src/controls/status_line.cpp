// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/status_line.h"

#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QResizeEvent>
#include <cmath>

#include "nazori/practice/tablet_control.h"
#include "nazori/practice/tablet_recording.h"
#include "nazori/widgets/controls/input_watch.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/words/device_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kLook_ms = 1000;
constexpr int kMargin = 8;
constexpr int kGap = 8;

}  // namespace

StatusLine::StatusLine(practice::TabletControl& controller, practice::TabletRecording& recording,
                       QWidget* parent)
    : QStatusBar(parent),
      controller_(controller),
      recording_(recording),
      record_(named(new QLabel(this), "recording")),
      device_(named(new QLabel(this), "device")),
      rate_(named(new QLabel(this), "rate")),
      timing_(named(new QLabel(this), "timing")),
      missed_(named(new QLabel(this), "missed")),
      depth_(named(new QLabel(this), "depth")) {
  setObjectName(QStringLiteral("status_line"));
  setSizeGripEnabled(false);
  rate_->setToolTip(tr("Force updates per second"));
  timing_->setToolTip(
      tr("Average time per update, longest delay of an update since the start, and longest delay of the "
         "display in the last second"));
  missed_->setToolTip(tr("Updates that were late or missing since the start"));
  for (auto* label : {record_, depth_, device_, rate_, timing_, missed_}) {
    label->setMinimumWidth(1);  // otherwise the labels would determine the minimum width of the window
    addPermanentWidget(label);
  }
  since_.start();
  show_device();
  connect(&InputWatch::of_program(), &InputWatch::changed, this, &StatusLine::show_device);
  show_recording();
  subscribe(controller_.device().changed, this, [this] {
    ticks_ = 0;
    show_device();
    look();
  });
  subscribe(recording_.changed, this, [this] { show_recording(); });
  subscribe(recording_.export_progressed, this, [this](const std::filesystem::path& path, double done) {
    if (recording_.is_on()) return;
    record_->setText(tr("Writing %1: %2 %")
                         .arg(to_text(path.filename().string()), QLocale().toString(100 * done, 'f', 0)));
    record_->setToolTip(to_text(path.string()));
    fit();
  });
  connect(this, &QStatusBar::messageChanged, this, &StatusLine::fit);
  connect(&timer_, &QTimer::timeout, this, &StatusLine::look);
  timer_.start(kLook_ms);
  again_.setSingleShot(true);
  connect(&again_, &QTimer::timeout, this, [this] {
    reformat();
    fit();
  });
  look();
}

void StatusLine::show_device() {
  const auto device = controller_.device().describe();
  const QString name = device_name(device.name);
  device_->setText(device.has_force ? name : tr("%1 (no force)").arg(name));
  device_->setToolTip(
      InputWatch::of_program().sentence(controller_.device().is_pointer() ? QString() : name));
  fit();
}

void StatusLine::show_recording() {
  if (!recording_.is_on()) {
    fit();
    return;
  }
  const auto status = recording_.status();
  const double seconds = static_cast<double>(status.samples) / controller_.device().describe().rate_hz;
  const QString file = to_text(recording_.path().filename().string());
  const QString words = tr("● %1, %2 s").arg(file, QLocale().toString(seconds, 'f', 0));
  record_->setText(
      status.lost == 0
          ? words
          : tr("%1, %2 lost").arg(words, QLocale().toString(static_cast<qulonglong>(status.lost))));
  record_->setToolTip(tr("Recording pen motion to %1").arg(to_text(recording_.path().string())));
  fit();
}

void StatusLine::show_depth(double depth_m) {
  const QString text =
      depth_m > 0 ? tr("depth %1 mm").arg(QLocale().toString(depth_m * 1000, 'f', 1)) : QString();
  if (depth_->text() == text) return;
  depth_->setText(text);
  fit();
}

void StatusLine::show_figures(bool shown) {
  has_figures_ = shown;
  fit();
}

void StatusLine::show_input(bool shown) {
  has_input_ = shown;
  fit();
}

void StatusLine::changeEvent(QEvent* event) {
  QStatusBar::changeEvent(event);
  // Its height depends on its labels, whose font changes after its own.
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) again_.start();
}

void StatusLine::resizeEvent(QResizeEvent* event) {
  QStatusBar::resizeEvent(event);
  fit();
}

void StatusLine::fit() {
  // Labels that do not fit are left out completely, the least important first. A passing message, such as
  // what an action does, is read whole.
  const QString message = currentMessage();
  const bool passing = !message.isEmpty();
  int room = contentsRect().width() - kMargin;
  if (passing) room -= fontMetrics().horizontalAdvance(message) + kGap;
  if (controller_.device().is_pointer()) {
    for (const QString& words : InputWatch::of_program().shorter_and_shorter()) {
      device_->setText(words);
      if (device_->sizeHint().width() + kGap <= room) break;
    }
  }
  bool full = false;
  for (auto* label : {record_, device_, depth_, rate_, missed_, timing_}) {
    const bool is_figure = label != record_ && label != device_;
    if (label->text().isEmpty() || (is_figure && !has_figures_) || (label == device_ && !has_input_) ||
        (label == record_ && !recording_.is_on() && !recording_.is_exporting())) {
      label->hide();
      continue;
    }
    room -= label->sizeHint().width() + kGap;
    full = full || room < 0;
    label->setVisible(!full || (label == device_ && !passing));
  }
}

void StatusLine::look() {
  show_recording();
  const auto timing = controller_.device().timing();
  const double seconds = static_cast<double>(since_.restart()) / 1000;
  if (controller_.device().is_resting()) {
    rate_->setText(tr("at rest"));
  } else if (ticks_ > 0 && seconds > 0.2) {
    // Rounded to tens: the last digit is below the precision of the clock.
    const double rate_hz = std::round(static_cast<double>(timing.ticks - ticks_) / seconds / 10) * 10;
    rate_->setText(tr("%1 times per second").arg(QLocale().toString(rate_hz, 'f', 0)));
  } else {
    rate_->setText(tr("starting"));
  }
  ticks_ = timing.ticks;
  const QLocale locale;
  QString times = tr("update %1 µs, delay %2 ms")
                      .arg(locale.toString(timing.mean_tick_s * 1e6, 'f', 1),
                           locale.toString(timing.max_lateness_s * 1e3, 'f', 1));
  if (const double age_s = controller_.take_drawn_age_s(); age_s > 0)
    times = tr("%1, display %2 ms").arg(times, locale.toString(age_s * 1e3, 'f', 0));
  timing_->setText(times);
  const auto missed = timing.missed_ticks + timing.dropped_samples;
  missed_->setText(tr("%1 missed").arg(QLocale().toString(static_cast<qulonglong>(missed))));
  fit();
}

}  // namespace nazori::ui
