// The image window shows what programs send to its server.
#include "editor/image/image_window.h"

#include <QSignalSpy>
#include <QTcpSocket>
#include <QTest>
#include <vector>

#include <gtest/gtest.h>

#include "editor/image/image_browser.h"
#include "renderer/display/packets.h"

namespace editor {
namespace {

using grf::Colour;

TEST(ImageWindow, ShowsWhatIsSent) {
  ImageWindow window;
  window.show();
  window.listen(0);
  ASSERT_GT(window.server().port(), 0);
  QTcpSocket socket;
  socket.connectToHost("127.0.0.1", window.server().port());
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
  ASSERT_TRUE(server.listen(0));
  QSignalSpy failed(&server, &ImageServer::failed);
  QTcpSocket socket;
  socket.connectToHost("127.0.0.1", server.port());
  socket.write("GET / HTTP/1.1\r\n\r\n");
  ASSERT_TRUE(failed.wait());
  EXPECT_TRUE(QTest::qWaitFor([&] { return socket.state() == QAbstractSocket::UnconnectedState; }));
}

}  // namespace
}  // namespace editor
