// SPDX-License-Identifier: Apache-2.0
#include "device/device_page.h"

#include <QSettings>
#include <QTimer>
#include <algorithm>

#include "device/device_actions.h"
#include "device/device_choice_panel.h"
#include "device/feel_panel.h"
#include "events/signals.h"
#include "nazori/tablet/trial_tablet.h"
#include "settings/stored_settings.h"
#include "words/device_text.h"
#include "words/error_text.h"
#include "words/kanji_text.h"

namespace nazori::ui {

DevicePage::DevicePage(WindowParts& parts)
    : Page(parts, {QStringLiteral("device"), tr("&Device"),
                   tr("The device you feel the tablet with, and the material of the tablet"), Icon::device,
                   tr("A tablet to try the stylus on: a wall on the left, a groove on the right")}),
      stylus_(parts.tablet().device()),
      actions_(new DeviceActions(&parts.window())),
      choice_panel_(new DeviceChoicePanel(*actions_, &parts.window())),
      feel_panel_(new FeelPanel(stylus_, *actions_, &parts.window())) {
  QSettings settings(parts.settings_file(), QSettings::IniFormat);
  settings.beginGroup(id());
  memory_.load(read_settings(settings));
  parts.tablet().set_material(memory_.material);
  feel_panel_->show_material(memory_.material);
  connect_actions();
  connect_panels();
  connect_stylus();
  // After the window is shown.
  QTimer::singleShot(0, this, [this] { stylus_.choose(memory_.chosen); });
}

DevicePage::~DevicePage() = default;

Page::Panel DevicePage::left() const {
  return {choice_panel_, tr("&Devices"), tr("Show or hide the devices")};
}

Page::Panel DevicePage::right() const {
  return {feel_panel_, tr("&What you feel"), tr("Show or hide what you feel")};
}

ActionSet* DevicePage::actions() const { return actions_; }

QList<Tool> DevicePage::tools() const {
  return {{actions_->look_again, true}, {}, {actions_->weaker, true}, {actions_->stronger, true}};
}

void DevicePage::enter() {
  entered_ = true;
  if (!trial_tablet_) trial_tablet_ = tablet::wall_and_groove({});
  parts().tablet().set_tablet(trial_tablet_);
  // A new strength restarts the device. For a moment the status does not know the problem.
  const auto status = stylus_.status();
  set_strength(kTrialStep);
  look_again();
  feel_panel_->watch(true);
  if (stylus_.opened() != nullptr && stylus_.is_pointer() && status.trouble != haptics::DeviceTrouble::none) {
    const QString name = device_name(stylus_.own_description().name);
    parts().announce(Feedback::advice,
                     tr("%1 Until then, use a mouse or pen.").arg(trouble_text(status.trouble, name)));
    return;
  }
  parts().announce(Feedback::hint,
                   stylus_.opened() != nullptr
                       ? tr("Touch the wall and the groove gently. The force grows only when you ask for it.")
                       : tr("With a mouse or pen you can only see the wall and the groove. Plug in a "
                            "force-feedback device to feel them."));
}

void DevicePage::leave() {
  if (corner_ >= 0) end_calibration({}, Feedback::hint);
  entered_ = false;
  feel_panel_->watch(false);
  set_strength(1);
}

void DevicePage::save(QSettings& settings) const {
  auto values = read_settings(settings);
  memory_.save(values);
  write_settings(settings, values);
}

void DevicePage::connect_actions() {
  on(actions_->look_again, [this] {
    if (stylus_.opened() == nullptr) stylus_.choose(stylus_.chosen());
    look_again();
  });
  on(actions_->stronger, [this] { set_strength(stylus_.strength() + kTrialStep); });
  on(actions_->weaker, [this] { set_strength(stylus_.strength() - kTrialStep); });
  on(actions_->calibrate, [this] { calibrate(); });
  on(actions_->fit, [this] {
    settings().calibration.reset();
    reopen(tr("The tablet is now as large as the stylus can reach."));
  });
}

void DevicePage::connect_panels() {
  connect(choice_panel_, &DeviceChoicePanel::chosen, this, [this](const QString& id) { choose(id); });
  connect(choice_panel_, &DeviceChoicePanel::posture_changed, this,
          [this](const devices::TabletPosture& posture) {
            auto& of_device = settings();
            of_device.posture = posture;
            // The calibration was made for another posture.
            of_device.calibration.reset();
            posture_timer_.start();
          });
  // Waits until the slider rests, so that not every step opens the device again.
  posture_timer_.setSingleShot(true);
  posture_timer_.setInterval(kPostureRest_ms);
  connect(&posture_timer_, &QTimer::timeout, this,
          [this] { reopen(tr("The position of the tablet was updated.")); });
  connect(choice_panel_, &DeviceChoicePanel::buttons_changed, this,
          [this](devices::ButtonDoes first, devices::ButtonDoes second) {
            settings().buttons = {first, second};
            parts().save_later();
          });
  connect(choice_panel_, &DeviceChoicePanel::limits_changed, this,
          [this](double force_n, double stiffness_n_m) {
            auto& of_device = settings();
            of_device.max_force_n = force_n;
            of_device.max_stiffness_n_m = stiffness_n_m;
            stylus_.apply_limits();
            parts().save_later();
          });
  connect(choice_panel_, &DeviceChoicePanel::corner_shown, this, [this] { add_corner(); });
  connect(feel_panel_, &FeelPanel::material_changed, this, [this](const haptics::Material& material) {
    memory_.material = material;
    parts().tablet().set_material(material);
    parts().save_later();
  });
}

void DevicePage::connect_stylus() {
  stylus_.set_devices(parts().take_back_ends(), {}, [this] { return memory_.devices; });
  subscribe(stylus_.found, this, [this](const auto& findings) { show_findings(findings); });
  subscribe(stylus_.changed, this, [this] { show_device(); });
  // Queued: the action of a button may open the device again, which must not happen while samples are read.
  subscribe(stylus_.button_pressed, this, [this](int number) {
    QMetaObject::invokeMethod(
        this, [this, number] { press_button(number); }, Qt::QueuedConnection);
  });
  subscribe(stylus_.happened, this, [this](const devices::DeviceEvent& event) { report(event); });
}

void DevicePage::report(const devices::DeviceEvent& event) {
  const QString device = device_name(event.device);
  using enum devices::DeviceEventKind;
  switch (event.kind) {
    case taken:
    case resumed:
      report_taken(device, event.kind == resumed);
      return;
    case paused:
    case lost:
      trouble_ = trouble_text(event.trouble, device);
      parts().announce_when_open(Feedback::advice, tr("%1 Until then, use a mouse or pen.").arg(trouble_));
      return;
    case refused:
      fitted_.clear();
      trouble_ = trouble_text(event.trouble, device, to_text(event.message));
      trouble_to_announce_ = true;  // the sentence also says which device replaces it
      return;
    case searched:
      if (trouble_to_announce_)
        parts().announce_when_open(Feedback::advice, tr("%1 Until then, use a mouse or pen.").arg(trouble_));
      trouble_to_announce_ = false;
      trouble_.clear();
      fitted_.clear();
      refresh();
      return;
  }
}

void DevicePage::report_taken(const QString& device, bool again) {
  trouble_to_announce_ = false;
  if (again) trouble_.clear();
  if (!fitted_.isEmpty())
    parts().announce_when_open(Feedback::good, fitted_);
  else if (again)
    parts().announce_when_open(Feedback::good,
                               tr("%1 is working again. Your writing is still there.").arg(device));
  else if (trouble_.isEmpty())
    parts().announce_when_open(Feedback::good, tr("Now using %1.").arg(device));
  else
    parts().announce_when_open(Feedback::advice, tr("%1 Until then, %2 is used.").arg(trouble_, device));
  if (!stylus_.is_searching()) refresh();
}

void DevicePage::choose(const QString& id) {
  memory_.chosen = id.toStdString();
  parts().save_later();
  stylus_.choose(memory_.chosen);
  if (stylus_.is_searching()) choice_panel_->show_searching();
}

void DevicePage::reopen(const QString& sentence) {
  parts().save_later();
  if (stylus_.opened() == nullptr) return;
  stylus_.reopen();
  fitted_ = sentence;
}

void DevicePage::look_again() {
  choice_panel_->show_searching();
  stylus_.find();
  show_device();
}

void DevicePage::show_findings(const std::vector<devices::BackEndFindings>& findings) {
  const auto* opened = stylus_.opened();
  choice_panel_->show_findings(findings, to_text(memory_.chosen),
                               opened != nullptr ? to_text(opened->id) : QStringLiteral("pointer"),
                               device_name(stylus_.own_description().name));
}

void DevicePage::refresh() {
  if (entered_)
    look_again();
  else
    show_device();
}

void DevicePage::show_device() {
  // A control that the learner is using must not disappear while the device is opened again.
  if (!stylus_.reopening().empty()) return;
  const auto* opened = stylus_.opened();
  const auto own = stylus_.own_description();
  const std::string id = opened != nullptr ? opened->id : "pointer";
  const bool has_force = opened != nullptr;
  choice_panel_->show_device(devices::settings_of(memory_.devices, id), own,
                             opened != nullptr ? opened->calibration.scale : 1);
  feel_panel_->show_strength(stylus_.strength(), has_force);
  for (auto* action : {actions_->calibrate, actions_->fit}) action->setEnabled(has_force);
  const double strength = stylus_.strength();
  actions_->stronger->setEnabled(has_force && strength < 1 - kTrialStep / 2);
  actions_->weaker->setEnabled(has_force && strength > kTrialStep * 1.5);
}

void DevicePage::set_strength(double strength) {
  stylus_.set_strength(std::clamp(strength, kTrialStep, 1.0));
  show_device();
}

devices::DeviceSettings& DevicePage::settings() {
  const auto* opened = stylus_.opened();
  if (opened != nullptr) return memory_.devices[opened->id];
  const std::string& reopening = stylus_.reopening();
  return memory_.devices[reopening.empty() ? "pointer" : reopening];
}

void DevicePage::calibrate() {
  if (stylus_.opened() == nullptr || stylus_.is_pointer()) {
    parts().announce(Feedback::advice, tr("There is no device to calibrate."));
    return;
  }
  // No force while the learner shows the corners of the tablet.
  parts().tablet().set_tablet(nullptr);
  corner_ = 0;
  choice_panel_->show_step(tr("1 of 3: hold the tip where you want the bottom left corner."));
  parts().announce(Feedback::hint, tr("Point at three corners for the tablet, in the air or on your desk."));
}

void DevicePage::add_corner() {
  const auto* opened = stylus_.opened();
  if (corner_ < 0 || opened == nullptr || stylus_.is_pointer()) {
    end_calibration(tr("The device was disconnected. The tablet was not changed."), Feedback::advice);
    return;
  }
  const auto mapping = devices::WorkspaceMapping::create(opened->calibration);
  const haptics::Vec3 tip_m = stylus_.latest().device_m;
  corners_m_[static_cast<std::size_t>(corner_)] = mapping ? mapping->to_device_m(tip_m) : tip_m;
  ++corner_;
  if (corner_ < 3) {
    choice_panel_->show_step(corner_ == 1 ? tr("2 of 3: hold the tip where you want the bottom right corner.")
                                          : tr("3 of 3: hold the tip where you want the top left corner."));
    return;
  }
  auto& of_device = settings();
  const auto fitted = devices::calibrate_from_corners(corners_m_[0], corners_m_[1], corners_m_[2], {},
                                                      of_device.posture.hand);
  if (!fitted) {
    end_calibration(tr("These corners do not form a tablet. Point at them in order, at least 2 cm apart, as "
                       "the corners of a square. The tablet was not changed."),
                    Feedback::wrong);
    return;
  }
  of_device.calibration = *fitted;
  of_device.posture = fitted->posture;
  end_calibration({}, Feedback::hint);
  reopen(tr("The tablet is now where you pointed."));
}

void DevicePage::end_calibration(const QString& sentence, Feedback kind) {
  corner_ = -1;
  choice_panel_->show_step({});
  if (entered_) parts().tablet().set_tablet(trial_tablet_);
  parts().announce(kind, sentence);
}

void DevicePage::press_button(int number) {
  if (corner_ >= 0) {
    add_corner();
    return;
  }
  if (stylus_.opened() == nullptr) return;
  const auto buttons = devices::settings_of(memory_.devices, stylus_.opened()->id).buttons;
  if (number < 0 || number >= static_cast<int>(buttons.size())) return;
  parts().tablet().press_button(buttons[static_cast<std::size_t>(number)]);
}

}  // namespace nazori::ui
