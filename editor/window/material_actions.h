#pragma once

#include <QList>
#include <QObject>

class QAction;
class QWidget;

namespace editor {

class Document;

/// Copies and pastes materials, as GRF text on the clipboard, which can be sent to others.
class MaterialActions : public QObject {
  Q_OBJECT

 public:
  MaterialActions(Document& document, QWidget& window);

  const QList<QAction*>& actions() const { return actions_; }

 signals:
  void status_message(const QString& text);
  /// Emitted with the reason why the clipboard cannot be pasted.
  void failed(const QString& reason);

 private:
  void copy();
  void paste();
  void update();

  Document& document_;
  QList<QAction*> actions_;
};

}  // namespace editor
