// SPDX-License-Identifier: Apache-2.0
#include "study/list_choice.h"

#include <QSignalBlocker>
#include <algorithm>

#include "kanji_text.h"

namespace nazori::ui {

ListChoice::ListChoice(QWidget* parent) : QComboBox(parent) {
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(20);
  addItem(tr("Met so far"), QString());
}

QString ListChoice::name_of(const QString& id) {
  if (id.startsWith(QLatin1String("grade-"))) return tr("School grade %1").arg(id.mid(6));
  if (id == QLatin1String("secondary")) return tr("Secondary school");
  if (id == QLatin1String("jinmeiyou")) return tr("For names");
  if (id == QLatin1String("hiragana")) return tr("Hiragana");
  if (id == QLatin1String("katakana")) return tr("Katakana");
  if (id.startsWith(QLatin1String("old-jlpt-"))) return tr("Old JLPT level %1 (before 2010)").arg(id.mid(9));
  if (id.startsWith(QLatin1String("list:"))) return tr("Own list: %1").arg(id.mid(5));
  if (id.startsWith(QLatin1String("tag:"))) return tr("Tag: %1").arg(id.mid(4));
  return id;
}

void ListChoice::fill(const study::LearnerStore& store) {
  const QSignalBlocker quiet(this);
  const QString before = list();
  clear();
  addItem(tr("Met so far"), QString());
  const auto add = [this](const QString& id) { addItem(name_of(id), id); };
  for (const study::ReadyList& ready : study::ready_lists()) add(to_text(ready.id));
  for (const study::CustomList& own : store.lists()) add(QStringLiteral("list:") + to_text(own.name));
  for (const auto& [tag, characters] : store.tags()) add(QStringLiteral("tag:") + to_text(tag));
  set_list(before);
}

void ListChoice::set_list(const QString& id) { setCurrentIndex(std::max(0, findData(id))); }

std::vector<char32_t> ListChoice::members(const QString& id, study::CharacterLists* lists,
                                          const study::LearnerStore& store) {
  if (lists != nullptr && !id.isEmpty())
    if (auto members = lists->members(id.toStdString(), store)) return *std::move(members);
  std::vector<char32_t> met;
  for (const auto& [character, card] : store.cards()) met.push_back(character);
  return met;
}

}  // namespace nazori::ui
