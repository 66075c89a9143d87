#pragma once

#include <QObject>

namespace editor {

class Document;
class LightPanel;
class NoticeBar;
class ObjectActions;
class ViewController;

/// Places lights by clicks in the 3D view, and offers lights for scenes that have none.
class LightController : public QObject {
  Q_OBJECT

 public:
  /// All but the parent outlive the controller.
  LightController(Document& document, LightPanel& lights, ViewController& view, ObjectActions& objects,
                  NoticeBar& notice, QObject* parent);

  /// Adds a studio to an imported model without lights, unless the user has refused it for this model: a grey
  /// shape under a grey sky is no picture to judge materials by.
  void light_first_preview();

 private:
  void offer_lights();
  void aim();
  void place_highlight();

  Document& document_;
  LightPanel& lights_;
  ViewController& view_;
  ObjectActions& objects_;
  NoticeBar& notice_;
  bool refuses_studio_ = false;  ///< for the model that was imported
};

}  // namespace editor
