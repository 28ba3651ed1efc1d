#include "parallel/threads.h"

#include <omp.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "parallel/in_chunks.h"

namespace toile {

int thread_count() { return std::clamp(omp_get_max_threads(), 1, 8); }

void in_ranges(int chunks, int count, const std::function<void(int, int, int)>& work) {
  in_chunks(chunks, std::min(chunks, thread_count()), [&](int chunk) {
    const auto bound = [&](int c) { return static_cast<int>(static_cast<long long>(count) * c / chunks); };
    work(chunk, bound(chunk), bound(chunk + 1));
  });
}

void in_order(const std::vector<std::vector<int>>& before, const std::function<void(int)>& work, int threads) {
  const int count = static_cast<int>(before.size());
  std::vector<int> waiting(before.size());
  std::vector<std::vector<int>> after(before.size());
  std::vector<int> ready;
  for (int task = count; task-- > 0;) {
    const auto& first = before[static_cast<std::size_t>(task)];
    waiting[static_cast<std::size_t>(task)] = static_cast<int>(first.size());
    for (const int earlier : first) after[static_cast<std::size_t>(earlier)].push_back(task);
    if (first.empty()) ready.push_back(task);
  }
  std::mutex guard;
  std::condition_variable changed;
  std::exception_ptr failure;
  int left = count;
  const auto run = [&] {
    std::unique_lock lock(guard);
    while (true) {
      changed.wait(lock, [&] { return !ready.empty() || left == 0 || failure; });
      if (left == 0 || failure) return;
      const int task = ready.back();
      ready.pop_back();
      lock.unlock();
      std::exception_ptr thrown;
      try {
        work(task);
      } catch (...) {
        thrown = std::current_exception();
      }
      lock.lock();
      if (thrown) failure = thrown;
      --left;
      for (const int next : after[static_cast<std::size_t>(task)])
        if (--waiting[static_cast<std::size_t>(next)] == 0) ready.push_back(next);
      changed.notify_all();
    }
  };
  std::vector<std::thread> helpers;
  for (int t = 1; t < std::min(threads, count); ++t) helpers.emplace_back(run);
  run();
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace toile
