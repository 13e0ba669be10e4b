// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/practice/stage_table.h"
#include "nazori/practice/writing_attempt.h"

namespace nazori::practice {

/// Dictation: a word that has the character is asked for by its reading and its meaning, and written whole
/// from memory, one character after another on an empty tablet. Each is judged stroke by stroke as in
/// MemoryStage; what is right goes on to the next character by itself. At the end there is a verdict for the
/// word. While the learner looks at something else the word is kept.
class DictationStage final : public PracticeStage {
 public:
  static constexpr std::string_view kId = "dictation";

  // What only it reports.
  static constexpr std::string_view kWordAsked = "word_asked";  ///< count: of characters
  static constexpr std::string_view kNoWord = "no_word";  ///< the character has none that can be asked for
  static constexpr std::string_view kCharacterWritten =
      "character_written";                                        ///< stroke: which, other: the next
  static constexpr std::string_view kWordJudged = "word_judged";  ///< count: of characters
  static constexpr std::string_view kWordOver = "word_over";      ///< something is written after the verdict
  static constexpr std::string_view kSpeechWanted = "speech_wanted";  ///< the learner wants to hear the word

  enum class State : std::uint8_t {
    unavailable,  ///< there is no word to write
    coming,       ///< the characters of the word are being looked up
    writing,
    judged,  ///< the word has its verdict
  };
  /// A character of the word.
  struct Box {
    char32_t character = 0;
    Tablet model;
    WritingAttempt::Content writing;  ///< of a character that is finished or put aside
    bool is_finished = false;
    bool was_shown = false;  ///< the learner asked for the answer
    int hints = 0;
    char32_t other = 0;  ///< the other character that was written; 0: none is known
    /// Written from memory, and accepted.
    [[nodiscard]] bool is_accepted() const { return is_finished && writing.grade.accepted && !was_shown; }
  };

  explicit DictationStage(const StageParts& parts);

  [[nodiscard]] std::string_view id() const override { return kId; }
  [[nodiscard]] bool can_practise(const StageSubject& subject) const override {
    return subject.sheet != nullptr && !subject.sheet->dictation.empty();
  }
  [[nodiscard]] std::vector<StageCommand> commands() override;
  [[nodiscard]] bool is_busy() const override {
    return is_entered() && (state_ == State::coming || attempt_.is_judging() || attempt_.is_naming());
  }
  [[nodiscard]] StageDetails details(const StageFeedback& what) const override;
  void forget() override;
  [[nodiscard]] bool hides_character() const override;

  /// How strictly what is written from now on is judged, 0..1.
  void set_strictness(double strictness) { attempt_.set_strictness(strictness); }

  // What the learner does.
  /// A stroke as if it had just been written.
  void add_stroke(HandStroke stroke);
  /// Takes back the last stroke; on an empty tablet that of the character before.
  void undo();
  /// Begins the character again, or after the verdict the word.
  void start_over();
  /// The character is finished as it is; after the verdict, another word.
  void finish_writing();
  void give_hint();
  /// Shows the character. The word does not count as written from memory then.
  void show_answer();
  /// Asks for the next of the words that have the character.
  void next_word();
  /// Asks for the word to be spoken: emits `speech_wanted` and reports the question again.
  void speak();

  [[nodiscard]] State state() const { return state_; }
  /// The word that is asked for; nullptr where there is none.
  [[nodiscard]] const DictationWord* word() const { return words_.empty() ? nullptr : &words_[chosen_]; }
  /// The characters of the word; empty while they are looked up.
  [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }
  /// The one that is being written, or was written last.
  [[nodiscard]] std::size_t position() const { return position_; }
  /// What is on the tablet.
  [[nodiscard]] const WritingAttempt& attempt() const { return attempt_; }
  [[nodiscard]] bool is_accepted() const;
  /// Of the word, 0..100: the mean of its characters.
  [[nodiscard]] int score() const;

  /// The word, in kana, is to be spoken.
  base::Signal<const std::string&> speech_wanted;

 protected:
  void begin() override;
  void end() override;

 private:
  /// Keeps what is written of the present character in its box.
  void put_aside();
  void ask_for(std::size_t word);
  void use_characters(const std::vector<kanji::Character>& characters);
  void open(std::size_t position);
  /// Goes back to a character that was finished.
  void reopen(std::size_t position);
  void use_check(bool is_about_new);
  void use_other(char32_t written, char32_t asked, bool was_finished);
  void finish_character();
  void finish_word();
  void set_state(State state);
  void report_own(std::string_view what, Tone tone, int count = 0);
  void show_writing();

  CharacterLibrary& library_;
  std::function<bool(char32_t)> knows_;
  WritingAttempt attempt_;
  State state_ = State::unavailable;
  char32_t character_ = 0;  ///< whose words are asked for
  std::vector<DictationWord> words_;
  std::size_t chosen_ = 0;
  std::vector<Box> boxes_;
  std::size_t position_ = 0;
  base::Connection characters_ready_;
};

}  // namespace nazori::practice
