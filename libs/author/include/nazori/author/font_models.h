// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nazori/author/font_model.h"
#include "nazori/base/executor.h"
#include "nazori/base/latest.h"
#include "nazori/base/signal.h"

namespace nazori::author {

/// A character whose strokes are known.
struct KnownCharacter {
  char32_t character = 0;
  std::vector<kanji::StrokeLine> strokes;
};

/// The model of a character in a font, or why there is none.
struct MadeModel {
  std::string family;
  char32_t character = 0;
  base::Result<FontStrokes> model;
};

/// Looks for brush fonts and makes models of them on another thread. Of several requests for models only the
/// newest goes on. Thread: the owner of the inbox.
class FontModels {
 public:
  /// @param inbox  outlives this. The thread starts with the first request.
  explicit FontModels(base::Inbox& inbox) : inbox_(inbox) {}

  /// Asks which brush fonts are installed: answered by `listed`.
  void list();
  /// Asks for models as of font_model(): each is answered by `made`, in their order.
  void make(std::string family, std::vector<KnownCharacter> characters);
  /// Drops what was asked of make().
  void cancel();
  /// Whether models were asked for that are not all made.
  [[nodiscard]] bool is_busy() const { return work_ && work_->is_busy(); }

  base::Signal<const std::vector<BrushFont>&> listed;
  base::Signal<const MadeModel&> made;
  base::Signal<> finished;  ///< after the last model of a request

 private:
  struct Request {
    std::string family;
    std::vector<KnownCharacter> characters;
  };
  using Work = base::Latest<Request, bool, MadeModel>;

  base::Background& background();

  base::Inbox& inbox_;
  std::optional<Work> work_;
  std::shared_ptr<base::Background> background_;  // declared last, so that its thread ends first
};

}  // namespace nazori::author
