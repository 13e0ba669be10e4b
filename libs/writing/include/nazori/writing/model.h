// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "nazori/base/result.h"
#include "nazori/kanji/character.h"

namespace nazori::writing {

struct ModelInside;

/// A character prepared for comparison with writing. Immutable, cheap to copy, safe to share among threads.
class Model {
 public:
  /// @param variants  other drawn forms of the same character; those whose strokes do not follow the order of
  ///   the main form are left out, because they are other orders or errors of the source.
  /// @return Errc::bad_argument for a character without strokes or with a stroke without points.
  [[nodiscard]] static base::Result<Model> make(const kanji::Character& main,
                                                std::span<const kanji::Character> variants = {});

  [[nodiscard]] char32_t code_point() const;
  [[nodiscard]] int stroke_count() const;
  [[nodiscard]] const ModelInside& inside() const { return *inside_; }

 private:
  explicit Model(std::shared_ptr<const ModelInside> inside);
  std::shared_ptr<const ModelInside> inside_;
};

}  // namespace nazori::writing
