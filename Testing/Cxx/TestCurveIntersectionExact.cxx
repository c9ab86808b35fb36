// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Polylines of whole coordinates against polylines: each place that they share, once.
//
// SKDTREE_FUZZ_PAIRS in the environment sets how many pairs of polylines are tried.

#include "Support/CurveRun.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"
#include "vtkSkdTreeCurveIntersection.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

using namespace skdtest;

namespace
{

using Whole = __int128;
using Triple = std::array<std::int64_t, 3>;

Triple operator-(const Triple& a, const Triple& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

std::array<Whole, 3> CrossOf(const Triple& a, const Triple& b)
{
  const auto part = [&](int i, int j) { return Whole(a[i]) * b[j] - Whole(a[j]) * b[i]; };
  return { part(1, 2), part(2, 0), part(0, 1) };
}

/// A quotient of whole numbers, the lower above 0.
struct Ratio
{
  Whole Upper;
  Whole Lower;

  Ratio(Whole upper, Whole lower)
    : Upper(lower < 0 ? -upper : upper)
    , Lower(lower < 0 ? -lower : lower)
  {
  }
  bool operator<(const Ratio& other) const
  {
    return this->Upper * other.Lower < other.Upper * this->Lower;
  }
  bool operator==(const Ratio& other) const
  {
    return this->Upper * other.Lower == other.Upper * this->Lower;
  }
  bool IsWithin() const { return this->Upper >= 0 && this->Upper <= this->Lower; }
  Ratio operator+(Whole count) const { return { this->Upper + count * this->Lower, this->Lower }; }
  double Value() const { return double(this->Upper) / double(this->Lower); }
};

/// A place that two polylines share, by the parameters along them: their segments' numbers and
/// what is left.
struct Position
{
  Ratio U;
  Ratio V;
  bool Begins = false; ///< a interval, along the first
  bool Ends = false;
};

using Polyline = std::vector<Triple>;

/// All that two polylines share, place by place, as exact arithmetic has it.
class Reference
{
public:
  Reference(const Polyline& first, const Polyline& second)
  {
    for (std::size_t i = 0; i + 1 < first.size(); ++i)
    {
      for (std::size_t j = 0; j + 1 < second.size(); ++j)
      {
        this->Count[0] = static_cast<Whole>(i);
        this->Count[1] = static_cast<Whole>(j);
        this->Meet(first[i], first[i + 1], second[j], second[j + 1]);
      }
    }
    this->CloseAround(first, &Position::U);
    this->CloseAround(second, &Position::V);
    this->Unite();
  }

  std::vector<Position> Positions;

private:
  void Meet(const Triple& a, const Triple& b, const Triple& c, const Triple& d)
  {
    const Triple u = b - a;
    const Triple v = d - c;
    const Triple between = c - a;
    const auto normal = CrossOf(u, v);
    const auto byV = CrossOf(between, v);
    const auto byU = CrossOf(between, u);
    for (int k = 0; k < 3; ++k)
    {
      if (normal[k] != 0)
      {
        const Ratio t(byV[k], normal[k]);
        const Ratio s(byU[k], normal[k]);
        const Whole apart =
          normal[0] * between[0] + normal[1] * between[1] + normal[2] * between[2];
        if (apart == 0 && t.IsWithin() && s.IsWithin())
        {
          this->Add(t, s, false, false);
        }
        return;
      }
    }
    if (byU == std::array<Whole, 3>{ 0, 0, 0 })
    {
      this->MeetInLine(a, b, c, d);
    }
  }

  void MeetInLine(const Triple& a, const Triple& b, const Triple& c, const Triple& d)
  {
    int k = 0;
    while (a[k] == b[k])
    {
      ++k;
    }
    const auto onFirst = [&](const Triple& x) { return Ratio(x[k] - a[k], b[k] - a[k]); };
    const auto onSecond = [&](const Triple& x) { return Ratio(x[k] - c[k], d[k] - c[k]); };
    const bool isAlong = onFirst(c) < onFirst(d);
    const Triple& low = isAlong ? c : d;
    const Triple& high = isAlong ? d : c;
    const Triple& begin = onFirst(a) < onFirst(low) ? low : a;
    const Triple& end = onFirst(high) < onFirst(b) ? high : b;
    if (onFirst(begin) == onFirst(end))
    {
      this->Add(onFirst(begin), onSecond(begin), false, false);
    }
    else if (onFirst(begin) < onFirst(end))
    {
      this->Add(onFirst(begin), onSecond(begin), true, false);
      this->Add(onFirst(end), onSecond(end), false, true);
    }
  }

  void Add(const Ratio& t, const Ratio& s, bool begins, bool ends)
  {
    this->Positions.push_back({ t + this->Count[0], s + this->Count[1], begins, ends });
  }

  void CloseAround(const Polyline& polyline, Ratio Position::*along)
  {
    const Ratio last(static_cast<Whole>(polyline.size() - 1), 1);
    for (Position& position : this->Positions)
    {
      const bool isClosed = polyline.size() > 2 && polyline.front() == polyline.back();
      position.*along = isClosed && position.*along == last ? Ratio(0, 1) : position.*along;
    }
  }

  /// Where one interval ends and another begins, it goes on.
  void Unite()
  {
    std::vector<Position> united;
    for (const Position& position : this->Positions)
    {
      const auto same = std::find_if(united.begin(), united.end(),
        [&](const Position& other) { return other.U == position.U && other.V == position.V; });
      if (same == united.end())
      {
        united.push_back(position);
        continue;
      }
      same->Begins |= position.Begins;
      same->Ends |= position.Ends;
    }
    this->Positions.clear();
    std::copy_if(united.begin(), united.end(), std::back_inserter(this->Positions),
      [](const Position& position) { return !position.Begins || !position.Ends; });
  }

  Whole Count[2];
};

/// Two polylines with planted incidences: vertices and intervals of the second on the first.
class PairMaker
{
public:
  /// Coordinates from 0 to `size`; the third is 0 unless the pairs are `solid`.
  PairMaker(unsigned seed, int size, bool solid)
    : Engine(seed)
    , Size(size)
    , IsSolid(solid)
  {
  }

  void Make(Polyline& first, Polyline& second)
  {
    first.clear();
    this->Fill(first, [&] { return this->Random(); });
    second.clear();
    this->Fill(second, [&] { return this->Planted(first); });
  }

private:
  template <class Next>
  void Fill(Polyline& line, Next next)
  {
    const std::size_t count = 2 + this->Engine() % 4;
    while (line.size() < count)
    {
      const Triple x = next();
      if (line.empty() || line.back() != x)
      {
        line.push_back(x);
      }
    }
    if (count > 3 && this->Engine() % 8 == 0 && line[count - 2] != line.front())
    {
      line.back() = line.front();
    }
  }

  std::int64_t Coordinate() { return static_cast<std::int64_t>(this->Engine() % (this->Size + 1)); }

  Triple Random()
  {
    Triple x{ this->Coordinate(), this->Coordinate(), 0 };
    x[2] = this->IsSolid ? this->Coordinate() : 0;
    return x;
  }

  /// A vertex of the polyline, a point on one of its lines, or any. One that follows another which
  /// was put beside a vertex is put on the other side: the line between goes through the vertex.
  Triple Planted(const Polyline& first)
  {
    if (this->HasMirrored)
    {
      this->HasMirrored = false;
      return this->Mirrored;
    }
    const std::size_t i = this->Engine() % (first.size() - 1);
    const Triple& a = first[i];
    const Triple along = first[i + 1] - a;
    switch (this->Engine() % 6)
    {
      case 0:
        return a;
      case 1: // a place on the line, also beyond its ends
      {
        const std::int64_t part = this->DivisorOf(along);
        return this->Moved(a, along, static_cast<int>(this->Engine() % (3 * part)) - part, part);
      }
      case 2: // beside an edge, so that the line through its end runs along it
      case 3:
      {
        Triple slope = along;
        slope[this->Engine() % (this->IsSolid ? 3 : 2)] += this->Engine() % 2 ? 1 : -1;
        this->Mirrored = this->Moved(a, slope, -1, 1);
        const Triple x = this->Moved(a, slope, 1, 1);
        this->HasMirrored = x != this->Mirrored;
        return x;
      }
      default:
        return this->Random();
    }
  }

  std::int64_t DivisorOf(const Triple& x)
  {
    std::int64_t divisor = 0;
    for (std::int64_t part : x)
    {
      part = std::abs(part);
      while (part != 0)
      {
        divisor = std::exchange(part, divisor % part);
      }
    }
    return divisor;
  }

  static Triple Moved(Triple x, const Triple& along, std::int64_t upper, std::int64_t lower)
  {
    for (int k = 0; k < 3; ++k)
    {
      x[k] += along[k] * upper / lower;
    }
    return x;
  }

  std::mt19937 Engine;
  int Size;
  bool IsSolid;
  bool HasMirrored = false;
  Triple Mirrored{};
};

struct Mistakes
{
  int Lost = 0;
  int Twice = 0; ///< or nowhere
  std::size_t Positions = 0;
};

/// Many pairs in one run, each in a box of its own.
class ManyPairs
{
public:
  ManyPairs(PairMaker& maker, int count, int size)
    : Pairs(count)
  {
    const int row = static_cast<int>(std::ceil(std::cbrt(count)));
    const std::int64_t apart = 6 * static_cast<std::int64_t>(size) + 2;
    for (int i = 0; i < count; ++i)
    {
      const Triple origin{ i % row * apart, i / row % row * apart, i / row / row * apart };
      maker.Make(this->Pairs[i][0], this->Pairs[i][1]);
      for (int side = 0; side < 2; ++side)
      {
        this->Insert(this->Pairs[i][side], origin, side);
      }
    }
  }

  Mistakes Compare() const
  {
    const auto filter =
      MakeCurveFilter<vtkSkdTreeCurveIntersection>(this->MakeLines(0), this->MakeLines(1));
    filter->InterpolateDataOff();
    filter->Update();
    auto* hits = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    vtkDataArray* arrays[4];
    const char* names[4] = { "SkdCurveId", "SkdOtherCurveId", "SkdCurveParameter",
      "SkdOtherCurveParameter" };
    for (int i = 0; i < 4; ++i)
    {
      arrays[i] = hits->GetPointData()->GetArray(names[i]);
    }
    Mistakes all;
    vtkIdType next = 0;
    for (std::size_t i = 0; i < this->Pairs.size(); ++i)
    {
      std::vector<std::array<double, 2>> found;
      for (; next < hits->GetNumberOfPoints() && arrays[0]->GetTuple1(next) == double(i); ++next)
      {
        EXPECT_EQ(arrays[1]->GetTuple1(next), double(i));
        found.push_back({ arrays[2]->GetTuple1(next), arrays[3]->GetTuple1(next) });
      }
      this->CompareOne(i, found, all);
    }
    return all;
  }

private:
  void Insert(const Polyline& polyline, const Triple& origin, int side)
  {
    this->Lines[side]->InsertNextCell(static_cast<int>(polyline.size()));
    for (const Triple& x : polyline)
    {
      this->Lines[side]->InsertCellPoint(this->Points[side]->InsertNextPoint(
        double(x[0] + origin[0]), double(x[1] + origin[1]), double(x[2] + origin[2])));
    }
  }

  vtkSmartPointer<vtkPolyData> MakeLines(int side) const
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(this->Points[side]);
    mesh->SetLines(this->Lines[side]);
    return mesh;
  }

  void CompareOne(std::size_t i, std::vector<std::array<double, 2>> found, Mistakes& all) const
  {
    const Reference reference(this->Pairs[i][0], this->Pairs[i][1]);
    all.Positions += reference.Positions.size();
    for (const Position& position : reference.Positions)
    {
      const double u = position.U.Value() / double(this->Pairs[i][0].size() - 1);
      const double v = position.V.Value() / double(this->Pairs[i][1].size() - 1);
      const auto same = std::find_if(found.begin(), found.end(),
        [&](const auto& hit)
        { return std::abs(hit[0] - u) < 1e-13 && std::abs(hit[1] - v) < 1e-13; });
      if (same == found.end())
      {
        ++all.Lost;
        continue;
      }
      found.erase(same);
    }
    all.Twice += static_cast<int>(found.size());
  }

  struct NewPoints : vtkNew<vtkPoints>
  {
    NewPoints() { (*this)->SetDataTypeToDouble(); }
  };

  std::vector<std::array<Polyline, 2>> Pairs;
  NewPoints Points[2];
  vtkNew<vtkCellArray> Lines[2];
};

/// How many pairs of all.
int PairsOf(double share)
{
  const char* set = std::getenv("SKDTREE_FUZZ_PAIRS");
  return static_cast<int>(share * (set ? std::atof(set) : 40000.0));
}

void ExpectNoMistakes(int size, bool isSolid, int pairs)
{
  constexpr int most = 20000; // a run
  PairMaker maker(static_cast<unsigned>(size + isSolid), size, isSolid);
  std::size_t positions = 0;
  for (int done = 0; done < pairs; done += most)
  {
    const Mistakes mistakes = ManyPairs(maker, std::min(most, pairs - done), size).Compare();
    EXPECT_EQ(mistakes.Lost, 0) << size;
    EXPECT_EQ(mistakes.Twice, 0) << size;
    positions += mistakes.Positions;
  }
  EXPECT_GT(positions, static_cast<std::size_t>(pairs / 2));
}

constexpr auto MakeFilter = [](vtkDataObject* curves, vtkDataObject* others)
{ return MakeCurveFilter<vtkSkdTreeCurveIntersection>(curves, others); };

std::size_t CountHits(const std::vector<Point>& one, const std::vector<Point>& other)
{
  const std::size_t forward =
    OutputPoints(MakeFilter(MakePolyline(one), MakePolyline(other))).size();
  const std::size_t back = OutputPoints(MakeFilter(MakePolyline(other), MakePolyline(one))).size();
  EXPECT_EQ(forward, back);
  return forward;
}

}

TEST(CurveIntersectionExact, SmallPolylinesInAPlane)
{
  ExpectNoMistakes(6, false, PairsOf(0.3));
}

TEST(CurveIntersectionExact, SmallPolylinesInSpace)
{
  ExpectNoMistakes(3, true, PairsOf(0.3));
}

TEST(CurveIntersectionExact, LargePolylinesInAPlane)
{
  ExpectNoMistakes(4000, false, PairsOf(0.2));
}

TEST(CurveIntersectionExact, LargePolylinesInSpace)
{
  ExpectNoMistakes(500, true, PairsOf(0.1));
}

TEST(CurveIntersectionExact, PolylinesAtSmallAngles)
{
  ExpectNoMistakes(100000, false, PairsOf(0.1));
}

TEST(CurveIntersectionExact, AVertexOnALine)
{
  EXPECT_EQ(CountHits({ { 376, -316, 0 }, { 23, 26, 0 }, { -330, 368, 0 } },
              { { 2494, -2382, 0 }, { -1389, 1402, 0 } }),
    1u);
}

TEST(CurveIntersectionExact, VerticesOnALineAtAnyAngle)
{
  Random random(12);
  for (double angle = 0.1; angle > 1e-11; angle *= 0.1)
  {
    for (int round = 0; round < 5; ++round)
    {
      // The vertex is exactly on the line: it is between two points at equal distances from it.
      const double unit = std::ldexp(1.0, -20);
      const auto number = [&](double size)
      { return unit * std::floor(random.Between(-size, size) / unit); };
      const Point vertex{ number(4), number(4), number(4) };
      const Point along{ number(4), number(4), number(4) };
      Point off = along;
      off[round % 3] += std::ldexp(1.0, std::ilogb(angle));
      const std::vector<Point> line{ vertex - along, vertex + along };
      EXPECT_EQ(CountHits({ vertex - off, vertex, vertex + off }, line), 1u) << angle;
      EXPECT_EQ(CountHits({ vertex, vertex + off }, line), 1u) << angle;
      EXPECT_EQ(CountHits({ vertex - off, vertex, vertex - 0.5 * off }, line), 1u) << angle;
    }
  }
}
