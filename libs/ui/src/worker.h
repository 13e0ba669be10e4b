// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMetaObject>
#include <QObject>
#include <QThread>
#include <utility>

namespace nazori::ui {

/// One thread that does pieces of work in the order they are posted, so that the window never waits for them.
/// The destructor finishes the piece at hand, drops the rest and joins the thread.
class Worker {
 public:
  explicit Worker(const QString& name) {
    thread_.setObjectName(name);
    context_ = new QObject;
    context_->moveToThread(&thread_);
    thread_.start(QThread::LowPriority);
  }
  ~Worker() {
    thread_.requestInterruption();
    thread_.quit();
    thread_.wait();
    delete context_;
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Runs `work` on the worker's thread, later.
  template <class Work>
  void post(Work&& work) {
    QMetaObject::invokeMethod(context_, std::forward<Work>(work), Qt::QueuedConnection);
  }

  /// Runs `work` on the thread of `receiver`, later, unless `receiver` is gone by then.
  template <class Work>
  static void answer(QObject* receiver, Work&& work) {
    QMetaObject::invokeMethod(receiver, std::forward<Work>(work), Qt::QueuedConnection);
  }

 private:
  QThread thread_;
  QObject* context_ = nullptr;
};

}  // namespace nazori::ui
