// SPDX-License-Identifier: Apache-2.0
#include "stylus.h"

#include <algorithm>
#include <utility>

#include "kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kLook_ms = 100;
constexpr int kSeek_ms = 3000;
// Looking for devices may hold up the window: it may do so for at most this share of the time.
constexpr int kSeekShare = 50;
constexpr int kLongestSeek_ms = 120'000;
const std::string kPointer = "pointer";

using haptics::DeviceState;
using haptics::DeviceTrouble;

}  // namespace

Stylus::Stylus(QObject* parent) : QObject(parent) {
  pointer_seat_.opened.id = kPointer;
  pointer_seat_.description = pointer_.describe();
  pointer_seat_.servo = std::make_unique<haptics::Servo>(pointer_seat_.description);
  look_timer_.setInterval(kLook_ms);
  connect(&look_timer_, &QTimer::timeout, this, &Stylus::look);
  seek_timer_.setSingleShot(true);
  connect(&seek_timer_, &QTimer::timeout, this, &Stylus::seek);
}

Stylus::~Stylus() {
  if (device_) device_->opened.device->stop();
  pointer_.stop();
}

base::Result<void> Stylus::start() { return is_pointer() ? pointer_.start(servo()) : base::Result<void>(); }

void Stylus::set_scene(std::shared_ptr<const haptics::HapticScene> scene) {
  scene_ = std::move(scene);
  active_->servo->set_scene(scene_);
  // A paused device goes on by itself: what it feels then must be this.
  if (device_ && is_pointer()) device_->servo->set_scene(scene_);
}

std::size_t Stylus::take_samples(std::span<haptics::ServoSample> out) {
  const auto count = active_->servo->take_samples(out);
  const std::span<const haptics::ServoSample> taken = out.first(count);
  if (count > 0) emit sampled(taken);
  if (is_pointer()) {
    if (count > 0) pressed_ = taken.back().buttons != 0;
    return count;
  }
  for (const auto& sample : taken) {
    const std::uint32_t down = sample.buttons & ~std::exchange(buttons_, sample.buttons);
    for (int number = 0; number < 32; ++number)
      if ((down >> number & 1U) != 0) emit button_pressed(number);
  }
  return count;
}

haptics::DeviceStatus Stylus::status() const {
  if (device_) return device_->opened.device->status();
  return pointer_.status();
}

haptics::DeviceDescription Stylus::own_description() const {
  return device_ ? device_->opened.device->describe() : pointer_seat_.description;
}

void Stylus::set_devices(BackEnds back_ends, const geometry::TabletShape& shape, Remembered remembered) {
  catalogue_ = std::make_unique<devices::DeviceCatalogue>(std::move(back_ends));
  shape_ = shape;
  remembered_ = std::move(remembered);
}

std::vector<devices::BackEndFindings> Stylus::find() {
  return catalogue_ ? catalogue_->find() : std::vector<devices::BackEndFindings>{};
}

devices::OpenRequest Stylus::request_for(const std::string& id) const {
  const DeviceSettings settings = remembered_ ? remembered_(id) : DeviceSettings{};
  return {shape_, settings.posture, settings.calibration};
}

void Stylus::choose(const std::string& id) {
  chosen_ = id;
  lost_.clear();
  seek_timer_.stop();
  close_device();
  if (!catalogue_ || id == kPointer) return;
  if ((id.empty() || !open(id, true)) && !open_best(id)) lost_ = id;
  seek_later();
}

void Stylus::reopen() {
  if (!device_) return;
  const std::string id = device_->opened.id;
  close_device();
  if (!open(id, true)) lost_ = id;
  seek_later();
}

bool Stylus::open_best(const std::string& but_not) {
  std::vector<devices::FoundDevice> found;
  for (auto& findings : catalogue_->find())
    for (auto& device : findings.devices)
      if (device.automatic && device.has_force && device.id != but_not) found.push_back(std::move(device));
  return std::any_of(found.begin(), found.end(),
                     [this](const auto& device) { return open(device.id, false); });
}

/// @param told  why it could not be opened.
bool Stylus::open(const std::string& id, bool told) {
  auto opened = catalogue_->open(id, request_for(id));
  // A name that is not an id was asked for: what is remembered belongs to the id.
  if (opened && opened->id != id) {
    const std::string found = opened->id;
    opened->device.reset();
    opened = catalogue_->open(found, request_for(found));
  }
  const auto refuse = [&](DeviceTrouble trouble, const base::Error& error) {
    if (told) emit device_refused(to_text(id), trouble, to_text(base::to_line(error)));
    return false;
  };
  if (!opened) return refuse(opened.error().trouble, opened.error().error);
  if (opened->id == kPointer) return true;
  auto seat = std::make_unique<Seat>();
  seat->opened = std::move(*opened);
  if (const auto started = start(*seat); !started) return refuse(DeviceTrouble::init_failed, started.error());
  device_ = std::move(seat);
  lost_.clear();
  seek_timer_.stop();
  trouble_ = DeviceTrouble::none;
  look_timer_.start();
  if (device_->opened.device->status().state == DeviceState::running) {
    give_tablet_to(*device_);
    emit device_taken(to_text(device_->description.name), false);
  } else {
    look();
  }
  return true;
}

/// A servo with the limits of device, learner and strength, and the device on it.
base::Result<void> Stylus::start(Seat& seat) const {
  auto& device = *seat.opened.device;
  seat.description = device.describe();
  auto& limits = seat.description.limits;
  limits = limited(limits, remembered_ ? remembered_(seat.opened.id) : DeviceSettings{});
  for (double* limit : {&limits.max_force_n, &limits.continuous_force_n, &limits.max_stiffness_n_m})
    *limit *= strength_;
  seat.servo = std::make_unique<haptics::Servo>(seat.description);
  seat.servo->set_scene(scene_);
  return device.start(*seat.servo);
}

void Stylus::take_limits() {
  if (!device_) return;
  const bool has_tablet = !is_pointer();
  if (has_tablet) emit leaving();
  device_->opened.device->stop();
  buttons_ = ~0U;
  const auto started = start(*device_);
  if (has_tablet) emit changed();
  if (!started) lose(DeviceTrouble::init_failed, to_text(base::to_line(started.error())));
}

void Stylus::set_strength(double strength) {
  strength = std::clamp(strength, 0.05, 1.0);
  if (std::exchange(strength_, strength) != strength) take_limits();
}

void Stylus::close_device() {
  look_timer_.stop();
  if (!device_) return;
  // No force first, then the tablet to the pointer.
  device_->opened.device->stop();
  give_tablet_to(pointer_seat_);
  device_.reset();
}

void Stylus::give_tablet_to(Seat& seat) {
  if (active_ == &seat) return;
  emit leaving();
  if (is_pointer()) pointer_.stop();
  active_ = &seat;
  buttons_ = ~0U;  // what is down already was not pressed for this
  seat.servo->set_scene(scene_);
  if (is_pointer()) (void)pointer_.start(*seat.servo);  // it ran before: its thread can be made
  emit changed();
}

void Stylus::look() {
  if (!device_) return;
  const auto status = device_->opened.device->status();
  const QString name = to_text(device_->description.name);
  switch (status.state) {
    case DeviceState::running:
      trouble_ = DeviceTrouble::none;
      if (!is_pointer()) return;
      give_tablet_to(*device_);
      emit device_taken(name, true);
      return;
    case DeviceState::paused:
      give_tablet_to(pointer_seat_);
      if (trouble_ == status.trouble) return;
      trouble_ = status.trouble;
      emit device_paused(name, status.trouble, to_text(status.message));
      return;
    case DeviceState::stopped:
    case DeviceState::lost:
      lose(status.trouble, to_text(status.message));
      return;
  }
}

void Stylus::lose(DeviceTrouble trouble, const QString& message) {
  const QString name = to_text(device_->description.name);
  lost_ = device_->opened.id;
  close_device();
  emit device_lost(name, trouble, message);
  seek_later();
}

void Stylus::seek_later() {
  if (!device_ && chosen_ != kPointer && catalogue_) seek_timer_.start(kSeek_ms);
}

void Stylus::seek() {
  if (device_ || chosen_ == kPointer) return;
  // Nobody is interrupted in the middle of a stroke.
  if (pressed_) {
    seek_timer_.start(kSeek_ms / 10);
    return;
  }
  QElapsedTimer taken;
  taken.start();
  const bool found = lost_.empty() ? open_best({}) : open(lost_, false) || open_best(lost_);
  if (found && device_) return;
  const auto pause_ms = taken.elapsed() * kSeekShare;
  seek_timer_.start(static_cast<int>(std::clamp<qint64>(pause_ms, kSeek_ms, kLongestSeek_ms)));
}

}  // namespace nazori::ui
