// SPDX-License-Identifier: Apache-2.0
#include "manual_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace nazori::cli {
namespace {

constexpr std::size_t kLineWidth = 78;

constexpr std::string_view kEnvironment = R"(.SH ENVIRONMENT
.TP
.B NAZORI_DATA
The folder of the kanji database
.IR kanji.db .
It is the first place where every verb looks, and where
.B database build
writes.
.TP
.B NAZORI_LEARNERS
The folder of all learners, for
.BR study .
.TP
.B NAZORI_CHARACTERS
The folder of a person's own characters.
Default:
.I nazori/characters
in XDG_DATA_HOME; where it is empty, there are none.
.TP
.B NAZORI_NOW
Takes this for the present and goes on from there:
2026\-01\-01T09:00Z or with +09:00.
.TP
.BR NAZORI_LIBHD ", " NAZORI_LIBDHD
The libraries of OpenHaptics and of Force Dimension,
where they have other names than usual.
.TP
.B NAZORI_INVERSE_PORT
The port of the Inverse Service, where it is not 10001.
.TP
.BR NAZORI_PANTOGRAPH_PORT ", " NAZORI_PANTOGRAPH_BUTTON
The serial port of a Haply 2diy, where it is not found by itself;
1 where a button is wired to its board.
.TP
.B XDG_DATA_HOME
The folder of a person's data, where study data and a person's own database are.
Default:
.IR \(ti/.local/share .
.TP
.B XDG_DATA_DIRS
More folders with a database in
.IR nazori/kanji.db .
Default:
.IR /usr/local/share:/usr/share .
.TP
.B XDG_CACHE_HOME
Where
.B database build
looks for the package of KanjiVG.
Default:
.IR \(ti/.cache .
.TP
.B SOURCE_DATE_EPOCH
The date of the page that
.B manual
prints, in seconds since 1970.
.SH FILES
.TP
.I kanji.db
The kanji database.
It is looked for in the folder
.BR NAZORI_DATA ,
beside the program, in
.I nazori/
of
.B XDG_DATA_HOME
and then of each of
.BR XDG_DATA_DIRS .
.TP
.I \(ti/.local/share/nazori/learners/
Study data, one folder for each learner.
.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 1
The answer is no, or nothing was found.
.TP
.B 2
Bad usage or bad input; one line on standard error says what, where,
and what would be right.
.TP
.B 3
Another program has the learner open.
.B \-\-wait
waits for it.
.TP
.BR 130 ", " 143
Ctrl+C (SIGINT) or SIGTERM stopped the work.
The program ends by that signal within 0.3 s,
and no file is left that is not whole.
)";

/// Running text in lines of at most kLineWidth bytes if its words allow it; no line starts with a request.
std::string filled(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::string lines;
  std::size_t width = 0;
  for (std::string word; words >> word;) {
    const std::string shown = roff_escaped(word);
    const std::size_t length = shown.size();
    if (width > 0 && width + 1 + length > kLineWidth) {
      lines += "\n";
      width = 0;
    }
    if (width > 0) lines += " ";
    width += length + (width > 0 ? 1 : 0);
    lines += shown;
  }
  return lines + "\n";
}

std::string bold(std::string_view text) { return "\\fB" + roff_escaped(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff_escaped(text) + "\\fR"; }

/// A footer of help in its two parts.
struct Footer {
  std::string prose;     ///< paragraphs, with an empty line between them
  std::string examples;  ///< command lines, without their indentation
};

Footer parts_of(const std::string& text) {
  Footer footer;
  std::istringstream lines(text);
  bool among_examples = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "Example:" || line == "Examples:") {
      among_examples = true;
    } else if (among_examples) {
      line.erase(0, line.find_first_not_of(' '));
      if (!line.empty()) footer.examples += line + "\n";
    } else {
      footer.prose += line + "\n";
    }
  }
  return footer;
}

std::string paragraphs(const std::string& prose) {
  std::string text;
  std::string paragraph;
  std::istringstream lines(prose + "\n");
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) {
      paragraph += line + " ";
    } else if (!paragraph.empty()) {
      text += ".PP\n" + filled(paragraph);
      paragraph.clear();
    }
  }
  return text;
}

std::string entry_text(const OptionEntry& entry) {
  std::string names;
  for (const std::string& name : entry.names) names += (names.empty() ? "" : ", ") + bold(name);
  if (names.empty()) names = italic(joined_names(entry));
  if (entry.argument.empty() && !entry.value.empty()) names += " " + italic(entry.value);
  return ".TP\n" + names + "\n" + filled(description_with_notes(entry));
}

/// "nazori-cli carve [options] characters..."
std::string usage_of(const Command& verb) {
  std::string usage = "nazori-cli " + verb.path + " [options]";
  if (!verb.verbs.empty()) usage += " VERB";
  for (const OptionEntry& argument : verb.arguments) {
    usage += argument.required ? " " + joined_names(argument) : " [" + joined_names(argument) + "]";
  }
  return usage;
}

/// Every command has --help, and every one with an answer has --quiet; the section OPTIONS describes both
/// once.
bool is_told_once(const OptionEntry& option) {
  return option.names.back() == "--help" || option.names.back() == "--quiet";
}

/// The options of a command under the headings of its help.
std::string options_text(const Command& verb) {
  std::vector<std::string> groups;
  for (const OptionEntry& option : verb.options) {
    if (std::find(groups.begin(), groups.end(), option.group) == groups.end()) groups.push_back(option.group);
  }
  std::string text;
  for (const std::string& group : groups) {
    if (group != groups.front()) text += ".PP\n" + filled(group + ":");
    for (const OptionEntry& option : verb.options) {
      if (option.group == group && !is_told_once(option)) text += entry_text(option);
    }
  }
  return text;
}

std::string verb_text(const Command& verb) {
  std::string text = ".SS " + roff_escaped("nazori-cli " + verb.path) + "\n" +
                     filled(verb.description + ".") + ".PP\n.EX\n" + roff_escaped(usage_of(verb)) + "\n.EE\n";
  for (const OptionEntry& argument : verb.arguments) text += entry_text(argument);
  return text + options_text(verb) + paragraphs(parts_of(verb.footer).prose);
}

std::string examples_of(const std::vector<const Command*>& commands) {
  std::string text = ".SH EXAMPLES\n";
  for (const Command* command : commands) {
    const std::string examples = parts_of(command->footer).examples;
    // The help of a command with subcommands repeats their examples.
    if (examples.empty() || !command->verbs.empty()) continue;
    text += ".PP\n" + filled(command->description + ":") + ".PP\n.EX\n";
    std::istringstream lines(examples);
    for (std::string line; std::getline(lines, line);) text += roff_escaped(line) + "\n";
    text += ".EE\n";
  }
  return text;
}

}  // namespace

std::string roff_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '\\':
        escaped += "\\(rs";
        break;
      case '-':
        escaped += "\\-";
        break;
      case '\'':
        escaped += "\\(aq";
        break;
      case '"':
        escaped += "\\(dq";
        break;
      case '`':
        escaped += "\\(ga";
        break;
      case '^':
        escaped += "\\(ha";
        break;
      case '~':
        escaped += "\\(ti";
        break;
      case '\n':
        escaped += ' ';
        break;
      default:
        escaped += c;
    }
  }
  // A dot at the start of a line is a request, and the line breaks are not known here.
  return escaped.starts_with('.') ? "\\&" + escaped : escaped;
}

std::string manual_page(const Command& program, std::string_view version, std::string_view date) {
  const std::vector<const Command*> commands = all_commands(program);
  std::string text = fmt::format(
      ".\\\" Written by: nazori\\-cli manual\n"
      ".TH NAZORI\\-CLI 1 \"{}\" \"Nazori {}\" \"User Commands\"\n"
      ".SH NAME\nnazori\\-cli \\- carved kanji you can see, feel and trace\n"
      ".SH SYNOPSIS\n"
      ".B nazori\\-cli\n.RI [ options ]\n.I VERB\n.RI [ options ]\n.RI [ argument ...]\n"
      ".SH DESCRIPTION\n",
      roff_escaped(date), roff_escaped(version));
  text += filled(
      "nazori-cli carves characters into height maps, draws pictures of them, tells what is known of them, "
      "grades "
      "handwriting, plans study and examines haptic devices. It does for scripts, laboratories and tests "
      "what the "
      "window does for people, and needs no screen.");
  text += ".PP\n" +
          filled(
              "Characters are named as 休, several as 休 木 or 休木, a variant form as 正-HzFst, any as "
              "U+4F11. Answers go to standard output; with --json in JSON, the same input giving the same "
              "bytes. An option's value follows in the next word or after an equals sign.");
  text += ".SH OPTIONS\n";
  for (const OptionEntry& option : program.options) text += entry_text(option);
  text +=
      ".PP\nEvery verb takes\n.BR \\-\\-help .\nEvery verb that answers takes\n.BR \\-q \", \" \\-\\-quiet "
      ":\n"
      "it then prints no answer and no progress, and the exit status tells.\n.SH VERBS\n";
  for (const Command* command : commands) {
    if (!command->path.empty()) text += verb_text(*command);
  }
  text += std::string(kEnvironment) + examples_of(commands);
  return text + ".SH SEE ALSO\n.BR nazori (1)\n";
}

}  // namespace nazori::cli
