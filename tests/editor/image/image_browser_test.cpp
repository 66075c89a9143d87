// Tests of the image view by a window, files, keys and the mouse.
#include "editor/image/image_browser.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QtConcurrent>
#include <cmath>
#include <ctime>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "editor/controls/number_box.h"
#include "editor/image/screen_controls.h"
#include "renderer/image/image_file.h"
#include "tests/editor/pointer.h"
#include "tests/support/sanitizers.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using grf::Colour;
using image::Image;

/// An image whose pixels encode their position.
Image ramp(int width, int height, float blue = 0) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.pixels.emplace_back(float(x) / float(width), float(y) / float(height), blue);
    }
  }
  return image;
}

SharedImage shared(Image image) { return std::make_shared<const Image>(std::move(image)); }

class Browser : public testing::Test {
 protected:
  Browser() {
    browser_.resize(900, 640);
    browser_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&browser_));
    QApplication::setActiveWindow(&browser_);  // there is no window manager that would
  }

  std::string write(const std::string& name, const Image& image) {
    grf::Diagnostics diagnostics;
    std::string path = folder_.path(name);
    EXPECT_TRUE(image::write_image({image}, path, diagnostics)) << diagnostics.to_text();
    return path;
  }

  void open(const std::string& path) {
    QSignalSpy opened(&browser_, &ImageBrowser::opened);
    browser_.open_files({QString::fromStdString(path)});
    ASSERT_TRUE(opened.wait());
  }

  QString text(const char* accessible_name) {
    for (const QLabel* label : browser_.findChildren<QLabel*>()) {
      if (label->accessibleName() == accessible_name) return label->text();
    }
    ADD_FAILURE() << accessible_name;
    return {};
  }

  QRgb shown(const QPoint& pixel) {
    const QImage view = browser_.pane().grab().toImage();
    return view.pixel((browser_.pane().place_of(pixel) * view.devicePixelRatio()).toPoint());
  }

  void key(int key, Qt::KeyboardModifiers modifiers = {}) {
    browser_.pane().setFocus();
    QTest::keyClick(&browser_.pane(), Qt::Key(key), modifiers);
  }

  test::TemporaryFolder folder_;
  ImageBrowser browser_;
};

TEST_F(Browser, OpensEveryTypeOfFile) {
  for (const char* name : {"a.exr", "a.hdr", "a.pfm", "a.raw", "a.png", "a.jpg", "a.tga"}) {
    open(write(name, ramp(40, 30)));
    EXPECT_EQ(browser_.names().back(), name);
  }
  EXPECT_EQ(browser_.names().size(), 7);
  open(write("a.exr", ramp(20, 30)));
  EXPECT_EQ(browser_.names().size(), 7) << "the same file again";
}

TEST_F(Browser, HasOneEntryForAFileAndWhatIsSentOfIt) {
  const std::string path = write("a.exr", ramp(40, 30));
  const QString sent = QString::fromStdString(path);
  browser_.show_image_of(sent, shared(ramp(40, 30)));
  open(path);
  browser_.show_image_of(sent, shared(ramp(40, 30)));
  EXPECT_EQ(browser_.names(), QStringList("a.exr"));
  folder_.add("other/a.exr", "");
  open(write("other/a.exr", ramp(40, 30)));
  EXPECT_EQ(browser_.names(), QStringList({"a.exr", QString::fromStdString(folder_.path("other/a.exr"))}));
}

TEST_F(Browser, SaysWhatIsWrongWithAFile) {
  QSignalSpy reported(&browser_, &ImageBrowser::reported);
  browser_.open_files({QString::fromStdString(folder_.add("broken.exr", "no image"))});
  ASSERT_TRUE(reported.wait());
  EXPECT_TRUE(browser_.names().isEmpty());
  bool says_so = false;
  for (const QLabel* label : browser_.findChildren<QLabel*>()) {
    says_so |= label->isVisible() && label->text().contains("broken.exr: error:");
  }
  EXPECT_TRUE(says_so);
}

TEST_F(Browser, OpensWhatIsDropped) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString(write("a.exr", ramp(4, 4))))});
  QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(&browser_, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QSignalSpy opened(&browser_, &ImageBrowser::opened);
  QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(&browser_, &drop);
  EXPECT_TRUE(opened.wait());
}

TEST_F(Browser, TellsPixelsUnderThePointer) {
  browser_.show_image("ramp", shared(ramp(64, 32, 0.5F)));
  const QPoint place = browser_.pane().place_of({16, 8}).toPoint();
  test::move_pointer(browser_.pane(), place);
  ASSERT_TRUE(QTest::qWaitFor([this] { return text("Values of the pixel").contains("x 16"); }));
  EXPECT_TRUE(text("Values of the pixel").startsWith("x 16  y 8   R 0.25  G 0.25  B 0.5"))
      << text("Values of the pixel").toStdString();
}

TEST_F(Browser, ZoomsAboutThePointer) {
  browser_.show_image("ramp", shared(ramp(1000, 700)));
  ImagePane& pane = browser_.pane();
  const QPointF place = pane.place_of({250, 300});
  const double before = pane.zoom();
  QWheelEvent wheel(place, pane.mapToGlobal(place), {}, QPoint(0, 480), {}, {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&pane, &wheel);
  EXPECT_NEAR(pane.zoom(), 4 * before, 1e-9);
  EXPECT_LT((pane.place_of({250, 300}) - place).manhattanLength(), 2 * pane.zoom());
  key(Qt::Key_1);
  EXPECT_NEAR(pane.zoom(), 1, 1e-9);
  const QPointF corner = pane.place_of({0, 0});
  key(Qt::Key_Left);
  EXPECT_GT(pane.place_of({0, 0}).x(), corner.x());
  key(Qt::Key_0);
  EXPECT_NEAR(pane.zoom(), before, 1e-9);
}

TEST_F(Browser, DrawsEachPixelWhereItIs) {
  Image image{8, 4, std::vector<Colour>(32, Colour(0))};
  image.pixels[3 * 8 + 5] = Colour(0.2158605F);
  browser_.show_image("dot", shared(image));
  EXPECT_EQ(shown({5, 3}), qRgb(128, 128, 128));
  EXPECT_EQ(shown({4, 3}), qRgb(0, 0, 0));
  EXPECT_EQ(shown({5, 2}), qRgb(0, 0, 0));
  for (int i = 0; i < 4; ++i) key(Qt::Key_E);
  EXPECT_EQ(shown({5, 3}), qRgb(239, 239, 239)) << "two stops";
  for (int i = 0; i < 4; ++i) key(Qt::Key_E, Qt::ShiftModifier);
  EXPECT_EQ(shown({5, 3}), qRgb(128, 128, 128));
  image.pixels[0] = Colour(std::numeric_limits<float>::quiet_NaN());
  browser_.show_image("dot", shared(image));
  EXPECT_EQ(shown({0, 0}), NanColour);
  ASSERT_TRUE(QTest::qWaitFor([this] { return text("Image statistics").contains("1 NaN"); }));
}

TEST_F(Browser, ComparesByWipeFlipAndSide) {
  browser_.show_image("red", shared({64, 64, std::vector<Colour>(4096, Colour(1, 0, 0))}));
  browser_.show_image("blue", shared({64, 64, std::vector<Colour>(4096, Colour(0, 0, 1))}));
  browser_.select_reference("red");
  ImagePane& pane = browser_.pane();
  ASSERT_EQ(pane.arrangement(), Arrangement::Wipe);
  EXPECT_EQ(shown({10, 40}), qRgb(0, 0, 255));
  EXPECT_EQ(shown({54, 40}), qRgb(255, 0, 0));
  const QPoint line(pane.width() / 2, pane.height() / 2 + 40);
  QTest::mousePress(&pane, Qt::LeftButton, {}, line);
  QTest::mouseMove(&pane, QPoint(pane.width() - 4, line.y()));
  QTest::mouseRelease(&pane, Qt::LeftButton, {}, QPoint(pane.width() - 4, line.y()));
  ASSERT_TRUE(QTest::qWaitFor([&] { return pane.wipe() > 0.95; }));
  EXPECT_EQ(shown({54, 40}), qRgb(0, 0, 255));
  key(Qt::Key_Space);
  EXPECT_EQ(shown({54, 40}), qRgb(255, 0, 0));
  key(Qt::Key_Space);
  browser_.set_comparison(Comparison::SideBySide);
  EXPECT_EQ(shown({54, 40}), qRgb(0, 0, 255));
  const QImage view = pane.grab().toImage();
  EXPECT_EQ(view.pixel(view.width() * 3 / 4, view.height() / 2 + 40), qRgb(255, 0, 0));
  key(Qt::Key_X);
  EXPECT_EQ(shown({54, 40}), qRgb(255, 0, 0));
}

TEST_F(Browser, SaysHowFarImagesAreApart) {
  const Image a = ramp(64, 48);
  Image b = a;
  for (Colour& pixel : b.pixels) pixel += Colour(0.125F);
  browser_.show_image("b", shared(b));
  browser_.show_image("a", shared(a));
  browser_.select_reference("b");
  ASSERT_TRUE(QTest::qWaitFor([this] { return text("Image statistics").contains("RMSE"); }));
  const image::ImageError expected = image::error_of(a, b);
  const QString statistics = text("Image statistics");
  EXPECT_TRUE(statistics.contains("RMSE 0.125")) << statistics.toStdString();
  EXPECT_TRUE(statistics.contains("relMSE " + QString::number(expected.relmse, 'g', 4)))
      << statistics.toStdString();
  EXPECT_TRUE(statistics.contains("PSNR " + QString::number(*expected.psnr, 'f', 1)))
      << statistics.toStdString();
  browser_.set_comparison(Comparison::Absolute);
  EXPECT_TRUE(QTest::qWaitFor([this] { return shown({10, 10}) == qRgb(99, 99, 99); }));
  browser_.set_comparison(Comparison::Signed);
  const auto is_blue = [this] { return qBlue(shown({10, 10})) > qRed(shown({10, 10})); };
  EXPECT_TRUE(QTest::qWaitFor(is_blue)) << "a is below b";
}

TEST_F(Browser, RefusesDifferencesOfOtherSizes) {
  browser_.show_image("b", shared(ramp(32, 48)));
  browser_.show_image("a", shared(ramp(64, 48)));
  browser_.select_reference("b");
  browser_.set_comparison(Comparison::Signed);
  EXPECT_TRUE(QTest::qWaitFor([this] { return text("Image statistics").contains("of the same size"); }));
  EXPECT_FALSE(browser_.pane().grab().isNull());
  browser_.remove_image("b");
  browser_.remove_image("a");
  EXPECT_TRUE(browser_.names().isEmpty());
}

/// 2 x 1 pixels with layers.
image::ImageFile layered(float far = 4) {
  image::ImageFile file{{2, 1, {Colour(1, 0, 0), Colour(0, 1, 0)}}};
  file.layers = {{"albedo", "RGB", {1, 0, 0, 0, 0, 1}},
                 {"depth", "Z", {2, far}},
                 {"normal", "XYZ", {0, 0, 1, 0, -1, 0}},
                 {"samples", "", {16, 32}},
                 {"variance", "RGB", {0.001F, 0.001F, 0.001F, 1, 1, 1}}};
  return file;
}

/// The byte of half the range in sRGB.
constexpr int Half = 188;

class LayersOfImages : public Browser {
 protected:
  void open_layers(const std::string& name, const image::ImageFile& file) {
    grf::Diagnostics diagnostics;
    ASSERT_TRUE(image::write_image(file, folder_.path(name), diagnostics)) << diagnostics.to_text();
    open(folder_.path(name));
  }
  QComboBox& layers() {
    for (auto* list : browser_.findChildren<QComboBox*>()) {
      if (list->accessibleName() == "Layer") return *list;
    }
    throw std::runtime_error("there is no list of layers");
  }
  bool shows(QRgb left, QRgb right) {
    return QTest::qWaitFor([&] { return shown({0, 0}) == left && shown({1, 0}) == right; });
  }
  QString text_at(const QPoint& pixel) {
    const QPointF place = browser_.pane().place_of(pixel);
    test::move_pointer(browser_.pane(), place);
    const QString start = QString("x %1  y %2   ").arg(pixel.x()).arg(pixel.y());
    EXPECT_TRUE(text("Values of the pixel").startsWith(start));
    return text("Values of the pixel").mid(start.size());
  }
};

TEST_F(LayersOfImages, AreShownAtTheirOwnScalesByKeys) {
  open_layers("a.exr", layered());
  ASSERT_EQ(layers().count(), 6);
  EXPECT_TRUE(shows(qRgb(255, 0, 0), qRgb(0, 255, 0))) << "the image";
  key(Qt::Key_L);
  EXPECT_EQ(layers().currentText(), "albedo");
  EXPECT_TRUE(shows(qRgb(255, 0, 0), qRgb(0, 0, 255)));
  EXPECT_EQ(text_at({1, 0}), "R 0  G 0  B 1");
  key(Qt::Key_L);
  EXPECT_EQ(layers().currentText(), "depth");
  EXPECT_TRUE(shows(qRgb(0, 0, 0), qRgb(255, 255, 255))) << "the least and the largest one";
  EXPECT_EQ(text_at({1, 0}), "depth 4");
  EXPECT_TRUE(text("Image statistics").contains("from 2 to 4")) << text("Image statistics").toStdString();
  key(Qt::Key_L);
  EXPECT_TRUE(shows(qRgb(Half, Half, 255), qRgb(Half, 0, Half))) << "-1 is black, 0 in the middle";
  EXPECT_EQ(text_at({1, 0}), "X 0  Y -1  Z 0");
  key(Qt::Key_L);
  EXPECT_TRUE(shows(qRgb(Half, Half, Half), qRgb(255, 255, 255))) << "16 of 32 samples";
  key(Qt::Key_L);
  EXPECT_EQ(layers().currentText(), "variance");
  EXPECT_EQ(browser_.pane().settings().colouring, Colouring::FalseColour);
  key(Qt::Key_L);
  EXPECT_TRUE(shows(qRgb(255, 0, 0), qRgb(0, 255, 0))) << "the image again, in its own colours";
  key(Qt::Key_L, Qt::ShiftModifier);
  EXPECT_EQ(layers().currentText(), "variance");
}

TEST_F(LayersOfImages, KeepTheirExposures) {
  open_layers("a.exr", layered());
  browser_.select_layer("samples");
  EXPECT_TRUE(shows(qRgb(Half, Half, Half), qRgb(255, 255, 255)));
  for (int i = 0; i < 2; ++i) key(Qt::Key_E, Qt::ShiftModifier);
  EXPECT_TRUE(shows(qRgb(137, 137, 137), qRgb(Half, Half, Half))) << "a quarter and a half";
  browser_.select_layer({});
  EXPECT_EQ(browser_.controls().settings().exposure, 0);
  browser_.select_layer("samples");
  EXPECT_EQ(browser_.controls().settings().exposure, -1);
}

TEST_F(LayersOfImages, AreComparedWithTheSameLayer) {
  open_layers("b.exr", layered(6));
  open_layers("a.exr", layered());
  browser_.select_reference("b.exr");
  browser_.select_layer("depth");
  ASSERT_TRUE(QTest::qWaitFor([this] { return text("Image statistics").contains("RMSE"); }));
  EXPECT_EQ(text_at({1, 0}), "depth 4   B: depth 6");
  browser_.show_image("plain", shared(ramp(2, 1)));
  browser_.select_image("a.exr");
  browser_.select_reference("plain");
  ASSERT_TRUE(QTest::qWaitFor([this] { return text("Image statistics").contains("B has no layer depth"); }));
  EXPECT_EQ(browser_.pane().arrangement(), Arrangement::Alone);
  browser_.select_image("plain");
  EXPECT_EQ(layers().currentText(), "image") << "that image has no layers";
}

TEST_F(LayersOfImages, AreSavedWithTheImageOrAsOne) {
  open_layers("a.exr", layered());
  QSignalSpy saved(&browser_, &ImageBrowser::saved);
  browser_.save_as(QString::fromStdString(folder_.path("whole.exr")));
  ASSERT_TRUE(saved.wait());
  grf::Diagnostics diagnostics;
  EXPECT_EQ(image::read_image_file(folder_.path("whole.exr"), diagnostics)->layers.size(), 5U);
  browser_.select_layer("depth");
  browser_.save_as(QString::fromStdString(folder_.path("depth.pfm")));
  ASSERT_TRUE(saved.wait());
  EXPECT_EQ(image::read_image(folder_.path("depth.pfm"), diagnostics)->pixels,
            (std::vector<Colour>{Colour(2), Colour(4)}));
  ASSERT_TRUE(shows(qRgb(0, 0, 0), qRgb(255, 255, 255)));
  browser_.save_as(QString::fromStdString(folder_.path("depth.png")));
  ASSERT_TRUE(saved.wait());
  EXPECT_EQ(image::read_image(folder_.path("depth.png"), diagnostics)->pixels,
            (std::vector<Colour>{Colour(0), Colour(1)}))
      << "as it is shown";
}

TEST_F(Browser, TakesTheExposureAsArithmetic) {
  const ScreenControls& controls = browser_.controls();
  auto* box = controls.findChild<NumberBox*>();
  auto* slider = controls.findChild<QSlider*>();
  ASSERT_TRUE(box != nullptr && slider != nullptr);
  EXPECT_EQ(box->accessibleName(), "Exposure in stops");
  auto* line = box->findChild<QLineEdit*>();
  line->setText("-3/2");
  box->commit();
  EXPECT_EQ(controls.settings().exposure, -1.5F);
  EXPECT_EQ(slider->value(), -15);
  QTest::keyClick(box, Qt::Key_Up);
  EXPECT_EQ(controls.settings().exposure, -1) << "at once";
  slider->setValue(3);
  EXPECT_EQ(line->text(), "0.3");
  line->setText("17");
  box->commit();
  EXPECT_EQ(controls.settings().exposure, 0.3F) << "the last number, since that one is out of range";
}

TEST_F(Browser, SavesAndCopies) {
  browser_.show_image("a", shared(ramp(16, 12)));
  browser_.controls().set_exposure(1);
  QSignalSpy saved(&browser_, &ImageBrowser::saved);
  const std::string path = folder_.path("out.exr");
  browser_.save_as(QString::fromStdString(path));
  ASSERT_TRUE(saved.wait());
  grf::Diagnostics diagnostics;
  const auto written = image::read_image(path, diagnostics);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->pixels, ramp(16, 12).pixels) << "linear, whatever the exposure";
  browser_.copy();
  const QImage copied = QApplication::clipboard()->image();
  ASSERT_EQ(copied.size(), QSize(16, 12));
  EXPECT_EQ(copied.pixel(4, 3), ScreenColours({.exposure = 1})(Colour(0.25F, 0.25F, 0)));
}

TEST(ImageSelection, KeepsTheTwoImagesApart) {
  ImageSelection images;
  for (const char* name : {"a", "b", "c"}) images.put({name, {}, shared(ramp(2, 2))}, false);
  EXPECT_EQ(images.image().name, "c") << "a new one is shown";
  images.put({"a", {}, shared(ramp(3, 2))}, false);
  EXPECT_EQ(images.image().name, "c") << "a new state of another one is not";
  images.select_reference("a");
  EXPECT_EQ(images.reference().image->width, 3);
  images.select("a");
  EXPECT_EQ(images.image().name + images.reference().name, "ac") << "exchanged";
  images.select_reference("a");
  EXPECT_EQ(images.image().name + images.reference().name, "ca");
  images.put({"a", {}, shared(ramp(4, 2))}, true);
  EXPECT_EQ(images.image().name + images.reference().name, "ca") << "the reference is shown already";
  images.remove("c");
  EXPECT_EQ(images.image().name, "b");
  images.select_reference("none");
  EXPECT_EQ(images.reference().name, "a");
  images.select_reference({});
  EXPECT_EQ(images.reference().image, nullptr);
  images.swap();
  EXPECT_EQ(images.image().name, "b") << "there is nothing to exchange it with";
  images.remove("a");
  images.remove("b");
  EXPECT_EQ(images.image().image, nullptr);
}

/// The least processor time of several calls, in seconds, without other processes.
template <typename Function>
double least_time(const Function& function) {
  std::clock_t best = std::numeric_limits<std::clock_t>::max();
  for (int i = 0; i < 9; ++i) {
    const std::clock_t start = std::clock();
    function(i);
    best = std::min(best, std::clock() - start);
  }
  return static_cast<double>(best) / CLOCKS_PER_SEC;
}

// The time is relative to that of the formula for each value, since machines differ.
TEST(ScreenColoursSpeed, ChangesTheExposureOfALargeImageAtOnce) {
  const Image image = ramp(1920, 1080);
  const double table = least_time([&](int i) {
    const ScreenColours colours({.exposure = 0.25F * static_cast<float>(i)});
    const QImage converted = colours.convert(image, QRect(0, 0, 1920, 1080));
    EXPECT_EQ(converted.pixel(960, 540), colours(Colour(0.5F, 0.5F, 0)));
  });
  // On as many threads, since two on one core take more processor time than one.
  std::vector<double> rows(static_cast<std::size_t>(image.height));
  const double formula = least_time([&](int) {
    QtConcurrent::blockingMap(rows, [&](double& sum) {
      const Colour* row = &image.at(0, static_cast<int>(&sum - rows.data()));
      sum = 0;
      for (const Colour* pixel = row; pixel < row + image.width; ++pixel) {
        sum += std::pow(pixel->x, 1 / 2.4) + std::pow(pixel->y, 1 / 2.4) + std::pow(pixel->z + 0.5F, 1 / 2.4);
      }
    });
  });
  EXPECT_GT(rows.back(), 0);
  RecordProperty("share", std::to_string(table / formula));
  // Sanitizers slow down memory accesses more than arithmetic.
  EXPECT_LT(table, (test::HasSanitizers ? 4 : 0.6) * formula);
}

}  // namespace
}  // namespace editor
