#pragma once
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace solitaire {

/// Calls work(row) for each row below `rows`, on so many threads at a time. Rows must not depend on each
/// other. An exception of the work is thrown at the end.
template <typename Work>
void for_each_row(std::size_t rows, std::size_t threads, const Work& work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failing;
  const auto run = [&] {
    try {
      for (std::size_t row = next++; row < rows; row = next++) work(row);
    } catch (...) {
      const std::lock_guard lock(failing);
      failure = std::current_exception();
      next = rows;
    }
  };
  std::vector<std::jthread> helpers;
  for (std::size_t i = 1; i < threads && i < rows; ++i) helpers.emplace_back(run);
  run();
  helpers.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace solitaire
