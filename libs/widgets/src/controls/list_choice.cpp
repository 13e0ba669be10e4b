// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/list_choice.h"

#include <QSignalBlocker>
#include <QStandardItemModel>
#include <algorithm>

#include "nazori/study/character_lists.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

ListChoice::ListChoice(QWidget* parent) : QComboBox(parent) {
  make_narrow(this, 20);
  addItem(tr("Studied so far"), QString());
}

QString ListChoice::name_of(const QString& id) {
  if (id.startsWith(QLatin1String("grade-"))) return tr("Grade %1").arg(id.mid(6));
  if (id == QLatin1String("secondary")) return tr("Secondary school");
  if (id == QLatin1String("jinmeiyou")) return tr("Kanji for names");
  if (id == QLatin1String("hiragana")) return tr("Hiragana");
  if (id == QLatin1String("katakana")) return tr("Katakana");
  if (id == QLatin1String("own")) return tr("My characters");
  if (id.startsWith(QLatin1String("old-jlpt-"))) return tr("Old JLPT level %1 (before 2010)").arg(id.mid(9));
  if (id.startsWith(QLatin1String("list:"))) return tr("My list: %1").arg(id.mid(5));
  if (id.startsWith(QLatin1String("tag:"))) return tr("Tag: %1").arg(id.mid(4));
  return id;
}

void ListChoice::fill(const study::LearnerStore& store) {
  const QSignalBlocker quiet(this);
  const QString before = list();
  clear();
  addItem(tr("Studied so far"), QString());
  const auto known = study::list_ids(store);
  for (const auto& id : known.ids) addItem(name_of(to_text(id)), to_text(id));
  if (known.unread) {
    addItem(tr("Your lists and tags cannot be read: %1").arg(reason(*known.unread)));
    if (auto* items = qobject_cast<QStandardItemModel*>(model())) items->item(count() - 1)->setEnabled(false);
  }
  set_list(before);
}

void ListChoice::set_list(const QString& id) { setCurrentIndex(std::max(0, findData(id))); }

}  // namespace nazori::ui
