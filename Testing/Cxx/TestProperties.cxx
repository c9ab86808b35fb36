// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers that a property cannot have are refused, by one rule for all properties of all classes.

#include "Support/EventCounter.h"
#include "Support/Folders.h"

#include "vtkNew.h"
#include "vtkSkdTreeAMR.h"
#include "vtkSkdTreeAttach.h"
#include "vtkSkdTreeCellLocator.h"
#include "vtkSkdTreeClosestPoint.h"
#include "vtkSkdTreeCurveIntersection.h"
#include "vtkSkdTreeCurveSurfaceIntersection.h"
#include "vtkSkdTreeMeshAdaptation.h"
#include "vtkSkdTreeMeshRefinement.h"
#include "vtkSkdTreePointInOut.h"
#include "vtkSkdTreeProbe.h"
#include "vtkSkdTreeRemap.h"
#include "vtkSkdTreeRepresentation.h"
#include "vtkSkdTreeSpatialQuery.h"
#include "vtkSkdTreeSurfaceIntersection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

using namespace skdtest;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
const double NotANumber = std::nan("");

/// That an object refuses a value with one error that names the property, the value and an end of
/// the range, and is as it was.
class Refusal
{
public:
  Refusal(vtkObject* object, std::string name)
    : Object(object)
    , Name(std::move(name))
    , Before(object->GetMTime())
    , Events(object)
  {
  }

  void Check(double value, double end) const
  {
    SCOPED_TRACE(this->Object->GetClassName() + ("::" + this->Name) + " " + TextOf(value));
    EXPECT_EQ(this->Events.Errors, 1);
    EXPECT_EQ(this->Object->GetMTime(), this->Before);
    for (const std::string& part : { this->Name, TextOf(value), TextOf(end) })
    {
      EXPECT_NE(this->Events.Error.find(part), std::string::npos) << this->Events.Error;
    }
  }

private:
  static std::string TextOf(double value)
  {
    std::ostringstream text;
    text << value;
    return text.str();
  }

  vtkObject* Object;
  std::string Name;
  vtkMTimeType Before;
  EventCounter Events;
};

/// A property of one number, with a range.
template <class Object>
struct Number
{
  const char* Name;
  void (Object::*Set)(double);
  double (Object::*Get)();
  double Least;
  double Most;
};

template <class Object>
void ExpectRefused(const std::vector<Number<Object>>& numbers)
{
  for (const Number<Object>& number : numbers)
  {
    const double below = number.Least == 0.0 ? -1e-300 : std::nextafter(number.Least, -Infinity);
    const double above = number.Most == VTK_DOUBLE_MAX ? Infinity : 1.0001 * number.Most;
    for (const double value : { NotANumber, Infinity, -Infinity, below, above })
    {
      vtkNew<Object> object;
      (object->*number.Set)(number.Least);
      const Refusal refusal(object, number.Name);
      (object->*number.Set)(value);
      refusal.Check(value, value < number.Least ? number.Least : number.Most);
      EXPECT_EQ((object->*number.Get)(), number.Least);
    }
    vtkNew<Object> object;
    EventCounter events(object);
    for (const double value : { number.Least, number.Most, 0.5 * number.Most })
    {
      (object->*number.Set)(value);
      EXPECT_EQ((object->*number.Get)(), value);
    }
    EXPECT_EQ(events.Errors + events.Warnings, 0);
  }
}

/// A property of several numbers, all of them finite.
template <class Object>
struct Numbers
{
  const char* Name;
  int Size;
  void (Object::*Set)(const double*);
  double* (Object::*Get)();
};

template <class Object>
void ExpectRefused(const std::vector<Numbers<Object>>& properties)
{
  for (const Numbers<Object>& property : properties)
  {
    for (int i = 0; i < property.Size; ++i)
    {
      for (const double value : { NotANumber, Infinity, -Infinity })
      {
        vtkNew<Object> object;
        const std::vector<double> good = { 1, 2, 3, 4, 5, 6 };
        (object->*property.Set)(good.data());
        const Refusal refusal(object, property.Name);
        std::vector<double> bad = good;
        bad[i] = value;
        (object->*property.Set)(bad.data());
        refusal.Check(value, std::numeric_limits<double>::max());
        EXPECT_TRUE(
          std::equal(good.begin(), good.begin() + property.Size, (object->*property.Get)()));
      }
    }
  }
}

#define WITHIN(name, least, most)                                                                  \
  {                                                                                                \
#name, &Object::Set##name, &Object::Get##name, least, most                                     \
  }
#define FINITE(name, size)                                                                         \
  {                                                                                                \
#name, size, &Object::Set##name, &Object::Get##name                                            \
  }

TEST(Properties, OfTheLocatorRefuseWhatTheyCannotBe)
{
  {
    using Object = vtkSkdTreeCellLocator;
    ExpectRefused<Object>({ WITHIN(Epsilon, 0, 1) });
  }
  {
    using Object = vtkSkdTreeAttach;
    ExpectRefused<Object>({ WITHIN(Epsilon, 0, 1) });
  }
  {
    using Object = vtkSkdTreeRepresentation;
    ExpectRefused<Object>({ WITHIN(Epsilon, 0, 1) });
  }
}

TEST(Properties, OfFiltersThatAskAMeshRefuseWhatTheyCannotBe)
{
  {
    using Object = vtkSkdTreeClosestPoint;
    ExpectRefused<Object>({ WITHIN(Epsilon, 0, 1), WITHIN(MaximumDistance, 0, VTK_DOUBLE_MAX) });
  }
  {
    using Object = vtkSkdTreeProbe;
    ExpectRefused<Object>({ WITHIN(Epsilon, 0, 1), WITHIN(MaximumDistance, 0, VTK_DOUBLE_MAX),
      WITHIN(RelativeTolerance, 0, VTK_DOUBLE_MAX), WITHIN(AbsoluteTolerance, 0, VTK_DOUBLE_MAX) });
  }
  {
    using Object = vtkSkdTreeRemap;
    ExpectRefused<Object>({ WITHIN(MinimumCoverage, 0, 1),
      WITHIN(ExtrapolationConstant, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX) });
  }
  {
    using Object = vtkSkdTreeMeshAdaptation;
    ExpectRefused<Object>({ WITHIN(Strength, 0, 1e6), WITHIN(MaximumRatio, 1, 1e9),
      WITHIN(FeatureAngle, 0, 180), WITHIN(Tolerance, 0, VTK_DOUBLE_MAX),
      WITHIN(Relaxation, 0.01, 1), WITHIN(MinimumQuality, 0, 0.9) });
  }
  {
    using Object = vtkSkdTreePointInOut;
    ExpectRefused<Object>({ WITHIN(Epsilon, 0, 1), WITHIN(BoundaryBand, 0, VTK_DOUBLE_MAX) });
  }
  {
    using Object = vtkSkdTreeSpatialQuery;
    ExpectRefused<Object>({ WITHIN(Epsilon, 0, 1), WITHIN(Tolerance, 0, VTK_DOUBLE_MAX),
      WITHIN(SphereRadius, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX) });
    ExpectRefused<Object>(std::vector<Numbers<Object>>{ FINITE(BoxPosition, 3),
      FINITE(BoxLength, 3), FINITE(BoxRotation, 3), FINITE(ReferenceBounds, 6),
      FINITE(SphereCenter, 3), FINITE(PlaneOrigin, 3), FINITE(PlaneNormal, 3),
      FINITE(LinePoint1, 3), FINITE(LinePoint2, 3) });
  }
}

TEST(Properties, OfFiltersThatIntersectRefuseWhatTheyCannotBe)
{
  {
    using Object = vtkSkdTreeSurfaceIntersection;
    ExpectRefused<Object>({ WITHIN(Clearance, 0, VTK_DOUBLE_MAX) });
    ExpectRefused<Object>(std::vector<Numbers<Object>>{
      FINITE(Translation, 3), FINITE(Rotation, 3), FINITE(RotationCenter, 3) });
  }
  {
    using Object = vtkSkdTreeCurveIntersection;
    ExpectRefused<Object>(
      { WITHIN(Epsilon, 0, 1), WITHIN(ChordTolerance, 0, 1), WITHIN(Clearance, 0, VTK_DOUBLE_MAX),
        WITHIN(Tension, -1, 1), WITHIN(Bias, -1, 1), WITHIN(Continuity, -1, 1) });
  }
  {
    using Object = vtkSkdTreeCurveSurfaceIntersection;
    ExpectRefused<Object>({ WITHIN(Epsilon, 0, 1), WITHIN(ChordTolerance, 0, 1),
      WITHIN(Tension, -1, 1), WITHIN(Bias, -1, 1), WITHIN(Continuity, -1, 1) });
  }
}

TEST(Properties, OfFiltersThatRefineRefuseWhatTheyCannotBe)
{
  {
    using Object = vtkSkdTreeAMR;
    ExpectRefused<Object>(
      { WITHIN(BoundsMargin, 0, 1e6), WITHIN(BaseCellSize, 0, VTK_DOUBLE_MAX) });
    ExpectRefused<Object>(std::vector<Numbers<Object>>{ FINITE(BaseBounds, 6) });
  }
  {
    using Object = vtkSkdTreeMeshRefinement;
    ExpectRefused<Object>(std::vector<Numbers<Object>>{ FINITE(SphereCenter, 3) });
  }
  {
    using Object = vtkSkdTreeRefineAlgorithm;
    const auto check = [](auto number)
    {
      for (const double value : { NotANumber, Infinity, -1e-9 })
      {
        vtkNew<vtkSkdTreeAMR> amr;
        const Refusal refusal(amr, number.Name);
        (amr->*number.Set)(value);
        refusal.Check(value, number.Most);
      }
    };
    check(Number<Object> WITHIN(Epsilon, 0, 1));
    check(Number<Object> WITHIN(NormalDeviation, 0, 180));
    check(Number<Object> WITHIN(FieldThreshold, 0, VTK_DOUBLE_MAX));
    vtkNew<vtkSkdTreeAMR> amr;
    const Refusal refusal(amr, "FieldRange");
    amr->SetFieldRange(0.0, NotANumber);
    refusal.Check(NotANumber, std::numeric_limits<double>::max());
  }
}

TEST(Properties, DistanceBandsThatAreNoneAreRefused)
{
  for (const auto& [distance, level] : { std::pair(NotANumber, 3.0), std::pair(-1.0, 3.0),
         std::pair(Infinity, 3.0), std::pair(1.0, NotANumber), std::pair(1.0, 31.0) })
  {
    vtkNew<vtkSkdTreeAMR> amr;
    EventCounter events(amr);
    amr->AddDistanceBand(distance, level);
    EXPECT_EQ(events.Errors, 1);
    EXPECT_NE(events.Error.find("band"), std::string::npos);
    std::ostringstream text;
    amr->Print(text);
    EXPECT_EQ(text.str().find("DistanceBand"), std::string::npos);
  }
}

TEST(Properties, ARayMustBeCast)
{
  vtkNew<vtkSkdTreePointInOut> filter;
  for (const int rays : { 0, -7, 1001 })
  {
    const Refusal refusal(filter, "NumberOfRays");
    const int before = filter->GetNumberOfRays();
    filter->SetNumberOfRays(rays);
    refusal.Check(rays, 1000);
    EXPECT_EQ(filter->GetNumberOfRays(), before);
  }
}

/// VTK's own macros let NaN pass.
TEST(Properties, OfDoublesAreAllSetByTheOneRule)
{
  const std::filesystem::path folder = std::filesystem::path(DataFolder()) / ".." / "Filters";
  const std::regex setter(R"(vtkSet(?:Clamp|Vector\d|)Macro\((\w+), double|void Set(\w+)\(double)");
  int headers = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    const std::string name = entry.path().filename().string();
    if (name.rfind("vtkSkdTree", 0) != 0 || entry.path().extension() != ".h" ||
      name == "vtkSkdTreeSetWithin.h")
    {
      continue;
    }
    ++headers;
    std::ifstream file(entry.path());
    const std::string text{ std::istreambuf_iterator<char>(file), {} };
    for (std::sregex_iterator at(text.begin(), text.end(), setter), end; at != end; ++at)
    {
      const std::string property = (*at)[1];
      EXPECT_TRUE(property == "FillValue" || property == "MissingValue")
        << name << ", " << property << ": only these may be any number, NaN too";
    }
  }
  EXPECT_GT(headers, 12);
}

}
