#pragma once
#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace solitaire {

/// A folder that lives as long as the test.
class Workplace {
 public:
  Workplace();
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  /// Writes a file and returns its path.
  std::string file(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

struct Outcome {
  int status = 0;  // the exit status, or 128 and the signal that ended it
  std::string out, err;
  double cpu_seconds = 0;  // that it computed for, on all of its threads together
};

/// A running command. The first of the arguments is looked for on the PATH.
class Command {
 public:
  explicit Command(const std::vector<std::string>& arguments, bool closed_stdout = false);
  void signal(int number) const;
  /// Waits until the program has, or has no more, a handler of its own for a signal; at most some seconds.
  void wait_for_handler(int signal, bool has_one = true) const;
  /// What it has written to standard output so far.
  std::string output() const;
  Outcome wait();

 private:
  bool has_handler(int signal) const;

  Workplace workplace_;
  pid_t process_ = 0;
};

Outcome run(const std::vector<std::string>& arguments);

/// The program of this project with these arguments.
std::vector<std::string> solitaire_with(std::vector<std::string> arguments);
Outcome run_solitaire(const std::vector<std::string>& arguments);

/// A file's bytes.
std::string bytes_of(const std::filesystem::path& path);

}  // namespace solitaire
