#include "scene/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

#include "scene/error.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int error) {
  throw SceneError(fmt::format("cannot write {}: {}", path.string(), std::generic_category().message(error)));
}

std::string temporary_name(::pid_t process, unsigned number) {
  return fmt::format(".solitaire-{}-{}.part", process, number);
}

/// Returns the process that has named a temporary file, or 0 if this is not such a name.
::pid_t process_of(const std::string& name) {
  ::pid_t process = 0;
  unsigned number = 0;
  if (std::sscanf(name.c_str(), ".solitaire-%d-%u", &process, &number) != 2 || process <= 0) return 0;
  return name == temporary_name(process, number) ? process : 0;
}

/// Returns true if no process can be at work on the file. Its number may be that of a process on another
/// machine or in another container which shares the folder, so a file that was written to just now is left
/// alone.
bool is_abandoned(const fs::directory_entry& file) {
  constexpr std::chrono::minutes kAtWork(1);
  const ::pid_t process = process_of(file.path().filename().string());
  if (process == 0 || fs::symlink_status(file).type() != fs::file_type::regular) return false;
  const bool ended = ::kill(process, 0) != 0 && errno == ESRCH;
  return ended && fs::file_time_type::clock::now() - file.last_write_time() > kAtWork;
}

/// An open file. close() returns true if everything has reached it.
class Output {
 public:
  Output(const fs::path& path, int flags)
      : descriptor_(::open(path.c_str(), flags | O_WRONLY | O_CLOEXEC, 0666)) {}
  ~Output() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  bool is_open() const { return descriptor_ >= 0; }

  bool write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }

  bool close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

 private:
  int descriptor_;
};

/// A file that removes itself unless it was given its final name.
class Temporary {
 public:
  explicit Temporary(const fs::path& beside) : path_(beside.parent_path() / unused_name()) {}
  ~Temporary() {
    std::error_code ignored;
    if (!kept_) fs::remove(path_, ignored);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  const fs::path& path() const { return path_; }

  bool rename_to(const fs::path& name) {
    kept_ = ::rename(path_.c_str(), name.c_str()) == 0;
    return kept_;
  }

 private:
  static std::string unused_name() {
    static std::atomic<unsigned> count = 0;
    return temporary_name(::getpid(), ++count);
  }

  fs::path path_;
  bool kept_ = false;
};

void write_directly(const fs::path& path, std::string_view bytes) {
  Output output(path, 0);
  if (!output.is_open() || !output.write(bytes) || !output.close()) fail(path, errno);
}

}  // namespace

void write_file_atomically(const fs::path& path, std::string_view bytes,
                           const std::function<void(const fs::path&)>& check) {
  std::error_code unknown;
  const fs::file_type type = fs::status(path, unknown).type();
  if (type == fs::file_type::directory) fail(path, EISDIR);
  const bool is_file =
      type == fs::file_type::regular || type == fs::file_type::not_found || type == fs::file_type::none;
  // /dev/stdout is a link to where the output goes, which can be a file.
  if (!is_file || path.lexically_normal().parent_path() == "/dev") return write_directly(path, bytes);

  Temporary temporary(path);
  Output output(temporary.path(), O_CREAT | O_TRUNC | O_NOFOLLOW);
  if (!output.is_open() || !output.write(bytes) || !output.close()) fail(path, errno);
  if (check) check(temporary.path());
  if (!temporary.rename_to(path)) fail(path, errno);  // of a link, the link itself
}

void remove_abandoned_files(const fs::path& folder) {
  try {
    std::vector<fs::path> abandoned;
    for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
      if (is_abandoned(file)) abandoned.push_back(file.path());
    }
    for (const fs::path& file : abandoned) fs::remove(file);
  } catch (const fs::filesystem_error&) {  // it is gone already, or not ours to remove
  }
}

}  // namespace solitaire
