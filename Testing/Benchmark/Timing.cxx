// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Timing.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
#include <malloc.h>
#define SKDBENCH_HAS_MALLINFO2
#endif

namespace skdbench
{
namespace
{

/// Keeps the time of every repetition, by the task's number.
class Collector : public benchmark::BenchmarkReporter
{
public:
  Collector(std::size_t numberOfTasks, bool wallClock)
    : Times(numberOfTasks)
    , WallClock(wallClock)
  {
  }

  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override
  {
    for (const Run& run : runs)
    {
      if (run.run_type == Run::RT_Iteration)
      {
        const double time = this->WallClock ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime();
        this->Times[std::stoul(run.run_name.function_name)].push_back(time);
      }
    }
  }

  double Median(std::size_t task)
  {
    std::vector<double>& times = this->Times[task];
    std::sort(times.begin(), times.end());
    const std::size_t n = times.size();
    return n == 0 ? 0.0 : 0.5 * (times[(n - 1) / 2] + times[n / 2]);
  }

private:
  std::vector<std::vector<double>> Times;
  bool WallClock;
};

void Register(std::size_t number, const Task& task, const Options& options)
{
  const auto loop = [&task](benchmark::State& state)
  {
    for (auto turn : state)
    {
      (void)turn;
      task.Run();
      benchmark::ClobberMemory();
      if (task.CleanUp)
      {
        state.PauseTiming();
        task.CleanUp();
        state.ResumeTiming();
      }
    }
  };
  auto* registered = benchmark::RegisterBenchmark(std::to_string(number).c_str(), loop);
  registered->Unit(benchmark::kNanosecond)->MinTime(options.Seconds)->Repetitions(task.Repetitions);
  if (options.Threads > 1)
  {
    registered->UseRealTime();
  }
}

}

void StartTiming()
{
  std::string program = "skdtree_benchmark";
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  char* arguments[] = { program.data(), interleave.data(), nullptr };
  int count = 2;
  benchmark::Initialize(&count, arguments);
}

std::vector<double> MedianNanoseconds(const std::vector<Task>& tasks, const Options& options)
{
  if (tasks.empty())
  {
    return {}; // Google Benchmark would complain
  }
  Collector collector(tasks.size(), options.Threads > 1);
  benchmark::ClearRegisteredBenchmarks();
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    Register(i, tasks[i], options);
  }
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  std::vector<double> medians;
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    medians.push_back(collector.Median(i));
  }
  return medians;
}

std::optional<double> BytesOnHeap()
{
#ifdef SKDBENCH_HAS_MALLINFO2
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
#else
  return std::nullopt;
#endif
}

}
