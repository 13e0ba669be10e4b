// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/model_library.h"

#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/writing/lookalikes.h"

namespace nazori::writing {

base::Result<const ModelLibrary::Entry*> ModelLibrary::find(char32_t character) {
  if (const auto known = entries_.find(character); known != entries_.end()) return &known->second;
  const auto main = database_->find(character);
  if (!main && database_->trouble()) return tl::unexpected(*database_->trouble());
  if (!main || main->strokes.empty())
    return base::fail(base::Errc::not_found, "there are no strokes for this character in the database",
                      base::encode_utf8(character), "choose a character that has strokes");
  std::vector<kanji::Character> variants;
  for (const auto& name : main->variants)
    if (auto form = database_->find(character, name)) variants.push_back(std::move(*form));
  auto model = Model::make(*main, variants);
  if (!model) return tl::unexpected(model.error());
  Entry entry{std::move(*model), {}};
  for (const char32_t other : lookalikes_of(character)) {
    const auto found = database_->find(other);
    if (!found) continue;
    if (auto lookalike = Model::make(*found)) entry.lookalikes.push_back(std::move(*lookalike));
  }
  return &entries_.emplace(character, std::move(entry)).first->second;
}

}  // namespace nazori::writing
