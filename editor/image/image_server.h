#pragma once

#include <QObject>
#include <QSet>
#include <QTimer>
#include <map>
#include <memory>

#include "renderer/transport/display_reader.h"

class QTcpServer;
class QTcpSocket;

namespace editor {

/// Receives images as they form, from `bpt` with BPT_DisplayWindow or another program that speaks tev's
/// network protocol. Programs of this machine alone are listened to.
class ImageServer : public QObject {
  Q_OBJECT

 public:
  /// Where `bpt` looks for a viewer.
  static quint16 usual_port();

  explicit ImageServer(QObject* parent = nullptr);

  /// Begins to listen; 0: any port that is free. False if it is taken, as by another viewer: `problem` says
  /// why.
  bool listen(quint16 port = usual_port());
  quint16 port() const;
  QString problem() const;

 signals:
  /// A new image, or a new state of one. States come a few times a second.
  void received(const QString& name, std::shared_ptr<const transport::Image> image);
  /// A program is done with an image of that name, and may send another one.
  void closed(const QString& name);
  /// Something came that is no packet; its sender was cut off.
  void failed(const QString& why);

 private:
  void accept();
  void read(QTcpSocket* socket);
  bool apply(const QByteArray& bytes);
  void apply(const transport::CloseImagePacket& packet);
  void apply(const transport::CreateImagePacket& packet);
  void apply(const transport::UpdateImagePacket& packet);
  void apply(const transport::OtherPacket&) {}
  void announce();

  QTcpServer* server_;
  std::map<QString, std::shared_ptr<transport::Image>> images_;
  QSet<QString> changed_;
  QTimer announcing_;
};

}  // namespace editor
