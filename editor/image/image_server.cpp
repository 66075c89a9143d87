#include "editor/image/image_server.h"

#include <QLocalServer>
#include <QLocalSocket>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>
#include <algorithm>

namespace editor {
namespace {

using std::chrono::milliseconds;

/// Minimum time between two displayed updates.
constexpr milliseconds Pause(100);
/// Maximum size of a packet, and so of a whole image of 40 million pixels.
constexpr qint64 LargestPacket = qint64(1) << 29;
/// Size of the receive buffer: a faster sender has to wait.
constexpr qint64 BufferSize = qint64(1) << 23;
/// Timeout for another viewer at the same address, milliseconds.
constexpr int AnswerTime = 500;
/// Bytes of packets that are read before the event loop continues.
constexpr qint64 BytesPerTurn = qint64(1) << 22;

QString text_of(const std::string& name) { return QString::fromStdString(name); }

}  // namespace

ImageServer::ImageServer(const Limits& limits, QObject* parent)
    : QObject(parent), limits_(limits), ports_(new QTcpServer(this)), paths_(new QLocalServer(this)) {
  announcing_.setSingleShot(true);
  announcing_.setInterval(Pause);
  paths_->setSocketOptions(QLocalServer::UserAccessOption);
  connect(ports_, &QTcpServer::newConnection, this, [this] {
    while (QTcpSocket* socket = ports_->nextPendingConnection()) accept(socket);
  });
  connect(paths_, &QLocalServer::newConnection, this, [this] {
    while (QLocalSocket* socket = paths_->nextPendingConnection()) accept(socket);
  });
  connect(&announcing_, &QTimer::timeout, this, &ImageServer::announce);
}

bool ImageServer::listen(const display::Address& address) {
  if (!address.path.empty()) return listen_at_path(QString::fromStdString(address.path));
  return ports_->listen(QHostAddress::LocalHost, QString::fromStdString(address.port).toUShort());
}

/// A viewer that was killed leaves its socket, which is replaced. That of a running one is not.
bool ImageServer::listen_at_path(const QString& path) {
  QLocalSocket other;
  other.connectToServer(path);
  if (other.waitForConnected(AnswerTime)) return false;
  QLocalServer::removeServer(path);
  return paths_->listen(path);
}

display::Address ImageServer::address() const {
  if (paths_->isListening()) return {.path = paths_->fullServerName().toStdString()};
  return {.port = std::to_string(ports_->serverPort())};
}

QString ImageServer::problem() const {
  if (ports_->serverError() != QAbstractSocket::UnknownSocketError) return ports_->errorString();
  return paths_->serverError() != QAbstractSocket::UnknownSocketError ? paths_->errorString()
                                                                      : tr("another viewer uses it");
}

template <class Socket>
void ImageServer::accept(Socket* socket) {
  connect(socket, &Socket::disconnected, socket, &QObject::deleteLater);
  if (senders_ == limits_.senders) return socket->abort();
  ++senders_;
  connect(socket, &Socket::disconnected, this, [this, socket] {
    --senders_;
    for (Received& received : images_) {
      if (received.sender == socket) received.sender = nullptr;
    }
  });
  socket->setReadBufferSize(BufferSize);
  connect(socket, &Socket::readyRead, this, [this, socket] { read(socket); });
  read(socket);
}

template <class Socket>
void ImageServer::read(Socket* socket) {
  for (qint64 taken = 0; socket->bytesAvailable() >= qint64(display::LengthBytes);) {
    const QByteArray head = socket->peek(display::LengthBytes);
    const auto size = static_cast<qint64>(display::packet_size({head.data(), std::size_t(head.size())}));
    // A packet larger than the buffer would never be complete.
    socket->setReadBufferSize(std::clamp(size, BufferSize, LargestPacket));
    QString problem = problem_of_packet(size);
    if (problem.isEmpty() && socket->bytesAvailable() < size) return;
    if (problem.isEmpty()) problem = apply(socket->read(size), *socket);
    if (!problem.isEmpty()) {
      emit failed(problem);
      return socket->abort();
    }
    taken += size;
    if (taken < BytesPerTurn) continue;
    QTimer::singleShot(0, socket, [this, socket] { read(socket); });
    return;
  }
}

QString ImageServer::problem_of_packet(qint64 size) {
  if (size > qint64(display::LengthBytes) && size <= LargestPacket) return {};
  return tr("A program sent data that is not a packet of the tev protocol, and was disconnected.");
}

QString ImageServer::apply(const QByteArray& bytes, const QIODevice& sender) {
  const auto packet = display::read_packet({bytes.data(), std::size_t(bytes.size())});
  if (!packet) return tr("A program sent a damaged packet of the tev protocol, and was disconnected.");
  const QString problem = std::visit([&](const auto& kind) { return apply(kind, sender); }, *packet);
  if (!changed_.isEmpty() && !announcing_.isActive()) announcing_.start();
  return problem;
}

ImageServer::Images::iterator ImageServer::find(const std::string& name) {
  return std::find_if(images_.begin(), images_.end(),
                      [&](const Received& received) { return received.name == text_of(name); });
}

QString ImageServer::apply(const display::CloseImagePacket& packet, const QIODevice&) {
  announce();
  if (const auto found = find(packet.name); found != images_.end()) images_.erase(found);
  return {};
}

/// Drops the oldest images of programs that have disconnected, until one of so many pixels fits. Returns
/// whether it does.
bool ImageServer::make_room(std::size_t pixels) {
  std::size_t sum = pixels;
  for (const Received& received : images_) sum += received.image->pixels.size();
  for (auto oldest = images_.begin(); oldest != images_.end();) {
    if (images_.size() < limits_.images && sum <= limits_.pixels) break;
    if (oldest->sender != nullptr) {
      ++oldest;
      continue;
    }
    sum -= oldest->image->pixels.size();
    changed_.remove(oldest->name);
    const QString name = oldest->name;
    oldest = images_.erase(oldest);
    emit dropped(name);
  }
  return images_.size() < limits_.images && sum <= limits_.pixels;
}

QString ImageServer::apply(const display::CreateImagePacket& packet, const QIODevice& sender) {
  if (const auto former = find(packet.name); former != images_.end()) images_.erase(former);
  const auto pixels = static_cast<std::size_t>(packet.width) * static_cast<std::size_t>(packet.height);
  if (!make_room(pixels))
    return tr("A program sent more images than there is room for, and was disconnected.");
  images_.push_back({text_of(packet.name),
                     std::make_shared<image::Image>(image::Image{
                         packet.width, packet.height, std::vector<grf::Colour>(pixels, grf::Colour(0))}),
                     &sender});
  changed_.insert(text_of(packet.name));
  return {};
}

QString ImageServer::apply(const display::UpdateImagePacket& packet, const QIODevice&) {
  const auto found = find(packet.name);
  if (found == images_.end()) return {};
  std::shared_ptr<image::Image>& image = found->image;
  const transport::TileBounds& bounds = packet.bounds;
  if (bounds.x > image->width - bounds.width || bounds.y > image->height - bounds.height) return {};
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
  changed_.insert(found->name);
  return {};
}

void ImageServer::announce() {
  const QSet<QString> changed = std::exchange(changed_, {});
  for (const QString& name : changed) {
    if (const auto found = find(name.toStdString()); found != images_.end())
      emit received(name, found->image);
  }
}

}  // namespace editor
