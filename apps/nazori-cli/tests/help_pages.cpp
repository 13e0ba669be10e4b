// SPDX-License-Identifier: Apache-2.0
#include "help_pages.h"

#include <sstream>
#include <stdexcept>

#include "program.h"

namespace nazori::cli::test {
namespace {

/// The names at the start of an entry: "-o", "--output" of "  -o, --output FILE       The file".
std::vector<std::string> names_in(const std::string& line) {
  std::vector<std::string> names;
  std::istringstream words(line.substr(2, line.find("  ", 2) - 2));
  for (std::string word; words >> word;) {
    if (word.ends_with(',')) word.pop_back();
    if (names.empty() || word.starts_with('-')) names.push_back(word);
  }
  return names;
}

void read_pages(const std::vector<std::string>& verb, std::vector<HelpPage>& pages) {
  HelpPage page{verb, {}, {}, {}};
  std::vector<std::string> line_of_command = verb;
  line_of_command.emplace_back("--help");
  const Outcome run = nazori_cli(line_of_command);
  if (run.code != 0) throw std::runtime_error(run.err);
  std::istringstream lines(run.out);
  std::string heading;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.front() != ' ') heading = line;
    if (heading.starts_with("Example") || line.size() < 3 || !line.starts_with("  ") || line[2] == ' ')
      continue;
    const std::vector<std::string> names = names_in(line);
    std::vector<std::string>& listed = names.front().starts_with('-') ? page.options
                                       : heading == "Arguments:"      ? page.arguments
                                                                      : page.verbs;
    listed.insert(listed.end(), names.begin(), names.end());
  }
  pages.push_back(page);
  for (const std::string& name : page.verbs) {
    std::vector<std::string> inner = verb;
    inner.push_back(name);
    read_pages(inner, pages);
  }
}

}  // namespace

std::string HelpPage::path() const {
  std::string path;
  for (const std::string& name : verb) path += (path.empty() ? "" : " ") + name;
  return path;
}

const std::vector<HelpPage>& help_pages() {
  static const std::vector<HelpPage> kPages = [] {
    std::vector<HelpPage> pages;
    read_pages({}, pages);
    return pages;
  }();
  return kPages;
}

}  // namespace nazori::cli::test
