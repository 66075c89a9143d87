// Makes the pictures of the editor's manual: opens the real window on a screen that nobody sees, brings it
// into the states that the manual speaks of, and writes what it shows. See editor/screenshots.
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QListView>
#include <QPainter>
#include <QSettings>
#include <QSignalSpy>
#include <QThreadPool>
#include <functional>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

#include "editor/appearance/theme.h"
#include "editor/brdf/brdf_editor.h"
#include "editor/image/image_browser.h"
#include "editor/image/screen_controls.h"
#include "editor/options/options_window.h"
#include "editor/panels/message_panel.h"
#include "editor/rendering/render_panel.h"
#include "editor/window/file_actions.h"
#include "editor/window/render_link.h"
#include "editor/window/viewer_window.h"
#include "tests/editor/own_screen.h"
#include "tests/editor/window/window_driver.h"

namespace {

using editor::BrdfEditor;
using editor::DisplayMode;
using editor::MainWindow;

const QString Samples = GRANADA_SOURCE_DIR "/samples/";
const QString Bunny = "/usr/share/glmark2/models/bunny.obj";
constexpr int Minute = 60'000;

/// A picture that is not made is a failure of the whole.
void expect(bool holds, const QString& what) {
  if (!holds) throw std::runtime_error(what.toStdString());
}

/// A window of a size with the layout of its first start, and what is done to it for a picture.
class Stage {
 public:
  explicit Stage(QSize size = {1600, 1000}) {
    QSettings().clear();
    window_ = std::make_unique<MainWindow>(QString::fromStdString(folder_.path("sessions")));
    window_->resize(size);
    window_->show();
    window_->activateWindow();
    expect(QTest::qWaitForWindowActive(window_.get()), "the window did not show");
    settle();
  }
  ~Stage() { window_->document().undo_stack().setClean(); }

  MainWindow& window() { return *window_; }
  QString path(const char* name) const { return QString::fromStdString(folder_.path(name)); }
  QString add(const char* name, const char* text) const {
    return QString::fromStdString(folder_.add(name, text));
  }

  void open(const QString& file) {
    window_->document().undo_stack().setClean();  // so that nobody is asked about the scene before
    QSignalSpy taken(&window_->document(), &editor::Document::taken);
    window_->files().open(file);
    expect(!taken.empty() || taken.wait(Minute), file + " did not open");
    settle();
  }

  void act(const QString& name) {
    test::action(*window_, name).trigger();
    settle();
  }

  /// A sample as its render sees it, with its BRDFs.
  void open_as_rendered(const QString& file) {
    open(file);
    act("Look through the camera");
    draw_as(DisplayMode::Brdf);
  }

  void draw_as(DisplayMode mode) {
    QTest::keyClick(window_.get(), static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(mode)), Qt::AltModifier);
    expect(window_->view().mode() == mode, "the view is drawn in another mode");
    settle();
  }

  /// Away from where the camera of renders is, so that it is seen.
  void orbit(double to_the_right, double upwards, double nearer) {
    editor::ViewCamera camera = window_->view().camera();
    camera.orbit(to_the_right, upwards);
    camera.zoom(nearer, {0, 0}, 1);
    window_->view().move_camera(camera);
    settle();
  }

  /// A click at a place of the view, in parts of its size, and rings of neighbours around the face.
  void select_patch(QPointF place, int rings) {
    const QSize size = window_->view().size();
    QTest::mouseClick(&window_->view(), Qt::LeftButton, {},
                      QPointF(place.x() * size.width(), place.y() * size.height()).toPoint());
    expect(window_->document().selection().count() == 1, "no face is under the pointer");
    for (int ring = 0; ring < rings; ++ring) test::action(*window_, "Grow").trigger();
    settle();
  }

  void show_brdf(BrdfEditor::View view) {
    window_->brdf_editor().set_view(view);
    settle();
  }

  QDockWidget& dock(const QString& name) {
    auto* found = window_->findChild<QDockWidget*>(name);
    editor::Docks::show(found);
    settle();
    return *found;
  }

  /// Until the view is drawn in full and no work is under way.
  void settle() {
    const auto is_idle = [this] {
      return (window_->view().is_complete() || !window_->view().isVisible()) &&
             QThreadPool::globalInstance()->activeThreadCount() == 0 &&
             !window_->brdf_editor().lobe().is_busy();
    };
    // Work that is done may begin other work.
    for (int turn = 0; turn < 5; ++turn) {
      QTest::qWait(20);
      expect(QTest::qWaitFor(is_idle, 5 * Minute), "the window has work without an end");
    }
  }

  /// A preview until it is done.
  void preview(QSize size, int samples) {
    options::RenderOptions few = window_->render_panel().options();
    few.size = {size.width(), size.height()};
    few.samples = samples;
    window_->render_panel().set_options(few);
    emit window_->render_panel().options_changed(few);
    bool is_done = false;
    const auto watched =
        QObject::connect(&window_->render_panel().preview(), &editor::Preview::state_changed,
                         [&](job::PreviewState state) { is_done = state == job::PreviewState::Done; });
    window_->render_panel().preview_action()->trigger();
    expect(QTest::qWaitFor([&] { return is_done; }, 5 * Minute), "the preview did not end");
    QObject::disconnect(watched);
    settle();
  }

 private:
  test::TemporaryFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

struct Picture {
  QString name;
  std::function<QPixmap()> make;
};

/// Spheres of all models, with faces of one selected.
void show_models(Stage& stage) {
  stage.open(Samples + "models/models.grf");
  stage.act("Look through the camera");
  stage.orbit(0.35, -0.35, 0.9);
  stage.select_patch({0.307, 0.6}, 6);
}

QPixmap window_with(BrdfEditor::View view, QSize size) {
  Stage stage(size);
  show_models(stage);
  stage.show_brdf(view);
  stage.draw_as(DisplayMode::Brdf);
  return stage.window().grab();
}

QPixmap empty_window() {
  Stage stage;
  return stage.window().grab();
}

QPixmap render_window() {
  Stage stage;
  stage.open_as_rendered(Samples + "plaza/plaza.grf");
  stage.preview({480, 320}, 48);
  return stage.window().grab();
}

QPixmap compared_images() {
  Stage stage;
  stage.open(Samples + "plaza/plaza.grf");
  editor::ImageBrowser& images = stage.window().image_browser();
  stage.preview({480, 320}, 4);
  images.show_image("4 samples", stage.window().render_panel().preview().image());
  stage.window().render_panel().stop_action()->trigger();
  stage.preview({480, 320}, 64);
  images.show_image("64 samples", stage.window().render_panel().preview().image());
  images.select_image("64 samples");
  images.select_reference("4 samples");
  images.set_comparison(editor::Comparison::Wipe);
  stage.dock("render").hide();
  for (const char* dock : {"scene", "lights", "surface", "brdf"}) stage.dock(dock).hide();
  stage.settle();
  return stage.window().grab();
}

QPixmap option_window() {
  editor::OptionsWindow window;
  expect(window.editor().open(Samples + "plaza/plaza.op"), "no options");
  window.resize(1200, 800);
  window.show();
  expect(QTest::qWaitForWindowExposed(&window), "the window did not show");
  QTest::qWait(100);
  return window.grab();
}

QPixmap viewer_window() {
  editor::ViewerWindow window;
  window.resize(1100, 720);
  window.show();
  QSignalSpy opened(&window, &editor::ViewerWindow::opened);
  window.open(Samples + "teapot/teapot.grf");
  expect(!opened.empty() || opened.wait(Minute), "the viewer opened nothing");
  test::action(window, "BRDF").trigger();
  expect(QTest::qWaitFor([&] { return window.view().is_complete(); }, Minute), "the viewer shows nothing");
  return window.grab();
}

QPixmap dock_with_models(const QString& name) {
  Stage stage;
  show_models(stage);
  return stage.dock(name).grab();
}

QPixmap brdf_dock(BrdfEditor::View view) {
  Stage stage;
  show_models(stage);
  stage.show_brdf(view);
  return stage.dock("brdf").grab();
}

QPixmap lights_dock() {
  Stage stage;
  stage.open(Samples + "cornell_box/cornell_box.grf");
  auto& list = *stage.window().findChild<QDockWidget*>("lights")->findChild<QAbstractItemView*>();
  list.setCurrentIndex(list.model()->index(0, 0));
  stage.settle();
  return stage.dock("lights").grab();
}

/// A scene with a mistake in a name, and where the message of it leads to.
QPixmap messages() {
  Stage stage({1280, 800});
  stage.open(stage.add("lamp.grf", R"(// A lamp over a table.
def wood = brdf ward sx=0.2 ks=0.1 kd=(0.4, 0.25, 0.1)
begin
  light begin
    rgb (20, 19, 17)
    (-0.5, 2, -0.5)
    (1, 0, 0)
    (0, 0, 1)
  end

  begin mesh "table"
    brdf wood
    pdf Owm
    begin vertexs
      (-1, 0, 1)
      (1, 0, 1)
      (1, 0, -1)
      (-1, 0, -1)
    end vertexs
    begin faces
      (0, 1, 2, 3)
    end faces
  end mesh
end
)"));
  stage.dock("messages");
  editor::MessagePanel& panel = stage.window().message_panel();
  expect(QTest::qWaitFor([&] { return panel.error_count() > 0; }, Minute), "the mistake was not found");
  panel.view()->setFocus();
  panel.view()->setCurrentIndex(panel.view()->model()->index(0, 0));
  QTest::keyClick(panel.view(), Qt::Key_Return);
  stage.settle();
  return stage.window().grab();
}

/// The eight ways to draw a scene, each with its name.
QPixmap display_modes() {
  Stage stage({1100, 800});
  for (const char* dock : {"scene", "lights", "surface", "brdf"}) stage.dock(dock).hide();
  const std::pair<const char*, QString> modes[] = {
      {"Points", "bunny/scene.grf"},         {"Wireframe", "shapes/knot.grf"},
      {"Solid", "teapot/teapot.grf"},        {"Solid with edges", "shapes/sphere.grf"},
      {"Textured", "garden/garden.grf"},     {"Vertex colours", "garden/garden.grf"},
      {"Irradiance", "baked_room/room.grf"}, {"BRDF", "models/models.grf"}};
  constexpr int Columns = 4;
  const QSize tile(400, 300);
  QPixmap sheet(Columns * tile.width(), 2 * tile.height());
  QPainter painter(&sheet);
  int number = 0;
  for (const auto& [mode, file] : modes) {
    stage.open(number == 0 ? Bunny : Samples + file);
    const QString options = QString(Samples + file).replace(".grf", ".op");
    if (number > 0 && QFile::exists(options)) stage.act("Look through the camera");
    stage.draw_as(static_cast<DisplayMode>(number));
    const QRect place(QPoint(number % Columns * tile.width(), number / Columns * tile.height()), tile);
    const QPixmap shown =
        stage.window().view().grab().scaled(tile, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    painter.drawPixmap(place.topLeft(), shown, QRect({(shown.width() - tile.width()) / 2, 0}, tile));
    const editor::ThemeColours colours = editor::colours_of(editor::theme_of(QApplication::palette()));
    const QRect label = place.adjusted(0, tile.height() - 3 * editor::Grid, 0, 0);
    painter.fillRect(label, colours.window);
    painter.setPen(colours.text);
    painter.drawText(label, Qt::AlignCenter, mode);
    ++number;
  }
  return sheet;
}

std::vector<Picture> pictures() {
  const auto window = [] { return window_with(BrdfEditor::View::Lobe, {1600, 1000}); };
  return {
      {"window", window},
      {"window_empty", empty_window},
      {"window_small",
       [] {
         return window_with(BrdfEditor::View::Sphere, {1024, 768});
       }},
      {"render", render_window},
      {"images", compared_images},
      {"options", option_window},
      {"viewer", viewer_window},
      {"modes", display_modes},
      {"messages", messages},
      {"scene", [] { return dock_with_models("scene"); }},
      {"lights", lights_dock},
      {"surface", [] { return dock_with_models("surface"); }},
      {"brdf_sphere", [] { return brdf_dock(BrdfEditor::View::Sphere); }},
      {"brdf_lobe", [] { return brdf_dock(BrdfEditor::View::Lobe); }},
      {"brdf_plots", [] { return brdf_dock(BrdfEditor::View::Plots); }},
      {"brdf_library", [] { return brdf_dock(BrdfEditor::View::Library); }},
  };
}

/// Large pictures are made smaller, or at 200 % cut to their upper right part, so that text stays as it is
/// drawn there. 6 bits a channel look the same as 8, in files of two thirds the size.
void write(const QPixmap& picture, const QString& file) {
  constexpr QSize Largest(1280, 800);
  QImage image = picture.toImage();
  if (picture.devicePixelRatio() > 1) {
    const QSize size = image.size().boundedTo(Largest);
    image = image.copy(QRect(QPoint(image.width() - size.width(), 0), size));
  } else if (image.width() > Largest.width()) {
    image = image.scaledToWidth(Largest.width(), Qt::SmoothTransformation);
  }
  image = image.convertToFormat(QImage::Format_RGB666, Qt::ThresholdDither | Qt::AvoidDither)
              .convertToFormat(QImage::Format_RGB888);
  expect(image.save(file, "PNG", 0), file + " cannot be written");
  std::cout << file.toStdString() << ' ' << image.width() << 'x' << image.height() << std::endl;
}

int make(const QCommandLineParser& parser) {
  const QDir folder(parser.value("to"));
  const QStringList wanted = parser.positionalArguments();
  for (const Picture& picture : pictures()) {
    if (!wanted.isEmpty() && !wanted.contains(picture.name)) continue;
    write(picture.make(), folder.filePath(picture.name + parser.value("suffix") + ".png"));
  }
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  test::OwnScreen screen;
  if (!screen.start({3840, 2400})) {
    std::cerr << "Xvfb cannot be started\n";
    return EXIT_FAILURE;
  }
  QApplication application(argc, argv);
  QApplication::setOrganizationName("granada");
  QApplication::setApplicationName("wannabe");
  QCommandLineParser parser;
  parser.addPositionalArgument("NAME", "The pictures to make; none: all.", "[NAME...]");
  parser.addOptions({{"to", "Folder of the pictures.", "FOLDER", "."},
                     {"suffix", "Added to each name.", "TEXT"},
                     {"theme", "dark or light.", "NAME", "dark"}});
  parser.process(application);
  editor::apply(parser.value("theme") == "light" ? editor::Theme::Light : editor::Theme::Dark, application);
  try {
    return make(parser);
  } catch (const std::exception& error) {
    std::cerr << "make_screenshots: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
