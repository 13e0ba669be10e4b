// SPDX-License-Identifier: Apache-2.0
#include "device/device_place.h"

#include <QSettings>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <utility>

#include "device/device_actions.h"
#include "device/feel_panel.h"
#include "device/seat_panel.h"
#include "device_text.h"
#include "error_text.h"
#include "kanji_text.h"
#include "signals.h"
#include "stored_settings.h"

namespace nazori::ui {

std::shared_ptr<const tablet::CarvedTablet> wall_and_groove(const geometry::TabletShape& shape) {
  constexpr int kSize = 512;
  auto map = surface::HeightMap::create(kSize);
  if (!map) return nullptr;
  for (int column = 0; column < kSize; ++column) {
    const double x = static_cast<double>(column) / (kSize - 1);
    // A floor, then a steep wall; a round groove in the plateau.
    const double wall = 0.1 + 0.9 * std::clamp((x - 0.30) / 0.06, 0.0, 1.0);
    const double off = (x - 0.68) / 0.035;
    const double height = std::min(wall, 1 - 0.8 * std::exp(-off * off));
    for (int row = 0; row < kSize; ++row) map->set(column, row, static_cast<float>(height));
  }
  kanji::StrokeLine line;
  line.points = {{0.68 * geometry::kGlyphSide, 15}, {0.68 * geometry::kGlyphSide, 94}};
  auto made = tablet::CarvedTablet::from_height_map(std::move(*map), {line}, shape);
  return made ? *made : nullptr;
}

DevicePlace::DevicePlace(Desk& desk)
    : Workplace(desk),
      stylus_(desk.tablet().device()),
      actions_(new DeviceActions(&desk.window())),
      seat_panel_(new SeatPanel(*actions_, &desk.window())),
      feel_panel_(new FeelPanel(stylus_, *actions_, &desk.window())) {
  QSettings settings(desk.settings_file(), QSettings::IniFormat);
  settings.beginGroup(id());
  memory_.load(read_settings(settings));
  desk.tablet().set_material(memory_.material);
  feel_panel_->show_material(memory_.material);
  connect_actions();
  connect_panels();
  connect_stylus();
  // Once the window is there.
  QTimer::singleShot(0, this, [this] { stylus_.choose(memory_.chosen); });
}

DevicePlace::~DevicePlace() = default;

QString DevicePlace::id() const { return QStringLiteral("device"); }
QString DevicePlace::name() const { return tr("&Device"); }
QString DevicePlace::purpose() const { return tr("What the tablet is felt with, and what it is made of"); }
Icon DevicePlace::drawing() const { return Icon::device; }

Workplace::Panel DevicePlace::left() const {
  return {seat_panel_, tr("&Devices"), tr("Show or fold away the devices")};
}

Workplace::Panel DevicePlace::right() const {
  return {feel_panel_, tr("&What is felt"), tr("Show or fold away what is felt")};
}

ActionSet* DevicePlace::actions() const { return actions_; }

QList<Tool> DevicePlace::tools() const {
  return {{actions_->look_again, true}, {}, {actions_->weaker, true}, {actions_->stronger, true}};
}

QString DevicePlace::tablet_description() const {
  return tr("A tablet to try the stylus on: a wall on the left, a groove on the right");
}

void DevicePlace::enter() {
  entered_ = true;
  if (!trial_tablet_) trial_tablet_ = wall_and_groove({});
  desk().tablet().set_tablet(trial_tablet_);
  // With another strength it starts anew, and knows nothing of its trouble for a moment.
  const auto status = stylus_.status();
  set_strength(kTrialStep);
  look_again();
  feel_panel_->watch(true);
  if (stylus_.opened() != nullptr && stylus_.is_pointer() && status.trouble != haptics::DeviceTrouble::none) {
    const QString name = device_name(stylus_.own_description().name);
    desk().say(Feedback::advice,
               tr("%1 Until then mouse and pen write.").arg(trouble_text(status.trouble, name)));
    return;
  }
  desk().say(
      Feedback::hint,
      stylus_.opened() != nullptr
          ? tr("Feel the wall and the groove gently. It becomes stronger only when you ask for it.")
          : tr("Mouse and pen see the wall and the groove. A device with force is felt as soon as it is "
               "plugged in."));
}

void DevicePlace::leave() {
  if (corner_ >= 0) end_calibration({}, Feedback::hint);
  entered_ = false;
  feel_panel_->watch(false);
  set_strength(1);
}

void DevicePlace::save(QSettings& settings) const {
  auto values = read_settings(settings);
  memory_.save(values);
  write_settings(settings, values);
}

void DevicePlace::connect_actions() {
  connect(actions_->look_again, &QAction::triggered, this, [this] {
    if (stylus_.opened() == nullptr) stylus_.choose(stylus_.chosen());
    look_again();
  });
  connect(actions_->stronger, &QAction::triggered, this,
          [this] { set_strength(stylus_.strength() + kTrialStep); });
  connect(actions_->weaker, &QAction::triggered, this,
          [this] { set_strength(stylus_.strength() - kTrialStep); });
  connect(actions_->calibrate, &QAction::triggered, this, [this] { calibrate(); });
  connect(actions_->fit, &QAction::triggered, this, [this] {
    settings().calibration.reset();
    reopen(tr("The tablet is as large as the stylus can reach."));
  });
}

void DevicePlace::connect_panels() {
  connect(seat_panel_, &SeatPanel::chosen, this, [this](const QString& id) { choose(id); });
  connect(seat_panel_, &SeatPanel::posture_changed, this, [this](const devices::TabletPosture& posture) {
    auto& of_device = settings();
    of_device.posture = posture;
    // Corners were shown for another posture.
    of_device.calibration.reset();
    posture_timer_.start();
  });
  // A slider on its way does not open the device at each step.
  posture_timer_.setSingleShot(true);
  posture_timer_.setInterval(kPostureRest_ms);
  connect(&posture_timer_, &QTimer::timeout, this,
          [this] { reopen(tr("The tablet stands as you set it.")); });
  connect(seat_panel_, &SeatPanel::buttons_changed, this,
          [this](devices::ButtonDoes first, devices::ButtonDoes second) {
            settings().buttons = {first, second};
            desk().save_later();
          });
  connect(seat_panel_, &SeatPanel::limits_changed, this, [this](double force_n, double stiffness_n_m) {
    auto& of_device = settings();
    of_device.max_force_n = force_n;
    of_device.max_stiffness_n_m = stiffness_n_m;
    stylus_.take_limits();
    desk().save_later();
  });
  connect(seat_panel_, &SeatPanel::corner_shown, this, [this] { take_corner(); });
  connect(feel_panel_, &FeelPanel::material_changed, this, [this](const haptics::Material& material) {
    memory_.material = material;
    desk().tablet().set_material(material);
    desk().save_later();
  });
}

void DevicePlace::connect_stylus() {
  stylus_.set_devices(desk().take_back_ends(), {}, [this] { return memory_.devices; });
  subscribe(stylus_.found, this, [this](const auto& findings) { show_findings(findings); });
  subscribe(stylus_.changed, this, [this] { show_device(); });
  // Not in the middle of taking samples: what a button does may open the device again.
  subscribe(stylus_.button_pressed, this, [this](int number) {
    QMetaObject::invokeMethod(
        this, [this, number] { press_button(number); }, Qt::QueuedConnection);
  });
  subscribe(stylus_.happened, this, [this](const devices::DeviceEvent& event) { report(event); });
}

void DevicePlace::report(const devices::DeviceEvent& event) {
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
      desk().tell(Feedback::advice, tr("%1 Until then mouse and pen write.").arg(trouble_));
      return;
    case refused:
      fitted_.clear();
      trouble_ = trouble_text(event.trouble, device, to_text(event.message));
      untold_ = true;  // what takes its place belongs into the same sentence
      return;
    case searched:
      if (untold_) desk().tell(Feedback::advice, tr("%1 Until then mouse and pen write.").arg(trouble_));
      untold_ = false;
      trouble_.clear();
      fitted_.clear();
      refresh();
      return;
  }
}

void DevicePlace::report_taken(const QString& device, bool again) {
  untold_ = false;
  if (again) trouble_.clear();
  if (!fitted_.isEmpty())
    desk().tell(Feedback::good, fitted_);
  else if (again)
    desk().tell(Feedback::good, tr("%1 goes on. What was written is still there.").arg(device));
  else if (trouble_.isEmpty())
    desk().tell(Feedback::good, tr("%1 has the tablet.").arg(device));
  else
    desk().tell(Feedback::advice, tr("%1 Until then %2 has the tablet.").arg(trouble_, device));
  if (!stylus_.is_searching()) refresh();
}

void DevicePlace::choose(const QString& id) {
  memory_.chosen = id.toStdString();
  desk().save_later();
  stylus_.choose(memory_.chosen);
  if (stylus_.is_searching()) seat_panel_->show_searching();
}

void DevicePlace::reopen(const QString& sentence) {
  desk().save_later();
  if (stylus_.opened() == nullptr) return;
  stylus_.reopen();
  fitted_ = sentence;
}

void DevicePlace::look_again() {
  seat_panel_->show_searching();
  stylus_.find();
  show_device();
}

void DevicePlace::show_findings(const std::vector<devices::BackEndFindings>& findings) {
  const auto* opened = stylus_.opened();
  seat_panel_->show_findings(findings, to_text(memory_.chosen),
                             opened != nullptr ? to_text(opened->id) : QStringLiteral("pointer"),
                             device_name(stylus_.own_description().name));
}

void DevicePlace::refresh() {
  if (entered_)
    look_again();
  else
    show_device();
}

void DevicePlace::show_device() {
  // What is turned at must not vanish under the hand while the device is opened anew.
  if (!stylus_.reopening().empty()) return;
  const auto* opened = stylus_.opened();
  const auto own = stylus_.own_description();
  const std::string id = opened != nullptr ? opened->id : "pointer";
  const bool has_force = opened != nullptr;
  seat_panel_->show_device(devices::settings_of(memory_.devices, id), own,
                           opened != nullptr ? opened->calibration.scale : 1);
  feel_panel_->show_strength(stylus_.strength(), has_force);
  for (auto* action : {actions_->calibrate, actions_->fit}) action->setEnabled(has_force);
  const double strength = stylus_.strength();
  actions_->stronger->setEnabled(has_force && strength < 1 - kTrialStep / 2);
  actions_->weaker->setEnabled(has_force && strength > kTrialStep * 1.5);
}

void DevicePlace::set_strength(double strength) {
  stylus_.set_strength(std::clamp(strength, kTrialStep, 1.0));
  show_device();
}

devices::DeviceSettings& DevicePlace::settings() {
  const auto* opened = stylus_.opened();
  if (opened != nullptr) return memory_.devices[opened->id];
  const std::string& reopening = stylus_.reopening();
  return memory_.devices[reopening.empty() ? "pointer" : reopening];
}

void DevicePlace::calibrate() {
  if (stylus_.opened() == nullptr || stylus_.is_pointer()) {
    desk().say(Feedback::advice, tr("There is no device to be fitted."));
    return;
  }
  // Nothing pushes while the hand shows where the tablet is to be.
  desk().tablet().set_tablet(nullptr);
  corner_ = 0;
  seat_panel_->show_step(tr("1 of 3: hold the tip where the bottom left corner is to be."));
  desk().say(Feedback::hint, tr("Show three corners of the tablet in the air or on the desk."));
}

void DevicePlace::take_corner() {
  const auto* opened = stylus_.opened();
  if (corner_ < 0 || opened == nullptr || stylus_.is_pointer()) {
    end_calibration(tr("The device went away. The tablet is as it was."), Feedback::advice);
    return;
  }
  const auto mapping = devices::WorkspaceMapping::create(opened->calibration);
  const haptics::Vec3 tip_m = stylus_.latest().device_m;
  corners_m_[static_cast<std::size_t>(corner_)] = mapping ? mapping->to_device_m(tip_m) : tip_m;
  ++corner_;
  if (corner_ < 3) {
    seat_panel_->show_step(corner_ == 1 ? tr("2 of 3: hold the tip where the bottom right corner is to be.")
                                        : tr("3 of 3: hold the tip where the top left corner is to be."));
    return;
  }
  auto& of_device = settings();
  const auto fitted = devices::calibrate_from_corners(corners_m_[0], corners_m_[1], corners_m_[2], {},
                                                      of_device.posture.hand);
  if (!fitted) {
    end_calibration(
        tr("These corners make no tablet: they must be at least 2 cm apart, square, and in order. "
           "The tablet is as it was."),
        Feedback::wrong);
    return;
  }
  of_device.calibration = *fitted;
  of_device.posture = fitted->posture;
  end_calibration({}, Feedback::hint);
  reopen(tr("The tablet stands where you showed it."));
}

void DevicePlace::end_calibration(const QString& sentence, Feedback kind) {
  corner_ = -1;
  seat_panel_->show_step({});
  if (entered_) desk().tablet().set_tablet(trial_tablet_);
  desk().say(kind, sentence);
}

void DevicePlace::press_button(int number) {
  if (corner_ >= 0) {
    take_corner();
    return;
  }
  if (stylus_.opened() == nullptr) return;
  const auto buttons = devices::settings_of(memory_.devices, stylus_.opened()->id).buttons;
  if (number < 0 || number >= static_cast<int>(buttons.size())) return;
  auto& controller = desk().tablet();
  switch (buttons[static_cast<std::size_t>(number)]) {
    case devices::ButtonDoes::nothing:
      return;
    case devices::ButtonDoes::next_stroke:
      controller.next_stroke();
      return;
    case devices::ButtonDoes::previous_stroke:
      controller.previous_stroke();
      return;
    case devices::ButtonDoes::all_strokes:
      controller.set_current_stroke(0);
      return;
    case devices::ButtonDoes::clear_ink:
      controller.clear_ink();
      return;
  }
}

}  // namespace nazori::ui
