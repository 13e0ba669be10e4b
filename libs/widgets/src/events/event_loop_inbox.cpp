// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/events/event_loop_inbox.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <QObject>
#include <QSocketNotifier>
#include <cstdint>

namespace nazori::ui {

/// Wakes the event loop from another thread. It uses a file descriptor instead of an event of Qt: the thread
/// sanitizer does not see into Qt, so threads exchange data only through base::Inbox.
class EventLoopInbox::Bell {
 public:
  explicit Bell(base::Inbox& inbox)
      : file_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK | EFD_SEMAPHORE)),
        notifier_(file_, QSocketNotifier::Read) {
    Q_ASSERT(file_ >= 0);
    QObject::connect(&notifier_, &QSocketNotifier::activated, &notifier_, [file = file_, &inbox] {
      std::uint64_t one = 0;
      // The task may destroy the inbox and this object: neither is used afterwards.
      if (read(file, &one, sizeof one) == sizeof one) inbox.run_one();
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
    // Fails only with 2^64 wake-ups that were not read.
    (void)!write(file_, &one, sizeof one);
  }

 private:
  const int file_;
  QSocketNotifier notifier_;
};

EventLoopInbox::EventLoopInbox() : bell_(std::make_unique<Bell>(inbox_)), inbox_([this] { bell_->ring(); }) {}

EventLoopInbox::~EventLoopInbox() = default;

}  // namespace nazori::ui
