// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdPiecePoints.h"

#include "Bodies/SkdWeld.h"
#include "Exchange/SkdNearPoints.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <unordered_map>

namespace skdtree
{
SkdPiecePoints::SkdPiecePoints(const SkdPieces& pieces)
  : Pieces(pieces)
  , Keys(pieces.size())
  , Ids(pieces.size())
{
  this->FindKeys();
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    const vtkIdType number = pieces[piece]->GetNumberOfPoints();
    const std::vector<unsigned char> ghosts = SkdDuplicatesOf(pieces[piece], vtkDataObject::POINT);
    this->Incomplete.push_back(SkdIncompleteOf(pieces[piece], vtkDataObject::POINT));
    this->Ids[piece].assign(static_cast<std::size_t>(number), -1);
    for (vtkIdType point = 0; point < number; ++point)
    {
      if (ghosts.empty() || !ghosts[static_cast<std::size_t>(point)])
      {
        this->Add(static_cast<int>(piece), point);
      }
    }
  }
}

void SkdPiecePoints::FindKeys()
{
  const bool haveGlobalIds = std::all_of(this->Pieces.begin(), this->Pieces.end(),
    [](vtkDataSet* piece)
    { return piece->GetNumberOfPoints() == 0 || piece->GetPointData()->GetGlobalIds(); });
  if (haveGlobalIds)
  {
    this->FindKeysByGlobalIds();
  }
  else
  {
    this->FindKeysByCoordinates();
  }
}

void SkdPiecePoints::FindKeysByGlobalIds()
{
  struct First
  {
    vtkIdType Key;
    SkdRepeatedId::Owner Owner;
    skd::Vector3 X;
  };
  std::unordered_map<vtkIdType, First> keys;
  double largest = 0.0;
  for (vtkDataSet* piece : this->Pieces)
  {
    largest = std::max(largest, SkdMagnitudesOf(piece).Largest);
  }
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    vtkDataArray* ids = this->Pieces[piece]->GetPointData()->GetGlobalIds();
    for (vtkIdType point = 0; point < this->Pieces[piece]->GetNumberOfPoints(); ++point)
    {
      const auto id = static_cast<vtkIdType>(ids->GetTuple1(point));
      const SkdRepeatedId::Owner owner{ static_cast<int>(piece), point };
      skd::Vector3 x;
      this->Pieces[piece]->GetPoint(point, x.X);
      const First& first =
        keys.emplace(id, First{ static_cast<vtkIdType>(keys.size()), owner, x }).first->second;
      this->Keys[piece].push_back(first.Key);
      if (!this->Repeated.IsThere && SkdAreDifferent(x, first.X, largest))
      {
        this->Repeated = { true, true, id, { { first.Owner, owner } } };
      }
    }
  }
  this->Join = SkdPointJoin(keys.size());
}

void SkdPiecePoints::FindKeysByCoordinates()
{
  SkdWeld weld;
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    for (vtkIdType point = 0; point < this->Pieces[piece]->GetNumberOfPoints(); ++point)
    {
      double x[3];
      this->Pieces[piece]->GetPoint(point, x);
      this->Keys[piece].push_back(weld.GetId(x));
    }
  }
  this->Join = SkdPointJoin(weld.GetPoints().size());
  if (this->Pieces.size() > 1)
  {
    SkdMergeNearPoints(this->Pieces, weld.GetPoints(), this->Keys);
  }
}

vtkIdType SkdPiecePoints::Add(int piece, vtkIdType point)
{
  const auto at = static_cast<std::size_t>(piece);
  const vtkIdType before = this->GetNumber();
  const vtkIdType id = this->Join.Add(piece, this->Keys[at][static_cast<std::size_t>(point)]);
  const Origin own{ piece, point };
  if (id == before)
  {
    this->Origins.push_back(own);
  }
  Origin& origin = this->Origins[static_cast<std::size_t>(id)];
  origin = this->IsIncomplete(origin) && !this->IsIncomplete(own) ? own : origin;
  this->Ids[at][static_cast<std::size_t>(point)] = id;
  return id;
}

bool SkdPiecePoints::IsIncomplete(const Origin& point) const
{
  const std::vector<unsigned char>& are = this->Incomplete[static_cast<std::size_t>(point.Piece)];
  return !are.empty() && are[static_cast<std::size_t>(point.Point)];
}

std::vector<SkdPieceTuples> SkdPiecePoints::GetTuples() const
{
  std::vector<SkdPieceTuples> tuples(this->Pieces.size());
  for (std::size_t id = 0; id < this->Origins.size(); ++id)
  {
    const Origin& origin = this->Origins[id];
    tuples[static_cast<std::size_t>(origin.Piece)].Add(origin.Point, static_cast<vtkIdType>(id));
  }
  return tuples;
}
}
