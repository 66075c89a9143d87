#include "editor/programs/image_process.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <utility>

#include <fmt/format.h>
#include <sys/mman.h>

#include "editor/programs/child_process.h"
#include "renderer/image/decoded_image.h"

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

std::optional<image::ImageFile> image_in(QFile& file, bool has_layers) {
  const auto size = static_cast<std::size_t>(file.size());
  const uchar* bytes = size > 0 ? file.map(0, file.size()) : nullptr;
  if (bytes == nullptr) return std::nullopt;
  return image::decoded_image({reinterpret_cast<const char*>(bytes), size}, has_layers);
}

}  // namespace

std::optional<image::Image> ImageProcess::read(const std::string& path, grf::Diagnostics& diagnostics,
                                               const grf::SourceLocation& asked_for_at,
                                               const std::stop_token& stop, image::Alpha alpha) const {
  const QString option = alpha == image::Alpha::Kept ? QStringLiteral("--alpha") : QString();
  auto file = read(path, option, diagnostics, asked_for_at, stop);
  return file ? std::optional(image::with_alpha_of_layer(std::move(*file))) : std::nullopt;
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
