// SPDX-License-Identifier: Apache-2.0
// The real window with the real back ends. They use stand-ins for the makers' libraries and for the Inverse
// Service, and SDL's virtual gamepad.
#include <SDL2/SDL.h>
#include <dlfcn.h>

#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <cmath>
#include <condition_variable>
#include <glm/geometric.hpp>
#include <mutex>

#include "characters/characters.h"
#include "device/device_page.h"
#include "nazori/devices/force_dimension.h"
#include "nazori/devices/game_controllers.h"
#include "nazori/devices/inverse_service.h"
#include "nazori/devices/openhaptics.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "standins/dhd_standin.h"
#include "standins/hd_standin.h"
#include "standins/inverse_standin.h"
#include "standins/virtual_pad.h"
#include "test_paths.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

using devices::standin::InverseService;
using devices::standin::VirtualPad;
using haptics::Vec3;

WindowParts* parts_under_test = nullptr;

template <class T>
std::unique_ptr<Page> make(WindowParts& parts) {
  parts_under_test = &parts;
  return std::make_unique<T>(parts);
}

constexpr int kPatience_ms = 30'000;

class StandIn : public WindowTest {
 protected:
  StandIn() {
    pages_ = {make<Characters>, make<DevicePage>};
    hd_ = stage<devices::standin::HdStage>("libHD.so", "nazori_standin_hd");
    dhd_ = stage<devices::standin::DhdStage>("libdhd.so", "nazori_standin_dhd");
    hd_->plugged = false;
    dhd_->devices = 0;
    where_.openhaptics.library = std::string(test_paths::kStandins) + "/libHD.so";
    where_.openhaptics.device_folder = "/nowhere";
    where_.force_dimension.library = std::string(test_paths::kStandins) + "/libdhd.so";
    where_.inverse_service.port = 1;         // no service listens on this port
    where_.inverse_service.delay_s = 0.020;  // so that no force depends on how busy the machine is
    where_.inverse_service.give_up_s = 3600;
    // Only the test of gamepads may use the joysticks that are plugged in.
    back_ends_ = [this] {
      std::vector<std::unique_ptr<devices::BackEnd>> all;
      all.push_back(devices::openhaptics_back_end(where_.openhaptics));
      all.push_back(devices::force_dimension_back_end(where_.force_dimension));
      all.push_back(devices::inverse_service_back_end(where_.inverse_service));
      if (with_pads_) all.push_back(devices::game_controllers_back_end());
      all.push_back(devices::pointer_back_end());
      return all;
    };
  }
  void SetUp() override { install_language(QStringLiteral("en")); }
  void TearDown() override { window_.reset(); }

  template <class Stage>
  static Stage* stage(const char* library, const std::string& function) {
    void* handle =
        dlopen((std::string(test_paths::kStandins) + "/" + library).c_str(), RTLD_NOW | RTLD_GLOBAL);
    EXPECT_NE(handle, nullptr) << dlerror();
    reinterpret_cast<void (*)()>(dlsym(handle, (function + "_reset").c_str()))();
    return reinterpret_cast<Stage* (*)()>(dlsym(handle, function.c_str()))();
  }

  practice::TabletControl& controller() { return parts_under_test->tablet(); }
  devices::TabletDevice& stylus() { return controller().device(); }
  template <class Truth>
  static bool comes(Truth truth) {
    return QTest::qWaitFor(truth, kPatience_ms);
  }
  bool has_tablet(const char* name) {
    return comes([&] { return text("device").contains(QString::fromLatin1(name)); });
  }
  bool says(const char* part) {
    return comes([&] { return feedback().contains(QString::fromLatin1(part)); });
  }
  /// A point of the tablet, in the frame of the device.
  Vec3 in_device_m(const Vec3& tablet_m) {
    const auto mapping = devices::WorkspaceMapping::create(stylus().opened()->calibration);
    return mapping->to_device_m(tablet_m);
  }
  void hold_touch(const Vec3& tablet_m) {
    const Vec3 mm = in_device_m(tablet_m) * 1e3;
    hd_->x_mm = mm.x;
    hd_->y_mm = mm.y;
    hd_->z_mm = mm.z;
  }
  void hold_falcon(const Vec3& tablet_m) {
    const Vec3 at = in_device_m(tablet_m);
    dhd_->y_m = at.x;
    dhd_->z_m = at.y;
    dhd_->x_m = at.z;
  }
  void hold_inverse(InverseService& service, const Vec3& tablet_m) {
    const Vec3 at = in_device_m(tablet_m);
    service.x_m = at.x;
    service.y_m = -at.z;
    service.z_m = at.y;
  }
  [[nodiscard]] Vec3 touch_n() const {
    return {hd_->force_x_n.load(), hd_->force_y_n.load(), hd_->force_z_n.load()};
  }
  [[nodiscard]] Vec3 falcon_n() const {  // x right, y up, z towards the operator
    return {dhd_->force_y_n.load(), dhd_->force_z_n.load(), dhd_->force_x_n.load()};
  }
  /// Traces a stroke with `hold`, up to this share of its length.
  template <class Hold>
  bool trace(const Hold& hold, std::size_t stroke, double part) {
    const auto& path = controller().tablet()->paths()[stroke].points;
    hold({path.front().x, path.front().y, 0.004});
    if (!comes([&] {
          return glm::length(controller().latest().device_m - Vec3{path.front().x, path.front().y, 0.004}) <
                 1e-3;
        }))
      return false;
    const auto most = static_cast<std::size_t>(part * static_cast<double>(path.size()));
    for (std::size_t i = 0; i < most; ++i) {
      const Vec3 at = path[i] - Vec3(0, 0, 0.001);
      hold(at);
      if (!comes([&] { return glm::length(controller().latest().device_m - at) < 2e-3; })) return false;
      QTest::qWait(2);
    }
    controller().pump();
    return controller().ink().progress()[stroke] > 0.5 * part;
  }
  /// Collects the forces of the next servo that uses the tablet.
  void watch_ramp() {
    subscribe(stylus().changed, window_.get(), [this] { ramp_.clear(); });
    subscribe(stylus().sampled, window_.get(), [this](std::span<const haptics::ServoSample> samples) {
      for (const auto& s : samples) ramp_.emplace_back(s.time_s, glm::length(s.force_n));
    });
  }
  /// Expects that the force of a device that was just opened rises within 0.3 s, not at once.
  void expect_ramp() {
    ASSERT_TRUE(comes([&] { return !ramp_.empty() && ramp_.back().second > 0.1; }));
    constexpr double kRamp_s = 0.3, kMost_n = 8;  // of the strongest of these devices
    for (const auto& [since_start_s, force_n] : ramp_) {
      if (since_start_s > kRamp_s) break;
      EXPECT_LE(force_n, kMost_n * (since_start_s + 0.005) / kRamp_s) << since_start_s << " s: a kick";
    }
  }

  struct {
    devices::OpenHapticsSettings openhaptics;
    devices::ForceDimensionSettings force_dimension;
    devices::InverseServiceSettings inverse_service;
  } where_;
  devices::standin::HdStage* hd_ = nullptr;
  devices::standin::DhdStage* dhd_ = nullptr;
  bool with_pads_ = false;
  std::vector<std::pair<double, double>> ramp_;
};

TEST_F(StandIn, ATouchIsFoundFeltAndWrittenWith) {
  hd_->plugged = true;
  open_window();
  ASSERT_TRUE(has_tablet("Stand-in Touch (serial 0042)")) << text("device").toStdString();
  EXPECT_TRUE(says("Now using Stand-in Touch (serial 0042)."));
  hold_touch({0.045, 0.045, 0.004});  // above the plateau
  ASSERT_TRUE(comes([&] { return controller().latest().device_m.z > 0.003; }));
  EXPECT_EQ(glm::length(touch_n()), 0);
  hold_touch({0.045, 0.045, -0.003});
  EXPECT_TRUE(comes([&] { return touch_n().z > 0.3; })) << "an upright tablet pushes towards the learner";
  EXPECT_TRUE(trace([&](const Vec3& at) { hold_touch(at); }, 0, 0.9));
}

TEST_F(StandIn, ATouchThatIsUnpluggedInAStrokeIsFollowedByTheNextBestAndComesBackWithARamp) {
  hd_->plugged = true;
  dhd_->devices = 1;
  dhd_->name = "FALCON";
  open_window();
  ASSERT_TRUE(has_tablet("Stand-in Touch"));
  ASSERT_TRUE(trace([&](const Vec3& at) { hold_touch(at); }, 0, 0.6));
  hold_touch({0.045, 0.045, -0.003});
  ASSERT_TRUE(comes([&] { return touch_n().z > 0.3; }));
  controller().pump();
  const std::vector<double> ink(controller().ink().progress().begin(), controller().ink().progress().end());

  hd_->plugged = false;
  ASSERT_TRUE(
      says("The connection to Stand-in Touch (serial 0042) was lost. Check the cable. Until then, FALCON is "
           "used."))
      << feedback().toStdString();
  EXPECT_EQ(glm::length(touch_n()), 0);
  EXPECT_EQ(hd_->force_despite_error_n, 0);
  EXPECT_TRUE(has_tablet("FALCON"));
  EXPECT_EQ(std::vector<double>(controller().ink().progress().begin(), controller().ink().progress().end()),
            ink)
      << "nothing that was written is lost";
  hold_falcon({0.045, 0.045, -0.003});
  EXPECT_TRUE(comes([&] { return falcon_n().z > 0.3; }));
  hold_falcon({0.045, 0.045, 0.010});  // so that the change of device interrupts no stroke
  ASSERT_TRUE(comes([&] { return !controller().latest().touching; }));

  watch_ramp();
  hd_->plugged = true;
  ASSERT_TRUE(has_tablet("Stand-in Touch"));
  EXPECT_TRUE(comes([&] { return touch_n().z > 0.3; }));
  expect_ramp();
  EXPECT_EQ(glm::length(falcon_n()), 0);
  EXPECT_FALSE(dhd_->force_on);
  EXPECT_TRUE(says("Now using Stand-in Touch (serial 0042)."));
}

TEST_F(StandIn, AFalconIsFoundFeltAndWhenItIsUnpluggedTheMouseWrites) {
  dhd_->devices = 1;
  dhd_->name = "FALCON";
  open_window();
  ASSERT_TRUE(has_tablet("FALCON"));
  ASSERT_TRUE(trace([&](const Vec3& at) { hold_falcon(at); }, 0, 0.6));
  hold_falcon({0.045, 0.045, -0.003});
  ASSERT_TRUE(comes([&] { return falcon_n().z > 0.3; }));
  dhd_->devices = 0;
  ASSERT_TRUE(says("The connection to FALCON was lost. Check the cable. Until then, use a mouse or pen."));
  EXPECT_EQ(dhd_->force_despite_error_n, 0);
  EXPECT_TRUE(stylus().is_pointer());
  EXPECT_GT(controller().ink().progress()[0], 0.3);
  dhd_->devices = 1;
  watch_ramp();
  EXPECT_TRUE(has_tablet("FALCON"));
  expect_ramp();
}

TEST_F(StandIn, AnInverse3IsFoundFeltAndGoesOnWhenItsServiceIsBack) {
  auto service = std::make_unique<InverseService>();
  const auto port = service->port();
  where_.inverse_service.port = port;
  open_window();
  ASSERT_TRUE(has_tablet("Inverse3 049D"));
  hold_inverse(*service, {0.045, 0.045, -0.004});
  ASSERT_TRUE(comes([&] { return service->force_y_n < -0.05; })) << "towards the learner is against its +y";
  controller().pump();

  service.reset();
  ASSERT_TRUE(
      says("The service for Inverse3 049D has stopped. Start it again. Until then, use a mouse or pen."))
      << feedback().toStdString();
  EXPECT_TRUE(stylus().is_pointer());
  EXPECT_NE(stylus().opened(), nullptr) << "it is waited for";
  service = std::make_unique<InverseService>(port);
  hold_inverse(*service, {0.045, 0.045, -0.004});
  ASSERT_TRUE(says("Inverse3 049D is working again. Your writing is still there."));
  EXPECT_TRUE(comes([&] { return service->force_y_n < -0.05; }));
  EXPECT_EQ(service->malformed, 0);
}

TEST_F(StandIn, AServiceThatTalksNonsenseIsSaidOnItsPageAndHoldsNothingUp) {
  InverseService service;
  service.answer = InverseService::Answer::garbage;
  where_.inverse_service.port = service.port();
  where_.openhaptics.library = std::string(test_paths::kStandins) + "/incomplete/libHD.so";
  where_.force_dimension.library = std::string(test_paths::kStandins) + "/not-a-library.so";
  open_window();
  press(Qt::Key_2, Qt::AltModifier);
  ASSERT_TRUE(comes([&] { return texts("reason").size() == 2; })) << texts("reason").join('\n').toStdString();
  const QStringList reasons = texts("reason");
  EXPECT_TRUE(reasons[0].startsWith(QStringLiteral(
      "OpenHaptics (PHANTOM, Touch): the manufacturer's library is too old or the wrong one.")))
      << reasons[0].toStdString();
  EXPECT_TRUE(reasons[1].contains(QStringLiteral("the manufacturer's library is not installed")))
      << reasons[1].toStdString();
  EXPECT_TRUE(says("Inverse3 049D sends data that cannot be read")) << feedback().toStdString();
  EXPECT_TRUE(stylus().is_pointer());
}

TEST_F(StandIn, TheTroubleOfADeviceIsSaidAgainWhereItsPageIsEntered) {
  InverseService service;
  service.answer = InverseService::Answer::garbage;
  where_.inverse_service.port = service.port();
  open_window();
  ASSERT_TRUE(says("Inverse3 049D sends data that cannot be read")) << feedback().toStdString();
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_TRUE(says("Inverse3 049D sends data that cannot be read")) << feedback().toStdString();
}

TEST_F(StandIn, TheChosenDeviceThatIsAbsentIsSaidTheNextBestServesAndItComesWhenPluggedIn) {
  dhd_->devices = 1;
  dhd_->name = "FALCON";
  QSettings(folder_.filePath(QStringLiteral("nazori.ini")), QSettings::IniFormat)
      .setValue(QStringLiteral("device/chosen"), QStringLiteral("openhaptics"));
  open_window();
  ASSERT_TRUE(has_tablet("FALCON"));
  EXPECT_TRUE(says("Until then, FALCON is used.")) << feedback().toStdString();
  hd_->plugged = true;
  EXPECT_TRUE(has_tablet("Stand-in Touch"));
}

TEST_F(StandIn, AGamepadIsChosenMovesTheTipRumblesAndIsTakenUpAgain) {
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  ASSERT_EQ(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER), 0) << SDL_GetError();
  with_pads_ = true;
  auto pad = std::make_unique<VirtualPad>();
  open_window();
  press(Qt::Key_2, Qt::AltModifier);
  QRadioButton* choice = nullptr;
  ASSERT_TRUE(comes([&] {
    for (auto* button : window_->findChildren<QRadioButton*>())
      if (button->accessibleName() == QStringLiteral("Nazori's virtual pad")) choice = button;
    return choice != nullptr;
  }));
  choice->click();
  ASSERT_TRUE(has_tablet("Nazori's virtual pad"));
  pad->axis(SDL_CONTROLLER_AXIS_RIGHTX, 16'384);
  EXPECT_TRUE(comes([&] { return controller().latest().device_m.x > 0.02; }));
  // From the floor of the trial, pressed a little into the wall, where the tip stays. Further in, it would
  // slide over the wall.
  pad->axis(SDL_CONTROLLER_AXIS_RIGHTX, -32'768);
  ASSERT_TRUE(comes([&] { return controller().latest().device_m.x < -0.04; }));
  pad->axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 32'767);
  ASSERT_TRUE(comes([&] { return controller().latest().touching; }));
  find<QPushButton>("button_stronger")->click();
  pad->axis(SDL_CONTROLLER_AXIS_RIGHTX, -9'000);
  EXPECT_TRUE(comes([&] { return pad->low > 0; })) << "the wall is felt";

  pad.reset();
  ASSERT_TRUE(says(
      "The connection to Nazori's virtual pad was lost. Check the cable. Until then, use a mouse or pen."))
      << feedback().toStdString();
  EXPECT_TRUE(stylus().is_pointer());
  pad = std::make_unique<VirtualPad>();
  EXPECT_TRUE(has_tablet("Nazori's virtual pad"));
  window_.reset();
  pad.reset();
  SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

/// A back end that blocks in its maker's library until the test releases it.
struct Stuck final : devices::BackEnd {
  struct Gate {
    std::mutex lock;
    std::condition_variable opened;
    bool open = false, reached = false;
    void pass() {
      std::unique_lock one(lock);
      reached = true;
      opened.notify_all();
      opened.wait(one, [this] { return open; });
    }
    void let_go() {
      const std::lock_guard one(lock);
      open = true;
      opened.notify_all();
    }
    bool is_reached() {
      const std::lock_guard one(lock);
      return reached;
    }
  };
  explicit Stuck(std::shared_ptr<Gate> gate) : gate_(std::move(gate)) {}
  [[nodiscard]] std::string_view id() const override { return "stuck"; }
  [[nodiscard]] devices::BackEndFindings find() override {
    gate_->pass();
    return {"Stuck", {}, {{haptics::DeviceTrouble::service_missing, {base::Errc::device, "none", "", ""}}}};
  }
  [[nodiscard]] devices::DeviceResult<devices::OpenedDevice> open(std::string_view,
                                                                  const devices::OpenRequest&) override {
    return devices::no_device(haptics::DeviceTrouble::service_missing, "none", "Stuck", "");
  }
  std::shared_ptr<Gate> gate_;
};

TEST_F(StandIn, TheWindowOpensAndTheMouseWritesWhileALibraryDoesNotAnswer) {
  auto gate = std::make_shared<Stuck::Gate>();
  back_ends_ = [gate] {
    std::vector<std::unique_ptr<devices::BackEnd>> all;
    all.push_back(std::make_unique<Stuck>(gate));
    all.push_back(devices::pointer_back_end());
    return all;
  };
  open_window();
  ASSERT_TRUE(comes([&] { return gate->is_reached(); }));
  EXPECT_TRUE(stylus().is_searching());
  controller().move_stylus({0.045, 0.045}, true);
  EXPECT_TRUE(comes([&] { return controller().latest().touching; }));
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_TRUE(find("searching")->isVisible());
  gate->let_go();
  EXPECT_TRUE(comes([&] { return !find("searching")->isVisible(); }));
  EXPECT_FALSE(stylus().is_searching());
}

}  // namespace
}  // namespace nazori::ui
