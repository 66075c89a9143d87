#include "tests/grf/scene_generator.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include <rapidcheck.h>

#include "grf/keywords.h"

namespace grf {
namespace {

constexpr int DeepestBody = 3;

int number_up_to(int most) { return *rc::gen::inRange(0, most + 1); }
bool coin() { return *rc::gen::arbitrary<bool>(); }

std::string one_of(const std::vector<std::string>& texts) { return *rc::gen::elementOf(texts); }

std::string text_of(const std::vector<std::string>& pieces) {
  std::string text;
  const int count = number_up_to(4);
  for (int i = 0; i < count; ++i) text += one_of(pieces);
  return text;
}

/// Few enough for definitions to hide each other and to be spelt like keywords.
std::string definition_name() {
  if (number_up_to(4) == 0) return to_identifier(text_of({"a", "ñ", " ", "$", "begin", "7", "_"}));
  return one_of({"ward", "Ward", "light", "gold", "mesh", "transform", "rgb", "_2"});
}

/// Of several letters, so that there is always a spelling that is no definition's.
std::string keyword() { return one_of({"ward", "WARD", "light", "gold", "cascadeCDF", "mesh", "he"}); }

/// An equal surface of other text.
Surface written_otherwise(Surface surface) {
  if (surface.brdf) {
    if (auto* model = std::get_if<BrdfModel>(&*surface.brdf)) model->keyword = lower_case(model->keyword);
  }
  if (surface.emission && surface.emission->x == 0) surface.emission->x = -surface.emission->x;
  if (surface.opacity && surface.opacity->value == 0) surface.opacity->value = -surface.opacity->value;
  return surface;
}

}  // namespace

Scene SceneGenerator::scene() { return {block_list(0)}; }

float SceneGenerator::number() {
  using Limits = std::numeric_limits<float>;
  if (coin()) {
    return *rc::gen::element(0.0F, 1.0F, -0.0F, -1.0F, 0.1F, 1.0F / 3, 16777216.0F, 1e20F, Limits::max(),
                             Limits::lowest(), Limits::min(), Limits::denorm_min(), -Limits::denorm_min());
  }
  const auto number = std::bit_cast<float>(*rc::gen::arbitrary<std::uint32_t>());
  return std::isfinite(number) ? number : 2.0F;
}

Colour SceneGenerator::colour() {
  const float red = number();
  const float green = number();
  return {red, green, number()};
}

BlockList SceneGenerator::block_list(int depth) {
  BlockList list;
  const int count = number_up_to(depth == 0 ? 4 : 2);
  for (int i = 0; i < count; ++i) {
    const bool again = !list.blocks.empty() && number_up_to(7) == 0;
    list.blocks.push_back(again ? list.blocks.back() : block(depth));
  }
  list.end_comments = comment_lines();
  return list;
}

Block SceneGenerator::block(int depth) {
  Block block;
  const std::vector<std::string> meshes = names_of<Shared<Mesh>>();
  const int kind = number_up_to(depth < DeepestBody ? (with_includes_ ? 7 : 6) : 4);
  if (kind == 0) block.content = light();
  if (kind == 1) block.content = Shared<Mesh>(mesh());
  if (kind == 2) block.content = mesh_light();
  if (kind == 3) block.content = params();
  if (kind == 4) {
    if (meshes.empty()) {
      block.content = light();
    } else {
      block.content = use(meshes);
    }
  }
  if (kind == 5) block.content = transform(depth);
  if (kind == 6) block.content = definitions(depth);
  if (kind == 7) block.content = include(depth);
  block.comments = comments();
  return block;
}

Use SceneGenerator::use(const std::vector<std::string>& names) { return {{one_of(names), {}}}; }

Params SceneGenerator::params() {
  Params params;
  const int count = number_up_to(2);
  for (int i = 0; i < count; ++i) params.views.push_back(colour());
  return params;
}

AreaLight SceneGenerator::light() {
  AreaLight light{colour(), colour(), colour(), {}};
  if (coin()) light.radiance = colour();
  return light;
}

Transform SceneGenerator::transform(int depth) {
  Transform transform;
  const int count = 1 + number_up_to(2);
  for (int i = 0; i < count; ++i) {
    TransformStep step{static_cast<TransformStep::Kind>(number_up_to(2)), colour()};
    for (float* factor : {&step.value.x, &step.value.y, &step.value.z}) {
      if (step.kind == TransformStep::Kind::Scale && *factor == 0) *factor = -1;
    }
    transform.steps.push_back(step);
  }
  transform.body = block_list(depth + 1);
  return transform;
}

DefinitionScope SceneGenerator::definitions(int depth) {
  std::deque<Definition> definitions;  // each sees those before it
  std::set<std::string> names;
  const int count = 1 + number_up_to(3);
  for (int i = 0; i < count; ++i) {
    Definition definition;
    definition.name = definition_name();
    while (!names.insert(definition.name).second) definition.name += '_';
    const int kind = number_up_to(4);
    if (kind == 4) definition.body = Shared<Mesh>(mesh());
    if (kind == 0) definition.body = colour();
    if (kind == 1) definition.body = model<BrdfModel>();
    if (kind == 2) definition.body = model<PdfModel>();
    if (kind == 3) definition.body = texture();
    definition.comments = comments();
    scope_.enter(definitions.emplace_back(std::move(definition)));
  }
  DefinitionScope scope;
  scope.body = block_list(depth + 1);
  scope_.leave(definitions.size());
  scope.definitions.assign(definitions.begin(), definitions.end());
  return scope;
}

Include SceneGenerator::include(int depth) {
  Include include;
  const std::string folder = one_of({"", "parts/", "parts\\", "más partes/", "“a”/"});
  include.file = folder + std::to_string(++file_count_) + one_of({"", " b", "ñ", "'"}) + ".igrf";
  include.contents = block_list(depth + 1);
  return include;
}

Mesh SceneGenerator::mesh() {
  MeshDraft mesh;
  mesh.name = quotable();
  mesh.surfaces[0] = surface();
  const Surface& own = mesh.surfaces[0];
  if (own.colour) mesh.comments.colour = comments();
  if (own.brdf) mesh.comments.brdf = comments();
  if (own.pdf) mesh.comments.pdf = comments();
  if (own.texture) mesh.comments.texture = comments();
  if (own.emission) mesh.comments.emission = comments();
  if (own.opacity) mesh.comments.opacity = comments();
  mesh.comments.vertices = comments();
  mesh.comments.faces = comments();
  mesh.comments.end = comment_lines();
  fill_vertices(mesh);
  if (!mesh.positions.empty()) fill_faces(mesh, &SceneGenerator::surface);
  return mesh;
}

MeshLight SceneGenerator::mesh_light() {
  MeshDraft mesh;
  mesh.surfaces[0] = light_surface();
  if (mesh.surfaces[0].colour) mesh.comments.colour = comments();
  mesh.comments.vertices = comments();
  mesh.comments.faces = comments();
  mesh.comments.end = comment_lines();
  fill_vertices(mesh);
  if (!mesh.positions.empty()) fill_faces(mesh, &SceneGenerator::light_surface);
  return {Mesh(std::move(mesh))};
}

void SceneGenerator::fill_vertices(MeshDraft& mesh) {
  const int count = number_up_to(5);
  for (int i = 0; i < count; ++i) {
    mesh.positions.push_back(colour());
    const auto vertex = static_cast<std::size_t>(i);
    if (coin()) mesh.normals.set(vertex, colour());
    if (coin()) mesh.colours.set(vertex, colour());
    if (coin()) mesh.uvs.set(vertex, Vec2f(number(), number()));
    if (number_up_to(3) == 0) mesh.irradiance.set(vertex, irradiance());
  }
}

Irradiance SceneGenerator::irradiance() {
  if (coin()) return colour();
  std::vector<DirectionalIrradiance> list;
  const int count = number_up_to(2);
  for (int i = 0; i < count; ++i) list.push_back({colour(), colour()});
  return list;
}

void SceneGenerator::fill_faces(MeshDraft& mesh, Surface (SceneGenerator::*make)()) {
  const int surfaces = number_up_to(3);
  for (int i = 0; i < surfaces; ++i) {
    mesh.surfaces.push_back(number_up_to(3) == 0 ? written_otherwise(mesh.surfaces.back()) : (this->*make)());
  }
  const int faces = number_up_to(5);
  for (int i = 0; i < faces; ++i) {
    std::vector<std::uint32_t> corners(3 + static_cast<std::size_t>(number_up_to(2)));
    for (std::uint32_t& corner : corners) {
      corner = static_cast<std::uint32_t>(number_up_to(static_cast<int>(mesh.positions.size()) - 1));
    }
    mesh.add_face(corners, static_cast<std::uint32_t>(number_up_to(surfaces)));
  }
}

Surface SceneGenerator::surface() {
  Surface surface;
  surface.colour = attribute<Colour>();
  surface.brdf = attribute<BrdfModel>();
  surface.pdf = attribute<PdfModel>();
  surface.texture = attribute<Texture>();
  if (coin()) surface.emission = colour();
  // The grammar of 2008 lacks it, so most scenes have none.
  if (number_up_to(15) == 0) {
    const float value = *rc::gen::element(0.0F, -0.0F, 0.1F, 1.0F / 3, 0.5F, 1.0F);
    surface.opacity = Opacity{static_cast<Opacity::Kind>(number_up_to(2)), value};
  }
  return surface;
}

Surface SceneGenerator::light_surface() {
  Surface surface;
  surface.colour = attribute<Colour>();
  return surface;
}

/// Sorted, so that the same choice is the same name in every run.
template <class Body>
std::vector<std::string> SceneGenerator::names_of() const {
  std::vector<std::string> names = scope_.scope().names_of<Body>();
  std::sort(names.begin(), names.end());
  return names;
}

template <class Body>
std::optional<std::variant<Body, Reference>> SceneGenerator::attribute() {
  if (coin()) return std::nullopt;
  const std::vector<std::string> names = names_of<Body>();
  if (!names.empty() && coin()) return Reference{one_of(names), {}};
  if constexpr (std::is_same_v<Body, Colour>) {
    return colour();
  } else if constexpr (std::is_same_v<Body, Texture>) {
    return texture();
  } else {
    return model<Body>();
  }
}

template <class ModelOfKind>
ModelOfKind SceneGenerator::model() {
  ModelOfKind model;
  model.keyword = keyword();
  if constexpr (std::is_same_v<ModelOfKind, BrdfModel>) {
    const std::vector<std::string> names = names_of<BrdfModel>();
    if (!names.empty() && number_up_to(2) == 0) return coin() ? combine(names) : layered(names);
    if (number_up_to(3) == 0) model.data_file = quotable();
    // The files of such instances are written where included ones are.
    if (with_includes_ && number_up_to(3) == 0) model.instance_file = std::to_string(++file_count_) + ".brdf";
  }
  const int count = number_up_to(2);
  for (int i = 0; i < count; ++i) model.arguments.push_back(argument());
  return model;
}

BrdfModel SceneGenerator::combine(const std::vector<std::string>& names) {
  BrdfModel brdf;
  brdf.keyword = one_of({"combine", "Combine"});
  const int count = 1 + number_up_to(2);
  for (int i = 0; i < count; ++i) brdf.terms.push_back({std::abs(number()), {one_of(names), {}}});
  if (coin()) brdf.arguments.push_back({"sx", value(), {}});
  return brdf;
}

BrdfModel SceneGenerator::layered(const std::vector<std::string>& names) {
  BrdfModel brdf;
  brdf.keyword = one_of({"coat", "Layer"});
  for (std::size_t i = 0; i < layer_names(brdf.keyword).size(); ++i) {
    brdf.terms.push_back({1, {one_of(names), {}}});
  }
  if (coin()) brdf.arguments.push_back({"ior", value(), {}});
  return brdf;
}

Argument SceneGenerator::argument() {
  Argument argument{one_of({"sx", "Cx", "begin", "_", "$1", "r"}), value(), {}};
  const bool is_factor =
      std::holds_alternative<float>(argument.value) || std::holds_alternative<Colour>(argument.value);
  if (is_factor && number_up_to(3) == 0) {
    argument.map = ParameterMap{quotable(), static_cast<ImageChannel>(number_up_to(4))};
    if (coin()) argument.value = 1.0F;
  }
  return argument;
}

Texture SceneGenerator::texture() { return {quotable(), {}}; }

Value SceneGenerator::value() {
  const int kind = number_up_to(3);
  if (kind == 0) return number();
  if (kind == 1) return coin();
  if (kind == 2)
    return Word{one_of({"reject", "Warp", "ward", "gold", "light", "mesh", "normal", "_", "$1"})};
  return colour();
}

Comments SceneGenerator::comments() {
  Comments comments;
  if (number_up_to(3) == 0) comments.before = comment_lines();
  if (number_up_to(3) == 0) comments.behind = comment();
  return comments;
}

std::vector<std::string> SceneGenerator::comment_lines() {
  std::vector<std::string> lines;
  const int count = number_up_to(3) == 0 ? 1 + number_up_to(1) : 0;
  for (int i = 0; i < count; ++i) lines.push_back(comment());
  return lines;
}

std::string SceneGenerator::comment() {
  return text_of(
      {" about", "/", "//", "\"", "“", " ", "\t", "end", " begin mesh", "niño", "\xF1", "\x01", "\r."});
}

std::string SceneGenerator::quotable() {
  const std::vector<std::string> quotes =
      coin() ? std::vector<std::string>{"\""} : std::vector<std::string>{"“", "”"};
  std::vector<std::string> pieces = {"a", " ", "//", "\\", "ñ", "\xF1", "\t", "'", "\r"};
  pieces.insert(pieces.end(), quotes.begin(), quotes.end());
  return text_of(pieces);
}

}  // namespace grf
