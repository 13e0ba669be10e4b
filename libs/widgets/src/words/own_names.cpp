// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/own_names.h"

#include <QCoreApplication>
#include <utility>

#include "nazori/kanji/own_characters.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

struct OwnNameWords {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::OwnNames)
};

std::map<char32_t, QString>& own_names() {
  static std::map<char32_t, QString> names;
  return names;
}

}  // namespace

void set_own_names(std::map<char32_t, QString> names) { own_names() = std::move(names); }

QString spoken_text(const QString& text) {
  QString spoken;
  for (const char32_t c : text.toStdU32String()) {
    if (!kanji::is_own(c)) {
      spoken += to_text(c);
      continue;
    }
    const auto known = own_names().find(c);
    spoken += known == own_names().end() || known->second.isEmpty()
                  ? OwnNameWords::tr("own character")
                  : OwnNameWords::tr("“%1”").arg(known->second);
  }
  return spoken;
}

}  // namespace nazori::ui
