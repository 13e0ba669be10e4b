// SPDX-License-Identifier: Apache-2.0
#include "window/own_font.h"

#include <QApplication>
#include <QFontDatabase>
#include <QWidget>
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
  for (author::KeptCharacter& kept : content->characters) {
    made.names.emplace(kept.code_point, to_text(kept.character.facts.name));
    glyphs.push_back({kept.code_point, std::move(kept.character.strokes), kept.character.facts.name});
  }
  if (const auto font = author::character_font(glyphs, OwnFont::kFamily))
    made.font = {reinterpret_cast<const char*>(font->data()), static_cast<qsizetype>(font->size())};
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
  if (id_ >= 0) QFontDatabase::removeApplicationFont(id_);
}

void OwnFont::refresh() {
  if (!folder_.empty()) maker_.request(folder_);
}

void OwnFont::use(const Made& made) {
  set_own_names(made.names);
  const QByteArray& font = made.font;
  if (font.isEmpty() && id_ < 0) return;
  if (id_ >= 0) QFontDatabase::removeApplicationFont(id_);
  id_ = font.isEmpty() ? -1 : QFontDatabase::addApplicationFontFromData(font);
  const auto widgets = QApplication::allWidgets();
  for (QWidget* widget : widgets) widget->update();
  emit changed();
}

}  // namespace nazori::ui
