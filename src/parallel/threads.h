#pragma once
// Work on as many threads as OpenMP would take (OMP_NUM_THREADS). What is computed never depends on how many there are.

#include <functional>
#include <vector>

namespace toile {

int thread_count();  // 1..8

// Chunks of about equal size of 0 .. count: work(chunk, begin, end).
void in_ranges(int chunks, int count, const std::function<void(int chunk, int begin, int end)>& work);

// Every task once, after all of `before[task]`, on `threads` at most.
void in_order(const std::vector<std::vector<int>>& before, const std::function<void(int task)>& work,
              int threads = thread_count());

}  // namespace toile
