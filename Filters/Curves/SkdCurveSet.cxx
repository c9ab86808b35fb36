// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdCurveSet.h"

#include "Cells/Curved/SkdBezierCell.h"
#include "Core/Curves/ArcLength.h"
#include "Core/Curves/BernsteinBasis.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkCardinalSpline.h"
#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkKochanekSpline.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"

#include <cmath>

namespace skdtree
{
namespace
{
constexpr double LeastLength = 1e-140; // of what has squares, and a largest length of its inverse

std::vector<skd::Vector3> PointsOf(vtkCell* cell)
{
  std::vector<skd::Vector3> points(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    cell->GetPoints()->GetPoint(static_cast<vtkIdType>(i), points[i].X);
  }
  return points;
}

bool AreFinite(const std::vector<skd::Vector3>& points)
{
  for (const skd::Vector3& point : points)
  {
    if (!skd::IsFinite(point))
    {
      return false;
    }
  }
  return true;
}

/// The chord lengths from the first of some points; points that follow an equal one have none.
struct Knots
{
  std::vector<double> At{ 0.0 };
  std::vector<std::size_t> Numbers{ 0 }; ///< of the points

  explicit Knots(const std::vector<skd::Vector3>& points)
  {
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      const double length = std::sqrt(skd::Distance2(points[i], points[this->Numbers.back()]));
      if (length > 0.0)
      {
        this->At.push_back(this->At.back() + length);
        this->Numbers.push_back(i);
      }
    }
  }

  /// With a coordinate of the points, seen from the first. A closed spline adds its end itself.
  std::vector<double> PairsWith(
    const std::vector<skd::Vector3>& points, int axis, bool isClosed) const
  {
    std::vector<double> pairs;
    for (std::size_t i = 0; i < this->At.size() - (isClosed ? 1 : 0); ++i)
    {
      pairs.insert(pairs.end(), { this->At[i], points[this->Numbers[i]][axis] - points[0][axis] });
    }
    return pairs;
  }
};

/// A spline that is filled at once: AddPoint() sorts all points each time.
template <class Base>
class FilledSpline : public Base
{
public:
  static vtkSmartPointer<Base> Make(std::vector<double>& pairs)
  {
    auto* made = new FilledSpline;
    made->InitializeObjectBase();
    made->PiecewiseFunction->FillFromDataPointer(static_cast<int>(pairs.size() / 2), pairs.data());
    return vtkSmartPointer<Base>::Take(made);
  }
};

vtkSmartPointer<vtkSpline> MakeOpenSpline(const SkdPolylineForm& form, std::vector<double>& pairs)
{
  if (form.Kind == SkdPolylineForm::Cardinal)
  {
    return FilledSpline<vtkCardinalSpline>::Make(pairs);
  }
  const auto spline = FilledSpline<vtkKochanekSpline>::Make(pairs);
  spline->SetDefaultTension(form.Tension);
  spline->SetDefaultBias(form.Bias);
  spline->SetDefaultContinuity(form.Continuity);
  return spline;
}

/// The spline through (knot, value) pairs.
vtkSmartPointer<vtkSpline> MakeSpline(
  const SkdPolylineForm& form, bool isClosed, double length, std::vector<double>& pairs)
{
  vtkSmartPointer<vtkSpline> spline = MakeOpenSpline(form, pairs);
  spline->SetClosed(isClosed);
  spline->SetParametricRange(0.0, length);
  return spline;
}
}

//------------------------------------------------------------------------------
SkdPolylineForm SkdPolylineForm::Of(int kind, double tension, double bias, double continuity)
{
  const auto number = [](double value) { return std::isnan(value) ? 0.0 : value; };
  return { static_cast<Kinds>(kind), number(tension), number(bias), number(continuity) };
}

//------------------------------------------------------------------------------
void SkdCurveSet::Read(
  const std::vector<SkdBlock>& blocks, const SkdPolylineForm& form, const skd::Processes* processes)
{
  *this = SkdCurveSet();
  this->Blocks = blocks;
  this->Form = form;
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    vtkDataSet* mesh = blocks[block].Mesh;
    const std::vector<unsigned char> counted = SkdFindCounted(mesh);
    const std::vector<unsigned char> own = SkdOwnCellsOf(mesh);
    for (vtkIdType cellId = 0; cellId < mesh->GetNumberOfCells(); ++cellId)
    {
      if (counted[static_cast<std::size_t>(cellId)] == 0)
      {
        continue;
      }
      const Faults before = this->Found;
      this->ReadCell(mesh, static_cast<int>(block), cellId);
      if (!own.empty() && own[static_cast<std::size_t>(cellId)] == 0)
      {
        this->Found = before;
      }
    }
  }
  if (processes)
  {
    this->AddBoundsOf(*processes);
  }
  this->JoinEnds();
}

//------------------------------------------------------------------------------
void SkdCurveSet::AddBoundsOf(const skd::Processes& processes)
{
  const skd::Vector3& low = this->Bounds.Min;
  const skd::Vector3& high = this->Bounds.Max;
  for (const std::vector<double>& other :
    processes.GatherFromOthers({ low[0], low[1], low[2], high[0], high[1], high[2] }))
  {
    this->Bounds.Add(
      skd::Box3{ { { other[0], other[1], other[2] } }, { { other[3], other[4], other[5] } } });
  }
}

//------------------------------------------------------------------------------
void SkdCurveSet::JoinEnds()
{
  std::vector<SkdCurveEnd> ends;
  for (std::size_t number = 0; number < this->Curves.size(); ++number)
  {
    const SkdCurve& curve = this->Curves[number];
    if (curve.IsClosed)
    {
      continue;
    }
    for (const bool atEnd : { false, true })
    {
      const std::size_t piece = atEnd ? curve.LastPiece - 1 : curve.FirstPiece;
      const skd::Vector3& origin = this->Pieces[piece].Origin;
      const skd::CurvePoint at = this->GetPiece(piece, origin).At(atEnd ? 1.0 : 0.0);
      ends.push_back({ 2 * number + (atEnd ? 1 : 0), at.X + origin, atEnd ? at.D1 : -1.0 * at.D1 });
    }
  }
  const double rounding = // as far apart as contacts are resolved
    32.0 * std::numeric_limits<double>::epsilon() * skd::LargestCoordinate(this->Bounds);
  this->Joints = SkdCurveJoints(std::move(ends), this->Curves.size(), rounding);
}

//------------------------------------------------------------------------------
bool SkdCurveSet::IsAtEnd(std::size_t number, double u, double slack, std::size_t& joint) const
{
  const SkdCurve& curve = this->Curves[number];
  const double last = static_cast<double>(curve.LastPiece - curve.FirstPiece);
  const bool atStart = u <= slack;
  if (curve.IsClosed || (!atStart && u < last - slack))
  {
    return false;
  }
  joint = this->Joints.At(number, !atStart);
  return true;
}

//------------------------------------------------------------------------------
void SkdCurveSet::ReadCell(vtkDataSet* mesh, int block, vtkIdType cellId)
{
  const int type = mesh->GetCellType(cellId);
  if (type == VTK_EMPTY_CELL)
  {
    return;
  }
  vtkCell* cell = mesh->GetCell(cellId);
  if (cell->GetCellDimension() != 1)
  {
    ++this->Found.NotCurves;
    return;
  }
  SkdCurve curve{ block, cellId, this->Pieces.size(), 0, 1, false, 0.0 };
  const bool isPolyline = type == VTK_LINE || type == VTK_POLY_LINE;
  if (isPolyline ? this->AddPolyline(cell, curve) : this->AddNative(cell))
  {
    this->Close(curve);
  }
}

//------------------------------------------------------------------------------
bool SkdCurveSet::AddPolyline(vtkCell* cell, SkdCurve& curve)
{
  const std::vector<skd::Vector3> points = PointsOf(cell);
  if (!AreFinite(points))
  {
    ++this->Found.NotFinite;
    return false;
  }
  const bool isClosed = points.size() > 2 && points.front() == points.back();
  curve.Intervals = std::max(static_cast<int>(points.size()) - 1, 1);
  if (this->Form.Kind == SkdPolylineForm::Straight || points.size() < 3)
  {
    this->AddLines(points);
  }
  else
  {
    this->AddSplines(points, isClosed);
  }
  return true;
}

//------------------------------------------------------------------------------
void SkdCurveSet::AddLines(const std::vector<skd::Vector3>& points)
{
  const skd::Vector3 zero{};
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    if (!(points[i] == points[i + 1]))
    {
      this->AddPiece(skd::BezierCurve::Line(points[i], points[i + 1]), zero, static_cast<int>(i));
    }
  }
}

//------------------------------------------------------------------------------
// VTK's splines are cubic between their knots: four values there determine the piece.
void SkdCurveSet::AddSplines(const std::vector<skd::Vector3>& points, bool isClosed)
{
  const Knots knots(points);
  if (knots.At.size() < 3)
  {
    this->AddLines(points);
    return;
  }
  vtkSmartPointer<vtkSpline> splines[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> pairs = knots.PairsWith(points, axis, isClosed);
    splines[axis] = MakeSpline(this->Form, isClosed, knots.At.back(), pairs);
  }
  for (std::size_t i = 0; i + 1 < knots.At.size(); ++i)
  {
    const skd::Vector3& start = points[knots.Numbers[i]];
    skd::BezierCurve piece;
    piece.Degree = 3;
    piece.Points[0] = skd::Weighted(skd::Vector3{}, 1.0);
    piece.Points[3] = skd::Weighted(points[knots.Numbers[i + 1]] - start, 1.0);
    for (int k = 1; k < 3; ++k)
    {
      const double at = knots.At[i] + (knots.At[i + 1] - knots.At[i]) * k / 3.0;
      const skd::Vector3 x{ { splines[0]->Evaluate(at), splines[1]->Evaluate(at),
        splines[2]->Evaluate(at) } };
      piece.Points[k] = skd::Weighted(x - (start - points[0]), 1.0);
    }
    skd::BernsteinBasisOf(3).Convert(piece.Points);
    this->AddPiece(piece, start, static_cast<int>(knots.Numbers[i]));
  }
}

//------------------------------------------------------------------------------
bool SkdCurveSet::AddNative(vtkCell* cell)
{
  const auto read = SkdReadBezierCurve(cell);
  switch (read.Fault)
  {
    case SkdBezierFault::None:
      break;
    case SkdBezierFault::Weight:
      ++this->Found.BadWeights;
      return false;
    case SkdBezierFault::Coordinate:
      ++this->Found.NotFinite;
      return false;
    case SkdBezierFault::Degree:
      ++this->Found.TooHigh;
      return false;
    default:
      ++this->Found.NotCurves;
      return false;
  }
  const skd::Box3 bounds = read.Form.Bounds();
  if (bounds.Diagonal() > 0.0)
  {
    this->AddPiece(read.Form, read.Origin, 0);
  }
  return true;
}

//------------------------------------------------------------------------------
void SkdCurveSet::AddPiece(const skd::BezierCurve& form, const skd::Vector3& origin, int interval)
{
  this->Pieces.push_back(
    { origin, 0.0, this->Points.size(), this->Curves.size(), form.Degree, interval });
  this->Points.insert(this->Points.end(), form.Points, form.Points + form.Degree + 1);
}

//------------------------------------------------------------------------------
void SkdCurveSet::Close(SkdCurve& curve)
{
  curve.LastPiece = this->Pieces.size();
  if (curve.FirstPiece == curve.LastPiece)
  {
    ++this->Found.NoLength;
    return;
  }
  skd::Box3 bounds;
  for (std::size_t piece = curve.FirstPiece; piece < curve.LastPiece; ++piece)
  {
    const skd::Vector3& origin = this->Pieces[piece].Origin;
    const skd::BezierCurve form = this->GetPiece(piece, origin);
    this->Pieces[piece].LengthBefore = curve.Length;
    curve.Length += skd::ArcLength(form, 0.0, 1.0);
    bounds.Add(form.Bounds().Min + origin);
    bounds.Add(form.Bounds().Max + origin);
  }
  if (!(curve.Length >= LeastLength && curve.Length <= 1.0 / LeastLength))
  {
    ++this->Found.NotMeasurable;
    this->Points.resize(this->Pieces[curve.FirstPiece].FirstPoint);
    this->Pieces.resize(curve.FirstPiece);
    return;
  }
  const skd::Vector3& origin = this->Pieces[curve.FirstPiece].Origin;
  curve.IsClosed = this->GetPiece(curve.FirstPiece, origin).Start() ==
    this->GetPiece(curve.LastPiece - 1, origin).End();
  this->Bounds.Add(bounds);
  this->Curves.push_back(curve);
}

//------------------------------------------------------------------------------
skd::BezierCurve SkdCurveSet::GetPiece(std::size_t piece, const skd::Vector3& origin) const
{
  const Piece& stored = this->Pieces[piece];
  const skd::Vector3 shift = stored.Origin - origin;
  skd::BezierCurve curve;
  curve.Degree = stored.Degree;
  for (int i = 0; i <= stored.Degree; ++i)
  {
    const std::size_t number = stored.FirstPoint + static_cast<std::size_t>(i);
    curve.Points[i] = skd::Shifted(this->Points[number], shift);
  }
  return curve;
}

//------------------------------------------------------------------------------
double SkdCurveSet::GetParameter(std::size_t piece, double t) const
{
  const Piece& stored = this->Pieces[piece];
  return (stored.Interval + t) / this->Curves[stored.Curve].Intervals;
}

//------------------------------------------------------------------------------
double SkdCurveSet::GetArcLength(std::size_t piece, double t) const
{
  const Piece& stored = this->Pieces[piece];
  return stored.LengthBefore + skd::ArcLength(this->GetPiece(piece, stored.Origin), 0.0, t);
}

//------------------------------------------------------------------------------
void SkdCurveSet::GetWeights(
  std::size_t piece, double t, vtkIdList* ids, std::vector<double>& weights) const
{
  const Piece& stored = this->Pieces[piece];
  const SkdCurve& curve = this->Curves[stored.Curve];
  vtkDataSet* mesh = this->Blocks[static_cast<std::size_t>(curve.Block)].Mesh;
  const int type = mesh->GetCellType(curve.CellId);
  if (type == VTK_LINE || type == VTK_POLY_LINE)
  {
    mesh->GetCellPoints(curve.CellId, ids);
    const vtkIdType ends[2] = { ids->GetId(stored.Interval), ids->GetId(stored.Interval + 1) };
    ids->SetNumberOfIds(2);
    ids->SetId(0, ends[0]);
    ids->SetId(1, ends[1]);
    weights = { 1.0 - t, t };
    return;
  }
  vtkCell* cell = mesh->GetCell(curve.CellId);
  ids->DeepCopy(cell->GetPointIds());
  weights.resize(static_cast<std::size_t>(ids->GetNumberOfIds()));
  const double at[3] = { type == VTK_CUBIC_LINE ? 2.0 * t - 1.0 : t, 0.0, 0.0 };
  cell->InterpolateFunctions(at, weights.data());
}

//------------------------------------------------------------------------------
std::vector<std::string> SkdCurveSet::GetFaults() const
{
  return SkdFaultsOf({ { this->Found.NotCurves, " cells are not curves" },
    { this->Found.NoLength, " curves have zero length" },
    { this->Found.NotFinite, " curves have points that are not finite" },
    { this->Found.BadWeights, " curves have a weight that is not positive" },
    { this->Found.NotMeasurable, " curves are longer than 1e140 or shorter than 1e-140" },
    { this->Found.TooHigh, " curves have a degree above 10" } });
}
}
