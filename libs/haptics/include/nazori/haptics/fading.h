// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nazori::haptics {

/// How much help (Guiding::strength) a learner gets the next time, from the help and the error of this time:
/// f x help + g x error, held to 0..1. With f < 1 help vanishes as the error does; whoever errs by e for long
/// ends at g e / (1 - f). One number is kept for each character.
///
/// @param help   of this time, 0..1.
/// @param error  of this time, 0 none .. 1 as bad as is looked at; its sign is ignored. Not finite: 0.
/// @param f,g    how much of the help stays, and what error adds; 0..1.
/// @source G[n+1] = f G[n] + g |e[n]|: J. Emken, R. Benitez, D. Reinkensmeyer, Human-robot cooperative
/// movement training, J. NeuroEngineering and Rehabilitation 4:8, 2007; L. Marchal-Crespo, D. Reinkensmeyer,
/// Haptic guidance can enhance motor learning of a steering task, J. Motor Behavior 40(6), 2008. Thread-safe:
/// yes.
[[nodiscard]] double next_help(double help, double error, double f = 0.85, double g = 0.3) noexcept;

}  // namespace nazori::haptics
