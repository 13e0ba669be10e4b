// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QObject>
#include <filesystem>
#include <map>

#include "nazori/base/latest.h"

namespace nazori::ui {

/// Lets every text show the learner's own characters: no font has them, so the program makes one and adds it
/// to its fonts, from which the system takes what a text's own font lacks. Screen readers get their names.
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
    QByteArray font;  ///< empty: there is none
    std::map<char32_t, QString> names;
  };
  static constexpr const char* kFamily = "Nazori Own Characters";

 signals:
  void changed();

 private:
  void use(const Made& made);

  std::filesystem::path folder_;
  int id_ = -1;
  /// Declared last, so that its thread ends first.
  base::Latest<std::filesystem::path, Made> maker_;
};

}  // namespace nazori::ui
