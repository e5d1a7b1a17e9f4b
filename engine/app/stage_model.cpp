#include "engine/app/stage_model.h"

#include "engine/body/built_in_model.h"
#include "engine/body/headed_figure.h"
#include "engine/face/model_face.h"
#include "engine/io/gltf_read.h"
#include "engine/io/mesh_read.h"
#include "engine/model/resample.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

/// Of the file, which `hash` has seen, and of all that it refers to: buffers and pictures may lie in files of their
/// own.
std::string content_hash(Sha256& hash, const Model& model) {
  for (const EncodedImage& image : model.images) hash.add(image.bytes);
  for (const Skin& skin : model.skins) hash.add_all(skin.inverse_bind);
  for (const Clip& clip : model.clips)
    for (const Channel& channel : clip.channels) {
      hash.add_all(channel.times);
      hash.add_all(channel.values);
    }
  for (const Mesh& mesh : model.meshes)
    for (const Primitive& primitive : mesh.primitives) {
      hash.add_all(primitive.positions);
      hash.add_all(primitive.normals);
      hash.add_all(primitive.tangents);
      hash.add_all(primitive.texture_coordinates);
      hash.add_all(primitive.second_texture_coordinates);
      hash.add_all(primitive.colours);
      hash.add_all(primitive.indices);
      hash.add_all(primitive.influences.first);
      for (const Influence& influence : primitive.influences.entries)
        hash.add_all(std::vector<double>{double(influence.joint), influence.weight});
      for (const MorphTarget& target : primitive.morph_targets) {
        hash.add_all(target.positions);
        hash.add_all(target.normals);
      }
    }
  return hash.finish();
}

/// Models that are drawn from the scene's "head": a head alone, or a figure that wears one.
Result<void> draw_head(StagedCharacter& character, double frame, const ScenePlace& place) {
  const std::string name = character.scene.model.string();
  const std::optional<HeadSpec>& spec = character.scene.head;
  if (name == "builtin:head") {
    auto head = DrawnHead::make(spec.value_or(HeadSpec{}), frame);
    if (!head) return place.inside("/head", std::move(head));
    character.face.head = std::make_shared<DrawnHead>(std::move(*head));
    character.model = std::make_shared<Model>(character.face.head->model());
    character.model_hash = fmt::format("{} {}", name, sha256(character.face.head->measures()));
    return {};
  }
  if (!spec) return {};
  const auto figure = built_in_figure(name);
  if (!figure)
    return place.at("/head",
                    Result<void>(bad_input("is for \"builtin:head\" and the built-in figures, not for {}", name)));
  if (!spec->age.is_constant())
    return place.at("/head/age",
                    Result<void>(bad_input("a figure's head keeps its age; only builtin:head changes it")));
  const auto measures = head_measures(*spec, frame);
  if (!measures) return place.inside("/head", Result<HeadMeasures>(measures));
  auto headed = build_headed_figure(*figure, *measures, spec->level.value_or(default_head_level));
  if (!headed) return place.at("/head", std::move(headed));
  character.face.worn = headed->face();
  headed->model.file = name;
  character.model = std::make_shared<Model>(std::move(headed->model));
  character.model_hash =
      fmt::format("{} {} {}", name, sha256(measures_text(*measures)), spec->level.value_or(default_head_level));
  return {};
}

/// Reads the file once, so that the hash is that of what was parsed, whoever replaces the file meanwhile.
Result<void> load_model(StagedCharacter& character, std::optional<Bytes> bytes, const TaskWatch& watch) {
  const std::string name = character.scene.model.string();
  if (character.model) return {};  // it was drawn
  if (is_built_in_model(name)) {
    auto model = built_in_model(name);
    if (!model) return pass_on(std::move(model));
    character.model = std::make_shared<Model>(std::move(*model));
    character.model_hash = name;
    return {};
  }
  if (!bytes) {
    auto read = read_file(character.scene.model);
    if (!read) return pass_on(std::move(read));
    bytes = std::move(*read);
  }
  if (auto ok = watch.check(); !ok) return ok;
  Sha256 hash;
  hash.add(*bytes);
  auto model = is_polygon_file(name) ? read_mesh(name) : read_gltf(name, std::move(*bytes));
  if (!model) return pass_on(std::move(model));
  if (auto ok = watch.check(); !ok) return ok;
  character.model_hash = content_hash(hash, *model);
  character.model = std::make_shared<Model>(std::move(*model));
  return {};
}

/// The face that the scene's landmarks give the model.
Result<void> lay_face(StagedCharacter& character) {
  const std::string& file = character.scene.landmarks;
  if (file.empty()) return {};
  LandmarkPlaces places;
  if (file == "auto") {
    const auto found = find_model_landmarks(*character.model);
    if (!found) return tl::unexpected<Error>(found.error());
    for (const auto& [mark, place] : found->marks) places[mark] = place;
    if (!found->by_features) character.face.problems.push_back(no_features);
  } else {
    auto read = read_landmarks(file);
    if (!read) return pass_on(std::move(read));
    places = std::move(*read);
  }
  const auto laid = model_face(*character.model, places,
                               file == "auto" ? character.scene.model.string() + " (landmarks that were found)" : file);
  if (!laid) return tl::unexpected<Error>(laid.error());
  auto face = character_face(*laid, character.mesh, character.scene.model.string());
  if (!face) return pass_on(std::move(face));
  character.mesh.face = std::move(*face);
  auto points = placed_landmarks(laid->mesh, places, file);
  if (!points) return pass_on(std::move(points));
  character.face.landmarks = std::move(*points);
  character.model_hash += " " + landmarks_text(places);
  return {};
}

/// Whoever knows regions for this mesh: a head that was drawn has its own, landmarks lay one on any other.
Result<void> give_face(StagedCharacter& character) {
  if (character.face.head)
    character.mesh.face = character.face.head->face();
  else if (character.face.worn)
    character.mesh.face = character.face.worn;
  return lay_face(character);
}

/// What follows from the model that was read or drawn.
Result<void> lay_out(StagedCharacter& character, const SceneOptions& options) {
  const Model& model = *character.model;
  character.order = hierarchy_order(model);
  character.rest_rotations = rest_rotations(model, character.order);
  if (auto ok = check_drawn_vertices(model); !ok) return ok;
  character.mesh = character_mesh(model);
  if (auto ok = give_face(character); !ok) return ok;
  if (options.vertices > 0) {
    if (character.face.head && character.face.head->changes())
      return bad_input("{}: a head that changes its age has the vertices that it is drawn with",
                       character.scene.model.string());
    auto mesh = resample(character.mesh, options.vertices);
    if (!mesh) return bad_input("{}: {}", character.scene.model.string(), mesh.error().message);
    character.mesh = std::move(*mesh);
  }
  character.rest = rest_shape(model, character.mesh, character.order);
  for (MeshPart& part : character.mesh.parts)
    if (part.vertex_count > 0) part.mirrored = glm::determinant(character.rest.blend[part.first_vertex]) < 0.0;
  character.humanoid = find_humanoid(model, character.rest.global);
  return {};
}

}  // namespace

Result<void> stage_model(StagedCharacter& character, const Scene& scene, const SceneOptions& options,
                         const ScenePlace& place, TaskWatch& watch, std::optional<Bytes> bytes) {
  if (auto ok = watch.check(); !ok) return ok;
  if (auto ok = draw_head(character, scene.frames.value_or(FrameSpan{}).first, place); !ok) return ok;
  if (auto ok = load_model(character, std::move(bytes), watch); !ok) return place.at("/model", std::move(ok));
  watch.advance();
  if (auto ok = watch.check(); !ok) return ok;
  if (auto ok = lay_out(character, options); !ok) return place.at("/model", std::move(ok));
  watch.advance();
  return {};
}

}  // namespace sinew
