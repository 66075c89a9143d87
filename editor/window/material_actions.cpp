#include "editor/window/material_actions.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QWidget>
#include <utility>

#include "editor/controls/actions.h"
#include "editor/document/document.h"
#include "editor/document/material_text.h"
#include "editor/panels/selection_summary.h"

namespace editor {

MaterialActions::MaterialActions(Document& document, QWidget& window)
    : QObject(&window),
      document_(document),
      actions_{new_action(window,
                          {tr("&Copy material"), "copy", QKeySequence("Ctrl+Shift+C"),
                           tr("Copy the surface of the first selected face to the clipboard, as GRF text")},
                          [this] { copy(); }),
               new_action(window,
                          {tr("&Paste material"),
                           {},
                           QKeySequence("Ctrl+Shift+V"),
                           tr("Give the selected faces the material on the clipboard")},
                          [this] { paste(); })} {
  connect(&document_, &Document::selection_changed, this, &MaterialActions::update);
  connect(&document_, &Document::changed, this, &MaterialActions::update);
  update();
}

void MaterialActions::update() {
  for (QAction* action : actions_) action->setEnabled(!document_.selection().empty());
}

void MaterialActions::copy() {
  const std::uint32_t mesh = document_.selection().meshes().front();
  const std::size_t face = document_.selection().of_mesh(mesh).find_first();
  const MeshObject& object = document_.objects().meshes[mesh];
  const std::string text = material_text(document_.scene(), object.path, object.mesh->surface(face),
                                         document_.path().toStdString());
  QGuiApplication::clipboard()->setText(QString::fromStdString(text));
  emit status_message(tr("The material is on the clipboard"));
}

void MaterialActions::paste() {
  grf::Diagnostics diagnostics;
  const std::string text = QGuiApplication::clipboard()->text().toStdString();
  auto pasted =
      paste_material(document_.scene(), common_definitions(document_.scene(), selected_meshes(document_)),
                     text, diagnostics);
  if (!pasted) {
    emit failed(tr("The clipboard has no material. %1")
                    .arg(QString::fromStdString(diagnostics.entries().front().message)));
    return;
  }
  // Both edits are one step.
  document_.finish_gesture();
  const QString key = QStringLiteral("paste material");
  document_.replace(tr("Paste material"), std::move(pasted->scene), key);
  document_.edit_surfaces(tr("Paste material"), edit_to(pasted->surface), key);
  document_.finish_gesture();
}

}  // namespace editor
