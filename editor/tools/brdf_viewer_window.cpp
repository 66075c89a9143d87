#include "editor/tools/brdf_viewer_window.h"

#include <QActionGroup>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QStatusBar>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "editor/appearance/theme.h"
#include "editor/controls/actions.h"
#include "editor/controls/notice_bar.h"
#include "editor/controls/text.h"
#include "editor/tools/brdf_view.h"
#include "editor/tools/shader_text_view.h"
#include "renderer/reflectance/model.h"
#include "renderer/studies/angles.h"

namespace editor {
namespace {

using Settings = studies::BrdfViewerSettings;

constexpr int RestTime = 500;  // milliseconds without a new frame after which the view rests
constexpr std::array<const char*, 3> ShapeNames = {"sphere", "teapot", "knot"};

std::string number(double value) { return fmt::format("{:.4g}", value); }
QString triple(const reflectance::Rgb& c) {
  return QString::fromStdString(number(c.x) + ", " + number(c.y) + ", " + number(c.z));
}

}  // namespace

BrdfViewerWindow::BrdfViewerWindow(const GraphicsDriver& driver, QWidget* parent)
    : ToolWindow(studies::brdf_viewer_tool(), parent),
      view_(new BrdfView(driver)),
      speed_(new QLabel),
      resting_(new QTimer(this)) {
  begin(view_);
  set_animation(15, 720);
  make_speed_label();
  make_actions();
  connect(view_, &BrdfView::turned, this, &BrdfViewerWindow::turn);
  connect(view_, &BrdfView::light_moved, this, &BrdfViewerWindow::move_light);
  connect(view_, &BrdfView::light_turned, this, &BrdfViewerWindow::turn_light);
  const auto change = [this](std::string_view name, double value, bool is_done) {
    studies::ToolState changed = state();
    set_setting(name, value, changed);
    show_edited(changed, is_done);
  };
  connect(view_, &BrdfView::split_moved, this,
          [change](double split, bool is_done) { change("split", split, is_done); });
  connect(view_, &BrdfView::zoomed, this,
          [this, change](double factor) { change("distance", setting("distance") * factor, true); });
  connect(view_, &BrdfView::exposed, this,
          [this, change](double stops) { change("exposure", setting("exposure") + stops, true); });
  connect(view_, &BrdfView::probed, this, &BrdfViewerWindow::show_probe);
  connect(view_, &BrdfView::pointer_left, this, [this] { pointed().clear(); });
  connect(view_, &BrdfView::failed, this, [this](const QString& message) {
    graphics_message_ = message;
    view_->show_hint(message);
    show_messages();
  });
  connect(view_, &BrdfView::drawn, this, [this] {
    show_speed();
    show_messages();
    if (shader_text_) shader_text_->set_sources(view_->image().sources);
    if (!is_busy()) emit updated();
  });
  connect(&loader_, &SceneLoader::loaded, this, [this](const std::shared_ptr<const LoadedScene>& scene) {
    building_.start(
        [scene](const StopFlag&) {
          return Object{scene->path, viewed_object(*scene->objects), {}};
        },
        [this](Object object) { take_object(std::move(object)); });
  });
  connect(&loader_, &SceneLoader::failed, this, [this](const LoadFailure& failure) {
    take_object({wanted_object_, nullptr, failure.message});
  });
  resting_->setSingleShot(true);
  connect(resting_, &QTimer::timeout, this, &BrdfViewerWindow::show_speed);
}

BrdfViewerWindow::~BrdfViewerWindow() = default;

void BrdfViewerWindow::make_speed_label() {
  speed_->setAccessibleName(tr("Speed"));
  speed_->setToolTip(tr("Frames per second while something moves; else how far the image is refined"));
  speed_->setContentsMargins(Grid, 0, Grid, 0);
  statusBar()->addPermanentWidget(speed_);
}

void BrdfViewerWindow::make_actions() {
  view_menu().addAction(new_switch(
      *this,
      {tr("Move the &light"), "light", QKeySequence("Ctrl+L"),
       tr("Let the pointer and the arrow keys move the light, not the object")},
      false, [this](bool is_on) { view_->set_tool(is_on ? BrdfView::Tool::Light : BrdfView::Tool::Turn); }));
  QMenu* lights = view_menu().addMenu(tr("Light that is &moved"));
  lights_ = new QActionGroup(this);
  for (int i = 1; i <= 3; ++i) {
    QAction* action = new_switch(*this,
                                 {tr("Light &%1").arg(i),
                                  {},
                                  QKeySequence(QString("Ctrl+%1").arg(i)),
                                  tr("Move light %1, which is turned on if it is off").arg(i)},
                                 i == 1, [](bool) {});
    action->setData(i);
    lights_->addAction(action);
    lights->addAction(action);
  }
  view_menu().addSeparator();
  view_menu().addAction(new_action(*this,
                                   {tr("&Shader text"), "browse", QKeySequence("Ctrl+U"),
                                    tr("Show the GLSL of the BRDFs, with the driver's messages")},
                                   [this] {
                                     shader_text().show();
                                     shader_text().raise();
                                     shader_text().activateWindow();
                                   }));
}

ShaderTextView& BrdfViewerWindow::shader_text() {
  if (!shader_text_) {
    shader_text_ = std::make_unique<ShaderTextView>();
    shader_text_->set_sources(view_->image().sources);
  }
  return *shader_text_;
}

QString BrdfViewerWindow::pointed_text() { return pointed().text(); }

bool BrdfViewerWindow::is_busy() const {
  return !has_followed() || compiling_.is_busy() || object_.name != wanted_object_ ||
         map_.path != wanted_map_ || view_->is_busy();
}

bool BrdfViewerWindow::has_picture() const { return view_->is_current() && !view_->image().image.isNull(); }

std::vector<studies::DataFile> BrdfViewerWindow::data_files() const {
  return {{"csv", "Radiance along the middle row", {}}};
}

bool BrdfViewerWindow::is_frame_shown() const { return view_->is_current(); }

void BrdfViewerWindow::request() {
  settings_ = reflectance::make<Settings>(state().settings);
  grf::Diagnostics diagnostics;
  const auto files = files_of(state(), diagnostics);
  file_message_ = text_of(diagnostics);
  request_materials();
  if (files) {
    request_object(*files);
    request_map(*files);
  }
  show_scene();
}

void BrdfViewerWindow::request_materials() {
  Materials wanted;
  wanted.models = state().brdfs;
  wanted.definitions = state().definitions;
  wanted.diffuseness = settings_.diffuseness;
  wanted.specularity = settings_.specularity;
  if (wanted.is_of(wanted_materials_)) return;
  wanted_materials_ = wanted;
  // In a thread, because a measured BRDF is read from its file.
  compiling_.start(
      [wanted](const StopFlag&) {
        Materials made = wanted;
        QStringList messages;
        for (std::size_t i = 0; i < 2; ++i) {
          const CompiledBrdf compiled = compile_brdf(wanted.models[i], wanted.definitions);
          for (const QString& error : compiled.errors) messages.append(error);
          if (compiled.brdf)
            made.brdfs[i] = std::make_shared<const studies::LitBrdf>(
                studies::lit_brdf(*compiled.brdf, wanted.diffuseness, wanted.specularity));
        }
        made.messages = messages.join('\n');
        return made;
      },
      [this](Materials made) {
        materials_ = std::move(made);
        show_scene();
      });
}

void BrdfViewerWindow::request_object(const studies::ViewerFiles& files) {
  QString name;
  if (settings_.shape != Settings::Model) {
    name = ShapeNames[static_cast<std::size_t>(settings_.shape)];
  } else if (files.model != nullptr) {
    name = QFileInfo(QString::fromStdString(files.model->path)).absoluteFilePath();
  }
  if (name == wanted_object_) return;
  wanted_object_ = name;
  loader_.cancel();
  building_.stop();
  if (name.isEmpty()) {
    take_object({name, nullptr, {}});
  } else if (settings_.shape == Settings::Model) {
    loader_.start(name);
  } else {
    building_.start(
        [name, shape = settings_.shape](const StopFlag&) {
          return Object{name, viewed_object(objects_of(studies::scene_of_shape(shape), {})), {}};
        },
        [this](Object object) { take_object(std::move(object)); });
  }
}

void BrdfViewerWindow::take_object(Object object) {
  object_ = std::move(object);
  if (object_.object && object_.object->triangles == 0) {
    object_.object.reset();
    object_.message = tr("%1 has no faces to show").arg(object_.name);
  }
  show_scene();
}

void BrdfViewerWindow::request_map(const studies::ViewerFiles& files) {
  const QString path = settings_.sky == Settings::Map && files.environment != nullptr
                           ? QString::fromStdString(files.environment->path)
                           : QString();
  if (path == wanted_map_) return;
  wanted_map_ = path;
  if (path.isEmpty()) {
    reading_.stop();
    map_ = {};
    return;
  }
  reading_.start(
      [path](const StopFlag&) {
        Map map;
        map.path = path;
        grf::Diagnostics diagnostics;
        auto read = transport::read_environment_map(path.toStdString(), diagnostics);
        map.message = text_of(diagnostics);
        if (!read) return map;
        map.map = std::make_shared<const transport::EnvironmentMap>(*std::move(read));
        map.environment.set_map(map.map);
        return map;
      },
      [this](Map map) {
        map_ = std::move(map);
        show_scene();
      });
}

void BrdfViewerWindow::show_scene() {
  show_messages();
  if (!graphics_message_.isEmpty()) return;
  if (object_.name == wanted_object_ && !object_.object) {
    view_->show_hint(wanted_object_.isEmpty()
                         ? tr("No model is open.\n\nOpen a file (Ctrl+O), or drop one here.")
                         : tr("There is no object to show: see the message above."));
    return emit updated();
  }
  if (!object_.object || !materials_.brdfs[0] || !materials_.brdfs[1]) return;
  BrdfScene scene;
  scene.object = object_.object;
  scene.brdfs = materials_.brdfs;
  scene.split = settings_.split;
  scene.lighting.lights = settings_.lights();
  scene.lighting.samples = settings_.sample_count();
  studies::Environment& sky = scene.lighting.environment;
  if (settings_.sky != Settings::Map || map_.map) {
    if (settings_.sky == Settings::Map) sky = map_.environment;
    sky.kind = static_cast<studies::Environment::Kind>(settings_.sky);
    sky.scale = settings_.radiance;
    sky.turned = static_cast<float>(settings_.turned * studies::Degree);
  }
  const double aspect = static_cast<double>(view_->width()) / std::max(1, view_->height());
  scene.view = settings_.view(object_.object->bounds, aspect);
  scene.exposure = settings_.exposure;
  scene.has_backdrop = settings_.backdrop;
  view_->show_scene(scene);
}

/// Shows what is wrong with the state and with what it names, the gravest first.
void BrdfViewerWindow::show_messages() {
  QStringList errors;
  if (!graphics_message_.isEmpty()) errors.append(graphics_message_);
  if (!file_message_.isEmpty()) errors.append(file_message_);
  if (!materials_.messages.isEmpty()) errors.append(materials_.messages);
  if (object_.name == wanted_object_ && !object_.message.isEmpty()) errors.append(object_.message);
  if (settings_.sky == Settings::Map) {
    if (wanted_map_.isEmpty()) errors.append(tr("No environment map is open: open an EXR or HDR file."));
    if (map_.path == wanted_map_ && !map_.message.isEmpty()) errors.append(map_.message);
  }
  QStringList all = errors;
  if (view_->scene().object) all.append(view_->image().limitations);
  if (all.isEmpty()) return notice().hide();
  const QString text = all.join('\n');
  if (notice().isVisible() && notice().text() == text) return;
  notice().show_notice(errors.isEmpty() ? NoticeBar::Kind::Information : NoticeBar::Kind::Error, text);
}

void BrdfViewerWindow::show_speed() {
  const BrdfImage& image = view_->image();
  const double speed = view_->frames_per_second();
  if (speed > 0) {
    QString text = tr("%1 frames/s").arg(speed, 0, 'f', 0);
    if (image.scale > 1) text += tr(" at 1/%1 resolution").arg(image.scale);
    speed_->setText(text);
    return resting_->start(RestTime);
  }
  if (image.passes == 0) return;
  QString text =
      image.is_done() ? tr("refined") : tr("refined %1 of %2 times").arg(image.passes).arg(image.all_passes);
  if (!image.is_by_glsl) text += tr(", on the CPU");
  speed_->setText(text);
}

void BrdfViewerWindow::show_probe(const PixelProbe& probe) {
  if (!probe.is_object) return pointed().clear();
  const reflectance::Rgb difference = probe.by_gpu - probe.by_cpu;
  const float largest = std::max({std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)});
  pointed().setText(tr("BRDF %1 at \u03B8 = %2\u00B0: GPU %3; CPU %4; difference %5")
                        .arg(probe.is_first ? "A" : "B")
                        .arg(probe.view_angle, 0, 'f', 1)
                        .arg(triple(probe.by_gpu), triple(probe.by_cpu))
                        .arg(static_cast<double>(largest), 0, 'g', 2));
}

void BrdfViewerWindow::move_light(const reflectance::Vec3f& direction, bool is_done) {
  const std::string light = lights_->checkedAction()->data().toString().toStdString();
  const studies::Heading heading = studies::heading_of(direction);
  studies::ToolState changed = state();
  set_setting("azimuth" + light, heading.azimuth, changed);
  set_setting("elevation" + light, heading.elevation, changed);
  const std::array all = {settings_.light1, settings_.light2, settings_.light3};
  if (reflectance::is_black(all[static_cast<std::size_t>(std::stoi(light) - 1)]))
    set_setting("light" + light, 1, changed);
  show_edited(changed, is_done);
}

void BrdfViewerWindow::turn_light(const QPointF& by) {
  const std::string light = lights_->checkedAction()->data().toString().toStdString();
  const double azimuth = std::remainder(setting("azimuth" + light) + by.x(), 360);
  move_light(studies::direction_at(azimuth, std::clamp(setting("elevation" + light) + by.y(), -89.0, 89.0)),
             true);
}

void BrdfViewerWindow::closeEvent(QCloseEvent* event) {
  shader_text_.reset();
  ToolWindow::closeEvent(event);
}

}  // namespace editor
