// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/solid_maker.h"

#include <functional>
#include <utility>

#include "nazori/base/file.h"
#include "nazori/base/latest.h"
#include "nazori/practice/touch_plot.h"

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

base::Result<void> write_touch(const TouchRequest& request, const std::filesystem::path& path) {
  const TouchMachines& machines = request.machines;
  const auto file =
      request.plot ? plot_touch_file(request.kind, request.plot->request.plot, request.plot->picture,
                                     {request.settings.plate.side_mm, machines.paper, machines.embosser})
                   : touch_file(request.kind, request.tablets, request.settings, machines, request.subject);
  if (!file) return tl::unexpected(file.error());
  return base::write_file(path, file->content);
}

}  // namespace

struct SolidMaker::Inside {
  /// Writes on the other thread and tells how it went.
  void post(SolidMaker& maker, const std::filesystem::path& path,
            std::function<base::Result<void>()> write) const {
    background->post([&maker, &to = *background, path, write = std::move(write)] {
      const auto written = write();
      to.answer([&maker, path, written] {
        if (written)
          maker.saved(path);
        else
          maker.not_saved(path, written.error());
      });
    });
  }

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
  inside_->post(*this, path,
                [solid = std::move(solid), path, subject] { return save_solid(*solid, path, subject); });
}

void SolidMaker::save(TouchRequest request, const std::filesystem::path& path) {
  inside_->post(*this, path, [request = std::move(request), path] { return write_touch(request, path); });
}

}  // namespace nazori::practice
