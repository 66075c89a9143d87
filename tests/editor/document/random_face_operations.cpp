#include <filesystem>
#include <functional>
#include <map>
#include <tuple>
#include <utility>
#include <variant>

#include "converters/mesh_operations/subdivide.h"
#include "editor/document/geometry_edits.h"
#include "editor/document/scene_places.h"
#include "tests/editor/document/random_session.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using Kind = PlainObject::Kind;
using Chosen = std::vector<std::pair<PlainPlace, std::set<std::size_t>>>;

void select(RandomSession& session) {
  const SceneObjects& objects = session.modelled.document().objects();
  FaceSelection selection(objects);
  for (std::uint32_t mesh = 0; mesh < objects.meshes.size(); ++mesh) {
    if (!session.one_in(3)) continue;
    const bool is_whole = session.one_in(2);
    for (std::uint32_t face = 0; face < objects.meshes[mesh].mesh->face_count(); ++face) {
      if (is_whole || session.one_in(2)) selection.set({mesh, face});
    }
  }
  session.modelled.document().select(std::move(selection));
}

/// The selected meshes, each place in a file once, with the faces that are selected in some instance.
Chosen chosen(RandomSession& session) {
  std::map<std::tuple<std::string, std::string, std::size_t>, Chosen::value_type> all;
  for (const PlainPlace& each : session.modelled.places()) {
    const auto mesh = session.modelled.document().objects().mesh_at(each.path);
    if (!mesh || session.modelled.selection().count(*mesh) == 0) continue;
    auto& [place, faces] = all[{each.file, each.name, each.object}];
    place = each;
    session.modelled.selection().for_each_face(*mesh, [&of = faces](std::size_t face) { of.insert(face); });
  }
  Chosen result;
  for (auto& [name, each] : all) result.push_back(std::move(each));
  return result;
}

SelectedFaces selected_faces(RandomSession& session) {
  return {session.modelled.scene(), session.modelled.document().objects(), session.modelled.selection()};
}

/// A name of this kind with the same meaning for all selected faces.
template <class Body>
std::optional<std::string> name_for_selection(RandomSession& session) {
  const SceneObjects& objects = session.modelled.document().objects();
  std::vector<grf::ScenePath> paths;
  for (const std::uint32_t mesh :
       at_all_places(session.modelled.scene(), objects, session.modelled.selection()).meshes()) {
    paths.push_back(objects.meshes[mesh].path);
  }
  std::vector<std::string> names;
  for (const PlacedDefinition& each : common_definitions(session.modelled.scene(), paths)) {
    if (std::holds_alternative<Body>(each.definition->body)) names.push_back(each.definition->name);
  }
  return names.empty() || session.one_in(2) ? std::nullopt
                                            : std::optional(names[session.below(names.size())]);
}

/// The mesh's own surface is that of its faces if they all share one.
void follow_faces(PlainMesh& mesh) {
  if (mesh.faces.empty()) return;
  const PlainSurface& first = mesh.faces.front().surface;
  const bool is_one = std::all_of(mesh.faces.begin(), mesh.faces.end(),
                                  [&](const PlainFace& face) { return face.surface == first; });
  if (is_one) mesh.own = first;
}

/// Edits the selected faces; the action edits a plain surface likewise.
void edit_surfaces(RandomSession& session, const char* text, const SurfaceEdit& edit, const QString& key,
                   const std::function<void(PlainSurface&, const std::string& naming_file)>& action) {
  PlainProject after = session.modelled.state();
  for (const auto& [place, faces] : chosen(session)) {
    PlainMesh& mesh = plain_mesh_at(after, place);
    const bool is_light = !place.is_definition() && object_at(after, place).kind == Kind::MeshLight;
    for (const std::size_t face : faces) {
      PlainSurface& surface = mesh.faces[face].surface;
      if (!is_light) {
        action(surface, place.file.empty() ? session.modelled.path() : place.file);
      } else if (edit.emission.is_any()) {
        surface.colour.reset();
        if (edit.emission.value()) surface.colour = colour_text(*edit.emission.value());
      }
    }
    follow_faces(mesh);
  }
  session.modelled.edit_surfaces(text, edit, std::move(after), key);
}

void give_colour(RandomSession& session, const QString& step_key) {
  SurfaceEdit edit;
  std::optional<std::string> given;
  if (const auto name = name_for_selection<grf::Colour>(session)) {
    given = "@" + *name;
    edit.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Reference{*name, {}});
  } else if (session.one_in(4)) {
    edit.colour = AttributeEdit<grf::ColourAttribute>::remove();
  } else {
    const grf::Colour value = session.colour();
    given = colour_text(value);
    edit.colour = AttributeEdit<grf::ColourAttribute>::set(value);
  }
  edit_surfaces(session, "Colour", edit, step_key,
                [&](PlainSurface& surface, const auto&) { surface.colour = given; });
}

void give_colour(RandomSession& session) { give_colour(session, session.key("colour")); }

void drag_colour(RandomSession& session) {
  for (std::size_t ticks = 2 + session.below(3); ticks > 0; --ticks) give_colour(session, "drag");
}

void give_brdf(RandomSession& session) {
  SurfaceEdit edit;
  std::optional<std::string> given;
  if (const auto name = name_for_selection<grf::BrdfModel>(session)) {
    given = "@" + *name;
    edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(grf::Reference{*name, {}});
  } else if (session.one_in(4)) {
    edit.brdf = AttributeEdit<grf::BrdfAttribute>::remove();
  } else {
    given = session.one_in(2) ? "phong n=20" : "ward sx=0.5";
    edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(brdf_model(*given));
  }
  edit_surfaces(session, "BRDF", edit, session.key("brdf"),
                [&](PlainSurface& surface, const auto&) { surface.brdf = given; });
}

void give_texture(RandomSession& session) {
  SurfaceEdit edit;
  const char* name = session.one_in(2) ? "steel.png" : "oak.png";
  const bool removes = session.one_in(4);
  edit.texture = removes ? AttributeEdit<grf::TextureAttribute>::remove()
                         : AttributeEdit<grf::TextureAttribute>::set(grf::Texture{name, {}});
  edit_surfaces(session, "Texture", edit, {}, [&](PlainSurface& surface, const std::string& naming_file) {
    surface.texture.reset();
    if (!removes) surface.texture = (std::filesystem::path(naming_file).parent_path() / name).string();
  });
}

void give_emission(RandomSession& session) {
  SurfaceEdit edit;
  std::optional<Plain3> given;
  if (session.one_in(3)) {
    edit.emission = AttributeEdit<grf::Colour>::remove();
  } else {
    const grf::Colour value = session.colour();
    given = plain(grf::Vec3d(value));
    edit.emission = AttributeEdit<grf::Colour>::set(value);
  }
  edit_surfaces(session, "Emission", edit, session.key("emission"),
                [&](PlainSurface& surface, const auto&) { surface.emission = given; });
}

void finish_gesture(RandomSession& session) { session.modelled.finish_gesture(); }

void flip(RandomSession& session) {
  PlainProject after = session.modelled.state();
  for (const auto& [place, faces] : chosen(session)) {
    for (const std::size_t face : faces) {
      auto& corners = plain_mesh_at(after, place).faces[face].corners;
      std::reverse(corners.begin() + 1, corners.end());
    }
  }
  session.replace("Flip", flipped(selected_faces(session)), after);
}

void smooth_normals(RandomSession& session) {
  session.replace("Smooth", with_smooth_normals(selected_faces(session), 1), session.modelled.state());
}

void paint_vertices(RandomSession& session) {
  PlainProject after = session.modelled.state();
  const grf::Colour value = session.colour();
  for (const auto& [place, faces] : chosen(session)) {
    for (const std::size_t face : faces) {
      for (PlainCorner& corner : plain_mesh_at(after, place).faces[face].corners) {
        corner.colour = plain(grf::Vec3d(value));
      }
    }
  }
  session.replace("Paint", with_vertex_colours(selected_faces(session), value), after, session.key("paint"));
}

void subdivide(RandomSession& session) {
  if (session.modelled.document().objects().faces > 100) return;
  const grf::Scene scene = with_subdivided_meshes(selected_faces(session), {});
  PlainProject found = plain_reading(scene, session.modelled.path()).project;
  PlainProject after = session.modelled.state();
  for (const auto& [place, faces] : chosen(session)) {
    std::vector<PlainFace>& coarse = plain_mesh_at(after, place).faces;
    std::vector<PlainFace> fine = plain_mesh_at(found, place).faces;
    // Vertex positions are covered by other tests.
    auto child = fine.begin();
    for (const PlainFace& face : coarse) {
      for (std::size_t i = 0; i < face.corners.size() && child != fine.end(); ++i, ++child) {
        child->surface = face.surface;
      }
    }
    if (child != fine.end()) session.modelled.fail("there are other subdivided faces");
    coarse = std::move(fine);
  }
  session.replace("Subdivide", scene, after);
}

void delete_faces(RandomSession& session) {
  PlainProject after = session.modelled.state();
  std::vector<PlainPlace> empty;
  for (const auto& [place, faces] : chosen(session)) {
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
  session.replace("Delete faces", without_faces(selected_faces(session)), after);
}

}  // namespace

std::vector<RandomOperation> face_operations() {
  return {{"select", select},
          {"select", select},
          {"drag colour", drag_colour},
          {"colour", give_colour},
          {"BRDF", give_brdf},
          {"texture", give_texture},
          {"texture", give_texture},
          {"emission", give_emission},
          {"finish gesture", finish_gesture},
          {"flip", flip},
          {"smooth normals", smooth_normals},
          {"paint vertices", paint_vertices},
          {"subdivide", subdivide},
          {"delete faces", delete_faces}};
}

}  // namespace editor
