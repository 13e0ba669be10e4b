// SPDX-License-Identifier: Apache-2.0
#include "characters/stages/watch_view.h"

#include <QFontInfo>
#include <QFontMetrics>
#include <QLabel>
#include <QLocale>
#include <QWidgetAction>
#include <algorithm>

namespace nazori::ui {
namespace {

constexpr int kFrame_ms = 16;

}  // namespace

WatchView::WatchView(practice::WatchStage& stage, WindowParts& parts, CharacterActions& actions)
    : StageView(stage, parts, actions), watch_(stage), location_label_(new QLabel) {
  location_label_->setObjectName(QStringLiteral("watch_label"));
  location_label_->setAlignment(Qt::AlignCenter);
  auto* location = new QWidgetAction(this);
  location->setDefaultWidget(location_label_);
  location_ = location;
  show_location();
  timer_.setInterval(kFrame_ms);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, [this] { watch_.advance(); });
  on(actions.play, [this] { watch_.set_playing(this->actions().play->isChecked()); });
  on(actions.step_back, [this] { watch_.step(-1); });
  on(actions.step_on, [this] { watch_.step(+1); });
  on(actions.slower, [this] { watch_.slower(); });
  on(actions.faster, [this] { watch_.faster(); });
  connect(actions.loop, &QAction::toggled, this, [this](bool on) { watch_.set_looping(on); });
}

QList<QAction*> WatchView::own_actions() const {
  return {actions().play,   actions().step_back, actions().step_on,
          actions().slower, actions().faster,    actions().loop};
}

QString WatchView::sentence(const practice::StageFeedback& feedback) const {
  // In a session the button below the tablet leads on, with its own key.
  const auto& session = parts().session();
  if (feedback.event == practice::StageEvent::all_watched && session.is_running() && !session.is_away())
    return StageWords::watched_in_session(feedback.count);
  return StageView::sentence(feedback);
}

QList<Tool> WatchView::tools() const {
  return {{actions().play, true}, {actions().step_back}, {location_}, {actions().step_on},   {},
          {actions().slower},     {actions().faster},    {},          {actions().loop, true}};
}

void WatchView::refresh() {
  const bool is_playing = is_entered() && watch_.is_playing();
  if (is_entered()) actions().play->setChecked(is_playing);
  if (is_playing != timer_.isActive()) is_playing ? timer_.start() : timer_.stop();
  show_location();
}

void WatchView::show_location() {
  const int count = watch_.player().stroke_count();
  const auto words = [&](int stroke) {
    return tr("%1 of %2 · %3×").arg(stroke).arg(count).arg(QLocale().toString(watch_.speed(), 'g', 2));
  };
  const QString text = count == 0 ? tr("no strokes") : words(watch_.current_stroke());
  if (location_label_->text() == text) return;
  location_label_->setText(text);
  // As wide as its longest text, so that the buttons beside it do not move.
  const QFontMetrics metrics(location_label_->font());
  location_label_->setMinimumWidth(
      std::max({location_label_->minimumWidth(), location_label_->sizeHint().width(),
                metrics.horizontalAdvance(words(count)) + QFontInfo(location_label_->font()).pixelSize()}));
}

}  // namespace nazori::ui
