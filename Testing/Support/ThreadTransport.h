// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ThreadTransport_h
#define ThreadTransport_h

#include "Exchange/SkdTransport.h"

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace skdtest
{

/// Threads in place of processes, so that an exchange between many is tested without MPI.
class ThreadTransport : public skdtree::SkdTransport
{
public:
  /// Calls run(transport) in as many threads as processes are wanted.
  template <class Run>
  static void RunAll(int number, const Run& run)
  {
    RunOwners(
      number, [&run](std::unique_ptr<skdtree::SkdTransport> transport) { run(*transport); });
  }

  /// The same, for what keeps its transport: run(std::unique_ptr<SkdTransport>).
  template <class Run>
  static void RunOwners(int number, const Run& run)
  {
    Post post(number);
    std::vector<std::thread> threads;
    for (int rank = 0; rank < number; ++rank)
    {
      threads.emplace_back([&post, &run, rank]()
        { run(std::unique_ptr<skdtree::SkdTransport>(new ThreadTransport(post, rank))); });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }

  int GetRank() const override { return this->Rank; }
  int GetNumber() const override { return this->Boxes.Number; }

protected:
  skdtree::SkdBytes Move(
    const skdtree::SkdBytes& message, int to, int from, std::size_t size) override
  {
    std::unique_lock<std::mutex> lock(this->Boxes.Mutex);
    if (!message.empty())
    {
      this->Boxes.Of(this->Rank, to).push_back(message);
      this->Boxes.Changed.notify_all();
    }
    if (size == 0)
    {
      return {};
    }
    std::deque<skdtree::SkdBytes>& in = this->Boxes.Of(from, this->Rank);
    this->Boxes.Changed.wait(lock, [&]() { return !in.empty(); });
    skdtree::SkdBytes received = std::move(in.front());
    in.pop_front();
    return received;
  }

private:
  struct Post
  {
    explicit Post(int number)
      : Number(number)
      , Sent(static_cast<std::size_t>(number) * static_cast<std::size_t>(number))
    {
    }
    std::deque<skdtree::SkdBytes>& Of(int from, int to)
    {
      return this->Sent[static_cast<std::size_t>(from * this->Number + to)];
    }

    int Number;
    std::mutex Mutex;
    std::condition_variable Changed;
    std::vector<std::deque<skdtree::SkdBytes>> Sent;
  };

  ThreadTransport(Post& boxes, int rank)
    : Boxes(boxes)
    , Rank(rank)
  {
  }

  Post& Boxes;
  int Rank;
};

}

#endif
