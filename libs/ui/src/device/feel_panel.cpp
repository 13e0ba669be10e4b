// SPDX-License-Identifier: Apache-2.0
#include "device/feel_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>
#include <glm/geometric.hpp>

#include "device/device_actions.h"
#include "nazori/devices/tablet_device.h"
#include "nazori/surface/ball_surface.h"
#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/number_slider.h"
#include "nazori/widgets/controls/parts.h"

namespace nazori::ui {
namespace {

constexpr int kMargin = 16;
constexpr int kGap = 8;
constexpr int kLook_ms = 100;
constexpr int kLookAtRest_ms = 500;

}  // namespace

FeelPanel::FeelPanel(devices::TabletDevice& stylus, const DeviceActions& actions, QWidget* parent)
    : QScrollArea(parent), stylus_(stylus), content_(named(new QWidget(this), "information_content")) {
  setObjectName(QStringLiteral("feel_panel"));
  setAccessibleName(tr("What you feel"));
  auto* column = new QVBoxLayout(content_);
  column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  column->setSpacing(8);

  column->addWidget(heading(tr("Now"), content_));
  auto* form = new QFormLayout;
  form->setVerticalSpacing(3);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  const std::array<std::pair<const char*, QString>, line_count> names{{
      {"live_pose", tr("Tip position")},
      {"live_buttons", tr("Buttons")},
      {"live_force", tr("Force")},
      {"live_rate", tr("Update rate")},
      {"live_lateness", tr("Longest delay")},
      {"live_missed", tr("Missed updates")},
      {"live_delay", tr("Latency")},
  }};
  for (std::size_t i = 0; i < names.size(); ++i) {
    lines_[i] = sentence_label(names[i].first, content_);
    lines_[i]->setAccessibleName(names[i].second);
    form->addRow(names[i].second, lines_[i]);
  }
  column->addLayout(form);

  trial_ = new QWidget(content_);
  auto* trial = new QVBoxLayout(trial_);
  trial->setContentsMargins(0, 0, 0, 0);
  trial->addWidget(heading(tr("Feel a wall and a groove"), trial_));
  strength_ = text_label("strength", trial_);
  trial->addWidget(strength_);
  auto* row = new FlowLayout(kGap, kGap);
  for (QAction* action : {actions.weaker, actions.stronger})
    row->addWidget(action_button(action, without_mnemonic(action->text()), trial_));
  trial->addLayout(row);
  column->addWidget(trial_);

  column->addWidget(heading(tr("Material"), content_));
  const auto slider = [&](const QString& name, const char* object) {
    auto* made =
        new NumberSlider(name, QString::fromLatin1(object), 0, 1, 0.05, QStringLiteral("%1"), 2, content_);
    column->addWidget(made);
    connect(made, &NumberSlider::moved, this, &FeelPanel::emit_material);
    return made;
  };
  stiffness_ = slider(tr("Stiffness"), "material_stiffness");
  damping_ = slider(tr("Damping"), "material_damping");
  hold_ = slider(tr("Static friction"), "material_static_friction");
  slide_ = slider(tr("Dynamic friction"), "material_dynamic_friction");
  popthrough_ = slider(tr("Pop-through"), "material_popthrough");
  texture_ = named(new QComboBox(content_), "material_texture", tr("Texture"));
  make_narrow(texture_, 4);
  auto* texture_name = new QLabel(tr("Texture"), content_);
  texture_name->setBuddy(texture_);
  column->addWidget(texture_name);
  texture_->addItems({tr("smooth"), tr("paper"), tr("wood"), tr("stone")});
  connect(texture_, &QComboBox::currentIndexChanged, this, &FeelPanel::emit_material);
  column->addWidget(texture_);
  roughness_ = slider(tr("Roughness"), "material_roughness");
  column->addWidget(heading(tr("Tip of the stylus"), content_));
  tip_ = new NumberSlider(tr("Radius of the ball"), QStringLiteral("tip_radius"), 0,
                          1e3 * surface::kLargestBall_m, 0.1, tr("%1 mm"), 1, content_);
  column->addWidget(tip_);
  auto* tip_hint = text_label("tip_hint", content_, "muted");
  tip_hint->setText(
      tr("0 is a point. A ball does not reach the bottom of a groove that is narrower than it."));
  column->addWidget(tip_hint);
  connect(tip_, &NumberSlider::moved, this, [this](double mm) { emit tip_changed(mm / 1e3); });
  column->addStretch(1);
  make_scrolling(this, content_);
  timer_.setInterval(kLook_ms);
  connect(&timer_, &QTimer::timeout, this, &FeelPanel::look);
}

void FeelPanel::watch(bool on) {
  if (on) {
    look();
    timer_.start();
  } else {
    timer_.stop();
  }
}

void FeelPanel::look() {
  timer_.setInterval(stylus_.is_resting() ? kLookAtRest_ms : kLook_ms);
  const QLocale locale;
  const auto& now = stylus_.latest();
  const auto status = stylus_.status();
  const auto timing = stylus_.timing();
  const auto mm = [&](double m) { return locale.toString(m * 1000, 'f', 1); };
  const auto show = [&](Line line, const QString& text) {
    if (lines_[line]->text() != text) lines_[line]->setText(text);
  };
  show(pose, tr("%1, %2, %3 mm").arg(mm(now.device_m.x), mm(now.device_m.y), mm(now.device_m.z)));
  QStringList down;
  for (int i = 0; i < 32; ++i)
    if ((now.buttons >> i & 1U) != 0) down.append(locale.toString(i + 1));
  show(buttons, down.isEmpty() ? tr("none") : down.join(QStringLiteral(", ")));
  show(force, tr("%1 N").arg(locale.toString(glm::length(now.force_n), 'f', 2)));
  const double rate_hz = status.rate_hz > 0 ? status.rate_hz : stylus_.describe().rate_hz;
  show(rate, stylus_.is_resting() ? tr("at rest")
                                  : tr("%1 times per second").arg(locale.toString(rate_hz, 'f', 0)));
  show(lateness, tr("%1 ms").arg(locale.toString(timing.max_lateness_s * 1e3, 'f', 1)));
  show(missed, locale.toString(static_cast<qulonglong>(timing.missed_ticks)));
  show(delay, tr("%1 ms").arg(locale.toString(status.delay_s * 1e3, 'f', 1)));
}

void FeelPanel::show_strength(double strength, bool has_force) {
  trial_->setVisible(has_force);
  strength_->setText(tr("Force at %1% of the device's limits. A wall is on the left, a groove on the right.")
                         .arg(QLocale().toString(std::lround(strength * 100))));
}

void FeelPanel::show_material(const haptics::Material& material) {
  showing_ = true;
  material_ = material;
  stiffness_->set_value(material.stiffness);
  damping_->set_value(material.damping);
  hold_->set_value(material.static_friction);
  slide_->set_value(material.dynamic_friction);
  popthrough_->set_value(material.popthrough);
  texture_->setCurrentIndex(static_cast<int>(material.texture));
  roughness_->set_value(material.roughness);
  showing_ = false;
}

void FeelPanel::show_tip(double radius_m) { tip_->set_value(1e3 * radius_m); }

void FeelPanel::emit_material() {
  if (showing_) return;
  material_.stiffness = stiffness_->value();
  material_.damping = damping_->value();
  material_.static_friction = hold_->value();
  // Static friction is never less than sliding friction.
  if (slide_->value() > hold_->value()) slide_->set_value(hold_->value());
  material_.dynamic_friction = slide_->value();
  material_.popthrough = popthrough_->value();
  material_.texture = static_cast<haptics::Texture>(texture_->currentIndex());
  material_.roughness = roughness_->value();
  emit material_changed(material_);
}

}  // namespace nazori::ui
