// SPDX-License-Identifier: Apache-2.0
#include "window/own_font.h"

#include <QApplication>
#include <QFontDatabase>
#include <QWidget>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "nazori/author/character_font.h"
#include "nazori/author/collection.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/own_names.h"

namespace nazori::ui {
namespace {

/// Without a font where there are no own characters. What cannot be read is left out.
OwnFont::Made font_of(const std::filesystem::path& folder) {
  OwnFont::Made made;
  auto content = author::Collection(folder).read();
  if (!content || content->characters.empty()) return made;
  std::vector<author::FontGlyph> glyphs;
  std::vector<author::FontGlyph> forms;
  for (author::KeptCharacter& kept : content->characters) {
    made.names.emplace(kept.code_point, to_text(kept.character.facts.name));
    if (kept.instead_of) {
      made.replaced.insert(*kept.instead_of);
      forms.push_back({*kept.instead_of, kept.character.strokes, kept.character.facts.name});
    }
    glyphs.push_back({kept.code_point, std::move(kept.character.strokes), kept.character.facts.name});
  }
  const auto bytes_of = [](const std::vector<author::FontGlyph>& all, const char* family) {
    const auto font =
        all.empty() ? base::Result<std::vector<std::uint8_t>>() : author::character_font(all, family);
    return font
               ? QByteArray(reinterpret_cast<const char*>(font->data()), static_cast<qsizetype>(font->size()))
               : QByteArray();
  };
  made.font = bytes_of(glyphs, OwnFont::kFamily);
  made.forms = bytes_of(forms, OwnFont::kFormsFamily);
  return made;
}

}  // namespace

OwnFont::OwnFont(base::Inbox& inbox, std::filesystem::path folder, QObject* parent)
    : QObject(parent),
      folder_(std::move(folder)),
      maker_(
          "own font", inbox, [](const std::filesystem::path& from, const auto&) { return font_of(from); },
          [this](const Made& made) { use(made); }) {
  if (!folder_.empty()) refresh();
}

OwnFont::~OwnFont() {
  for (const int id : {id_, forms_id_})
    if (id >= 0) QFontDatabase::removeApplicationFont(id);
}

void OwnFont::refresh() {
  if (!folder_.empty()) maker_.request(folder_);
}

void OwnFont::use(const Made& made) {
  set_own_names(made.names);
  if (made.font.isEmpty() && id_ < 0) return;
  const auto replace = [](int& id, const QByteArray& font) {
    if (id >= 0) QFontDatabase::removeApplicationFont(id);
    id = font.isEmpty() ? -1 : QFontDatabase::addApplicationFontFromData(font);
  };
  replace(id_, made.font);
  replace(forms_id_, made.forms);
  set_own_forms(QString::fromLatin1(kFormsFamily), forms_id_ < 0 ? std::set<char32_t>() : made.replaced);
  const auto widgets = QApplication::allWidgets();
  for (QWidget* widget : widgets) widget->update();
  emit changed();
}

}  // namespace nazori::ui
