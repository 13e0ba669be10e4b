// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace nazori::kanji {

/// What can be wrong with a written stroke. Saved by name and number: learner.db and exported files hold the
/// names of name_of().
enum class MistakeKind : std::uint8_t {
  order,     ///< right strokes in an order that is neither the model's nor a listed alternative
  reversed,  ///< a stroke drawn from its end to its start
  missing,   ///< a stroke of the model was not drawn
  extra,     ///< a stroke that the model does not have
  joined,    ///< two strokes of the model in one, without lifting the pen
  split,     ///< one stroke of the model in two
  wrong,     ///< another shape, size or position than the stroke of the model
  other,     ///< the strokes are those of another character: 土 for 士
  ending,    ///< a hook is missing, or there is one where the stroke stops
};

/// "order", "reversed", ...; empty for a number without a kind.
[[nodiscard]] std::string_view name_of(MistakeKind kind);
/// The kind with this name; nullopt for other text.
[[nodiscard]] std::optional<MistakeKind> mistake_named(std::string_view name);

}  // namespace nazori::kanji
