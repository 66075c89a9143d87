#include "editor/window/selection_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QToolBar>
#include <QtConcurrent>
#include <numbers>

#include "editor/controls/actions.h"
#include "editor/document/document.h"
#include "editor/document/face_query.h"
#include "editor/panels/face_query_dialog.h"
#include "editor/view/region_input.h"
#include "editor/view/scene_view.h"

namespace editor {
namespace {

/// The selection that another one becomes by a change.
std::function<FaceSelection(FaceSelection)> changed_by(void (FaceSelection::*change)()) {
  return [change](FaceSelection selection) {
    (selection.*change)();
    return selection;
  };
}

FaceSelection whole_meshes(const FaceSelection& selection) {
  FaceSelection whole = selection;
  for (const std::uint32_t mesh : selection.meshes()) whole.set_mesh(mesh);
  return whole;
}

}  // namespace

SelectionActions::SelectionActions(Document& document, SceneView& view, QWidget& window)
    : QObject(&window), document_(document), window_(window) {
  whole_ = {add(tr("&All"), QKeySequence::SelectAll, tr("Select all faces"),
                changed_by(&FaceSelection::select_all)),
            add(tr("&None"), QKeySequence("Ctrl+Shift+A"), tr("Deselect all faces"),
                changed_by(&FaceSelection::clear)),
            add(tr("In&vert"), QKeySequence("Ctrl+I"), tr("Invert the selection"),
                changed_by(&FaceSelection::invert))};
  const auto of_objects = [this](FaceSelection (*change)(const FaceSelection&, const SceneObjects&)) {
    return [this, change](const FaceSelection& selection) { return change(selection, document_.objects()); };
  };
  neighbours_ = {add(tr("&Grow"), QKeySequence("Ctrl++"),
                     tr("Grow the selection by faces that share an edge with it"), of_objects(grown)),
                 add(tr("&Shrink"), QKeySequence("Ctrl+-"),
                     tr("Shrink the selection by the faces at its border"), of_objects(shrunk)),
                 add(tr("&Connected"), QKeySequence("Ctrl+L"),
                     tr("Select all faces that are connected to the selected ones"), of_objects(connected)),
                 add(tr("Expand to whole &mesh"), QKeySequence("Ctrl+M"),
                     tr("Expand the selection to all faces of its meshes"), whole_meshes)};
  make_angles();
  make_likenesses();
  open_query_ =
      new_action(window_,
                 {tr("Select &faces by..."), "search", QKeySequence("Ctrl+F"),
                  tr("Select faces by normal, area, height, material, and by several similarities at once")},
                 [this] { open_query(); });
  make_gestures(view);
  connect(&document_, &Document::selection_changed, this, &SelectionActions::find_edges);
}

QAction* SelectionActions::add(const QString& text, const QKeySequence& keys, const QString& tip,
                               const Change& change) {
  return new_action(window_, {text, {}, keys, tip}, [this, change] {
    if (document_.objects().faces > 0) document_.select(change(document_.selection()));
  });
}

void SelectionActions::make_angles() {
  for (const int degrees : {1, 5, 15, 30, 45}) {
    const QKeySequence keys = degrees == 5 ? QKeySequence("Ctrl+Shift+L") : QKeySequence();
    const double radians = degrees * std::numbers::pi / 180;
    angles_.append(add(tr("Within %1°").arg(degrees), keys,
                       tr("Select connected faces that are coplanar within %1°").arg(degrees),
                       [this, radians](const FaceSelection& selection) {
                         return coplanar(selection, document_.objects(), radians);
                       }));
  }
}

void SelectionActions::make_likenesses() {
  const auto add_similar = [this](const QString& text, const Similarity& by, const QString& tip,
                                  const QKeySequence& keys = {}) {
    similar_.append(add(text, keys, tip, [this, by](const FaceSelection& selection) {
      return select_similar(selection, document_.objects(), by);
    }));
  };
  add_similar(tr("&BRDF"), {.brdf = true}, tr("Select all faces with the same BRDF as a selected one"),
              QKeySequence("Ctrl+Shift+B"));
  add_similar(tr("&Sampling"), {.pdf = true},
              tr("Select all faces with the same sampling scheme as a selected one"));
  add_similar(tr("&Colour"), {.colour = true}, tr("Select all faces with the same colour as a selected one"));
  add_similar(tr("&Texture"), {.texture = true},
              tr("Select all faces with the same texture as a selected one"));
  add_similar(tr("&Emission"), {.emission = true},
              tr("Select all faces with the same emission as a selected one"));
  add_similar(tr("&All"), Similarity::of_surface(),
              tr("Select all faces with the same surface as a selected one"));
}

void SelectionActions::make_gestures(SceneView& view) {
  gestures_ = {new_switch(
      window_,
      {tr("&Lasso"), "lasso", QKeySequence("Ctrl+Alt+L"), tr("Drag a lasso around faces instead of a box")},
      false, [&view](bool is_on) { view.set_lasso(is_on); })};
  make_tools(view);
  gestures_.append(new_switch(window_,
                              {tr("Select &through"), "through", QKeySequence("Ctrl+Alt+T"),
                               tr("Select occluded faces, too, with boxes, lassos, brush and polygon")},
                              false, [&view](bool is_on) { view.set_select_through(is_on); }));
}

void SelectionActions::make_tools(SceneView& view) {
  using Tool = RegionInput::Tool;
  auto* input = new RegionInput(view);
  auto* tools = new QActionGroup(this);
  tools->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  tools->addAction(gestures_.front());
  const auto add = [&](const QString& text, const QString& icon, const QKeySequence& keys, Tool tool,
                       const QString& tip) {
    QAction* action = new_switch(window_, {text, icon, keys, tip}, false, [input, tool](bool is_on) {
      if (is_on || input->tool() == tool) input->set_tool(is_on ? std::optional(tool) : std::nullopt);
    });
    connect(input, &RegionInput::ended, action, [action] { action->setChecked(false); });
    gestures_.append(tools->addAction(action));
    return action;
  };
  QAction* brush = add(tr("&Brush"), "brush", Qt::Key_C, Tool::Brush,
                       tr("Paint over faces to select them, with Ctrl to deselect them; [ and ] change the "
                          "radius, Escape ends"));
  // Letters are shortcuts only in the view, since fields and lists need them for typing.
  window_.removeAction(brush);
  brush->setShortcutContext(Qt::WidgetShortcut);
  view.addAction(brush);
  add(tr("&Polygon"), "polygon", QKeySequence("Ctrl+Alt+P"), Tool::Polygon,
      tr("Click the corners of a polygon around faces; Return or a double click selects, Escape ends"));
}

void SelectionActions::open_query() {
  if (query_ == nullptr) query_ = new FaceQueryDialog(document_, &window_);
  query_->show();
  query_->raise();
  query_->activateWindow();
}

/// Finds the edges of meshes with selected faces in a thread, so that they are there once the selection is
/// grown: for 1,000,000 faces this takes a third of a second.
void SelectionActions::find_edges() {
  if (finding_.isRunning()) return;
  std::vector<grf::SharedGeometry> geometries;
  for (const std::uint32_t mesh : document_.selection().meshes())
    geometries.push_back(document_.objects().meshes[mesh].mesh->geometry);
  if (geometries.empty()) return;
  finding_ = QtConcurrent::run([geometries = std::move(geometries)] {
    for (const grf::SharedGeometry& geometry : geometries) geometry.edges();
  });
}

void SelectionActions::fill(QMenu& menu) {
  menu.addActions(whole_);
  menu.addSeparator();
  menu.addActions(neighbours_);
  QMenu* angles = menu.addMenu(tr("C&oplanar"));
  angles->setToolTipsVisible(true);
  angles->addActions(angles_);
  QMenu* similar_menu = menu.addMenu(tr("Select simila&r"));
  similar_menu->setToolTipsVisible(true);
  similar_menu->addActions(similar_);
  menu.addAction(open_query_);
  menu.addSeparator();
  menu.addActions(gestures_);
}

void SelectionActions::fill(QToolBar& bar) { bar.addActions(gestures_); }

}  // namespace editor
