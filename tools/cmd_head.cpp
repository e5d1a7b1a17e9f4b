#include <iostream>

#include <spdlog/spdlog.h>

#include "engine/core/files.h"
#include "engine/core/text.h"
#include "engine/deform/face.h"
#include "engine/face/head.h"
#include "engine/face/head_model.h"
#include "engine/io/gltf_write.h"
#include "tools/command.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  std::string output, age = "adult", skull;
  std::vector<std::string> measures, channels;
  int level = default_head_level;
};

Result<void> head(const Words& words) {
  auto age = parse_age(words.age);
  if (!age) return pass_on(std::move(age));
  HeadMeasures m = measures_of_age(*age);
  if (!words.skull.empty()) {
    auto s = parse_skull(words.skull);
    if (!s) return pass_on(std::move(s));
    apply_skull(*s, m);
  }
  for (const auto& text : words.measures)
    if (auto ok = apply_measure(text, m); !ok) return ok;
  auto made = HeadMaker(words.level).head(m);
  if (!made) return pass_on(std::move(made));
  FaceChannels c{};
  for (const auto& w : words.channels) {
    auto p = split(w, '=');
    for (size_t i = 0; i < face_channels; ++i) {
      auto n = face_channel_names()[i];
      std::string full = std::string(n.region) + (*n.number ? std::string(".") + n.number : "");
      if (full == p[0]) c[i] = *parse_number(p[1]);
    }
  }
  HeldFace held = hold_at_limits(made->face, c);
  for (auto& h : held.held) std::cerr << "held " << int(h.channel) << " " << h.asked << " -> " << h.held << "\n";
  HeadShape base{"", posed_positions(*made, held.channels), {}};
  base.normals = head_normals(*made, base.positions);
  const auto bytes = rig_glb(head_model(*made, &base, {}));
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  std::cout << made->positions.size() << " vertices " << made->triangles.size() << "\n";
  for (auto& [n, v] : made->landmarks) std::cout << n << " " << made->positions[v].y << " " << made->positions[v].x << "\n";
  return write_file(words.output, *bytes);
}

}  // namespace

void add_head(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("head", "A head from drawing rules");
  auto words = std::make_shared<Words>();
  command->add_option("-o,--output", words->output, "x.glb")->required();
  command->add_option("--age", words->age, "");
  command->add_option("--skull", words->skull, "");
  command->add_option("--measure", words->measures, "");
  command->add_option("--channel", words->channels, "");
  command->add_option("--level", words->level, "");
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return head(*words); }; });
}

}  // namespace sinew::tools
