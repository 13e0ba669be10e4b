// SPDX-License-Identifier: Apache-2.0
// The question above the tablet: the size and colour of each of its words, and its height.
#include <QAction>
#include <QSignalSpy>
#include <QTextDocument>

#include "chosen_session_under_test.h"
#include "described_widget.h"
#include "nazori/base/utf8.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/study_words.h"
#include "study/question_view.h"
#include "study/session_text_size.h"

namespace nazori::ui {
namespace {

class QuestionText : public ChosenSessionTest {
 protected:
  QuestionText() {
    install_language(QStringLiteral("en"));
    test::use_plain_look();
    window_.resize(1600, 40 * em());
  }
  static int em() { return QFontInfo(QApplication::font()).pixelSize(); }
  static double points() { return QFontInfo(QApplication::font()).pointSizeF(); }
  /// Words of this size, in multiples of other text.
  static QString span(double size, const QString& style, const char* words) {
    return QStringLiteral("<span style=\"font-size:%1pt; %2\">%3</span>")
        .arg(points() * size)
        .arg(style, QString::fromUtf8(words));
  }
  static QString ink(double size, const char* words) {
    return span(size, QStringLiteral("color:") + current_colours().ink.name(), words);
  }
  static QString muted(double size, const char* words) {
    return span(size, QStringLiteral("color:") + current_colours().muted.name(), words);
  }
  static QString in_hand(double size, const char* words) {
    return span(size, QStringLiteral("font-family:'Klee One'"), words);
  }
  QString asked(const std::shared_ptr<const practice::CharacterSheet>& sheet) {
    test::resize_unseen(view_, {1600, 100});
    view_.show_state(sheet, {});
    return view_.findChild<QLabel*>(QStringLiteral("session_question"))->text();
  }
  /// The sizes of the words, in multiples of other text.
  static std::vector<double> sizes(const QString& text) {
    static const QRegularExpression size(QStringLiteral("font-size:([0-9.]+)pt"));
    std::vector<double> all;
    for (auto match = size.globalMatch(text); match.hasNext();)
      all.push_back(match.next().captured(1).toDouble() / points());
    return all;
  }
  void set_room(int em_high) {
    window_.resize(1600, em_high * em());
    view_.refresh();
  }
  const QString gap_ = QStringLiteral(" &nbsp; ");
  QWidget window_;
  QAction show_{QStringLiteral("Show"), &window_};
  QuestionView view_{*session_, &show_, &window_};
};

TEST_F(QuestionText, MeaningsAreLargeAndReadingsInTheHandBelow) {
  know(U'八');
  learn_from({});
  ASSERT_TRUE(session_->start());
  auto sheet = bare_sheet();
  sheet->character.entry.meanings = {{"en", "a < b"}, {"en", "c"}};
  EXPECT_EQ(asked(sheet), ink(1.8, "a &lt; b, c"));
  sheet->character.entry.on_readings = {"ハチ"};
  sheet->character.entry.kun_readings = {"や.つ"};
  const QString both = asked(sheet);
  const auto all = sizes(both);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NEAR(all[0] / all[1], 1.8 / 1.4, 0.01);
  EXPECT_EQ(both, ink(all[0], "a &lt; b, c") + QStringLiteral("<br>") + in_hand(all[1], "ハチ、や・つ"));
  sheet->character.entry.meanings.clear();
  EXPECT_EQ(asked(sheet).section(QStringLiteral("<br>"), 1), in_hand(1.4, "ハチ、や・つ"));
  sheet->character.entry = {};
  EXPECT_EQ(asked(sheet), ink(1.4, "a character with 2 strokes"));
}

TEST_F(QuestionText, InALessonTheCharacterStandsBeforeAndWhatLooksLikeItBelow) {
  learn_from({U'シ'});
  ASSERT_TRUE(session_->start());
  const QString text = asked(bare_sheet());
  const auto all = sizes(text);
  ASSERT_GE(all.size(), 5U);
  EXPECT_NEAR(all[0], all[1], 1e-6);
  EXPECT_NEAR(all[0] / all[3], 1.8 / 1.4, 0.01);
  const QString first = in_hand(all[0], "シ") + gap_ + ink(all[1], "katakana: shi") + QStringLiteral("<br>") +
                        muted(all[2], "looks like") + gap_;
  EXPECT_TRUE(text.startsWith(first)) << text.toStdString();
  const auto similar = kanji::similar_kana(U'シ');
  const auto shown = std::min<std::size_t>(3, similar.size());
  EXPECT_EQ(all.size(), 3 + 2 * shown);
  QStringList others;
  for (std::size_t i = 0; i < shown; ++i) {
    const std::string one = base::encode_utf8(similar[i]);
    others.append(in_hand(all[3], one.c_str()) + u' ' + muted(all[4], kanji::romaji_of(one).c_str()));
  }
  EXPECT_EQ(text.mid(first.size()), others.join(gap_));
}

TEST_F(QuestionText, AWordThatAsksIsLargeAndOneThatHelpsIsNot) {
  know(U'八');
  learn_from({});
  session_->set_asks_by_words(true);
  ASSERT_TRUE(session_->start());
  auto sheet = bare_sheet();
  kanji::Word word;
  word.text = "八月";
  word.reading = "はちがつ";
  word.glosses = {"August", "b"};
  word.common = true;
  sheet->words = {word};
  session_->set_sheet(sheet);
  ASSERT_NE(session_->word(), nullptr);
  QString text = asked(sheet);
  auto all = sizes(text);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_NEAR(all[0] / all[1], 1.8 / 1.4, 0.01);
  EXPECT_EQ(text, in_hand(all[0], "＿月") + QStringLiteral("<br>") + in_hand(all[1], "はちがつ") +
                      QStringLiteral(" &nbsp;") + muted(all[2], "August; b"));
  EXPECT_GT(all[1], all[2]);
  EXPECT_EQ(view_.findChild<QLabel*>(QStringLiteral("session_question"))->accessibleName(),
            QStringLiteral("blank 月, はちがつ, August; b"));
  set_room(20);
  const QString line = asked(sheet);
  all = sizes(line);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_NEAR(all[0], all[1], 1e-6) << "in one line nothing is larger than 1.15";
  EXPECT_LE(all[0], 1.15 + 1e-6);
  EXPECT_EQ(line, in_hand(all[0], "＿月") + gap_ + in_hand(all[1], "はちがつ") + QStringLiteral(" &nbsp;") +
                      muted(all[2], "August"));
}

TEST_F(QuestionText, ALongQuestionIsWrittenSmallerByTenthsUntilItFits) {
  know(U'八');
  learn_from({});
  ASSERT_TRUE(session_->start());
  auto sheet = bare_sheet();
  const auto height = [&](const QString& text) {
    QTextDocument page;
    page.setDefaultFont(view_.font());
    page.setDocumentMargin(0);
    page.setTextWidth(1600 - 32);
    page.setHtml(text);
    return page.size().height();
  };
  std::set<int> steps;
  for (int words = 5; words < 200; words += 15) {
    const std::string meaning = std::string("meaning ") + [words] {
      std::string all;
      for (int i = 0; i < words; ++i) all += "word ";
      return all;
    }();
    sheet->character.entry.meanings = {{"en", meaning}};
    const QString text = asked(sheet);
    const double size = sizes(text).at(0);
    const int step = static_cast<int>(std::lround(std::log(size / 1.8) / std::log(0.9)));
    EXPECT_GE(size, 0.85 - 1e-6);
    if (size < 0.8501) continue;  // as small as it gets, whether it fits or not
    steps.insert(step);
    EXPECT_NEAR(size, 1.8 * std::pow(0.9, step), 1e-4) << words;
    EXPECT_EQ(text, ink(size, meaning.c_str()));
    EXPECT_LE(height(text), view_.minimumHeight()) << words;
    if (step > 0) {
      EXPECT_GT(height(ink(1.8 * std::pow(0.9, step - 1), meaning.c_str())), view_.minimumHeight()) << words;
    }
  }
  EXPECT_GT(steps.size(), 2U);
  EXPECT_TRUE(steps.contains(0));
}

TEST_F(QuestionText, ItIsFourLinesHighAndLessInALowWindow) {
  know(U'八');
  learn_from({});
  ASSERT_TRUE(session_->start());
  const int line = QFontMetrics(QApplication::font()).lineSpacing();
  QSignalSpy rooms(&view_, &QuestionView::room_changed);
  asked(sheet());
  const std::pair<int, double> all[] = {{36, 4}, {35, 2.8}, {30, 2.8}, {29, 1.5}, {36, 4}};
  for (const auto& [em_high, lines] : all) {
    set_room(em_high);
    EXPECT_EQ(view_.minimumHeight(), static_cast<int>(lines * line)) << em_high;
    EXPECT_EQ(view_.maximumHeight(), view_.minimumHeight());
  }
  ASSERT_EQ(rooms.count(), 3);
  EXPECT_EQ(rooms.at(0).at(0).value<practice::QuestionRoom>(), practice::QuestionRoom::lines);
  EXPECT_EQ(rooms.at(1).at(0).value<practice::QuestionRoom>(), practice::QuestionRoom::line);
  EXPECT_EQ(rooms.at(2).at(0).value<practice::QuestionRoom>(), practice::QuestionRoom::full);
}

TEST_F(QuestionText, TheVerdictHasItsColourAndInALowWindowOnlyItsStars) {
  know(U'八');
  learn_from({});
  ASSERT_TRUE(session_->start());
  bring(U'八');
  for (const bool right : {true, false}) {
    write(right);
    const QuestionView::Verdict verdict{QStringLiteral("a < b"), QStringLiteral("spoken"),
                                        QStringLiteral("brief")};
    const auto line = [&](const char* words) {
      return QStringLiteral("<span style=\"color:%1\">%2</span> %3")
          .arg((right ? current_colours().moss : current_colours().vermilion).name(),
               right ? QStringLiteral("✓") : QStringLiteral("✗"), QString::fromLatin1(words));
    };
    const auto shown = [&](int em_high) {
      window_.resize(1600, em_high * em());
      view_.show_state(sheet(), verdict);
      return view_.findChild<QLabel*>(QStringLiteral("session_verdict"))->text();
    };
    const auto* reason = view_.findChild<QLabel*>(QStringLiteral("session_reason"));
    const auto* character = view_.findChild<QLabel*>(QStringLiteral("session_answer"));
    EXPECT_EQ(shown(36), line("a &lt; b"));
    EXPECT_FALSE(reason->isHidden());
    shown(36);  // the letters follow the character that is shown
    EXPECT_NEAR(character->font().pointSizeF(), 2 * QApplication::font().pointSizeF(), 0.01);
    EXPECT_EQ(shown(29), line("brief"));
    EXPECT_TRUE(reason->isHidden());
    EXPECT_NEAR(character->font().pointSizeF(), QApplication::font().pointSizeF(), 0.01);
    EXPECT_EQ(reason->text(),
              QStringLiteral("Suggested: %1 (%2)")
                  .arg(StudyWords::rating(session_->proposed()), StudyWords::reason(session_->reason())));
    EXPECT_EQ(character->text(), QStringLiteral("八"));
    session_->reopen();
  }
}

}  // namespace
}  // namespace nazori::ui
