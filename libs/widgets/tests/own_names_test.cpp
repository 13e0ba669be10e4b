// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/own_names.h"

#include <gtest/gtest.h>

#include "nazori/kanji/own_characters.h"
#include "nazori/widgets/words/kanji_text.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

TEST(OwnNames, StandForTheLettersThatNoVoiceCanRead) {
  set_own_names({{kanji::kFirstOwn, QStringLiteral("our sign")}, {kanji::kLastOwn, QString()}});
  EXPECT_EQ(spoken_text(QStringLiteral("Write %1, then 休.").arg(to_text(kanji::kFirstOwn))),
            QStringLiteral("Write “our sign”, then 休."));
  EXPECT_EQ(spoken_text(to_text(kanji::kLastOwn)), QStringLiteral("own character"));
  EXPECT_EQ(spoken_text(to_text(kanji::kFirstOwn + 1)), QStringLiteral("own character"));
  EXPECT_EQ(spoken_text(QStringLiteral("𠆢 and 休")), QStringLiteral("𠆢 and 休"));
  set_own_names({});
  EXPECT_EQ(spoken_text(to_text(kanji::kFirstOwn)), QStringLiteral("own character"));
}

}  // namespace
}  // namespace nazori::ui
