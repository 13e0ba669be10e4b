// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/font_models.h"

#include <utility>

namespace nazori::author {

base::Background& FontModels::background() {
  if (!background_) background_ = std::make_shared<base::Background>("font models", inbox_);
  return *background_;
}

void FontModels::list() {
  base::Background& thread = background();
  thread.post([this, &thread] { thread.answer([this, fonts = installed_brush_fonts()] { listed(fonts); }); });
}

void FontModels::make(std::string family, std::vector<KnownCharacter> characters) {
  background();
  if (!work_)
    work_.emplace(
        background_,
        [](const Request& request, const Work::Run& run) {
          for (const KnownCharacter& one : request.characters) {
            if (!run.is_wanted()) return false;
            run.report(
                {request.family, one.character, font_model(one.character, one.strokes, request.family)});
          }
          return true;
        },
        [this](bool /*all*/) { finished(); }, [this](const MadeModel& model) { made(model); });
  work_->request({std::move(family), std::move(characters)});
}

void FontModels::cancel() {
  if (work_) work_->cancel();
}

}  // namespace nazori::author
