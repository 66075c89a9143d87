#include "editor/window/view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>

#include "editor/view/scene_view.h"
#include "editor/window/actions.h"

namespace editor {
namespace {

struct Mode {
  DisplayMode mode;
  const char* text;
  const char* tip;
};

constexpr Mode Modes[] = {
    {DisplayMode::Points, "&Points", "Vertices alone"},
    {DisplayMode::Wireframe, "&Wireframe", "Edges alone"},
    {DisplayMode::Solid, "&Solid", "Faces in their colours, lit from the eye"},
    {DisplayMode::SolidEdges, "Solid with &edges", "Faces in their colours, with their edges"},
    {DisplayMode::Textured, "&Textured", "Faces with their textures"},
    {DisplayMode::VertexColours, "&Vertex colours", "The colours of vertices"},
    {DisplayMode::Irradiance, "&Irradiance", "The irradiance that is kept at vertices"},
    {DisplayMode::Brdf, "&BRDF", "Faces with their BRDFs, lit by the scene's lights and a sky"},
};

}  // namespace

ViewActions::ViewActions(SceneView& view, QWidget& window)
    : QObject(&window), view_(view), window_(window), modes_(new QActionGroup(this)) {
  make_modes();
  make_overlays();
  make_places();
}

void ViewActions::make_modes() {
  int number = 0;
  for (const Mode& mode : Modes) {
    const QKeySequence keys(Qt::ALT | static_cast<Qt::Key>(Qt::Key_1 + number++));
    QAction* action = new_switch(window_, {tr(mode.text), {}, keys, tr(mode.tip)}, mode.mode == view_.mode(),
                                 [this, shown = mode.mode](bool is_on) {
                                   if (is_on) view_.set_mode(shown);
                                 });
    modes_->addAction(action);
  }
}

void ViewActions::make_overlays() {
  const auto add = [this](const ActionText& text, bool is_on, void (SceneView::*set)(bool)) {
    overlays_.append(new_switch(window_, text, is_on, [this, set](bool shown) { (view_.*set)(shown); }));
  };
  add({tr("&Grid and axes"), "grid", {}, tr("The ground in steps of whole units, and the axes")}, true,
      &SceneView::set_grid);
  add({tr("&Normals of faces"), {}, {}, tr("A line from the middle of each face")}, false,
      &SceneView::set_face_normals);
  add({tr("Normals of &vertices"), {}, {}, tr("A line from each vertex that has a normal")}, false,
      &SceneView::set_vertex_normals);
}

void ViewActions::make_places() {
  // Letters and digits are the view's: in fields and lists they are typed.
  const auto add = [this](const QString& text, Qt::Key key, const QString& tip, const QString& icon = {}) {
    QAction* made = new_action(window_, {text, icon, key, tip}, [this, key] { view_.press(key); });
    window_.removeAction(made);
    made->setShortcutContext(Qt::WidgetShortcut);
    view_.addAction(made);
    return made;
  };
  frame_all_ = add(tr("Frame &all"), Qt::Key_Home, tr("Shows the whole scene"), "fit");
  frame_selection_ = add(tr("&Frame the selection"), Qt::Key_F, tr("Shows the selected faces"), "frame");
  places_ = {add(tr("Fr&ont"), Qt::Key_1, tr("Looks along -z")),
             add(tr("&Right"), Qt::Key_3, tr("Looks along -x")),
             add(tr("&Top"), Qt::Key_7, tr("Looks along -y")),
             add(tr("Oppos&ite"), Qt::Key_9, tr("Looks from the other side")),
             add(tr("&Perspective or parallel"), Qt::Key_5, tr("Changes between perspective and parallel"))};
}

void ViewActions::fill(QMenu& menu) {
  menu.addActions(modes_->actions());
  menu.addSeparator();
  menu.addActions(overlays_);
  menu.addSeparator();
  menu.addAction(frame_all_);
  menu.addAction(frame_selection_);
  menu.addActions(places_);
}

void ViewActions::fill(QToolBar& bar) {
  auto* button = new QToolButton(&bar);
  auto* menu = new QMenu(button);
  menu->addActions(modes_->actions());
  menu->setToolTipsVisible(true);
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setFocusPolicy(Qt::TabFocus);
  button->setToolTip(tr("How the scene is drawn (Alt and a digit)"));
  button->setAccessibleName(tr("Display mode"));
  const auto name = [button](const QAction* mode) { button->setText(mode->text().remove('&')); };
  name(modes_->checkedAction());
  connect(modes_, &QActionGroup::triggered, &view_, [this] { view_.setFocus(); });
  for (QAction* mode : modes_->actions())
    connect(mode, &QAction::toggled, button, [name, mode](bool is_on) {
      if (is_on) name(mode);
    });
  bar.addWidget(button);
  bar.addAction(overlays_.front());
  bar.addSeparator();
  bar.addAction(frame_all_);
  bar.addAction(frame_selection_);
}

}  // namespace editor
