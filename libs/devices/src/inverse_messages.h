// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "nazori/haptics/haptic_device.h"

namespace nazori::devices::inverse {

/// Both spellings of a force in a command: documentation from 3.5 on says "vector", older programs send
/// "values".
enum class ForceKey : std::uint8_t { vector, values };

/// How a version of the service is spoken to.
struct Dialect {
  ForceKey key = ForceKey::vector;
  bool knows_presets = true;  ///< from 3.5 on; before, the origin is always the base of the arm
};

/// The arms that the service drives, by "type" in their configuration.
enum class ArmType : std::uint8_t { inverse3, inverse3x, minverse };

/// A word of at most kMost printable ASCII characters. Longer or other ones are empty.
class ShortText {
 public:
  static constexpr std::size_t kMost = 47;
  void set(std::string_view text) noexcept;
  [[nodiscard]] std::string_view view() const noexcept { return {text_.data(), size_}; }
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }

 private:
  std::array<char, kMost> text_{};
  std::size_t size_ = 0;
};

/// What one message says of one arm. Metres and newtons in the service's frame: x right, y forward, z up.
/// What the message does not say is empty; nothing is obligatory.
struct ArmState {
  ShortText device_id;
  std::optional<haptics::Vec3> position_m;
  std::optional<haptics::Vec3> force_n;  ///< what the arm says it pushes with
  std::optional<bool> calibrated, ready;
  // Only the inventory, the first message of a connection, has these.
  std::optional<ArmType> type;
  bool left_handed = false;
  bool has_preset = false;  ///< its configuration names one, so the service knows presets
};

/// A message of the service. Holds no memory of its own, so that one can be read at the servo's rate.
struct ServiceState {
  static constexpr std::size_t kMostArms = 8;

  /// The arm of that id, or the first where `device_id` is empty; null where there is none.
  [[nodiscard]] const ArmState* find(std::string_view device_id) const noexcept;

  std::array<ArmState, kMostArms> arms;
  std::size_t arm_count = 0;
  std::uint32_t buttons = 0;  ///< of all grips, in the order of their names
};

/// Reads a message into `state`. Never allocates. @return false where it is not a JSON object with lists of
/// devices; `state` is then invalid. Arms beyond kMostArms, and ids that are not a ShortText, are left out.
[[nodiscard]] bool read_state(std::string_view message, ServiceState& state) noexcept;

/// The protocol variant of the service, from its answer to GET /version; nothing if the answer does not say.
[[nodiscard]] std::optional<Dialect> dialect_for_version(std::string_view answer);

/// The first message of a session: profile, where the origin is, and no force.
[[nodiscard]] std::string first_message(std::string_view device_id, const Dialect& dialect,
                                        std::optional<double> force_gate_gain);

/// Messages of one tick: the force, in the service's frame.
class TickMessage {
 public:
  /// Allocates.
  TickMessage(std::string_view device_id, ForceKey key);
  /// Never allocates. The text is valid until the next call. @param force_n  finite; what is not counts as 0.
  [[nodiscard]] std::string_view write(const haptics::Vec3& force_n) noexcept;

 private:
  std::string text_;
  std::size_t begin_;  ///< of the numbers
};

}  // namespace nazori::devices::inverse
