#include "editor/window/mesh_actions.h"

#include <QApplication>
#include <QLocale>
#include <QWidget>

#include "converters/mesh_operations/subdivide.h"
#include "editor/document/document.h"
#include "editor/document/geometry_edits.h"
#include "editor/window/actions.h"

namespace editor {
namespace {

/// Faces that a window still shows at ease: more are a matter for `grfconvert --subdivide`.
constexpr double MostFaces = 2e7;
/// Enough that noise of a scan goes, and few enough that a nose stays.
constexpr int SmoothingSteps = 10;

class BusyCursor {
 public:
  BusyCursor() { QApplication::setOverrideCursor(Qt::WaitCursor); }
  ~BusyCursor() { QApplication::restoreOverrideCursor(); }
  BusyCursor(const BusyCursor&) = delete;
  BusyCursor& operator=(const BusyCursor&) = delete;
};

}  // namespace

MeshActions::MeshActions(Document& document, QWidget& window) : QObject(&window), document_(document) {
  const QString whole =
      tr("of the selected faces, or of all if none is selected. Faces keep their BRDFs and colours");
  delete_faces_ = new_action(
      window,
      {tr("&Delete faces"), "delete", QKeySequence("Shift+Del"),
       tr("Takes the selected faces away; meshes without faces go, too")},
      [this] {
        if (document_.selection().empty()) {
          emit told(tr("No face is selected"));
          return;
        }
        document_.replace(tr("Delete faces"),
                          without_faces({document_.scene(), document_.objects(), document_.selection()}));
      });
  of_meshes_ = {
      new_action(window,
                 {tr("Subdivide (&Catmull-Clark)"),
                  {},
                  {},
                  tr("Subdivides the meshes %1; each face becomes as many as it has corners").arg(whole)},
                 [this] { subdivide(convert::SubdivisionScheme::CatmullClark); }),
      new_action(
          window,
          {tr("Subdivide (L&oop)"),
           {},
           {},
           tr("Subdivides the meshes %1; they are triangulated, and each triangle becomes four").arg(whole)},
          [this] { subdivide(convert::SubdivisionScheme::Loop); }),
      new_action(window,
                 {tr("&Smooth vertices"),
                  {},
                  {},
                  tr("Smooths noise and small features away in the meshes %1").arg(whole)},
                 [this] { smooth(); })};
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
  if (after == 0) {
    emit told(tr("The scene has no mesh"));
    return;
  }
  if (after > MostFaces) {
    emit failed(tr("The meshes would have %1 faces, which is too much for the window: subdivide the file "
                   "with grfconvert --subdivide")
                    .arg(QLocale().toString(after, 'f', 0)));
    return;
  }
  const CommonVertices common = common_vertices(document_.objects(), selection);
  const bool had_irradiance = common.irradiance || common.are_irradiances_mixed;
  const BusyCursor busy;
  document_.replace(tr("Subdivide"), with_subdivided_meshes(faces, once));
  if (had_irradiance) emit told(tr("Subdivided meshes have no irradiance: bake it again"));
}

void MeshActions::smooth() {
  const FaceSelection selection = selected_or_all();
  if (selection.empty()) {
    emit told(tr("The scene has no mesh"));
    return;
  }
  const BusyCursor busy;
  document_.replace(tr("Smooth vertices"),
                    with_smooth_meshes({document_.scene(), document_.objects(), selection}, SmoothingSteps));
}

}  // namespace editor
