// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmbreeDevice.h"
#include "Pairs.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <limits>
#include <mutex>

namespace skdbench
{
namespace
{

using namespace skdtest;

/// The boxes of the cells of a data set as Embree takes them: rounded outward to floats.
class Boxes
{
public:
  ~Boxes() { this->Release(); }

  void Build(vtkDataSet* data)
  {
    this->Release();
    this->Bounds.resize(static_cast<std::size_t>(data->GetNumberOfCells()));
    for (std::size_t cell = 0; cell < this->Bounds.size(); ++cell)
    {
      data->GetCellBounds(static_cast<vtkIdType>(cell), this->Bounds[cell].data());
    }
    this->Scene = rtcNewScene(EmbreeDevice());
    RTCGeometry geometry = rtcNewGeometry(EmbreeDevice(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(this->Bounds.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, Tell, nullptr);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->Scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(this->Scene);
  }

  RTCScene Scene = nullptr;
  std::vector<skdtest::Bounds> Bounds;

private:
  void Release()
  {
    if (this->Scene)
    {
      rtcReleaseScene(this->Scene);
      this->Scene = nullptr;
    }
  }

  static float Down(double x)
  {
    return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::lowest());
  }
  static float Up(double x)
  {
    return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::max());
  }

  static void Tell(const RTCBoundsFunctionArguments* arguments)
  {
    const auto* boxes = static_cast<const Boxes*>(arguments->geometryUserPtr);
    const skdtest::Bounds& box = boxes->Bounds[arguments->primID];
    RTCBounds* told = arguments->bounds_o;
    told->lower_x = Down(box[0]);
    told->upper_x = Up(box[1]);
    told->lower_y = Down(box[2]);
    told->upper_y = Up(box[3]);
    told->lower_z = Down(box[4]);
    told->upper_z = Up(box[5]);
  }
};

/// rtcCollide names candidates; what decides is their boxes in double, as an application would.
class EmbreePairs : public PairFinder
{
public:
  bool Build(vtkDataSet* first, vtkDataSet* second) override
  {
    this->First.Build(first);
    this->Second.Build(second);
    return rtcGetDeviceError(EmbreeDevice()) == RTC_ERROR_NONE;
  }

  bool FindBoxes() override
  {
    this->Pairs.clear();
    rtcCollide(this->First.Scene, this->Second.Scene, Take, this);
    return true;
  }

  PairList BoxPairs() const override { return this->Pairs; }

  bool FindTriangles(vtkDataSet*, vtkDataSet*) override { return false; }
  PairList TrianglePairs() const override { return {}; }

private:
  static void Take(void* self, RTCCollision* candidates, unsigned count)
  {
    auto* finder = static_cast<EmbreePairs*>(self);
    const std::lock_guard<std::mutex> lock(finder->Taking);
    for (unsigned i = 0; i < count; ++i)
    {
      const RTCCollision& candidate = candidates[i];
      if (Overlap(
            finder->First.Bounds[candidate.primID0], finder->Second.Bounds[candidate.primID1]))
      {
        finder->Pairs.emplace_back(candidate.primID0, candidate.primID1);
      }
    }
  }

  Boxes First;
  Boxes Second;
  PairList Pairs;
  std::mutex Taking;
};

}

PairKind EmbreePairKind()
{
  return { "Embree rtcCollide", Family::Peer,
    []() -> std::unique_ptr<PairFinder> { return std::make_unique<EmbreePairs>(); } };
}

}
