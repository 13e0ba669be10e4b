// SPDX-License-Identifier: Apache-2.0
#include "device/device_page.h"

#include <QLocale>
#include <QSettings>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "device/device_actions.h"
#include "device/device_choice_panel.h"
#include "device/feel_panel.h"
#include "nazori/surface/ball_surface.h"
#include "nazori/tablet/trial_tablet.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "nazori/widgets/words/device_text.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr double kTipStep_m = 0.0005;

}  // namespace

DevicePage::DevicePage(WindowParts& parts)
    : Page(parts, {QStringLiteral("device"), tr("&Device"),
                   tr("The device you feel the tablet with, and the material of the tablet"), Icon::device,
                   tr("A tablet to try the stylus on: a wall on the left, a groove on the right")}),
      stylus_(parts.tablet().device()),
      setup_(stylus_, parts.take_back_ends()),
      actions_(new DeviceActions(&parts.window())),
      choice_panel_(new DeviceChoicePanel(*actions_, &parts.window())),
      feel_panel_(new FeelPanel(stylus_, *actions_, &parts.window())) {
  QSettings settings(parts.settings_file(), QSettings::IniFormat);
  settings.beginGroup(id());
  setup_.load(read_settings(settings));
  parts.tablet().set_material(setup_.memory().material);
  parts.tablet().set_tip(setup_.memory().tip_radius_m);
  feel_panel_->show_material(setup_.memory().material);
  feel_panel_->show_tip(setup_.memory().tip_radius_m);
  connect_actions();
  connect_panels();
  connect_stylus();
  // After the window is shown.
  QTimer::singleShot(0, this, [this] { setup_.open_chosen(); });
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
  setup_.set_strength(devices::DeviceSetup::kTrialStep);
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
  if (setup_.corner() >= 0) end_calibration({}, Feedback::hint);
  entered_ = false;
  feel_panel_->watch(false);
  setup_.set_strength(1);
  show_device();
}

void DevicePage::save(QSettings& settings) const {
  auto values = read_settings(settings);
  setup_.memory().save(values);
  write_settings(settings, values);
}

void DevicePage::connect_actions() {
  on(actions_->look_again, [this] {
    if (stylus_.opened() == nullptr) stylus_.choose(stylus_.chosen());
    look_again();
  });
  on(actions_->choose, [this] {
    this->parts().open_left_panel();
    choice_panel_->focus_choice();
  });
  for (const auto& [action, steps] : {std::pair{actions_->stronger, +1}, std::pair{actions_->weaker, -1}})
    on(action, [this, steps = steps] {
      setup_.change_strength(steps);
      show_device();
    });
  for (const auto& [action, steps] :
       {std::pair{actions_->larger_tip, +1}, std::pair{actions_->smaller_tip, -1}})
    on(action, [this, steps = steps] {
      const double radius_m =
          std::clamp(setup_.memory().tip_radius_m + steps * kTipStep_m, 0.0, surface::kLargestBall_m);
      set_tip(radius_m);
      feel_panel_->show_tip(radius_m);
      parts().respond(
          Feedback::hint,
          radius_m > 0
              ? tr("Radius of the ball at the tip: %1 mm.").arg(QLocale().toString(1e3 * radius_m, 'f', 1))
              : tr("The tip is a point."));
    });
  on(actions_->calibrate, [this] { calibrate(); });
  on(actions_->fit, [this] {
    setup_.fit();
    parts().save_later();
  });
}

void DevicePage::connect_panels() {
  connect(choice_panel_, &DeviceChoicePanel::chosen, this, [this](const QString& id) {
    setup_.choose(id.toStdString());
    parts().save_later();
    if (stylus_.is_searching()) choice_panel_->show_searching();
  });
  connect(choice_panel_, &DeviceChoicePanel::posture_changed, this,
          [this](const devices::TabletPosture& posture) {
            setup_.set_posture(posture);
            posture_timer_.start();
          });
  // Waits until the slider rests, so that not every step opens the device again.
  posture_timer_.setSingleShot(true);
  posture_timer_.setInterval(kPostureRest_ms);
  connect(&posture_timer_, &QTimer::timeout, this, [this] {
    setup_.apply(devices::DeviceChange::posture);
    parts().save_later();
  });
  connect(choice_panel_, &DeviceChoicePanel::buttons_changed, this,
          [this](devices::ButtonDoes first, devices::ButtonDoes second) {
            setup_.set_buttons({first, second});
            parts().save_later();
          });
  connect(choice_panel_, &DeviceChoicePanel::limits_changed, this,
          [this](double force_n, double stiffness_n_m) {
            setup_.set_limits(force_n, stiffness_n_m);
            parts().save_later();
          });
  connect(choice_panel_, &DeviceChoicePanel::corner_shown, this, [this] { add_corner(); });
  connect(feel_panel_, &FeelPanel::material_changed, this, [this](const haptics::Material& material) {
    setup_.set_material(material);
    parts().tablet().set_material(material);
    parts().save_later();
  });
  connect(feel_panel_, &FeelPanel::tip_changed, this, &DevicePage::set_tip);
}

void DevicePage::set_tip(double radius_m) {
  setup_.set_tip(radius_m);
  parts().tablet().set_tip(radius_m);
  parts().save_later();
}

void DevicePage::connect_stylus() {
  subscribe(stylus_.found, this, [this](const auto& findings) {
    choice_panel_->show_choices(devices::device_choices(findings, setup_.memory(), setup_.id_in_use(),
                                                        stylus_.own_description().name));
  });
  subscribe(stylus_.changed, this, [this] { show_device(); });
  // Queued: the action of a button may open the device again, which must not happen while samples are read.
  subscribe(stylus_.button_pressed, this, [this](int number) {
    QMetaObject::invokeMethod(
        this, [this, number] { press_button(number); }, Qt::QueuedConnection);
  });
  subscribe(setup_.news, this, [this](const devices::DeviceNews& news) { report(news); });
  subscribe(setup_.settled, this, [this] {
    if (entered_)
      look_again();
    else
      show_device();
  });
}

void DevicePage::report(const devices::DeviceNews& news) {
  const QString device = device_name(news.device);
  const auto trouble = [&not_used = news.missing] {
    return trouble_text(not_used.trouble, device_name(not_used.device), to_text(not_used.message));
  };
  using enum devices::DeviceNewsKind;
  switch (news.kind) {
    case in_use:
      parts().save_later();
      parts().announce_when_open(Feedback::good, tr("Now using %1.").arg(device));
      return;
    case works_again:
      parts().announce_when_open(Feedback::good,
                                 tr("%1 is working again. Your writing is still there.").arg(device));
      return;
    case changed:
      parts().announce_when_open(Feedback::good, change_words(news.change));
      return;
    case replaced:
      parts().announce_when_open(Feedback::advice, tr("%1 Until then, %2 is used.").arg(trouble(), device));
      return;
    case missing:
      parts().announce_when_open(Feedback::advice, tr("%1 Until then, use a mouse or pen.").arg(trouble()));
      return;
  }
}

QString DevicePage::change_words(devices::DeviceChange change) {
  switch (change) {
    case devices::DeviceChange::automatic_fit:
      return tr("The tablet is now as large as the stylus can reach.");
    case devices::DeviceChange::posture:
      return tr("The position of the tablet was updated.");
    case devices::DeviceChange::corners:
      return tr("The tablet is now where you pointed.");
    case devices::DeviceChange::none:
      break;
  }
  return {};
}

void DevicePage::look_again() {
  choice_panel_->show_searching();
  stylus_.find();
  show_device();
}

void DevicePage::show_device() {
  // A control that the learner is using must not disappear while the device is opened again.
  if (!stylus_.reopening().empty()) return;
  const auto* opened = stylus_.opened();
  const bool has_force = opened != nullptr;
  choice_panel_->show_device(setup_.settings(), stylus_.own_description(),
                             opened != nullptr ? opened->calibration.scale : 1);
  feel_panel_->show_strength(stylus_.strength(), has_force);
  for (auto* action : {actions_->calibrate, actions_->fit}) action->setEnabled(has_force);
  actions_->stronger->setEnabled(setup_.can_be_stronger());
  actions_->weaker->setEnabled(setup_.can_be_weaker());
}

void DevicePage::calibrate() {
  if (!setup_.begin_calibration()) {
    parts().announce(Feedback::advice, tr("There is no device to calibrate."));
    return;
  }
  // No force while the learner shows the corners of the tablet.
  parts().tablet().set_tablet(nullptr);
  choice_panel_->show_step(tr("1 of 3: hold the tip where you want the bottom left corner."));
  parts().announce(Feedback::hint, tr("Point at three corners for the tablet, in the air or on your desk."));
}

void DevicePage::add_corner() {
  using enum devices::DeviceSetup::Corner;
  switch (setup_.add_corner()) {
    case next:
      choice_panel_->show_step(setup_.corner() == 1
                                   ? tr("2 of 3: hold the tip where you want the bottom right corner.")
                                   : tr("3 of 3: hold the tip where you want the top left corner."));
      return;
    case no_device:
      end_calibration(tr("The device was disconnected. The tablet was not changed."), Feedback::advice);
      return;
    case no_tablet:
      end_calibration(
          tr("These corners do not form a tablet. Point at them in order, at least 2 cm apart, as "
             "the corners of a square. The tablet was not changed."),
          Feedback::wrong);
      return;
    case done:
      end_calibration({}, Feedback::hint);
      parts().save_later();
      return;
  }
}

void DevicePage::end_calibration(const QString& sentence, Feedback kind) {
  setup_.stop_calibration();
  choice_panel_->show_step({});
  if (entered_) parts().tablet().set_tablet(trial_tablet_);
  parts().announce(kind, sentence);
}

void DevicePage::press_button(int number) {
  if (setup_.corner() >= 0)
    add_corner();
  else
    parts().tablet().press_button(setup_.action_of(number));
}

}  // namespace nazori::ui
