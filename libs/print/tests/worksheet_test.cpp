// SPDX-License-Identifier: Apache-2.0
#include "nazori/print/worksheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "nazori/kanji/kanji_database.h"

namespace nazori::print {
namespace {

using testing::Each;
using testing::Ge;
using testing::HasSubstr;
using testing::Not;

const kanji::KanjiDatabase& database() {
  static const auto opened =
      kanji::KanjiDatabase::open(std::filesystem::path(std::getenv("NAZORI_DATA")) / "kanji.db");
  return *opened;
}

std::vector<SheetCharacter> characters(std::u32string_view text) {
  std::vector<SheetCharacter> all;
  for (const char32_t c : text) all.push_back({database().find(c).value(), database().words(c, 3)});
  return all;
}

/// A PDF in a folder of its own, for the tools of poppler.
class PrintedPages {
 public:
  explicit PrintedPages(const base::Result<std::string>& pdf) {
    static int count = 0;
    folder_ = std::filesystem::temp_directory_path() /
              ("nazori-print-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(folder_);
    EXPECT_TRUE(pdf) << (pdf ? "" : base::to_line(pdf.error()));
    std::ofstream(folder_ / "a.pdf", std::ios::binary) << pdf.value_or("");
  }
  ~PrintedPages() { std::filesystem::remove_all(folder_); }
  PrintedPages(const PrintedPages&) = delete;
  PrintedPages& operator=(const PrintedPages&) = delete;

  [[nodiscard]] std::string run(const std::string& command) const {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(
        popen(("cd '" + folder_.string() + "' && " + command + " 2>&1").c_str(), "r"), &pclose);
    std::string out;
    std::array<char, 4096> room{};
    for (std::size_t n = 0; (n = std::fread(room.data(), 1, room.size(), pipe.get())) > 0;)
      out.append(room.data(), n);
    return out;
  }
  [[nodiscard]] std::string text() const { return run("pdftotext -layout a.pdf -"); }
  [[nodiscard]] int pages() const {
    const std::string info = run("pdfinfo a.pdf");
    std::smatch match;
    return std::regex_search(info, match, std::regex(R"(Pages:\s*(\d+))")) ? std::stoi(match[1]) : 0;
  }
  /// Distance of the nearest mark from each edge of a page [mm]: left, top, right, bottom.
  [[nodiscard]] std::array<double, 4> free_mm(int page) const {
    constexpr int kDpi = 100;
    const std::string picture =
        run("pdftoppm -gray -r 100 -f " + std::to_string(page) + " -l " + std::to_string(page) + " a.pdf");
    std::istringstream in(picture);
    std::string magic;
    int width = 0;
    int height = 0;
    int most = 0;
    in >> magic >> width >> height >> most;
    EXPECT_EQ(magic, "P5") << picture.substr(0, 200);
    const std::size_t start = static_cast<std::size_t>(in.tellg()) + 1;
    int left = width;
    int top = height;
    int right = -1;
    int bottom = -1;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto at = start + static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x);
        if (static_cast<unsigned char>(picture[at]) > 250) continue;
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
    }
    EXPECT_GE(right, 0) << "the page is empty";
    constexpr double kMm = 25.4 / kDpi;
    return {left * kMm, top * kMm, (width - 1 - right) * kMm, (height - 1 - bottom) * kMm};
  }

 private:
  std::filesystem::path folder_;
};

// A dot of the rasterised page, and half a line.
constexpr double kBlur_mm = 0.5;

TEST(Worksheet, ItsTextIsReadBackAsTheRightCharacters) {
  const PrintedPages paper(worksheet_pdf(characters(U"休一日"), {}));
  const std::string text = paper.text();
  for (const char* part :
       {"休", "一", "日", "キュウ", "やす(む)", "rest", "休み", "やすみ", "Name", "Date", "KanjiVG"})
    EXPECT_THAT(text, HasSubstr(part));
  // Radicals of Unicode look like 一 and 日.
  EXPECT_THAT(text, Not(HasSubstr("⼀")));
  EXPECT_THAT(text, Not(HasSubstr("⽇")));
}

/// The strokes of 一 as a sign of somebody's own.
SheetCharacter own_sign(char32_t code_point, MadeForm made) {
  SheetCharacter one{database().find(U'一').value(), {}};
  one.character.code_point = code_point;
  one.made = std::move(made);
  return one;
}

TEST(Worksheet, ASignOfOnesOwnIsReadBackByItsName) {
  SheetSettings cards;
  cards.layout = Layout::cards;
  SheetSettings quiz;
  quiz.layout = Layout::quiz;
  quiz.answers = true;
  for (const SheetSettings& settings : {SheetSettings{}, cards, quiz}) {
    const PrintedPages paper(worksheet_pdf({own_sign(0xF1A2B, {"our sign", "", "", false})}, settings));
    EXPECT_THAT(paper.text(), HasSubstr("our sign")) << static_cast<int>(settings.layout);
    EXPECT_THAT(paper.text(), Not(HasSubstr("〓"))) << static_cast<int>(settings.layout);
  }
  SheetCharacter form = own_sign(U'一', {"bar", "", "", false});
  form.character.own_form = 0xF1A2B;
  EXPECT_THAT(PrintedPages(worksheet_pdf({form}, {})).text(), HasSubstr("一"))
      << "it is the published character";
}

TEST(Worksheet, ItNamesWhoMadeItsStrokes) {
  const auto credits = [](const std::vector<SheetCharacter>& all) {
    const std::string text = PrintedPages(worksheet_pdf(all, {})).text();
    const std::size_t begin = text.find("Strokes:");
    if (begin == std::string::npos)
      return std::string(text.find("Made with Nazori.") != std::string::npos ? "none" : "");
    return text.substr(begin, text.find(" Made with Nazori.") - begin);
  };
  const SheetCharacter published = characters(U"一").front();
  const SheetCharacter drawn = own_sign(0xF1A2B, {"our sign", "Hanako Yamada", "CC-BY-4.0", false});
  const SheetCharacter nameless = own_sign(0xF1A2C, {"mark", "", "", false});
  const SheetCharacter corrected =
      own_sign(0xF1A2D, {"一", "Ulrich Apel and the KanjiVG contributors", "CC-BY-SA-3.0", true});
  const SheetCharacter changed = own_sign(0xF1A2E, {"一", "Hanako Yamada", "CC-BY-SA-3.0", true});
  EXPECT_EQ(credits({published}), "Strokes: KanjiVG, CC BY-SA 3.0.");
  EXPECT_EQ(credits({corrected}), "Strokes: KanjiVG, CC BY-SA 3.0.");
  EXPECT_EQ(credits({drawn, drawn}), "Strokes: Hanako Yamada, CC-BY-4.0.");
  EXPECT_EQ(credits({nameless}), "none");
  EXPECT_EQ(credits({published, drawn}), "Strokes: KanjiVG, CC BY-SA 3.0; Hanako Yamada, CC-BY-4.0.");
  EXPECT_EQ(credits({changed}), "Strokes: KanjiVG, CC BY-SA 3.0; Hanako Yamada, CC-BY-SA-3.0.");
  std::vector<SheetCharacter> many;
  for (int i = 0; i < 12; ++i)
    many.push_back(
        own_sign(0xF1A30 + static_cast<char32_t>(i),
                 {"mark", "A maker with a long name, number " + std::to_string(i), "CC-BY-4.0", false}));
  const PrintedPages crowded(worksheet_pdf(many, {}));
  EXPECT_THAT(crowded.text(), HasSubstr("number 11, CC-BY-4.0"));
  for (const double free : crowded.free_mm(1)) EXPECT_GE(free, kMargin_mm - kBlur_mm);
}

TEST(Worksheet, ItsFontsAreEmbeddedSubsetsWithText) {
  const PrintedPages paper(worksheet_pdf(characters(U"休"), {}));
  const std::string fonts = paper.run("pdffonts a.pdf");
  EXPECT_THAT(fonts, HasSubstr("NAZORI+KleeOne"));
  // Embedded, subset, with the map to Unicode.
  EXPECT_TRUE(std::regex_search(fonts, std::regex("KleeOne.*yes +yes +yes"))) << fonts;
  EXPECT_THAT(fonts, Not(HasSubstr(" no ")));
  EXPECT_THAT(paper.run("pdfinfo a.pdf"), Not(HasSubstr("Error")));
}

TEST(Worksheet, NothingIsInTheMargins) {
  for (const Layout layout :
       {Layout::practice, Layout::quiz, Layout::cards, Layout::manuscript, Layout::brush}) {
    for (const Paper size : {Paper::a4, Paper::b5, Paper::letter, Paper::hanshi}) {
      for (const bool vertical : {false, true}) {
        SheetSettings settings;
        settings.layout = layout;
        settings.paper = size;
        settings.vertical = vertical;
        settings.answers = true;
        settings.title =
            "A title that is much too long for the space that is left beside the name, the class and the "
            "date";
        settings.text =
            "春はあけぼの。やうやう白くなりゆく山ぎは、少し明かりて、紫だちたる雲の細くたなびきたる。";
        const PrintedPages paper(worksheet_pdf(characters(U"休鬱永"), settings));
        for (int page = 1; page <= std::min(2, paper.pages()); ++page) {
          EXPECT_THAT(paper.free_mm(page), Each(Ge(kMargin_mm - kBlur_mm)))
              << static_cast<int>(layout) << " " << static_cast<int>(size) << " " << vertical << " page "
              << page;
        }
      }
    }
  }
}

TEST(Worksheet, CellsFromTheSmallestToTheLargestStayInside) {
  for (const double cell : {kSmallestCell_mm, 33.0, kLargestCell_mm}) {
    SheetSettings settings;
    settings.cell_mm = cell;
    settings.guide = Guide::diagonals;
    const PrintedPages paper(worksheet_pdf(characters(U"鬱"), settings));
    EXPECT_THAT(paper.free_mm(1), Each(Ge(kMargin_mm - kBlur_mm))) << cell;
  }
}

TEST(Worksheet, AWholePageIsFilledWithCellsOfOneCharacter) {
  SheetSettings settings;
  settings.whole_page = true;
  const PrintedPages paper(worksheet_pdf(characters(U"休木"), settings));
  EXPECT_EQ(paper.pages(), 2);
  EXPECT_THAT(paper.free_mm(1)[3], testing::Lt(kMargin_mm + 5));
  const PrintedPages together(worksheet_pdf(characters(U"休木"), {}));
  EXPECT_EQ(together.pages(), 1);
}

TEST(Worksheet, AnswersStandOnTheBackAndOnlyThere) {
  SheetSettings settings;
  settings.layout = Layout::quiz;
  settings.answers = true;
  const PrintedPages paper(worksheet_pdf(characters(U"休"), settings));
  ASSERT_EQ(paper.pages(), 2);
  EXPECT_THAT(paper.run("pdftotext -f 1 -l 1 a.pdf -"), Not(HasSubstr("休")));
  EXPECT_THAT(paper.run("pdftotext -f 2 -l 2 a.pdf -"), HasSubstr("休"));
  settings.answers = false;
  EXPECT_EQ(PrintedPages(worksheet_pdf(characters(U"休"), settings)).pages(), 1);
}

TEST(Worksheet, ACardHasItsBackBehindIt) {
  SheetSettings settings;
  settings.layout = Layout::cards;
  settings.numbers = false;
  const PrintedPages paper(worksheet_pdf(characters(U"休木"), settings));
  ASSERT_EQ(paper.pages(), 2);
  // 休 is the left card in front, so its reading is on the right of the back.
  const std::string front = paper.run("pdftotext -layout -f 1 -l 1 a.pdf -");
  EXPECT_LT(front.find("休"), front.find("木"));
  const std::string back = paper.run("pdftotext -layout -f 2 -l 2 a.pdf -");
  EXPECT_LT(back.find("ボク"), back.find("キュウ"));
}

TEST(Worksheet, ABookletHasItsFirstPageBesideItsLast) {
  SheetSettings settings;
  settings.whole_page = true;
  settings.booklet = true;
  settings.facts = false;
  const PrintedPages paper(worksheet_pdf(characters(U"一二三四五"), settings));
  // Five pages and three empty ones: two sheets, printed on both sides.
  ASSERT_EQ(paper.pages(), 4);
  const auto side = [&](int page) {
    std::string found;
    const std::string text =
        paper.run("pdftotext -f " + std::to_string(page) + " -l " + std::to_string(page) + " a.pdf -");
    for (const char* one : {"一", "二", "三", "四", "五"})
      if (text.find(one) != std::string::npos) found += one;
    return found;
  };
  EXPECT_EQ(side(1), "一");
  EXPECT_EQ(side(2), "二");
  EXPECT_EQ(side(3), "三");
  EXPECT_EQ(side(4), "四五");
  EXPECT_THAT(paper.free_mm(1), Each(Ge(kMargin_mm - kBlur_mm)));
}

TEST(Worksheet, ManuscriptPaperHoldsFourHundredLettersASheet) {
  SheetSettings settings;
  settings.layout = Layout::manuscript;
  const auto pages = [&](const std::string& text) {
    settings.text = text;
    return PrintedPages(worksheet_pdf({}, settings)).pages();
  };
  const auto letters = [](int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += "あ";
    return text;
  };
  EXPECT_EQ(pages(""), 1);
  EXPECT_EQ(pages(letters(400)), 1);
  EXPECT_EQ(pages(letters(401)), 2);
  EXPECT_EQ(pages(letters(400) + "。"), 1) << "a full stop shares the last cell";
  EXPECT_EQ(pages(letters(381) + "\nあ"), 2) << "a new line begins a new column";
}

TEST(Worksheet, TheSameInputGivesTheSameBytes) {
  const auto first = worksheet_pdf(characters(U"休永"), {});
  EXPECT_EQ(first.value(), worksheet_pdf(characters(U"休永"), {}).value());
}

TEST(Worksheet, WhatCannotBePrintedIsRefused) {
  const auto trouble = [](SheetSettings settings) {
    const auto pdf = worksheet_pdf(characters(U"休"), settings);
    return pdf ? std::string() : pdf.error().what;
  };
  SheetSettings settings;
  settings.cell_mm = 7.9;
  EXPECT_THAT(trouble(settings), HasSubstr("7.9 mm"));
  settings.cell_mm = 61;
  EXPECT_THAT(trouble(settings), HasSubstr("61 mm"));
  settings = {};
  settings.rows = 41;
  EXPECT_THAT(trouble(settings), HasSubstr("rows"));
  settings = {};
  settings.copies = -1;
  EXPECT_THAT(trouble(settings), HasSubstr("copies"));
  settings.copies = 40;
  settings.rows = 40;
  settings.whole_page = true;  // the page decides how many rows there are
  EXPECT_EQ(trouble(settings), "");
  settings = {};
  settings.rows = 20;
  EXPECT_THAT(trouble(settings), HasSubstr("do not fit"));
  EXPECT_THAT(worksheet_pdf({}, {}).error().what, HasSubstr("no character"));
}

TEST(Worksheet, ASignThatClosesStandsInTheFirstCellOfATextThatBeginsWithIt) {
  SheetSettings settings;
  settings.layout = Layout::manuscript;
  settings.text = "。あ";
  const PrintedPages paper(worksheet_pdf({}, settings));
  EXPECT_THAT(paper.free_mm(1), Each(Ge(kMargin_mm - kBlur_mm)));
  // pdftotext -bbox: in points from the upper edge; the sheet lies on its side.
  const std::string boxes = paper.run("pdftotext -bbox a.pdf - ");
  std::smatch first;
  ASSERT_TRUE(std::regex_search(boxes, first, std::regex("yMin=\"([0-9.]+)\"[^>]*>。"))) << boxes;
  EXPECT_GE(std::stod(first[1]), kMargin_mm * 72 / 25.4 - 5) << "a cell is 19 points high";
}

TEST(Worksheet, ItCanBeStopped) {
  const auto pdf = worksheet_pdf(characters(U"休"), {}, [](double, std::string_view) { return false; });
  EXPECT_EQ(pdf.error().code, base::Errc::cancelled);
}

}  // namespace
}  // namespace nazori::print
