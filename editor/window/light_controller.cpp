#include "editor/window/light_controller.h"

#include <QUndoStack>
#include <memory>
#include <optional>

#include "editor/controls/notice_bar.h"
#include "editor/document/document.h"
#include "editor/panels/light_panel.h"
#include "editor/window/object_actions.h"
#include "editor/window/view_controller.h"

namespace editor {

LightController::LightController(Document& document, LightPanel& lights, ViewController& view,
                                 ObjectActions& objects, NoticeBar& notice, QObject* parent)
    : QObject(parent), document_(document), lights_(lights), view_(view), objects_(objects), notice_(notice) {
  connect(&document, &Document::scene_replaced, this, [this] { refuses_studio_ = false; });
  connect(&document, &Document::scene_has_no_lights, this, &LightController::offer_lights);
  connect(&lights, &LightPanel::aim_requested, this, &LightController::aim);
  connect(&lights, &LightPanel::highlight_requested, this, &LightController::place_highlight);
}

void LightController::offer_lights() {
  notice_.show_notice(
      NoticeBar::Kind::Information, tr("The scene has no lights. Until it has one, renders use a grey sky."),
      {{tr("Add a light"), tr("Add an area light above the scene"), [this] { lights_.add(); }},
       {tr("Add a studio"), tr("Add a floor, a soft box and a rim light in proportion to the scene"),
        [this] { objects_.add_studio(); }}});
}

void LightController::light_first_preview() {
  if (!document_.has_plain_sky() || !document_.path().isEmpty() || refuses_studio_) return;
  objects_.add_studio();
  const int step = document_.undo_stack().index();
  notice_.show_notice(
      NoticeBar::Kind::Information,
      tr("The model has no lights, so a studio was added to the scene: a floor, a soft box and a rim light."),
      {{tr("Without the studio"), tr("Remove the studio, and render under a grey sky"), [this, step] {
          refuses_studio_ = true;
          if (document_.undo_stack().index() == step) document_.undo_stack().undo();
        }}});
  // What is edited afterwards is not undone with the studio.
  connect(
      &document_.undo_stack(), &QUndoStack::indexChanged, &notice_,
      [this, text = notice_.text()] {
        if (notice_.text() == text) notice_.hide();
      },
      Qt::SingleShotConnection);
}

void LightController::aim() {
  view_.pick({tr("Click what the light shall shine on, or press Escape to cancel"),
              [this](const SurfacePoint& point) {
                std::optional<Lamp> lamp = lights_.lamp();
                if (!lamp) return;
                editor::aim(*lamp, point.position);
                lights_.change_lamp(*lamp, tr("Aim light"));
              }});
}

void LightController::place_highlight() {
  // The distance from the first point of a drag is kept.
  const auto distance = std::make_shared<std::optional<double>>();
  const auto picked = [this, distance](const SurfacePoint& point) {
    std::optional<Lamp> lamp = lights_.lamp();
    // A mesh light reflects nothing; it may be the lamp itself.
    if (!lamp || document_.objects().meshes[point.face.mesh].is_light) return;
    if (!*distance) *distance = (lamp->centre - point.position).length();
    light_highlight(*lamp, point.position, point.normal, point.view_direction, **distance);
    lights_.change_lamp(*lamp, tr("Light highlight"), "light highlight");
  };
  view_.pick({tr("Click or drag where the light's reflection shall be, or press Escape to cancel"), picked,
              [this] { document_.finish_gesture(); }, true});
}

}  // namespace editor
