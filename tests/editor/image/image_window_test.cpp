// The image window shows what programs send to its server.
#include "editor/image/image_window.h"

#include <QLocalSocket>
#include <QSignalSpy>
#include <QTcpSocket>
#include <QTest>
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "editor/image/image_browser.h"
#include "renderer/display/packets.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using grf::Colour;

quint16 port_of(const ImageServer& server) {
  return QString::fromStdString(server.address().port).toUShort();
}

/// A server at a socket, with small limits, and programs that send images to it.
class LocalImageServer : public testing::Test {
 protected:
  LocalImageServer() {
    EXPECT_TRUE(server_.listen({.path = path_}));
    QObject::connect(&server_, &ImageServer::received, [this](const QString& name) { received_ << name; });
    QObject::connect(&server_, &ImageServer::dropped, [this](const QString& name) { dropped_ << name; });
    QObject::connect(&server_, &ImageServer::failed, [this](const QString& why) { failed_ << why; });
  }

  std::unique_ptr<QLocalSocket> connect() const {
    auto socket = std::make_unique<QLocalSocket>();
    socket->connectToServer(QString::fromStdString(path_));
    EXPECT_TRUE(socket->waitForConnected());
    return socket;
  }
  static void create(QLocalSocket& socket, const std::string& name, int width, int height) {
    const std::string bytes = display::create_image_packet(name, width, height);
    socket.write(bytes.data(), qint64(bytes.size()));
  }
  /// Waits until the server has the image.
  bool receives(const QString& name) const {
    return QTest::qWaitFor([&] { return received_.contains(name); });
  }
  static bool is_cut_off(const QLocalSocket& socket) {
    return QTest::qWaitFor([&] { return socket.state() == QLocalSocket::UnconnectedState; });
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.path("display");
  ImageServer server_{{.images = 3, .pixels = 1000, .senders = 2}};
  QStringList received_;
  QStringList dropped_;
  QStringList failed_;
};

TEST_F(LocalImageServer, IsForItsUserOnly) {
  struct stat status = {};
  ASSERT_EQ(::stat(path_.c_str(), &status), 0);
  EXPECT_TRUE(S_ISSOCK(status.st_mode));
  EXPECT_EQ(status.st_mode & 0077U, 0U) << "of the group and of others";
  EXPECT_EQ(server_.address().text(), path_);
}

TEST_F(LocalImageServer, LeavesTheSocketOfAnother) {
  ImageServer second;
  EXPECT_FALSE(second.listen({.path = path_}));
  EXPECT_FALSE(second.problem().isEmpty());
  const auto sender = connect();
  create(*sender, "to the first", 1, 1);
  EXPECT_TRUE(receives("to the first"));
}

TEST_F(LocalImageServer, ReplacesTheSocketOfAKilledOne) {
  const std::string left = folder_.path("left");
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  left.copy(static_cast<char*>(address.sun_path), sizeof(address.sun_path) - 1);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  ::close(socket);
  ImageServer second;
  EXPECT_TRUE(second.listen({.path = left})) << second.problem().toStdString();
}

TEST_F(LocalImageServer, RefusesMoreImagesThanItKeeps) {
  const auto sender = connect();
  for (const char* name : {"a", "b", "c"}) create(*sender, name, 1, 1);
  EXPECT_TRUE(receives("c"));
  create(*sender, "b", 2, 2);  // instead of the other
  create(*sender, "d", 1, 1);
  EXPECT_TRUE(is_cut_off(*sender));
  EXPECT_EQ(failed_.size(), 1);
  EXPECT_TRUE(dropped_.isEmpty());
  EXPECT_FALSE(received_.contains("d"));
}

TEST_F(LocalImageServer, RefusesMorePixelsThanItKeeps) {
  const auto sender = connect();
  create(*sender, "half", 20, 25);
  create(*sender, "half too", 25, 20);
  EXPECT_TRUE(receives("half too"));
  create(*sender, "one pixel", 1, 1);
  EXPECT_TRUE(is_cut_off(*sender));
  EXPECT_EQ(failed_.size(), 1);
}

TEST_F(LocalImageServer, DropsTheOldestImagesOfThoseWhoHaveLeft) {
  auto former = connect();
  const auto sender = connect();
  create(*former, "old", 1, 1);
  EXPECT_TRUE(receives("old"));
  create(*sender, "running", 1, 1);
  EXPECT_TRUE(receives("running"));
  create(*former, "newer", 1, 1);
  EXPECT_TRUE(receives("newer"));
  former->disconnectFromServer();
  former = nullptr;
  QTest::qWait(50);
  create(*sender, "new", 1, 1);
  EXPECT_TRUE(receives("new"));
  EXPECT_EQ(dropped_, QStringList("old"));
  create(*sender, "large", 20, 40);
  EXPECT_TRUE(receives("large"));
  EXPECT_EQ(dropped_, QStringList({"old", "newer"}));
  EXPECT_TRUE(failed_.isEmpty());
}

TEST_F(LocalImageServer, TakesAFewSendersAtATime) {
  auto first = connect();
  const auto second = connect();
  EXPECT_TRUE(is_cut_off(*connect()));
  first = nullptr;
  QTest::qWait(50);
  const auto third = connect();
  create(*third, "third", 1, 1);
  EXPECT_TRUE(receives("third"));
}

TEST(ImageWindow, ShowsWhatIsSent) {
  ImageWindow window;
  window.show();
  window.listen({.port = "0"});
  QTcpSocket socket;
  socket.connectToHost("127.0.0.1", port_of(window.server()));
  ASSERT_TRUE(QTest::qWaitFor([&] { return socket.state() == QAbstractSocket::ConnectedState; }));
  const auto send = [&](const std::string& bytes) { socket.write(bytes.data(), qint64(bytes.size())); };
  send(display::close_image_packet("render"));
  send(display::create_image_packet("render", 64, 32));
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.browser().names() == QStringList("render"); }));
  QSignalSpy received(&window.server(), &ImageServer::received);
  // In two parts: a packet may be split anywhere.
  const std::string update =
      display::update_image_packet("render", {62, 30, 2, 2}, std::vector<Colour>(4, Colour(1, 0, 0)));
  send(update.substr(0, 30));
  socket.flush();
  send(update.substr(30));
  ASSERT_TRUE(received.wait());
  const auto image = received.back().at(1).value<SharedImage>();
  EXPECT_EQ(image->at(63, 31), Colour(1, 0, 0));
  EXPECT_EQ(image->at(61, 31), Colour(0));
  send(display::update_image_packet("render", {0, 0, 1, 1}, {Colour(0, 1, 0)}));
  ASSERT_TRUE(received.wait());
  EXPECT_EQ(image->at(0, 0), Colour(0)) << "what was given away stays";
  EXPECT_EQ(received.back().at(1).value<SharedImage>()->at(0, 0), Colour(0, 1, 0));
}

TEST(ImageWindow, CutsOffWhoSendsNoPackets) {
  ImageServer server;
  ASSERT_TRUE(server.listen({.port = "0"}));
  QSignalSpy failed(&server, &ImageServer::failed);
  QTcpSocket socket;
  socket.connectToHost("127.0.0.1", port_of(server));
  socket.write("GET / HTTP/1.1\r\n\r\n");
  ASSERT_TRUE(failed.wait());
  EXPECT_TRUE(QTest::qWaitFor([&] { return socket.state() == QAbstractSocket::UnconnectedState; }));
}

}  // namespace
}  // namespace editor
