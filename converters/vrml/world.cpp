#include "converters/vrml/world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "converters/scene_building.h"
#include "converters/vrml/addresses.h"
#include "converters/vrml/parser.h"
#include "grf/text_file.h"

namespace convert::vrml {
namespace {

/// The maximum number of visited nodes, far more than any real file has.
constexpr std::size_t MostMetNodes = 1'000'000;
constexpr std::size_t DeepestInline = 64;

template <class Vector>
bool is_finite(const Vector& v) {
  for (unsigned i = 0; i < v.dimensions(); ++i) {
    if (!std::isfinite(v[static_cast<int>(i)])) return false;
  }
  return true;
}

bool all_finite(const Polygons& polygons) {
  const auto finite = [](const auto& v) { return is_finite(v); };
  return std::all_of(polygons.positions.begin(), polygons.positions.end(), finite) &&
         std::all_of(polygons.uvs.begin(), polygons.uvs.end(), finite);
}

/// Returns whether the steps of a transform are in the range of floats.
bool is_finite(const grf::Matrix44d& matrix) {
  constexpr double Largest = std::numeric_limits<float>::max();
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (!(std::abs(matrix[i][k]) <= Largest)) return false;
    }
  }
  const auto steps = transform_steps(matrix);
  return std::all_of(steps.begin(), steps.end(),
                     [](const grf::TransformStep& step) { return is_finite(step.value); });
}

/// Returns whether a transform is singular, or nearly so.
bool is_singular(const grf::Matrix44d& matrix) {
  double lengths = 1;
  for (int i = 0; i < 3; ++i) lengths *= grf::Vec3d(matrix[i][0], matrix[i][1], matrix[i][2]).length();
  constexpr double Flat = 1e-12;
  constexpr double Smallest = 1e-100;  // below a product of three floats
  return !(std::abs(matrix.determinant()) > std::max(Flat * lengths, Smallest));
}

grf::Block block_of(const grf::Shared<grf::Mesh>& mesh, const grf::SourceLocation& location) {
  grf::Block block;
  block.content = mesh;
  block.location = location;
  return block;
}

}  // namespace

World::World(std::string path, grf::Diagnostics& diagnostics)
    : path_(std::move(path)), report_(diagnostics), appearances_(names_, report_) {}

std::optional<grf::Scene> World::read(std::shared_ptr<const Source> source) {
  const grf::SourceLocation location = source->whole_file();
  const OpenDocument* document = open(std::move(source), "");
  if (document == nullptr) return std::nullopt;
  std::vector<grf::Block> blocks = blocks_of(*document, {});
  if (report_.failed()) return std::nullopt;
  appearances_.materials().report(location, report_.diagnostics());
  report_.finish(location);
  if (blocks.empty()) {
    report_.diagnostics().error(location, "the file has no faces, and only faces can be imported");
    return std::nullopt;
  }
  std::vector<grf::Definition> definitions = appearances_.materials().definitions();
  for (grf::Definition& definition : definitions_of_shared_meshes()) {
    definitions.push_back(std::move(definition));
  }
  replace_shared_meshes(blocks);
  return scene_of(std::move(definitions), std::move(blocks), location);
}

const OpenDocument* World::open(std::shared_ptr<const Source> source, const std::string& folder) {
  const std::string canonical = grf::canonical_path(source->path());
  const auto [known, is_new] = documents_.try_emplace(canonical);
  OpenDocument& open = known->second;
  if (!is_new) return &open;
  open = {parse(std::move(source), report_.diagnostics()), folder, canonical};
  if (open.document == nullptr) return nullptr;
  report_.add("ROUTE was skipped", "ROUTEs were skipped", "GRF scenes are static", open.document->routes);
  for (const std::string_view prototype : open.document->prototypes) {
    report_.add(fmt::format("prototype '{}' was skipped", prototype),
                fmt::format("prototypes '{}' were skipped", prototype), "prototypes are not supported");
  }
  return &open;
}

std::vector<grf::Block> World::blocks_of(const OpenDocument& document, const Place& place) {
  open_files_.push_back(document.canonical);
  const bool is_vrml1 = document.document->source->version() == Version::Vrml1;
  auto blocks = is_vrml1 ? read_vrml1(*this, document, place) : read_vrml97(*this, document, place);
  open_files_.pop_back();
  return blocks;
}

bool World::enter(const Node& node, const Place& place) {
  if (report_.failed()) return false;
  if (place.depth > DeepestNode) {
    report_.diagnostics().error(node.location(),
                                fmt::format("nodes are nested more than {} deep", DeepestNode));
  } else if (++met_nodes_ > MostMetNodes) {
    report_.diagnostics().error(
        node.location(),
        fmt::format("with all that USE repeats, there are more than {} nodes", MostMetNodes));
  }
  return !report_.failed();
}

std::vector<grf::Block> World::mesh(const std::vector<const Node*>& made_of, const Node& shape,
                                    std::string_view name,
                                    const std::function<std::optional<ShapeFaces>()>& build) {
  const auto [known, is_new] = meshes_.try_emplace(made_of);
  SharedMesh& shared = known->second;
  if (is_new) {
    const auto parts = build();
    if (!parts || report_.failed()) return {};
    if (!all_finite(parts->polygons)) {
      report_.diagnostics().error(shape.location(), "the shape is too large for floats");
      return {};
    }
    if (parts->polygons.face_count() > 0) {
      shared.mesh = make_mesh(std::string(name), parts->polygons, parts->surfaces);
      shared.location = shape.source->lasting_location(shape.offset);
      meshes_in_order_.push_back(&shared);
    } else {
      report_.add("shape was left out", "shapes were left out", "it has no faces");
    }
  }
  if (!shared.mesh) return {};
  ++shared.places;
  return {block_of(*shared.mesh, shared.location)};
}

std::vector<grf::Block> World::under(const grf::Matrix44d& to_parent, std::vector<grf::Block> blocks,
                                     const Node& node) {
  if (blocks.empty() || report_.failed()) return {};
  if (is_singular(to_parent)) {
    report_.losses().add(Loss::SingularTransform, blocks.size());
    return {};
  }
  if (!is_finite(to_parent)) {
    report_.diagnostics().error(node.location(), "the transform is too large for floats");
    return {};
  }
  return placed(std::move(blocks), to_parent, node.source->lasting_location(node.offset));
}

std::vector<grf::Block> World::inlined(const Node& node, const std::vector<std::string>& addresses,
                                       const std::string& folder, const Place& place) {
  const auto [known, is_new] = inlined_.try_emplace(&node, nullptr);
  if (is_new) known->second = inlined_document(node, addresses, folder);
  const OpenDocument* document = known->second;
  if (document == nullptr || !may_inline(node, document->canonical)) return {};
  return blocks_of(*document, place);
}

const OpenDocument* World::inlined_document(const Node& node, const std::vector<std::string>& addresses,
                                            const std::string& folder) {
  // A missing file is a warning: a browser that cannot reach a URL shows the rest, too.
  const auto name = local_file(addresses, folder, path_);
  if (!name) {
    report_.diagnostics().warning(node.location(), "what is inlined here is no file: left out");
    return nullptr;
  }
  const std::string path = grf::path_beside(path_, *name);
  const auto known = documents_.find(grf::canonical_path(path));
  if (known != documents_.end()) return &known->second;
  auto problems = grf::Diagnostics::to_be_repeated();
  const auto bytes = grf::read_file(path, problems, node.location());
  if (!bytes) {
    report_.diagnostics().warning(node.location(), problems.entries().front().message + ": left out");
    return nullptr;
  }
  report_.diagnostics().add_file(path);
  auto source = make_source(*bytes, path, node.location(), report_.diagnostics());
  return source ? open(std::move(source), folder_of(*name)) : nullptr;
}

bool World::may_inline(const Node& node, const std::string& canonical) {
  const auto open_at = std::find(open_files_.begin(), open_files_.end(), canonical);
  if (open_at != open_files_.end()) {
    const std::vector<std::string> chain(open_at, open_files_.end());
    report_.diagnostics().error(node.location(), fmt::format("the file inlines itself: {} -> {}",
                                                             fmt::join(chain, " -> "), canonical));
    return false;
  }
  if (open_files_.size() <= DeepestInline) return true;
  report_.diagnostics().error(node.location(),
                              fmt::format("files inline each other more than {} deep", DeepestInline));
  return false;
}

std::vector<grf::Definition> World::definitions_of_shared_meshes() {
  std::vector<grf::Definition> definitions;
  for (const SharedMesh* shared : meshes_in_order_) {
    if (shared->places < 2) continue;
    const std::string& name = (*shared->mesh)->name;
    grf::Definition definition;
    definition.name = names_.take(name.empty() ? name_of_file(shared->location.file->path) : name);
    definition.body = *shared->mesh;
    definition.location = shared->location;
    names_of_shared_.emplace(&**shared->mesh, definition.name);
    definitions.push_back(std::move(definition));
  }
  return definitions;
}

// The scene is nested no deeper than the nodes.
void World::replace_shared_meshes(std::vector<grf::Block>& blocks) const {
  for (grf::Block& block : blocks) {
    if (auto* transform = std::get_if<grf::Transform>(&block.content)) {
      replace_shared_meshes(transform->body.blocks);
    } else if (const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&block.content)) {
      const auto shared = names_of_shared_.find(&**mesh);
      if (shared != names_of_shared_.end()) block.content = grf::Use{{shared->second, block.location}};
    }
  }
}

}  // namespace convert::vrml
