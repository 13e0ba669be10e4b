// SPDX-License-Identifier: Apache-2.0
#include "watchdog.h"

#include <QEvent>
#include <QMetaEnum>
#include <QThread>
#include <ctime>
#include <utility>

namespace nazori::ui::test {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr double kSlower = 6;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr double kSlower = 6;
#else
constexpr double kSlower = 1;
#endif
#else
constexpr double kSlower = 1;
#endif

double g_longest_ms = 0;
QString g_longest;
int g_level = -1;        ///< of the event loop whose event is being measured
double g_nested_ms = 0;  ///< of events of nested loops

double processor_ms(clockid_t clock = CLOCK_THREAD_CPUTIME_ID) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
  const int level = QThread::currentThread()->loopLevel();
  // Events that are sent meanwhile belong to the event that is being measured.
  if (QThread::currentThread() != thread() || level <= g_level) return QApplication::notify(receiver, event);
  const QString name =
      QStringLiteral("%1 of a %2 %3")
          .arg(QString::fromLatin1(QMetaEnum::fromType<QEvent::Type>().valueToKey(event->type())),
               QString::fromLatin1(receiver->metaObject()->className()), receiver->objectName());
  const int level_before = std::exchange(g_level, level);
  const double nested_before = std::exchange(g_nested_ms, 0);
  const double begin_ms = processor_ms();
  const bool taken = QApplication::notify(receiver, event);
  const double all_ms = processor_ms() - begin_ms;
  const double own_ms = (all_ms - g_nested_ms) / kSlower;
  g_level = level_before;
  g_nested_ms = nested_before + all_ms;
  if (own_ms > g_longest_ms) {
    g_longest_ms = own_ms;
    g_longest = name;
  }
  return taken;
}

Watchdog::Watchdog() : begin_ms_(processor_ms(CLOCK_PROCESS_CPUTIME_ID)) {
  g_longest_ms = 0;
  g_longest.clear();
}

double Watchdog::longest_ms() { return g_longest_ms; }
QString Watchdog::longest() { return g_longest; }
double Watchdog::all_threads_ms() const {
  return (processor_ms(CLOCK_PROCESS_CPUTIME_ID) - begin_ms_) / kSlower;
}

}  // namespace nazori::ui::test
