// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Inputs that change in time, on any port: filters have the times of all of them, execute again for
// each, and answer as if the inputs were static at that time.

#include "Support/FilterRun.h"
#include "Support/FilterZoo.h"
#include "Support/SurfaceMeshes.h"
#include "Support/TimeSource.h"
#include "Support/VolumeMeshes.h"

#include "vtkSkdTreeAMR.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

using namespace skdtest;

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;
using Steps = std::vector<double>;

const Steps OfInput{ 0.0, 1.0, 2.0 };
const Steps OfSource{ 0.0, 0.5, 1.5 };
const Steps OfBoth{ 0.0, 0.5, 1.0, 1.5, 2.0 };

/// A filter whose inputs on some ports are of meshes in time.
class TimedFilter
{
public:
  explicit TimedFilter(vtkAlgorithm* filter)
    : Filter(filter)
  {
  }

  /// The input of a port, and others that are the same, change at the steps.
  void Move(int port, const Steps& steps)
  {
    vtkDataObject* data = this->Filter->GetInputDataObject(port, 0);
    auto* mesh = vtkPointSet::SafeDownCast(data);
    ASSERT_NE(mesh, nullptr);
    vtkNew<TimeSource> source;
    source->Set(mesh, steps);
    this->Filter->SetInputConnection(port, source->GetOutputPort());
    this->Sources[port] = source;
  }

  std::vector<double> AnswersAt(double time)
  {
    this->Filter->UpdateTimeStep(time);
    return AnswersOf(this->Filter);
  }

  Steps GetSteps()
  {
    this->Filter->UpdateInformation();
    vtkInformation* output = this->Filter->GetOutputInformation(0);
    const double* steps = output->Get(Pipeline::TIME_STEPS());
    const int number = output->Length(Pipeline::TIME_STEPS());
    const double* range = output->Get(Pipeline::TIME_RANGE());
    EXPECT_NE(range, nullptr);
    EXPECT_TRUE(range && range[0] == steps[0] && range[1] == steps[number - 1]);
    return Steps(steps, steps + number);
  }

  double StepOf(int port, double time) const
  {
    const auto found = this->Sources.find(port);
    return found == this->Sources.end() ? 0.0 : found->second->StepAt(time);
  }

private:
  vtkSmartPointer<vtkAlgorithm> Filter;
  std::map<int, vtkSmartPointer<TimeSource>> Sources;
};

/// A filter with static inputs, moved as they are at a time.
std::vector<double> ExpectedAt(vtkAlgorithm* filter, const TimedFilter& timed, double time)
{
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    if (auto* mesh = vtkPointSet::SafeDownCast(filter->GetNumberOfInputConnections(port) > 0
            ? filter->GetInputDataObject(port, 0)
            : nullptr))
    {
      filter->SetInputDataObject(port, MovedTo(mesh, timed.StepOf(port, time)));
    }
  }
  filter->Update();
  return AnswersOf(filter);
}

bool AreEqual(const std::vector<double>& a, const std::vector<double>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// Meshes that have what the setups look for.
vtkSmartPointer<vtkPointSet> MeshFor(const std::string& setup)
{
  if (setup.find("Curve") != std::string::npos && setup != "CurveOnSurface")
  {
    Mesh lines;
    Ids ids;
    for (int i = 0; i < 8; ++i)
    {
      ids.push_back(lines.Add({ 0.3 * i, 0.2 + 2.1 * (i % 2), 0.4 + 0.21 * i }));
    }
    lines.Add(VTK_POLY_LINE, ids);
    return WithData(MakePolyData(lines));
  }
  if (setup == "RemapOf" || setup == "ProbeOf" || setup == "RemapFor" || setup == "InOutOfCells")
  {
    return WithData(MakeGrid(Transformed(Hexahedra(2), 1.1, { 0.1, 0.2, 0.3 })));
  }
  return WithData(MakePolyData(Transformed(SphereTriangles(3), 0.7, { 1.01, 1.17, 1.13 })));
}

class InTime : public testing::TestWithParam<FilterSetup>
{
protected:
  vtkSmartPointer<vtkPointSet> Mesh = MeshFor(GetParam().Name);

  vtkSmartPointer<vtkAlgorithm> Make() const { return GetParam().Make(this->Mesh); }

  std::vector<int> PortsWithMeshes() const
  {
    std::vector<int> ports;
    const auto filter = this->Make();
    for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
    {
      if (filter->GetNumberOfInputConnections(port) > 0)
      {
        ports.push_back(port);
      }
    }
    return ports;
  }

  void ExpectAnswers(TimedFilter& timed, const Steps& times) const
  {
    for (const double time : times)
    {
      EXPECT_TRUE(AreEqual(timed.AnswersAt(time), ExpectedAt(this->Make(), timed, time)))
        << "at " << time;
    }
  }
};

TEST_P(InTime, EachPortAlone)
{
  for (const int port : this->PortsWithMeshes())
  {
    SCOPED_TRACE(port);
    TimedFilter timed(this->Make());
    timed.Move(port, OfSource);
    EXPECT_EQ(timed.GetSteps(), OfSource);
    this->ExpectAnswers(timed, { 0.0, 1.5, 0.5, 0.0 });
  }
}

// At 0.5 the Input is that of 0.0, and so is its mark of time: at 0.0 the Source differs.
TEST_P(InTime, AllPortsWithTheirOwnSteps)
{
  const std::vector<int> ports = this->PortsWithMeshes();
  TimedFilter timed(this->Make());
  for (const int port : ports)
  {
    timed.Move(port, port == 0 ? OfInput : OfSource);
  }
  EXPECT_EQ(timed.GetSteps(), ports.size() > 1 ? OfBoth : OfInput);
  this->ExpectAnswers(timed, { 0.0, 0.5, 0.0, 1.0, 1.5, 2.0 });
}

// The answers change with the mesh: what is compared above is not always the same. Those of a few
// setups are too coarse for that.
TEST(InTimeTogether, AnswersChange)
{
  const std::set<std::string> coarse{ "AMRField", "CurveIntersection", "CurveIntersectionBy",
    "CurveWithItself", "InOutOf", "QueryBySphere", "RefinementAt", "RefinementOnto" };
  for (const FilterSetup& setup : AllFilterSetups())
  {
    const auto mesh = MeshFor(setup.Name);
    const auto first = setup.Make(mesh);
    const auto second = setup.Make(MovedTo(mesh, 1.0));
    first->Update();
    second->Update();
    EXPECT_EQ(AreEqual(AnswersOf(first), AnswersOf(second)), coarse.count(setup.Name) > 0)
      << setup.Name;
  }
}

INSTANTIATE_TEST_SUITE_P(Filters, InTime, testing::ValuesIn(AllFilterSetups()),
  [](const auto& info) { return info.param.Name; });

// The third port.
TEST(InTimeTogether, FieldOfAGrid)
{
  const auto field = WithData(MakeGrid(Transformed(Hexahedra(2), 1.2, { 0.0, 0.0, 0.0 })));
  const auto parts = MakePolyData(Transformed(SphereTriangles(2), 0.8, { 1.21, 1.27, 1.23 }));
  const auto make = [&]() -> vtkSmartPointer<vtkAlgorithm>
  {
    auto filter = vtkSmartPointer<vtkSkdTreeAMR>::New();
    filter->SetInputDataObject(0, parts);
    filter->SetFieldData(field);
    filter->AddFieldArray("Linear");
    filter->SetMaximumLevel(3);
    filter->AutomaticBoundsOff();
    filter->SetBaseBounds(-0.31, 2.83, -0.37, 2.89, -0.33, 2.81);
    filter->SetOutputType(vtkSkdTreeAMR::UNSTRUCTURED_GRID);
    return filter;
  };
  TimedFilter timed(make());
  timed.Move(2, OfSource);
  EXPECT_EQ(timed.GetSteps(), OfSource);
  std::vector<std::vector<double>> all;
  for (const double time : { 0.0, 1.5, 0.5 })
  {
    all.push_back(timed.AnswersAt(time));
    EXPECT_TRUE(AreEqual(all.back(), ExpectedAt(make(), timed, time))) << time;
  }
  EXPECT_FALSE(AreEqual(all[0], all[1]));
}

}
