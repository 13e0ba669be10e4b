// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QEvent>
#include <QObject>
#include <QThread>
#include <functional>
#include <utility>

namespace nazori::ui {

/// One thread that does pieces of work in the order they are posted, so that the window never waits for them.
/// The destructor finishes the piece at hand, drops the rest and what was answered but not yet heard, and
/// joins the thread.
class Worker {
 public:
  using Work = std::function<void()>;

  /// Answers are heard on the thread that makes the worker.
  explicit Worker(const QString& name) : tasks_(new Inbox) {
    thread_.setObjectName(name);
    tasks_->moveToThread(&thread_);
    thread_.start(QThread::LowPriority);
  }
  ~Worker() {
    thread_.quit();
    thread_.wait();
    delete tasks_;
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Runs `work` on the worker's thread, later.
  void post(Work work) { QCoreApplication::postEvent(tasks_, new Letter(std::move(work))); }

  /// From a piece of work: runs `work` on the thread that made the worker, later.
  void answer(Work work) { QCoreApplication::postEvent(&answers_, new Letter(std::move(work))); }

 private:
  class Letter final : public QEvent {
   public:
    explicit Letter(Work work) : QEvent(QEvent::User), work_(std::move(work)) {}
    void open() const { work_(); }

   private:
    Work work_;
  };

  class Inbox final : public QObject {
   public:
    bool event(QEvent* event) override {
      if (event->type() != QEvent::User) return QObject::event(event);
      static_cast<const Letter*>(event)->open();
      return true;
    }
  };

  QThread thread_;
  Inbox answers_;
  Inbox* tasks_;
};

}  // namespace nazori::ui
