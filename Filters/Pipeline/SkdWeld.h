// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdWeld_h
#define SkdWeld_h

#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <functional>
#include <unordered_map>

/// Points by their coordinates: equal ones are one.
class SkdWeld
{
public:
  SkdWeld()
    : Points(vtkSmartPointer<vtkPoints>::New())
  {
    this->Points->SetDataTypeToDouble();
  }

  /// The id of the point at x, a new one when it is the first there.
  vtkIdType GetId(const double x[3])
  {
    const Key key{ x[0] + 0.0, x[1] + 0.0, x[2] + 0.0 }; // + 0 makes -0 equal in its bits, too
    const auto [entry, isNew] = this->Ids.emplace(key, this->Points->GetNumberOfPoints());
    if (isNew)
    {
      this->Points->InsertNextPoint(x);
    }
    return entry->second;
  }

  vtkPoints* GetPoints() const { return this->Points; }

private:
  using Key = std::array<double, 3>;
  struct Hash
  {
    std::size_t operator()(const Key& key) const
    {
      std::size_t hash = 0;
      for (double coordinate : key)
      {
        hash = (hash ^ std::hash<double>()(coordinate)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
      }
      return hash;
    }
  };

  std::unordered_map<Key, vtkIdType, Hash> Ids;
  vtkSmartPointer<vtkPoints> Points;
};

#endif
