// Whole files or none.
#include <chrono>
#include <csignal>
#include <sys/resource.h>

#include "scene/atomic_file.h"
#include "tests/scene/fixture.h"

namespace solitaire {

TEST_CASE("scene: a failed write leaves what was there and nothing else") {
  TemporaryFolder folder;
  write_file(folder / "a", "before");
  SUBCASE("no room") {  // a limit on the size of files acts like a full disk
    rlimit old{};
    getrlimit(RLIMIT_FSIZE, &old);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{1000, old.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string error = error_of([&] { write_file_atomically(folder / "a", std::string(5000, 'x')); });
    setrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, old_handler);
    CHECK(error.find((folder / "a").string()) != std::string::npos);
  }
  SUBCASE("the check refuses it") {
    CHECK_THROWS_AS(write_file_atomically(folder / "a", "x", [](const fs::path&) { throw SceneError("no"); }),
                    SceneError);
  }
  SUBCASE("the name is a folder's") {
    fs::create_directory(folder / "d");
    CHECK(error_of([&] { write_file_atomically(folder / "d", "x"); }).find("directory") != std::string::npos);
    fs::remove(folder / "d");
  }
  SUBCASE("there is no such folder") {
    CHECK(error_of([&] { write_file_atomically(folder / "b/c", "x"); }) != "");
  }
  CHECK(read_file(folder / "a") == "before");
  CHECK(folder.entries() == 1);
}

TEST_CASE("scene: temporary files of processes that ended are removed, and nothing else") {
  TemporaryFolder folder;
  const auto make = [&](const std::string& name, std::chrono::seconds age) {
    write_file(folder / name, "x");
    fs::last_write_time(folder / name, fs::file_time_type::clock::now() - age);
  };
  constexpr std::chrono::hours kOld(1);
  constexpr const char* kNobody = "2147483646";                    // no process can have this number
  const std::vector<std::string> others = {".solitaire-1-1.part",  // of a process that lives
                                           fmt::format(".solitaire-{}-1.part.txt", kNobody),
                                           fmt::format(".solitaire-{}-01.part", kNobody),
                                           fmt::format("solitaire-{}-1.part", kNobody),
                                           ".solitaire--5-1.part",
                                           ".solitaire-0-1.part",
                                           ".solitaire-x-1.part",
                                           "scene-0001.glb"};
  for (const std::string& name : others) make(name, kOld);
  const std::string recent = fmt::format(".solitaire-{}-1.part", kNobody);
  make(recent, std::chrono::seconds(1));
  make(fmt::format(".solitaire-{}-23.part", kNobody), kOld);
  fs::create_directory(folder / fmt::format(".solitaire-{}-4.part", kNobody));
  fs::create_symlink("scene-0001.glb", folder / fmt::format(".solitaire-{}-5.part", kNobody));
  remove_abandoned_files(folder.path());
  CHECK(folder.entries() == others.size() + 3);
  for (const std::string& name : others) CHECK(fs::exists(folder / name));
  CHECK(fs::exists(folder / recent));
  remove_abandoned_files(folder / "none");
}

TEST_CASE("scene: a full device is reported") {
  const std::string error = error_of([] { write_file_atomically("/dev/full", "x"); });
  CHECK(error == "cannot write /dev/full: No space left on device");
}

TEST_CASE("scene: a write replaces the file, and a link but not the file that it leads to") {
  TemporaryFolder folder;
  write_file(folder / "a", "before");
  fs::create_symlink("a", folder / "link");
  write_file_atomically(folder / "link", "after");
  CHECK(read_file(folder / "a") == "before");
  CHECK(read_file(folder / "link") == "after");
  CHECK(!fs::is_symlink(folder / "link"));
  write_file_atomically(folder / "a", "again");
  CHECK(read_file(folder / "a") == "again");
  CHECK(folder.entries() == 2);
}

}  // namespace solitaire
