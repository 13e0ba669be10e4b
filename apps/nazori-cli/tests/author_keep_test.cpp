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

TEST_F(AuthorKeep, CarvesDrawsAndMakesWhatSomebodyMadeWithItsOwnGrooves) {
  const std::string code_point = keep();
  EXPECT_EQ(run({"author", "convert", sign(), "--output", folder_ / "relief.raw", "--size", "64"}).code, 0);
  // The brush is for published characters: it would change all of these.
  const auto made = [&](const std::string& what, const std::vector<std::string>& command) {
    const auto file = [&](const std::string& name, const std::string& character,
                          const std::vector<std::string>& brush) {
      std::vector<std::string> arguments{command.front(), character, "--output", folder_ / name};
      arguments.insert(arguments.end(), command.begin() + 1, command.end());
      arguments.insert(arguments.end(), brush.begin(), brush.end());
      const Outcome outcome = run(arguments);
      EXPECT_EQ(outcome.code, 0) << outcome.err;
      return bytes_of(folder_ / name);
    };
    const auto own = file("own" + what, code_point, {});
    EXPECT_EQ(file("own_wide" + what, code_point, {"--width", "20"}), own) << what;
    EXPECT_NE(file("published_wide" + what, "二", {"--width", "20"}), file("published" + what, "二", {}))
        << what;
    return own;
  };
  EXPECT_EQ(made(".raw", {"carve", "--size", "64"}), bytes_of(folder_ / "relief.raw"));
  made(".stl", {"model", "--size-mm", "20"});
  made(".png", {"render", "--size", "64x64", "--map-size", "64"});
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

TEST_F(AuthorKeep, UsesAFormInsteadOfThePublishedCharacterUntilItIsRemoved) {
  write(folder_ / "一.svg",
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 109 109\"><g id=\"kvg:StrokePaths_x\">"
        "<g id=\"kvg:x\"><path id=\"kvg:x-s1\" d=\"M20,50L90,50\"/><path id=\"kvg:x-s2\" d=\"M20,80L90,80\"/>"
        "</g></g></svg>");
  const Outcome kept = run({"author", "keep", folder_ / "一.svg", "--instead"});
  EXPECT_EQ(kept.code, 0) << kept.err;
  const std::string code_point = kept.out.substr(0, kept.out.find(' '));
  EXPECT_EQ(kept.out, code_point + "  一 instead of the published 一\n");
  EXPECT_EQ(run({"author", "kept"}).out, code_point + "  一  2 strokes instead of the published 一\n");
  const auto listed = nlohmann::json::parse(run({"author", "kept", "--json"}).out);
  EXPECT_EQ(listed.front().at("instead_of"), "一");
  const Outcome info = run({"info", "一"});
  EXPECT_THAT(info.out, HasSubstr("2 strokes · 1 in the dictionary"));
  EXPECT_THAT(info.out,
              HasSubstr("form        your own, " + code_point + ", instead of the published one\n"));
  const auto json = nlohmann::json::parse(run({"info", "一", "二", "--json"}).out);
  EXPECT_EQ(json[0].at("own_form"), code_point);
  EXPECT_EQ(json[0].at("strokes").size(), 2U);
  EXPECT_TRUE(json[1].at("own_form").is_null());
  EXPECT_EQ(run({"info", code_point}).code, 1) << "it is the published character";
  EXPECT_EQ(run({"worksheet", "一", "--layout", "quiz", "--output", folder_ / "q.pdf"}).code, 0);
  // A copy of a form has the licence of the form.
  const auto original = nlohmann::json::parse(
      run({"author", "convert", folder_ / "一.svg", "--output", folder_ / "original.nazori", "--json"}).out);
  const auto copy = nlohmann::json::parse(
      run({"author", "convert", "一", "--output", folder_ / "copy.nazori", "--json"}).out);
  EXPECT_EQ(copy.at("strokes"), 2);
  EXPECT_EQ(copy.at("licence"), original.at("licence"));
  EXPECT_EQ(run({"author", "remove", "一"}).code, 0);
  EXPECT_THAT(run({"info", "一"}).out, HasSubstr("1 stroke · "));
}

TEST_F(AuthorKeep, ReplacesAFormAndTurnsTheChoiceOff) {
  const auto keep_as = [this](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"author", "keep", sign(), "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome kept = run(arguments);
    return kept.code == 0 ? nlohmann::json::parse(kept.out).front() : nlohmann::json();
  };
  const auto beside = keep_as({});
  EXPECT_TRUE(beside.at("instead_of").is_null());
  const Outcome refused = run({"author", "keep", sign(), "--instead"});
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.err, HasSubstr("give --replace"));
  const auto instead = keep_as({"--instead", "--replace"});
  EXPECT_EQ(instead.at("instead_of"), "二");
  EXPECT_EQ(instead.at("code_point"), beside.at("code_point"));
  EXPECT_EQ(instead.at("replaced"), true);
  // The file of the collection has the choice in it.
  const std::string file =
      nlohmann::json::parse(run({"author", "kept", "--json"}).out).front().at("file").get<std::string>();
  const Outcome again =
      nazori_cli({"author", "keep", file, "--json"}, {"NAZORI_CHARACTERS=" + (folder_ / "other computer")});
  EXPECT_EQ(nlohmann::json::parse(again.out).front().at("instead_of"), "二");
  const Outcome off = nazori_cli({"author", "keep", file, "--beside", "--json"},
                                 {"NAZORI_CHARACTERS=" + (folder_ / "third computer")});
  EXPECT_TRUE(nlohmann::json::parse(off.out).front().at("instead_of").is_null());
}

TEST_F(AuthorKeep, RefusesThePlaceOfWhatIsNotPublished) {
  const std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 109 109\"><g id=\"kvg:StrokePaths_x\">"
      "<g id=\"kvg:x\"><path id=\"kvg:x-s1\" d=\"M20,50L90,50\"/></g></g></svg>";
  write(folder_ / "our bar.svg", svg);
  write(folder_ / "€.svg", svg);
  const Outcome sign_name = run({"author", "keep", folder_ / "our bar.svg", "--instead"});
  EXPECT_EQ(sign_name.code, 2);
  EXPECT_THAT(sign_name.err, HasSubstr("is not the name of one published character"));
  const Outcome unknown = run({"author", "keep", folder_ / "€.svg", "--instead"});
  EXPECT_EQ(unknown.code, 1);
  EXPECT_THAT(unknown.err, HasSubstr("not in the database"));
  EXPECT_EQ(run({"author", "keep", sign(), "--instead", "--beside"}).code, 2);
  EXPECT_THAT(run({"author", "kept"}).out, StartsWith("No characters of your own are kept."));
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
