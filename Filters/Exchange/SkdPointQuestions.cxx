// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdPointQuestions.h"

#include "Bodies/SkdWeld.h"
#include "Exchange/SkdPointJoin.h"

#include <algorithm>
#include <unordered_map>

namespace skdtree
{
namespace
{
using Keys = std::vector<std::vector<vtkIdType>>;

std::size_t FindKeysByGlobalIds(
  const SkdPointQuestions& queries, double largestCoordinate, Keys& keys, SkdRepeatedId& repeated)
{
  struct First
  {
    vtkIdType Key;
    int Process;
    const SkdPointQuestion* Question;
  };
  std::unordered_map<vtkIdType, First> known;
  for (std::size_t piece = 0; piece < queries.size(); ++piece)
  {
    for (const SkdPointQuestion& question : queries[piece])
    {
      const First own{ static_cast<vtkIdType>(known.size()), static_cast<int>(piece), &question };
      const First& first = known.emplace(question.GlobalId, own).first->second;
      keys[piece].push_back(first.Key);
      if (!repeated.IsThere && SkdAreDifferent(question.X, first.Question->X, largestCoordinate))
      {
        repeated = { true, true, question.GlobalId,
          { { { first.Process, first.Question->Point }, { own.Process, question.Point } } } };
      }
    }
  }
  return known.size();
}

std::size_t FindKeysByCoordinates(
  const SkdPointQuestions& queries, const SkdRounding& rounding, Keys& keys)
{
  SkdWeld weld;
  for (std::size_t piece = 0; piece < queries.size(); ++piece)
  {
    for (const SkdPointQuestion& question : queries[piece])
    {
      keys[piece].push_back(weld.GetId(question.X.X));
    }
  }
  SkdMergeNearPoints(rounding, weld.GetPoints(), keys);
  return weld.GetPoints().size();
}

/// Adds the points of all pieces in the order of SkdPiecePoints.
class PointDirectory
{
public:
  PointDirectory(const SkdPointQuestions& queries, const Keys& keys, std::size_t numberOfKeys)
    : Queries(queries)
    , Keyed(keys)
    , Join(numberOfKeys)
    , Ids(queries.size())
  {
    for (std::size_t piece = 0; piece < queries.size(); ++piece)
    {
      this->Ids[piece].assign(queries[piece].size(), -1);
      this->AddOwn(piece);
    }
    for (std::size_t piece = 0; piece < queries.size(); ++piece)
    {
      this->AddGhosts(piece);
    }
  }

  SkdPointAnswers GetAnswers() const
  {
    SkdPointAnswers answers(this->Queries.size());
    for (std::size_t piece = 0; piece < this->Queries.size(); ++piece)
    {
      for (const vtkIdType id : this->Ids[piece])
      {
        answers[piece].push_back(
          id < 0 ? SkdPointAnswer{ { -1, -1 }, { -1, -1 }, { -1, -1 } } : this->AnswerOf(id));
      }
    }
    return answers;
  }

private:
  SkdPointAnswer AnswerOf(vtkIdType id) const
  {
    const Origin& origin = this->Origins[static_cast<std::size_t>(id)];
    const vtkIdType first = this->Join.FirstLike(id);
    return { origin.Numbered, origin.Data,
      this->Join.IsShared(first) ? this->Origins[static_cast<std::size_t>(first)].Numbered
                                 : SkdPointOrigin{ -1, -1 } };
  }

  void AddOwn(std::size_t piece)
  {
    for (std::size_t i = 0; i < this->Queries[piece].size(); ++i)
    {
      if (this->Queries[piece][i].Order == SkdPointQuestion::AtOnce)
      {
        this->Add(piece, i);
      }
    }
  }

  void AddGhosts(std::size_t piece)
  {
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < this->Queries[piece].size(); ++i)
    {
      if (this->Queries[piece][i].Order >= 0)
      {
        used.push_back(i);
      }
    }
    std::sort(used.begin(), used.end(),
      [&](std::size_t a, std::size_t b)
      { return this->Queries[piece][a].Order < this->Queries[piece][b].Order; });
    for (const std::size_t i : used)
    {
      this->Add(piece, i);
    }
  }

  void Add(std::size_t piece, std::size_t i)
  {
    const vtkIdType before = this->Join.GetNumber();
    const vtkIdType id = this->Join.Add(static_cast<int>(piece), this->Keyed[piece][i]);
    const SkdPointQuestion& question = this->Queries[piece][i];
    const SkdPointOrigin own{ static_cast<int>(piece), question.Point };
    if (id == before)
    {
      this->Origins.push_back({ own, own, question.IsIncomplete });
    }
    Origin& origin = this->Origins[static_cast<std::size_t>(id)];
    if (origin.IsIncomplete && !question.IsIncomplete)
    {
      origin.Data = own;
      origin.IsIncomplete = false;
    }
    this->Ids[piece][i] = id;
  }

  /// The first point, and the first that is complete (SkdIncompleteOf).
  struct Origin
  {
    SkdPointOrigin Numbered;
    SkdPointOrigin Data;
    bool IsIncomplete;
  };

  const SkdPointQuestions& Queries;
  const Keys& Keyed;
  SkdPointJoin Join;
  Keys Ids;
  std::vector<Origin> Origins; // by joined point
};
}

SkdPointAnswers SkdAnswerByGlobalIds(
  const SkdPointQuestions& queries, double largestCoordinate, SkdRepeatedId& repeated)
{
  Keys keys(queries.size());
  const std::size_t number = FindKeysByGlobalIds(queries, largestCoordinate, keys, repeated);
  return PointDirectory(queries, keys, number).GetAnswers();
}

SkdPointAnswers SkdAnswerByCoordinates(
  const SkdPointQuestions& queries, const SkdRounding& rounding)
{
  Keys keys(queries.size());
  const std::size_t number = FindKeysByCoordinates(queries, rounding, keys);
  return PointDirectory(queries, keys, number).GetAnswers();
}
}
