// SPDX-License-Identifier: Apache-2.0
#include "solid_model.h"

#include <fmt/format.h>

#include "nazori/base/file.h"
#include "nazori/model/mesh.h"
#include "nazori/model/mesh_file.h"
#include "options.h"

namespace nazori::cli {

base::Result<exchange::SolidModel> save_model(const model::Plate& plate, const OutputPlace& place,
                                              const std::string& subject, double tolerance_mm) {
  model::MeshSettings settings;
  settings.tolerance_mm = tolerance_mm;
  const auto made = model::mesh_of(plate, settings);
  if (!made) return tl::unexpected(made.error());
  std::vector<std::uint8_t> bytes;
  if (has_extension(place.path(), ".3mf")) {
    auto packed = model::to_3mf(made->mesh, subject);
    if (!packed) return tl::unexpected(std::move(packed.error()));
    bytes = *std::move(packed);
  } else {
    bytes = model::to_stl(made->mesh);
  }
  if (auto saved = base::write_file(place.path(), bytes); !saved)
    return tl::unexpected(std::move(saved.error()));
  float highest = 0;
  for (const float height : plate.heights()) highest = std::max(highest, height);
  exchange::SolidModel model;
  model.subject = subject;
  model.file = place.name();
  model.width_mm = plate.width_mm();
  model.height_mm = plate.height_mm();
  model.thickness_mm = highest;
  model.volume_mm3 = model::volume_mm3(made->mesh);
  model.triangles = made->mesh.triangles.size();
  model.error_mm = made->error_mm;
  return model;
}

std::string model_text(const exchange::SolidModel& made) {
  std::string text =
      fmt::format("{}  {}  {:.4g} x {:.4g} x {:.4g} mm, {} triangles within {:.3f} mm\n", made.subject,
                  made.file, made.width_mm, made.height_mm, made.thickness_mm, made.triangles, made.error_mm);
  if (made.without_number.empty()) return text;
  std::string strokes;
  for (const int stroke : made.without_number)
    strokes += fmt::format("{}{}", strokes.empty() ? "" : ", ", stroke);
  return text + fmt::format("no room for the numbers of strokes {}: a larger --size-mm has more\n", strokes);
}

}  // namespace nazori::cli
