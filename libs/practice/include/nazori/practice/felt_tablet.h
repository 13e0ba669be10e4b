// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "nazori/base/executor.h"
#include "nazori/base/latest.h"
#include "nazori/base/signal.h"
#include "nazori/tablet/carved_tablet.h"

namespace nazori::practice {

/// A tablet as the tip of the stylus feels it. The surface that a ball feels is prepared on another thread.
/// Until it is ready, a new tablet is felt with a point, and with another radius the tablet is felt as
/// before, so that nobody waits. Thread: the owner of the inbox.
class FeltTablet {
 public:
  using Tablet = std::shared_ptr<const tablet::CarvedTablet>;

  /// @param inbox  outlives this. The thread starts with the first ball.
  explicit FeltTablet(base::Inbox& inbox) : inbox_(inbox) {}

  /// Another tablet; null: none. Does not emit changed().
  void set_tablet(Tablet tablet);
  /// Another radius of the ball at the tip, 0..surface::kLargestBall_m [m]; 0: a point. What is out of range
  /// is moved into it; what is no number counts as a point.
  void set_radius(double radius_m);
  [[nodiscard]] double radius_m() const { return radius_m_; }
  /// Whether a surface is being prepared.
  [[nodiscard]] bool is_preparing() const { return preparing_ && preparing_->is_busy(); }

  /// What is felt now. Null without a tablet.
  [[nodiscard]] const Tablet& felt() const { return felt_; }
  /// felt() is another one.
  base::Signal<> changed;

 private:
  struct Request {
    Tablet tablet;
    double radius_m = 0;
  };
  using Preparing = base::Latest<Request, Tablet>;

  void prepare();

  base::Inbox& inbox_;
  Tablet tablet_, felt_;
  double radius_m_ = 0;
  std::optional<Preparing> preparing_;  // declared last, so that its thread ends first
};

}  // namespace nazori::practice
