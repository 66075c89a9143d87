// Makes the pictures of the editor's manual, or those for a review: opens the real windows on a virtual
// screen and saves screenshots. See editor/screenshots.
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QFileInfo>
#include <cstdlib>
#include <iostream>

#include "editor/appearance/theme.h"
#include "tests/editor/own_application.h"
#include "tests/editor/screenshots/pictures.h"
#include "tests/editor/screenshots/stage.h"

namespace screenshots {
namespace {

/// Scales large pictures down, or crops those at 200 % to their upper right part, so that their text is not
/// scaled.
QImage for_the_manual(const QPixmap& picture) {
  constexpr QSize Largest(1280, 800);
  const QImage image = picture.toImage();
  if (picture.devicePixelRatio() > 1) {
    const QSize size = image.size().boundedTo(Largest);
    return image.copy(QRect(QPoint(image.width() - size.width(), 0), size));
  }
  return image.width() > Largest.width() ? image.scaledToWidth(Largest.width(), Qt::SmoothTransformation)
                                         : image;
}

/// Quantises to 7 bits per channel.
QImage coarser(QImage image) {
  for (int y = 0; y < image.height(); ++y) {
    uchar* line = image.scanLine(y);
    for (int i = 0; i < 3 * image.width(); ++i) {
      line[i] = static_cast<uchar>((line[i] & 0xFE) | (line[i] >> 7));
    }
  }
  return image;
}

void write(const QImage& picture, const QString& file) {
  constexpr int Smallest = 0;  // file: Qt's quality of a PNG is how little it is compressed
  const QImage image = picture.convertToFormat(QImage::Format_RGB888);
  expect(image.save(file, "PNG", Smallest), file + " cannot be written");
  // Render noise makes files large, and hides the loss of one bit.
  constexpr qint64 Large = 400'000;
  if (QFileInfo(file).size() > Large) {
    expect(coarser(image).save(file, "PNG", Smallest), file + " cannot be written");
  }
  std::cout << file.toStdString() << ' ' << image.width() << 'x' << image.height() << std::endl;
}

int make(const QCommandLineParser& parser) {
  const QDir folder(parser.value("to"));
  const QStringList wanted = parser.positionalArguments();
  const auto is_wanted = [&](const QString& name) { return wanted.isEmpty() || wanted.contains(name); };
  const auto path = [&](const QString& name) {
    return folder.filePath(name + parser.value("suffix") + ".png");
  };
  if (parser.isSet("review")) {
    const Take take = [&](const QString& name, const QPixmap& picture) {
      write(picture.toImage(), path(name));
    };
    for (const ReviewGroup& group : review_groups()) {
      if (is_wanted(group.name)) group.make(take);
    }
    return EXIT_SUCCESS;
  }
  for (const Picture& picture : manual_pictures()) {
    if (is_wanted(picture.name)) write(for_the_manual(picture.make()), path(picture.name));
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace screenshots

int main(int argc, char** argv) {
  test::OwnScreen screen;
  const auto application = test::application_on(screen, {3840, 2400}, argc, argv);
  if (application == nullptr) return EXIT_FAILURE;
  QCommandLineParser parser;
  parser.addPositionalArgument("NAME", "The pictures to make, or groups to review; none: all.", "[NAME...]");
  parser.addOptions({{"to", "Folder of the pictures.", "FOLDER", "."},
                     {"suffix", "Added to each name.", "TEXT"},
                     {"review", "Pictures to be looked at, as large as they are."},
                     {"theme", "dark or light.", "NAME", "dark"}});
  parser.process(*application);
  if (parser.value("theme") == "light") editor::apply(editor::Theme::Light, *application);
  try {
    return screenshots::make(parser);
  } catch (const std::exception& error) {
    std::cerr << "make_screenshots: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
