// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdFaceSets.h"

#include "Solids/Boolean/SkdRoundedPlane.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace skdtree
{
/// What the triangles of a face have in common.
struct SkdFaceSets::Key
{
  int Block;
  bool IsNumber; ///< of an array; else a cell
  vtkIdType Number;
  std::uint32_t Triangle;

  auto AsTuple() const { return std::tie(this->Block, this->IsNumber, this->Number); }
  bool operator<(const Key& other) const
  {
    return this->AsTuple() != other.AsTuple() ? this->AsTuple() < other.AsTuple()
                                              : this->Triangle < other.Triangle;
  }
};

namespace
{
/// The numbers of the cells of each block; nullptr where there are none.
std::vector<vtkDataArray*> FindNumbers(const std::vector<SkdBlock>& blocks, const char* name)
{
  std::vector<vtkDataArray*> numbers;
  for (const SkdBlock& block : blocks)
  {
    vtkDataArray* array = block.Mesh->GetCellData()->GetArray(name);
    const bool isUsed = array && array->GetNumberOfComponents() == 1 &&
      array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE &&
      array->GetNumberOfTuples() >= block.Mesh->GetNumberOfCells();
    numbers.push_back(isUsed ? array : nullptr);
  }
  return numbers;
}

/// Whether each triangle is a cell, and cells have no numbers.
bool AreAllAlone(const SkdTriangleSet& set, const std::vector<vtkDataArray*>& numbers)
{
  return set.GetCells().size() == set.GetTriangles().size() &&
    std::all_of(numbers.begin(), numbers.end(), [](vtkDataArray* array) { return !array; });
}
}

//------------------------------------------------------------------------------
SkdFaceSets::SkdFaceSets(const SkdPlacement& placement, const std::vector<SkdBlock>& blocks,
  const char* name, const std::vector<std::string>& others)
  : Moved(&placement.First)
  , Set(&placement.First.GetSet())
  , Sets(this->Set->GetTriangles().size())
  , Largest(this->Set->GetTriangles().size())
  , United(this->Largest.size())
{
  std::iota(this->Largest.begin(), this->Largest.end(), 0u);
  this->TakeData(blocks, others);
  const std::vector<Key> keys = this->ListKeys(blocks, name);
  for (const Key *first = keys.data(), *end = first + keys.size(); first != end;)
  {
    const Key* last = first + 1;
    while (last != end && last->AsTuple() == first->AsTuple())
    {
      ++last;
    }
    this->UniteAll(first, last);
    first = last;
  }
}

void SkdFaceSets::Update(const SkdPlacement& placement, const std::vector<SkdBlock>& blocks,
  const char* name, const std::vector<std::string>& others)
{
  const SkdTriangleSet& set = placement.First.GetSet();
  const std::vector<vtkDataArray*> numbers = FindNumbers(blocks, name);
  if (this->Largest.size() != set.GetTriangles().size() || !AreAllAlone(set, numbers))
  {
    *this = SkdFaceSets(placement, blocks, name, others);
    return;
  }
  this->Moved = &placement.First;
  this->Set = &set;
  this->Separate();
  this->TakeData(blocks, others);
}

void SkdFaceSets::Separate()
{
  this->United.ForEach(
    [this](std::uint32_t triangle)
    {
      this->Sets.TakeOut(triangle);
      this->Largest[triangle] = triangle;
    });
  this->United.Clear();
}

void SkdFaceSets::TakeData(
  const std::vector<SkdBlock>& blocks, const std::vector<std::string>& others)
{
  this->Data.clear();
  for (const SkdBlock& block : blocks)
  {
    this->Data.emplace_back();
    vtkCellData* data = block.Mesh->GetCellData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      const std::string nameOfArray = array->GetName() ? array->GetName() : "";
      const bool isCompared = array != data->GetGlobalIds() && // which are different in all cells
        std::find(others.begin(), others.end(), nameOfArray) == others.end();
      if (isCompared)
      {
        this->Data.back().push_back(array);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::vector<SkdFaceSets::Key> SkdFaceSets::ListKeys(
  const std::vector<SkdBlock>& blocks, const char* name) const
{
  const auto n = static_cast<std::uint32_t>(this->Set->GetTriangles().size());
  const std::vector<vtkDataArray*> numbers = FindNumbers(blocks, name);
  std::vector<Key> keys;
  if (AreAllAlone(*this->Set, numbers))
  {
    return keys;
  }
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    const std::uint32_t cell = this->Set->GetCellOf(triangle);
    const SkdTriangleSet::Cell& of = this->Set->GetCells()[cell];
    vtkDataArray* const array = numbers[of.Block];
    const bool isOfMore = (triangle > 0 && this->Set->GetCellOf(triangle - 1) == cell) ||
      (triangle + 1 < n && this->Set->GetCellOf(triangle + 1) == cell);
    if (array || isOfMore)
    {
      const vtkIdType number = array ? static_cast<vtkIdType>(array->GetTuple1(of.Id)) : of.Id;
      keys.push_back({ of.Block, array != nullptr, number, triangle });
    }
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// Those in the plane of the largest.
void SkdFaceSets::UniteAll(const Key* first, const Key* last)
{
  const Key* largest = first;
  double most = -1.0;
  for (const Key* key = first; key != last; ++key)
  {
    const double size = Norm(this->NormalOf(key->Triangle));
    largest = size > most ? key : largest;
    most = std::max(most, size);
  }
  for (const Key* key = first; key != last; ++key)
  {
    if (this->FacesAs(key->Triangle, largest->Triangle) &&
      this->IsInPlane(key->Triangle, largest->Triangle))
    {
      this->Unite(key->Triangle, largest->Triangle, largest->Triangle);
    }
  }
}

void SkdFaceSets::Unite(std::uint32_t a, std::uint32_t b, std::uint32_t largest)
{
  this->United.Mark(a); // what was of a face of several is marked already
  this->United.Mark(b);
  this->Sets.Unite(a, b);
  this->Largest[this->Sets.Find(a)] = largest;
}

//------------------------------------------------------------------------------
bool SkdFaceSets::Unite(std::uint32_t a, std::uint32_t b)
{
  const std::uint32_t first = this->Largest[this->Find(a)];
  const std::uint32_t second = this->Largest[this->Find(b)];
  if (this->Find(a) == this->Find(b))
  {
    return true;
  }
  const bool isFirstLarger = Norm(this->NormalOf(first)) >= Norm(this->NormalOf(second));
  const std::uint32_t plane = isFirstLarger ? first : second;
  const auto isIn = [&](std::uint32_t triangle)
  { return this->FacesAs(triangle, plane) && this->IsInPlane(triangle, plane); };
  const bool areOne =
    this->HaveSameData(a, b) && isIn(a) && isIn(b) && isIn(isFirstLarger ? second : first);
  if (areOne)
  {
    this->Unite(a, b, plane);
  }
  return areOne;
}

bool SkdFaceSets::AreInOnePlane(std::uint32_t a, std::uint32_t b) const
{
  const std::uint32_t first = this->Largest[this->Sets.Find(a)];
  const std::uint32_t second = this->Largest[this->Sets.Find(b)];
  return Norm(this->NormalOf(first)) >= Norm(this->NormalOf(second))
    ? this->IsInPlane(second, first)
    : this->IsInPlane(first, second);
}

bool SkdFaceSets::HaveSameData(std::uint32_t a, std::uint32_t b) const
{
  const SkdTriangleSet::Cell& first = this->Set->GetCells()[this->Set->GetCellOf(a)];
  const SkdTriangleSet::Cell& second = this->Set->GetCells()[this->Set->GetCellOf(b)];
  if (first.Block != second.Block)
  {
    return false;
  }
  for (const auto& array : this->Data[first.Block])
  {
    const int n = array->GetNumberOfComponents();
    const vtkIdType size = array->GetNumberOfTuples();
    for (int i = 0; i < n && first.Id < size && second.Id < size; ++i)
    {
      if (!(array->GetVariantValue(first.Id * n + i) == array->GetVariantValue(second.Id * n + i)))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
skd::Vector3 SkdFaceSets::At(std::uint32_t triangle, std::size_t corner) const
{
  return this->Moved->GetPoints()[this->Set->GetTriangles()[triangle][corner]];
}

skd::Vector3 SkdFaceSets::NormalOf(std::uint32_t triangle) const
{
  const skd::Vector3 a = this->At(triangle, 0);
  return Cross(this->At(triangle, 1) - a, this->At(triangle, 2) - a);
}

bool SkdFaceSets::FacesAs(std::uint32_t triangle, std::uint32_t plane) const
{
  return triangle == plane || Dot(this->NormalOf(plane), this->NormalOf(triangle)) > 0.0;
}

bool SkdFaceSets::IsInPlane(std::uint32_t triangle, std::uint32_t plane) const
{
  const auto corners = this->Moved->GetCornerPoints(triangle);
  const auto inPlane = this->Moved->GetCornerPoints(plane);
  const double tolerance = std::max(SkdToleranceOf(corners), SkdToleranceOf(inPlane));
  return SkdRoundedPlane(inPlane, tolerance).Contains(corners);
}
}
