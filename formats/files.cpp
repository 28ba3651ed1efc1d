#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>
#include <vector>

#include "formats/formats.h"

namespace toile {
namespace {

[[noreturn]] void cannot_create(const std::filesystem::path& file, const std::string& why) {
  throw BadInput({"file.cannot-create", Severity::error, file.string(), "the file cannot be written: " + why,
                  "choose a folder that exists, may be written to and has room", Fault::cannot_create});
}

// Closes and removes the temporary file unless it has been renamed.
struct Temporary {
  std::string name;
  int descriptor = -1;
  bool kept = false;
  ~Temporary() {
    if (descriptor >= 0) ::close(descriptor);
    if (!kept && !name.empty()) ::unlink(name.c_str());
  }
};

std::string reason(int code) { return std::generic_category().message(code); }

}  // namespace

void write_whole_file(const std::filesystem::path& file, const std::string& bytes) {
  std::error_code ignored;
  if (file.filename().empty()) cannot_create(file, "it has no name");
  if (std::filesystem::is_directory(file, ignored)) cannot_create(file, "there is a folder of that name");
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::string pattern = (folder / ("." + file.filename().string().substr(0, 200) + ".XXXXXX")).string();
  Temporary temporary;
  temporary.descriptor = ::mkstemp(pattern.data());
  if (temporary.descriptor < 0) cannot_create(file, reason(errno));
  temporary.name = pattern;

  for (std::size_t written = 0; written < bytes.size();) {
    const ssize_t more = ::write(temporary.descriptor, bytes.data() + written, bytes.size() - written);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) cannot_create(file, reason(more < 0 ? errno : ENOSPC));
    written += static_cast<std::size_t>(more);
  }
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(temporary.descriptor, 0666 & ~mask) != 0 || ::fsync(temporary.descriptor) != 0)
    cannot_create(file, reason(errno));
  if (::close(std::exchange(temporary.descriptor, -1)) != 0) cannot_create(file, reason(errno));
  if (::rename(temporary.name.c_str(), file.c_str()) != 0) cannot_create(file, reason(errno));
  temporary.kept = true;
}

Loaded<std::string> read_whole_file(const std::filesystem::path& file) {
  Loaded<std::string> loaded;
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    const int code = errno;
    if (code == ENOENT || code == ENOTDIR)
      loaded.report.error("file.missing", file.string(), "there is no such file", "check the name and the folder",
                          Fault::missing);
    else
      loaded.report.error("file.unreadable", file.string(), "the file cannot be read: " + reason(code),
                          "check that you may read it", Fault::missing);
    return loaded;
  }
  std::string bytes;
  std::vector<char> buffer(1 << 16);
  for (;;) {
    const ssize_t more = ::read(descriptor, buffer.data(), buffer.size());
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) {
      const int code = errno;
      loaded.report.error("file.unreadable", file.string(),
                          code == EISDIR ? "this is a folder, not a file" : "the file cannot be read: " + reason(code),
                          "name a file that may be read", Fault::missing);
      break;
    }
    if (more == 0) {
      loaded.value = std::move(bytes);
      break;
    }
    bytes.append(buffer.data(), static_cast<std::size_t>(more));
  }
  ::close(descriptor);
  return loaded;
}

}  // namespace toile
