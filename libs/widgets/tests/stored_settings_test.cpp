// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/settings/stored_settings.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>

#include "nazori/devices/device_settings.h"

namespace nazori::ui {
namespace {

class StoredSettings : public testing::Test {
 protected:
  [[nodiscard]] QString file() const { return folder_.filePath(QStringLiteral("nazori.ini")); }
  QTemporaryDir folder_;
};

TEST_F(StoredSettings, OfDevicesAreReadFromTheFileAndWrittenToItAndTheRestStays) {
  {
    QSettings settings(file(), QSettings::IniFormat);
    settings.setValue(QStringLiteral("device/inverse_port"), 10002);
    settings.setValue(QStringLiteral("device/chosen"), QStringLiteral("a, b"));
    settings.setValue(QStringLiteral("device/known/61726d3a31/scale"), 1.5);
    settings.setValue(QStringLiteral("device/known/61726d3a31/tilt"), 0.5);
    settings.setValue(QStringLiteral("device/list"), QStringList{QStringLiteral("a"), QStringLiteral("b")});
    settings.setValue(QStringLiteral("other/x"), 1);
  }
  devices::DeviceMemory memory;
  {
    QSettings settings(file(), QSettings::IniFormat);
    settings.beginGroup(QStringLiteral("device"));
    auto values = read_settings(settings);
    EXPECT_EQ(values.at("inverse_port"), "10002");
    EXPECT_FALSE(values.contains("x"));
    memory.load(values);
    EXPECT_EQ(memory.chosen, "a, b");
    const auto arm = devices::settings_of(memory.devices, "arm:1");
    EXPECT_EQ(arm.posture.tilt_rad, 0.5);
    ASSERT_TRUE(arm.calibration);
    EXPECT_EQ(arm.calibration->scale, 1.5);
    memory.devices["arm:1"].calibration.reset();
    memory.devices["arm/1: Ä"].max_force_n = 0.1;
    memory.save(values);
    write_settings(settings, values);
    EXPECT_EQ(settings.group(), QStringLiteral("device")) << "it stands where it stood";
  }
  QSettings settings(file(), QSettings::IniFormat);
  EXPECT_FALSE(settings.contains(QStringLiteral("device/known/61726d3a31/scale")));
  EXPECT_EQ(settings.value(QStringLiteral("device/list")).toStringList().size(), 2);
  EXPECT_EQ(settings.value(QStringLiteral("device/inverse_port")).toInt(), 10002);
  EXPECT_EQ(settings.value(QStringLiteral("other/x")).toInt(), 1);
  settings.beginGroup(QStringLiteral("device"));
  devices::DeviceMemory again;
  again.load(read_settings(settings));
  EXPECT_EQ(devices::settings_of(again.devices, "arm/1: Ä").max_force_n, 0.1);
  EXPECT_FALSE(devices::settings_of(again.devices, "arm:1").calibration);
}

TEST_F(StoredSettings, AreWrittenOnlyWhereTheyDiffer) {
  QSettings settings(file(), QSettings::IniFormat);
  settings.setValue(QStringLiteral("same"), QStringList{QStringLiteral("a")});
  settings.setValue(QStringLiteral("other"), QStringLiteral("old"));
  settings.setValue(QStringLiteral("gone"), 1);
  base::Settings values = read_settings(settings);
  values["other"] = "new";
  values["added"] = "1";
  values.erase("gone");
  write_settings(settings, values);
  EXPECT_EQ(settings.allKeys(),
            (QStringList{QStringLiteral("added"), QStringLiteral("other"), QStringLiteral("same")}));
  EXPECT_EQ(settings.value(QStringLiteral("other")).toString(), QStringLiteral("new"));
  EXPECT_EQ(settings.value(QStringLiteral("added")).toString(), QStringLiteral("1"));
}

TEST_F(StoredSettings, RecordingsThatAreUnfinishedAreListedUntilThereAreNone) {
  const auto unfinished = unfinished_recordings(file());
  EXPECT_TRUE(unfinished.read().empty());
  const std::vector<std::string> two{"/a/休.nzr", "/b/c, d.csv"};
  unfinished.write(two);
  EXPECT_EQ(unfinished.read(), two);
  EXPECT_EQ(unfinished_recordings(file()).read(), two) << "in the file";
  unfinished.write({"/a/休.nzr"});
  EXPECT_EQ(unfinished.read(), std::vector<std::string>{"/a/休.nzr"});
  unfinished.write({});
  EXPECT_TRUE(unfinished.read().empty());
  EXPECT_FALSE(QSettings(file(), QSettings::IniFormat).contains(QStringLiteral("recording/unfinished")));
}

}  // namespace
}  // namespace nazori::ui
