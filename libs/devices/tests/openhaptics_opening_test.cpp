// SPDX-License-Identifier: Apache-2.0
// Finding and opening a device of OpenHaptics, and libraries that are missing or incomplete.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "openhaptics_fixture.h"
#include "openhaptics_port.h"

namespace nazori::devices {
namespace {

using haptics::DeviceTrouble;
using test::FeltPlane;
using test::OpenHaptics;

TEST_F(OpenHaptics, TriesTheUsersNameThenTheFirstThenTheUsualNames) {
  for (const char* name : {"", "Default Device", "Default PHANToM"}) {
    stage->only_name = name;
    EXPECT_TRUE(back_end->open("openhaptics", {})) << name;
    stage->garbage_handle = true;  // some versions: no error, and an invalid device number
    EXPECT_TRUE(back_end->open("openhaptics", {}).has_value() || *name == '\0') << name;
    stage->garbage_handle = false;
  }
  stage->only_name = "Left";
  EXPECT_FALSE(back_end->open("openhaptics", {}));
  EXPECT_EQ(back_end->open("openhaptics:Left", {})->id, "openhaptics:Left");
  OpenHapticsSettings by_name = settings();
  by_name.device_name = "Left";
  EXPECT_TRUE(openhaptics_back_end(by_name)->open("openhaptics", {}));
}

TEST_F(OpenHaptics, ADeviceThatIsOpenIsListedAsInUse) {
  const OpenedDevice device = opened();
  const BackEndFindings found = back_end->find();
  EXPECT_EQ(found.devices.size(), 1U);
  EXPECT_EQ(found.problem->trouble, DeviceTrouble::in_use);
  EXPECT_EQ(back_end->open("openhaptics", {}).error().trouble, DeviceTrouble::in_use);
  // Or it is in use by another part of the program, or another program, as the library reports.
  EXPECT_EQ(openhaptics_back_end(settings())->open("openhaptics", {}).error().trouble, DeviceTrouble::in_use);
}

TEST_F(OpenHaptics, EveryFailureToOpenSaysInOneLineWhatToDo) {
  struct Case {
    unsigned int code;
    DeviceTrouble trouble;
    const char* words;
  };
  for (const Case& c : {Case{0x0304, DeviceTrouble::no_timer, "close other programs"},
                        Case{0x0302, DeviceTrouble::device_absent, "Touch_Setup"},
                        Case{0x0303, DeviceTrouble::device_absent, "'Default PHANToM'"},
                        Case{0x0200, DeviceTrouble::init_failed, "wait a few minutes"},
                        Case{0x0600, DeviceTrouble::init_failed, "OH_SDK_LICENSE_PATH"},
                        Case{0x0102, DeviceTrouble::init_failed, "Touch_Diagnostic"}}) {
    stage->init_error = c.code;
    const BackEndFindings found = back_end->find();
    ASSERT_TRUE(found.problem);
    EXPECT_EQ(found.problem->trouble, c.trouble) << c.code;
    const std::string line = base::to_line(found.problem->error);
    EXPECT_NE(line.find(c.words), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(stage->disables, 0);
  }
}

TEST_F(OpenHaptics, TheSecondLookSaysWhatTheFirstSaidThoughTheLibraryDoesNot) {
  // The library reports 0x0302 to 0x0304 once for each cause.
  for (const auto& [code, words] :
       {std::pair{0x0302U, "0x0302"}, std::pair{0x0303U, "0x0303"}, std::pair{0x0304U, "0x0304"}}) {
    stage->init_error = code;
    const BackEndFindings first = back_end->find();
    const BackEndFindings second = back_end->find();
    ASSERT_TRUE(first.problem && second.problem);
    EXPECT_NE(base::to_line(first.problem->error).find(words), std::string::npos);
    EXPECT_EQ(base::to_line(second.problem->error), base::to_line(first.problem->error));
    EXPECT_EQ(second.problem->trouble, first.problem->trouble);
  }
}

TEST_F(OpenHaptics, ALibraryThatRefusesWithoutAReasonIsNotSentToTheWrongTool) {
  {
    // Errors of an earlier device are cleared once a device has run.
    FeltPlane plane;
    OpenedDevice device = opened();
    stage->start_error = 0x0304;
    EXPECT_FALSE(device.device->start(plane));
    stage->start_error = 0;
    ASSERT_TRUE(device.device->start(plane));
  }
  stage->init_error = 0x0302;
  stage->silent = true;
  const BackEndFindings found = back_end->find();
  ASSERT_TRUE(found.problem);
  EXPECT_EQ(found.problem->trouble, DeviceTrouble::device_absent);
  EXPECT_NE(base::to_line(found.problem->error).find("does not say why (tried"), std::string::npos)
      << base::to_line(found.problem->error);
}

TEST_F(OpenHaptics, TheMakersBannerIsNotPrinted) {
  testing::internal::CaptureStderr();
  (void)back_end->find();
  std::fputs("ours\n", stderr);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "ours\n");
}

TEST_F(OpenHaptics, AnUnusableCalibrationIsRefusedAndTheDeviceClosed) {
  OpenRequest request;
  request.calibration.emplace();
  request.calibration->scale = 0;
  const auto refused = back_end->open("openhaptics", request);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().trouble, DeviceTrouble::bad_calibration);
  EXPECT_EQ(stage->disables, 1);
  EXPECT_TRUE(back_end->open("openhaptics", {}));
}

TEST_F(OpenHaptics, AMissingLibraryIsNamedWithAllTheNamesThatWereTried) {
  OpenHapticsSettings missing;
  missing.library = "/nowhere/libHD.so";
  const BackEndFindings found = openhaptics_back_end(missing)->find();
  ASSERT_TRUE(found.problem);
  EXPECT_EQ(found.problem->trouble, DeviceTrouble::library_missing);
  EXPECT_NE(base::to_line(found.problem->error).find("/nowhere/libHD.so"), std::string::npos);
}

TEST_F(OpenHaptics, OnlyNodesOfTheMakerCountAsDevicesThatMayNotBeOpened) {
  namespace fs = std::filesystem;
  const fs::path root = fs::path(testing::TempDir()) / "nazori-touch-nodes";
  fs::remove_all(root);
  const auto node = [&](const std::string& name, const std::string& group, const std::string& about) {
    fs::create_directories(root / "dev");
    fs::create_directories(root / "sys" / "class" / group / name / "device");
    std::ofstream(root / "dev" / name) << "";
    fs::permissions(root / "dev" / name, fs::perms::none);
    std::ofstream(root / "sys" / "class" / group / name / "device" / "uevent") << about;
  };
  // Root may open everything, so the check runs as the user nobody.
  const auto line_as_nobody = [&]() -> std::string {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    const pid_t process = fork();
    if (process == 0) {
      if (geteuid() == 0 && setuid(65534) != 0) std::_Exit(1);
      OpenHapticsSettings s = settings();
      s.device_folder = root / "dev";
      s.system_folder = root / "sys";
      stage->init_error = 0x0303;
      const std::string line = base::to_line(openhaptics_back_end(s)->find().problem->error);
      (void)!write(ends[1], line.data(), line.size());
      std::_Exit(0);
    }
    close(ends[1]);
    std::string line(4096, '\0');
    line.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(ends[0], line.data(), line.size()))));
    close(ends[0]);
    waitpid(process, nullptr, 0);
    return line;
  };
  node("hidraw0", "hidraw", "DRIVER=hid-generic\nHID_ID=0003:0000046D:0000C31C\n");  // a keyboard
  node("ttyACM0", "tty", "DRIVER=cdc_acm\nPRODUCT=2341/43/1\n");
  EXPECT_NE(line_as_nobody().find("Touch_Setup"), std::string::npos) << line_as_nobody();
  node("hidraw1", "hidraw", "DRIVER=hid-generic\nHID_ID=0003:00002988:00000302\n");
  EXPECT_NE(line_as_nobody().find("/dev/hidraw1: install a udev rule"), std::string::npos)
      << line_as_nobody();
  fs::remove(root / "dev" / "hidraw1");
  node("ttyACM1", "tty", "DRIVER=cdc_acm\nPRODUCT=2988/302/100\n");
  EXPECT_NE(line_as_nobody().find("/dev/ttyACM1"), std::string::npos) << line_as_nobody();
  fs::remove_all(root);
}

TEST_F(OpenHaptics, ALibraryThatLacksAFunctionIsRefusedByTheNameOfTheFunction) {
  OpenHapticsSettings incomplete;
  incomplete.library = std::string(test_paths::kStandins) + "/incomplete/libHD.so";
  const auto refused = openhaptics_back_end(incomplete)->open("openhaptics", {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().trouble, DeviceTrouble::symbol_missing);
  EXPECT_NE(base::to_line(refused.error().error).find("hdUnschedule"), std::string::npos);
}

TEST_F(OpenHaptics, AFileThatIsNoLibraryIsSaidInTheLoadersWords) {
  OpenHapticsSettings text;
  text.library = std::string(test_paths::kStandins) + "/not-a-library.so";
  const auto refused = openhaptics_back_end(text)->open("openhaptics", {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().trouble, DeviceTrouble::library_missing);
  EXPECT_NE(base::to_line(refused.error().error).find("cannot be loaded"), std::string::npos);
}

TEST_F(OpenHaptics, ALibraryThatLacksAnotherNamesWhatBringsIt) {
  // The loader's message in Debian 12.
  const auto words = [](const std::string& library) {
    return "the library was found but cannot be loaded: " + library +
           ": cannot open shared object file: No such file or directory";
  };
  EXPECT_NE(hd::remedy_for_missing(words("libncurses.so.5"), "x").find("libncurses5"), std::string::npos);
  EXPECT_NE(hd::remedy_for_missing(words("libPhantomManagerLite.so"), "x").find("HID driver"),
            std::string::npos);
  for (const char* driver : {"libPHANToMIO.so.4", "libPhantomIOLib42.so"})
    EXPECT_NE(hd::remedy_for_missing(words(driver), "x").find("Touch driver"), std::string::npos);
  EXPECT_EQ(hd::remedy_for_missing(words("libm.so.6"), "x"), "x");
}

TEST_F(OpenHaptics, WithoutItTheProgramGoesOnWithTheNextBest) {
  std::vector<std::unique_ptr<BackEnd>> all;
  all.push_back(openhaptics_back_end(settings()));
  all.push_back(pointer_back_end());
  DeviceCatalogue catalogue(std::move(all));
  EXPECT_EQ(catalogue.open_best("", {}).opened->id, "openhaptics");
  stage->plugged = false;
  const BestDevice best = catalogue.open_best("openhaptics", {});
  EXPECT_EQ(best.opened->id, "pointer");
  ASSERT_FALSE(best.passed_over.empty());
  EXPECT_EQ(best.passed_over.front().trouble, DeviceTrouble::device_absent);
}

}  // namespace
}  // namespace nazori::devices
