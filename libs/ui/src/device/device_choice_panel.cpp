// SPDX-License-Identifier: Apache-2.0
#include "device/device_choice_panel.h"

#include <QAction>
#include <QButtonGroup>
#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>
#include <initializer_list>
#include <numbers>

#include "device/button_lines.h"
#include "device/device_actions.h"
#include "nazori/widgets/controls/number_slider.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/device_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kMargin = 16;
constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

DeviceChoicePanel::DeviceChoicePanel(const DeviceActions& actions, QWidget* parent)
    : QScrollArea(parent),
      content_(named(new QWidget(this), "information_content")),
      lines_(new ButtonLines(this, kMargin)),
      column_(new QVBoxLayout(content_)),
      choices_(new QVBoxLayout),
      group_(new QButtonGroup(this)),
      searching_(with_role(named(new QLabel(tr("Searching for devices…"), content_), "searching"), "muted")),
      fit_text_(text_label("fit_text", content_, "muted")),
      step_(text_label("calibration_step", content_)),
      corner_(named(new QPushButton(content_), "corner")),
      hand_(named(new QComboBox(content_), "writing_hand", tr("Writing hand"))) {
  setObjectName(QStringLiteral("device_choice_panel"));
  setAccessibleName(tr("Devices and their position"));
  column_->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  column_->setSpacing(8);

  column_->addWidget(heading(tr("Device"), content_));
  choices_->setSpacing(4);
  column_->addLayout(choices_);
  searching_->setWordWrap(true);
  searching_->hide();
  column_->addWidget(searching_);
  column_->addWidget(button_for(actions.look_again));

  auto* fit_heading = heading(tr("Calibration"), content_);
  column_->addWidget(fit_heading);
  column_->addWidget(fit_text_);
  make_narrow(hand_, 4);
  hand_->addItems({tr("Right hand"), tr("Left hand")});
  column_->addWidget(hand_);
  tilt_ = new NumberSlider(tr("Tilt of the tablet"), QStringLiteral("tilt"), 0, 90, 5,
                           tr("%1°", "angle, 90 upright"), 0, content_);
  yaw_ = new NumberSlider(tr("Angle of your seat to the device"), QStringLiteral("yaw"), -60, 60, 5,
                          tr("%1°"), 0, content_);
  column_->addWidget(tilt_);
  column_->addWidget(yaw_);
  auto* by_corners = button_for(actions.calibrate);
  auto* by_itself = button_for(actions.fit);
  column_->addWidget(by_corners);
  lines_->add(corner_, tr("Set corner here"));
  connect(corner_, &QPushButton::clicked, this, &DeviceChoicePanel::corner_shown);
  column_->addWidget(step_);
  column_->addWidget(corner_);
  column_->addWidget(by_itself);

  auto* button_heading = heading(tr("Stylus buttons"), content_);
  column_->addWidget(button_heading);
  const QStringList does{tr("do nothing"), tr("next stroke"), tr("previous stroke"), tr("all strokes"),
                         tr("clear ink")};
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    const QString name = i == 0 ? tr("First button") : tr("Second button");
    auto* label = new QLabel(name, content_);
    label->setWordWrap(true);
    buttons_[i] = new QComboBox(content_);
    buttons_[i]->setObjectName(QStringLiteral("stylus_button_%1").arg(i + 1));
    buttons_[i]->setAccessibleName(name);
    buttons_[i]->addItems(does);
    make_narrow(buttons_[i], 4);
    label->setBuddy(buttons_[i]);
    column_->addWidget(label);
    column_->addWidget(buttons_[i]);
    only_with_force_.push_back(label);
    only_with_force_.push_back(buttons_[i]);
    connect(buttons_[i], &QComboBox::currentIndexChanged, this, [this] {
      if (!showing_)
        emit buttons_changed(static_cast<devices::ButtonDoes>(buttons_[0]->currentIndex()),
                             static_cast<devices::ButtonDoes>(buttons_[1]->currentIndex()));
    });
  }

  auto* limit_heading = heading(tr("Limits"), content_);
  column_->addWidget(limit_heading);
  force_ = new NumberSlider(tr("Force"), QStringLiteral("max_force"), 0.1, 1, 0.1, tr("%1 N"), 1, content_);
  stiffness_ = new NumberSlider(tr("Stiffness"), QStringLiteral("max_stiffness"), 50, 500, 10, tr("%1 N/m"),
                                0, content_);
  column_->addWidget(force_);
  column_->addWidget(stiffness_);
  column_->addStretch(1);
  for (QWidget* w :
       std::initializer_list<QWidget*>{fit_heading, hand_, tilt_, yaw_, by_corners, by_itself, fit_text_,
                                       button_heading, limit_heading, force_, stiffness_})
    only_with_force_.push_back(w);

  const auto tell_posture = [this] {
    if (showing_) return;
    devices::TabletPosture posture;
    posture.tilt_rad = tilt_->value() * kDegree;
    posture.yaw_rad = yaw_->value() * kDegree;
    posture.hand = hand_->currentIndex() == 1 ? devices::WritingHand::left : devices::WritingHand::right;
    emit posture_changed(posture);
  };
  const auto tell_limits = [this] { emit limits_changed(force_->value(), stiffness_->value()); };
  connect(hand_, &QComboBox::currentIndexChanged, this, tell_posture);
  connect(tilt_, &NumberSlider::moved, this, tell_posture);
  connect(yaw_, &NumberSlider::moved, this, tell_posture);
  connect(force_, &NumberSlider::moved, this, tell_limits);
  connect(stiffness_, &NumberSlider::moved, this, tell_limits);
  connect(group_, &QButtonGroup::buttonClicked, this,
          [this](QAbstractButton* button) { emit chosen(button->property("device").toString()); });
  make_scrolling(this, content_);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  show_step({});
}

QPushButton* DeviceChoicePanel::button_for(QAction* action) {
  auto* button = action_button(action, {}, content_);
  button->setAccessibleName(without_mnemonic(action->text()));
  lines_->add(button, without_mnemonic(action->text()));
  return button;
}

void DeviceChoicePanel::add_choice(const QString& id, const QString& text, bool checked) {
  auto* choice = new QRadioButton(content_);
  lines_->add(choice, text);
  choice->setAccessibleName(text);
  choice->setObjectName(QStringLiteral("device_%1").arg(id.isEmpty() ? QStringLiteral("best") : id));
  choice->setProperty("device", id);
  choice->setChecked(checked);
  group_->addButton(choice);
  choices_->addWidget(choice);
}

void DeviceChoicePanel::show_searching() { searching_->show(); }

void DeviceChoicePanel::focus_choice() {
  if (auto* chosen = group_->checkedButton()) chosen->setFocus(Qt::OtherFocusReason);
}

void DeviceChoicePanel::show_choices(const devices::DeviceChoices& choices) {
  const bool had_focus = focusWidget() != nullptr && qobject_cast<QRadioButton*>(focusWidget()) != nullptr;
  searching_->hide();
  for (auto* old : group_->buttons()) group_->removeButton(old);
  clear_layout(choices_);
  for (const auto& choice : choices.devices) {
    using State = devices::DeviceChoice::State;
    const QString name = device_name(choice.name);
    add_choice(to_text(choice.id),
               choice.id.empty()                      ? tr("Automatic (best available)")
               : choice.state == State::in_use        ? tr("%1 – in use").arg(name)
               : choice.state == State::not_connected ? tr("%1 – not connected").arg(name)
                                                      : name,
               choice.chosen);
  }
  for (const auto& back_end : choices.problems) {
    auto* reason = sentence_label("reason", content_, "muted");
    reason->setText(trouble_text(back_end.problem->trouble, device_name(back_end.back_end),
                                 to_text(back_end.problem->error.remedy)));
    reason->setToolTip(to_text(base::to_line(back_end.problem->error)));
    choices_->addWidget(reason);
  }
  if (had_focus && group_->checkedButton() != nullptr) group_->checkedButton()->setFocus();
}

void DeviceChoicePanel::show_device(const devices::DeviceSettings& settings,
                                    const haptics::DeviceDescription& own, double scale) {
  showing_ = true;
  for (auto* widget : only_with_force_) widget->setVisible(own.has_force);
  const QLocale locale;
  fit_text_->setText(settings.calibration
                         ? tr("Calibrated with corners: 1 cm of hand movement is %1 cm on the tablet.")
                               .arg(locale.toString(scale, 'f', 2))
                         : tr("Automatic fit: 1 cm of hand movement is %1 cm on the tablet.")
                               .arg(locale.toString(scale, 'f', 2)));
  hand_->setCurrentIndex(settings.posture.hand == devices::WritingHand::left ? 1 : 0);
  tilt_->set_value(settings.posture.tilt_rad / kDegree);
  yaw_->set_value(settings.posture.yaw_rad / kDegree);
  for (std::size_t i = 0; i < buttons_.size(); ++i)
    buttons_[i]->setCurrentIndex(static_cast<int>(settings.buttons[i]));
  const auto& limits = own.limits;
  force_->set_range(0.1, limits.max_force_n);
  force_->set_value(settings.max_force_n > 0 ? settings.max_force_n : limits.max_force_n);
  stiffness_->set_range(50, limits.max_stiffness_n_m);
  stiffness_->set_value(settings.max_stiffness_n_m > 0 ? settings.max_stiffness_n_m
                                                       : limits.max_stiffness_n_m);
  showing_ = false;
}

void DeviceChoicePanel::show_step(const QString& text) {
  step_->setText(text);
  step_->setVisible(!text.isEmpty());
  corner_->setVisible(!text.isEmpty());
  if (!text.isEmpty()) corner_->setFocus();
}

}  // namespace nazori::ui
