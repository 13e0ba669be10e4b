// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/tablet_device.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace nazori::devices {
namespace {

using namespace std::chrono_literals;
using std::chrono::milliseconds;

constexpr milliseconds kLook = 100ms;
constexpr milliseconds kRest = 1s;
constexpr milliseconds kSeek = 3s;
// A device whose search takes long is retried less often: searching takes at most this share of the time.
constexpr int kSeekShare = 20;
constexpr milliseconds kLongestSeek = 60s;
constexpr milliseconds kStrokeEnd = 200ms;
// After sleep the window may run before the servo: this many checks in a row must fail before a servo counts
// as dead.
constexpr int kStalledLooks = 5;
constexpr std::string_view kPointer = "pointer";

using haptics::DeviceState;
using haptics::DeviceTrouble;
using enum DeviceEventKind;

/// The window itself reports this.
std::string what_to_do(const base::Error& error) {
  return error.remedy.empty() ? base::to_line(error) : error.remedy;
}

}  // namespace

TabletDevice::TabletDevice(base::Inbox& inbox, const base::Clock& clock, WakeAt wake_at)
    : clock_(clock), inbox_(inbox), wake_at_(std::move(wake_at)) {
  pointer_run_.opened.id = kPointer;
  pointer_run_.description = pointer_.describe();
  pointer_run_.servo = std::make_unique<haptics::Servo>(pointer_run_.description);
}

TabletDevice::~TabletDevice() {
  if (device_) device_->opened.device->stop();
  pointer_.stop();
}

void TabletDevice::set_deadline(Deadline& deadline, milliseconds from_now) {
  deadline = clock_.steady() + from_now;
  if (woken_at_ && *woken_at_ <= *deadline) return;
  woken_at_ = deadline;
  if (wake_at_) wake_at_(*deadline);
}

/// Whether the deadline has passed; if so, clears it.
bool TabletDevice::is_past(Deadline& deadline) const {
  if (!deadline || clock_.steady() < *deadline) return false;
  deadline.reset();
  return true;
}

void TabletDevice::update() {
  woken_at_.reset();
  if (is_past(rest_at_)) rest();
  if (is_past(look_at_)) {
    set_deadline(look_at_, kLook);
    look();
  }
  if (is_past(seek_at_)) seek();
  Deadline next;
  for (const Deadline* deadline : {&rest_at_, &look_at_, &seek_at_})
    if (*deadline && (!next || **deadline < *next)) next = *deadline;
  if (!next || woken_at_ == next) return;
  woken_at_ = next;
  if (wake_at_) wake_at_(*next);
}

base::Result<void> TabletDevice::start() { return is_pointer() ? start_pointer() : base::Result<void>(); }

base::Result<void> TabletDevice::start_pointer() {
  resting_ = false;
  set_deadline(rest_at_, kRest);
  pointer_run_.servo->begin_run();
  return pointer_.start(*pointer_run_.servo);
}

void TabletDevice::move(const PointerState& state, std::optional<double> event_s) {
  if (is_resting()) (void)start_pointer();  // it ran before, so its thread can be started
  if (is_pointer()) set_deadline(rest_at_, kRest);
  moved_ = state;
  if (event_s)
    pointer_.move(state, *event_s);
  else
    pointer_.move(state);
}

void TabletDevice::set_awake(bool awake) {
  awake_ = awake;
  if (awake && is_resting()) (void)start_pointer();
  if (!awake) set_deadline(rest_at_, kRest);
}

void TabletDevice::rest() {
  if (!is_pointer() || resting_ || awake_) return;
  // A pressed pointer needs the servo even where it does not move.
  if (moved_.pressed) return set_deadline(rest_at_, kRest);
  pointer_.stop();
  resting_ = true;
}

void TabletDevice::set_scene(std::shared_ptr<const haptics::HapticScene> scene) {
  scene_ = std::move(scene);
  // The servo adopts a scene and releases the previous one only while it ticks.
  if (is_resting()) (void)start_pointer();
  active_->servo->set_scene(scene_);
  // A paused device continues automatically and must then use this scene.
  if (device_ && is_pointer()) device_->servo->set_scene(scene_);
}

std::size_t TabletDevice::take_samples(std::span<haptics::ServoSample> out) {
  const auto count = active_->servo->take_samples(out);
  const std::span<const haptics::ServoSample> taken = out.first(count);
  if (count > 0) sampled(taken);
  if (is_pointer()) {
    if (count > 0) pressed_ = taken.back().buttons != 0;
    return count;
  }
  for (const auto& sample : taken) {
    const std::uint32_t down = sample.buttons & ~std::exchange(buttons_, sample.buttons);
    for (int number = 0; number < 32; ++number)
      if ((down >> number & 1U) != 0) button_pressed(number);
  }
  return count;
}

haptics::DeviceStatus TabletDevice::status() const {
  if (device_) return device_->opened.device->status();
  return pointer_.status();
}

haptics::DeviceDescription TabletDevice::own_description() const {
  return device_ ? device_->opened.device->describe() : pointer_run_.description;
}

void TabletDevice::set_devices(BackEnds back_ends, const geometry::TabletShape& shape,
                               Remembered remembered) {
  search_ = std::make_unique<DeviceSearch>(inbox_, std::move(back_ends), shape);
  remembered_ = std::move(remembered);
}

void TabletDevice::find() {
  if (search_) search_->find([this](const auto& findings) { found(findings); });
}

void TabletDevice::choose(const std::string& id) {
  chosen_ = id;
  sought_.clear();
  close_device();
  if (search_ && id != kPointer) {
    search_for({id, true, {}}, true);
  } else {
    if (search_) search_->cancel();
    searching_ = false;
    happened({searched, {}, {}, {}});
  }
}

void TabletDevice::reopen() {
  if (!device_) return;
  const std::string id = device_->opened.id;
  close_device();
  search_for({id, true, {}}, true);
  reopening_ = id;
}

/// @param announced  events that say why the request could not be opened and that the search has ended.
void TabletDevice::search_for(DeviceWish wish, bool announced) {
  searching_ = true;
  seek_at_.reset();
  const auto began = clock_.steady();
  const DeviceWish asked = wish;
  search_->open(std::move(wish), remembered_ ? remembered_() : RememberedDevices{},
                [this, asked, announced, began](DeviceFind result) {
                  searching_ = false;
                  reopening_.clear();
                  use(std::move(result), asked, announced);
                  if (searching_) return;
                  seek_later(std::chrono::duration_cast<milliseconds>(clock_.steady() - began));
                  if (announced) happened({searched, {}, {}, {}});
                });
}

void TabletDevice::use(DeviceFind result, const DeviceWish& wish, bool announced) {
  if (!wish.id.empty()) sought_ = result.refused ? wish.id : "";
  if (result.refused && announced)
    happened({refused, wish.id, result.refused->trouble, what_to_do(result.refused->error)});
  if (!result.opened || result.opened->id == kPointer) return;
  // The learner is not interrupted in the middle of a stroke.
  if (is_writing()) {
    waiting_ = std::move(result.opened);
    return;
  }
  const std::string id = result.opened->id;
  if (run(std::move(*result.opened), announced) || !wish.or_best) return;
  // The device opens but does not start: try the next one.
  DeviceWish next{{}, true, wish.but_not};
  next.but_not.push_back(id);
  search_for(std::move(next), announced);
}

/// Starts a device and makes it active, or closes it. @return whether it started.
bool TabletDevice::run(OpenedDevice opened, bool announced) {
  auto begun = std::make_unique<DeviceRun>();
  begun->opened = std::move(opened);
  if (const auto started = start(*begun); !started) {
    if (sought_.empty()) sought_ = begun->opened.id;
    if (announced)
      happened({refused, begun->opened.id, DeviceTrouble::init_failed, what_to_do(started.error())});
    search_->close(std::move(begun->opened));
    return false;
  }
  close_device();
  device_ = std::move(begun);
  if (sought_ == device_->opened.id) sought_.clear();
  trouble_ = DeviceTrouble::none;
  stalled_looks_ = 0;
  set_deadline(look_at_, kLook);
  if (device_->opened.device->status().state == DeviceState::running) {
    give_tablet_to(*device_);
    happened({taken, device_->description.name, {}, {}});
  } else {
    look();
  }
  return true;
}

/// A servo with the limits of device, learner and strength, and the device on it.
base::Result<void> TabletDevice::start(DeviceRun& run) const {
  auto& device = *run.opened.device;
  run.description = device.describe();
  auto& limits = run.description.limits;
  limits = limited(limits, settings_of(remembered_ ? remembered_() : RememberedDevices{}, run.opened.id));
  for (double* limit : {&limits.max_force_n, &limits.continuous_force_n, &limits.max_stiffness_n_m})
    *limit *= strength_;
  run.servo = std::make_unique<haptics::Servo>(run.description);
  run.servo->set_scene(scene_);
  return device.start(*run.servo);
}

void TabletDevice::apply_limits() {
  if (!device_) return;
  const bool has_tablet = !is_pointer();
  if (has_tablet) leaving();
  device_->opened.device->stop();
  buttons_ = ~0U;
  const auto started = start(*device_);
  if (has_tablet) changed();
  if (!started) lose(DeviceTrouble::init_failed, base::to_line(started.error()));
}

void TabletDevice::set_strength(double strength) {
  strength = std::clamp(strength, 0.05, 1.0);
  if (std::exchange(strength_, strength) != strength) apply_limits();
}

void TabletDevice::close_device() {
  look_at_.reset();
  seek_at_.reset();
  reopening_.clear();
  if (waiting_) search_->close(std::move(*std::exchange(waiting_, std::nullopt)));
  if (!device_) return;
  // Stop the force first, then make the pointer active.
  device_->opened.device->stop();
  give_tablet_to(pointer_run_);
  search_->close(std::move(std::exchange(device_, nullptr)->opened));
}

void TabletDevice::give_tablet_to(DeviceRun& run) {
  if (active_ == &run) return;
  leaving();
  if (is_pointer()) {
    rest_at_.reset();
    pointer_.stop();
  }
  active_ = &run;
  buttons_ = ~0U;  // buttons that are already down do not count as pressed now
  pressed_ = false;
  run.servo->set_scene(scene_);
  if (is_pointer()) (void)start_pointer();  // it ran before, so its thread can be started
  changed();
}

void TabletDevice::look() {
  if (!device_) return;
  const auto status = device_->opened.device->status();
  stalled_looks_ = status.trouble == DeviceTrouble::stalled ? stalled_looks_ + 1 : 0;
  if (stalled_looks_ > 0 && stalled_looks_ < kStalledLooks) return;
  const std::string name = device_->description.name;
  switch (status.state) {
    case DeviceState::running:
      trouble_ = DeviceTrouble::none;
      if (!is_pointer()) return;
      give_tablet_to(*device_);
      happened({resumed, name, {}, {}});
      return;
    case DeviceState::paused:
      give_tablet_to(pointer_run_);
      if (trouble_ == status.trouble) return;
      trouble_ = status.trouble;
      happened({paused, name, status.trouble, status.message});
      return;
    case DeviceState::stopped:
    case DeviceState::lost:
      lose(status.trouble, status.message);
      return;
  }
}

void TabletDevice::lose(DeviceTrouble trouble, const std::string& message) {
  const std::string name = device_->description.name;
  const std::string id = device_->opened.id;
  if (sought_.empty()) sought_ = id;
  close_device();
  happened({lost, name, trouble, message});
  search_for({{}, true, {id}}, true);
}

bool TabletDevice::is_writing() { return is_pointer() ? pressed_ : latest().touching; }

void TabletDevice::seek_later(milliseconds took) {
  if (waiting_)
    set_deadline(seek_at_, kStrokeEnd);
  else if (search_ && chosen_ != kPointer && (!device_ || !sought_.empty()))
    set_deadline(seek_at_, std::clamp(took * kSeekShare, kSeek, kLongestSeek));
}

void TabletDevice::seek() {
  if (waiting_) {
    if (!is_writing()) (void)run(std::move(*std::exchange(waiting_, std::nullopt)), false);
    return seek_later();
  }
  // While the next best device is active, only the better one is searched for.
  if (!device_ || !sought_.empty()) search_for({sought_, !device_, {}}, false);
}

}  // namespace nazori::devices
