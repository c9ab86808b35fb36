// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Queries allocate nothing. All of the program's operator new is counted, on the thread of the
// query.

#include "Support/LocatorOnMesh.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>
#include <string>

namespace
{
thread_local bool IsCounting = false;
thread_local int NumberOfAllocations = 0;

void* Allocate(std::size_t size)
{
  NumberOfAllocations += IsCounting;
  void* memory = std::malloc(size ? size : 1);
  if (!memory)
  {
    std::abort(); // the forms that must not throw come here, too
  }
  return memory;
}

void* Allocate(std::size_t size, std::align_val_t alignment)
{
  NumberOfAllocations += IsCounting;
  void* memory = nullptr;
  if (posix_memalign(&memory, static_cast<std::size_t>(alignment), size ? size : 1) != 0)
  {
    std::abort();
  }
  return memory;
}
}

// All forms, or those that are left to a sanitizer do not go with these.
void* operator new(std::size_t size)
{
  return Allocate(size);
}

void* operator new[](std::size_t size)
{
  return Allocate(size);
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return Allocate(size);
}

void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
  return Allocate(size);
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
  return Allocate(size, alignment);
}

void* operator new[](std::size_t size, std::align_val_t alignment)
{
  return Allocate(size, alignment);
}

void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
  return Allocate(size, alignment);
}

void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
  return Allocate(size, alignment);
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}

void operator delete[](void* memory) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

void operator delete[](void* memory, std::size_t) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, const std::nothrow_t&) noexcept
{
  std::free(memory);
}

void operator delete[](void* memory, const std::nothrow_t&) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept
{
  std::free(memory);
}

void operator delete[](void* memory, std::align_val_t) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}

void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::align_val_t, const std::nothrow_t&) noexcept
{
  std::free(memory);
}

void operator delete[](void* memory, std::align_val_t, const std::nothrow_t&) noexcept
{
  std::free(memory);
}

using namespace skdtest;

namespace
{

std::vector<NamedMesh> KernelMeshes()
{
  return { { "Vertices", [] { return MakePolyData(Cloud(300, VTK_VERTEX)); } },
    { "Lines", [] { return MakePolyData(Helix(200, VTK_LINE)); } },
    { "Triangles", [] { return MakePolyData(SphereTriangles(10)); } },
    { "Quads", [] { return MakePolyData(SphereQuads(10)); } },
    { "Pixels", [] { return MakeGrid(Sheet(12, VTK_PIXEL)); } },
    { "Tetrahedra", [] { return MakeGrid(Tetrahedra(4).Map(Bent)); } },
    { "Hexahedra", [] { return MakeGrid(Hexahedra(5).Map(Bent)); } },
    { "Voxels", [] { return MakeGrid(Voxels(5)); } },
    { "Wedges", [] { return MakeGrid(Wedges(4).Map(Bent)); } },
    { "Pyramids", [] { return MakeGrid(Pyramids(4).Map(Bent)); } },
    { "Image", [] { return MakeImage(6); } } };
}

class Allocations : public BuiltLocator
{
protected:
  Allocations()
  {
    Random random(150);
    for (int i = 0; i < 200; ++i)
    {
      this->Points.push_back(random.InBox(Grown(this->Box, 0.1 * Diagonal(this->Box))));
    }
  }

  /// Runs the query once for each pair of points to fill lists and caches, then counts.
  template <typename Query>
  int Count(Query&& query)
  {
    const auto runAll = [&]
    {
      for (std::size_t i = 0; i + 1 < this->Points.size(); ++i)
      {
        query(this->Points[i].data(), this->Points[i + 1].data());
      }
    };
    runAll();
    NumberOfAllocations = 0;
    IsCounting = true;
    runAll();
    IsCounting = false;
    return NumberOfAllocations;
  }

  std::vector<Point> Points;
  Point X, Pcoords;
  double T = 0.0;
  double Dist2 = 0.0;
  vtkIdType Cell = -1;
  int SubId = 0;
  double Weights[64];
  vtkNew<vtkIdList> List;
  vtkNew<vtkIdList> OtherList;
  vtkNew<vtkPoints> PointList;
  vtkNew<vtkDoubleArray> Distances;
};

INSTANTIATE_TEST_SUITE_P(Kernels, Allocations, testing::ValuesIn(KernelMeshes()), NameOfMesh());

TEST_P(Allocations, InsideLibrariesAreCounted)
{
  EXPECT_GT(this->Count([](double*, double*) { vtkNew<vtkIdList> list; }), 0);
}

TEST_P(Allocations, OfClosestPointAreNone)
{
  EXPECT_EQ(this->Count(
              [this](double* x, double*) {
                this->Locator->FindClosestPoint(
                  x, this->X.data(), this->Cell, this->SubId, this->Dist2);
              }),
    0);
}

TEST_P(Allocations, OfClosestPointWithinRadiusAreNone)
{
  EXPECT_EQ(this->Count(
              [this](double* x, double*)
              {
                this->Locator->FindClosestPointWithinRadius(
                  x, 0.3, this->X.data(), this->Cell, this->SubId, this->Dist2);
              }),
    0);
}

TEST_P(Allocations, OfFirstHitAreNone)
{
  EXPECT_EQ(this->Count(
              [this](double* a, double* b)
              {
                this->Locator->IntersectWithLine(a, b, 0.0, this->T, this->X.data(),
                  this->Pcoords.data(), this->SubId, this->Cell, nullptr);
              }),
    0);
}

TEST_P(Allocations, OfFindCellAreNone)
{
  EXPECT_EQ(this->Count(
              [this](double* x, double*)
              {
                this->Locator->FindCell(x);
                this->Locator->FindCell(x, 0.01);
                this->Locator->FindCell(
                  x, 0.01, nullptr, this->SubId, this->Pcoords.data(), this->Weights);
              }),
    0);
}

TEST_P(Allocations, OfFindCellWithHintAreNone)
{
  EXPECT_EQ(this->Count(
              [this](double* x, double*)
              {
                this->Cell = this->Locator->FindCellWithHint(
                  x, 0.0, this->Cell, nullptr, this->SubId, this->Pcoords.data(), this->Weights);
              }),
    0);
}

TEST_P(Allocations, OfBoundsQueriesAreNone)
{
  EXPECT_EQ(this->Count(
              [this](double* a, double* b)
              {
                Bounds box = EmptyBounds();
                Extend(box, { a[0], a[1], a[2] });
                Extend(box, { b[0], b[1], b[2] });
                this->Locator->FindCellsWithinBounds(box.data(), this->List);
                this->Locator->FindCellsAlongPlane(a, b, 0.0, this->List);
                this->Locator->InsideCellBounds(a, 0);
              }),
    0);
}

TEST_P(Allocations, OfCountCrossingsAreNone)
{
  EXPECT_EQ(this->Count([this](double* a, double* b) { this->Locator->CountCrossings(a, b); }), 0);
}

TEST_P(Allocations, OfCrossingsAreNone)
{
  EXPECT_EQ(this->Count(
              [this](double* a, double* b)
              {
                this->Locator->FindCrossings(a, b, nullptr, nullptr, nullptr, nullptr);
                this->Locator->FindCrossings(a, b, this->Distances, nullptr, nullptr, nullptr);
              }),
    0);
}

TEST_P(Allocations, OfAllHitsAreNone)
{
  vtkNew<vtkGenericCell> cell;
  EXPECT_EQ(this->Count(
              [&](double* a, double* b)
              {
                this->Locator->IntersectWithLine(a, b, 0.0, nullptr, this->List, cell);
                this->Locator->FindCellsAlongLine(a, b, 0.0, this->List);
              }),
    0);
}

TEST_P(Allocations, OfNeighboursAreNone)
{
  EXPECT_EQ(this->Count(
              [this](double* x, double*)
              {
                this->Locator->FindClosestCells(x, 5, this->List, this->Distances);
                this->Locator->FindCellsWithinRadius(x, 0.3, this->List, this->Distances);
              }),
    0);
}

TEST_P(Allocations, OfCandidatesAreNone)
{
  EXPECT_EQ(this->Count(
              [this](double* a, double* b)
              {
                this->Locator->FindClosestCandidates(a, this->List);
                this->Locator->FindCandidatesAlongLine(a, b, this->List);
                this->Locator->FindCandidatesWithinRadius(a, 0.2, this->List);
                this->Locator->FindCandidatesAlongPlane(a, b, this->List);
              }),
    0);
}

/// VTK's loops on this thread, which counts: its threads allocate for each part of a loop.
class OnThisThread
{
public:
  OnThisThread() { vtkSMPTools::SetBackend("Sequential"); }
  ~OnThisThread() { vtkSMPTools::SetBackend(this->Former.c_str()); }
  OnThisThread(const OnThisThread&) = delete;
  void operator=(const OnThisThread&) = delete;

private:
  std::string Former = vtkSMPTools::GetBackend();
};

TEST_P(Allocations, OfBatchesDoNotGrowWithTheNumberOfQueries)
{
  const OnThisThread loops;
  vtkNew<vtkIdTypeArray> ids;
  const auto count = [&](int number)
  {
    vtkNew<vtkDoubleArray> points;
    points->SetNumberOfComponents(3);
    for (int i = 0; i < number; ++i)
    {
      points->InsertNextTuple(this->Points[static_cast<std::size_t>(i) % 200].data());
    }
    this->Locator->FindClosestPoints(points, ids, this->Distances, nullptr);
    NumberOfAllocations = 0;
    IsCounting = true;
    this->Locator->FindClosestPoints(points, ids, this->Distances, nullptr);
    this->Locator->FindCells(points, ids, nullptr);
    IsCounting = false;
    return NumberOfAllocations;
  };
  const int few = count(2000);
  EXPECT_GT(few, 0) << "the order of the queries is made";
  EXPECT_LE(count(20000), few);
}

}
