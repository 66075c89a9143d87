// Makes the scenes of samples/authored in the real window, by pointer and keyboard alone, and writes their
// steps. Usage: make_authored FOLDER
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QSettings>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "editor/document/object_placement.h"
#include "editor/window/docks.h"
#include "tests/editor/own_application.h"
#include "tests/editor/own_screen.h"
#include "tests/editor/window/gestures.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

namespace {

using grf::Vec3d;

/// A window in which a scene is made, and the steps that were taken.
class Author {
 public:
  explicit Author(QString folder)
      : folder_(std::move(folder)), window_(temporary("sessions")), user_(window_) {
    QSettings().clear();
    window_.resize(1600, 1000);
    window_.show();
    window_.activateWindow();
    if (!QTest::qWaitForWindowActive(&window_)) throw std::runtime_error("the window did not show");
  }
  ~Author() { window_.document().clear(); }

  /// Triggers an entry of a menu.
  void menu(const QString& entry) {
    test::action(window_, entry).trigger();
    step("*" + entry + "* in the menu");
  }
  /// Transforms the selected objects by keys: `s x 4` is typed, then Return.
  void keys(const QString& typed) {
    window_.view().setFocus();
    QTest::keyClicks(&window_.view(), typed);
    QTest::keyClick(&window_.view(), Qt::Key_Return);
    step("`" + typed.toUpper() + "`, `Return`");
  }
  void press(const QKeyCombination& key, const QString& text) {
    QTest::keyClick(&window_, key.key(), key.keyboardModifiers());
    step("`" + text + "`");
  }
  /// Places the selected object on a point of a surface.
  void place_on(const Vec3d& point, const QString& what) {
    QTest::keyClick(&window_, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    user_.click_view(point);
    step("`Ctrl+Shift+P`, a click on " + what);
  }
  /// Gives all faces of the active object a BRDF of the library.
  void paint(const QString& brdf) {
    press(Qt::ControlModifier | Qt::Key_M, "Ctrl+M");
    auto& library = test::named<QWidget>(window_, "Library");
    user_.click(library);
    auto& search = test::named<QLineEdit>(window_, "Search the library");
    search.clear();
    user_.type(search, brdf);
    auto& tiles = test::named<QListWidget>(window_, "BRDFs of the library");
    for (int i = 0; i < tiles.count(); ++i) {
      if (tiles.item(i)->isHidden() || tiles.item(i)->text() != brdf) continue;
      tiles.scrollToItem(tiles.item(i));
      user_.double_click(*tiles.viewport(), tiles.visualItemRect(tiles.item(i)).center());
      return step("*Library*, type `" + brdf + "`, a double click on it");
    }
    throw std::runtime_error("the library has no " + brdf.toStdString());
  }
  /// Selects a face of the active object, which paint() extends to its mesh.
  void click(const Vec3d& point, const QString& what) {
    user_.click_view(point);
    step("a click on " + what);
  }
  void type_into(const QString& field, const QString& text) {
    auto& box = test::named<QWidget>(window_, field);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
    step("*" + field + "*: `" + text + "`");
  }
  /// Drops an environment map on the background of the view.
  void drop_on_background(const QString& file) {
    user_.drop(window_.view(), {file}, {12, 12});
    step("drop `" + QFileInfo(file).fileName() + "` on the background of the view");
  }
  void dock(const QString& name) {
    auto* dock = window_.findChild<QDockWidget*>(name);
    editor::Docks::show(dock);
    step("the " + dock->windowTitle() + " dock");
  }

  /// Adds a plane of felt, scaled by typed keys.
  void lay_ground(const QString& scale) {
    menu("Add a plane");
    keys(scale);
    press(Qt::Key_Home, "Home");
    click({0, 0, 0}, "the plane");
    paint("felt");
  }

  grf::Box3d bounds() {
    return object_bounds(window_.document().objects(), window_.document().selected_objects().back());
  }
  void save(const QString& name) {
    const QString file = QDir(folder_).filePath(name + ".grf");
    // What is there already would be asked about.
    for (const char* ending : {".grf", ".op"}) QFile::remove(QDir(folder_).filePath(name + ending));
    {
      const test::FileTyping typing(file);
      QTest::keyClick(&window_, Qt::Key_S, Qt::ControlModifier);
    }
    step("`Ctrl+S`, type `" + name + "`, `Return`");
    const bool is_done = QTest::qWaitFor([this] { return window_.jobs().jobs().empty(); }, test::Minute);
    if (!is_done || window_.document().is_modified()) throw std::runtime_error("the scene was not saved");
    std::ofstream steps(QDir(folder_).filePath(name + ".md").toStdString());
    steps << "# How " << name.toStdString() << " was made\n\n" << text_;
    std::cout << name.toStdString() << ": " << steps_ << " steps" << std::endl;
  }
  /// Frames the mesh of the selected face.
  void frame_mesh() {
    press(Qt::ControlModifier | Qt::Key_M, "Ctrl+M");
    window_.view().press(Qt::Key_F);
    step("`F`");
  }
  /// Takes the viewpoint of the view for the render camera.
  void align_camera() { press(Qt::ControlModifier | Qt::AltModifier | Qt::Key_0, "Ctrl+Alt+0"); }

 private:
  QString temporary(const char* name) const { return QString::fromStdString(temporary_.path(name)); }
  void step(const QString& text) {
    text_ += std::to_string(++steps_) + ". " + text.toStdString() + "\n";
    if (!user_.is_drawn()) throw std::runtime_error("the view was not drawn");
  }

  test::TemporaryFolder temporary_;
  QString folder_;
  editor::MainWindow window_;
  test::Gestures user_;
  std::string text_;
  int steps_ = 0;
};

/// A table with three things under a soft box.
void make_still_life(const QString& folder) {
  Author author(folder);
  author.menu("Add a box");
  author.keys("sx4");
  author.keys("sz2");
  author.keys("sy.2");
  author.menu("Drop to floor");
  author.press(Qt::Key_Home, "Home");
  const grf::Box3d table = author.bounds();
  const double top = table.max.y;
  const auto put = [&](const QString& shape, const QString& scale, double x, double z, const QString& brdf) {
    author.menu("Add a " + shape);
    author.keys("s" + scale);
    author.place_on({x, top, z}, "the table");
    const grf::Box3d box = author.bounds();
    author.click({box.center().x, box.center().y, box.max.z}, "the " + shape);
    author.paint(brdf);
  };
  put("sphere", ".7", -1.2, 0.2, "gold");
  put("torus", ".8", 0.1, 0.3, "copper");
  put("cylinder", ".5", 1.2, 0, "velvet");
  author.click({table.max.x - 0.1, top - 0.05, table.max.z}, "the table");
  author.paint("oren");
  author.frame_mesh();
  author.menu("Add a studio");
  author.align_camera();
  author.save("still_life");
}

/// A ball and a ring outdoors, by an environment map and a thin lens.
void make_outdoors(const QString& folder) {
  Author author(folder);
  author.lay_ground("s12");
  author.menu("Add a sphere");
  author.keys("s.3");
  author.menu("Drop to floor");
  author.press(Qt::Key_Home, "Home");
  const grf::Box3d ball = author.bounds();
  author.click({ball.center().x, ball.center().y, ball.max.z}, "the sphere");
  author.paint("silver");
  author.frame_mesh();
  author.dock("lights");
  author.drop_on_background(GRANADA_SOURCE_DIR "/samples/environments/sky.exr");
  author.type_into("Rotation of the environment", "60");
  author.align_camera();
  author.dock("cameras");
  author.type_into("Lens radius", "0.05");
  author.save("outdoors");
}

/// A stack of blocks under a warm disc and a cold rectangle.
void make_blocks(const QString& folder) {
  Author author(folder);
  author.lay_ground("s3");
  const QString brdfs[] = {"ward", "oren", "ashikhmin"};
  double top = 0;
  for (int i = 0; i < 3; ++i) {
    author.menu("Add a box");
    author.keys(QString("s%1").arg(1 - 0.2 * i));
    author.keys(QString("ry%1").arg(20 * i));
    author.menu("Drop to floor");
    author.keys(QString("gy%1").arg(top));
    author.press(Qt::Key_Home, "Home");
    const grf::Box3d box = author.bounds();
    top += box.size().y;
    author.click({box.center().x, box.center().y, box.max.z - (i == 0 ? 0 : 0.1)}, "the box");
    author.paint(brdfs[i]);
  }
  author.menu("Add a studio");
  author.align_camera();
  author.save("blocks");
}

}  // namespace

int main(int argc, char** argv) {
  test::OwnScreen screen;
  const auto application = test::application_on(screen, {1920, 1200}, argc, argv);
  if (application == nullptr) return 1;
  if (argc != 2) {
    std::cerr << "usage: make_authored FOLDER\n";
    return 2;
  }
  try {
    const QString folder = QDir(argv[1]).absolutePath();
    make_still_life(folder);
    make_outdoors(folder);
    make_blocks(folder);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
