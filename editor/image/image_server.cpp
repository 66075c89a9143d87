#include "editor/image/image_server.h"

#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>

#include "renderer/display/address.h"

namespace editor {
namespace {

using std::chrono::milliseconds;

/// Minimum time between two displayed updates.
constexpr milliseconds Pause(100);
/// Maximum size of a packet, and so of a whole image of 40 million pixels.
constexpr qint64 LargestPacket = qint64(1) << 29;
/// Size of the receive buffer: a faster sender has to wait.
constexpr qint64 BufferSize = qint64(1) << 23;
/// Bytes of packets that are read before the event loop continues.
constexpr qint64 BytesPerTurn = qint64(1) << 22;

QString text_of(const std::string& name) { return QString::fromStdString(name); }

}  // namespace

ImageServer::ImageServer(QObject* parent) : QObject(parent), server_(new QTcpServer(this)) {
  announcing_.setSingleShot(true);
  announcing_.setInterval(Pause);
  connect(server_, &QTcpServer::newConnection, this, &ImageServer::accept);
  connect(&announcing_, &QTimer::timeout, this, &ImageServer::announce);
}

quint16 ImageServer::usual_port() {
  return QString::fromStdString(display::default_address().port).toUShort();
}

bool ImageServer::listen(quint16 port) { return server_->listen(QHostAddress::LocalHost, port); }

quint16 ImageServer::port() const { return server_->serverPort(); }

QString ImageServer::problem() const { return server_->errorString(); }

void ImageServer::accept() {
  while (QTcpSocket* socket = server_->nextPendingConnection()) {
    socket->setReadBufferSize(BufferSize);
    connect(socket, &QTcpSocket::readyRead, this, [this, socket] { read(socket); });
    connect(socket, &QTcpSocket::disconnected, socket, &QObject::deleteLater);
    read(socket);
  }
}

void ImageServer::read(QTcpSocket* socket) {
  for (qint64 taken = 0; socket->bytesAvailable() >= qint64(display::LengthBytes);) {
    const QByteArray head = socket->peek(display::LengthBytes);
    const auto size = static_cast<qint64>(display::packet_size({head.data(), std::size_t(head.size())}));
    if (size <= qint64(display::LengthBytes) || size > LargestPacket) {
      emit failed(tr("A program sent data that is not a packet of the tev protocol, and was disconnected."));
      return socket->abort();
    }
    // A packet larger than the buffer would never be complete.
    socket->setReadBufferSize(std::max(BufferSize, size));
    if (socket->bytesAvailable() < size) return;
    if (!apply(socket->read(size))) {
      emit failed(tr("A program sent a damaged packet of the tev protocol, and was disconnected."));
      return socket->abort();
    }
    taken += size;
    if (taken < BytesPerTurn) continue;
    QTimer::singleShot(0, socket, [this, socket] { read(socket); });
    return;
  }
}

bool ImageServer::apply(const QByteArray& bytes) {
  const auto packet = display::read_packet({bytes.data(), std::size_t(bytes.size())});
  if (!packet) return false;
  std::visit([this](const auto& kind) { apply(kind); }, *packet);
  if (!changed_.isEmpty() && !announcing_.isActive()) announcing_.start();
  return true;
}

void ImageServer::apply(const display::CloseImagePacket& packet) {
  announce();
  if (images_.erase(text_of(packet.name)) > 0) emit closed(text_of(packet.name));
}

void ImageServer::apply(const display::CreateImagePacket& packet) {
  const auto pixels = static_cast<std::size_t>(packet.width) * static_cast<std::size_t>(packet.height);
  images_[text_of(packet.name)] = std::make_shared<image::Image>(
      image::Image{packet.width, packet.height, std::vector<grf::Colour>(pixels, grf::Colour(0))});
  changed_.insert(text_of(packet.name));
}

void ImageServer::apply(const display::UpdateImagePacket& packet) {
  const auto found = images_.find(text_of(packet.name));
  if (found == images_.end()) return;
  std::shared_ptr<image::Image>& image = found->second;
  const transport::TileBounds& bounds = packet.bounds;
  if (bounds.x > image->width - bounds.width || bounds.y > image->height - bounds.height) return;
  // An image that was passed on is shown and read by threads: it must not change.
  if (image.use_count() > 1) image = std::make_shared<image::Image>(*image);
  const bool has_all = packet.has_channel == std::array{true, true, true};
  for (int y = 0; y < bounds.height; ++y) {
    const auto* from = &packet.pixels[std::size_t(y) * std::size_t(bounds.width)];
    const std::size_t start = std::size_t(bounds.y + y) * std::size_t(image->width) + std::size_t(bounds.x);
    auto* to = &image->pixels[start];
    if (has_all) {
      std::copy_n(from, bounds.width, to);
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      for (int x = 0; x < bounds.width && packet.has_channel[std::size_t(k)]; ++x) to[x][k] = from[x][k];
    }
  }
  changed_.insert(found->first);
}

void ImageServer::announce() {
  const QSet<QString> changed = std::exchange(changed_, {});
  for (const QString& name : changed) {
    if (const auto found = images_.find(name); found != images_.end()) emit received(name, found->second);
  }
}

}  // namespace editor
