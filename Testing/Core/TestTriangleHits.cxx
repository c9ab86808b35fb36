// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles whose corners lie beside the packets of a tree are hit as each of them is by itself.
#include "Core/Search/Queries/PacketHits.h"
#include "Core/Search/Queries/TriangleHits.h"
#include "CoreScenes.h"
#include "CoreSupport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <tuple>

using namespace coretest;
using skd::Segment;
using skd::TriangleHit;
using skd::Vector3;

namespace
{

struct Mesh
{
  std::vector<Vector3> Points;
  std::vector<std::array<std::uint32_t, 3>> Triangles;

  const Vector3& Corner(std::size_t triangle, int corner) const
  {
    return this->Points[this->Triangles[triangle][static_cast<std::size_t>(corner)]];
  }
};

/// Triangles of points that many of them share: on whole numbers, where lines meet edges and
/// corners exactly, or anywhere. Some have no area, some are twins.
Mesh MakeMesh(Random& random, std::size_t count, bool isWhole, const Vector3& offset, double scale)
{
  Mesh mesh;
  for (std::size_t i = 0; i < count / 2 + 3; ++i)
  {
    Vector3 x = random.Point<3>(-4.0, 4.0);
    for (int axis = 0; axis < 3 && isWhole; ++axis)
    {
      x[axis] = std::round(x[axis]);
    }
    mesh.Points.push_back(offset + scale * x);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    std::array<std::uint32_t, 3> corners;
    for (std::uint32_t& corner : corners)
    {
      corner = static_cast<std::uint32_t>(random.Below(mesh.Points.size()));
    }
    const bool isTwin = i > 0 && random.Below(10) == 0;
    mesh.Triangles.push_back(isTwin ? mesh.Triangles.back() : corners);
  }
  return mesh;
}

/// A tree of triangles with packets that have points.
template <class Real>
class Packed
{
public:
  Packed(const Mesh& mesh, int capacity, double epsilon)
    : TheTree(skd::BuildTree<3>(InputOf(mesh, capacity, epsilon)))
  {
    for (std::uint32_t i = 0; i < this->TheTree.NumberOfNodes(); ++i)
    {
      const skd::Node<3>& node = this->TheTree.Open(i);
      if (node.IsLeaf)
      {
        this->Packet(mesh, node);
        this->TheTree.SetTag(i, skd::TrianglePackets::TagOf(this->TheTree.NumberOf(node)));
      }
      else
      {
        this->TheTree.SetTag(i, skd::TrianglePackets::TagOf(0));
        this->TheTree.SetNote(i, this->TheTree.LeavesBelow(node));
      }
    }
  }

  template <bool InOrder, class Visitor>
  void Visit(const Segment<3>& segment, double tolerance, Visitor visitor) const
  {
    skd::VisitTriangleHits<InOrder>(
      this->TheTree.View(), this->GetPackets(), segment, tolerance, visitor);
  }

  template <bool InOrder, class Visitor>
  bool VisitPacket(const std::vector<Segment<3>>& segments, double maxSpread, double tolerance,
    Visitor visitor) const
  {
    return skd::VisitPacketHits<InOrder>(this->TheTree.View(), this->GetPackets(), segments.data(),
      static_cast<int>(segments.size()), maxSpread, tolerance, visitor);
  }

private:
  skd::TrianglePackets GetPackets() const
  {
    skd::PacketPoints points;
    if constexpr (std::is_same_v<Real, float>)
    {
      points.Floats = this->Points.data();
    }
    else
    {
      points.Doubles = this->Points.data();
    }
    return { this->Packets.data(), points };
  }

  static skd::TreeInput<3> InputOf(const Mesh& mesh, int capacity, double epsilon)
  {
    Boxes<3> boxes(mesh.Triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        boxes[i].Add(mesh.Corner(i, corner));
      }
    }
    skd::TreeInput<3> input = skd::MakeTreeInput(boxes, epsilon);
    input.Capacity = capacity;
    return input;
  }

  void Packet(const Mesh& mesh, const skd::Node<3>& leaf)
  {
    const std::uint32_t number = this->TheTree.NumberOf(leaf);
    this->Packets.resize(std::max<std::size_t>(this->Packets.size(), number + 1));
    skd::TrianglePacket& packet = this->Packets[number];
    skd::FloatBox<3> box = skd::NoBox<3>();
    for (int lane = 0; lane < leaf.Count; ++lane)
    {
      skd::Enclose(box, leaf.Boxes.Get(lane));
    }
    packet.Grid = skd::QuantizationGrid(box);
    packet.FirstPoint = static_cast<std::uint32_t>(this->Points.size() / 3);
    std::map<std::uint32_t, std::uint8_t> positions;
    for (int lane = 0; lane < leaf.Count; ++lane)
    {
      const std::uint32_t triangle =
        this->TheTree.Element(leaf.First + static_cast<std::uint32_t>(lane));
      for (int corner = 0; corner < 3; ++corner)
      {
        const Vector3& x = mesh.Corner(triangle, corner);
        packet.Set(corner, lane, this->TheTree.GetFrame().Local(x));
        const std::uint32_t id = mesh.Triangles[triangle][static_cast<std::size_t>(corner)];
        const auto position = positions.emplace(id, static_cast<std::uint8_t>(positions.size()));
        packet.PointOf[lane][corner] = position.first->second;
        if (position.second)
        {
          std::copy(x.X, x.X + 3, std::back_inserter(this->Points));
        }
      }
    }
  }

  skd::Tree<3> TheTree;
  std::vector<skd::TrianglePacket> Packets;
  std::vector<Real> Points;
};

using Hits = std::vector<std::tuple<double, std::uint32_t, double, double, bool, bool>>;

Hits::value_type ToTuple(std::uint32_t triangle, const TriangleHit& hit)
{
  return { hit.T, triangle, hit.R, hit.S, hit.OnEdge, hit.Passes };
}

Hits OneByOne(const Mesh& mesh, const Segment<3>& segment, double tolerance)
{
  Hits hits;
  const skd::SegmentView view(segment);
  for (std::uint32_t i = 0; i < mesh.Triangles.size() && view.IsValid(); ++i)
  {
    const auto hit = skd::IntersectWithin(
      view, mesh.Corner(i, 0), mesh.Corner(i, 1), mesh.Corner(i, 2), tolerance);
    if (hit)
    {
      hits.push_back(ToTuple(i, *hit));
    }
  }
  std::sort(hits.begin(), hits.end());
  return hits;
}

/// Returns how many are hit.
template <class Real>
std::size_t ExpectAsOneByOne(
  const Mesh& mesh, const Packed<Real>& packed, const Segment<3>& segment, double tolerance)
{
  const Hits expected = OneByOne(mesh, segment, tolerance);
  Hits all;
  packed.template Visit<false>(segment, tolerance,
    [&](std::uint32_t triangle, const TriangleHit& hit)
    {
      all.push_back(ToTuple(triangle, hit));
      return 1.0;
    });
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, expected);

  Hits first;
  packed.template Visit<true>(segment, tolerance,
    [&](std::uint32_t triangle, const TriangleHit& hit)
    {
      const auto found = ToTuple(triangle, hit);
      first.assign(1, first.empty() ? found : std::min(found, first.front()));
      return std::get<0>(first.front());
    });
  EXPECT_EQ(first, Hits(expected.begin(), expected.begin() + (expected.empty() ? 0 : 1)));
  return expected.size();
}

struct Setting
{
  bool IsWhole;
  Vector3 Offset;
  double Scale;
};

/// Between two points, one of them on a triangle as often as not; now and then along an axis, of no
/// length, or not finite.
Segment<3> MakeSegment(Random& random, const Mesh& mesh, const Setting& setting)
{
  Segment<3> segment{ setting.Offset + setting.Scale * random.Point<3>(-6.0, 6.0),
    setting.Offset + setting.Scale * random.Point<3>(-6.0, 6.0) };
  if (random.Below(2) == 0)
  {
    segment.B = mesh.Points[random.Below(mesh.Points.size())];
  }
  if (random.Below(3) == 0)
  {
    const auto axis = static_cast<int>(random.Below(3));
    segment.A = segment.B + Along<3>(axis, 9.0 * setting.Scale);
    segment.B = segment.B - Along<3>(axis, 9.0 * setting.Scale);
  }
  if (random.Below(20) == 0)
  {
    segment.A = random.Below(2) == 0 ? segment.B : Filled<3>(NAN);
  }
  return segment;
}

/// Two to eight lines that begin and end about where one does: the same, so near that they run
/// the same way, or anywhere; one of them may be of no length, or not finite.
std::vector<Segment<3>> MakePacket(Random& random, const Mesh& mesh, const Setting& setting)
{
  const Segment<3> middle = MakeSegment(random, mesh, setting);
  const double spread[] = { 0.0, 1e-6, 0.01, 0.3, 4.0 };
  const double most = setting.Scale * spread[random.Below(5)];
  const bool isParallel = random.Below(2) == 0;
  std::vector<Segment<3>> segments(2 + random.Below(7));
  for (Segment<3>& segment : segments)
  {
    const Vector3 aside = random.Point<3>(-most, most);
    segment = { middle.A + aside, middle.B + (isParallel ? aside : random.Point<3>(-most, most)) };
  }
  if (random.Below(4) == 0)
  {
    segments[random.Below(segments.size())] = MakeSegment(random, mesh, setting);
  }
  return segments;
}

/// What all or the first of the hits of each line are. Returns whether they were a packet.
template <bool OnlyFirst, class Real>
bool ExpectPacketAsOneByOne(const Mesh& mesh, const Packed<Real>& packed,
  const std::vector<Segment<3>>& segments, double tolerance)
{
  std::vector<Hits> found(segments.size());
  const bool isPacket = packed.template VisitPacket<OnlyFirst>(segments, HUGE_VAL, tolerance,
    [&](int line, std::uint32_t triangle, const TriangleHit& hit)
    {
      Hits& hits = found[static_cast<std::size_t>(line)];
      hits.push_back(ToTuple(triangle, hit));
      return OnlyFirst ? std::get<0>(*std::min_element(hits.begin(), hits.end())) : 1.0;
    });
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    Hits expected = isPacket ? OneByOne(mesh, segments[i], tolerance) : Hits();
    std::sort(found[i].begin(), found[i].end());
    expected.resize(OnlyFirst ? std::min<std::size_t>(expected.size(), 1) : expected.size());
    found[i].resize(OnlyFirst ? std::min<std::size_t>(found[i].size(), 1) : found[i].size());
    EXPECT_EQ(found[i], expected);
  }
  return isPacket;
}

template <class Real>
void CheckPackets(const Setting& setting)
{
  Random random(11);
  int packets = 0;
  for (const std::size_t count : { 1, 8, 9, 65, 700 })
  {
    const Mesh mesh = MakeMesh(random, count, setting.IsWhole, setting.Offset, setting.Scale);
    const Packed<Real> packed(mesh, 8, 1e-9 * setting.Scale);
    for (int i = 0; i < 60; ++i)
    {
      const double tolerance = i % 3 == 0 ? 0.05 * setting.Scale : 0.0;
      const std::vector<Segment<3>> segments = MakePacket(random, mesh, setting);
      packets += ExpectPacketAsOneByOne<true>(mesh, packed, segments, tolerance) ? 1 : 0;
      packets += ExpectPacketAsOneByOne<false>(mesh, packed, segments, tolerance) ? 1 : 0;
    }
  }
  EXPECT_GT(packets, 100);
}

template <class Real>
void Check(const Setting& setting)
{
  Random random(7);
  std::size_t hits = 0;
  for (const std::size_t count : { 1, 2, 8, 9, 63, 64, 65, 700 })
  {
    const Mesh mesh = MakeMesh(random, count, setting.IsWhole, setting.Offset, setting.Scale);
    for (const int capacity : { 1, 3, 8 })
    {
      const Packed<Real> packed(mesh, capacity, 1e-9 * setting.Scale);
      for (int i = 0; i < 40; ++i)
      {
        const double tolerance = i % 3 == 0 ? 0.05 * setting.Scale : 0.0;
        hits += ExpectAsOneByOne(mesh, packed, MakeSegment(random, mesh, setting), tolerance);
      }
    }
  }
  EXPECT_GT(hits, 1000u);
}

TEST(TriangleHits, DoublesAreHitAsEachTriangleIs)
{
  Check<double>({ false, Filled<3>(0.0), 1.0 });
}

TEST(TriangleHits, EdgesAndCornersAreHitAsEachTriangleIs)
{
  Check<double>({ true, Filled<3>(0.0), 1.0 });
}

TEST(TriangleHits, FloatsAreHitAsEachTriangleIs)
{
  Check<float>({ true, Filled<3>(16.0), 0.125 });
}

TEST(TriangleHits, FarAndTinyTrianglesAreHitAsEachIs)
{
  Check<double>({ false, Filled<3>(1e6), 1e-3 });
  Check<double>({ true, Filled<3>(0.0), 1e-150 });
  Check<double>({ true, Filled<3>(0.0), 1e100 });
}

TEST(PacketHits, AreThoseOfEachLine)
{
  CheckPackets<double>({ false, Filled<3>(0.0), 1.0 });
  CheckPackets<double>({ true, Filled<3>(0.0), 1.0 });
  CheckPackets<float>({ true, Filled<3>(16.0), 0.125 });
}

TEST(PacketHits, OfFarAndTinyTrianglesAreThoseOfEachLine)
{
  CheckPackets<double>({ false, Filled<3>(1e6), 1e-3 });
  CheckPackets<double>({ true, Filled<3>(0.0), 1e-150 });
  CheckPackets<double>({ true, Filled<3>(0.0), 1e100 });
}

TEST(PacketHits, AreOfLinesThatAreNearEachOtherAndRunTheSameWay)
{
  Random random(3);
  const Packed<double> packed(MakeMesh(random, 65, false, Filled<3>(0.0), 1.0), 8, 1e-9);
  const auto isPacket = [&](const Segment<3>& a, const Segment<3>& b)
  {
    return packed.VisitPacket<true>(
      { a, b }, 0.5, 0.0, [](int, std::uint32_t, const TriangleHit&) { return 1.0; });
  };
  const Segment<3> segment{ { { -9.0, 0.1, 0.1 } }, { { 9.0, 0.2, 0.2 } } };
  const Segment<3> farther{ { { -9.0, 0.1, 0.1 } }, { { 9.0, 0.8, 0.2 } } };
  const Segment<3> otherWay{ { { -9.0, 0.1, 0.1 } }, { { 9.0, 0.0, 0.2 } } };
  const Segment<3> unknown{ { { -9.0, 0.1, 0.1 } }, { { 9.0, NAN, 0.2 } } };
  EXPECT_TRUE(isPacket(segment, segment));
  EXPECT_FALSE(isPacket(segment, farther));
  EXPECT_FALSE(isPacket(segment, otherWay));
  EXPECT_FALSE(isPacket(segment, unknown));
}

}
