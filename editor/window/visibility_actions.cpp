#include "editor/window/visibility_actions.h"

#include <QAction>
#include <QInputDialog>
#include <QMenu>
#include <utility>

#include "editor/controls/actions.h"
#include "editor/document/document.h"
#include "editor/view/scene_view.h"

namespace editor {
namespace {

FaceSelection complement(FaceSelection faces) {
  faces.invert();
  return faces;
}

}  // namespace

VisibilityActions::VisibilityActions(Document& document, SceneView& view, QWidget& window)
    : QObject(&window), document_(document), window_(window), sets_(new QMenu(tr("S&ets"), &window)) {
  sets_->setToolTipsVisible(true);
  // It outlives `fill_sets`, since users can give it a shortcut.
  save_set_ = new_action(
      window_, {tr("&Save selection as..."), {}, {}, tr("Save the selected faces as a set with a name")},
      [this] { save_set(); });
  make_visibility(view);
  make_locks();
  connect(&document_, &Document::editor_state_changed, this, &VisibilityActions::fill_sets);
  connect(&document_, &Document::scene_replaced, this, [this] { hidden_before_.reset(); });
  fill_sets();
}

QAction* VisibilityActions::add(const QString& text, const QString& icon, const QKeySequence& keys,
                                const QString& tip, const Change& change) {
  return new_action(window_, {text, icon, keys, tip}, [this, change] {
    EditorState state = document_.editor_state();
    change(state);
    document_.set_editor_state(std::move(state));
  });
}

void VisibilityActions::make_visibility(SceneView& view) {
  visibility_ = {add(tr("&Hide selected"), "eye_closed", Qt::Key_H, tr("Hide the selected faces in the view"),
                     [this](EditorState& state) { state.hidden.add(document_.selection()); }),
                 add(tr("Hi&de others"), {}, Qt::SHIFT | Qt::Key_H,
                     tr("Hide all faces but the selected ones in the view"),
                     [this](EditorState& state) {
                       if (!document_.selection().empty())
                         state.hidden.add(complement(document_.selection()));
                     }),
                 add(tr("Sho&w all"), "eye", Qt::ALT | Qt::Key_H, tr("Show all hidden faces again"),
                     [this](EditorState& state) {
                       state.hidden.clear();
                       hidden_before_.reset();
                     }),
                 add(tr("&Isolate"), {}, Qt::Key_Slash,
                     tr("Hide all meshes but those with selected faces, or show again what that hid"),
                     [this](EditorState& state) { isolate(state); })};
  // Letters are shortcuts only in the view, since fields and lists need them for typing.
  for (QAction* action : visibility_) {
    window_.removeAction(action);
    action->setShortcutContext(Qt::WidgetShortcut);
    view.addAction(action);
  }
}

void VisibilityActions::make_locks() {
  locks_ = {add(tr("Loc&k selected"), "lock", QKeySequence("Ctrl+Alt+K"),
                tr("Lock the selected faces: they are shown, but the view does not select them"),
                [this](EditorState& state) { state.locked.add(document_.selection()); }),
            add(tr("&Unlock all"), "unlocked", QKeySequence("Ctrl+Alt+Shift+K"),
                tr("Unlock all faces, so that they can be selected"),
                [](EditorState& state) { state.locked.clear(); })};
}

/// The second time it shows what it hid the first time. An edit that adds or removes meshes meanwhile makes
/// it show all.
void VisibilityActions::isolate(EditorState& state) {
  if (const auto before = std::exchange(hidden_before_, std::nullopt)) {
    state.hidden = before->fits(document_.objects()) ? *before : FaceSelection(document_.objects());
    return;
  }
  const FaceSelection& selection = document_.selection();
  if (selection.empty()) return;
  hidden_before_ = state.hidden;
  for (std::uint32_t mesh = 0; mesh < selection.mesh_count(); ++mesh) {
    if (selection.count(mesh) == 0) state.hidden.set_mesh(mesh);
  }
}

void VisibilityActions::ask_name(const QString& title, const QString& name,
                                 const std::function<void(const std::string& name)>& named) {
  auto* dialog = new QInputDialog(&window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  dialog->setLabelText(tr("Name of the set"));
  dialog->setTextValue(name);
  connect(dialog, &QInputDialog::textValueSelected, this, [named](const QString& text) {
    if (!text.trimmed().isEmpty()) named(text.trimmed().toStdString());
  });
  dialog->show();
}

void VisibilityActions::save_set() {
  if (document_.selection().empty()) return;
  ask_name(tr("Save the selection as a set"), {}, [this](const std::string& name) {
    EditorState state = document_.editor_state();
    state.face_sets.insert_or_assign(name, document_.selection());
    document_.set_editor_state(std::move(state));
  });
}

void VisibilityActions::rename_set(const std::string& name) {
  ask_name(tr("Rename a set"), QString::fromStdString(name), [this, name](const std::string& wanted) {
    EditorState state = document_.editor_state();
    auto set = state.face_sets.extract(name);
    if (set.empty()) return;
    state.face_sets.insert_or_assign(wanted, std::move(set.mapped()));
    document_.set_editor_state(std::move(state));
  });
}

void VisibilityActions::fill_sets() {
  sets_->clear();
  for (QMenu* former : sets_->findChildren<QMenu*>()) former->deleteLater();
  const auto add_to = [this](QMenu* menu, const QString& text, const QString& tip, const auto& triggered) {
    QAction* action = menu->addAction(text);
    action->setToolTip(tip);
    action->setStatusTip(tip);
    connect(action, &QAction::triggered, this, triggered);
  };
  sets_->addAction(save_set_);
  for (const auto& [name, set] : document_.editor_state().face_sets) {
    QString title = QString::fromStdString(name);
    QMenu* menu = sets_->addMenu(title.replace('&', "&&"));
    menu->setToolTipsVisible(true);
    add_to(menu, tr("&Select"), tr("Select the faces of the set"),
           [this, name = name] { document_.select(document_.editor_state().face_sets.at(name)); });
    add_to(menu, tr("Re&name..."), tr("Give the set another name"),
           [this, name = name] { rename_set(name); });
    add_to(menu, tr("&Remove"), tr("Forget the set; its faces stay"), [this, name = name] {
      EditorState state = document_.editor_state();
      state.face_sets.erase(name);
      document_.set_editor_state(std::move(state));
    });
  }
}

void VisibilityActions::fill(QMenu& menu) {
  menu.addActions(visibility_);
  menu.addSeparator();
  menu.addActions(locks_);
  menu.addSeparator();
  menu.addMenu(sets_);
}

}  // namespace editor
