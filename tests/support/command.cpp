#include "tests/support/command.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace solitaire {

namespace fs = std::filesystem;

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

}  // namespace

Workplace::Workplace() {
  std::string name = (fs::temp_directory_path() / "solitaire-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

Workplace::~Workplace() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string Workplace::file(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return (path_ / name).string();
}

std::string bytes_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Command::Command(const std::vector<std::string>& arguments, bool closed_stdout) {
  const std::string out = workplace_ / "out", err = workplace_ / "err";
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  process_ = fork();
  if (process_ != 0) return;
  constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
  dup2(open(out.c_str(), kWrite, 0600), STDOUT_FILENO);
  dup2(open(err.c_str(), kWrite, 0600), STDERR_FILENO);
  if (closed_stdout) {  // a pipe that nobody reads
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) _exit(126);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
  }
  execvp(pointers[0], pointers.data());
  _exit(127);
}

void Command::signal(int number) const { kill(process_, number); }

/// The kernel tells in hexadecimal for which signals there are handlers, the lowest bit for signal 1.
bool Command::has_handler(int signal) const {
  const std::string status = bytes_of(fs::path("/proc") / std::to_string(process_) / "status");
  const std::string caught = "SigCgt:";
  const std::size_t line = status.find(caught);
  if (line == std::string::npos) return false;
  return (std::stoull(status.substr(line + caught.size()), nullptr, 16) >> (signal - 1) & 1) != 0;
}

void Command::wait_for_handler(int signal, bool has_one) const {
  for (int i = 0; i < 1000 && has_handler(signal) != has_one; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

std::string Command::output() const { return bytes_of(workplace_ / "out"); }

Outcome Command::wait() {
  int status = 0;
  rusage usage{};
  wait4(process_, &status, 0, &usage);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), output(),
          bytes_of(workplace_ / "err"), seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

Outcome run(const std::vector<std::string>& arguments) { return Command(arguments).wait(); }

std::vector<std::string> solitaire_with(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), SOLITAIRE_PROGRAM);
  return arguments;
}

Outcome run_solitaire(const std::vector<std::string>& arguments) { return run(solitaire_with(arguments)); }

}  // namespace solitaire
