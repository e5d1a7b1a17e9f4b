#pragma once
/// Words of a text file, with the line and column of each, for formats that are lines of words and numbers.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/files.h"
#include "engine/core/math.h"
#include "engine/core/result.h"

namespace sinew {

/// A word and its place, counted from 1; an empty text is the end of the file.
struct Word {
  std::string_view text;
  std::size_t line = 1, column = 1;
  bool first_of_line = false;  ///< only blanks stand before it in its line

  bool end() const { return text.empty(); }
};

/// Goes through a text word by word; blanks and line ends of any kind lie between words. Braces are words of their own.
class TextScanner {
 public:
  /// Both outlive the scanner. `name` is the file's, for messages.
  TextScanner(std::string_view text, std::string_view name) : text_(text), name_(name) {}

  /// The next word, taken or only looked at.
  Word next();
  Word peek() const;
  /// What is left of the line up to a brace or a comment ('#'), blanks at both ends cut off, and taken.
  Word rest_of_line();
  /// Passes over what is left of the line.
  void skip_line();

  /// The next word as a finite number, or as a whole one.
  Result<double> number(std::string_view what);
  Result<Vec3> vec3(std::string_view what);

  /// "FILE:LINE:COLUMN: ..., found ...": an error about a word.
  tl::unexpected<Error> wrong(const Word& word, std::string_view expected) const;
  /// "FILE:LINE:COLUMN: ...".
  tl::unexpected<Error> error(const Word& at, std::string_view what) const;

 private:
  std::string_view text_, name_;
  std::size_t at_ = 0, line_ = 1, line_start_ = 0;
};

/// The bytes as text. Fails as bad_input, with the place, where they hold what no text has: it is another kind of file.
Result<std::string_view> as_text(const Bytes& bytes, std::string_view name, std::string_view expected);

/// A word for messages: quoted, cut short, without control characters.
std::string in_quotes(std::string_view word);

}  // namespace sinew
