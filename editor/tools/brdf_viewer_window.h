#pragma once

#include <array>
#include <memory>

#include "editor/brdf/compiled_brdf.h"
#include "editor/document/scene_loader.h"
#include "editor/graphics/graphics_driver.h"
#include "editor/tools/brdf_scene.h"
#include "editor/tools/tool_window.h"
#include "renderer/studies/brdf_viewer/tool.h"

class QActionGroup;

namespace editor {

class BrdfView;
class ShaderTextView;

/// The window of the tool `brdfviewer`: BRDFs on an object in real time, drawn with GLSL.
class BrdfViewerWindow : public ToolWindow {
  Q_OBJECT

 public:
  explicit BrdfViewerWindow(const GraphicsDriver& driver = {}, QWidget* parent = nullptr);
  ~BrdfViewerWindow() override;

  BrdfView& view() { return *view_; }
  /// The window with the shaders, which is shown on request.
  ShaderTextView& shader_text();
  /// Text of the status line: the values under the pointer.
  QString pointed_text();
  bool has_picture() const override;
  bool is_busy() const override;

 protected:
  void request() override;
  std::vector<studies::DataFile> data_files() const override;
  bool is_frame_shown() const override;
  void closeEvent(QCloseEvent* event) override;

 private:
  /// BRDFs for which the light is computed, and what they were made from.
  struct Materials {
    std::vector<grf::BrdfModel> models;
    Definitions definitions;
    float diffuseness = 1;
    float specularity = 1;
    std::array<std::shared_ptr<const studies::LitBrdf>, 2> brdfs;  ///< null after an error
    QString messages;

    bool is_of(const Materials& other) const {
      return models == other.models && definitions == other.definitions && diffuseness == other.diffuseness &&
             specularity == other.specularity;
    }
  };
  /// An object or an environment map with the name of its file, or a shape's.
  struct Object {
    QString name;
    std::shared_ptr<const ViewedObject> object;
    QString message;
  };
  struct Map {
    QString path;
    std::shared_ptr<const transport::EnvironmentMap> map;
    studies::Environment environment;  ///< with the directions drawn from the map
    QString message;
  };

  void make_actions();
  void make_speed_label();
  void request_materials();
  void request_object(const studies::ViewerFiles& files);
  void request_map(const studies::ViewerFiles& files);
  void take_object(Object object);
  void show_scene();
  void show_messages();
  void show_speed();
  void show_probe(const PixelProbe& probe);
  void move_light(const reflectance::Vec3f& direction, bool is_done);
  void turn_light(const QPointF& by);

  BrdfView* view_;
  QLabel* speed_;
  QTimer* resting_;  ///< until the speed of the last movement is no longer shown
  QActionGroup* lights_ = nullptr;
  std::unique_ptr<ShaderTextView> shader_text_;  ///< a separate window
  studies::BrdfViewerSettings settings_;
  Materials materials_;
  Object object_;
  Map map_;
  QString wanted_object_, wanted_map_;
  Materials wanted_materials_;
  QString file_message_;      ///< about the files of the state
  QString graphics_message_;  ///< why nothing can be drawn
  SceneLoader loader_;
  BackgroundJob<Materials> compiling_{this};
  BackgroundJob<Object> building_{this};
  BackgroundJob<Map> reading_{this};
};

}  // namespace editor
