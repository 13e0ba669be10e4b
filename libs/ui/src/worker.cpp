// SPDX-License-Identifier: Apache-2.0
#include "worker.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <QObject>
#include <QSocketNotifier>
#include <cstdint>

namespace nazori::ui {

/// Wakes the event loop from another thread. A file, not an event of Qt: nothing that is made on one thread
/// is then read on another but what base::Worker keeps under its lock, which a thread sanitizer can see.
class Worker::Bell {
 public:
  /// @param heard  on the thread that makes the bell, once for each ring() or more.
  explicit Bell(std::function<void()> heard)
      : file_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK | EFD_SEMAPHORE)),
        notifier_(file_, QSocketNotifier::Read) {
    Q_ASSERT(file_ >= 0);
    QObject::connect(&notifier_, &QSocketNotifier::activated, &notifier_,
                     [file = file_, heard = std::move(heard)] {
                       std::uint64_t one = 0;
                       // The answer may be the end of this bell: nothing of it is used afterwards.
                       const auto hear = heard;
                       if (read(file, &one, sizeof one) == sizeof one) hear();
                     });
  }
  ~Bell() {
    notifier_.setEnabled(false);
    close(file_);
  }
  Bell(const Bell&) = delete;
  Bell& operator=(const Bell&) = delete;

  void ring() const {
    const std::uint64_t one = 1;
    // Fails only where there are 2^64 rings that nobody has heard.
    (void)!write(file_, &one, sizeof one);
  }

 private:
  const int file_;
  QSocketNotifier notifier_;
};

Worker::Worker(const QString& name)
    : bell_(std::make_unique<Bell>([this] { worker_->hear_one(); })),
      worker_(std::make_unique<base::Worker>(name.toStdString(), [bell = bell_.get()] { bell->ring(); })) {}

Worker::~Worker() = default;

}  // namespace nazori::ui
