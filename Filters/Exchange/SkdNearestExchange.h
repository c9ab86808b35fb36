// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdNearestExchange_h
#define SkdNearestExchange_h

#include "Core/Geometry/Vector.h"
#include "Exchange/SkdAskOthers.h"
#include "Pipeline/SkdLoop.h"

#include <algorithm>

/// A process with a box near a point.
struct SkdNearProcess
{
  int Process;
  double Distance2; // squared, from the point to the nearest of its boxes; never too large
};

/// The nearest of what several processes have, to points of each of them. A point is answered at
/// home first. It is then sent to the process with the nearest box, if that is not farther than the
/// answer, and last to all others whose boxes are not farther than the better of both. The distance
/// found so far travels along, so that a process that has nothing nearer finds so out in its first
/// boxes, and says nothing.
///
/// `Searcher` has, for any thread:
/// - Answer, trivially copyable; IsBetter(a, b) of two of them, which decides ties in the same way
///   whoever has them; RadiusOf(answer), a radius that just includes it;
/// - bool FindHere(x, radius, answer): the best of the own at a distance of at most `radius`;
/// - void ListNear(x, radius, list): the other processes that have a box within the radius.
template <class Searcher>
class SkdNearestExchange
{
public:
  using Answer = typename Searcher::Answer;

  SkdNearestExchange(SkdTransport& transport, const Searcher& searcher)
    : Transport(transport)
    , TheSearcher(searcher)
  {
  }

  /// Calls set(i, answer, process) for those of n points, pointOf(i, x), that have an answer within
  /// the radius. All processes must call it together, each with points of its own, also if it has
  /// none. Returns false if it was aborted on any of them: then all stop after the same round.
  template <class PointOf, class Set>
  bool Find(std::size_t n, double radius, const PointOf& pointOf, const Set& set, SkdLoop& loop)
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
      goesOn = this->AskHere(begin, end, radius, pointOf, loop);
      this->AskNearest();
      this->AskRest();
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

  /// How often a point was sent to another process.
  std::uint64_t GetAsked() const { return this->Asked; }

private:
  struct Question
  {
    skd::Vector3 Point{};
    double Radius = -1.0; // not asked yet
  };

  /// What is known of a point, and whom it was sent to.
  struct State
  {
    Question Now;
    Answer Best;
    int Process = -1; // that has the best, or -1
    int First = -1;   // that was asked first
  };

  template <class PointOf>
  bool AskHere(
    std::size_t begin, std::size_t end, double radius, const PointOf& pointOf, SkdLoop& loop)
  {
    this->Known.assign(end - begin, State());
    return loop.For(static_cast<vtkIdType>(end - begin),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          State& state = this->Known[static_cast<std::size_t>(i)];
          pointOf(begin + static_cast<std::size_t>(i), state.Now.Point);
          state.Now.Radius = radius;
          Answer answer;
          if (this->TheSearcher.FindHere(state.Now.Point, radius, answer))
          {
            this->Take(state, answer, this->Transport.GetRank());
          }
        }
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

  /// Asks the processes that list(state, near, processes) chooses of those near a point, if
  /// isDue(state).
  template <class IsDue, class List>
  void Ask(const IsDue& isDue, const List& list)
  {
    this->Asked += SkdAskOthers<Question, Answer>(
      this->Transport, this->Known.size(),
      [&](std::size_t i, std::vector<int>& processes)
      {
        State& state = this->Known[i];
        if (isDue(state))
        {
          std::vector<SkdNearProcess> near;
          this->TheSearcher.ListNear(state.Now.Point, state.Now.Radius, near);
          list(state, near, processes);
        }
      },
      [this](std::size_t i) { return this->Known[i].Now; },
      [this](const Question& question, std::vector<Answer>& answers)
      {
        Answer answer;
        if (this->TheSearcher.FindHere(question.Point, question.Radius, answer))
        {
          answers.push_back(answer);
        }
      },
      [this](std::size_t i, const Answer& answer, int process)
      { this->Take(this->Known[i], answer, process); });
  }

  void AskNearest()
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
      });
  }

  void AskRest()
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
      });
  }

  SkdTransport& Transport;
  const Searcher& TheSearcher;
  std::vector<State> Known; // of the points of this round
  std::uint64_t Asked = 0;
};

#endif
