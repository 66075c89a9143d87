// An editor session without a window: editing_session FILE SESSIONS IMPORTS NAME opens a scene, or imports a
// model whose images go to the folder IMPORTS, renames its first mesh, prints a line once that is autosaved
// in the folder of sessions, and runs until it is killed.
#include <QCoreApplication>
#include <QEventLoop>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "editor/document/document.h"
#include "editor/document/model_import.h"
#include "editor/document/recovery.h"
#include "grf/read.h"
#include "grf/scene_path.h"

namespace {

/// Returns false if it cannot be read.
bool open(editor::Document& document, const QString& file, const QString& imports) {
  grf::Diagnostics diagnostics;
  if (file.endsWith(".grf")) {
    auto scene = grf::read(file.toStdString(), diagnostics);
    std::cerr << diagnostics.to_text();
    if (scene) document.take(std::move(*scene), file, diagnostics);
    return scene.has_value();
  }
  editor::ModelImport import(imports);
  QEventLoop loop;
  bool is_done = false;
  QObject::connect(&import, &editor::ModelImport::done, [&](const auto& model) {
    document.take_import(*model);
    is_done = true;
    loop.quit();
  });
  QObject::connect(&import, &editor::ModelImport::failed, &loop, &QEventLoop::quit);
  import.start(file);
  loop.exec();
  return is_done;
}

}  // namespace

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  const QStringList arguments = QCoreApplication::arguments();
  if (arguments.size() != 5) {
    std::cerr << "usage: editing_session FILE SESSIONS IMPORTS NAME\n";
    return EXIT_FAILURE;
  }
  editor::Document document;
  if (!open(document, arguments[1], arguments[3])) return EXIT_FAILURE;
  const editor::Recovery recovery(document, arguments[2], 0);
  QObject::connect(&recovery, &editor::Recovery::kept, [] { std::cout << "kept\n" << std::flush; });
  grf::Scene scene = document.scene();
  grf::find_mesh(scene, document.objects().meshes.front().path)->edit().name = arguments[4].toStdString();
  document.replace("Rename", scene);
  return QCoreApplication::exec();
}
