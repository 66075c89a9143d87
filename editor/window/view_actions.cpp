#include "editor/window/view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>

#include "editor/controls/actions.h"
#include "editor/view/scene_view.h"

namespace editor {
namespace {

struct Mode {
  DisplayMode mode;
  const char* text;
  const char* tip;
};

constexpr Mode Modes[] = {
    {DisplayMode::Points, QT_TRANSLATE_NOOP("editor::ViewActions", "Poi&nts"),
     QT_TRANSLATE_NOOP("editor::ViewActions", "Only vertices")},
    {DisplayMode::Wireframe, QT_TRANSLATE_NOOP("editor::ViewActions", "&Wireframe"),
     QT_TRANSLATE_NOOP("editor::ViewActions", "Only edges")},
    {DisplayMode::Solid, QT_TRANSLATE_NOOP("editor::ViewActions", "So&lid"),
     QT_TRANSLATE_NOOP("editor::ViewActions", "Faces in their colours, lit by a headlight")},
    {DisplayMode::SolidEdges, QT_TRANSLATE_NOOP("editor::ViewActions", "&Solid with edges"),
     QT_TRANSLATE_NOOP("editor::ViewActions", "Faces in their colours, with their edges")},
    {DisplayMode::Textured, QT_TRANSLATE_NOOP("editor::ViewActions", "T&extured"),
     QT_TRANSLATE_NOOP("editor::ViewActions", "Faces with their textures")},
    {DisplayMode::VertexColours, QT_TRANSLATE_NOOP("editor::ViewActions", "Vertex colo&urs"),
     QT_TRANSLATE_NOOP("editor::ViewActions", "The vertex colours")},
    {DisplayMode::Irradiance, QT_TRANSLATE_NOOP("editor::ViewActions", "&Irradiance"),
     QT_TRANSLATE_NOOP("editor::ViewActions", "The irradiance baked at the vertices")},
    {DisplayMode::Brdf, QT_TRANSLATE_NOOP("editor::ViewActions", "&BRDF"),
     QT_TRANSLATE_NOOP("editor::ViewActions", "Faces shaded with their BRDFs, lit by a headlight and a sky")},
    {DisplayMode::Rendered, QT_TRANSLATE_NOOP("editor::ViewActions", "Ren&dered"),
     QT_TRANSLATE_NOOP("editor::ViewActions",
                       "The renderer's preview, which follows the view and your edits")},
};

}  // namespace

ViewActions::ViewActions(SceneView& view, QWidget& window, bool has_renderer)
    : QObject(&window), view_(view), window_(window), modes_(new QActionGroup(this)) {
  make_modes(has_renderer);
  make_overlays();
  make_places();
}

void ViewActions::make_modes(bool has_renderer) {
  int number = 0;
  for (const Mode& mode : Modes) {
    if (mode.mode == DisplayMode::Rendered && !has_renderer) continue;
    const QKeySequence keys(Qt::ALT | static_cast<Qt::Key>(Qt::Key_1 + number++));
    QAction* action = new_switch(window_, {tr(mode.text), {}, keys, tr(mode.tip)}, mode.mode == view_.mode(),
                                 [this, shown = mode.mode](bool is_on) {
                                   if (is_on) view_.set_mode(shown);
                                 });
    action->setData(static_cast<int>(mode.mode));
    modes_->addAction(action);
  }
}

void ViewActions::set_mode(DisplayMode mode) {
  for (QAction* action : modes_->actions()) {
    if (action->data().toInt() == static_cast<int>(mode)) action->setChecked(true);
  }
}

void ViewActions::make_overlays() {
  const auto add = [this](const ActionText& text, bool is_on, void (SceneView::*set)(bool)) {
    overlays_.append(new_switch(window_, text, is_on, [this, set](bool shown) { (view_.*set)(shown); }));
  };
  add({tr("&Grid and axes"), "grid", {}, tr("Show the ground grid in whole units, and the axes")}, true,
      &SceneView::set_grid);
  add({tr("Face nor&mals"), {}, {}, tr("Show face normals as lines")}, false, &SceneView::set_face_normals);
  add({tr("Verte&x normals"), {}, {}, tr("Show vertex normals as lines")}, false,
      &SceneView::set_vertex_normals);
}

void ViewActions::make_places() {
  // Letters and digits are shortcuts only in the view, since fields and lists need them for typing.
  const auto add = [this](const QString& text, Qt::Key key, const QString& tip, const QString& icon = {}) {
    QAction* made = new_action(window_, {text, icon, key, tip}, [this, key] { view_.press(key); });
    window_.removeAction(made);
    made->setShortcutContext(Qt::WidgetShortcut);
    view_.addAction(made);
    return made;
  };
  frame_all_ = add(tr("Frame &all"), Qt::Key_Home, tr("Frame the whole scene"), "fit");
  frame_selection_ = add(tr("F&rame selection"), Qt::Key_F, tr("Frame the selected faces"), "frame");
  places_ = {add(tr("&Front"), Qt::Key_1, tr("Look along -z")),
             add(tr("Rig&ht"), Qt::Key_3, tr("Look along -x")),
             add(tr("To&p"), Qt::Key_7, tr("Look along -y")),
             add(tr("&Opposite"), Qt::Key_9, tr("Look from the opposite side")),
             add(tr("Perspecti&ve or orthographic"), Qt::Key_5,
                 tr("Toggle perspective and orthographic projection"))};
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
  button->setToolTip(tr("Display mode of the scene (Alt and a digit)"));
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
