// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QTemporaryDir>

#include "watchdog.h"

// Widgets need an application. No test may read or write the settings of the person who runs it.
int main(int argc, char** argv) {
  const QTemporaryDir config;
  qputenv("XDG_CONFIG_HOME", config.path().toUtf8());
  qputenv("XDG_DATA_HOME", config.path().toUtf8());
  qunsetenv("NAZORI_LEARNERS");
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const nazori::ui::test::WatchedApplication application(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
