// A session of the editor without its window: editing_session SCENE SESSIONS NAME gives the first mesh of the
// scene the name, says so once that work is kept in the folder of sessions, and lives until it is killed.
#include <QCoreApplication>
#include <cstdlib>
#include <iostream>

#include "editor/document/document.h"
#include "editor/document/recovery.h"
#include "grf/read.h"
#include "grf/scene_path.h"

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  const QStringList arguments = QCoreApplication::arguments();
  if (arguments.size() != 4) {
    std::cerr << "usage: editing_session SCENE SESSIONS NAME\n";
    return EXIT_FAILURE;
  }
  grf::Diagnostics diagnostics;
  auto read = grf::read(arguments[1].toStdString(), diagnostics);
  if (!read) {
    std::cerr << diagnostics.to_text();
    return EXIT_FAILURE;
  }
  editor::Document document;
  document.take(std::move(*read), arguments[1], diagnostics);
  const editor::Recovery recovery(document, arguments[2], 0);
  QObject::connect(&recovery, &editor::Recovery::kept, [] { std::cout << "kept\n" << std::flush; });
  grf::Scene scene = document.scene();
  grf::find_mesh(scene, document.objects().meshes.front().path)->edit().name = arguments[3].toStdString();
  document.replace("Rename", scene);
  return QCoreApplication::exec();
}
