// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/mesh_file.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

#include "nazori/archive/zip.h"

namespace nazori::model {
namespace {

constexpr std::size_t kStlHeader = 80;
constexpr std::size_t kStlTriangle = 50;

void append_number(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void append_float(std::vector<std::uint8_t>& bytes, float value) {
  append_number(bytes, std::bit_cast<std::uint32_t>(value));
}

std::array<float, 3> normal_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  std::array<double, 3> u{};
  std::array<double, 3> v{};
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = static_cast<double>(mesh.vertices[t[1]][i]) - mesh.vertices[t[0]][i];
    v[i] = static_cast<double>(mesh.vertices[t[2]][i]) - mesh.vertices[t[0]][i];
  }
  const std::array<double, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
          static_cast<float>(n[2] / length)};
}

/// A length in millimetres with up to four decimals, which is a tenth of a micrometre.
void append_length(std::string& text, float mm) {
  long units = std::lround(static_cast<double>(mm) * 10000);
  if (units < 0) {
    text += '-';
    units = -units;
  }
  std::array<char, 24> digits{};
  const auto whole = std::to_chars(digits.data(), digits.data() + digits.size(), units / 10000);
  text.append(digits.data(), whole.ptr);
  long rest = units % 10000;
  if (rest == 0) return;
  text += '.';
  for (long place = 1000; rest != 0; place /= 10) {
    text += static_cast<char>('0' + rest / place);
    rest %= place;
  }
}

void append_index(std::string& text, std::uint32_t index) {
  std::array<char, 12> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), index);
  text.append(digits.data(), end.ptr);
}

std::string escaped(std::string_view name) {
  std::string text;
  for (const char c : name) {
    if (c == '&') {
      text += "&amp;";
    } else if (c == '<') {
      text += "&lt;";
    } else if (c == '"') {
      text += "&quot;";
    } else if (static_cast<unsigned char>(c) >= 0x20) {
      text += c;
    }
  }
  return text;
}

std::string model_xml(const Mesh& mesh, const std::string& name) {
  std::string xml;
  xml.reserve(mesh.triangles.size() * 70);
  xml += R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">Nazori</metadata>
<resources><object id="1" type="model" name=")";
  xml += escaped(name);
  xml += "\"><mesh><vertices>\n";
  for (const auto& v : mesh.vertices) {
    xml += "<vertex x=\"";
    append_length(xml, v[0]);
    xml += "\" y=\"";
    append_length(xml, v[1]);
    xml += "\" z=\"";
    append_length(xml, v[2]);
    xml += "\"/>\n";
  }
  xml += "</vertices><triangles>\n";
  for (const auto& t : mesh.triangles) {
    xml += "<triangle v1=\"";
    append_index(xml, t[0]);
    xml += "\" v2=\"";
    append_index(xml, t[1]);
    xml += "\" v3=\"";
    append_index(xml, t[2]);
    xml += "\"/>\n";
  }
  xml += "</triangles></mesh></object></resources>\n<build><item objectid=\"1\"/></build>\n</model>\n";
  return xml;
}

constexpr std::string_view kContentTypes = R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
constexpr std::string_view kRelations = R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="rel0" Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

}  // namespace

std::vector<std::uint8_t> to_stl(const Mesh& mesh) {
  // A header that begins with "solid" would be taken for the text form.
  constexpr std::string_view kHeader = "Nazori, binary STL, millimetres";
  std::vector<std::uint8_t> bytes;
  bytes.reserve(kStlHeader + 4 + kStlTriangle * mesh.triangles.size());
  bytes.assign(kHeader.begin(), kHeader.end());
  bytes.resize(kStlHeader, ' ');
  append_number(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    for (const float x : normal_of(mesh, t)) append_float(bytes, x);
    for (const std::uint32_t corner : t) {
      for (const float x : mesh.vertices[corner]) append_float(bytes, x);
    }
    bytes.insert(bytes.end(), {0, 0});
  }
  return bytes;
}

base::Result<std::vector<std::uint8_t>> to_3mf(const Mesh& mesh, const std::string& name) {
  constexpr int kFast = 3;
  archive::ZipWriter zip(kFast);
  zip.add("[Content_Types].xml", kContentTypes);
  zip.add("_rels/.rels", kRelations);
  zip.add("3D/3dmodel.model", model_xml(mesh, name));
  return zip.finish();
}

}  // namespace nazori::model
