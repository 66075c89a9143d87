#pragma once

#include <QObject>

class QAction;

namespace editor {

class Document;
class EffectsPage;
class MainWindow;
class Pages;
class RenderPanel;

/// Shows the page Effects, which is created on first use, and the images and faces that it asks for.
class EffectsController : public QObject {
  Q_OBJECT

 public:
  /// All outlive the controller.
  EffectsController(Document& document, RenderPanel& render, Pages& pages, MainWindow& window);

  /// Shows the page, for a menu.
  QAction* action() const { return action_; }
  /// Goes to the page.
  EffectsPage& page();

 signals:
  void status_message(const QString& message);

 private:
  Document& document_;
  RenderPanel& render_;
  Pages& pages_;
  MainWindow& window_;
  QAction* action_;
  EffectsPage* page_ = nullptr;
};

}  // namespace editor
