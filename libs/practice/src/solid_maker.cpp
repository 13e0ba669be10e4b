// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/solid_maker.h"

#include <utility>

#include "nazori/base/latest.h"

namespace nazori::practice {
namespace {

base::Result<SolidView> view_of(const SolidRequest& request) {
  const SolidSettings& settings = request.settings;
  const auto plate = request.plot ? plot_plate(request.plot->request.plot, request.plot->picture,
                                               settings.plate.side_mm, settings.mould)
                                  : tablet_plate(request.tablets, settings);
  if (!plate) return tl::unexpected(plate.error());
  auto solid = solid_of(*plate);
  if (!solid) return tl::unexpected(std::move(solid.error()));
  SolidView view;
  view.picture = relief_picture(plate->plate, SolidMaker::kPictureSize);
  view.is_watertight = solid->is_watertight();
  view.solid = std::make_shared<const Solid>(*std::move(solid));
  return view;
}

}  // namespace

struct SolidMaker::Inside {
  Inside(SolidMaker& maker, base::Inbox& inbox)
      : background(std::make_shared<base::Background>("solids", inbox)),
        views(
            background, [](const SolidRequest& request, const auto&) { return view_of(request); },
            [&maker](const base::Result<SolidView>& view) {
              if (view)
                maker.shown(*view);
              else
                maker.refused(view.error());
            }) {}

  std::shared_ptr<base::Background> background;
  base::Latest<SolidRequest, base::Result<SolidView>> views;
};

SolidMaker::SolidMaker(base::Inbox& inbox) : inside_(std::make_unique<Inside>(*this, inbox)) {}

SolidMaker::~SolidMaker() = default;

void SolidMaker::show(SolidRequest request) { inside_->views.request(std::move(request)); }

void SolidMaker::save(std::shared_ptr<const Solid> solid, const std::filesystem::path& path,
                      const std::string& subject) {
  base::Background& background = *inside_->background;
  background.post([this, &background, solid = std::move(solid), path, subject] {
    const auto written = save_solid(*solid, path, subject);
    background.answer([this, path, written] {
      if (written)
        saved(path);
      else
        not_saved(path, written.error());
    });
  });
}

}  // namespace nazori::practice
