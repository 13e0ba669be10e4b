// SPDX-License-Identifier: Apache-2.0
#include "paper.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <sstream>

#include "nazori/base/utf8.h"
#include "nazori/geometry/polyline.h"
#include "test_paths.h"

namespace nazori::scan {
namespace {

/// The numbers of a text, whatever stands between them.
std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.c_str();
  while (*at != '\0') {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at) {
      ++at;
    } else {
      numbers.push_back(value);
      at = end;
    }
  }
  return numbers;
}

void add_stroke(Handwriting& strokes, const std::string& text) {
  const std::vector<double> numbers = numbers_of(text);
  auto& stroke = strokes.emplace_back();
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) stroke.push_back({numbers[i], numbers[i + 1]});
  if (stroke.empty()) strokes.pop_back();
}

/// "ア source  x,y x,y | x,y x,y"
WrittenSample sample_of(const std::string& line) {
  const std::size_t begin = line.find("  ");
  WrittenSample sample{base::decode_utf8(line.substr(0, line.find(' '))).value_or(U"?").front(), {}};
  std::istringstream in(line.substr(begin));
  for (std::string part; std::getline(in, part, '|');) add_stroke(sample.strokes, part);
  return sample;
}

/// {"char":"一",...,"strokes":[[[x,y],...],...]}
WrittenSample sample_of_json(const std::string& line) {
  const std::size_t name = line.find("\"char\":\"") + 8;
  WrittenSample sample{
      base::decode_utf8(line.substr(name, line.find('"', name) - name)).value_or(U"?").front(), {}};
  std::string rest = line.substr(line.find("\"strokes\":[[") + 12);
  for (std::size_t end = 0; (end = rest.find("]]")) != std::string::npos; rest = rest.substr(end + 2))
    add_stroke(sample.strokes, rest.substr(0, end));
  return sample;
}

}  // namespace

std::vector<WrittenSample> real_handwriting() {
  const char* other = std::getenv("NAZORI_SCAN_HANDWRITING");
  std::ifstream in(other != nullptr ? std::string(other)
                                    : std::string(test_paths::kFixtures) + "/handwriting.txt");
  EXPECT_TRUE(in);
  std::vector<WrittenSample> all;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) all.push_back(other != nullptr ? sample_of_json(line) : sample_of(line));
  return all;
}

Handwriting by_hand(const kanji::Character& character, std::mt19937& random, double unsteady) {
  std::normal_distribution<double> spread(0, 1);
  const auto normal = [&spread, unsteady](std::mt19937& chance) { return unsteady * spread(chance); };
  Handwriting strokes;
  const double turn = 0.03 * normal(random);
  const double scale = 0.92 + 0.04 * normal(random);
  const double shift_x = 0.02 * normal(random);
  const double shift_y = 0.02 * normal(random);
  for (const kanji::Stroke& stroke : character.strokes) {
    auto& line = strokes.emplace_back();
    const double dx = 0.012 * normal(random);
    const double dy = 0.012 * normal(random);
    const double wave = 0.008 * normal(random);
    const auto& points = stroke.line.points;
    const double length = geometry::arc_length(std::span<const geometry::GlyphPoint>(points));
    for (int k = 0; k <= 16; ++k) {
      const geometry::GlyphPoint p =
          geometry::point_at(std::span<const geometry::GlyphPoint>(points), length * k / 16);
      const double x = (p.x / geometry::kGlyphSide - 0.5) * scale;
      const double y = (p.y / geometry::kGlyphSide - 0.5) * scale;
      const double bend = wave * std::sin(k / 16.0 * std::numbers::pi);
      line.push_back({0.5 + x * std::cos(turn) - y * std::sin(turn) + shift_x + dx + bend,
                      0.5 + x * std::sin(turn) + y * std::cos(turn) + shift_y + dy + bend});
    }
  }
  return strokes;
}

const kanji::KanjiDatabase& database() {
  static const auto opened =
      kanji::KanjiDatabase::open(std::filesystem::path(std::getenv("NAZORI_DATA")) / "kanji.db");
  return *opened;
}

std::vector<print::SheetCharacter> sheet_characters(std::u32string_view text) {
  std::vector<print::SheetCharacter> all;
  for (const char32_t c : text) all.push_back({database().find(c).value(), database().words(c, 3)});
  return all;
}

PaperSheet::PaperSheet(const base::Result<std::string>& pdf, int page) {
  EXPECT_TRUE(pdf) << (pdf ? "" : base::to_line(pdf.error()));
  static int count = 0;
  const auto file = std::filesystem::temp_directory_path() /
                    ("nazori-scan-" + std::to_string(getpid()) + "-" + std::to_string(count++) + ".pdf");
  std::ofstream(file, std::ios::binary) << pdf.value_or("");
  const std::string number = std::to_string(page);
  const std::string command =
      "pdftoppm -gray -r 300 -f " + number + " -l " + number + " '" + file.string() + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
  int most = 0;
  if (std::fscanf(pipe.get(), "P5 %d %d %d", &width_, &height_, &most) != 3) {
    ADD_FAILURE() << "pdftoppm made no picture";
    width_ = height_ = 1;
  }
  std::fgetc(pipe.get());
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  EXPECT_EQ(std::fread(bytes.data(), 1, bytes.size(), pipe.get()), bytes.size());
  grey_.assign(bytes.begin(), bytes.end());
  std::filesystem::remove(file);
}

void PaperSheet::write(const print::MarkedBox& box, const Handwriting& strokes, double pen_mm,
                       double darkness) {
  const double radius = pen_mm / 2 * kDots;
  for (const auto& stroke : strokes) {
    for (std::size_t i = 0; i < stroke.size(); ++i) {
      const auto at = [&](std::size_t k) {
        return std::array<double, 2>{(box.corner.x + stroke[k][0] * box.side_mm) * kDots,
                                     (box.corner.y + stroke[k][1] * box.side_mm) * kDots};
      };
      const auto a = at(i);
      const auto b = at(std::min(i + 1, stroke.size() - 1));
      const double length2 = std::max(1e-9, std::pow(b[0] - a[0], 2) + std::pow(b[1] - a[1], 2));
      const int reach = static_cast<int>(radius) + 2;
      for (int y = static_cast<int>(std::min(a[1], b[1])) - reach;
           y <= static_cast<int>(std::max(a[1], b[1])) + reach; ++y)
        for (int x = static_cast<int>(std::min(a[0], b[0])) - reach;
             x <= static_cast<int>(std::max(a[0], b[0])) + reach; ++x) {
          if (x < 0 || y < 0 || x >= width_ || y >= height_) continue;
          const double t =
              std::clamp(((x - a[0]) * (b[0] - a[0]) + (y - a[1]) * (b[1] - a[1])) / length2, 0.0, 1.0);
          const double d = std::hypot(x - a[0] - t * (b[0] - a[0]), y - a[1] - t * (b[1] - a[1]));
          const double cover = std::clamp(radius + 0.5 - d, 0.0, 1.0);
          float& grey = grey_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                              static_cast<std::size_t>(x)];
          grey = std::min(grey, static_cast<float>(255 * (1 - cover * darkness)));
        }
    }
  }
}

void PaperSheet::cover(double x, double y, double width, double height, std::uint8_t grey) {
  for (int v = std::max(0, static_cast<int>(y * kDots));
       v < std::min(height_, static_cast<int>((y + height) * kDots)); ++v)
    for (int u = std::max(0, static_cast<int>(x * kDots));
         u < std::min(width_, static_cast<int>((x + width) * kDots)); ++u)
      grey_[static_cast<std::size_t>(v) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(u)] =
          grey;
}

Photo PaperSheet::photographed(const View& view, unsigned seed) const {
  constexpr double kTable_mm = 14;  // around the page
  const double scale = view.dpi / 25.4;
  const double turn = view.turn_deg * std::numbers::pi / 180;
  const std::array<std::array<double, 2>, 4> corners{
      {{0, 0}, {width_mm(), 0}, {width_mm(), height_mm()}, {0, height_mm()}}};
  std::array<print::PaperPoint, 4> seen;
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = corners[i][0] - width_mm() / 2;
    const double y = corners[i][1] - height_mm() / 2;
    const double far = 1 + view.tilt_x * x / width_mm() + view.tilt_y * y / height_mm();
    seen[i] = {(x * std::cos(turn) - y * std::sin(turn)) / far * scale,
               (x * std::sin(turn) + y * std::cos(turn)) / far * scale};
    left = std::min(left, seen[i].x);
    right = std::max(right, seen[i].x);
    top = std::min(top, seen[i].y);
    bottom = std::max(bottom, seen[i].y);
  }
  const double table = kTable_mm * scale;
  std::array<PhotoPoint, 4> page;
  for (std::size_t i = 0; i < 4; ++i) {
    seen[i] = {seen[i].x - left + table, seen[i].y - top + table};
    page[i] = {corners[i][0] * kDots, corners[i][1] * kDots};
  }
  const PageMap to_page = PageMap::through(seen, page);
  Photo photo;
  photo.width = static_cast<int>(right - left + 2 * table);
  photo.height = static_cast<int>(bottom - top + 2 * table);
  const auto w = static_cast<std::size_t>(photo.width);
  const auto h = static_cast<std::size_t>(photo.height);
  std::vector<float> bright(w * h);
  std::mt19937 random(seed);
  const double light_turn = static_cast<double>(random() % 360) * std::numbers::pi / 180;
  // A pixel of the photograph covers several of the page.
  const int parts = std::max(1, static_cast<int>(300 / view.dpi + 0.6));
  for (std::size_t y = 0; y < h; ++y)
    for (std::size_t x = 0; x < w; ++x) {
      float sum = 0;
      for (int v = 0; v < parts; ++v)
        for (int u = 0; u < parts; ++u) {
          PhotoPoint p = to_page.at({static_cast<double>(x) + (u + 0.5) / parts - 0.5,
                                     static_cast<double>(y) + (v + 0.5) / parts - 0.5});
          p.y -= view.curl_mm * kDots * std::sin(std::clamp(p.x / width_, 0.0, 1.0) * std::numbers::pi);
          const int column = static_cast<int>(std::floor(p.x));
          const int row = static_cast<int>(std::floor(p.y));
          const bool inside = column >= 0 && row >= 0 && column < width_ && row < height_;
          sum += inside ? grey_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                                static_cast<std::size_t>(column)]
                        : 95 + 12 * std::sin(static_cast<float>(x) / 40);
        }
      const double along = (static_cast<double>(x) / static_cast<double>(w) - 0.5) * std::cos(light_turn) +
                           (static_cast<double>(y) / static_cast<double>(h) - 0.5) * std::sin(light_turn);
      bright[y * w + x] =
          sum / static_cast<float>(parts * parts) * static_cast<float>(0.92 - view.light * (along + 0.5));
    }
  if (view.blur_px > 0) {
    const int reach = static_cast<int>(std::ceil(3 * view.blur_px));
    std::vector<float> weights;
    for (int k = -reach; k <= reach; ++k)
      weights.push_back(static_cast<float>(std::exp(-k * k / (2 * view.blur_px * view.blur_px))));
    const float all = [&] {
      float sum = 0;
      for (const float v : weights) sum += v;
      return sum;
    }();
    for (const bool down : {false, true}) {
      std::vector<float> blurred(w * h);
      for (std::size_t y = 0; y < h; ++y)
        for (std::size_t x = 0; x < w; ++x) {
          float sum = 0;
          for (int k = -reach; k <= reach; ++k) {
            const auto u = static_cast<std::size_t>(
                std::clamp(static_cast<int>(x) + (down ? 0 : k), 0, photo.width - 1));
            const auto v = static_cast<std::size_t>(
                std::clamp(static_cast<int>(y) + (down ? k : 0), 0, photo.height - 1));
            sum += bright[v * w + u] * weights[static_cast<std::size_t>(k + reach)];
          }
          blurred[y * w + x] = sum / all;
        }
      bright = std::move(blurred);
    }
  }
  std::normal_distribution<float> noise(0, 1);
  photo.grey.reserve(w * h);
  for (const float value : bright) {
    const float noisy = value + (view.noise > 0 ? static_cast<float>(view.noise) * noise(random) : 0);
    photo.grey.push_back(static_cast<std::uint8_t>(std::clamp(noisy, 0.0F, 255.0F)));
  }
  return photo;
}

}  // namespace nazori::scan
