#include "engine/io/text_scanner.h"

#include <algorithm>

#include "engine/core/text.h"

namespace sinew {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }
bool is_brace(char c) { return c == '{' || c == '}'; }

}  // namespace

Word TextScanner::next() {
  while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '\n')) {
    if (text_[at_] == '\n' || (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n')) {
      ++line_;
      line_start_ = at_ + 1;
    }
    ++at_;
  }
  const std::size_t start = at_;
  if (at_ < text_.size() && is_brace(text_[at_])) {
    ++at_;
  } else {
    while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '\n' && !is_brace(text_[at_])) ++at_;
  }
  const std::string_view before = text_.substr(line_start_, start - line_start_);
  return {text_.substr(start, at_ - start), line_, start - line_start_ + 1,
          std::all_of(before.begin(), before.end(), is_blank)};
}

Word TextScanner::peek() const { return TextScanner(*this).next(); }

Word TextScanner::rest_of_line() {
  const auto ends = [&](char c) { return c == '\n' || c == '\r' || c == '#' || is_brace(c); };
  while (at_ < text_.size() && text_[at_] != '\r' && is_blank(text_[at_])) ++at_;
  const std::size_t start = at_;
  while (at_ < text_.size() && !ends(text_[at_])) ++at_;
  std::size_t end = at_;
  while (end > start && is_blank(text_[end - 1])) --end;
  return {text_.substr(start, end - start), line_, start - line_start_ + 1, false};
}

void TextScanner::skip_line() {
  while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
}

Result<double> TextScanner::number(std::string_view what) {
  const Word word = next();
  const auto value = parse_number(word.text);
  if (!value) return wrong(word, fmt::format("a number, {}", what));
  return *value;
}

Result<Vec3> TextScanner::vec3(std::string_view what) {
  Vec3 v;
  for (int i = 0; i < 3; ++i) {
    auto value = number(what);
    if (!value) return pass_on(std::move(value));
    v[i] = *value;
  }
  return v;
}

tl::unexpected<Error> TextScanner::wrong(const Word& word, std::string_view expected) const {
  return error(word, fmt::format("expected {}, found {}", expected,
                                 word.end() ? "the end of the file: it is cut off" : in_quotes(word.text)));
}

tl::unexpected<Error> TextScanner::error(const Word& at, std::string_view what) const {
  return bad_input("{}:{}:{}: {}", name_, at.line, at.column, what);
}

Result<std::string_view> as_text(const Bytes& bytes, std::string_view name, std::string_view expected) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::size_t line = 1, start = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      ++line;
      start = i + 1;
    } else if (static_cast<unsigned char>(c) < 0x20 && !is_blank(c)) {
      return bad_input("{}:{}:{}: expected {}, which is text; found the byte 0x{:02x}", name, line, i - start + 1,
                       expected, static_cast<unsigned char>(c));
    }
  }
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return text;
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string out(word.substr(0, longest));
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  return word.size() > longest ? fmt::format("\"{}...\"", out) : fmt::format("\"{}\"", out);
}

}  // namespace sinew
