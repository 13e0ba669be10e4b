// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "nazori/base/executor.h"

namespace nazori::base {

/// Requests that another thread answers and of which only the newest matters. An older one that has not begun
/// is skipped. One that is running is asked to stop, and its answer is dropped.
/// @tparam Request, Answer  copied or moved between the threads.
/// @tparam Part  what a running request may report before its answer, such as its progress. Reports arrive in
/// order, before the answer, and only while their request is the newest.
/// Thread: the owner of the inbox makes, uses and destroys this object.
template <class Request, class Answer, class Part = double>
class Latest {
 public:
  /// What the work of one request may ask and report. Thread: the one that does the work.
  class Run {
   public:
    /// False once a newer request was made, or this one was cancelled: the work must then end as soon as it
    /// can.
    [[nodiscard]] bool is_wanted() const { return newest_->load() == ticket_; }
    /// The number that request() returned.
    [[nodiscard]] std::uint64_t ticket() const { return ticket_; }
    /// Sends a partial result to the owner.
    void report(Part part) const { report_(std::move(part)); }

   private:
    friend class Latest;
    std::shared_ptr<const std::atomic<std::uint64_t>> newest_;
    std::uint64_t ticket_ = 0;
    std::function<void(Part)> report_;
  };

  /// On the work's thread.
  using Work = std::function<Answer(const Request& request, const Run& run)>;
  /// On the owner's thread; may make the next request, or destroy this object.
  using Answered = std::function<void(Answer answer)>;
  /// On the owner's thread.
  using Reported = std::function<void(Part part)>;

  /// Uses a thread of its own. @param name  of the thread, for debuggers. @param inbox  outlives this.
  /// @param work  is called by that thread alone and owns what it uses.
  Latest(const std::string& name, Inbox& inbox, Work work, Answered answered, Reported reported = {})
      : Latest(std::make_shared<Background>(name, inbox), std::move(work), std::move(answered),
               std::move(reported)) {}
  /// Uses a thread that others use, too.
  Latest(std::shared_ptr<Background> background, Work work, Answered answered, Reported reported = {})
      : work_(std::make_shared<const Work>(std::move(work))),
        answered_(std::move(answered)),
        reported_(std::move(reported)),
        background_(std::move(background)) {}
  /// Asks the running work to stop. Waits until it has stopped, unless others share the thread.
  ~Latest() { ++*newest_; }
  Latest(const Latest&) = delete;
  Latest& operator=(const Latest&) = delete;

  /// Requests an answer to `request`. Earlier requests are cancelled.
  /// @return its number, counted from 1.
  std::uint64_t request(Request request) {
    Run run;
    run.newest_ = newest_;
    run.ticket_ = ++*newest_;
    // The thread that runs this belongs to the background, so the background outlives it.
    run.report_ = [this, background = background_.get(), alive = std::weak_ptr(alive_),
                   ticket = run.ticket_](Part part) {
      background->answer([this, alive, ticket, part = std::move(part)]() mutable {
        if (!alive.expired() && *newest_ == ticket && reported_) reported_(std::move(part));
      });
    };
    is_busy_ = true;
    background_->post([this, background = background_.get(), alive = std::weak_ptr(alive_),
                       run = std::move(run), work = work_, request = std::move(request)] {
      if (!run.is_wanted()) return;
      background->answer([this, alive, ticket = run.ticket_, answer = (*work)(request, run)]() mutable {
        if (alive.expired() || *newest_ != ticket) return;
        is_busy_ = false;
        // A copy, because the answer may destroy this object.
        const auto answered = answered_;
        answered(std::move(answer));
      });
    });
    return *newest_;
  }
  /// Cancels all requests. Does not wait.
  void cancel() {
    ++*newest_;
    is_busy_ = false;
  }
  /// Cancels, and waits until the work no longer uses anything.
  void cancel_and_wait() {
    cancel();
    std::atomic<bool> is_idle{false};
    background_->post([&is_idle] {
      is_idle = true;
      is_idle.notify_one();
    });
    is_idle.wait(false);
  }
  /// Whether the newest request is not yet answered.
  [[nodiscard]] bool is_busy() const { return is_busy_; }

 private:
  std::shared_ptr<std::atomic<std::uint64_t>> newest_ = std::make_shared<std::atomic<std::uint64_t>>(0);
  std::shared_ptr<const int> alive_ = std::make_shared<const int>(0);  ///< read by the owner's thread only
  std::shared_ptr<const Work> work_;
  Answered answered_;
  Reported reported_;
  bool is_busy_ = false;
  std::shared_ptr<Background> background_;  // declared last, so that its thread ends first
};

}  // namespace nazori::base
