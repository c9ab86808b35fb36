// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdNearestExchange_h
#define SkdNearestExchange_h

#include "Exchange/SkdAskOthers.h"
#include "Pipeline/SkdLoop.h"

#include <algorithm>

namespace skdtree
{
/// A process with a box near a query.
struct SkdNearProcess
{
  int Process;
  double Distance2; // squared, to the nearest of its boxes; never too large
};

/// A question and what it is answered with.
template <class Query, class Answer>
struct SkdNearestState
{
  struct Question
  {
    Query Request{};
    double Radius = -1.0; // negative: not asked yet
  };

  Question Now;
  Answer Best;
  int Process = -1; // that has the best, or -1
  int First = -1;   // that was asked first
};

/// The nearest of what several processes have, to queries (points or rays) of each of them. A query
/// is answered at home first. It is then sent to the process with the nearest box, if that is not
/// farther than the answer, and last to all others whose boxes are not farther than the better of
/// both. The distance found so far travels along, so that a process that has nothing nearer finds
/// so out in its first boxes, and says nothing.
///
/// `Searcher` has:
/// - Query and Answer, trivially copyable; IsBetter(a, b) of two answers, which decides ties in the
///   same way whoever has them; RadiusOf(answer), a radius that just includes it;
/// - FindHere(n, questionOf, set): in parallel, for those of n questions that have an answer among
///   the own, at a distance of at most Radius, calls set(i, answer) with the best;
/// - ListNear(query, radius, list), for any thread: the other processes that have a box within the
///   radius.
template <class Searcher>
class SkdNearestExchange
{
public:
  using Query = typename Searcher::Query;
  using Answer = typename Searcher::Answer;
  using State = SkdNearestState<Query, Answer>;
  using Question = typename State::Question;

  SkdNearestExchange(SkdTransport& transport, const Searcher& searcher)
    : Transport(transport)
    , TheSearcher(searcher)
  {
  }

  /// Calls set(i, answer, process) for those of n queries, queryOf(i), that have an answer within
  /// the radius. All processes must call it together, each with queries of its own, also if it has
  /// none. Returns false if it was aborted on any of them: then all stop after the same round.
  template <class QueryOf, class Set>
  bool Find(std::size_t n, double radius, const QueryOf& queryOf, const Set& set, SkdLoop& loop)
  {
    return this->Find(
      n, radius, queryOf, set, [](const Answer&, int) {}, loop);
  }

  /// The same, and calls heard(answer, process) for each answer of a process to a query: the best,
  /// and others.
  template <class QueryOf, class Set, class Heard>
  bool Find(std::size_t n, double radius, const QueryOf& queryOf, const Set& set,
    const Heard& heard, SkdLoop& loop)
  {
    const std::size_t share = SkdSizeOfRound(this->Transport.GetNumber(), sizeof(Question));
    bool goesOn = true;
    std::size_t begin = 0;
    while (true)
    {
      const int state = SkdMostOf(this->Transport, !goesOn ? 2 : begin < n ? 1 : 0);
      if (state != 1)
      {
        return state == 0;
      }
      const std::size_t end = std::min(n, begin + share);
      this->Known.assign(end - begin, State());
      goesOn = this->AskHere([&](std::size_t i) { return queryOf(begin + i); }, radius, loop);
      for (const State& known : this->Known)
      {
        if (known.Process >= 0)
        {
          heard(known.Best, known.Process);
        }
      }
      this->AskNearest(heard);
      this->AskRest(heard);
      for (std::size_t i = 0; i < this->Known.size(); ++i)
      {
        if (this->Known[i].Process >= 0)
        {
          set(begin + i, this->Known[i].Best, this->Known[i].Process);
        }
      }
      begin = end;
    }
  }

  /// How often a query was sent to another process.
  std::uint64_t CountRequests() const { return this->NumberOfRequests; }

private:
  template <class QueryOf>
  bool AskHere(const QueryOf& queryOf, double radius, SkdLoop& loop)
  {
    return loop.InPieces(static_cast<vtkIdType>(this->Known.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        const auto begin = static_cast<std::size_t>(first);
        const std::size_t n = static_cast<std::size_t>(last) - begin;
        SkdForEach(n,
          [&](std::size_t i) {
            this->Known[begin + i].Now = { queryOf(begin + i), radius };
          });
        this->TheSearcher.FindHere(
          n, [&](std::size_t i) { return this->Known[begin + i].Now; },
          [&](std::size_t i, const Answer& answer)
          { this->Take(this->Known[begin + i], answer, this->Transport.GetRank()); });
      });
  }

  void Take(State& state, const Answer& answer, int process) const
  {
    if (state.Process < 0 || this->TheSearcher.IsBetter(answer, state.Best))
    {
      state.Best = answer;
      state.Process = process;
      state.Now.Radius = std::min(state.Now.Radius, this->TheSearcher.RadiusOf(answer));
    }
  }

  void Reply(
    const std::vector<Question>& questions, std::vector<SkdNumberedAnswer<Answer>>& answers) const
  {
    std::vector<SkdNumberedAnswer<Answer>> found(questions.size());
    std::vector<unsigned char> isFound(questions.size(), 0);
    this->TheSearcher.FindHere(
      questions.size(), [&](std::size_t i) { return questions[i]; },
      [&](std::size_t i, const Answer& answer)
      {
        found[i] = { static_cast<std::uint32_t>(i), answer };
        isFound[i] = 1;
      });
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      if (isFound[i] != 0)
      {
        answers.push_back(found[i]);
      }
    }
  }

  /// Asks the processes that list(state, near, processes) chooses of those near a query, if
  /// isDue(state).
  template <class IsDue, class List, class Heard>
  void Ask(const IsDue& isDue, const List& list, const Heard& heard)
  {
    this->NumberOfRequests += SkdAskOthers<Question, Answer>(
      this->Transport, this->Known.size(),
      [&](std::size_t i, std::vector<int>& processes)
      {
        State& state = this->Known[i];
        if (isDue(state))
        {
          std::vector<SkdNearProcess> near;
          this->TheSearcher.ListNear(state.Now.Request, state.Now.Radius, near);
          list(state, near, processes);
        }
      },
      [this](std::size_t i) { return this->Known[i].Now; },
      [this](const std::vector<Question>& questions,
        std::vector<SkdNumberedAnswer<Answer>>& answers) { this->Reply(questions, answers); },
      [&](std::size_t i, const Answer& answer, int process)
      {
        heard(answer, process);
        this->Take(this->Known[i], answer, process);
      });
  }

  template <class Heard>
  void AskNearest(const Heard& heard)
  {
    this->Ask([](const State& state) { return state.Now.Radius >= 0.0; },
      [](State& state, const std::vector<SkdNearProcess>& near, std::vector<int>& processes)
      {
        const auto nearest = std::min_element(near.begin(), near.end(),
          [](const SkdNearProcess& a, const SkdNearProcess& b)
          { return a.Distance2 < b.Distance2; });
        if (nearest != near.end())
        {
          state.First = nearest->Process;
          processes.push_back(state.First);
        }
      },
      heard);
  }

  template <class Heard>
  void AskRest(const Heard& heard)
  {
    this->Ask([](const State& state) { return state.First >= 0; },
      [](const State& state, const std::vector<SkdNearProcess>& near, std::vector<int>& processes)
      {
        for (const SkdNearProcess& other : near)
        {
          if (other.Process != state.First)
          {
            processes.push_back(other.Process);
          }
        }
      },
      heard);
  }

  SkdTransport& Transport;
  const Searcher& TheSearcher;
  std::vector<State> Known; // of the queries of this round
  std::uint64_t NumberOfRequests = 0;
};
}

#endif
