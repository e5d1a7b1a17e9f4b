#include <map>

#include "engine/core/euler.h"
#include "engine/core/text.h"
#include "engine/io/acclaim.h"
#include "engine/io/motion_limits.h"
#include "engine/io/text_scanner.h"

namespace sinew {
namespace {

/// A bone as it is written; angles in the file's unit until the end.
struct Bone {
  std::string name;
  Vec3 direction{0.0};
  double length = 0.0;
  Vec3 axis{0.0};
  EulerOrder axis_order{2, 1, 0};
  std::vector<AcclaimDof> dof;
  int parent = -2;  ///< -2: not in the hierarchy yet
  Word place;
};

std::optional<AcclaimDof> dof_of(std::string_view word) {
  static constexpr std::string_view names[] = {"tx", "ty", "tz", "rx", "ry", "rz", "l"};
  const std::string wanted = lower(word);
  for (std::size_t i = 0; i < std::size(names); ++i)
    if (names[i] == wanted) return static_cast<AcclaimDof>(i);
  return std::nullopt;
}

/// "XYZ": x first, so that as columns it is Rz Ry Rx.
std::optional<EulerOrder> axis_order(std::string_view word) {
  EulerOrder order{};
  bool seen[3] = {};
  if (word.size() != 3) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = lower(word)[i] - 'x';
    if (axis < 0 || axis > 2 || seen[axis]) return std::nullopt;
    seen[axis] = true;
    order[2 - i] = axis;
  }
  return order;
}

class AsfReader {
 public:
  AsfReader(std::string_view text, std::string_view name) : scanner_(text, name) {
    bones_.push_back({.name = "root", .dof = {}, .parent = -1, .place = {}});
    index_["root"] = 0;
  }

  Result<AcclaimSkeleton> read() {
    for (Word word = scanner_.next(); !word.end(); word = scanner_.next()) {
      if (word.text.starts_with('#')) {
        scanner_.skip_line();
        continue;
      }
      if (!word.text.starts_with(':')) return scanner_.wrong(word, "a section such as \":bonedata\"");
      const std::string section = lower(word.text.substr(1));
      Result<void> ok;
      if (section == "units") {
        ok = read_units();
      } else if (section == "root") {
        ok = read_root();
      } else if (section == "bonedata") {
        ok = read_bones();
      } else if (section == "hierarchy") {
        ok = read_hierarchy();
      } else {
        skip_section();
      }
      if (!ok) return pass_on(std::move(ok));
    }
    return finish();
  }

 private:
  bool at_section() const {
    const Word word = scanner_.peek();
    return word.end() || (word.first_of_line && word.text.starts_with(':'));
  }

  void skip_section() {
    scanner_.skip_line();
    while (!at_section()) {
      scanner_.next();
      scanner_.skip_line();
    }
  }

  Result<void> read_units() {
    while (!at_section()) {
      const Word key = scanner_.next();
      if (key.text == "angle") {
        const Word unit = scanner_.next();
        if (!lower(unit.text).starts_with("deg") && !lower(unit.text).starts_with("rad"))
          return scanner_.wrong(unit, "deg or rad");
        out_.degrees = lower(unit.text).starts_with("deg");
      } else if (key.text == "length") {
        const Word word = scanner_.peek();
        auto length = scanner_.number("the unit of lengths");
        if (!length) return pass_on(std::move(length));
        if (!(*length > 0.0)) return scanner_.wrong(word, "a length above 0");
        constexpr double inch = 0.0254;
        out_.skeleton.metres_per_unit = inch / *length;
      } else {
        scanner_.skip_line();
      }
    }
    return {};
  }

  Result<void> read_axis_order(Bone& bone) {
    const Word word = scanner_.next();
    const auto order = axis_order(word.text);
    if (!order) return scanner_.wrong(word, "an order of axes such as XYZ");
    bone.axis_order = *order;
    return {};
  }

  Result<void> read_dof(Bone& bone) {
    bone.dof.clear();
    while (!scanner_.peek().first_of_line && !scanner_.peek().end()) {
      const Word word = scanner_.next();
      const auto dof = dof_of(word.text);
      if (!dof) return scanner_.wrong(word, "a degree of freedom: rx, ry, rz, tx, ty, tz or l");
      if (bone.dof.size() >= 7) return scanner_.error(word, "more degrees of freedom than there are");
      bone.dof.push_back(*dof);
    }
    return {};
  }

  Result<void> read_root() {
    while (!at_section()) {
      const Word key = scanner_.next();
      Result<void> ok;
      if (key.text == "order") {
        ok = read_dof(bones_[0]);
      } else if (key.text == "axis") {
        ok = read_axis_order(bones_[0]);
      } else if (key.text == "position" || key.text == "orientation") {
        auto value = scanner_.vec3("of the root's three");
        if (!value) return pass_on(std::move(value));
        (key.text == "position" ? root_position_ : bones_[0].axis) = *value;
      } else {
        scanner_.skip_line();
      }
      if (!ok) return ok;
    }
    return {};
  }

  Result<void> read_bones() {
    while (!at_section()) {
      const Word word = scanner_.next();
      if (word.text != "begin") return scanner_.wrong(word, "\"begin\" of a bone");
      if (bones_.size() >= most_motion_joints)
        return scanner_.error(word, fmt::format("more than {} bones, which no body has", most_motion_joints));
      if (auto ok = read_bone(word); !ok) return ok;
    }
    return {};
  }

  Result<void> read_bone(const Word& begin) {
    Bone bone;
    bone.place = begin;
    while (true) {
      const Word key = scanner_.next();
      if (key.text == "end") break;
      if (key.end()) return scanner_.wrong(key, "\"end\" of a bone");
      Result<void> ok;
      if (key.text == "name") {
        bone.place = scanner_.next();
        bone.name = bone.place.text;
      } else if (key.text == "direction") {
        auto value = scanner_.vec3("of a direction's three");
        if (!value) return pass_on(std::move(value));
        bone.direction = unit_or(*value, Vec3(0.0));
      } else if (key.text == "length") {
        auto value = scanner_.number("the bone's length");
        if (!value) return pass_on(std::move(value));
        bone.length = *value;
      } else if (key.text == "axis") {
        auto value = scanner_.vec3("of an axis' three");
        if (!value) return pass_on(std::move(value));
        bone.axis = *value;
        ok = read_axis_order(bone);
      } else if (key.text == "dof") {
        ok = read_dof(bone);
      } else {
        // id, limits, masses: nothing that moves. Limits go on in lines that begin with a bracket.
        scanner_.skip_line();
        while (scanner_.peek().text.starts_with('(')) {
          scanner_.next();
          scanner_.skip_line();
        }
      }
      if (!ok) return ok;
    }
    if (bone.name.empty()) return scanner_.error(begin, "a bone without a name");
    if (!index_.emplace(bone.name, static_cast<int>(bones_.size())).second)
      return scanner_.error(bone.place, fmt::format("a second bone {}", in_quotes(bone.name)));
    bones_.push_back(std::move(bone));
    return {};
  }

  Result<int> find_bone(const Word& word) const {
    const auto found = index_.find(std::string(word.text));
    if (found != index_.end()) return found->second;
    std::vector<std::string> names;
    for (const Bone& bone : bones_) names.push_back(bone.name);
    return scanner_.error(word, fmt::format("no bone {}{}", in_quotes(word.text), did_you_mean(word.text, names)));
  }

  Result<void> read_hierarchy() {
    const Word begin = scanner_.next();
    if (begin.text != "begin") return scanner_.wrong(begin, "\"begin\" of the hierarchy");
    for (Word word = scanner_.next(); word.text != "end"; word = scanner_.next()) {
      if (word.end()) return scanner_.wrong(word, "\"end\" of the hierarchy");
      auto parent = find_bone(word);
      if (!parent) return pass_on(std::move(parent));
      while (!scanner_.peek().first_of_line && !scanner_.peek().end()) {
        const Word child_word = scanner_.next();
        auto child = find_bone(child_word);
        if (!child) return pass_on(std::move(child));
        Bone& bone = bones_[static_cast<std::size_t>(*child)];
        if (bone.parent != -2)
          return scanner_.error(child_word, fmt::format("the bone {} has a parent already", in_quotes(bone.name)));
        bone.parent = *parent;
      }
    }
    return {};
  }

  /// The bones that hang from the root, parents first.
  Result<std::vector<int>> parents_first() const {
    std::vector<std::vector<int>> children(bones_.size());
    for (std::size_t b = 1; b < bones_.size(); ++b)
      if (bones_[b].parent >= 0) children[static_cast<std::size_t>(bones_[b].parent)].push_back(static_cast<int>(b));
    std::vector<int> order{0};
    std::vector<std::size_t> depth(bones_.size(), 1);
    for (std::size_t i = 0; i < order.size(); ++i)
      for (const int child : children[static_cast<std::size_t>(order[i])]) {
        const auto c = static_cast<std::size_t>(child);
        depth[c] = depth[static_cast<std::size_t>(order[i])] + 1;
        if (depth[c] > deepest_motion_joint)
          return scanner_.error(bones_[c].place,
                                fmt::format("more than {} bones hang from one another", deepest_motion_joint));
        order.push_back(child);
      }
    if (order.size() == bones_.size()) return order;
    std::vector<bool> reached(bones_.size(), false);
    for (const int b : order) reached[static_cast<std::size_t>(b)] = true;
    const auto lost = static_cast<std::size_t>(std::find(reached.begin(), reached.end(), false) - reached.begin());
    return scanner_.error(
        bones_[lost].place,
        fmt::format("the bone {} does not hang from the root: the hierarchy {}", in_quotes(bones_[lost].name),
                    bones_[lost].parent == -2 ? "does not name it" : "runs in a circle"));
  }

  Result<AcclaimSkeleton> finish() {
    if (bones_.size() == 1) return scanner_.error(scanner_.peek(), "has no bones: expected a section \":bonedata\"");
    auto order = parents_first();
    if (!order) return pass_on(std::move(order));
    const double unit = out_.degrees ? degrees_to_radians : 1.0;
    std::vector<int> place(bones_.size(), -1);
    std::vector<bool> leaf(bones_.size(), true);
    for (const int b : *order) {
      const Bone& bone = bones_[static_cast<std::size_t>(b)];
      MotionJoint joint;
      joint.name = bone.name;
      if (b == 0) {
        joint.offset = root_position_;
      } else {
        const Bone& parent = bones_[static_cast<std::size_t>(bone.parent)];
        leaf[static_cast<std::size_t>(bone.parent)] = false;
        joint.parent = place[static_cast<std::size_t>(bone.parent)];
        joint.offset = parent.direction * parent.length;
      }
      place[static_cast<std::size_t>(b)] = static_cast<int>(out_.skeleton.joints.size());
      out_.skeleton.joints.push_back(std::move(joint));
      out_.dof.push_back(bone.dof);
      // Stated in the order of the words, turned in the order of the turns.
      Vec3 angles;
      for (int i = 0; i < 3; ++i) angles[i] = bone.axis[bone.axis_order[static_cast<std::size_t>(i)]] * unit;
      out_.axis.push_back(from_euler(angles, bone.axis_order));
    }
    for (std::size_t b = 1; b < bones_.size(); ++b)
      if (leaf[b])
        out_.skeleton.joints[static_cast<std::size_t>(place[b])].end = bones_[b].direction * bones_[b].length;
    return std::move(out_);
  }

  TextScanner scanner_;
  AcclaimSkeleton out_;
  std::vector<Bone> bones_;
  std::map<std::string, int> index_;
  Vec3 root_position_{0.0};
};

}  // namespace

Result<AcclaimSkeleton> parse_asf(const Bytes& bytes, const std::filesystem::path& file) {
  const std::string name = file.string();
  const auto text = as_text(bytes, name, "an ASF file");
  if (!text) return tl::unexpected<Error>(text.error());
  return AsfReader(*text, name).read();
}

}  // namespace sinew
