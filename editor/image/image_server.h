#pragma once

#include <QObject>
#include <QSet>
#include <QTimer>
#include <list>
#include <memory>

#include "renderer/display/address.h"
#include "renderer/display/reader.h"
#include "renderer/image/image.h"

class QIODevice;
class QLocalServer;
class QTcpServer;

namespace editor {

/// Receives images of renders in progress, from `bpt` with BPT_DisplayWindow or another program that uses
/// tev's network protocol. At a socket's path, only programs of this user can connect; at a port, those of
/// this machine. Whatever they send, the images and connections are bounded.
class ImageServer : public QObject {
  Q_OBJECT

 public:
  /// Bounds of what is kept.
  struct Limits {
    std::size_t images = 64;
    std::size_t pixels = std::size_t(1) << 27U;  ///< of all images, 12 bytes each
    int senders = 16;                            ///< connected at the same time
  };

  explicit ImageServer(QObject* parent = nullptr) : ImageServer(Limits(), parent) {}
  explicit ImageServer(const Limits& limits, QObject* parent = nullptr);

  /// Starts to listen; port 0 chooses any free port. Returns false if the address is in use, as by another
  /// viewer, and `problem` says why.
  bool listen(const display::Address& address = display::default_address());
  display::Address address() const;
  QString problem() const;

 signals:
  /// Emitted with a new image, or an update of one, a few times per second.
  void received(const QString& name, std::shared_ptr<const image::Image> image);
  /// Emitted when an image of an ended render has made room for another one.
  void dropped(const QString& name);
  /// Emitted when a client was disconnected after it sent an invalid packet or too many images.
  void failed(const QString& why);

 private:
  struct Received {
    QString name;
    std::shared_ptr<image::Image> image;
    const QIODevice* sender = nullptr;  ///< null: its program has disconnected
  };
  using Images = std::list<Received>;

  bool listen_at_path(const QString& path);
  template <class Socket>
  void accept(Socket* socket);
  template <class Socket>
  void read(Socket* socket);
  /// These return why the sender is to be disconnected; empty if it is not.
  static QString problem_of_packet(qint64 size);
  QString apply(const QByteArray& bytes, const QIODevice& sender);
  QString apply(const display::CloseImagePacket& packet, const QIODevice& sender);
  QString apply(const display::CreateImagePacket& packet, const QIODevice& sender);
  QString apply(const display::UpdateImagePacket& packet, const QIODevice& sender);
  QString apply(const display::OtherPacket&, const QIODevice&) { return {}; }
  Images::iterator find(const std::string& name);
  bool make_room(std::size_t pixels);
  void announce();

  const Limits limits_;
  QTcpServer* ports_;
  QLocalServer* paths_;
  Images images_;  ///< the oldest first
  QSet<QString> changed_;
  QTimer announcing_;
  int senders_ = 0;
};

}  // namespace editor
