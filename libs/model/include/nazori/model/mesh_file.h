// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/model/mesh.h"

namespace nazori::model {

/// Binary STL. The format has no unit; readers take the numbers as millimetres.
[[nodiscard]] std::vector<std::uint8_t> to_stl(const Mesh& mesh);

/// 3MF in millimetres, with one object. The same mesh and name always give the same bytes.
/// @param name  of the object, as a slicer shows it.
/// @return Errc::io where the archive cannot be made.
/// @source 3MF Core Specification 1.3.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> to_3mf(const Mesh& mesh, const std::string& name);

}  // namespace nazori::model
