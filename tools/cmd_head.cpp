#include <iostream>

#include <spdlog/spdlog.h>

#include "engine/core/files.h"
#include "engine/core/interrupt.h"
#include "engine/core/text.h"
#include "engine/face/expression.h"
#include "engine/face/half_head.h"
#include "engine/face/head_shapes.h"
#include "engine/face/head_write.h"
#include "engine/face/model_face.h"
#include "engine/io/gltf_write.h"
#include "engine/io/obj_model.h"
#include "tools/command.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  std::string output, measures, save_measures, half, on, landmarks, save_landmarks;
  std::optional<std::string> age, skull;
  std::vector<std::string> measure, expression, region;
  std::optional<int> level;
  bool strict = false;
};

Result<void> check_words(const Words& words) {
  if (lower(std::filesystem::path(words.output).extension().string()) != ".glb")
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .glb", words.output);
  if (words.level && (*words.level < 0 || *words.level > most_head_level))
    return failure(ErrorKind::usage, "--level {}: expected 0 to {}", *words.level, most_head_level);
  if (!words.measures.empty() && words.age)
    return failure(ErrorKind::usage, "--age beside --measures: a head's file has its measures already");
  const bool drawn = words.age || words.skull || words.level || words.strict || !words.measure.empty() ||
                     !words.measures.empty() || !words.save_measures.empty() || !words.expression.empty() ||
                     !words.region.empty();
  if (words.on.empty() && !words.save_landmarks.empty())
    return failure(ErrorKind::usage, "--save-landmarks {}: expected --on MODEL beside it", words.save_landmarks);
  if (words.on.empty() && !words.landmarks.empty())
    return failure(ErrorKind::usage, "--landmarks {}: without --on MODEL there is nothing they lie on",
                   words.landmarks);
  const bool shaped = words.age || words.skull || words.level || !words.measure.empty() || !words.measures.empty() ||
                      !words.save_measures.empty() || !words.half.empty();
  if (!words.on.empty() && shaped)
    return failure(ErrorKind::usage,
                   "--on {}: a model that is given is not drawn; of the other options --landmarks, "
                   "--expression, --region and --strict go with it",
                   words.on);
  if (!words.half.empty() && drawn)
    return failure(ErrorKind::usage, "--half: a half that is given is only mirrored; other options do not go with it");
  return {};
}

Result<HeadMeasures> wanted_measures(const Words& words) {
  const auto age = parse_age(words.age.value_or("adult"));
  if (!age) return tl::unexpected<Error>(age.error());
  auto skull = words.skull ? parse_skull(*words.skull) : Result<SkullWeights>(SkullWeights{});
  if (!skull) return pass_on(std::move(skull));
  HeadMeasures measures = measures_of_age(*age);
  if (!words.measures.empty()) {
    const auto bytes = read_file(words.measures);
    if (!bytes) return tl::unexpected<Error>(bytes.error());
    auto parsed = parse_measures(std::string(bytes->begin(), bytes->end()), words.measures);
    if (!parsed) return parsed;
    measures = *parsed;
  }
  apply_skull(*skull, measures);
  for (const std::string& text : words.measure)
    if (auto ok = apply_measure(text, measures); !ok) return pass_on(std::move(ok));
  if (auto ok = check_measures(measures); !ok) return pass_on(std::move(ok));
  return measures;
}

/// "NAME" or "NAME=STRENGTH".
Result<WeighedExpression> parse_expression(const std::string& text) {
  const std::size_t equals = text.find('=');
  const auto strength = equals == std::string::npos ? std::optional(1.0) : parse_number(text.substr(equals + 1));
  if (!strength || *strength < 0.0)
    return failure(ErrorKind::usage, "--expression {}: expected NAME or NAME=STRENGTH, strengths from 0", text);
  auto found = find_expression(text.substr(0, equals));
  if (!found) return bad_input("--expression {}: {}", text, found.error().message);
  return WeighedExpression{*found, *strength};
}

/// What is baked into the head: expressions, then regions on top; an adult's amounts and the head's own.
struct Pose {
  std::vector<WeighedExpression> expressions;
  FaceChannels regions{};
};

Result<Pose> wanted_pose(const Words& words) {
  Pose out;
  for (const std::string& text : words.expression) {
    auto weighed = parse_expression(text);
    if (!weighed) return pass_on(std::move(weighed));
    out.expressions.push_back(*weighed);
  }
  for (const std::string& text : words.region)
    if (auto ok = add_region(text, out.regions); !ok) return pass_on(std::move(ok));
  return out;
}

void report(const Words& words, const Head& head, const Model& model, const std::vector<HeldChannel>& held) {
  std::size_t vertices = 0, triangles = 0;
  for (const Primitive& primitive : model.meshes[0].primitives) {
    vertices += primitive.positions.size();
    triangles += primitive.indices.size() / 3;
  }
  const std::size_t targets = model.meshes[0].primitives[0].morph_targets.size();
  for (const HeldChannel& h : held)
    spdlog::info("{} is held at {:.4g}, asked for {:.4g}", channel_word(h.channel), h.held, h.asked);
  if (!words.common.json) {
    std::cout << fmt::format("{}: {} vertices, {} triangles, {} morph targets, {:.3f} m\n", words.output, vertices,
                             triangles, targets, head.measures.height);
    return;
  }
  nlohmann::ordered_json landmarks = nlohmann::ordered_json::object(), list = nlohmann::ordered_json::array();
  const auto numbers = model_vertices(head);
  for (const auto& [name, vertex] : head.landmarks) landmarks[name] = numbers[vertex];
  for (const HeldChannel& h : held)
    list.push_back({{"region", channel_word(h.channel)}, {"asked", h.asked}, {"held", h.held}});
  print_json({{"file", words.output},
              {"vertices", vertices},
              {"triangles", triangles},
              {"morph_targets", targets},
              {"height", head.measures.height},
              {"landmarks", landmarks},
              {"held", list}});
}

Result<void> mirrored_half(const Words& words) {
  auto model = mirrored_half_model(words.half);
  if (!model) return pass_on(std::move(model));
  const auto bytes = rig_glb(*model);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  if (auto ok = write_file(words.output, *bytes); !ok) return ok;
  const Primitive& skin = model->meshes[0].primitives[0];
  if (words.common.json)
    print_json({{"file", words.output}, {"vertices", skin.positions.size()}, {"triangles", skin.indices.size() / 3}});
  else
    std::cout << fmt::format("{}: {} vertices, {} triangles\n", words.output, skin.positions.size(),
                             skin.indices.size() / 3);
  return {};
}

/// Expressions and regions in the face's own lengths, held at its limits.
HeldFace held_pose(const FaceRig& face, const Pose& pose, bool strict) {
  FaceChannels channels = for_head(face, mix_expressions(pose.expressions, strict));
  for (std::size_t i = 0; i < face_channels; ++i) channels[i] += pose.regions[i];
  return hold_at_limits(face, channels);
}

/// Where the landmarks are on the model at rest.
nlohmann::ordered_json landmarks_json(const ModelFace& face, const LandmarkPlaces& places) {
  nlohmann::ordered_json out = nlohmann::ordered_json::object();
  const Landmarks placed = placed_landmarks(face.mesh, places, "").value();
  for (const auto& [name, place] : placed) out[name] = {place.x, place.y, place.z};
  return out;
}

/// --on: the face of the drawn head on a model.
Result<void> on_model(const Words& words) {
  auto landmarks = words.landmarks.empty() ? LandmarkPlaces() : read_landmarks(words.landmarks);
  if (!landmarks) return tl::unexpected<Error>(landmarks.error());
  auto model = read_mesh_model(words.on);
  if (!model) return tl::unexpected<Error>(model.error());
  std::vector<std::string> problems;
  if (words.landmarks.empty()) {
    const auto found = find_model_landmarks(*model);
    if (!found) return tl::unexpected<Error>(found.error());
    for (const std::string& note : found->notes) spdlog::info("{}: {}", words.on, note);
    if (!found->by_features) problems.push_back(no_features);
    for (const std::string& problem : problems) spdlog::warn("{}: {}", words.on, problem);
    for (const auto& [mark, place] : found->marks) (*landmarks)[mark] = place;
  }
  const auto pose = wanted_pose(words);
  if (!pose) return tl::unexpected<Error>(pose.error());
  for (const std::string& file : {words.output, words.save_landmarks})
    if (auto ok = file.empty() ? Result<void>() : check_writable(file); !ok) return ok;
  if (!words.save_landmarks.empty())
    if (auto ok = write_file(words.save_landmarks, landmarks_text(*landmarks)); !ok) return ok;
  std::optional<EndAtOnce> nothing_is_open(std::in_place);
  const auto face = model_face(*model, *landmarks,
                               words.landmarks.empty() ? words.on + " (landmarks that were found)" : words.landmarks);
  if (!face) return tl::unexpected<Error>(face.error());
  for (const std::string& note : face->transfer.notes) spdlog::info("{}: {}", words.on, note);
  const Head& head = face->transfer.head;
  std::size_t moving = 0, targets = 0;
  HeldFace held;
  if (words.expression.empty() && words.region.empty()) {
    const std::vector<HeadShape> shapes = head_shapes(head, words.strict);
    moving = add_face_targets(*face, shapes, *model);
    targets = shapes.size();
  } else {
    held = held_pose(head.face, *pose, words.strict);
    set_face_shape(*face, posed_head(head, held.channels), *model);
  }
  const auto bytes = rig_glb(*model);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  nothing_is_open.reset();
  if (auto ok = write_file(words.output, *bytes); !ok) return ok;
  for (const HeldChannel& h : held.held)
    spdlog::info("{} is held at {:.4g}, asked for {:.4g}", channel_word(h.channel), h.held, h.asked);
  if (words.common.json)
    print_json({{"file", words.output},
                {"vertices", face->mesh.vertices()},
                {"triangles", face->mesh.triangles.size() / 3},
                {"morph_targets", targets},
                {"moving_vertices", moving},
                {"height", head.measures.height},
                {"landmarks", landmarks_json(*face, *landmarks)},
                {"notes", face->transfer.notes},
                {"problems", problems}});
  else
    std::cout << fmt::format("{}: {} vertices, {} morph targets\n", words.output, face->mesh.vertices(), targets);
  return {};
}

Result<void> head(const Words& words) {
  apply_verbosity(words.common);
  if (auto ok = check_words(words); !ok) return ok;
  if (!words.on.empty()) return on_model(words);
  if (!words.half.empty()) {
    if (auto ok = check_writable(words.output); !ok) return ok;
    return mirrored_half(words);
  }
  const auto measures = wanted_measures(words);
  if (!measures) return tl::unexpected<Error>(measures.error());
  const auto pose = wanted_pose(words);
  if (!pose) return tl::unexpected<Error>(pose.error());
  for (const std::string& file : {words.output, words.save_measures})
    if (auto ok = file.empty() ? Result<void>() : check_writable(file); !ok) return ok;

  std::optional<EndAtOnce> nothing_is_open(std::in_place);
  const auto made = HeadMaker(words.level.value_or(default_head_level)).head(*measures);
  if (!made) return tl::unexpected<Error>(made.error());
  Model model;
  HeldFace held;
  if (words.expression.empty() && words.region.empty()) {
    model = head_model(*made, nullptr, head_shapes(*made, words.strict));
  } else {
    held = held_pose(made->face, *pose, words.strict);
    const HeadShape base = posed_head(*made, held.channels);
    model = head_model(*made, &base, {});
  }
  const auto bytes = head_glb(*made, model);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  nothing_is_open.reset();
  if (!words.save_measures.empty())
    if (auto ok = write_file(words.save_measures, measures_text(*measures)); !ok) return ok;
  if (auto ok = write_file(words.output, *bytes); !ok) return ok;
  report(words, *made, model, held.held);
  return {};
}

}  // namespace

void add_head(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("head", "A head from drawing rules, with regions and expressions");
  command->footer("Example: sinew head --age child --skull round=0.6 -o child.glb");
  auto words = std::make_shared<Words>();
  command->add_option("-o,--output", words->output, "x.glb")->required();
  command->add_option("--age", words->age, "adult, young, adolescent, child, infant, or 0 (adult) to 1 (infant)");
  command->add_option("--skull", words->skull, "square, round, wide, narrow, or NAME=WEIGHT,...");
  command->add_option("--measure", words->measure, "NAME=VALUE: one measure; repeatable");
  command->add_option("--level", words->level, "Steps of subdivision, 0 to 4 (2)");
  command->add_option("--measures", words->measures, "Start from this file of measures");
  command->add_option("--save-measures", words->save_measures, "Write the measures to this file as well");
  command->add_option("--half", words->half, "Mirror this half (.glb, .gltf, .obj) instead of drawing a head");
  command->add_option("--on", words->on, "Lay the face on this model (.glb, .gltf, .obj) instead of drawing a head");
  command->add_option("--landmarks", words->landmarks, "Where the model's face is (JSON): with --on; else looked for");
  command->add_option("--save-landmarks", words->save_landmarks, "Write the landmarks that were used to this file");
  command->add_option("--expression", words->expression, "NAME or NAME=STRENGTH: show it; repeatable");
  command->add_option("--region", words->region, "NAME=NUMBER,...: move a region, as scenes do; repeatable");
  command->add_flag("--strict", words->strict, "Of expressions only what the thesis' tables have");
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return head(*words); }; });
}

}  // namespace sinew::tools
