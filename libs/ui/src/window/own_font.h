// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QObject>
#include <filesystem>
#include <map>
#include <set>

#include "nazori/base/latest.h"

namespace nazori::ui {

/// Lets every text show the learner's own characters: no font has them, so the program makes one and adds it
/// to its fonts, from which the system takes what a text's own font lacks. Screen readers get their names. A
/// second font has the forms that take the place of published ones (set_own_forms()).
/// Made on another thread. Thread: interface.
class OwnFont final : public QObject {
  Q_OBJECT
 public:
  /// @param folder  of the own characters. Empty: there are none, and nothing is ever made.
  OwnFont(base::Inbox& inbox, std::filesystem::path folder, QObject* parent);
  ~OwnFont() override;

  /// Makes the font again; `changed` follows.
  void refresh();

  /// What the other thread makes.
  struct Made {
    QByteArray font;   ///< empty: there is none
    QByteArray forms;  ///< those that take the place of published characters, by the published code points
    std::map<char32_t, QString> names;
    std::set<char32_t> replaced;
  };
  static constexpr const char* kFamily = "Nazori Own Characters";
  static constexpr const char* kFormsFamily = "Nazori Own Forms";

 signals:
  void changed();

 private:
  void use(const Made& made);

  std::filesystem::path folder_;
  int id_ = -1;
  int forms_id_ = -1;
  /// Declared last, so that its thread ends first.
  base::Latest<std::filesystem::path, Made> maker_;
};

}  // namespace nazori::ui
