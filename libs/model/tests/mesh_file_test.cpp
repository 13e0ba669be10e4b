// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/mesh_file.h"

#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <regex>

#include "nazori/model/stand.h"
#include "test_plates.h"

namespace nazori::model {
namespace {

using testing::HasSubstr;

Mesh relief() {
  Plate plate = Plate::create(40, 40, 0.25, 5).value();
  plate.sink(hills(129), {4, 4}, 26, 3);
  EXPECT_TRUE(plate.add_hole({{20, 35}, 2}));
  return mesh_of(plate).value().mesh;
}

float float_at(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) bits |= static_cast<std::uint32_t>(bytes[at + i]) << (8 * i);
  return std::bit_cast<float>(bits);
}

std::map<std::string, std::string> unpacked(const std::vector<std::uint8_t>& bytes) {
  std::map<std::string, std::string> files;
  const std::unique_ptr<archive, decltype(&archive_read_free)> zip(archive_read_new(), &archive_read_free);
  archive_read_support_format_zip(zip.get());
  EXPECT_EQ(archive_read_open_memory(zip.get(), bytes.data(), bytes.size()), ARCHIVE_OK);
  archive_entry* entry = nullptr;
  while (archive_read_next_header(zip.get(), &entry) == ARCHIVE_OK) {
    std::string& content = files[archive_entry_pathname(entry)];
    std::array<char, 4096> room{};
    for (la_ssize_t n = 0; (n = archive_read_data(zip.get(), room.data(), room.size())) > 0;)
      content.append(room.data(), static_cast<std::size_t>(n));
  }
  return files;
}

TEST(Stl, IsAHeaderACountAndFiftyBytesATriangle) {
  const Mesh mesh = mesh_of(Plate::create(30, 20, 0.5, 4).value()).value().mesh;
  const auto bytes = to_stl(mesh);
  ASSERT_EQ(bytes.size(), 84 + 50 * mesh.triangles.size());
  EXPECT_NE(std::string(bytes.begin(), bytes.begin() + 5), "solid");
  EXPECT_EQ(bytes[80], mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    double length = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const float n = float_at(bytes, 84 + 50 * t + 4 * i);
      length += n * n;
      for (std::size_t corner = 0; corner < 3; ++corner)
        EXPECT_EQ(float_at(bytes, 84 + 50 * t + 12 + 12 * corner + 4 * i),
                  mesh.vertices[mesh.triangles[t][corner]][i]);
    }
    EXPECT_NEAR(length, 1, 1e-6);
  }
  // The first triangle belongs to the upper face.
  EXPECT_EQ(float_at(bytes, 84 + 8), 1);
}

/// What admesh says of a mesh; a failure where it had to mend anything.
std::string checked_by_admesh(const Mesh& mesh) {
  const auto file = std::filesystem::temp_directory_path() / ("nazori-" + std::to_string(getpid()) + ".stl");
  {
    const auto bytes = to_stl(mesh);
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  std::string answer;
  const std::unique_ptr<FILE, int (*)(FILE*)> admesh(
      popen(("admesh '" + file.string() + "' 2>&1").c_str(), "r"), &pclose);
  std::array<char, 512> room{};
  while (admesh && std::fgets(room.data(), static_cast<int>(room.size()), admesh.get()) != nullptr)
    answer += room.data();
  std::filesystem::remove(file);
  for (const char* fault : {"Facets with 1 disconnected edge", "Facets with 2 disconnected edges",
                            "Facets with 3 disconnected edges", "Total disconnected facets"})
    EXPECT_TRUE(std::regex_search(answer, std::regex(std::string(fault) + R"(\s*:\s*0\s+0)"))) << answer;
  for (const char* repair : {"Degenerate facets", "Edges fixed", "Facets removed", "Facets added",
                             "Facets reversed", "Backwards edges"})
    EXPECT_TRUE(std::regex_search(answer, std::regex(std::string(repair) + R"(\s*:\s*0\b)"))) << answer;
  return answer;
}

TEST(Stl, AdmeshFindsNothingToMend) {
  EXPECT_THAT(checked_by_admesh(relief()), HasSubstr("Number of parts       :     1"));
}

TEST(Stl, AdmeshFindsTwoFeetWithNothingToMend) {
  EXPECT_THAT(checked_by_admesh(stand_mesh().value()), HasSubstr("Number of parts       :     2"));
}

TEST(ThreeMf, IsInMillimetresAndHasTheMesh) {
  const Mesh mesh = relief();
  const auto bytes = to_3mf(mesh, "休 & <木>");
  ASSERT_TRUE(bytes);
  const auto files = unpacked(*bytes);
  ASSERT_EQ(files.size(), 3U);
  EXPECT_THAT(files.at("[Content_Types].xml"), HasSubstr("3dmanufacturing-3dmodel+xml"));
  EXPECT_THAT(files.at("_rels/.rels"), HasSubstr("Target=\"/3D/3dmodel.model\""));
  const std::string& xml = files.at("3D/3dmodel.model");
  EXPECT_THAT(xml, HasSubstr("unit=\"millimeter\""));
  EXPECT_THAT(xml, HasSubstr("name=\"休 &amp; &lt;木>\""));
  const std::regex vertex(R"re(<vertex x="([^"]*)" y="([^"]*)" z="([^"]*)"/>)re");
  const std::regex triangle(R"re(<triangle v1="(\d+)" v2="(\d+)" v3="(\d+)"/>)re");
  Mesh read;
  for (std::sregex_iterator i(xml.begin(), xml.end(), vertex), end; i != end; ++i)
    read.vertices.push_back({std::stof((*i)[1]), std::stof((*i)[2]), std::stof((*i)[3])});
  for (std::sregex_iterator i(xml.begin(), xml.end(), triangle), end; i != end; ++i)
    read.triangles.push_back({static_cast<std::uint32_t>(std::stoul((*i)[1])),
                              static_cast<std::uint32_t>(std::stoul((*i)[2])),
                              static_cast<std::uint32_t>(std::stoul((*i)[3]))});
  EXPECT_EQ(read.triangles, mesh.triangles);
  ASSERT_EQ(read.vertices.size(), mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(read.vertices[i][k], mesh.vertices[i][k], 6e-5);
}

TEST(ThreeMf, TheBytesDependNeitherOnTheClockNorOnThePlace) {
  const Mesh mesh = relief();
  const char* const before = std::getenv("TZ");
  const std::string kept = before != nullptr ? before : "";
  setenv("TZ", "Asia/Tokyo", 1);
  tzset();
  const auto tokyo = to_3mf(mesh, "a").value();
  setenv("TZ", "America/New_York", 1);
  tzset();
  const auto new_york = to_3mf(mesh, "a").value();
  if (before != nullptr) {
    setenv("TZ", kept.c_str(), 1);
  } else {
    unsetenv("TZ");
  }
  tzset();
  EXPECT_EQ(tokyo, new_york);
  EXPECT_EQ(to_stl(mesh), to_stl(relief()));
}

}  // namespace
}  // namespace nazori::model
