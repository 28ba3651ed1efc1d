#pragma once
// The same work on one or several threads: chunk i is always the same piece of work, whoever does it.

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace toile {

template <class Work>
void in_chunks(int chunks, int threads, const Work& work) {
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto run = [&] {
    try {
      for (int chunk = next++; chunk < chunks; chunk = next++) work(chunk);
    } catch (...) {
      const std::lock_guard lock(guard);
      failure = std::current_exception();
    }
  };
  std::vector<std::thread> helpers;
  for (int t = 1; t < threads; ++t) helpers.emplace_back(run);
  run();
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace toile
