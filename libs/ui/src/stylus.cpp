// SPDX-License-Identifier: Apache-2.0
#include "stylus.h"

#include <QElapsedTimer>
#include <algorithm>
#include <utility>

#include "kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kLook_ms = 100;
constexpr int kRest_ms = 1000;
constexpr int kSeek_ms = 3000;
// A device that takes long to refuse is asked less often: looking takes at most this share of the time.
constexpr int kSeekShare = 20;
constexpr int kLongestSeek_ms = 60'000;
constexpr int kStrokeEnd_ms = 200;
// A computer that slept or stood still wakes the window first: so many looks in a row before a servo counts
// as dead.
constexpr int kStalledLooks = 5;
const std::string kPointer = "pointer";

using haptics::DeviceState;
using haptics::DeviceTrouble;

/// The window says itself what is wrong.
QString what_to_do(const base::Error& error) {
  return to_text(error.remedy.empty() ? base::to_line(error) : error.remedy);
}

}  // namespace

Stylus::Stylus(QObject* parent) : QObject(parent) {
  pointer_seat_.opened.id = kPointer;
  pointer_seat_.description = pointer_.describe();
  pointer_seat_.servo = std::make_unique<haptics::Servo>(pointer_seat_.description);
  look_timer_.setInterval(kLook_ms);
  connect(&look_timer_, &QTimer::timeout, this, &Stylus::look);
  seek_timer_.setSingleShot(true);
  connect(&seek_timer_, &QTimer::timeout, this, &Stylus::seek);
  rest_timer_.setSingleShot(true);
  rest_timer_.setInterval(kRest_ms);
  connect(&rest_timer_, &QTimer::timeout, this, &Stylus::rest);
}

Stylus::~Stylus() {
  if (device_) device_->opened.device->stop();
  pointer_.stop();
}

base::Result<void> Stylus::start() { return is_pointer() ? start_pointer() : base::Result<void>(); }

base::Result<void> Stylus::start_pointer() {
  resting_ = false;
  rest_timer_.start();
  pointer_seat_.servo->begin_run();
  return pointer_.start(*pointer_seat_.servo);
}

void Stylus::move(const devices::PointerState& state, std::optional<double> event_s) {
  if (is_resting()) (void)start_pointer();  // it ran before: its thread can be made
  if (is_pointer()) rest_timer_.start();
  moved_ = state;
  if (event_s)
    pointer_.move(state, *event_s);
  else
    pointer_.move(state);
}

void Stylus::set_awake(bool awake) {
  awake_ = awake;
  if (awake && is_resting()) (void)start_pointer();
  if (!awake) rest_timer_.start();
}

void Stylus::rest() {
  if (!is_pointer() || resting_ || awake_) return;
  // A pressed pointer feels and is felt even where it stays.
  if (moved_.pressed) return rest_timer_.start();
  pointer_.stop();
  resting_ = true;
}

void Stylus::set_scene(std::shared_ptr<const haptics::HapticScene> scene) {
  scene_ = std::move(scene);
  // The servo takes a scene over, and gives the one before back, only while it ticks.
  if (is_resting()) (void)start_pointer();
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
  search_ = std::make_unique<DeviceSearch>(std::move(back_ends), shape);
  remembered_ = std::move(remembered);
}

DeviceSettings Stylus::remembered(const std::string& id) const {
  return remembered_ ? remembered_().value(to_text(id)) : DeviceSettings{};
}

void Stylus::find() {
  if (search_) search_->find([this](const auto& findings) { emit found(findings); });
}

void Stylus::choose(const std::string& id) {
  chosen_ = id;
  sought_.clear();
  close_device();
  if (search_ && id != kPointer) {
    ask({id, true, {}}, true);
  } else {
    if (search_) search_->cancel();
    searching_ = false;
    emit searched();
  }
}

void Stylus::reopen() {
  if (!device_) return;
  const std::string id = device_->opened.id;
  close_device();
  ask({id, true, {}}, true);
  reopening_ = id;
}

/// @param told  why what was asked for could not be opened, and that the search is over.
void Stylus::ask(DeviceWish wish, bool told) {
  searching_ = true;
  seek_timer_.stop();
  QElapsedTimer taken;
  taken.start();
  const DeviceWish asked = wish;
  search_->open(std::move(wish), remembered_ ? remembered_() : DeviceSearch::Remembered{},
                [this, asked, told, taken](DeviceFind found) {
                  searching_ = false;
                  reopening_.clear();
                  take(std::move(found), asked, told);
                  if (searching_) return;
                  seek_later(taken.elapsed());
                  if (told) emit searched();
                });
}

void Stylus::take(DeviceFind found, const DeviceWish& wish, bool told) {
  if (!wish.id.empty()) sought_ = found.refused ? wish.id : "";
  if (found.refused && told)
    emit device_refused(to_text(wish.id), found.refused->trouble, what_to_do(found.refused->error));
  if (!found.opened || found.opened->id == kPointer) return;
  // Nobody is interrupted in the middle of a stroke.
  if (is_writing()) {
    waiting_ = std::move(found.opened);
    return;
  }
  const std::string id = found.opened->id;
  if (seat(std::move(*found.opened), told) || !wish.or_best) return;
  // It opens and does not start: the next one.
  DeviceWish next{{}, true, wish.but_not};
  next.but_not.push_back(id);
  ask(std::move(next), told);
}

bool Stylus::seat(devices::OpenedDevice opened, bool told) {
  auto seat = std::make_unique<Seat>();
  seat->opened = std::move(opened);
  if (const auto started = start(*seat); !started) {
    if (sought_.empty()) sought_ = seat->opened.id;
    if (told)
      emit device_refused(to_text(seat->opened.id), DeviceTrouble::init_failed, what_to_do(started.error()));
    search_->close(std::move(seat->opened));
    return false;
  }
  close_device();
  device_ = std::move(seat);
  if (sought_ == device_->opened.id) sought_.clear();
  trouble_ = DeviceTrouble::none;
  stalled_looks_ = 0;
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
  limits = limited(limits, remembered(seat.opened.id));
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
  seek_timer_.stop();
  reopening_.clear();
  if (waiting_) search_->close(std::move(*std::exchange(waiting_, std::nullopt)));
  if (!device_) return;
  // No force first, then the tablet to the pointer.
  device_->opened.device->stop();
  give_tablet_to(pointer_seat_);
  search_->close(std::move(std::exchange(device_, nullptr)->opened));
}

void Stylus::give_tablet_to(Seat& seat) {
  if (active_ == &seat) return;
  emit leaving();
  if (is_pointer()) {
    rest_timer_.stop();
    pointer_.stop();
  }
  active_ = &seat;
  buttons_ = ~0U;  // what is down already was not pressed for this
  pressed_ = false;
  seat.servo->set_scene(scene_);
  if (is_pointer()) (void)start_pointer();  // it ran before: its thread can be made
  emit changed();
}

void Stylus::look() {
  if (!device_) return;
  const auto status = device_->opened.device->status();
  stalled_looks_ = status.trouble == DeviceTrouble::stalled ? stalled_looks_ + 1 : 0;
  if (stalled_looks_ > 0 && stalled_looks_ < kStalledLooks) return;
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
  const std::string id = device_->opened.id;
  if (sought_.empty()) sought_ = id;
  close_device();
  emit device_lost(name, trouble, message);
  ask({{}, true, {id}}, true);
}

bool Stylus::is_writing() { return is_pointer() ? pressed_ : latest().touching; }

void Stylus::seek_later(qint64 took_ms) {
  if (waiting_)
    seek_timer_.start(kStrokeEnd_ms);
  else if (search_ && chosen_ != kPointer && (!device_ || !sought_.empty()))
    seek_timer_.start(static_cast<int>(std::clamp<qint64>(took_ms * kSeekShare, kSeek_ms, kLongestSeek_ms)));
}

void Stylus::seek() {
  if (waiting_) {
    if (!is_writing()) (void)seat(std::move(*std::exchange(waiting_, std::nullopt)), false);
    return seek_later();
  }
  // While the next best has the tablet, only the better one is looked for.
  if (!device_ || !sought_.empty()) ask({sought_, !device_, {}}, false);
}

}  // namespace nazori::ui
