// SPDX-License-Identifier: Apache-2.0
// What of the window has a thread: asked again and again, and ended in the middle of it. Needs no widget, so
// that the thread sanitizer can watch it too.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QObject>
#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "functions/plotter.h"
}  // namespace
}  // namespace nazori::ui
