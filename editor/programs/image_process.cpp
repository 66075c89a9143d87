#include "editor/programs/image_process.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <array>

#include <fmt/format.h>
#include <sys/mman.h>

#include "editor/programs/child_process.h"

namespace editor {
namespace {

/// Opens an in-memory file: a child writes to it at full speed, and it is read after the child ends.
bool open_memory(QFile& file) {
  const int descriptor = ::memfd_create("image", MFD_CLOEXEC);
  return descriptor >= 0 && file.open(descriptor, QIODevice::ReadWrite, QFile::AutoCloseHandle);
}

QString first_line_in(QFile& file) {
  constexpr qint64 Longest = 1000;
  return file.seek(0) ? QString::fromUtf8(file.readLine(Longest)).trimmed() : QString();
}

/// Parses an image as `bpt decode` writes it. It is untrusted: a file that exploits the decoder may have had
/// it write anything.
std::optional<transport::Image> image_in(QFile& file) {
  std::array<std::int32_t, 2> size = {};
  const auto read = [&file](void* bytes, std::size_t count) {
    return file.read(static_cast<char*>(bytes), static_cast<qint64>(count)) == static_cast<qint64>(count);
  };
  if (!file.seek(0) || !read(size.data(), sizeof(size)) || size[0] < 1 || size[1] < 1) return std::nullopt;
  const std::uint64_t bytes = static_cast<std::uint64_t>(file.size()) - sizeof(size);
  const std::uint64_t pixels = static_cast<std::uint64_t>(size[0]) * static_cast<std::uint64_t>(size[1]);
  constexpr std::uint64_t PixelSize = sizeof(reflectance::Rgb);
  if (bytes / PixelSize != pixels || bytes % PixelSize != 0) return std::nullopt;
  transport::Image image{size[0], size[1], std::vector<reflectance::Rgb>(pixels)};
  if (!read(&image.pixels.front().x, bytes)) return std::nullopt;
  return image;
}

}  // namespace

std::optional<transport::Image> ImageProcess::read(const std::string& path, grf::Diagnostics& diagnostics,
                                                   const grf::SourceLocation& asked_for_at,
                                                   const std::stop_token& stop) const {
  Result result = decode(QString::fromStdString(path), stop);
  if (result.image || stop.stop_requested()) return std::move(result.image);
  const std::string problem = result.problem.toStdString();
  if (asked_for_at.file) {
    diagnostics.error(asked_for_at, fmt::format("'{}': {}", path, problem));
  } else {
    diagnostics.error(grf::whole_file(path), problem);
  }
  return std::nullopt;
}

ImageProcess::Result ImageProcess::decode(const QString& path, const std::stop_token& stop) const {
  if (program_.isEmpty()) return {{}, tr("cannot read the image: cannot find the program bpt")};
  QFile output;
  QFile errors;
  if (!open_memory(output) || !open_memory(errors)) return {{}, tr("cannot read the image: out of memory")};
  ChildSettings settings;
  settings.memory = limits_.memory;
  settings.output = output.handle();
  settings.errors = errors.handle();
  ChildProcess process(settings);
  std::optional<ChildEnd> end;
  QObject::connect(&process, &ChildProcess::ended, [&](const ChildEnd& ended) { end = ended; });
  QElapsedTimer clock;
  clock.start();
  process.start(program_, {"decode", "--", path});
  while (!end && !process.wait(20)) {
    const bool is_late = static_cast<double>(clock.elapsed()) > 1000 * limits_.seconds;
    if (!stop.stop_requested() && !is_late) continue;
    process.kill();
    return {{}, tr("cannot read the image: decoding takes longer than %1 s").arg(limits_.seconds)};
  }
  if (end->cause == ChildEnd::Cause::NotStarted)
    return {{}, tr("cannot read the image: cannot start the program bpt: %1").arg(end->why)};
  if (end->cause != ChildEnd::Cause::Returned)
    return {{}, tr("cannot read the image: the file is corrupt (its decoder crashed)")};
  if (end->code != 0) return {{}, first_line_in(errors)};
  if (auto image = image_in(output)) return {std::move(image), {}};
  return {{}, tr("cannot read the image: the file is corrupt (its decoder wrote no image)")};
}

}  // namespace editor
