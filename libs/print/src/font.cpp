// SPDX-License-Identifier: Apache-2.0
#include "font.h"

#include <fontconfig/fontconfig.h>
#include <hb-ot.h>
#include <hb-subset.h>
#include <hb.h>

#include <algorithm>
#include <array>
#include <utility>

namespace nazori::print {
namespace {

/// Radicals look like characters and share their glyphs, but nobody searches for them.
bool is_radical(char32_t c) { return c >= 0x2E80 && c <= 0x2FDF; }

std::string file_of(const std::string& family) {
  // Loaded once. The configuration that fontconfig shares with other libraries is never released.
  static const std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)> config(FcInitLoadConfigAndFonts(),
                                                                            &FcConfigDestroy);
  const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> pattern(FcPatternCreate(), &FcPatternDestroy);
  FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
  FcPatternAddInteger(pattern.get(), FC_WEIGHT, FC_WEIGHT_REGULAR);
  FcConfigSubstitute(config.get(), pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult result = FcResultNoMatch;
  const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> match(
      FcFontMatch(config.get(), pattern.get(), &result), &FcPatternDestroy);
  FcChar8* file = nullptr;
  if (!match || FcPatternGetString(match.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
  // fontconfig always answers with some font: only one of this family will do.
  FcChar8* found = nullptr;
  for (int i = 0; FcPatternGetString(match.get(), FC_FAMILY, i, &found) == FcResultMatch; ++i) {
    if (family == reinterpret_cast<const char*>(found)) return reinterpret_cast<const char*>(file);
  }
  return {};
}

/// Receives the shape of a glyph from HarfBuzz.
struct OutlinePen {
  std::vector<PathStep> steps;
  double units = 1000;

  [[nodiscard]] PaperPoint at(float x, float y) const {
    return {static_cast<double>(x) / units, static_cast<double>(y) / units};
  }

  static OutlinePen& of(void* data) { return *static_cast<OutlinePen*>(data); }
  static void move(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) {
    of(data).steps.push_back({PathStep::Kind::move, {of(data).at(x, y)}});
  }
  static void line(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) {
    of(data).steps.push_back({PathStep::Kind::line, {of(data).at(x, y)}});
  }
  /// TrueType curves have one control point; a font with other curves is not opened.
  static void quadratic(hb_draw_funcs_t*, void* data, hb_draw_state_t* state, float cx, float cy, float x,
                        float y, void*) {
    const OutlinePen& pen = of(data);
    const PaperPoint from = pen.at(state->current_x, state->current_y);
    const PaperPoint control = pen.at(cx, cy);
    const PaperPoint to = pen.at(x, y);
    of(data).steps.push_back(
        {PathStep::Kind::curve, {from + (control - from) * (2.0 / 3), to + (control - to) * (2.0 / 3), to}});
  }
  static void close(hb_draw_funcs_t*, void* data, hb_draw_state_t*, void*) {
    of(data).steps.push_back({PathStep::Kind::close, {}});
  }
};

std::unique_ptr<hb_draw_funcs_t, decltype(&hb_draw_funcs_destroy)> outline_functions() {
  std::unique_ptr<hb_draw_funcs_t, decltype(&hb_draw_funcs_destroy)> made(hb_draw_funcs_create(),
                                                                          &hb_draw_funcs_destroy);
  hb_draw_funcs_set_move_to_func(made.get(), &OutlinePen::move, nullptr, nullptr);
  hb_draw_funcs_set_line_to_func(made.get(), &OutlinePen::line, nullptr, nullptr);
  hb_draw_funcs_set_quadratic_to_func(made.get(), &OutlinePen::quadratic, nullptr, nullptr);
  hb_draw_funcs_set_close_path_func(made.get(), &OutlinePen::close, nullptr, nullptr);
  return made;
}

}  // namespace

void Font::DestroyFace::operator()(hb_face_t* face) const { hb_face_destroy(face); }
void Font::DestroyFont::operator()(hb_font_t* font) const { hb_font_destroy(font); }

base::Result<Font> Font::installed(const std::string& family, const std::string& package) {
  const auto missing = [&](const char* what) {
    return base::fail(base::Errc::not_found, what, "font " + family, "install the package " + package);
  };
  const std::string file = file_of(family);
  if (file.empty()) return missing("is not installed");
  hb_blob_t* const blob = hb_blob_create_from_file_or_fail(file.c_str());
  if (blob == nullptr) return missing("cannot be read");
  Font font;
  font.face_.reset(hb_face_create(blob, 0));
  hb_blob_destroy(blob);
  hb_blob_t* const outlines = hb_face_reference_table(font.face_.get(), HB_TAG('g', 'l', 'y', 'f'));
  const bool has_outlines = hb_blob_get_length(outlines) > 0;
  hb_blob_destroy(outlines);
  if (!has_outlines) return missing("has no TrueType outlines");
  font.font_.reset(hb_font_create(font.face_.get()));
  font.units_ = hb_face_get_upem(font.face_.get());
  hb_font_extents_t extents{};
  if (hb_font_get_h_extents(font.font_.get(), &extents) != 0) {
    font.ascent_ = extents.ascender / font.units_;
    font.descent_ = extents.descender / font.units_;
  }
  for (const char c : family) {
    if (c != ' ') font.name_ += c;
  }
  return font;
}

GlyphId Font::glyph(char32_t code_point, bool vertical) {
  if (vertical) {
    const auto known = vertical_.find(code_point);
    if (known != vertical_.end()) return known->second;
    const std::unique_ptr<hb_buffer_t, decltype(&hb_buffer_destroy)> buffer(hb_buffer_create(),
                                                                            &hb_buffer_destroy);
    const auto code = static_cast<std::uint32_t>(code_point);
    hb_buffer_add_utf32(buffer.get(), &code, 1, 0, 1);
    hb_buffer_set_direction(buffer.get(), HB_DIRECTION_TTB);
    hb_buffer_set_script(buffer.get(), HB_SCRIPT_HAN);
    hb_shape(font_.get(), buffer.get(), nullptr, 0);
    unsigned count = 0;
    const hb_glyph_info_t* const info = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const GlyphId glyph = count == 1 ? info[0].codepoint : 0;
    vertical_[code_point] = glyph;
    return glyph;
  }
  hb_codepoint_t glyph = 0;
  return hb_font_get_nominal_glyph(font_.get(), code_point, &glyph) != 0 ? glyph : 0;
}

void Font::use(GlyphId glyph, char32_t code_point) {
  const auto [at, is_new] = used_.emplace(glyph, code_point);
  if (!is_new && is_radical(at->second)) at->second = code_point;
}

double Font::advance(GlyphId glyph) const { return hb_font_get_glyph_h_advance(font_.get(), glyph) / units_; }

const std::vector<PathStep>& Font::outline(GlyphId glyph) {
  const auto [at, is_new] = outlines_.try_emplace(glyph);
  if (!is_new) return at->second;
  OutlinePen pen;
  pen.units = units_;
  const auto functions = outline_functions();
#if HB_VERSION_ATLEAST(7, 0, 0)
  hb_font_draw_glyph(font_.get(), glyph, functions.get(), &pen);
#else
  hb_font_get_glyph_shape(font_.get(), glyph, functions.get(), &pen);
#endif
  at->second = std::move(pen.steps);
  return at->second;
}

std::string Font::subset() const {
  const std::unique_ptr<hb_subset_input_t, decltype(&hb_subset_input_destroy)> input(
      hb_subset_input_create_or_fail(), &hb_subset_input_destroy);
  hb_set_t* const glyphs = hb_subset_input_glyph_set(input.get());
  for (const auto& [glyph, code_point] : used_) hb_set_add(glyphs, glyph);
  hb_set_t* const dropped = hb_subset_input_set(input.get(), HB_SUBSET_SETS_DROP_TABLE_TAG);
  for (const char* tag : {"GSUB", "GPOS", "GDEF", "vhea", "vmtx", "name", "cmap", "post", "OS/2", "BASE",
                          "gasp", "meta", "STAT", "DSIG", "VORG"})
    hb_set_add(dropped, hb_tag_from_string(tag, -1));
  hb_subset_input_set_flags(input.get(), HB_SUBSET_FLAGS_RETAIN_GIDS | HB_SUBSET_FLAGS_NO_HINTING);
  const std::unique_ptr<hb_face_t, DestroyFace> small(hb_subset_or_fail(face_.get(), input.get()));
  if (!small) return {};
  hb_blob_t* const blob = hb_face_reference_blob(small.get());
  unsigned length = 0;
  const char* const bytes = hb_blob_get_data(blob, &length);
  std::string file(bytes, length);
  hb_blob_destroy(blob);
  return file;
}

}  // namespace nazori::print
