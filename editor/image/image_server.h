#pragma once

#include <QObject>
#include <QSet>
#include <QTimer>
#include <map>
#include <memory>

#include "renderer/display/reader.h"
#include "renderer/image/image.h"

class QTcpServer;
class QTcpSocket;

namespace editor {

/// Receives images of renders in progress, from `bpt` with BPT_DisplayWindow or another program that uses
/// tev's network protocol. Only programs of this machine can connect.
class ImageServer : public QObject {
  Q_OBJECT

 public:
  /// The port on which `bpt` looks for a viewer.
  static quint16 usual_port();

  explicit ImageServer(QObject* parent = nullptr);

  /// Starts to listen; port 0 chooses any free port. Returns false if the port is in use, as by another
  /// viewer, and `problem` says why.
  bool listen(quint16 port = usual_port());
  quint16 port() const;
  QString problem() const;

 signals:
  /// Emitted with a new image, or an update of one, a few times per second.
  void received(const QString& name, std::shared_ptr<const image::Image> image);
  /// Emitted when a program has finished an image, and may send another one of that name.
  void closed(const QString& name);
  /// Emitted when a client was disconnected after it sent an invalid packet.
  void failed(const QString& why);

 private:
  void accept();
  void read(QTcpSocket* socket);
  bool apply(const QByteArray& bytes);
  void apply(const display::CloseImagePacket& packet);
  void apply(const display::CreateImagePacket& packet);
  void apply(const display::UpdateImagePacket& packet);
  void apply(const display::OtherPacket&) {}
  void announce();

  QTcpServer* server_;
  std::map<QString, std::shared_ptr<image::Image>> images_;
  QSet<QString> changed_;
  QTimer announcing_;
};

}  // namespace editor
