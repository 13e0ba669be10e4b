// SPDX-License-Identifier: Apache-2.0
#include "study/list_choice.h"

#include <QSignalBlocker>
#include <algorithm>
#include <map>

#include "kanji_text.h"

namespace nazori::ui {

ListChoice::ListChoice(QWidget* parent) : QComboBox(parent) {
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(12);
  addItem(tr("Met so far"), QString());
}

QString ListChoice::name_of(const study::ReadyList& list) {
  const std::map<std::string, QString> names{{"secondary", tr("Secondary school")},
                                             {"jinmeiyou", tr("For names")},
                                             {"hiragana", tr("Hiragana")},
                                             {"katakana", tr("Katakana")}};
  if (const auto named = names.find(list.id); named != names.end()) return named->second;
  const QString id = to_text(list.id);
  const QString number = id.section(QLatin1Char('-'), -1);
  return id.startsWith(QLatin1String("old-jlpt")) ? tr("Old JLPT level %1 (before 2010)").arg(number)
                                                  : tr("Grade %1").arg(number);
}

void ListChoice::fill(const study::LearnerStore& store) {
  const QSignalBlocker quiet(this);
  const QString before = list();
  clear();
  addItem(tr("Met so far"), QString());
  for (const study::ReadyList& ready : study::ready_lists()) addItem(name_of(ready), to_text(ready.id));
  for (const study::CustomList& own : store.lists())
    addItem(to_text(own.name), QStringLiteral("list:") + to_text(own.name));
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
