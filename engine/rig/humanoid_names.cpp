#include "engine/rig/humanoid_names.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/text.h"

namespace sinew {
namespace {

struct Word {
  std::string_view text;  ///< letters and numbers run together, lower case, numbers without leading zeros
  BodyPart part;
  int doubt = 0;
};

constexpr Word middle_words[] = {
    {"hips", BodyPart::hips},          {"hip", BodyPart::hips},
    {"pelvis", BodyPart::hips},        {"humanoidroot", BodyPart::hips},
    {"sacroiliac", BodyPart::hips, 1}, {"root", BodyPart::hips, 3},
    {"spine", BodyPart::spine},        {"tospine", BodyPart::spine},
    {"lowerspine", BodyPart::spine},   {"spinelower", BodyPart::spine},
    {"spinemid", BodyPart::spine},     {"upperspine", BodyPart::spine},
    {"spineupper", BodyPart::spine},   {"chest", BodyPart::spine},
    {"upperchest", BodyPart::spine},   {"chestlower", BodyPart::spine},
    {"chestupper", BodyPart::spine},   {"thorax", BodyPart::spine},
    {"torso", BodyPart::spine},        {"abdomen", BodyPart::spine},
    {"abdomenlower", BodyPart::spine}, {"abdomenupper", BodyPart::spine},
    {"waist", BodyPart::spine},        {"back", BodyPart::spine},
    {"lowerback", BodyPart::spine},    {"upperback", BodyPart::spine},
    {"ribcage", BodyPart::spine},      {"vl", BodyPart::spine},
    {"vt", BodyPart::spine},           {"neck", BodyPart::neck},
    {"necktwist", BodyPart::neck},     {"necklower", BodyPart::neck},
    {"neckupper", BodyPart::neck},     {"lowerneck", BodyPart::neck},
    {"upperneck", BodyPart::neck},     {"vc", BodyPart::neck},
    {"head", BodyPart::head},          {"skullbase", BodyPart::head},
    {"skull", BodyPart::head, 1},      {"jaw", BodyPart::jaw},
    {"lowerjaw", BodyPart::jaw},       {"jawroot", BodyPart::jaw},
    {"mandible", BodyPart::jaw},       {"temporomandibular", BodyPart::jaw},
};

constexpr Word sided_words[] = {
    {"eye", BodyPart::eye},
    {"eyeball", BodyPart::eye},
    {"clavicle", BodyPart::clavicle},
    {"collar", BodyPart::clavicle},
    {"collarbone", BodyPart::clavicle},
    {"sternoclavicular", BodyPart::clavicle},
    {"acromioclavicular", BodyPart::clavicle, 1},
    {"shoulder", BodyPart::clavicle_or_upper_arm},
    {"upperarm", BodyPart::upper_arm},
    {"upperarm1", BodyPart::upper_arm},
    {"uparm", BodyPart::upper_arm},
    {"armupper", BodyPart::upper_arm},
    {"arm", BodyPart::upper_arm, 1},
    {"humerus", BodyPart::upper_arm},
    {"shldr", BodyPart::upper_arm},
    {"shldrbend", BodyPart::upper_arm},
    {"lowerarm", BodyPart::lower_arm},
    {"lowerarm1", BodyPart::lower_arm},
    {"lowarm", BodyPart::lower_arm},
    {"armlower", BodyPart::lower_arm},
    {"forearm", BodyPart::lower_arm},
    {"forearmbend", BodyPart::lower_arm},
    {"elbow", BodyPart::lower_arm, 1},
    {"radius", BodyPart::lower_arm},
    {"hand", BodyPart::hand},
    {"radiocarpal", BodyPart::hand},
    {"wrist", BodyPart::hand, 1},
    {"palm", BodyPart::hand, 1},
    {"upperleg", BodyPart::upper_leg},
    {"upperleg1", BodyPart::upper_leg},
    {"upleg", BodyPart::upper_leg},
    {"legupper", BodyPart::upper_leg},
    {"thigh", BodyPart::upper_leg},
    {"thighbend", BodyPart::upper_leg},
    {"femur", BodyPart::upper_leg},
    {"hip", BodyPart::upper_leg, 1},
    {"leg", BodyPart::upper_or_lower_leg},
    {"lowerleg", BodyPart::lower_leg},
    {"lowerleg1", BodyPart::lower_leg},
    {"lowleg", BodyPart::lower_leg},
    {"leglower", BodyPart::lower_leg},
    {"shin", BodyPart::lower_leg},
    {"calf", BodyPart::lower_leg},
    {"tibia", BodyPart::lower_leg},
    {"knee", BodyPart::lower_leg, 1},
    {"foot", BodyPart::foot},
    {"talocrural", BodyPart::foot},
    {"ankle", BodyPart::foot, 1},
    {"toes", BodyPart::toes},
    {"toe", BodyPart::toes},
    {"toebase", BodyPart::toes},
    {"toe0", BodyPart::toes},
    {"toe1-1", BodyPart::toes},
    {"ball", BodyPart::toes},
    {"forefoot", BodyPart::toes},
    {"metatarsophalangeal", BodyPart::toes},
    {"metatarsal", BodyPart::toes, 2},
    {"metatarsals", BodyPart::toes, 2},
    {"tarsometatarsal", BodyPart::toes, 3},
    {"midtarsal", BodyPart::toes, 3},
};

constexpr Word finger_words[] = {
    {"thumb", BodyPart::thumb}, {"index", BodyPart::index},  {"middle", BodyPart::middle}, {"mid", BodyPart::middle},
    {"ring", BodyPart::ring},   {"pinky", BodyPart::little}, {"little", BodyPart::little},
};

/// In H-Anim, MakeHuman and Biped a finger is a number, from the thumb.
constexpr BodyPart numbered_fingers[] = {BodyPart::thumb, BodyPart::index, BodyPart::middle, BodyPart::ring,
                                         BodyPart::little};

/// Stand before the name proper; a number behind one of them ("Bip01", "mixamorig2") belongs to it.
constexpr std::string_view prefixes[] = {"mixamorig", "bip", "biped", "valve", "def",  "org",      "cc",
                                         "base",      "b",   "j",     "c",     "f",    "skeleton", "armature",
                                         "bone",      "jnt", "joint", "rig",   "bind", "character"};
constexpr std::string_view suffixes[] = {"joint", "jnt", "bone", "bind"};

bool contains(std::span<const std::string_view> words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

const Word* find_word(std::span<const Word> words, std::string_view text) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const Word& word) { return word.text == text; });
  return found == words.end() ? nullptr : &*found;
}

/// A run of letters of one word, or of digits.
struct Token {
  std::string text;  ///< lower case
  bool number = false;
  bool separated = false;  ///< something that is neither letter nor digit stands before it
};

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return is_upper(c) || is_lower(c); }

/// "LeftUpLeg" has three words, "LHipJoint" too, "kneeIK" two.
bool word_starts_at(std::string_view name, std::size_t i) {
  const char before = name[i - 1], here = name[i];
  if (is_digit(before) != is_digit(here)) return true;
  if (is_lower(before) && is_upper(here)) return true;
  return is_upper(before) && is_upper(here) && i + 1 < name.size() && is_lower(name[i + 1]);
}

std::vector<Token> tokenize(std::string_view name) {
  std::vector<Token> tokens;
  bool separated = true;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_letter(name[i]) && !is_digit(name[i])) {
      separated = true;
      continue;
    }
    if (separated || word_starts_at(name, i)) tokens.push_back({"", is_digit(name[i]), separated});
    tokens.back().text += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
    separated = false;
  }
  return tokens;
}

/// Takes the word for the side out of the tokens. Nothing where both sides are named.
std::optional<Side> take_side(std::vector<Token>& tokens) {
  Side side = Side::middle;
  for (std::size_t i = 0; i < tokens.size();) {
    const std::string& text = tokens[i].text;
    const Side here = text == "l" || text == "left"    ? Side::left
                      : text == "r" || text == "right" ? Side::right
                                                       : Side::middle;
    if (here == Side::middle) {
      ++i;
      continue;
    }
    if (side != Side::middle && side != here) return std::nullopt;
    side = here;
    tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return side;
}

std::string without_leading_zeros(const std::string& digits) {
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

/// "spine" "05" -> "spine5"; "finger" "1" "1" -> "finger1-1".
std::string join(std::span<const Token> tokens) {
  std::string text;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (i > 0 && tokens[i].number && tokens[i - 1].number) text += '-';
    text += tokens[i].number ? without_leading_zeros(tokens[i].text) : tokens[i].text;
  }
  return text;
}

/// A name's letters and the number behind them, if it has just one and there.
struct NumberedWord {
  std::string letters;
  int number = -1;
};

NumberedWord split_number(const std::string& text) {
  const std::size_t digits = std::min(text.find_first_of("0123456789"), text.size());
  const auto number = parse_integer(std::string_view(text).substr(digits));
  if (!number || *number > 99) return {text, -1};
  return {text.substr(0, digits), static_cast<int>(*number)};
}

NameReading finger_reading(BodyPart finger, int ordinal, const std::string& word) {
  return {finger, Side::middle, ordinal, 0, false, word};
}

/// "indexproximal": VRM and Unity. A thumb's "proximal" is its first joint in VRM 0 and its second in VRM 1; counting
/// from 2 leaves that to the chain.
std::optional<NameReading> read_named_finger_joint(const std::string& text) {
  static constexpr std::pair<std::string_view, int> joints[] = {
      {"metacarpal", 0}, {"proximal", 1}, {"intermediate", 2}, {"distal", 3}};
  for (const Word& finger : finger_words) {
    if (!text.starts_with(finger.text)) continue;
    for (const auto& [joint, ordinal] : joints)
      if (std::string_view(text).substr(finger.text.size()) == joint)
        return finger_reading(finger.part, ordinal + (finger.part == BodyPart::thumb ? 1 : 0), text);
  }
  return std::nullopt;
}

/// "metacarpophalangeal2": H-Anim counts the fingers, and the thumb has one joint name of its own.
std::optional<NameReading> read_anatomical_finger_joint(const NumberedWord& word) {
  static constexpr std::pair<std::string_view, int> joints[] = {{"carpometacarpal", 0},
                                                                {"metacarpophalangeal", 1},
                                                                {"carpalinterphalangeal", 2},
                                                                {"carpalproximalinterphalangeal", 2},
                                                                {"carpaldistalinterphalangeal", 3}};
  if (word.number < 1 || word.number > 5) return std::nullopt;
  for (const auto& [joint, ordinal] : joints)
    if (word.letters == joint)
      return finger_reading(numbered_fingers[word.number - 1], ordinal + (word.number == 1 ? 1 : 0), word.letters);
  return std::nullopt;
}

std::optional<NameReading> read_finger(const std::string& text) {
  const std::string bare = text.starts_with("hand") ? text.substr(4) : text;
  if (auto named = read_named_finger_joint(bare)) return named;
  if (bare.size() == 9 && bare.starts_with("finger") && bare[7] == '-' && bare[6] >= '1' && bare[6] <= '5' &&
      is_digit(bare[8]))
    return finger_reading(numbered_fingers[bare[6] - '1'], bare[8] - '0', "finger");
  const NumberedWord word = split_number(bare);
  if (auto anatomical = read_anatomical_finger_joint(word)) return anatomical;
  const Word* finger = find_word(finger_words, word.letters);
  if (finger == nullptr || word.number < 0 || word.number > 4) return std::nullopt;
  return finger_reading(finger->part, word.number, word.letters);
}

/// Biped: "Finger0" "Finger01" "Finger02" is the thumb, "Finger1" "Finger11" "Finger12" the index finger, and so on.
std::optional<NameReading> read_biped_finger(std::span<const Token> tokens) {
  if (tokens.size() != 2 || tokens[0].text != "finger" || !tokens[1].number) return std::nullopt;
  const std::string& digits = tokens[1].text;
  if (digits.size() > 2 || digits[0] > '4') return std::nullopt;
  return finger_reading(numbered_fingers[digits[0] - '0'], digits.size() == 1 ? 1 : digits[1] - '0' + 1, "finger");
}

std::optional<NameReading> read_sided(const std::string& text, Side side) {
  std::optional<NameReading> reading;
  if (const Word* word = find_word(sided_words, text))
    reading = NameReading{word->part, side, 0, word->doubt, false, text};
  else
    reading = read_finger(text);
  if (reading) reading->side = side;
  return reading;
}

std::optional<NameReading> read_middle(const std::string& text) {
  if (const Word* word = find_word(middle_words, text))
    return NameReading{word->part, Side::middle, 0, word->doubt, false, text};
  const NumberedWord numbered = split_number(text);
  const Word* word = numbered.number >= 0 ? find_word(middle_words, numbered.letters) : nullptr;
  if (word == nullptr || (word->part != BodyPart::spine && word->part != BodyPart::neck)) return std::nullopt;
  return NameReading{word->part, Side::middle, 0, word->doubt, false, numbered.letters};
}

/// A side that runs into its word: "lfemur", "lefthand", "handright".
std::optional<NameReading> read_glued_side(const std::string& text) {
  static constexpr std::pair<std::string_view, Side> sides[] = {
      {"left", Side::left}, {"right", Side::right}, {"l", Side::left}, {"r", Side::right}};
  for (const auto& [word, side] : sides) {
    if (text.starts_with(word))
      if (auto reading = read_sided(text.substr(word.size()), side)) return reading;
    if (word.size() > 1 && text.ends_with(word))
      if (auto reading = read_sided(text.substr(0, text.size() - word.size()), side)) return reading;
  }
  return std::nullopt;
}

std::optional<NameReading> look_up(std::span<const Token> tokens, Side side, bool biped) {
  if (biped && side != Side::middle)
    if (auto finger = read_biped_finger(tokens)) {
      finger->side = side;
      return finger;
    }
  const std::string text = join(tokens);
  if (side != Side::middle) return read_sided(text, side);
  if (auto reading = read_middle(text)) return reading;
  return read_glued_side(text);
}

/// Tries the whole, then without counters ("_013") and words that say nothing ("joint") at the end.
std::optional<NameReading> read_tokens(std::span<const Token> tokens, Side side, bool biped) {
  int doubt = 0;
  bool counted = false;
  while (!tokens.empty()) {
    if (auto reading = look_up(tokens, side, biped)) {
      reading->doubt += doubt;
      reading->counted = counted;
      return reading;
    }
    const Token& last = tokens.back();
    if (last.number && last.separated) {
      counted = true;
      doubt += 2;
    } else if (!last.number && contains(suffixes, last.text)) {
      doubt += 1;
    } else {
      return std::nullopt;
    }
    tokens = tokens.first(tokens.size() - 1);
  }
  return std::nullopt;
}

}  // namespace

std::optional<NameReading> read_joint_name(std::string_view name) {
  if (const std::size_t space = name.find_last_of(":|"); space != std::string_view::npos) name.remove_prefix(space + 1);
  std::vector<Token> tokens = tokenize(name);
  const auto side = take_side(tokens);
  if (!side) return std::nullopt;
  std::span<const Token> rest = tokens;
  bool biped = false;
  int doubt = 0;
  while (!rest.empty()) {
    if (auto reading = read_tokens(rest, *side, biped)) {
      reading->doubt += doubt;
      return reading;
    }
    if (!contains(prefixes, rest.front().text)) return std::nullopt;
    if (rest.front().text == "bip") biped = true;
    if (rest.front().text == "org") doubt += 4;  // Rigify: the deform bone DEF-x moves the skin, ORG-x only leads it
    do rest = rest.subspan(1);
    while (!rest.empty() && rest.front().number);
  }
  return std::nullopt;
}

}  // namespace sinew
