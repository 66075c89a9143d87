#pragma once

#include <QSignalSpy>
#include <QTest>
#include <string>

#include "editor/rendering/final_render.h"
#include "tests/job/preview_helpers.h"
#include "tests/support/temporary_folder.h"

namespace test {

/// Timeout for renders on busy machines, milliseconds.
constexpr int Minute = 60'000;

inline editor::FinalRenderRequest final_request(const QString& path, int samples) {
  editor::FinalRenderRequest request;
  const job::PreviewRequest preview = test::request(scene_of_text(Corner), 96, 72, samples);
  request.scene = preview.scene;
  request.path = path;
  request.options = preview.options;
  return request;
}

}  // namespace test
