// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <utility>
#include <variant>

#include "nazori/base/latest.h"
#include "nazori/base/signal.h"
#include "nazori/functions/drawing.h"

namespace nazori::functions {

/// Draws plots on a separate thread, coarse and then fine; a newer request stops an older one. Requests
/// return at once, answers come as signals on the thread of the inbox.
/// @tparam Shown  the type made from a drawing before it is shown, such as a tablet. Copied. Thread: the
/// owner of the inbox.
template <class Shown>
class Plotter {
 public:
  /// Makes a Shown from a drawing, on the plotter's thread. An error ends the request.
  using Finish = std::function<base::Result<Shown>(Drawing&& drawing)>;

  /// @param inbox  outlives the plotter.
  Plotter(base::Inbox& inbox, Finish finish)
      : latest_(
            "plotter", inbox,
            [finish = std::move(finish)](const PlotRequest& request, const Run& run) {
              return draw(request, run, finish);
            },
            [this](const base::Result<void>& result) {
              rested();
              if (!result && result.error().code != base::Errc::cancelled) failed(result.error());
            },
            [this](const Part& part) {
              if (const auto* shown = std::get_if<Shown>(&part))
                drawn(*shown);
              else
                progressed(std::get<double>(part));
            }) {}

  void draw(PlotRequest request) { latest_.request(std::move(request)); }
  /// Cancels the present drawing; the last one remains shown.
  void stop() {
    if (!latest_.is_busy()) return;
    latest_.cancel();
    rested();
  }
  [[nodiscard]] bool is_busy() const { return latest_.is_busy(); }

  base::Signal<const Shown&> drawn;
  base::Signal<double> progressed;  ///< from 0 to 1 while it is busy
  base::Signal<> rested;            ///< stopped, failed or done
  base::Signal<const base::Error&> failed;

 private:
  using Part = std::variant<double, Shown>;
  using Work = base::Latest<PlotRequest, base::Result<void>, Part>;
  using Run = typename Work::Run;
  using Time = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kProgressStep{50};

  static base::Result<void> draw(const PlotRequest& request, const Run& run, const Finish& finish) {
    base::Result<void> finished;
    const auto show = [&](Drawing&& drawing) {
      auto shown = finish(std::move(drawing));
      if (!shown) {
        finished = tl::unexpected(std::move(shown.error()));
        return false;
      }
      run.report(std::move(*shown));
      return run.is_wanted();
    };
    std::optional<Time::time_point> reported;
    const auto progress = [&](double done, std::string_view) {
      const auto now = Time::now();
      if (!reported || now - *reported >= kProgressStep) {
        reported = now;
        run.report(done);
      }
      return run.is_wanted();
    };
    auto drawn = draw_plot(request, show, progress);
    return finished ? std::move(drawn) : std::move(finished);
  }

  Work latest_;  // declared last, so that its thread ends before the members it uses are destroyed
};

}  // namespace nazori::functions
