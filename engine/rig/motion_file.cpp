#include "engine/rig/motion_file.h"

#include <new>

#include <fmt/ranges.h>

#include "engine/core/text.h"
#include "engine/io/acclaim.h"
#include "engine/io/bvh.h"
#include "engine/io/gltf_read.h"
#include "engine/io/motion_limits.h"
#include "engine/rig/clip_motion.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

std::string_view head_of(std::span<const unsigned char> bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), std::min<std::size_t>(bytes.size(), 4096));
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  return start == std::string_view::npos ? std::string_view() : text.substr(start);
}

Result<std::vector<Motion>> one(Result<Motion>&& motion) {
  if (!motion) return pass_on(std::move(motion));
  std::vector<Motion> motions;
  motions.push_back(std::move(*motion));
  return motions;
}

Result<Motion> read_asf(const fs::path& file, const Bytes& bytes) {
  auto skeleton = parse_asf(bytes, file);
  if (!skeleton) return pass_on(std::move(skeleton));
  Motion motion;
  motion.name = file.stem().string();
  motion.skeleton = std::move(skeleton->skeleton);
  MotionFrame& rest = motion.frames.emplace_back();
  rest.root = motion.skeleton.joints.front().offset;
  rest.rotations.assign(motion.skeleton.joints.size(), Quat(1, 0, 0, 0));
  motion.problems.push_back("an ASF file is a skeleton without a motion: its rest pose is shown");
  return motion;
}

Result<Motion> read_amc(const fs::path& file, const Bytes& bytes) {
  const auto asf = find_asf(bytes, file);
  if (!asf) return tl::unexpected<Error>(asf.error());
  auto asf_bytes = read_file(*asf, largest_motion_file);
  if (!asf_bytes) return pass_on(std::move(asf_bytes));
  auto skeleton = parse_asf(*asf_bytes, *asf);
  if (!skeleton) return pass_on(std::move(skeleton));
  return parse_amc(bytes, file, *skeleton);
}

Result<std::vector<Motion>> read_clips(const fs::path& file, Bytes bytes) {
  auto model = read_gltf(file, std::move(bytes));
  if (!model) return pass_on(std::move(model));
  if (model->clips.empty()) return bad_input("{}: has no animation", file.string());
  std::vector<Motion> motions;
  std::optional<Error> reason;
  for (std::size_t i = 0; i < model->clips.size(); ++i) {
    auto motion = motion_from_clip(*model, model->clips[i]);
    if (!motion) {
      if (!reason) reason = motion.error();
      continue;
    }
    if (motion->name.empty())
      motion->name = file.stem().string() + (model->clips.size() > 1 ? fmt::format("_{}", i) : "");
    motions.push_back(std::move(*motion));
  }
  if (motions.empty()) return tl::unexpected<Error>(*reason);
  return motions;
}

Result<std::vector<Motion>> read_content(const fs::path& file, Bytes bytes) {
  const auto format = motion_format(file, bytes);
  if (!format)
    return bad_input("{}: is no motion file; expected BVH, AMC with its ASF, or glTF or VRM with an animation",
                     file.string());
  switch (*format) {
    case MotionFormat::bvh:
      return one(parse_bvh(bytes, file));
    case MotionFormat::asf:
      return one(read_asf(file, bytes));
    case MotionFormat::amc:
      return one(read_amc(file, bytes));
    case MotionFormat::gltf:
      break;
  }
  return read_clips(file, std::move(bytes));
}

}  // namespace

std::optional<MotionFormat> motion_format(const fs::path& file, std::span<const unsigned char> bytes) {
  const std::string_view head = head_of(bytes);
  const std::string start = lower(head.substr(0, 9)), extension = lower(file.extension().string());
  if (start == "hierarchy") return MotionFormat::bvh;
  if (head.starts_with("glTF") || head.starts_with("{")) return MotionFormat::gltf;
  const std::string whole = lower(head);
  if (whole.find("\n:bonedata") != std::string::npos || whole.find("\n:units") != std::string::npos)
    return MotionFormat::asf;
  if (whole.find(":fully-specified") != std::string::npos) return MotionFormat::amc;
  if (extension == ".bvh") return MotionFormat::bvh;
  if (extension == ".asf") return MotionFormat::asf;
  if (extension == ".amc") return MotionFormat::amc;
  if (extension == ".glb" || extension == ".gltf" || extension == ".vrma" || extension == ".vrm")
    return MotionFormat::gltf;
  return std::nullopt;
}

Result<std::vector<Motion>> read_motions(const fs::path& file) {
  auto bytes = read_file(file, largest_motion_file);
  if (!bytes) return pass_on(std::move(bytes));
  return read_motions(file, std::move(*bytes));
}

Result<std::vector<Motion>> read_motions(const fs::path& file, Bytes bytes) {
  try {
    return read_content(file, std::move(bytes));
  } catch (const std::bad_alloc&) {
    return bad_input("{}: there is not enough memory to read it", file.string());
  }
}

Result<Motion> read_motion(const fs::path& file, const std::string& clip) {
  auto motions = read_motions(file);
  if (!motions) return pass_on(std::move(motions));
  if (clip.empty()) return std::move(motions->front());
  std::vector<std::string> names;
  for (Motion& motion : *motions) {
    if (motion.name == clip) return std::move(motion);
    names.push_back(motion.name);
  }
  return bad_input("{}: has no clip \"{}\"{}; it has {}", file.string(), clip, did_you_mean(clip, names),
                   fmt::join(names, ", "));
}

}  // namespace sinew
