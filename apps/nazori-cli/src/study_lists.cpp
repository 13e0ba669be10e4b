// SPDX-License-Identifier: Apache-2.0
// study lists, study tag, study profiles
#include <fmt/format.h>

#include <cstdint>
#include <memory>

#include "characters.h"
#include "nazori/base/file.h"
#include "nazori/base/utf8.h"
#include "nazori/study/profiles.h"
#include "study_session.h"
#include "text_layout.h"

namespace nazori::cli {
namespace {

constexpr std::size_t kMostListBytes = 1 << 20;

struct ListsSettings {
  StudyOptions options;
  std::string id;
  std::string file;
  std::string name;
  std::string remove;
};

struct TagSettings {
  StudyOptions options;
  std::vector<std::string> characters;
  std::vector<std::string> tags;
};

struct ProfilesSettings {
  StudyOptions options;
  std::vector<std::string> rename;
  std::string remove;
};

int import_list(Console& console, const ListsSettings& settings) {
  if (settings.name.empty()) {
    return console.refuse({base::Errc::bad_argument, "is missing", "--as", "give the list a name"});
  }
  const auto bytes = base::read_file(settings.file, kMostListBytes);
  if (!bytes) return console.refuse(bytes.error());
  auto session = StudySession::open(settings.options, study::Access::write);
  if (!session) return console.refuse(session.error());
  auto characters = study::parse_list({reinterpret_cast<const char*>(bytes->data()), bytes->size()},
                                      [&](char32_t c) { return session->lists().facts(c) != nullptr; });
  if (!characters) {
    characters.error().where = settings.file + ": " + characters.error().where;
    return console.refuse(characters.error());
  }
  const std::size_t count = characters->size();
  if (auto saved = session->learner().save_list({settings.name, *std::move(characters)}); !saved) {
    return console.refuse(saved.error());
  }
  console.print(settings.options.json ? to_text({{"list", "list:" + settings.name}, {"characters", count}})
                                      : fmt::format("list:{}  {}\n", settings.name,
                                                    counted(static_cast<std::int64_t>(count), "character")));
  return kDone;
}

int show_lists(Console& console, const ListsSettings& settings) {
  auto session = StudySession::open(settings.options, study::Access::read);
  if (!session) return console.refuse(session.error());
  if (!settings.id.empty()) {
    const auto members = session->lists().members(settings.id, session->learner());
    if (!members && members.error().code != base::Errc::not_found) return console.refuse(members.error());
    if (!members) return console.deny(members.error());
    std::vector<std::string> characters;
    for (const char32_t one : *members) characters.push_back(letter(one));
    console.print(settings.options.json ? to_text(Json(characters))
                                        : flow(characters, " ", 0, text_width()) + "\n");
    return kDone;
  }
  Json json = Json::array();
  std::string lines;
  const auto add = [&](const std::string& id, const std::string& name, const std::vector<char32_t>& members) {
    int met = 0;
    for (const char32_t one : members) met += session->learner().card(one).introduced ? 1 : 0;
    const std::size_t count = members.size();
    json.push_back({{"list", id}, {"name", name}, {"characters", count}, {"met", met}});
    lines += pad(id, 24) + fmt::format("{:5} characters, {:4} studied  {}\n", count, met, name);
  };
  for (const study::ReadyList& list : study::ready_lists()) {
    const auto members = session->lists().members(list.id, session->learner());
    if (!members) return console.refuse(members.error());
    add(list.id, list.name, *members);
  }
  const auto own = session->learner().lists();
  if (!own) return console.refuse(own.error());
  for (const study::CustomList& list : *own) add("list:" + list.name, list.name, list.characters);
  const auto tags = session->learner().tags();
  if (!tags) return console.refuse(tags.error());
  for (const auto& [tag, characters] : *tags) add("tag:" + tag, tag, characters);
  console.print(settings.options.json ? to_text(json) : lines);
  return kDone;
}

int lists(Console& console, const ListsSettings& settings) {
  if (!settings.file.empty()) return import_list(console, settings);
  if (settings.remove.empty()) return show_lists(console, settings);
  auto learner = open_learner(settings.options, study::Access::write);
  if (!learner) return console.refuse(learner.error());
  if (auto removed = learner->remove_list(settings.remove); !removed) return console.deny(removed.error());
  console.print(settings.options.json ? to_text({{"removed", "list:" + settings.remove}})
                                      : fmt::format("removed list:{}\n", settings.remove));
  return kDone;
}

int tag(Console& console, const TagSettings& settings) {
  auto session = StudySession::open(settings.options, study::Access::write);
  if (!session) return console.refuse(session.error());
  const auto characters = session->characters(settings.characters);
  if (!characters) return console.refuse(characters.error());
  for (const std::string& text : settings.tags) {
    if (!study::can_be_name(text)) {
      return console.refuse({base::Errc::bad_argument, fmt::format("'{}' cannot be a tag", text), "--with",
                             "give 1 to 100 bytes of text"});
    }
  }
  for (const char32_t one : *characters) {
    if (auto done = session->learner().set_tags(one, settings.tags); !done)
      return console.refuse(done.error());
  }
  if (!settings.options.json) {
    console.print(
        fmt::format("tagged: {}\n", counted(static_cast<std::int64_t>(characters->size()), "character")));
    return kDone;
  }
  Json json = Json::array();
  for (const char32_t one : *characters)
    json.push_back({{"character", base::encode_utf8(one)}, {"tags", settings.tags}});
  console.print(to_text(json));
  return kDone;
}

int profiles(Console& console, const ProfilesSettings& settings) {
  const auto folder = learners_folder(settings.options);
  if (!folder) return console.refuse(folder.error());
  if (!settings.rename.empty()) {
    auto done = when_free(settings.options, [&] {
      return study::rename_profile(*folder, settings.rename.at(0), settings.rename.at(1));
    });
    if (!done) return console.refuse(done.error());
  }
  if (!settings.remove.empty()) {
    const auto done =
        when_free(settings.options, [&] { return study::remove_profile(*folder, settings.remove); });
    if (!done) return console.refuse(done.error());
    if (!settings.options.json) console.print(fmt::format("moved to {}\n", done->string()));
  }
  const std::vector<std::string> names = study::profiles(*folder);
  if (settings.options.json) {
    console.print(to_text(Json(names)));
  } else {
    for (const std::string& name : names) console.print(name + "\n");
  }
  return kDone;
}

}  // namespace

void add_study_lists(CLI::App& study, Action& chosen) {
  auto list = std::make_shared<ListsSettings>();
  CLI::App* verb =
      add_study_verb(study, "lists", "Show lists of characters, import one from a text file, or remove one",
                     "A text file can have any number of characters per line; # starts a comment.\n\n"
                     "Examples:\n  nazori-cli study lists\n  nazori-cli study lists grade-1\n"
                     "  nazori-cli study lists --import chapter3.txt --as chapter3\n"
                     "  nazori-cli study settings 'new_lists=[\"list:chapter3\"]' new_order=own");
  verb->add_option("list", list->id, "A list to show: grade-1, old-jlpt-4, list:NAME, tag:NAME");
  verb->add_option("--import", list->file, "Import a list from this text file")->type_name("FILE");
  verb->add_option("--as", list->name, "Name of the imported list; replaces a list with the same name")
      ->type_name("NAME");
  verb->add_option("--remove", list->remove, "Remove this list of your own")->type_name("NAME");
  add_writer_options(*verb, list->options);
  verb->add_option("--database", list->options.database, "Kanji database to use")->type_name("FILE");
  verb->callback([list, &chosen] { chosen = [list](Console& console) { return lists(console, *list); }; });

  auto tags = std::make_shared<TagSettings>();
  verb = add_study_verb(study, "tag", "Set the tags of characters",
                        "Replaces existing tags; without --with, all tags are removed.\n\n"
                        "Example:\n  nazori-cli study tag 休 木 --with trees --with exam");
  verb->add_option("characters", tags->characters, "Characters or lists")->required();
  verb->add_option("--with", tags->tags, "A tag; may be repeated")->type_name("TAG");
  add_writer_options(*verb, tags->options);
  verb->add_option("--database", tags->options.database, "Kanji database to use")->type_name("FILE");
  verb->callback([tags, &chosen] { chosen = [tags](Console& console) { return tag(console, *tags); }; });

  auto asked = std::make_shared<ProfilesSettings>();
  verb = add_study_verb(study, "profiles", "Show the profiles on this computer, or rename or remove one",
                        "A profile is created on first use. A removed profile is moved to a hidden folder, "
                        "not deleted.\n\nExample:\n  nazori-cli study profiles --rename learner Mari");
  verb->add_option("--rename", asked->rename, "Old and new name")->expected(2)->type_name("NAME");
  verb->add_option("--remove", asked->remove, "Remove this profile")->type_name("NAME");
  add_writer_options(*verb, asked->options);
  verb->callback(
      [asked, &chosen] { chosen = [asked](Console& console) { return profiles(console, *asked); }; });
}

}  // namespace nazori::cli
