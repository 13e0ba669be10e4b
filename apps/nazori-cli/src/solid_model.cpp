// SPDX-License-Identifier: Apache-2.0
#include "solid_model.h"

#include <fmt/format.h>

#include "nazori/model/mesh.h"

namespace nazori::cli {

base::Result<exchange::SolidModel> save_model(const practice::SolidPlate& plate, const OutputPlace& place,
                                              const std::string& subject) {
  const auto solid = practice::solid_of(plate);
  if (!solid) return tl::unexpected(solid.error());
  if (auto saved = practice::save_solid(*solid, place.path(), subject); !saved)
    return tl::unexpected(std::move(saved.error()));
  exchange::SolidModel model;
  model.subject = subject;
  model.file = place.name();
  model.width_mm = solid->width_mm;
  model.height_mm = solid->height_mm;
  model.thickness_mm = solid->thickness_mm;
  model.volume_mm3 = model::volume_mm3(solid->mesh);
  model.triangles = solid->mesh.triangles.size();
  model.error_mm = solid->error_mm;
  model.without_number = solid->without_number;
  return model;
}

std::string model_text(const exchange::SolidModel& made) {
  const std::string text =
      fmt::format("{}  {}  {:.4g} x {:.4g} x {:.4g} mm, {} triangles within {:.3f} mm\n", made.subject,
                  made.file, made.width_mm, made.height_mm, made.thickness_mm, made.triangles, made.error_mm);
  return text + without_number_text(made.without_number);
}

std::string without_number_text(const std::vector<int>& without_number) {
  if (without_number.empty()) return {};
  std::string strokes;
  for (const int stroke : without_number) strokes += fmt::format("{}{}", strokes.empty() ? "" : ", ", stroke);
  return fmt::format("no room for the numbers of strokes {}: a larger --size-mm has more\n", strokes);
}

}  // namespace nazori::cli
