// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/mistake_kind.h"

namespace nazori::kanji {

std::string_view name_of(MistakeKind kind) {
  switch (kind) {
    case MistakeKind::order:
      return "order";
    case MistakeKind::reversed:
      return "reversed";
    case MistakeKind::missing:
      return "missing";
    case MistakeKind::extra:
      return "extra";
    case MistakeKind::joined:
      return "joined";
    case MistakeKind::split:
      return "split";
    case MistakeKind::wrong:
      return "wrong";
    case MistakeKind::other:
      return "other";
    case MistakeKind::ending:
      return "ending";
  }
  return {};
}

std::optional<MistakeKind> mistake_named(std::string_view name) {
  // The kinds are numbered from 0 without gaps.
  for (std::uint8_t number = 0;; ++number) {
    const auto kind = static_cast<MistakeKind>(number);
    if (name_of(kind).empty()) return std::nullopt;
    if (name_of(kind) == name) return kind;
  }
}

}  // namespace nazori::kanji
