// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "sdl_port.h"

namespace nazori::devices::standin {

/// A simulated joystick, wheel or pad that records its commands, because SDL has no virtual haptic device.
struct Stick {
  sdl::Listed listed;
  std::atomic<bool> attached{true}, refuses_effects{false};
  std::atomic<double> x{0}, y{0}, press{0};
  std::atomic<std::uint32_t> buttons{0};

  struct Effect {
    SDL_HapticEffect what{};
    bool running = false;
    int updates = 0, runs = 0;
  };
  mutable std::mutex lock;
  std::map<int, Effect> effects;
  int made = 0;
  std::uint16_t low = 0, high = 0, most_high = 0, most_low = 0;
  int rumbles = 0;

  /// The running effect of a type, or nothing.
  [[nodiscard]] Effect effect(Uint16 type) const {
    const std::lock_guard one(lock);
    for (const auto& [id, e] : effects) {
      if (e.what.type == type) return e;
    }
    return {};
  }
  /// The running constant force as a share of the full one, as defined in SDL_haptic.h: the direction is
  /// where the force comes from, +x is east and +y is south.
  [[nodiscard]] double push_right() const { return push().first; }
  [[nodiscard]] double push_up() const { return push().second; }
  [[nodiscard]] bool anything_runs() const {
    const std::lock_guard one(lock);
    for (const auto& [id, e] : effects) {
      if (e.running) return true;
    }
    return low != 0 || high != 0;
  }

 private:
  [[nodiscard]] std::pair<double, double> push() const {
    const Effect e = effect(SDL_HAPTIC_CONSTANT);
    if (!e.running) return {0, 0};
    const SDL_HapticConstant& c = e.what.constant;
    const double east = c.direction.dir[0], south = c.direction.dir[1], size = std::hypot(east, south);
    return {-east / size * c.level / 32767.0, south / size * c.level / 32767.0};
  }
};

class StickController final : public sdl::Controller {
 public:
  explicit StickController(std::shared_ptr<Stick> stick) : stick_(std::move(stick)) {}
  [[nodiscard]] sdl::Reading read() override {
    return {stick_->attached, stick_->x, stick_->y, stick_->press, stick_->buttons};
  }
  bool rumble(std::uint16_t low, std::uint16_t high, std::uint32_t) override {
    const std::lock_guard one(stick_->lock);
    stick_->low = low;
    stick_->high = high;
    stick_->most_low = std::max(stick_->most_low, low);
    stick_->most_high = std::max(stick_->most_high, high);
    ++stick_->rumbles;
    return true;
  }
  [[nodiscard]] int new_effect(SDL_HapticEffect& effect) override {
    if (stick_->refuses_effects) return -1;
    const std::lock_guard one(stick_->lock);
    stick_->effects[stick_->made].what = effect;
    return stick_->made++;
  }
  bool update_effect(int id, SDL_HapticEffect& effect) override {
    if (stick_->refuses_effects) return false;
    const std::lock_guard one(stick_->lock);
    stick_->effects.at(id).what = effect;
    ++stick_->effects.at(id).updates;
    return true;
  }
  bool run_effect(int id) override {
    if (stick_->refuses_effects) return false;
    const std::lock_guard one(stick_->lock);
    stick_->effects.at(id).running = true;
    ++stick_->effects.at(id).runs;
    return true;
  }
  bool stop_effect(int id) override {
    const std::lock_guard one(stick_->lock);
    stick_->effects.at(id).running = false;
    return true;
  }
  void destroy_effect(int id) override {
    const std::lock_guard one(stick_->lock);
    stick_->effects.erase(id);
  }

 private:
  std::shared_ptr<Stick> stick_;
};

/// The plugged-in devices, chosen by the test. Thread rules: the test's thread.
struct StickPort final : sdl::Port {
  [[nodiscard]] base::Result<std::vector<sdl::Listed>> list() override {
    if (!starts) return base::fail(base::Errc::device, "SDL cannot be started", "joysticks and gamepads");
    std::vector<sdl::Listed> all;
    for (const auto& stick : plugged) all.push_back(stick->listed);
    return all;
  }
  [[nodiscard]] base::Result<std::unique_ptr<sdl::Controller>> open(const sdl::Listed& device,
                                                                    WritingHand asked) override {
    hand = asked;
    for (const auto& stick : plugged) {
      if (stick->listed.instance == device.instance && opens) return std::make_unique<StickController>(stick);
    }
    return base::fail(base::Errc::device, "it cannot be opened", device.name, "plug it in again");
  }
  std::shared_ptr<Stick> plug_in(const std::string& name, const sdl::Abilities& abilities) {
    auto stick = std::make_shared<Stick>();
    stick->listed = {next_++, "guid-of-" + name, name, abilities};
    plugged.push_back(stick);
    return stick;
  }

  std::vector<std::shared_ptr<Stick>> plugged;
  bool starts = true, opens = true;
  WritingHand hand = WritingHand::right;

 private:
  std::int32_t next_ = 0;
};

inline constexpr sdl::Abilities kForceStick{SDL_HAPTIC_CONSTANT | SDL_HAPTIC_SPRING | SDL_HAPTIC_DAMPER, 2,
                                            false, false, false};
/// As on Linux, where SDL counts two axes of every device with force feedback.
inline constexpr sdl::Abilities kWheel{SDL_HAPTIC_CONSTANT, 2, false, false, true};
inline constexpr sdl::Abilities kPad{SDL_HAPTIC_LEFTRIGHT, 0, true, true, false};

}  // namespace nazori::devices::standin
