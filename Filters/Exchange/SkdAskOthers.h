// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdAskOthers.h
 * @brief Questions that processes ask each other about what only some of them have.
 */

#ifndef SkdAskOthers_h
#define SkdAskOthers_h

#include "Cells/Read/SkdForEach.h"
#include "Exchange/SkdTransport.h"

#include <algorithm>
#include <utility>

namespace skdtree
{
/// How many questions of a size each process may ask in a round, so that what arrives at one
/// process from all stays within some megabytes.
inline std::size_t SkdSizeOfRound(int processes, std::size_t size)
{
  constexpr std::size_t most = std::size_t(1) << 25; // bytes
  constexpr std::size_t fewest = 1024;
  constexpr std::size_t enough = 65536;
  const std::size_t fair = most / (size * static_cast<std::size_t>(processes));
  return std::min(std::max(fair, fewest), enough);
}

/// The largest of the numbers that processes have.
inline int SkdMostOf(SkdTransport& transport, int own)
{
  int most = own;
  for (const std::vector<int>& told : SkdGatherRows(transport, std::vector<int>{ own }))
  {
    most = std::max(most, told.front());
  }
  return most;
}

/// By process: the items of a round, fewer than 2^32.
using SkdItemsOfProcesses = SkdRowsByProcess<std::uint32_t>;

/// Which of n items to ask each process about: list(i, processes) names the processes. The lists
/// are made in parallel; their order does not depend on threads.
template <class List>
SkdItemsOfProcesses SkdListItems(int processes, std::size_t n, const List& list)
{
  constexpr std::size_t block = 256;
  using Listed = std::pair<int, std::uint32_t>;
  std::vector<std::vector<Listed>> blocks((n + block - 1) / block);
  SkdForEach(
    blocks.size(),
    [&](std::size_t at)
    {
      std::vector<int> named;
      for (std::size_t i = at * block; i < std::min(n, (at + 1) * block); ++i)
      {
        named.clear();
        list(i, named);
        for (const int process : named)
        {
          blocks[at].emplace_back(process, static_cast<std::uint32_t>(i));
        }
      }
    },
    n > block ? 1 : 0);
  SkdItemsOfProcesses items(static_cast<std::size_t>(processes));
  for (const std::vector<Listed>& listed : blocks)
  {
    for (const auto& [process, item] : listed)
    {
      items[static_cast<std::size_t>(process)].push_back(item);
    }
  }
  return items;
}

/// An answer, of which a question may have none or several.
template <class Answer>
struct SkdNumberedAnswer
{
  std::uint32_t Number; // of the question among those from its process
  Answer TheAnswer;
};

/// For each of n items, list(i, processes) names the processes to ask and make(i) makes the
/// question; reply(questions, answers) appends answers to those that came from another process,
/// some to each; take(i, answer, process) gets what comes back, process by process. All processes
/// must call it together. Returns the number of questions that were sent.
template <class Question, class Answer, class List, class Make, class Reply, class Take>
std::uint64_t SkdAskOthers(SkdTransport& transport, std::size_t n, const List& list,
  const Make& make, const Reply& reply, const Take& take)
{
  using Numbered = SkdNumberedAnswer<Answer>;
  const SkdItemsOfProcesses items = SkdListItems(transport.GetNumber(), n, list);
  SkdRowsByProcess<Question> questions(items.size());
  std::uint64_t requests = 0;
  for (std::size_t process = 0; process < items.size(); ++process)
  {
    questions[process].resize(items[process].size());
    SkdForEach(items[process].size(),
      [&](std::size_t k) { questions[process][k] = make(items[process][k]); });
    requests += items[process].size();
  }
  questions = SkdExchangeRows(transport, questions);
  SkdRowsByProcess<Numbered> answers(items.size());
  for (std::size_t process = 0; process < items.size(); ++process)
  {
    reply(questions[process], answers[process]);
  }
  answers = SkdExchangeRows(transport, answers);
  for (std::size_t process = 0; process < items.size(); ++process)
  {
    for (const Numbered& told : answers[process])
    {
      take(items[process][told.Number], told.TheAnswer, static_cast<int>(process));
    }
  }
  return requests;
}
}

#endif
