// SPDX-License-Identifier: Apache-2.0
// Characters that people keep, and the commands that have them then.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class AuthorKeep : public testing::Test {
 protected:
  AuthorKeep() { EXPECT_EQ(nazori_cli({"author", "convert", "二", "--output", sign()}).code, 0); }
  [[nodiscard]] std::string sign() const { return folder_ / "sign.nazori"; }
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const {
    return nazori_cli(arguments, {"NAZORI_CHARACTERS=" + (folder_ / "characters")});
  }
  /// "U+F1A2B"
  [[nodiscard]] std::string keep() const {
    const Outcome kept = run({"author", "keep", sign()});
    EXPECT_EQ(kept.code, 0) << kept.err;
    return kept.out.substr(0, kept.out.find(' '));
  }

  TemporaryFolder folder_;
};

TEST_F(AuthorKeep, NamesTheKeptCharacterByItsCodePointForOtherCommands) {
  const std::string code_point = keep();
  EXPECT_THAT(code_point, StartsWith("U+F"));
  const Outcome kept = run({"author", "kept"});
  EXPECT_EQ(kept.out, code_point + "  二  2 strokes\n");
  EXPECT_THAT(run({"info", code_point}).out, HasSubstr("two"));
  EXPECT_EQ(run({"worksheet", code_point, "--output", folder_ / "w.pdf"}).code, 0);
  EXPECT_EQ(
      run({"worksheet", "--list", "own", "--learners", folder_ / "learners", "--output", folder_ / "l.pdf"})
          .code,
      0);
  EXPECT_EQ(run({"carve", code_point, "--output", folder_ / "a.raw", "--size", "64"}).code, 0);
  EXPECT_EQ(bytes_of(folder_ / "a.raw").size(), 64U * 64U);
  const auto found = nlohmann::json::parse(run({"search", "two", "--json"}).out);
  EXPECT_THAT(found.dump(), HasSubstr(nlohmann::json::parse(run({"author", "kept", "--json"}).out)
                                          .front()
                                          .at("character")
                                          .get<std::string>()));
  EXPECT_EQ(nazori_cli({"info", code_point}).code, 1) << "the tests' own folder is another one";
}

TEST_F(AuthorKeep, AsksWhatToDoWithTheSameName) {
  const std::string first = keep();
  const Outcome again = run({"author", "keep", sign()});
  EXPECT_EQ(again.code, 1);
  EXPECT_THAT(again.err, HasSubstr("give --replace or --beside"));
  const auto replaced = nlohmann::json::parse(run({"author", "keep", sign(), "--replace", "--json"}).out);
  EXPECT_EQ(replaced.front().at("code_point"), first);
  EXPECT_EQ(replaced.front().at("replaced"), true);
  const auto beside = nlohmann::json::parse(run({"author", "keep", sign(), "--beside", "--json"}).out);
  EXPECT_NE(beside.front().at("code_point"), first);
  EXPECT_EQ(beside.front().at("replaced"), false);
  EXPECT_EQ(run({"author", "keep", sign(), "--replace"}).code, 1) << "there are two now";
  EXPECT_EQ(run({"author", "remove", "二"}).code, 2);
  EXPECT_EQ(run({"author", "remove", first}).code, 0);
  EXPECT_EQ(run({"author", "remove", "二"}).code, 0);
  EXPECT_EQ(run({"author", "remove", "二"}).code, 1);
  EXPECT_EQ(run({"author", "kept", "--json"}).out, "[]\n");
}

TEST_F(AuthorKeep, CallsACharacterWithoutANameAsItsFile) {
  write(folder_ / "our bar.svg",
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 109 109\"><g id=\"kvg:StrokePaths_x\">"
        "<g id=\"kvg:x\"><path id=\"kvg:x-s1\" d=\"M20,50L90,50\"/></g></g></svg>");
  EXPECT_THAT(run({"author", "keep", folder_ / "our bar.svg"}).out, HasSubstr("  our bar\n"));
}

TEST_F(AuthorKeep, KeepsNothingWhereOneFileIsWrong) {
  write(folder_ / "wrong.nazori", "no document");
  EXPECT_EQ(run({"author", "keep", sign(), folder_ / "wrong.nazori"}).code, 2);
  EXPECT_THAT(run({"author", "kept"}).out, StartsWith("No characters of your own are kept."));
}

TEST_F(AuthorKeep, TellsADamagedFileAndTheOthersStillWork) {
  const std::string code_point = keep();
  write(folder_ / "characters/U+F0001.nazori", "no document");
  const Outcome kept = run({"author", "kept"});
  EXPECT_EQ(kept.code, 1);
  EXPECT_THAT(kept.err, HasSubstr("U+F0001.nazori"));
  EXPECT_THAT(kept.out, HasSubstr(code_point));
  EXPECT_EQ(run({"info", code_point}).code, 0);
}

TEST_F(AuthorKeep, RefusesAReliefWithoutStrokes) {
  ASSERT_EQ(nazori_cli({"author", "convert", sign(), "--output", folder_ / "a.raw", "--size", "64"}).code, 0);
  ASSERT_EQ(nazori_cli({"author", "convert", folder_ / "a.raw", "--output", folder_ / "b.nazori"}).code, 0);
  const Outcome refused = run({"author", "keep", folder_ / "b.nazori"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("has no"));
}

}  // namespace
}  // namespace nazori::cli::test
