#include "editor/window/mesh_actions.h"

#include <QLocale>
#include <QWidget>
#include <algorithm>
#include <memory>

#include "converters/mesh_operations/subdivide.h"
#include "editor/controls/actions.h"
#include "editor/document/document.h"
#include "editor/document/texture_coordinates.h"
#include "editor/jobs/job_list.h"
#include "grf/scene_path.h"

namespace editor {
namespace {

/// The maximum number of faces that the editor handles well: more need `grfconvert --subdivide`.
constexpr double MostFaces = 2e7;
/// Enough to remove the noise of a scan, and few enough to keep features such as a nose.
constexpr int SmoothingSteps = 10;

const QString MeshQueue = QStringLiteral("meshes");

/// Sets the edited geometry of a mesh if it is unchanged except for its surfaces, which are kept. Returns
/// false if it is not.
bool take_geometry(grf::Shared<grf::Mesh>& now, const grf::Mesh& before, const grf::Mesh& edited) {
  const bool is_same = now->geometry.shares(before.geometry) && now->irradiance.shares(before.irradiance) &&
                       now->surface_of_face.shares(before.surface_of_face);
  if (!is_same || edited.surfaces != before.surfaces) return false;
  grf::Mesh taken = edited;
  taken.surfaces = now->surfaces;
  now = std::move(taken);
  return true;
}

bool have_same_places(const SceneObjects& a, const SceneObjects& b) {
  return std::equal(a.meshes.begin(), a.meshes.end(), b.meshes.begin(), b.meshes.end(),
                    [](const MeshObject& one, const MeshObject& other) { return one.path == other.path; });
}

}  // namespace

/// A scene that was edited in a thread.
struct MeshActions::Edited {
  grf::Scene before;
  std::uint64_t revision;  ///< of the document with that scene
  std::shared_ptr<const SceneObjects> objects;
  FaceSelection selection;
  grf::Scene after;
  bool keeps_places = false;  ///< no mesh was removed
};

MeshActions::MeshActions(Document& document, JobList& jobs, QWidget& window)
    : QObject(&window), document_(document), jobs_(jobs) {
  const QString whole =
      tr("of the selected faces, or of all if none is selected. Faces keep their BRDFs and colours");
  delete_faces_ = new_action(window,
                             {tr("&Delete faces"), "delete", QKeySequence("Shift+Del"),
                              tr("Delete the selected faces, and meshes that have no faces left")},
                             [this] { remove(); });
  const auto add = [&](const QString& text, const QString& tip, const std::function<void()>& action) {
    of_meshes_.append(new_action(window, {text, {}, {}, tip.arg(whole)}, action));
  };
  add(tr("Subdivide (&Catmull-Clark)"), tr("Subdivide the meshes %1; a face with n corners becomes n quads"),
      [this] { subdivide(convert::SubdivisionScheme::CatmullClark); });
  add(tr("Subdi&vide (Loop)"),
      tr("Subdivide the meshes %1; they are triangulated, and each triangle becomes four"),
      [this] { subdivide(convert::SubdivisionScheme::Loop); });
  add(tr("S&mooth vertices"), tr("Smooth noise and small features of the meshes %1"), [this] { smooth(); });
  of_meshes_.append(
      new_action(window,
                 {tr("&Recalculate outside"),
                  {},
                  QKeySequence("Shift+N"),
                  tr("Make the normals of the faces agree and point outward, in the meshes %1").arg(whole)},
                 [this] { start(tr("Recalculate outside"), selected_or_all(), with_outward_faces); }));
  of_meshes_.append(
      new_action(window,
                 {tr("Select &inward faces"),
                  {},
                  QKeySequence("Ctrl+Shift+N"),
                  tr("Select the faces whose normals point inward (flipped normals), in the meshes of the "
                     "selected faces, or in all if none is selected")},
                 [this] { select_inward(); }));
  make_projections(window);
  make_uv_transforms(window);
  connect(&jobs_, &JobList::changed, this, [this] {
    for (QAction* action : all()) action->setEnabled(!jobs_.is_busy(MeshQueue));
  });
}

void MeshActions::add_uv_edit(QWidget& window, const QString& text, const QString& tip, const Edit& edit) {
  const QString title = QString(text).remove('&');
  of_texture_coordinates_.append(new_action(window, {text, {}, {}, tip}, [this, title, edit] {
    if (document_.selection().empty()) return emit status_message(tr("No face is selected"));
    start(title, document_.selection(), edit);
  }));
}

void MeshActions::make_projections(QWidget& window) {
  const auto add = [&](const QString& text, UvProjection projection, const QString& from) {
    add_uv_edit(window, text, tr("Project the image onto the selected faces %1").arg(from),
                [projection](const SelectedFaces& faces) { return with_projected_uvs(faces, projection); });
  };
  add(tr("Project along the &normal"), UvProjection::AlongNormal, tr("along their mean normal"));
  add(tr("Project along &x"), UvProjection::AlongX, tr("on a plane, as seen from +x"));
  add(tr("Project along &y"), UvProjection::AlongY, tr("on a plane, as seen from above"));
  add(tr("Project along &z"), UvProjection::AlongZ, tr("on a plane, as seen from +z"));
  add(tr("Project from a &box"), UvProjection::Box,
      tr("from the side of a box that is nearest to the normal of each"));
  add(tr("Project from a &cylinder"), UvProjection::Cylinder,
      tr("around a vertical cylinder; on caps from above and below"));
  add(tr("Project from a &sphere"), UvProjection::Sphere, tr("by longitude and latitude about their centre"));
}

void MeshActions::make_uv_transforms(QWidget& window) {
  const auto add = [&](const QString& text, const QString& tip,
                       const std::function<UvTransform(const UvBounds&)>& transform) {
    add_uv_edit(window, text, tip, [transform](const SelectedFaces& faces) {
      const UvBounds bounds = uv_bounds(faces.objects, faces.selection);
      return bounds.isEmpty() ? faces.scene : with_transformed_uvs(faces, transform(bounds));
    });
  };
  const auto scaled = [](double u, double v) {
    return [u, v](const UvBounds& bounds) { return UvTransform{bounds.center(), {u, v}, 0, {0, 0}}; };
  };
  add(tr("&Rotate by 90°"), tr("Rotate the texture coordinates of the selected faces to the left"),
      [](const UvBounds& bounds) {
        return UvTransform{bounds.center(), {1, 1}, 90, {0, 0}};
      });
  add(tr("Flip &horizontally"), tr("Mirror the texture coordinates of the selected faces, left to right"),
      scaled(-1, 1));
  add(tr("Flip &vertically"), tr("Mirror the texture coordinates of the selected faces, top to bottom"),
      scaled(1, -1));
  add(tr("&Fit to the image"),
      tr("Scale and move the texture coordinates of the selected faces to the whole image"),
      [](const UvBounds& bounds) {
        return fitted(bounds, {{0, 0}, {1, 1}});
      });
}

FaceSelection MeshActions::selected_or_all() const {
  FaceSelection selection = document_.selection();
  if (selection.empty()) selection.select_all();
  return selection;
}

void MeshActions::subdivide(convert::SubdivisionScheme scheme) {
  const convert::Subdivision once = {scheme, 1};
  const FaceSelection selection = selected_or_all();
  const SelectedFaces faces = {document_.scene(), document_.objects(), selection};
  const double after = faces_after(faces, once);
  if (after == 0) return emit status_message(tr("The scene has no mesh"));
  if (after > MostFaces) {
    return emit failed(
        tr("Cannot subdivide: the meshes would have %1 faces, too many for the editor. Subdivide the "
           "file with grfconvert --subdivide")
            .arg(QLocale().toString(after, 'f', 0)));
  }
  const CommonVertices common = common_vertices(document_.objects(), selection);
  const bool had_irradiance = common.irradiance.value || common.irradiance.is_mixed;
  start(tr("Subdivide"), selection,
        [once](const SelectedFaces& selected) { return with_subdivided_meshes(selected, once); });
  if (had_irradiance) emit status_message(tr("Subdivided meshes lost their irradiance: bake it again"));
}

void MeshActions::smooth() {
  const FaceSelection selection = selected_or_all();
  if (selection.empty()) return emit status_message(tr("The scene has no mesh"));
  start(tr("Smooth vertices"), selection,
        [](const SelectedFaces& selected) { return with_smooth_meshes(selected, SmoothingSteps); });
}

void MeshActions::select_inward() {
  const std::shared_ptr<const SceneObjects> objects = document_.shared_objects();
  const auto find = [scene = document_.scene(), objects, selection = selected_or_all()] {
    return inward_faces({scene, *objects, selection});
  };
  const auto take = [this, objects](const FaceSelection& found) {
    if (document_.shared_objects() != objects) return;  // of a scene that was edited meanwhile
    if (found.empty()) emit status_message(tr("All faces point outward"));
    document_.select(found);
  };
  if (objects->faces < FewFaces) return take(find());
  jobs_.add({tr("Find inward faces"),
             MeshQueue,
             [find, take](Job& job) { job.run(find, take); },
             {},
             tr("Cancel: the selection stays as it is")});
}

void MeshActions::remove() {
  if (document_.selection().empty()) return emit status_message(tr("No face is selected"));
  start(tr("Delete faces"), document_.selection(), without_faces);
}

void MeshActions::start(const QString& title, const FaceSelection& selection, const Edit& edit) {
  const Edited snapshot = {
      document_.scene(), document_.revision(), document_.shared_objects(), selection, {}, false};
  if (snapshot.objects->faces < FewFaces) {
    return document_.replace(title, edit({snapshot.before, *snapshot.objects, selection}));
  }
  const auto work = [snapshot, edit] {
    Edited edited = snapshot;
    edited.after = edit({edited.before, *edited.objects, edited.selection});
    // Derived data is cached with the meshes: computed here, it does not delay the window.
    edited.keeps_places = have_same_places(*edited.objects, objects_of(edited.after, {}));
    return edited;
  };
  jobs_.add({title,
             MeshQueue,
             [this, title, work](Job& job) {
               job.run(work, [this, title](const Edited& edited) { take(title, edited); });
             },
             {},
             tr("Cancel: the meshes stay as they are")});
}

void MeshActions::take(const QString& title, const Edited& edited) {
  if (edited.revision == document_.revision()) return document_.replace(title, edited.after);
  grf::Scene scene = document_.scene();
  grf::Scene before = edited.before;
  grf::Scene after = edited.after;
  bool is_whole = edited.keeps_places;
  for (const std::uint32_t mesh : edited.selection.meshes()) {
    if (!edited.keeps_places) break;
    const grf::ScenePath& path = edited.objects->meshes[mesh].path;
    grf::Shared<grf::Mesh>* now = grf::find_mesh(scene, path);
    const grf::Shared<grf::Mesh>* old = grf::find_mesh(before, path);
    const grf::Shared<grf::Mesh>* made = grf::find_mesh(after, path);
    is_whole =
        now != nullptr && old != nullptr && made != nullptr && take_geometry(*now, **old, **made) && is_whole;
  }
  document_.replace(title, std::move(scene));
  if (!is_whole) emit failed(tr("%1: meshes that were edited meanwhile were left unchanged").arg(title));
}

}  // namespace editor
