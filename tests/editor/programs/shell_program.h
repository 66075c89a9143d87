#pragma once

#include <QString>
#include <filesystem>
#include <string>

#include "tests/support/temporary_folder.h"

namespace test {

/// Creates a program from a shell script, in place of one that the editor runs, and returns its path.
inline QString shell_program(const TemporaryFolder& folder, const std::string& script) {
  const std::string path = folder.add("program", "#!/bin/sh\n" + script + "\n");
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return QString::fromStdString(path);
}

}  // namespace test
