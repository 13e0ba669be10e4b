// SPDX-License-Identifier: Apache-2.0
#include "characters/watch_stage.h"

#include <QFontInfo>
#include <QFontMetrics>
#include <QLabel>
#include <QLocale>
#include <QWidgetAction>
#include <algorithm>

#include "characters/stroke_words.h"

namespace nazori::ui {
namespace {

constexpr int kFrame_ms = 16;
constexpr double kSpeedStep = 1.4142135623730951;
constexpr double kSlowest = 0.25;
constexpr double kFastest = 4;

}  // namespace

WatchStage::WatchStage(Desk& desk, CharacterActions& actions)
    : CharacterStage(desk, actions), place_label_(new QLabel) {
  place_label_->setObjectName(QStringLiteral("watch_label"));
  place_label_->setAlignment(Qt::AlignCenter);
  show_place();
  auto* place = new QWidgetAction(this);
  place->setDefaultWidget(place_label_);
  place_ = place;
  timer_.setInterval(kFrame_ms);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &WatchStage::advance);
  const auto on = [this](QAction* action, auto&& what) {
    // Other stages play, too.
    connect(action, &QAction::triggered, this, [this, what] {
      if (is_entered()) what();
    });
  };
  on(actions.play, [this] { set_playing(this->actions().play->isChecked()); });
  on(actions.step_back, [this] { step(-1); });
  on(actions.step_on, [this] { step(+1); });
  on(actions.slower, [this] { change_speed(1 / kSpeedStep); });
  on(actions.faster, [this] { change_speed(kSpeedStep); });
}

QList<QAction*> WatchStage::own_actions() const {
  return {actions().play,   actions().step_back, actions().step_on,
          actions().slower, actions().faster,    actions().loop};
}

QList<Tool> WatchStage::tools() const {
  return {{actions().play, true}, {actions().step_back}, {place_}, {actions().step_on},   {},
          {actions().slower},     {actions().faster},    {},       {actions().loop, true}};
}

void WatchStage::begin() {
  TabletGuides guides;
  guides.strokes = true;
  guides.numbers = true;
  guides.lines_opacity = 0;
  controller().set_guides(guides);
  controller().set_tablet(lesson().tablet);
  if (lesson().tablet)
    player_.set_strokes(lesson().tablet->paths(), lesson().tablet->lines());
  else
    player_.set_strokes({}, {});
  told_ = 0;
  show_moment(0);
  // Nothing moves unasked for those who want it so.
  if (desk().preferences().reduced_motion)
    desk().say(Feedback::hint, tr("Space plays, Left and Right step from stroke to stroke."));
  set_playing(!desk().preferences().reduced_motion && player_.stroke_count() > 0);
}

void WatchStage::end() {
  set_playing(false);
  controller().set_demonstration({});
}

void WatchStage::set_playing(bool playing) {
  if (playing && time_s_ >= player_.duration_s()) {
    told_ = 0;
    show_moment(0);
  }
  actions().play->setChecked(playing);
  since_.start();
  if (playing)
    timer_.start();
  else
    timer_.stop();
}

void WatchStage::advance() {
  const double passed_s = static_cast<double>(since_.restart()) / 1000;
  double next_s = time_s_ + passed_s * speed_;
  if (next_s >= player_.duration_s()) {
    emit finished({});
    if (actions().loop->isChecked()) {
      told_ = 0;
      next_s = 0;
    } else {
      next_s = player_.duration_s();
      set_playing(false);
      desk().say(Feedback::good, tr("All %n strokes. Space plays them again; F6 goes on to tracing.", nullptr,
                                    player_.stroke_count()));
      told_ = player_.stroke_count();
    }
  }
  show_moment(next_s);
}

void WatchStage::step(int by) {
  if (player_.stroke_count() == 0) return;
  set_playing(false);
  constexpr double kJust_s = 1e-6;
  // Moments to stop at: the start of the first stroke, then the end of each.
  std::vector<double> stops{player_.start_s(1)};
  for (int n = 1; n <= player_.stroke_count(); ++n) stops.push_back(player_.end_s(n));
  double to_s = by > 0 ? stops.back() : stops.front();
  if (by > 0) {
    for (const double stop_s : stops)
      if (stop_s > time_s_ + kJust_s) {
        to_s = stop_s;
        break;
      }
  } else {
    for (const double stop_s : stops)
      if (stop_s < time_s_ - kJust_s) to_s = stop_s;
  }
  told_ = 0;
  show_moment(to_s);
  if (by > 0 && to_s >= stops.back()) emit finished({});
}

void WatchStage::change_speed(double factor) {
  speed_ = std::clamp(speed_ * factor, kSlowest, kFastest);
  desk().say(Feedback::hint, tr("Speed %1.").arg(QLocale().toString(speed_, 'f', 2)));
  show_place();
}

void WatchStage::show_moment(double time_s) {
  time_s_ = time_s;
  if (player_.stroke_count() == 0) return;
  const auto pose = player_.at(time_s);
  Demonstration demonstration;
  for (int n = 1; n <= player_.stroke_count(); ++n) demonstration.ink.push_back(player_.share_at(n, time_s));
  demonstration.brush.proxy_m = pose.tip_m;
  demonstration.brush.device_m = pose.tip_m;
  demonstration.brush.touching = pose.writing;
  demonstration.moving = timer_.isActive();
  controller().set_demonstration(std::move(demonstration));
  if (pose.writing && pose.stroke != told_) tell_stroke(pose.stroke);
  show_place();
}

void WatchStage::tell_stroke(int stroke) {
  told_ = stroke;
  const QString which = tr("Stroke %1 of %2").arg(stroke).arg(player_.stroke_count());
  const auto& line = lesson().tablet->lines()[static_cast<std::size_t>(stroke - 1)];
  const auto ending = line.ending.value_or(kanji::StrokeEnding::stop);
  QString name;
  if (lesson().sheet && static_cast<std::size_t>(stroke) <= lesson().sheet->character.strokes.size())
    name = StrokeWords::name(lesson().sheet->character.strokes[static_cast<std::size_t>(stroke - 1)].type);
  desk().say(Feedback::hint, name.isEmpty() ? tr("%1. %2").arg(which, StrokeWords::ending(ending))
                                            : tr("%1: %2. %3").arg(which, name, StrokeWords::ending(ending)));
}

void WatchStage::show_place() {
  const int count = player_.stroke_count();
  const auto words = [&](int stroke) {
    return tr("%1 of %2 · × %3").arg(stroke).arg(count).arg(QLocale().toString(speed_, 'g', 2));
  };
  const QString text = count == 0 ? tr("no strokes") : words(player_.at(time_s_).stroke);
  if (place_label_->text() == text) return;
  place_label_->setText(text);
  // As wide as with its longest words, so that the buttons beside it keep their places.
  const QFontMetrics metrics(place_label_->font());
  place_label_->setMinimumWidth(
      std::max({place_label_->minimumWidth(), place_label_->sizeHint().width(),
                metrics.horizontalAdvance(words(count)) + QFontInfo(place_label_->font()).pixelSize()}));
}

}  // namespace nazori::ui
