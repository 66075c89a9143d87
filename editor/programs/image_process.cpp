#include "editor/programs/image_process.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <algorithm>
#include <array>
#include <utility>

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

bool read_bytes(QFile& file, void* bytes, std::uint64_t count) {
  return file.read(static_cast<char*>(bytes), static_cast<qint64>(count)) == static_cast<qint64>(count);
}

std::uint64_t bytes_left(const QFile& file) { return static_cast<std::uint64_t>(file.size() - file.pos()); }

/// Parses a layer as `bpt decode --layers` writes it.
std::optional<image::ImageLayer> layer_in(QFile& file, std::uint64_t pixels) {
  constexpr std::uint32_t Longest = 1000;
  std::array<std::uint32_t, 2> lengths = {};
  if (!read_bytes(file, lengths.data(), sizeof(lengths)) || lengths[0] > Longest || lengths[1] > Longest)
    return std::nullopt;
  image::ImageLayer layer{std::string(lengths[0], ' '), std::string(lengths[1], ' '), {}};
  const bool has_names =
      read_bytes(file, layer.name.data(), lengths[0]) && read_bytes(file, layer.channels.data(), lengths[1]);
  const std::uint64_t count = pixels * std::max(1U, lengths[1]);
  if (!has_names || bytes_left(file) / sizeof(float) < count) return std::nullopt;
  layer.values.resize(count);
  if (!read_bytes(file, layer.values.data(), count * sizeof(float))) return std::nullopt;
  return layer;
}

/// Parses an image as `bpt decode` writes it. It is untrusted: a file that exploits the decoder may have had
/// it write anything.
std::optional<image::ImageFile> image_in(QFile& file, bool has_layers) {
  std::array<std::int32_t, 2> size = {};
  if (!file.seek(0) || !read_bytes(file, size.data(), sizeof(size)) || size[0] < 1 || size[1] < 1)
    return std::nullopt;
  const std::uint64_t pixels = static_cast<std::uint64_t>(size[0]) * static_cast<std::uint64_t>(size[1]);
  constexpr std::uint64_t PixelSize = sizeof(grf::Colour);
  const std::uint64_t left = bytes_left(file);
  if (has_layers ? left / PixelSize < pixels : left / PixelSize != pixels || left % PixelSize != 0)
    return std::nullopt;
  image::ImageFile result;
  result.image = {size[0], size[1], std::vector<grf::Colour>(pixels)};
  if (!read_bytes(file, &result.image.pixels.front().x, pixels * PixelSize)) return std::nullopt;
  while (bytes_left(file) > 0) {
    auto layer = layer_in(file, pixels);
    if (!layer) return std::nullopt;
    result.layers.push_back(std::move(*layer));
  }
  return result;
}

}  // namespace

std::optional<image::Image> ImageProcess::read(const std::string& path, grf::Diagnostics& diagnostics,
                                               const grf::SourceLocation& asked_for_at,
                                               const std::stop_token& stop, image::Alpha alpha) const {
  const QString option = alpha == image::Alpha::Kept ? QStringLiteral("--alpha") : QString();
  auto file = read(path, option, diagnostics, asked_for_at, stop);
  if (!file) return std::nullopt;
  const bool has_alpha = !file->layers.empty() && file->layers.front().channels.empty();
  if (has_alpha) file->image.alpha = std::move(file->layers.front().values);
  return std::move(file->image);
}

std::optional<image::ImageFile> ImageProcess::read_file(const std::string& path,
                                                        grf::Diagnostics& diagnostics) const {
  return read(path, QStringLiteral("--layers"), diagnostics, {}, {});
}

std::optional<image::ImageFile> ImageProcess::read(const std::string& path, const QString& option,
                                                   grf::Diagnostics& diagnostics,
                                                   const grf::SourceLocation& asked_for_at,
                                                   const std::stop_token& stop) const {
  Result result = decode(QString::fromStdString(path), option, stop);
  if (result.file || stop.stop_requested()) return std::move(result.file);
  const std::string problem = result.problem.toStdString();
  if (asked_for_at.file) {
    diagnostics.error(asked_for_at, fmt::format("'{}': {}", path, problem));
  } else {
    diagnostics.error(grf::whole_file(path), problem);
  }
  return std::nullopt;
}

ImageProcess::Result ImageProcess::decode(const QString& path, const QString& option,
                                          const std::stop_token& stop) const {
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
  const QStringList options = option.isEmpty() ? QStringList{"decode"} : QStringList{"decode", option};
  process.start(program_, options + QStringList{"--", path});
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
  if (auto file = image_in(output, !option.isEmpty())) return {std::move(file), {}};
  return {{}, tr("cannot read the image: the file is corrupt (its decoder wrote no image)")};
}

}  // namespace editor
