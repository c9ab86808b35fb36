// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdSpreadChains.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// The longest comes first.
struct Rank
{
  std::uint64_t Mixed; // different for different chains
  std::uint32_t Length;
  SkdChain Chain;

  bool operator<(const Rank& other) const
  {
    return this->Length != other.Length ? this->Length > other.Length : this->Mixed < other.Mixed;
  }
};

/// What is known of the chains in a row that begins with one and goes on from one of its ends.
struct Row
{
  Rank First;       // of all that are known
  SkdChainEnd Next; // that the first chain which is not known goes on from; none: all are known
};

/// One to one: SplitMix64's finalizer (Steele, Lea, Flood, OOPSLA 2014).
std::uint64_t Mix(std::uint64_t x)
{
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// The end that a chain goes on from which is entered at one.
SkdChainEnd Opposite(SkdChainEnd entered)
{
  return { entered.Process, entered.End ^ 1u };
}

std::vector<Row> BeginRows(
  int process, const std::vector<std::uint32_t>& lengths, const std::vector<SkdChainEnd>& links)
{
  std::vector<Row> rows(links.size());
  for (std::uint32_t end = 0; end < rows.size(); ++end)
  {
    const std::uint32_t chain = end / 2;
    const std::uint64_t number = (static_cast<std::uint64_t>(process) << 32) | chain;
    rows[end] = { { Mix(number), lengths[chain], { process, chain } }, Opposite(links[end]) };
  }
  return rows;
}

/// Adds to each row the one that it goes on with. Returns whether that has told anything.
bool Extend(SkdTransport& transport, std::vector<Row>& rows)
{
  const auto processes = static_cast<std::size_t>(transport.GetNumber());
  SkdRowsByProcess<std::uint32_t> questions(processes);
  SkdRowsByProcess<std::uint32_t> askers(processes);
  for (std::uint32_t end = 0; end < rows.size(); ++end)
  {
    if (rows[end].Next.Process >= 0)
    {
      const auto to = static_cast<std::size_t>(rows[end].Next.Process);
      questions[to].push_back(rows[end].Next.End);
      askers[to].push_back(end);
    }
  }
  const SkdRowsByProcess<Row> answers = SkdAsk<Row>(transport, questions,
    [&rows](const SkdRowsByProcess<std::uint32_t>& asked)
    {
      SkdRowsByProcess<Row> told(asked.size());
      for (std::size_t from = 0; from < asked.size(); ++from)
      {
        for (const std::uint32_t end : asked[from])
        {
          told[from].push_back(rows[end]);
        }
      }
      return told;
    });
  bool isNew = false;
  for (std::size_t to = 0; to < processes; ++to)
  {
    for (std::size_t i = 0; i < askers[to].size(); ++i)
    {
      Row& row = rows[askers[to][i]];
      isNew = isNew || answers[to][i].First < row.First;
      row.First = std::min(row.First, answers[to][i].First);
      row.Next = answers[to][i].Next;
    }
  }
  return isNew;
}
}

// In a round that tells no row anything all is known: if the first of a row of chains were unknown
// to one before it, the chain 2^k before it would get to know it in round k; and in a ring, if it
// were not all in what two neighbouring stretches of 2^k know, their firsts would differ all
// around.
std::vector<SkdChain> SkdChooseChains(SkdTransport& transport,
  const std::vector<std::uint32_t>& lengths, const std::vector<SkdChainEnd>& links)
{
  std::vector<Row> rows = BeginRows(transport.GetRank(), lengths, links);
  bool goesOn = true;
  while (goesOn)
  {
    goesOn = SkdIsAny(transport, Extend(transport, rows));
  }
  std::vector<SkdChain> chosen;
  for (std::size_t chain = 0; chain < lengths.size(); ++chain)
  {
    chosen.push_back(std::min(rows[2 * chain].First, rows[2 * chain + 1].First).Chain);
  }
  return chosen;
}
}
