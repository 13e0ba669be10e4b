// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/brush/tuft_form.h"
#include "nazori/haptics/soft_tip.h"

namespace nazori::brush {

/// Push of the paper on a tuft by depth and lean, with its energy, computed with the same spine as the
/// picture, without friction. In proportion between its values. Thread-safe: yes, immutable.
class ForceTable {
 public:
  static constexpr double kDepthStep = 0.01;    ///< between two depths [length of the hair]
  static constexpr double kDeepest = 0.6;       ///< [length of the hair]; deeper it pushes as there
  static constexpr double kLeanStep_rad = 0.1;  ///< between two leans
  static constexpr double kMostLean_rad = 1.1;  ///< the largest; more counts as this

  /// Computes the table; some milliseconds.
  explicit ForceTable(const TuftForm& form);

  /// Push [N], >= 0; 0 above the paper.
  [[nodiscard]] double push_n(double depth_m, double lean_rad) const noexcept;
  /// Energy of the bent tuft [J]: the integral of the push over the depth at this lean.
  [[nodiscard]] double stored_j(double depth_m, double lean_rad) const noexcept;
  [[nodiscard]] const TuftForm& form() const noexcept { return form_; }

 private:
  struct Between {
    std::size_t row;
    double part;
  };
  [[nodiscard]] static Between between(double lean_rad) noexcept;
  [[nodiscard]] static double at(const std::vector<double>& push, double depth) noexcept;
  [[nodiscard]] static double integral(const std::vector<double>& push, double depth) noexcept;

  TuftForm form_;
  std::vector<std::vector<double>> push_;  // by lean, then by depth [EI/L^2]
};

/// How strongly a brush is felt.
enum class Feel : std::uint8_t {
  true_force,    ///< as the brush pushes: 0.02 to 0.5 N, less than many devices need to move
  strengthened,  ///< kStrengthened times as much
};

/// What the force is multiplied by where it is strengthened, and the largest push then and otherwise [N].
inline constexpr double kStrengthened = 4;
inline constexpr double kMostStrengthened_n = 1.0;
inline constexpr double kMostTrue_n = 0.5;

/// The tip that a servo feels, for a holder that leans by `lean_rad` and a wetness of 0..1.
[[nodiscard]] haptics::SoftTip soft_tip(const ForceTable& table, double lean_rad, double wetness, Feel feel);

}  // namespace nazori::brush
