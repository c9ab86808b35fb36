// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdLocatorState_h
#define SkdLocatorState_h

#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdMeshSnapshot.h"
#include "Cells/Read/SkdMeshTime.h"
#include "Cells/Search/SkdCellTree.h"

#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>

namespace skdtree
{
inline skd::Vector3 SkdVector(const double x[3])
{
  return { { x[0], x[1], x[2] } };
}

inline void SkdStore(const skd::Vector3& from, double to[3])
{
  std::copy(from.X, from.X + 3, to);
}

/// The plane with a normal of any length; one of no length gives a plane that nothing meets.
inline skd::Plane<3> SkdPlane(const double origin[3], const double normal[3])
{
  const skd::Vector3 direction = SkdVector(normal);
  return { SkdVector(origin), (1.0 / skd::Norm(direction)) * direction };
}

/// The state of a locator: a tree, shared with its shallow copies, and the motion of its set.
class SkdLocatorState
{
public:
  std::mutex Building;
  double BuildSeconds = 0.0;
  std::optional<skd::RigidMotion> Motion;
  vtkNew<vtkMatrix4x4> Matrix; // of the motion, as it was given

  /// nullptr before a tree is built. Thread-safe, also during a build.
  const SkdCellTree* GetTree() const { return this->Ready.load(std::memory_order_acquire); }
  const std::shared_ptr<const SkdCellTree>& ShareTree() const { return this->Tree; }
  void SetTree(std::shared_ptr<const SkdCellTree> tree)
  {
    this->Ready.store(nullptr, std::memory_order_release);
    this->Tree = std::move(tree);
    this->Ready.store(this->Tree.get(), std::memory_order_release);
  }

  ///@{
  /// The mesh that the tree was built on, in order to notice later that it changed. Kept is false
  /// without a data set, and of types that cannot be compared. CheckTime is when the data set was
  /// last found to be that mesh; thread-safe.
  void Keep(vtkDataSet* mesh)
  {
    auto snapshot = std::make_shared<SkdMeshSnapshot>();
    if (mesh)
    {
      snapshot->KeepArrays(mesh);
    }
    const bool isComparable = mesh && snapshot->IsSameAs(mesh);
    this->Snapshot = isComparable ? std::move(snapshot) : nullptr;
    vtkTimeStamp now;
    now.Modified();
    this->CheckTime = isComparable ? now.GetMTime() : 0;
    this->Watch(mesh);
  }
  void Forget()
  {
    this->Snapshot = nullptr;
    this->CheckTime = 0;
    this->MeshTime.Watch(nullptr);
    this->SetForeign(nullptr);
  }
  void KeepAs(const SkdLocatorState& other)
  {
    this->Snapshot = other.Snapshot;
    this->CheckTime = other.CheckTime.load();
  }
  /// From now on the tree is used for this mesh, with equal points, perhaps another's.
  void Watch(vtkDataSet* mesh)
  {
    this->MeshTime.Watch(mesh);
    this->SetForeign(this->Tree ? this->Tree->Cells().PointsOfAnother(mesh) : nullptr);
  }
  /// Whether the other mesh, whose points the tree reads, has changed them. Thread-safe, also while
  /// another thread frees the tree.
  bool AreForeignPointsModified() const
  {
    return this->HasForeign.load(std::memory_order_relaxed) && this->IsForeignModified();
  }
  bool HasSnapshot() const { return this->Snapshot != nullptr; }
  bool IsBuiltOn(vtkDataSet* mesh) const
  {
    return this->Snapshot && mesh && this->Snapshot->IsSameAs(mesh);
  }
  vtkMTimeType GetCheckTime() const { return this->CheckTime; }
  /// When the mesh was last modified, as queries ask for it.
  vtkMTimeType TimeOf(vtkDataSet* mesh) const { return this->MeshTime.Of(mesh); }
  ///@}

  skd::Vector3 ToTree(const double x[3]) const
  {
    return this->Motion ? this->Motion->Back(SkdVector(x)) : SkdVector(x);
  }
  skd::Segment<3> ToTree(const double p1[3], const double p2[3]) const
  {
    const skd::Segment<3> segment{ SkdVector(p1), SkdVector(p2) };
    return this->Motion
      ? skd::Segment<3>{ this->Motion->Back(segment.A), this->Motion->Back(segment.B) }
      : segment;
  }
  skd::Vector3 ToWorld(const skd::Vector3& x) const
  {
    return this->Motion ? this->Motion->Forward(x) : x;
  }
  const skd::RigidMotion* GetMotion() const { return this->Motion ? &*this->Motion : nullptr; }

  /// The motion, or the identity.
  skd::RigidMotion GetMotionOrNone() const
  {
    constexpr skd::RigidMotion none{
      { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, { { 0.0, 0.0, 1.0 } } }, { { 0.0, 0.0, 0.0 } }
    };
    return this->Motion ? *this->Motion : none;
  }

  /// Loads a cell of the answer for the caller, transformed by the motion: from the data set, or
  /// faster from the tree, unless that is used unchecked.
  void Load(const SkdCellTree& tree, bool usesExisting, vtkDataSet* data, vtkIdType id,
    vtkGenericCell* cell) const
  {
    if (!cell || id < 0)
    {
      return;
    }
    const bool isChecked = !usesExisting || this->CheckTime != 0;
    if (!isChecked || !SkdHasPlainCells(data) || !tree.Load(id, cell))
    {
      SkdLoadCell(data, id, cell);
    }
    vtkPoints* points = cell->GetPoints();
    for (vtkIdType i = 0; this->Motion && i < points->GetNumberOfPoints(); ++i)
    {
      double x[3];
      points->GetPoint(i, x);
      points->SetPoint(i, this->Motion->Forward(SkdVector(x)).X);
    }
  }

private:
  SKD_NOINLINE bool IsForeignModified() const
  {
    const std::lock_guard<std::mutex> lock(this->WatchingForeign);
    return this->Foreign && this->Foreign->GetMTime() > this->CheckTime;
  }
  void SetForeign(vtkPoints* points)
  {
    const std::lock_guard<std::mutex> lock(this->WatchingForeign);
    this->Foreign = points;
    this->HasForeign.store(points != nullptr, std::memory_order_relaxed);
  }

  std::shared_ptr<const SkdCellTree> Tree;
  std::atomic<const SkdCellTree*> Ready{ nullptr };
  std::shared_ptr<const SkdMeshSnapshot> Snapshot; // shared with shallow copies
  std::atomic<vtkMTimeType> CheckTime{ 0 };
  SkdMeshTime MeshTime;
  mutable std::mutex WatchingForeign;
  vtkSmartPointer<vtkPoints> Foreign;
  std::atomic<bool> HasForeign{ false };
};
}

#endif
