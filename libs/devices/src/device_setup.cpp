// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/device_setup.h"

#include <algorithm>
#include <utility>

namespace nazori::devices {

DeviceChoices device_choices(const std::vector<BackEndFindings>& findings, const DeviceMemory& memory,
                             const std::string& in_use, const std::string& in_use_name) {
  using State = DeviceChoice::State;
  const std::string& chosen = memory.chosen;
  DeviceChoices all;
  const auto add = [&](const std::string& id, const std::string& name, State state) {
    all.devices.push_back({id, name, state, id == chosen});
  };
  const auto is_listed = [&all](const std::string& id) {
    return std::any_of(all.devices.begin(), all.devices.end(),
                       [&id](const auto& one) { return one.id == id; });
  };
  add({}, {}, State::found);
  for (const auto& back_end : findings) {
    bool ours = false;
    for (const auto& device : back_end.devices) {
      ours = ours || device.id == in_use;
      add(device.id, device.name, device.id == in_use ? State::in_use : State::found);
    }
    // The search cannot open a device that is in use here.
    if (back_end.problem && !(back_end.problem->trouble == haptics::DeviceTrouble::in_use && ours))
      all.problems.push_back(back_end);
  }
  if (!is_listed(in_use)) add(in_use, in_use_name, State::in_use);
  if (!is_listed(chosen)) {
    const std::string name = settings_of(memory.devices, chosen).name;
    add(chosen, name.empty() ? chosen : name, State::not_connected);
  }
  return all;
}

DeviceSetup::DeviceSetup(TabletDevice& device, TabletDevice::BackEnds back_ends) : device_(device) {
  device_.set_devices(std::move(back_ends), {}, [memory = memory_] { return memory->devices; });
  happened_ = device_.happened.connect([this](const DeviceEvent& event) { follow(event); });
}

void DeviceSetup::follow(const DeviceEvent& event) {
  using enum DeviceEventKind;
  const auto report_missing = [this] { news({DeviceNewsKind::missing, {}, {}, *missing_}); };
  switch (event.kind) {
    case taken:
    case resumed:
      report_use(event);
      return;
    case paused:
    case lost:
      missing_ = MissingDevice{event.device, event.trouble, {}};
      report_missing();
      return;
    case refused:
      change_ = DeviceChange::none;
      missing_ = MissingDevice{event.device, event.trouble, event.message};
      missing_is_news_ = true;  // the news also says which device replaces it
      return;
    case searched:
      if (missing_is_news_) report_missing();
      missing_is_news_ = false;
      missing_.reset();
      change_ = DeviceChange::none;
      settled();
      return;
  }
}

void DeviceSetup::report_use(const DeviceEvent& event) {
  if (device_.opened() != nullptr) memory_->devices[id_in_use()].name = event.device;
  const bool again = event.kind == DeviceEventKind::resumed;
  missing_is_news_ = false;
  if (again) missing_.reset();
  if (change_ != DeviceChange::none)
    news({DeviceNewsKind::changed, event.device, change_, {}});
  else if (again)
    news({DeviceNewsKind::works_again, event.device, {}, {}});
  else if (missing_)
    news({DeviceNewsKind::replaced, event.device, {}, *missing_});
  else
    news({DeviceNewsKind::in_use, event.device, {}, {}});
  if (!device_.is_searching()) settled();
}

void DeviceSetup::choose(const std::string& id) {
  memory_->chosen = id;
  open_chosen();
}

std::string DeviceSetup::id_in_use() const {
  const auto* opened = device_.opened();
  return opened != nullptr ? opened->id : "pointer";
}

DeviceSettings& DeviceSetup::own() {
  const std::string& reopening = device_.reopening();
  return memory_->devices[device_.opened() == nullptr && !reopening.empty() ? reopening : id_in_use()];
}

void DeviceSetup::set_posture(const TabletPosture& posture) {
  auto& settings = own();
  settings.posture = posture;
  settings.calibration.reset();
}

void DeviceSetup::set_limits(double force_n, double stiffness_n_m) {
  auto& settings = own();
  settings.max_force_n = force_n;
  settings.max_stiffness_n_m = stiffness_n_m;
  device_.apply_limits();
}

void DeviceSetup::fit() {
  own().calibration.reset();
  apply(DeviceChange::automatic_fit);
}

void DeviceSetup::apply(DeviceChange change) {
  if (device_.opened() == nullptr) return;
  device_.reopen();
  change_ = change;
}

void DeviceSetup::set_strength(double strength) {
  device_.set_strength(std::clamp(strength, kTrialStep, 1.0));
}

bool DeviceSetup::can_be_stronger() const {
  return device_.opened() != nullptr && device_.strength() < 1 - kTrialStep / 2;
}

bool DeviceSetup::can_be_weaker() const {
  return device_.opened() != nullptr && device_.strength() > kTrialStep * 1.5;
}

bool DeviceSetup::begin_calibration() {
  if (device_.opened() == nullptr || device_.is_pointer()) return false;
  corner_ = 0;
  return true;
}

DeviceSetup::Corner DeviceSetup::add_corner() {
  const auto* opened = device_.opened();
  if (corner_ < 0 || opened == nullptr || device_.is_pointer()) {
    stop_calibration();
    return Corner::no_device;
  }
  const auto mapping = WorkspaceMapping::create(opened->calibration);
  const haptics::Vec3 tip_m = device_.latest().device_m;
  corners_m_[static_cast<std::size_t>(corner_)] = mapping ? mapping->to_device_m(tip_m) : tip_m;
  if (++corner_ < kCorners) return Corner::next;
  stop_calibration();
  auto& settings = own();
  const auto fitted =
      calibrate_from_corners(corners_m_[0], corners_m_[1], corners_m_[2], {}, settings.posture.hand);
  if (!fitted) return Corner::no_tablet;
  settings.calibration = *fitted;
  settings.posture = fitted->posture;
  apply(DeviceChange::corners);
  return Corner::done;
}

ButtonDoes DeviceSetup::action_of(int number) const {
  const auto buttons = settings().buttons;
  if (device_.opened() == nullptr || number < 0 || number >= static_cast<int>(buttons.size()))
    return ButtonDoes::nothing;
  return buttons[static_cast<std::size_t>(number)];
}

}  // namespace nazori::devices
