// Fuzzes a document with thousands of random edits, undos, redos, saves, reloads, late results and external
// file changes, and compares it with a model of plain values after each.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "converters/mesh_operations/subdivide.h"
#include "editor/document/definitions.h"
#include "editor/document/geometry_edits.h"
#include "editor/document/light_edits.h"
#include "editor/document/object_edits.h"
#include "editor/document/scene_places.h"
#include "editor/rendering/baked_irradiance.h"
#include "grf/read.h"
#include "tests/editor/document/modelled_document.h"
#include "tests/editor/document/plain_edits.h"
#include "tests/editor/scene_of.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/thoroughness.h"

namespace editor {
namespace {

using Kind = PlainObject::Kind;

std::string mesh_text(const std::string& head) {
  return "begin mesh " + head +
         " begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) (0,0,1) end vertexs "
         "begin faces (0,1,2,3) (0,1,4) rgb (0,1,0) (1,2,4) end faces end mesh\n";
}

std::string main_text() {
  return "// The project's file.\ndef red = rgb (1,0,0)\n gold = brdf ward sx=0.2\n matt = brdf diffuse "
         "kd=0.25\n"
         " mix = brdf combine 0.5 gold, 0.5 matt\n tile = " +
         mesh_text("rgb red") + "begin\n use tile\n transform scale (2,2,2) begin use tile\n" +
         mesh_text("\"box\" brdf gold") +
         "end\n include \"part.grf\"\n"
         " transform scale (2,2,2) translation (8,0,0) begin include \"part.grf\" end\n" +
         mesh_text("\"floor\" brdf mix texture \"wood.png\"") +
         "light begin (0,0,4) (1,0,4) (0,1,4) end\n"
         "mesh light begin rgb (5,5,5) begin vertexs (0,0,3) (1,0,3) (0,1,3) end begin faces (0,1,2) end "
         "end\n"
         "params begin dependent view (1,2,3) end\n end\n";
}

/// Contents of the included file: initially, and when other programs write it.
std::vector<std::string> part_texts() {
  return {mesh_text("\"panel\" texture \"part.png\"") + "transform translation (1,2,3) begin " +
              mesh_text("\"knob\" rgb (0,0,1)") + "end\n",
          mesh_text("\"other_panel\""), "def bolt = " + mesh_text("") + "begin use bolt use bolt end\n"};
}

std::string model_text() {
  return mesh_text("\"extra\" texture \"brick.png\"") + "light begin (0,0,5) (1,0,5) (0,1,5) end\n";
}

std::string colour_text(const grf::Colour& colour) {
  return fmt::format("{} {} {}", colour.x, colour.y, colour.z);
}

Plain3 plain(const grf::Vec3d& value) { return {float(value.x), float(value.y), float(value.z)}; }

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

/// An operation and the seed of its choices, so that a sequence stays valid if some are left out.
struct Operation {
  std::size_t kind = 0;
  std::uint32_t seed = 0;
};

class Session {
 public:
  Session() {
    folder_.add("b/notes.txt", "a folder to save in");
    modelled_.write(part_, part_texts().front());
    modelled_.write(main_, main_text());
    folder_.add("c/model.grf", model_text());
    modelled_.open(main_);
    modelled_.check();
  }

  /// Returns an error message after an operation, or nothing.
  std::string run(const Operation& operation) {
    random_.seed(operation.seed);
    (this->*Operations[operation.kind].run)();
    return modelled_.check();
  }

  struct Named {
    const char* name;
    void (Session::*run)();
  };
  static const std::vector<Named> Operations;

 private:
  using Chosen = std::vector<std::pair<PlainPlace, std::set<std::size_t>>>;

  std::size_t below(std::size_t count) { return random_() % count; }
  bool one_in(std::size_t count) { return below(count) == 0; }
  float number() { return static_cast<float>(below(8)); }
  /// One of few colours, so that faces come to share them.
  grf::Colour colour() { return {float(below(2)), float(below(2)), float(below(2))}; }
  grf::Vec3d offset() { return {double(number()) * 2, double(number()) * 2, double(number()) * 2}; }
  QString key(const char* name) { return one_in(2) ? QString(name) : QString(); }

  template <class Condition>
  std::optional<PlainPlace> place(const Condition& condition) {
    std::vector<PlainPlace> found;
    const auto& places = modelled_.places();
    std::copy_if(places.begin(), places.end(), std::back_inserter(found), condition);
    return found.empty() ? std::nullopt : std::optional(found[below(found.size())]);
  }
  std::optional<PlainPlace> object_of(const std::set<Kind>& kinds) {
    PlainProject project = modelled_.state();
    return place([&](const PlainPlace& each) {
      return !each.is_definition() && kinds.contains(object_at(project, each).kind);
    });
  }
  std::optional<PlainPlace> movable_object() {
    return object_of({Kind::Mesh, Kind::MeshLight, Kind::Light, Kind::Use, Kind::Include});
  }
  bool is_full() const { return modelled_.places().size() > 40; }

  /// Applies the result of an edit.
  void replace(const QString& text, std::optional<grf::Scene> scene, PlainProject after,
               const QString& key = {}) {
    if (scene) return modelled_.replace(text, std::move(*scene), std::move(after), key);
    modelled_.fail(text.toStdString() + " was refused: " + std::exchange(diagnostics_, {}).to_text());
  }
  void expect_refused(const std::optional<grf::Scene>& scene, const std::string& what) {
    if (scene) modelled_.fail(what + " was not refused");
    diagnostics_ = {};
  }

  // Faces.

  void select() {
    const SceneObjects& objects = modelled_.document().objects();
    FaceSelection selection(objects);
    for (std::uint32_t mesh = 0; mesh < objects.meshes.size(); ++mesh) {
      if (!one_in(3)) continue;
      const bool is_whole = one_in(2);
      for (std::uint32_t face = 0; face < objects.meshes[mesh].mesh->face_count(); ++face) {
        if (is_whole || one_in(2)) selection.set({mesh, face});
      }
    }
    modelled_.document().select(std::move(selection));
  }
  /// The selected meshes, each place in a file once, with the faces that are selected in some instance.
  Chosen chosen() {
    std::map<std::tuple<std::string, std::string, std::size_t>, Chosen::value_type> all;
    for (const PlainPlace& each : modelled_.places()) {
      const auto mesh = modelled_.document().objects().mesh_at(each.path);
      if (!mesh || modelled_.selection().count(*mesh) == 0) continue;
      auto& [place, faces] = all[{each.file, each.name, each.object}];
      place = each;
      modelled_.selection().for_each_face(*mesh, [&of = faces](std::size_t face) { of.insert(face); });
    }
    Chosen chosen;
    for (auto& [name, each] : all) chosen.push_back(std::move(each));
    return chosen;
  }
  SelectedFaces selected_faces() {
    return {modelled_.scene(), modelled_.document().objects(), modelled_.selection()};
  }
  /// A name of this kind with the same meaning for all selected faces.
  template <class Body>
  std::optional<std::string> name_for_selection() {
    const SceneObjects& objects = modelled_.document().objects();
    std::vector<grf::ScenePath> paths;
    for (const std::uint32_t mesh :
         at_all_places(modelled_.scene(), objects, modelled_.selection()).meshes()) {
      paths.push_back(objects.meshes[mesh].path);
    }
    std::vector<std::string> names;
    for (const PlacedDefinition& each : common_definitions(modelled_.scene(), paths)) {
      if (std::holds_alternative<Body>(each.definition->body)) names.push_back(each.definition->name);
    }
    return names.empty() || one_in(2) ? std::nullopt : std::optional(names[below(names.size())]);
  }

  /// The mesh's own surface is that of its faces if they all share one.
  static void follow_faces(PlainMesh& mesh) {
    if (mesh.faces.empty()) return;
    const PlainSurface& first = mesh.faces.front().surface;
    const bool is_one = std::all_of(mesh.faces.begin(), mesh.faces.end(),
                                    [&](const PlainFace& face) { return face.surface == first; });
    if (is_one) mesh.own = first;
  }
  /// Edits the selected faces; the action edits a plain surface likewise.
  void edit_surfaces(const char* text, const SurfaceEdit& edit, const QString& key,
                     const std::function<void(PlainSurface&, const std::string& naming_file)>& action) {
    PlainProject after = modelled_.state();
    for (const auto& [place, faces] : chosen()) {
      PlainMesh& mesh = plain_mesh_at(after, place);
      const bool is_light = !place.is_definition() && object_at(after, place).kind == Kind::MeshLight;
      for (const std::size_t face : faces) {
        PlainSurface& surface = mesh.faces[face].surface;
        if (!is_light) {
          action(surface, place.file.empty() ? modelled_.path() : place.file);
        } else if (edit.emission.is_any()) {
          surface.colour.reset();
          if (edit.emission.value()) surface.colour = colour_text(*edit.emission.value());
        }
      }
      follow_faces(mesh);
    }
    modelled_.edit_surfaces(text, edit, std::move(after), key);
  }
  void drag_colour() {
    for (std::size_t ticks = 2 + below(3); ticks > 0; --ticks) give_colour("drag");
  }
  void give_colour() { give_colour(key("colour")); }
  void give_colour(const QString& step_key) {
    SurfaceEdit edit;
    std::optional<std::string> given;
    if (const auto name = name_for_selection<grf::Colour>()) {
      given = "@" + *name;
      edit.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Reference{*name, {}});
    } else if (one_in(4)) {
      edit.colour = AttributeEdit<grf::ColourAttribute>::remove();
    } else {
      const grf::Colour value = colour();
      given = colour_text(value);
      edit.colour = AttributeEdit<grf::ColourAttribute>::set(value);
    }
    edit_surfaces("Colour", edit, step_key,
                  [&](PlainSurface& surface, const auto&) { surface.colour = given; });
  }
  void give_brdf() {
    SurfaceEdit edit;
    std::optional<std::string> given;
    if (const auto name = name_for_selection<grf::BrdfModel>()) {
      given = "@" + *name;
      edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(grf::Reference{*name, {}});
    } else if (one_in(4)) {
      edit.brdf = AttributeEdit<grf::BrdfAttribute>::remove();
    } else {
      given = one_in(2) ? "phong n=20" : "ward sx=0.5";
      edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(brdf_model(*given));
    }
    edit_surfaces("BRDF", edit, key("brdf"),
                  [&](PlainSurface& surface, const auto&) { surface.brdf = given; });
  }
  void give_texture() {
    SurfaceEdit edit;
    const char* name = one_in(2) ? "steel.png" : "oak.png";
    const bool removes = one_in(4);
    edit.texture = removes ? AttributeEdit<grf::TextureAttribute>::remove()
                           : AttributeEdit<grf::TextureAttribute>::set(grf::Texture{name, {}});
    edit_surfaces("Texture", edit, {}, [&](PlainSurface& surface, const std::string& naming_file) {
      surface.texture.reset();
      if (!removes) surface.texture = (std::filesystem::path(naming_file).parent_path() / name).string();
    });
  }
  void give_emission() {
    SurfaceEdit edit;
    std::optional<Plain3> given;
    if (one_in(3)) {
      edit.emission = AttributeEdit<grf::Colour>::remove();
    } else {
      const grf::Colour value = colour();
      given = plain(grf::Vec3d(value));
      edit.emission = AttributeEdit<grf::Colour>::set(value);
    }
    edit_surfaces("Emission", edit, key("emission"),
                  [&](PlainSurface& surface, const auto&) { surface.emission = given; });
  }
  void finish_gesture() { modelled_.finish_gesture(); }

  void flip() {
    PlainProject after = modelled_.state();
    for (const auto& [place, faces] : chosen()) {
      for (const std::size_t face : faces) {
        auto& corners = plain_mesh_at(after, place).faces[face].corners;
        std::reverse(corners.begin() + 1, corners.end());
      }
    }
    replace("Flip", flipped(selected_faces()), after);
  }
  void smooth_normals() { replace("Smooth", with_smooth_normals(selected_faces(), 1), modelled_.state()); }
  void paint_vertices() {
    PlainProject after = modelled_.state();
    const grf::Colour value = colour();
    for (const auto& [place, faces] : chosen()) {
      for (const std::size_t face : faces) {
        for (PlainCorner& corner : plain_mesh_at(after, place).faces[face].corners) {
          corner.colour = plain(grf::Vec3d(value));
        }
      }
    }
    replace("Paint", with_vertex_colours(selected_faces(), value), after, key("paint"));
  }
  void subdivide() {
    if (modelled_.document().objects().faces > 100) return;
    const grf::Scene scene = with_subdivided_meshes(selected_faces(), {});
    PlainProject found = plain_reading(scene, modelled_.path()).project;
    PlainProject after = modelled_.state();
    for (const auto& [place, faces] : chosen()) {
      std::vector<PlainFace>& coarse = plain_mesh_at(after, place).faces;
      std::vector<PlainFace> fine = plain_mesh_at(found, place).faces;
      // Vertex positions are covered by other tests.
      auto child = fine.begin();
      for (const PlainFace& face : coarse) {
        for (std::size_t i = 0; i < face.corners.size() && child != fine.end(); ++i, ++child) {
          child->surface = face.surface;
        }
      }
      if (child != fine.end()) modelled_.fail("there are other subdivided faces");
      coarse = std::move(fine);
    }
    replace("Subdivide", scene, after);
  }
  void delete_faces() {
    PlainProject after = modelled_.state();
    std::vector<PlainPlace> empty;
    for (const auto& [place, faces] : chosen()) {
      std::vector<PlainFace>& all = plain_mesh_at(after, place).faces;
      for (auto face = faces.rbegin(); face != faces.rend(); ++face) {
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(*face));
      }
      follow_faces(plain_mesh_at(after, place));
      if (all.empty()) empty.push_back(place);
    }
    // Objects first, and backwards, so that the remaining places stay valid.
    std::sort(empty.begin(), empty.end(), [](const PlainPlace& a, const PlainPlace& b) {
      return std::pair(!a.is_definition(), a.object) > std::pair(!b.is_definition(), b.object);
    });
    for (const PlainPlace& place : empty) {
      place.is_definition() ? erase_defined_mesh(after, place) : erase_object(after, place);
    }
    replace("Delete faces", without_faces(selected_faces()), after);
  }

  // Objects.

  void rename() {
    PlainProject after = modelled_.state();
    const auto at = place([&](const PlainPlace& each) {
      return each.is_definition() || object_at(after, each).kind == Kind::Mesh;
    });
    if (!at) return;
    const std::string name = fresh_plain_name(after, fmt::format("name{}", below(6)));
    if (at->is_definition()) {
      expect_refused(rename_object(modelled_.scene(), at->path, "no name", diagnostics_),
                     "the name 'no name'");
      rename_plain_definition(after, *at, name);
    } else {
      object_at(after, *at).name = name;
    }
    replace("Rename", rename_object(modelled_.scene(), at->path, name, diagnostics_), after);
  }
  static void shift(PlainObject& object, const grf::Vec3d& by, const PlainPlace& place) {
    for (std::size_t i = 0; i < 3; ++i) object.offset[i] += plain(by)[i] / place.file_scale;
  }
  void move() {
    const auto at = movable_object();
    if (!at) return;
    const grf::Vec3d by = offset();
    PlainProject after = modelled_.state();
    shift(object_at(after, *at), by, *at);
    replace("Move", move_object(modelled_.scene(), at->path, by, diagnostics_), after, key("move"));
  }
  void duplicate() {
    const auto at = movable_object();
    if (!at || is_full()) return;
    const grf::Vec3d by = offset();
    PlainProject after = modelled_.state();
    PlainObject& original = object_at(after, *at);
    if (original.kind == Kind::Mesh) {
      const std::string name = fresh_plain_name(after, original.name.empty() ? "mesh" : original.name);
      file_at(after, *at).definitions[name] = {true, {}, std::exchange(original.mesh, {})};
      original.kind = Kind::Use;
      original.name = name;
    }
    PlainObject copy = original;
    shift(copy, by, *at);
    auto& objects = file_at(after, *at).objects;
    objects.insert(objects.begin() + static_cast<std::ptrdiff_t>(at->object) + 1, copy);
    replace("Duplicate", duplicate_object(modelled_.scene(), at->path, by, diagnostics_), after);
  }
  void remove() {
    const auto at = place([](const PlainPlace&) { return true; });
    if (!at) return;
    PlainProject after = modelled_.state();
    const auto scene = remove_objects(modelled_.scene(), {at->path}, {}, diagnostics_);
    if (!at->is_definition()) {
      erase_object(after, *at);
    } else if (is_used(after, at->name)) {
      return expect_refused(scene, "deleting what is used");
    } else {
      file_at(after, *at).definitions.erase(at->name);
    }
    replace("Delete", scene, after);
  }
  void new_light() {
    grf::AreaLight light;
    light.corner = grf::Vec3f(number(), number(), 9);
    light.edge1 = grf::Vec3f(1, 0, 0);
    light.edge2 = grf::Vec3f(0, 1, 0);
    PlainProject after = modelled_.state();
    PlainObject& added = after.main.objects.emplace_back();
    added.kind = Kind::Light;
    added.points = {{light.corner.x, light.corner.y, 9}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
    replace("Add light", add_light(modelled_.scene(), light), after);
  }
  void edit_light() {
    const auto at = object_of({Kind::Light});
    if (!at) return;
    PlainProject after = modelled_.state();
    grf::AreaLight light = std::get<grf::AreaLight>(block_at(modelled_.scene(), at->path)->content);
    light.radiance = colour();
    object_at(after, *at).points.back() = plain(grf::Vec3d(*light.radiance));
    replace("Light", change_light(modelled_.scene(), at->path, light, diagnostics_), after, key("light"));
  }
  void new_observer() {
    const grf::Vec3d position = offset();
    PlainProject after = modelled_.state();
    auto& objects = after.main.objects;
    auto block = std::find_if(objects.begin(), objects.end(),
                              [](const PlainObject& each) { return each.kind == Kind::Observers; });
    if (block == objects.end()) {
      block = objects.insert(block, PlainObject());
      block->kind = Kind::Observers;
    }
    block->points.push_back(plain(position));
    replace("Add observer", add_observer(modelled_.scene(), position), after);
  }
  void edit_observers() {
    const auto at = object_of({Kind::Observers});
    if (!at) return;
    PlainProject after = modelled_.state();
    auto& points = object_at(after, *at).points;
    const std::size_t number = below(points.size());
    const auto& observers = modelled_.document().objects().observers;
    const auto one = std::find_if(observers.begin(), observers.end(), [&](const ObserverObject& each) {
      return each.path == at->path && each.number == number;
    });
    if (one == observers.end()) return modelled_.fail("an observer is not among the objects");
    if (one_in(2)) {
      points[number] = {7, 7, 7};
      return replace("Move observer", move_observer(modelled_.scene(), *one, grf::Vec3d(7), diagnostics_),
                     after, key("observer"));
    }
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(number));
    if (points.empty()) erase_object(after, *at);
    replace("Delete observer", remove_objects(modelled_.scene(), {}, {*one}, diagnostics_), after);
  }

  // Definitions and options.

  void new_definition() {
    PlainProject after = modelled_.state();
    const bool is_colour = one_in(2);
    const grf::Colour value = colour();
    const std::string wanted = is_colour ? "hue" : "gloss";
    after.main.definitions[fresh_plain_name(after, wanted)] = {
        false, is_colour ? colour_text(value) : "phong n=5", {}};
    const auto defined =
        define(modelled_.scene(), wanted,
               is_colour ? grf::Definition::Body(value) : grf::Definition::Body(brdf_model("phong n=5")),
               diagnostics_);
    replace("Define", defined ? std::optional(defined->scene) : std::nullopt, after);
  }
  void edit_definition() {
    PlainProject after = modelled_.state();
    const auto at = place([&](const PlainPlace& each) {
      return each.is_definition() && !file_at(after, each).definitions.at(each.name).is_mesh;
    });
    if (!at) return;
    const bool is_colour =
        std::holds_alternative<grf::Colour>(definition_at(modelled_.scene(), at->path)->body);
    const grf::Colour value = colour();
    std::string& text = file_at(after, *at).definitions.at(at->name).text;
    text = is_colour ? colour_text(value) : fmt::format("ward sx=0.{}", 1 + below(8));
    const grf::Definition::Body body =
        is_colour ? grf::Definition::Body(value) : grf::Definition::Body(brdf_model(text));
    replace("Edit", change_definition(modelled_.scene(), at->path, body, diagnostics_), after,
            key("definition"));
  }
  void remove_unused() {
    PlainProject after = modelled_.state();
    erase_unused_definitions(after);
    replace("Remove unused", remove_unused_definitions(modelled_.scene()), after);
  }
  void edit_options() { modelled_.set_depth(1 + static_cast<int>(below(3)), key("depth")); }

  // History and files.

  std::size_t steps() { return one_in(3) ? 100 : 1 + below(3); }
  void undo() {
    for (std::size_t count = steps(); count > 0; --count) modelled_.undo();
  }
  void redo() {
    for (std::size_t count = steps(); count > 0; --count) modelled_.redo();
  }
  void save() {
    const bool is_igrf = has_irradiance(modelled_.state().main);
    const std::string name = std::vector<std::string>{"a/main", "a/copy", "b/main"}[below(3)];
    const bool stays = one_in(2) && (!is_igrf || modelled_.path().ends_with(".igrf"));
    modelled_.save(stays ? modelled_.path() : folder_.path(name + (is_igrf ? ".igrf" : ".grf")));
  }
  void reload() {
    const std::vector<std::string> paths = modelled_.paths();
    const bool can_revert = std::count(paths.begin(), paths.end(), modelled_.path()) > 0;
    if (!paths.empty())
      modelled_.open(can_revert && one_in(2) ? modelled_.path() : paths[below(paths.size())]);
  }
  void change_outside() {
    const std::vector<std::string> texts = part_texts();
    modelled_.write(part_, texts[below(texts.size())]);
    if (one_in(2)) modelled_.write(main_, main_text());
  }

  // Late results.

  void merge() {
    if (is_full()) return;
    const std::string path = folder_.path("c/model.grf");
    if (!model_) {
      grf::Diagnostics diagnostics;
      model_ = grf::read(path, diagnostics);
      return;
    }
    PlainProject after = modelled_.state();
    const PlainFile added = plain_reading(*model_, path).project.main;
    after.main.objects.insert(after.main.objects.end(), added.objects.begin(), added.objects.end());
    modelled_.merge("Merge", *model_, path, after);
    model_.reset();
  }
  void begin_bake() {
    snapshot_ = modelled_.scene();
    scenes_at_snapshot_ = modelled_.scenes();
  }
  /// Irradiance is applied to meshes whose geometry and transform equal those of the snapshot.
  void finish_bake() {
    if (!snapshot_) return;
    const std::vector<Placed> then = placed_meshes(*snapshot_);
    const std::vector<Placed> now = placed_meshes(modelled_.scene());
    std::vector<float> expected = irradiances(now);
    std::size_t found = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const auto same = std::find_if(then.begin(), then.end(),
                                     [&](const Placed& each) { return each.is_at_place_of(now[i]); });
      if (same == then.end()) continue;
      expected[i] = static_cast<float>(same - then.begin() + 1);
      ++found;
    }
    const IrradiatedScene result =
        BakedIrradiance(*snapshot_, baked(then)).applied_to(modelled_.scene(), modelled_.path());
    const std::vector<float> values = irradiances(placed_meshes(result.scene));
    if (result.meshes != found) modelled_.fail("irradiance is given to other meshes");
    if (values != expected) modelled_.fail(fmt::format("irradiance {} where {} is right", values, expected));
    if (modelled_.scenes() != scenes_at_snapshot_ && result.meshes > 0) {
      modelled_.fail("irradiance of a scene that was replaced");
    }
    // Includes and names are covered by other tests.
    PlainReading reading = plain_reading(result.scene, modelled_.path());
    PlainProject& after = reading.project;
    if (result.meshes == 0 || !reading.has_one_meaning_per_name || have_unclear_names(after)) return;
    after.depth = modelled_.state().depth;
    after.background = modelled_.state().background;
    replace("Bake", result.scene, after);
  }

  const test::TemporaryFolder folder_;
  const std::string main_ = folder_.add("a/main.grf", "");
  const std::string part_ = folder_.add("a/part.grf", "");
  ModelledDocument modelled_;
  std::mt19937 random_;
  grf::Diagnostics diagnostics_;
  std::optional<grf::Scene> model_;
  std::optional<grf::Scene> snapshot_;
  int scenes_at_snapshot_ = 0;
};

const std::vector<Session::Named> Session::Operations = {{"select", &Session::select},
                                                         {"select", &Session::select},
                                                         {"drag colour", &Session::drag_colour},
                                                         {"colour", &Session::give_colour},
                                                         {"BRDF", &Session::give_brdf},
                                                         {"texture", &Session::give_texture},
                                                         {"texture", &Session::give_texture},
                                                         {"emission", &Session::give_emission},
                                                         {"finish gesture", &Session::finish_gesture},
                                                         {"flip", &Session::flip},
                                                         {"smooth normals", &Session::smooth_normals},
                                                         {"paint vertices", &Session::paint_vertices},
                                                         {"subdivide", &Session::subdivide},
                                                         {"delete faces", &Session::delete_faces},
                                                         {"rename", &Session::rename},
                                                         {"move", &Session::move},
                                                         {"duplicate", &Session::duplicate},
                                                         {"delete", &Session::remove},
                                                         {"add light", &Session::new_light},
                                                         {"edit light", &Session::edit_light},
                                                         {"add observer", &Session::new_observer},
                                                         {"edit observers", &Session::edit_observers},
                                                         {"define", &Session::new_definition},
                                                         {"edit definition", &Session::edit_definition},
                                                         {"remove unused", &Session::remove_unused},
                                                         {"options", &Session::edit_options},
                                                         {"undo", &Session::undo},
                                                         {"undo", &Session::undo},
                                                         {"undo", &Session::undo},
                                                         {"redo", &Session::redo},
                                                         {"redo", &Session::redo},
                                                         {"save", &Session::save},
                                                         {"save", &Session::save},
                                                         {"reload", &Session::reload},
                                                         {"change outside", &Session::change_outside},
                                                         {"merge", &Session::merge},
                                                         {"begin bake", &Session::begin_bake},
                                                         {"finish bake", &Session::finish_bake}};

std::string problem_of(const std::vector<Operation>& operations) {
  Session session;
  for (const Operation& operation : operations) {
    std::string problem = session.run(operation);
    if (!problem.empty()) return problem;
  }
  return {};
}

/// Removes operations that are not needed for the failure, and prints the rest.
std::string story_of(std::vector<Operation> operations) {
  for (std::size_t i = operations.size(); i-- > 0;) {
    std::vector<Operation> fewer = operations;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (!problem_of(fewer).empty()) operations = std::move(fewer);
  }
  std::string story;
  for (const Operation& each : operations) {
    story += fmt::format("{} ({})\n", Session::Operations[each.kind].name, each.seed);
  }
  return story + problem_of(operations);
}

TEST(RandomEdits, LeaveADocumentAsPlainValuesSay) {
  const std::uint32_t sessions = test::tries_all() ? 3000 : 150;
  for (std::uint32_t seed = 1; seed <= sessions; ++seed) {
    std::mt19937 random(seed);
    std::vector<Operation> operations(60);
    for (Operation& each : operations) {
      each = {random() % Session::Operations.size(), static_cast<std::uint32_t>(random())};
    }
    ASSERT_TRUE(problem_of(operations).empty()) << "session " << seed << "\n" << story_of(operations);
  }
}

}  // namespace
}  // namespace editor
