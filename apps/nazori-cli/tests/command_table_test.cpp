// SPDX-License-Identifier: Apache-2.0
// The command line as data, read from an application that has every kind of option.
#include "command_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "odd_command_line.h"

namespace nazori::cli::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class CommandTable : public testing::Test {
 protected:
  [[nodiscard]] const OptionEntry& option(const std::string& name) const {
    for (const OptionEntry& entry : program_.verbs.front().options) {
      if (entry.names.back() == name) return entry;
    }
    throw std::runtime_error("no option " + name);
  }

  OddCommandLine line_;
  Command program_ = command_table(line_.app);
};

TEST_F(CommandTable, ListsVerbsOutermostFirstWithoutHiddenOnes) {
  std::vector<std::string> paths;
  for (const Command* command : all_commands(program_)) paths.push_back(command->path);
  EXPECT_THAT(paths, ElementsAre("", "carve", "study", "study check"));
}

TEST_F(CommandTable, ListsOptionsInOrderWithoutHiddenOnes) {
  std::vector<std::string> names;
  for (const OptionEntry& entry : program_.verbs.front().options) names.push_back(joined_names(entry));
  EXPECT_THAT(names, ElementsAre("-h, --help", "-o, --output", "--folder", "--shape", "--level", "--fault",
                                 "--size", "--window", "--rename", "-q, --quiet"));
  ASSERT_EQ(program_.verbs.front().arguments.size(), 1U);
  EXPECT_EQ(joined_names(program_.verbs.front().arguments.front()), "characters...");
}

TEST_F(CommandTable, KnowsFilesFoldersAndFlags) {
  EXPECT_EQ(option("--output").takes, Takes::file);
  EXPECT_EQ(option("--folder").takes, Takes::folder);
  EXPECT_EQ(option("--fault").takes, Takes::text);
  EXPECT_EQ(option("--quiet").takes, Takes::nothing);
  EXPECT_EQ(option("--quiet").value, "");
  EXPECT_EQ(option("--help").takes, Takes::nothing);
  EXPECT_EQ(program_.verbs.back().verbs.front().arguments.front().takes, Takes::file);
}

TEST_F(CommandTable, ReadsTheWordsOfFixedChoices) {
  EXPECT_EQ(option("--shape").takes, Takes::choice);
  EXPECT_THAT(option("--shape").choices, ElementsAre("round", "it's", "$(touch pwned)"));
  EXPECT_EQ(option("--level").takes, Takes::choice);
  EXPECT_THAT(option("--level").choices, ElementsAre("high", "low"));
  EXPECT_THAT(option("--size").choices, IsEmpty());
}

TEST_F(CommandTable, KeepsTheNameOfAValueApartFromItsChecks) {
  EXPECT_EQ(option("--size").value, "N");
  EXPECT_EQ(option("--fault").value, "KIND:STROKE");
}

TEST_F(CommandTable, CountsTheWordsOfAValue) {
  EXPECT_EQ(option("--quiet").values, 0);
  EXPECT_EQ(option("--output").values, 1);
  EXPECT_EQ(option("--rename").values, 2);
  EXPECT_EQ(option("--window").values, 1);
  EXPECT_FALSE(option("--output").several);
  EXPECT_TRUE(option("--fault").several);
}

TEST_F(CommandTable, KeepsDescriptionsFootersGroupsAndWhatIsRequired) {
  CLI::App app("Does it", "tool");
  app.footer("See there");
  std::string text;
  CLI::App* make = app.add_subcommand("make", "Makes it");
  make->footer("Example:\n  tool make");
  make->add_option("-f,--form", text, "The form")->group("Looks");
  make->add_option("name", text, "The name")->required();
  make->add_option("other", text, "The other name");
  const Command table = command_table(app);
  EXPECT_EQ(table.name, "tool");
  EXPECT_EQ(table.path, "");
  EXPECT_EQ(table.description, "Does it");
  EXPECT_EQ(table.footer, "See there");
  ASSERT_EQ(table.verbs.size(), 1U);
  const Command& verb = table.verbs.front();
  EXPECT_EQ(verb.name, "make");
  EXPECT_EQ(verb.description, "Makes it");
  EXPECT_EQ(verb.footer, "Example:\n  tool make");
  ASSERT_EQ(verb.options.size(), 2U);
  EXPECT_EQ(verb.options[1].group, "Looks");
  EXPECT_EQ(verb.options[1].description, "The form");
  EXPECT_THAT(verb.options[1].names, ElementsAre("-f", "--form"));
  EXPECT_FALSE(verb.options[1].required);
  ASSERT_EQ(verb.arguments.size(), 2U);
  EXPECT_EQ(verb.arguments[0].argument, "name");
  EXPECT_TRUE(verb.arguments[0].required);
  EXPECT_EQ(verb.arguments[0].notes, "") << "an argument that may be left out is in brackets instead";
  EXPECT_FALSE(verb.arguments[1].required);
  EXPECT_FALSE(verb.arguments[1].several);
}

TEST_F(CommandTable, NotesRangeDefaultAndDuty) {
  EXPECT_EQ(description_with_notes(option("--size")), "A size (2..8; default: 4)");
  EXPECT_EQ(option("--output").notes, "required");
  EXPECT_EQ(description_with_notes(option("--quiet")), "A flag");
}

}  // namespace
}  // namespace nazori::cli::test
