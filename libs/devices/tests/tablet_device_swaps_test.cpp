// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "nazori/devices/tablet_device.h"
#include "nazori/tablet/carved_tablet.h"

namespace nazori::devices {
namespace {

using namespace std::chrono_literals;
using haptics::DeviceState;
using haptics::DeviceTrouble;
using Kind = DeviceEventKind;

/// An arm that ticks only where the test lets it.
struct Arm {
  std::string name;
  bool plugged_in = true;
  bool starts = true;
  std::string remedy = "switch it off";  ///< of a start that fails
  DeviceState state = DeviceState::running;
  DeviceTrouble trouble = DeviceTrouble::none;
  haptics::ServoCallback* servo = nullptr;  ///< while it runs

  /// "open", "start", "stop", "close". A device is closed on another thread.
  [[nodiscard]] std::vector<std::string> log() const {
    const std::scoped_lock lock(mutex_);
    return log_;
  }
  void add(const std::string& what) {
    const std::scoped_lock lock(mutex_);
    log_.push_back(what);
  }
  void forget() {
    const std::scoped_lock lock(mutex_);
    log_.clear();
  }
  haptics::Vec3 tick(double z_m, std::uint32_t buttons = 0) const {
    return servo->tick({0.001, {0, 0, z_m}, buttons, true});
  }
  [[nodiscard]] int count(std::string_view what) const {
    const auto all = log();
    return static_cast<int>(std::count(all.begin(), all.end(), what));
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> log_;
};

/// The arm as a device.
class ArmOfATest final : public haptics::HapticDevice {
 public:
  explicit ArmOfATest(Arm& arm) : arm_(arm) { arm_.add("open"); }
  ~ArmOfATest() override { arm_.add("close"); }
  ArmOfATest(const ArmOfATest&) = delete;
  ArmOfATest& operator=(const ArmOfATest&) = delete;
  [[nodiscard]] haptics::DeviceDescription describe() const override { return {arm_.name, 1000, true, {}}; }
  [[nodiscard]] base::Result<void> start(haptics::ServoCallback& servo) override {
    if (!arm_.starts) return base::fail(base::Errc::device, "it does not start", arm_.name, arm_.remedy);
    arm_.servo = &servo;
    arm_.add("start");
    return {};
  }
  void stop() noexcept override {
    arm_.servo = nullptr;
    arm_.add("stop");
  }
  [[nodiscard]] haptics::DeviceStatus status() const override {
    return {arm_.state, arm_.trouble, "why", 7, 0, 0};
  }

 private:
  Arm& arm_;
};

class ArmBackEnd final : public BackEnd {
 public:
  ArmBackEnd(std::string id, Arm& arm) : id_(std::move(id)), arm_(arm) {}
  [[nodiscard]] std::string_view id() const override { return id_; }
  [[nodiscard]] BackEndFindings find() override {
    if (!arm_.plugged_in)
      return {id_, {}, {{DeviceTrouble::device_absent, {base::Errc::device, "none", "", ""}}}};
    return {id_, {{id_ + ":arm", arm_.name, true, true}}, std::nullopt};
  }
  [[nodiscard]] DeviceResult<OpenedDevice> open(std::string_view, const OpenRequest&) override {
    if (!arm_.plugged_in) return no_device(DeviceTrouble::device_absent, "nothing is plugged in", id_, "");
    return OpenedDevice{id_ + ":arm", std::make_unique<ArmOfATest>(arm_), {}, {}};
  }

 private:
  std::string id_;
  Arm& arm_;
};

/// A tablet with two arms. Nothing happens but what the test lets happen: a clock that it sets, searches that
/// it waits for, ticks that it makes.
class TabletDeviceSwaps : public testing::Test {
 protected:
  TabletDeviceSwaps() {
    a_.name = "Arm A";
    b_.name = "Arm B";
    device_.happened.connect([this](const DeviceEvent& event) {
      events_.push_back(event);
      kinds_.push_back(event.kind);
    });
    TabletDevice::BackEnds back_ends;
    back_ends.push_back(std::make_unique<ArmBackEnd>("a", a_));
    back_ends.push_back(std::make_unique<ArmBackEnd>("b", b_));
    device_.set_devices(std::move(back_ends), {}, {});
  }
  /// Time passes, and update() is called as soon as it was asked for.
  void pass(std::chrono::milliseconds time) {
    const auto end = clock_.steady() + time;
    while (woken_at_ && *woken_at_ <= end) {
      clock_.advance(std::chrono::duration_cast<std::chrono::milliseconds>(
          std::max(*woken_at_ - clock_.steady(), base::Clock::Steady::duration{})));
      woken_at_.reset();
      device_.update();
      if (device_.is_searching()) inbox_.run_until([this] { return !device_.is_searching(); });
    }
    clock_.advance(std::chrono::duration_cast<std::chrono::milliseconds>(end - clock_.steady()));
  }
  /// Chooses and waits for the end of the search.
  void choose(const std::string& id) {
    device_.choose(id);
    inbox_.run_until([this] { return !device_.is_searching(); });
  }
  void forget() {
    events_.clear();
    kinds_.clear();
    a_.forget();
    b_.forget();
  }
  /// Waits for the thread that opens and closes.
  void let_close(const Arm& arm, int times = 1) {
    // Closing is done in order with searches, so the answer to a search comes after it.
    std::size_t answers = 0;
    const base::Connection connection = device_.found.connect([&](const auto&) { ++answers; });
    device_.find();
    inbox_.run_until([&] { return answers > 0; });
    EXPECT_EQ(arm.count("close"), times);
  }

  Arm a_, b_;
  std::vector<DeviceEvent> events_;
  std::vector<Kind> kinds_;
  std::optional<base::Clock::Steady> woken_at_;
  base::Inbox inbox_;
  base::ManualClock clock_{base::Clock::Calendar{}};
  TabletDevice device_{inbox_, clock_, [this](base::Clock::Steady at) { woken_at_ = at; }};
};

TEST_F(TabletDeviceSwaps, TheNextBestServesUntilTheChosenOneIsThere) {
  a_.plugged_in = false;
  choose("a:arm");
  EXPECT_EQ(kinds_, (std::vector{Kind::refused, Kind::taken, Kind::searched}));
  EXPECT_EQ(events_[0].device, "a:arm");
  EXPECT_EQ(events_[0].trouble, DeviceTrouble::device_absent);
  EXPECT_EQ(events_[1].device, "Arm B");
  EXPECT_EQ(events_[2].device, "");
  EXPECT_EQ(device_.opened()->id, "b:arm");
  EXPECT_EQ(device_.chosen(), "a:arm");
  forget();

  pass(3s);
  EXPECT_TRUE(kinds_.empty()) << "retrying is silent";
  EXPECT_TRUE(b_.log().empty()) << "and leaves the active one as it is";
  a_.plugged_in = true;
  pass(2999ms);
  EXPECT_EQ(device_.opened()->id, "b:arm");
  pass(1ms);
  EXPECT_EQ(device_.opened()->id, "a:arm");
  EXPECT_FALSE(device_.is_pointer());
  EXPECT_EQ(kinds_, std::vector{Kind::taken});
  let_close(b_);
  EXPECT_EQ(b_.log(), (std::vector<std::string>{"stop", "close"}));

  forget();
  pass(120s);
  EXPECT_TRUE(a_.log().empty()) << "the chosen one is there: nothing is searched for";
}

TEST_F(TabletDeviceSwaps, ASearchThatTakesLongIsRepeatedLessOften) {
  a_.plugged_in = b_.plugged_in = false;
  const auto after_a_search_of = [&](std::chrono::milliseconds took) {
    device_.choose("a:arm");
    clock_.advance(took);
    inbox_.run_until([this] { return !device_.is_searching(); });
    const auto ended = clock_.steady();
    for (;;) {
      const auto due = woken_at_.value();
      clock_.advance(std::chrono::duration_cast<std::chrono::milliseconds>(due - clock_.steady()));
      woken_at_.reset();
      device_.update();
      if (device_.is_searching()) break;
    }
    return std::chrono::duration_cast<std::chrono::milliseconds>(clock_.steady() - ended);
  };
  EXPECT_EQ(after_a_search_of(0ms), 3s);
  EXPECT_EQ(after_a_search_of(150ms), 3s);
  EXPECT_EQ(after_a_search_of(200ms), 4s);
  EXPECT_EQ(after_a_search_of(2900ms), 58s);
  EXPECT_EQ(after_a_search_of(10s), 60s);
}

TEST_F(TabletDeviceSwaps, OneThatOpensButDoesNotStartGivesWayToTheNextAndIsRetried) {
  a_.starts = false;
  choose("a:arm");
  EXPECT_EQ(kinds_, (std::vector{Kind::refused, Kind::taken, Kind::searched}));
  EXPECT_EQ(events_[0].device, "a:arm");
  EXPECT_EQ(events_[0].trouble, DeviceTrouble::init_failed);
  EXPECT_EQ(events_[0].message, "switch it off") << "what to do";
  EXPECT_EQ(device_.opened()->id, "b:arm");
  let_close(a_);
  EXPECT_EQ(a_.log(), (std::vector<std::string>{"open", "close"})) << "it is tried once in a search";
  forget();
  pass(3s);
  EXPECT_TRUE(kinds_.empty()) << "retrying is silent";
  EXPECT_EQ(device_.opened()->id, "b:arm");
  a_.starts = true;
  pass(3s);
  EXPECT_EQ(kinds_, std::vector{Kind::taken});
  EXPECT_EQ(device_.opened()->id, "a:arm");
}

TEST_F(TabletDeviceSwaps, WithoutARemedyTheErrorItselfIsTold) {
  a_.starts = b_.starts = false;
  a_.remedy.clear();
  choose("a:arm");
  EXPECT_EQ(kinds_, (std::vector{Kind::refused, Kind::refused, Kind::searched}));
  EXPECT_EQ(events_[0].message, "Arm A: it does not start");
  EXPECT_EQ(device_.opened(), nullptr);
  EXPECT_TRUE(device_.is_pointer());
}

TEST_F(TabletDeviceSwaps, ChoosingAnotherStopsTheForceBeforeThePointerTakesOver) {
  choose("");
  EXPECT_EQ(device_.opened()->id, "a:arm") << "the first with force";
  device_.leaving.connect([&] { a_.add("leaving"); });
  device_.changed.connect([&] { a_.add("changed"); });
  forget();
  device_.choose("b:arm");
  EXPECT_TRUE(device_.is_searching());
  EXPECT_TRUE(device_.is_pointer());
  EXPECT_EQ(a_.log().at(0), "stop");
  EXPECT_EQ(a_.log().at(1), "leaving");
  EXPECT_EQ(a_.log().at(2), "changed");
  inbox_.run_until([this] { return !device_.is_searching(); });
  EXPECT_EQ(device_.opened()->id, "b:arm");
  EXPECT_EQ(a_.count("close"), 1);
  EXPECT_EQ(a_.count("leaving"), 2) << "the pointer left, too";
}

TEST_F(TabletDeviceSwaps, ChoosingThePointerEndsTheSearchAtOnce) {
  device_.choose("a:arm");
  device_.choose("pointer");
  EXPECT_FALSE(device_.is_searching());
  EXPECT_EQ(kinds_, std::vector{Kind::searched});
  let_close(a_, a_.count("open"));
  pass(120s);
  EXPECT_EQ(device_.opened(), nullptr);
  EXPECT_EQ(kinds_, std::vector{Kind::searched});
  EXPECT_EQ(a_.count("start"), 0);
}

TEST_F(TabletDeviceSwaps, ALostOneGivesWayToTheNextAndComesBack) {
  choose("a:arm");
  forget();
  a_.state = DeviceState::lost;
  a_.trouble = DeviceTrouble::communication_lost;
  pass(100ms);
  EXPECT_EQ(kinds_, (std::vector{Kind::lost, Kind::taken, Kind::searched}));
  EXPECT_EQ(events_[0].device, "Arm A");
  EXPECT_EQ(events_[0].trouble, DeviceTrouble::communication_lost);
  EXPECT_EQ(events_[0].message, "why");
  EXPECT_EQ(device_.opened()->id, "b:arm") << "not the one that was just lost";
  a_.state = DeviceState::running;
  a_.trouble = DeviceTrouble::none;
  pass(3s);
  EXPECT_EQ(device_.opened()->id, "a:arm");
}

TEST_F(TabletDeviceSwaps, AStoppedOneIsLostToo) {
  choose("a:arm");
  forget();
  a_.state = DeviceState::stopped;
  pass(100ms);
  EXPECT_EQ(kinds_.at(0), Kind::lost);
}

TEST_F(TabletDeviceSwaps, OneLookInBetweenBeginsTheCountOfStalledLooksAgain) {
  choose("a:arm");
  forget();
  const auto stalls = [&](bool stalled) {
    a_.state = stalled ? DeviceState::lost : DeviceState::running;
    a_.trouble = stalled ? DeviceTrouble::stalled : DeviceTrouble::none;
  };
  stalls(true);
  pass(400ms);
  stalls(false);
  pass(100ms);
  stalls(true);
  pass(400ms);
  EXPECT_TRUE(kinds_.empty());
  EXPECT_FALSE(device_.is_pointer());
  pass(100ms);
  EXPECT_EQ(kinds_.at(0), Kind::lost);
}

TEST_F(TabletDeviceSwaps, OneThatIsPausedWhenItIsOpenedWaitsWhileThePointerWrites) {
  a_.state = DeviceState::paused;
  a_.trouble = DeviceTrouble::docked;
  choose("a:arm");
  EXPECT_EQ(kinds_, (std::vector{Kind::paused, Kind::searched}));
  EXPECT_TRUE(device_.is_pointer());
  EXPECT_EQ(device_.opened()->id, "a:arm");
  EXPECT_EQ(device_.status().state, DeviceState::paused);
  EXPECT_EQ(device_.status().buttons, 7U) << "the status is the device's";
  EXPECT_EQ(device_.own_description().name, "Arm A");
  forget();
  a_.state = DeviceState::running;
  a_.trouble = DeviceTrouble::none;
  pass(100ms);
  EXPECT_EQ(kinds_, std::vector{Kind::resumed});
  EXPECT_FALSE(device_.is_pointer());
  // The same cause is told again after it was gone.
  a_.state = DeviceState::paused;
  a_.trouble = DeviceTrouble::docked;
  pass(100ms);
  EXPECT_EQ(kinds_, (std::vector{Kind::resumed, Kind::paused}));
}

TEST_F(TabletDeviceSwaps, TheStrengthRestartsItOnlyWhereItChanges) {
  choose("a:arm");
  device_.leaving.connect([&] { a_.add("leaving"); });
  device_.changed.connect([&] { a_.add("changed"); });
  forget();
  device_.set_strength(1);
  device_.set_strength(7);
  EXPECT_EQ(device_.strength(), 1);
  EXPECT_TRUE(a_.log().empty());
  const auto own = device_.own_description().limits;
  device_.set_strength(0.25);
  EXPECT_EQ(a_.log(), (std::vector<std::string>{"leaving", "stop", "start", "changed"}));
  EXPECT_DOUBLE_EQ(device_.describe().limits.max_force_n, own.max_force_n / 4);
  EXPECT_DOUBLE_EQ(device_.describe().limits.continuous_force_n, own.continuous_force_n / 4);
  EXPECT_DOUBLE_EQ(device_.describe().limits.max_stiffness_n_m, own.max_stiffness_n_m / 4);
  EXPECT_EQ(device_.describe().limits.max_damping_n_s_m, own.max_damping_n_s_m);
  EXPECT_EQ(device_.own_description().limits.max_force_n, own.max_force_n);
}

TEST_F(TabletDeviceSwaps, WhilePausedARestartLeavesTheTabletToThePointer) {
  a_.state = DeviceState::paused;
  choose("a:arm");
  device_.leaving.connect([&] { a_.add("leaving"); });
  device_.changed.connect([&] { a_.add("changed"); });
  forget();
  device_.apply_limits();
  EXPECT_EQ(a_.log(), (std::vector<std::string>{"stop", "start"}));
}

TEST_F(TabletDeviceSwaps, OneThatDoesNotRestartIsLost) {
  choose("a:arm");
  forget();
  a_.starts = false;
  b_.plugged_in = false;
  device_.set_strength(0.5);
  ASSERT_FALSE(kinds_.empty());
  EXPECT_EQ(kinds_[0], Kind::lost);
  EXPECT_EQ(events_[0].trouble, DeviceTrouble::init_failed);
  EXPECT_EQ(events_[0].message, "Arm A: it does not start (switch it off)");
  EXPECT_TRUE(device_.is_pointer());
  EXPECT_EQ(device_.opened(), nullptr);
}

TEST_F(TabletDeviceSwaps, WithoutADeviceNothingIsReopenedOrRestarted) {
  device_.reopen();
  device_.apply_limits();
  device_.set_strength(0.5);
  EXPECT_FALSE(device_.is_searching());
  EXPECT_TRUE(kinds_.empty());
  EXPECT_EQ(device_.reopening(), "");
}

TEST_F(TabletDeviceSwaps, ASceneReachesTheDeviceActiveOrPaused) {
  const auto tablet = *tablet::CarvedTablet::from_lines(
      {kanji::StrokeLine{{{20, 40}, {80, 40}}, kanji::StrokeEnding::stop, {}}}, 256);
  choose("a:arm");
  const auto pushes = [&] {
    // The force ramps up; a millimetre below the plateau.
    (void)a_.tick(0.01);
    haptics::Vec3 force{0, 0, 0};
    for (int i = 0; i < 2000; ++i) force = a_.tick(-0.001);
    return force.z > 0.01;
  };
  EXPECT_FALSE(pushes());
  device_.set_scene(tablet->scene({}, {}));
  EXPECT_TRUE(pushes());
  // While it pauses the scene is taken away; without it nothing pushes when it goes on.
  a_.state = DeviceState::paused;
  pass(100ms);
  ASSERT_TRUE(device_.is_pointer());
  device_.set_scene(nullptr);
  a_.state = DeviceState::running;
  pass(100ms);
  EXPECT_FALSE(pushes());
  // A restart and another device have the scene, too.
  device_.set_scene(tablet->scene({}, {}));
  device_.set_strength(0.9);
  EXPECT_TRUE(pushes());
}

TEST_F(TabletDeviceSwaps, TheBetterOneWaitsForTheEndOfTheStroke) {
  const auto tablet = *tablet::CarvedTablet::from_lines(
      {kanji::StrokeLine{{{20, 40}, {80, 40}}, kanji::StrokeEnding::stop, {}}}, 256);
  a_.plugged_in = false;
  device_.set_scene(tablet->scene({}, {}));
  choose("a:arm");
  ASSERT_EQ(device_.opened()->id, "b:arm");
  a_.plugged_in = true;
  (void)b_.tick(0.01);
  for (int i = 0; i < 10; ++i) (void)b_.tick(-0.001);
  ASSERT_TRUE(device_.latest().touching);
  forget();
  pass(3s);
  EXPECT_EQ(a_.log(), std::vector<std::string>{"open"});
  EXPECT_EQ(device_.opened()->id, "b:arm");
  pass(10s);
  EXPECT_EQ(a_.log(), std::vector<std::string>{"open"}) << "it is opened once, and started at the end";
  EXPECT_TRUE(b_.log().empty());
  for (int i = 0; i < 10; ++i) (void)b_.tick(0.01);
  pass(200ms);
  EXPECT_EQ(device_.opened()->id, "a:arm");
  EXPECT_EQ(a_.log(), (std::vector<std::string>{"open", "start"}));
  EXPECT_EQ(kinds_, std::vector{Kind::taken});
}

TEST_F(TabletDeviceSwaps, OneThatWaitsIsClosedWhereAnotherIsChosen) {
  const auto tablet = *tablet::CarvedTablet::from_lines(
      {kanji::StrokeLine{{{20, 40}, {80, 40}}, kanji::StrokeEnding::stop, {}}}, 256);
  a_.plugged_in = false;
  device_.set_scene(tablet->scene({}, {}));
  choose("a:arm");
  a_.plugged_in = true;
  for (int i = 0; i < 10; ++i) (void)b_.tick(-0.001);
  forget();
  pass(3s);
  ASSERT_EQ(a_.count("open"), 1);
  device_.choose("pointer");
  let_close(a_);
  EXPECT_EQ(a_.count("start"), 0);
}

TEST_F(TabletDeviceSwaps, ButtonsThatGoDownAreToldOnceWhileTheDeviceHasTheTablet) {
  choose("a:arm");
  std::vector<int> pressed;
  device_.button_pressed.connect([&](int number) { pressed.push_back(number); });
  const auto after = [&](std::initializer_list<std::uint32_t> ticks) {
    pressed.clear();
    for (const std::uint32_t buttons : ticks) (void)a_.tick(0.02, buttons);
    std::array<haptics::ServoSample, 64> samples;
    (void)device_.take_samples(samples);
    return pressed;
  };
  EXPECT_EQ(after({5, 5}), std::vector<int>{}) << "they were down before";
  EXPECT_EQ(after({4, 5, 5}), std::vector<int>{0});
  EXPECT_EQ(after({0, 0x80000000U | 1U, 0, 1}), (std::vector{0, 31, 0}));
  a_.state = DeviceState::paused;
  pass(100ms);
  a_.state = DeviceState::running;
  pass(100ms);
  EXPECT_EQ(after({3}), std::vector<int>{}) << "they went down while the pointer had the tablet";
}

TEST_F(TabletDeviceSwaps, AsksToBeWokenAtTheEarliestDeadline) {
  ASSERT_TRUE(device_.start());
  const auto begin = clock_.steady();
  EXPECT_EQ(woken_at_, begin + 1s) << "an idle pointer rests";
  clock_.advance(400ms);
  device_.move({0, 0, 0, false, true});
  EXPECT_EQ(woken_at_, begin + 1s) << "that is early enough for the later deadline";
  clock_.advance(600ms);
  woken_at_.reset();
  device_.update();
  EXPECT_FALSE(device_.is_resting());
  EXPECT_EQ(woken_at_, begin + 1400ms);
  clock_.advance(400ms);
  woken_at_.reset();
  device_.update();
  EXPECT_TRUE(device_.is_resting());
  EXPECT_FALSE(woken_at_) << "nothing is due";
  choose("a:arm");
  EXPECT_EQ(woken_at_, clock_.steady() + 100ms) << "the device is looked at";
  woken_at_.reset();
  device_.update();
  EXPECT_EQ(woken_at_, clock_.steady() + 100ms) << "it was too early; the deadline stands";
}

TEST_F(TabletDeviceSwaps, ARestingPointerStartsForASceneAMoveOrARecording) {
  ASSERT_TRUE(device_.start());
  for (int way = 0; way < 3; ++way) {
    pass(1s);
    ASSERT_TRUE(device_.is_resting()) << way;
    if (way == 0) device_.set_scene(nullptr);
    if (way == 1) device_.move({0, 0, 0, false, true});
    if (way == 2) device_.set_awake(true);
    EXPECT_FALSE(device_.is_resting()) << way;
  }
  pass(5s);
  EXPECT_FALSE(device_.is_resting());
  device_.set_awake(false);
  pass(999ms);
  EXPECT_FALSE(device_.is_resting());
  pass(1ms);
  EXPECT_TRUE(device_.is_resting());
}

}  // namespace
}  // namespace nazori::devices
