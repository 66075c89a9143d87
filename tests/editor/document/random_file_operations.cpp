#include <map>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "editor/rendering/baked_irradiance.h"
#include "grf/read.h"
#include "tests/editor/document/random_session.h"

namespace editor {
namespace {

std::size_t steps(RandomSession& session) { return session.one_in(3) ? 100 : 1 + session.below(3); }

void undo(RandomSession& session) {
  for (std::size_t count = steps(session); count > 0; --count) session.modelled.undo();
}

void redo(RandomSession& session) {
  for (std::size_t count = steps(session); count > 0; --count) session.modelled.redo();
}

void save(RandomSession& session) {
  const bool is_igrf = has_irradiance(session.modelled.state().main);
  const std::string name = std::vector<std::string>{"a/main", "a/copy", "b/main"}[session.below(3)];
  const bool stays = session.one_in(2) && (!is_igrf || session.modelled.path().ends_with(".igrf"));
  session.modelled.save(stays ? session.modelled.path()
                              : session.folder.path(name + (is_igrf ? ".igrf" : ".grf")));
}

void reload(RandomSession& session) {
  const std::vector<std::string> paths = session.modelled.paths();
  const bool can_revert = std::count(paths.begin(), paths.end(), session.modelled.path()) > 0;
  if (!paths.empty())
    session.modelled.open(can_revert && session.one_in(2) ? session.modelled.path()
                                                          : paths[session.below(paths.size())]);
}

void change_outside(RandomSession& session) {
  const std::vector<std::string> texts = part_texts();
  session.modelled.write(session.part_file, texts[session.below(texts.size())]);
  if (session.one_in(2)) session.modelled.write(session.main_file, main_text());
}

// Late results.

/// A mesh instance in world space.
struct Placed {
  const grf::Mesh* mesh = nullptr;
  grf::Matrix44d to_world;

  bool is_at_place_of(const Placed& other) const {
    return &*mesh->geometry == &*other.mesh->geometry && to_world == other.to_world;
  }
};

void add_placed(const grf::BlockList& list, const grf::Matrix44d& to_world,
                std::map<std::string, const grf::Mesh*>& defined, std::vector<Placed>& placed) {
  for (const grf::Block& block : list.blocks) {
    if (const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&block.content)) {
      placed.push_back({&**mesh, to_world});
    } else if (const auto* use = std::get_if<grf::Use>(&block.content)) {
      placed.push_back({defined.at(use->mesh.name), to_world});
    } else if (const auto* include = std::get_if<grf::Include>(&block.content)) {
      add_placed(*include->contents, to_world, defined, placed);
    } else if (const auto* transform = std::get_if<grf::Transform>(&block.content)) {
      add_placed(transform->body, grf::matrix_of(transform->steps) * to_world, defined, placed);
    } else if (const auto* scope = std::get_if<grf::DefinitionScope>(&block.content)) {
      for (const grf::Definition& definition : scope->definitions) {
        const auto* defined_mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body);
        if (defined_mesh != nullptr) defined[definition.name] = &**defined_mesh;
      }
      add_placed(scope->body, to_world, defined, placed);
    }
  }
}

std::vector<Placed> placed_meshes(const grf::Scene& scene) {
  std::vector<Placed> placed;
  std::map<std::string, const grf::Mesh*> defined;
  add_placed(scene.contents, {}, defined, placed);
  return placed;
}

/// The irradiance at the first vertex of each mesh instance; -1 for none.
std::vector<float> irradiances(const std::vector<Placed>& meshes) {
  std::vector<float> values;
  for (const Placed& each : meshes) {
    const grf::VertexIrradiance& irradiance = *each.mesh->irradiance;
    values.push_back(irradiance.has(0) ? std::get<grf::Colour>(irradiance[0]).x : -1);
  }
  return values;
}

/// The meshes with irradiance: 1 for the first one, 2 for the second, and so on.
grf::Scene baked(const std::vector<Placed>& meshes) {
  grf::Scene scene;
  for (const Placed& each : meshes) {
    grf::Mesh mesh = *each.mesh;
    grf::VertexIrradiance values;
    const auto value = static_cast<float>(scene.contents.blocks.size() + 1);
    for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) values.set(i, grf::Colour(value));
    mesh.irradiance = std::move(values);
    scene.contents.blocks.emplace_back().content = grf::Shared<grf::Mesh>(std::move(mesh));
  }
  return scene;
}

void merge(RandomSession& session) {
  if (session.is_full()) return;
  const std::string path = session.folder.path("c/model.grf");
  if (!session.model) {
    grf::Diagnostics diagnostics;
    session.model = grf::read(path, diagnostics);
    return;
  }
  PlainProject after = session.modelled.state();
  const PlainFile added = plain_reading(*session.model, path).project.main;
  after.main.objects.insert(after.main.objects.end(), added.objects.begin(), added.objects.end());
  session.modelled.merge("Merge", *session.model, path, after);
  session.model.reset();
}

void begin_bake(RandomSession& session) {
  session.snapshot = session.modelled.scene();
  session.scenes_at_snapshot = session.modelled.scenes();
}

/// Irradiance is applied to meshes whose geometry and transform equal those of the snapshot.
void finish_bake(RandomSession& session) {
  if (!session.snapshot) return;
  const std::vector<Placed> then = placed_meshes(*session.snapshot);
  const std::vector<Placed> now = placed_meshes(session.modelled.scene());
  std::vector<float> expected = irradiances(now);
  std::size_t found = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const auto same = std::find_if(then.begin(), then.end(),
                                   [&](const Placed& each) { return each.is_at_place_of(now[i]); });
    if (same == then.end()) continue;
    expected[i] = static_cast<float>(same - then.begin() + 1);
    ++found;
  }
  const IrradiatedScene result = BakedIrradiance(*session.snapshot, baked(then))
                                     .applied_to(session.modelled.scene(), session.modelled.path());
  const std::vector<float> values = irradiances(placed_meshes(result.scene));
  if (result.meshes != found) session.modelled.fail("irradiance is given to other meshes");
  if (values != expected)
    session.modelled.fail(fmt::format("irradiance {} where {} is right", values, expected));
  if (session.modelled.scenes() != session.scenes_at_snapshot && result.meshes > 0) {
    session.modelled.fail("irradiance of a scene that was replaced");
  }
  // Includes and names are covered by other tests.
  PlainReading reading = plain_reading(result.scene, session.modelled.path());
  PlainProject& after = reading.project;
  if (result.meshes == 0 || !reading.has_one_meaning_per_name || have_unclear_names(after)) return;
  after.depth = session.modelled.state().depth;
  after.background = session.modelled.state().background;
  session.replace("Bake", result.scene, after);
}

}  // namespace

std::vector<RandomOperation> file_operations() {
  return {{"undo", undo},
          {"undo", undo},
          {"undo", undo},
          {"redo", redo},
          {"redo", redo},
          {"save", save},
          {"save", save},
          {"reload", reload},
          {"change outside", change_outside},
          {"merge", merge},
          {"begin bake", begin_bake},
          {"finish bake", finish_bake}};
}

}  // namespace editor
