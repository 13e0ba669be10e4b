// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/print/page_drawing.h"

struct hb_face_t;
struct hb_font_t;

namespace nazori::print {

using GlyphId = std::uint32_t;

/// A TrueType font, and which of its glyphs a document uses. Thread rules: one thread.
class Font {
 public:
  /// The installed font of a family. @return Errc::not_found where there is none with outlines to embed.
  [[nodiscard]] static base::Result<Font> installed(const std::string& family, const std::string& package);

  /// The glyph of a code point, 0 where the font has none. @param vertical  its form in vertical text.
  [[nodiscard]] GlyphId glyph(char32_t code_point, bool vertical);
  /// Notes that a glyph is used for a code point, so that it is embedded and can be copied as text.
  void use(GlyphId glyph, char32_t code_point);
  /// Width in ems.
  [[nodiscard]] double advance(GlyphId glyph) const;
  /// The shape of a glyph in ems, y up. Valid as long as this font.
  [[nodiscard]] const std::vector<PathStep>& outline(GlyphId glyph);

  [[nodiscard]] const std::string& name() const { return name_; }  ///< as in PDF: "KleeOne"
  [[nodiscard]] const std::map<GlyphId, char32_t>& used() const { return used_; }
  [[nodiscard]] double ascent() const { return ascent_; }    ///< ems
  [[nodiscard]] double descent() const { return descent_; }  ///< ems, below 0
  /// The font file with nothing but the used glyphs, under their old numbers. Empty where HarfBuzz refuses.
  [[nodiscard]] std::string subset() const;

 private:
  struct DestroyFace {
    void operator()(hb_face_t* face) const;
  };
  struct DestroyFont {
    void operator()(hb_font_t* font) const;
  };
  Font() = default;

  std::string name_;
  std::unique_ptr<hb_face_t, DestroyFace> face_;
  std::unique_ptr<hb_font_t, DestroyFont> font_;
  double units_ = 1000;
  double ascent_ = 0.88;
  double descent_ = -0.12;
  std::map<GlyphId, char32_t> used_;
  std::map<char32_t, GlyphId> vertical_;
  std::map<GlyphId, std::vector<PathStep>> outlines_;
};

}  // namespace nazori::print
