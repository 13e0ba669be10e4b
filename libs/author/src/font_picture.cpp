// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/font_picture.h"

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>
#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace nazori::author {
namespace {

/// Loaded once. The configuration that fontconfig shares with other libraries is never released.
FcConfig* fonts_of_the_system() {
  static const std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)> config(FcInitLoadConfigAndFonts(),
                                                                            &FcConfigDestroy);
  return config.get();
}

struct FontFile {
  std::string family;
  std::string path;
  int face = 0;
  int weight = 0;  ///< as fontconfig counts it; 80 is regular
};

/// The fonts with outlines for a character; of one family only, where it is given.
std::vector<FontFile> font_files(char32_t character, const std::string* family) {
  const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> pattern(FcPatternCreate(), &FcPatternDestroy);
  const std::unique_ptr<FcCharSet, decltype(&FcCharSetDestroy)> wanted(FcCharSetCreate(), &FcCharSetDestroy);
  FcCharSetAddChar(wanted.get(), character);
  FcPatternAddCharSet(pattern.get(), FC_CHARSET, wanted.get());
  FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
  if (family != nullptr)
    FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family->c_str()));
  const std::unique_ptr<FcObjectSet, decltype(&FcObjectSetDestroy)> asked(
      FcObjectSetBuild(FC_FAMILY, FC_FILE, FC_INDEX, FC_WEIGHT, nullptr), &FcObjectSetDestroy);
  const std::unique_ptr<FcFontSet, decltype(&FcFontSetDestroy)> found(
      FcFontList(fonts_of_the_system(), pattern.get(), asked.get()), &FcFontSetDestroy);
  std::vector<FontFile> files;
  for (int i = 0; found && i < found->nfont; ++i) {
    FcPattern* const font = found->fonts[i];
    FcChar8* name = nullptr;
    FcChar8* file = nullptr;
    if (FcPatternGetString(font, FC_FAMILY, 0, &name) != FcResultMatch ||
        FcPatternGetString(font, FC_FILE, 0, &file) != FcResultMatch)
      continue;
    FontFile entry{reinterpret_cast<const char*>(name), reinterpret_cast<const char*>(file)};
    FcPatternGetInteger(font, FC_INDEX, 0, &entry.face);
    FcPatternGetInteger(font, FC_WEIGHT, 0, &entry.weight);
    files.push_back(std::move(entry));
  }
  return files;
}

}  // namespace

std::vector<std::string> font_families(char32_t character) {
  std::vector<std::string> families;
  for (FontFile& file : font_files(character, nullptr)) families.push_back(std::move(file.family));
  std::sort(families.begin(), families.end());
  families.erase(std::unique(families.begin(), families.end()), families.end());
  return families;
}

base::Result<scan::Photo> font_picture(char32_t character, const std::string& family, int side) {
  if (side < kLeastFontPicture || side > kMostFontPicture)
    return base::fail(base::Errc::bad_argument, fmt::format("{} is not a size of a picture", side), "size",
                      fmt::format("{} to {} pixels", kLeastFontPicture, kMostFontPicture));
  const auto files = font_files(character, &family);
  if (files.empty())
    return base::fail(base::Errc::not_found,
                      fmt::format("no installed font has U+{:04X}", static_cast<unsigned>(character)),
                      "font " + family);
  const auto file = std::min_element(files.begin(), files.end(), [](const FontFile& a, const FontFile& b) {
    return std::abs(a.weight - FC_WEIGHT_REGULAR) < std::abs(b.weight - FC_WEIGHT_REGULAR);
  });
  const auto damaged = [&] { return base::fail(base::Errc::parse, "the font cannot be read", file->path); };

  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) return damaged();
  const std::unique_ptr<FT_LibraryRec_, decltype(&FT_Done_FreeType)> library_end(library, &FT_Done_FreeType);
  FT_Face face = nullptr;
  // fontconfig numbers instances of variable fonts in the upper half of the index, as FreeType does.
  if (FT_New_Face(library, file->path.c_str(), file->face, &face) != 0) return damaged();
  const std::unique_ptr<FT_FaceRec_, decltype(&FT_Done_Face)> face_end(face, &FT_Done_Face);
  if (FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(side)) != 0 ||
      FT_Load_Char(face, character, FT_LOAD_NO_BITMAP | FT_LOAD_NO_HINTING) != 0 ||
      FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL) != 0)
    return damaged();

  scan::Photo picture{
      side, side,
      std::vector<std::uint8_t>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 255)};
  const double height = face->ascender - face->descender;
  const double ascent = height > 0 ? face->ascender / height : 0.88;
  const int base_line = static_cast<int>(std::lround(ascent * side));
  // 26.6 fixed point.
  const int indent =
      (side - static_cast<int>(std::lround(static_cast<double>(face->glyph->advance.x) / 64))) / 2;
  const FT_Bitmap& drawn = face->glyph->bitmap;
  for (int y = 0; y < static_cast<int>(drawn.rows); ++y) {
    const int row = base_line - face->glyph->bitmap_top + y;
    if (row < 0 || row >= side) continue;
    for (int x = 0; x < static_cast<int>(drawn.width); ++x) {
      const int column = indent + face->glyph->bitmap_left + x;
      if (column < 0 || column >= side) continue;
      picture.grey[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
                   static_cast<std::size_t>(column)] =
          static_cast<std::uint8_t>(255 - drawn.buffer[y * drawn.pitch + x]);
    }
  }
  return picture;
}

}  // namespace nazori::author
