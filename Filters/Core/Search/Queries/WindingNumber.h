// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The generalised winding number of a set of triangles around a point: the sum of their solid
/// angles by 4 pi. Of a closed surface with normals outward it is 1 inside and 0 outside; gaps,
/// overlaps and triangles flipped change it a little, not all at once (A. Jacobson, L. Kavan,
/// O. Sorkine-Hornung, ACM Trans. Graph. 32 (2013) 33).
///
/// This is a sum over all triangles rather than a search: triangles in a distant box are replaced
/// by the first three terms of their expansion at the centre of their area (G. Barill, N. G.
/// Dickson, R. Schmidt, D. I. W. Levin, A. Jacobson, ACM Trans. Graph. 37 (2018) 43). What the
/// terms left out can add up to is known: the kernel's part of degree k in the offset d of an area,
/// seen from a centre at the distance r, is the gradient of a solid harmonic, which is at most
/// sqrt(k (k + 1)) |d|^(k - 1) / r^(k + 1), for that of a Legendre polynomial is bounded by P^2 +
/// (1 - t^2) P'^2 / (k (k + 1)) <= 1.
#ifndef skd_Queries_WindingNumber_h
#define skd_Queries_WindingNumber_h

#include "../../Geometry/Measures/SolidAngle.h"
#include "../Tree/Tree.h"

#include <array>
#include <vector>

namespace skd
{

/// Made once of a tree and its triangles, then constant: any number of threads may query it, and a
/// query allocates nothing. Memory: 368 bytes a node and 72 a triangle. Cost: O(N) to make, about
/// O(log N) to ask. Lengths may range over 1e-50 to 1e50.
class WindingNumber
{
public:
  using Triangle = std::array<Vector3, 3>;

  /// The box of triangles[i] is that of the tree's element i. `accuracy` is At()'s, see Estimate().
  WindingNumber(const Tree<3>& tree, const std::vector<Triangle>& triangles, double accuracy = 2.0)
    : TheTree(tree)
    , Moments(tree.NumberOfNodes())
    , Accuracy(accuracy)
  {
    this->Triangles.reserve(tree.NumberOfElements());
    for (std::uint32_t i = 0; i < tree.NumberOfElements(); ++i)
    {
      this->Triangles.push_back(triangles[tree.Element(i)]);
    }
    // Children come after their parents.
    for (std::size_t node = this->Moments.size(); node-- > 0;)
    {
      this->Moments[node] = this->MomentsOf(tree.Open(static_cast<std::uint32_t>(node)));
    }
  }

  struct Sum
  {
    double Number = 0.0;
    double Bound = 0.0; ///< what Number is off by at most, but for rounding
    bool IsOn = false;  ///< x is on a triangle within rounding error: there is no number
  };

  /// What is farther than `accuracy` times its own radius is taken together: on a sphere 2 errs by
  /// 0.003, 4 by 0.0001; 0 or less sums exactly. The cost grows as its square.
  Sum Estimate(const Vector3& x, double accuracy) const
  {
    Sum sum;
    if (this->Moments.empty())
    {
      return sum;
    }
    const double accuracy2 =
      accuracy > 0.0 ? accuracy * accuracy : std::numeric_limits<double>::infinity();
    std::uint32_t stack[StackSize];
    int top = 0;
    stack[top++] = 0;
    while (top > 0)
    {
      const std::uint32_t index = stack[--top];
      const Moment& moment = this->Moments[index];
      if (Distance2(x, moment.Centre) > accuracy2 * moment.Radius2)
      {
        moment.AddTo(sum, x);
        continue;
      }
      const Node<3>& node = this->TheTree.Open(index);
      for (std::uint32_t i = node.First; i < node.First + node.Count; ++i)
      {
        if (node.IsLeaf)
        {
          const Triangle& t = this->Triangles[i];
          const TriangleSolidAngle solidAngle = SeeAngle(t[0], t[1], t[2], x);
          sum.Number += solidAngle.Angle;
          sum.IsOn = sum.IsOn || solidAngle.IsOn;
        }
        else
        {
          stack[top++] = i;
        }
      }
    }
    constexpr double fourPi = 12.566370614359172954;
    sum.Number /= fourPi;
    sum.Bound /= fourPi;
    return sum;
  }

  double At(const Vector3& x) const { return this->Estimate(x, this->Accuracy).Number; }

  /// The number, off by at most `tolerance`, and not so that it is on the other side of 1/2 or
  /// -1/2: as At(), and the more accurate the more that leaves to be desired. Where its magnitude
  /// is 1/2 to within rounding all triangles are summed. On a triangle it is as At() has it.
  Sum Decide(const Vector3& x, double tolerance) const
  {
    constexpr double most = 20.0; // what needs more is summed exactly
    double accuracy = this->Accuracy;
    Sum sum = this->Estimate(x, accuracy);
    while (accuracy > 0.0 && !sum.IsOn)
    {
      const double gap = std::abs(std::abs(sum.Number) - 0.5);
      if (sum.Bound <= tolerance && sum.Bound < gap)
      {
        break;
      }
      const double wanted = std::min(tolerance, 0.7 * gap); // the number moves, too
      // The bound falls as the third power of the accuracy.
      accuracy *= std::max(1.1, 1.1 * std::cbrt(sum.Bound / wanted));
      accuracy = accuracy < most ? accuracy : 0.0; // also of an infinite one
      sum = this->Estimate(x, accuracy);
    }
    return sum;
  }

  /// At least the sum of the magnitudes of all triangles' numbers, but at most 1/2: what is far
  /// away counts by its area, as if all of it faced x.
  double BoundMagnitudes(const Vector3& x) const
  {
    constexpr double far2 = 64.0; // the area counts at most (8 / 7)^2 times
    constexpr double half = 6.283185307179586477;
    double sum = 0.0;
    std::uint32_t stack[StackSize];
    int top = 0;
    if (!this->Moments.empty())
    {
      stack[top++] = 0;
    }
    while (top > 0 && sum < half)
    {
      const std::uint32_t index = stack[--top];
      const Moment& moment = this->Moments[index];
      const double distance2 = Distance2(x, moment.Centre);
      if (distance2 > far2 * moment.Radius2)
      {
        const double least = std::sqrt(distance2) - moment.Radius;
        sum += moment.Area / (least * least);
        continue;
      }
      const Node<3>& node = this->TheTree.Open(index);
      for (std::uint32_t i = node.First; i < node.First + node.Count; ++i)
      {
        if (node.IsLeaf)
        {
          const Triangle& t = this->Triangles[i];
          sum += std::abs(SeeAngle(t[0], t[1], t[2], x).Angle);
        }
        else
        {
          stack[top++] = i;
        }
      }
    }
    return std::min(0.5, 0.5 * sum / half);
  }

private:
  static constexpr int StackSize = 96; // as for a walk

  /// What triangles below a node are from afar.
  struct Moment
  {
    Vector3 Centre{ { 0.0, 0.0, 0.0 } };
    double Radius2 = 0.0; ///< of the ball around Centre that holds them
    double Radius = 0.0;
    double ErrorBound3 =
      0.0; ///< at least the sum of their areas times the distances from Centre cubed
    double Area = 0.0;
    Vector3 Dipole{ { 0.0, 0.0, 0.0 } }; ///< the sum of their area vectors
    double Second[3][3] = {};            ///< offset i of each from Centre, times its area j
    double Third[3][3][3] = {};          ///< offsets i and j times its area k

    /// The expansion around the centre of n . r / |r|^3, in the offsets of the parts, and what it
    /// may be off by: the sum of sqrt(k (k + 1)) d^(k - 1) / r^(k + 1), k from 4 on, where d is at
    /// most Radius. All times 4 pi.
    void AddTo(Sum& sum, const Vector3& x) const
    {
      const Vector3 r = this->Centre - x;
      const double inverse2 = 1.0 / Norm2(r);
      const double inverse = std::sqrt(inverse2);
      const double inverse3 = inverse2 * inverse;
      const double rest = 1.0 / (1.0 - this->Radius * inverse);
      sum.Bound += this->ErrorBound3 * inverse3 * inverse2 *
        (4.5 * rest + this->Radius * inverse * rest * rest);
      double second = 0.0;
      double third = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        second += this->Second[i][i];
        for (int j = 0; j < 3; ++j)
        {
          second -= 3.0 * inverse2 * r[i] * r[j] * this->Second[i][j];
          third -= 3.0 * r[j] * (this->Third[i][j][i] + 0.5 * this->Third[i][i][j]);
          for (int k = 0; k < 3; ++k)
          {
            third += 7.5 * inverse2 * r[i] * r[j] * r[k] * this->Third[i][j][k];
          }
        }
      }
      sum.Number += inverse3 * (Dot(this->Dipole, r) + second + inverse2 * third);
    }

    /// Adds a part whose own moments are seen from `offset`, itself seen from Centre.
    void Add(const Moment& part, const Vector3& offset)
    {
      this->Dipole = this->Dipole + part.Dipole;
      for (int i = 0; i < 3; ++i)
      {
        for (int j = 0; j < 3; ++j)
        {
          this->Second[i][j] += part.Second[i][j] + offset[i] * part.Dipole[j];
          for (int k = 0; k < 3; ++k)
          {
            this->Third[i][j][k] += part.Third[i][j][k] + offset[i] * part.Second[j][k] +
              offset[j] * part.Second[i][k] + offset[i] * offset[j] * part.Dipole[k];
          }
        }
      }
    }
  };

  /// Relative to its middle; its points are spread evenly over it.
  static Moment MomentOf(const Triangle& t)
  {
    Moment moment;
    moment.Dipole = AreaOf(t);
    const Vector3 middle = MiddleOf(t);
    for (const Vector3& corner : t)
    {
      const Vector3 d = corner - middle;
      for (int k = 0; k < 27; ++k)
      {
        moment.Third[k / 9][k / 3 % 3][k % 3] +=
          d[k / 9] * d[k / 3 % 3] * moment.Dipole[k % 3] / 12.0;
      }
    }
    return moment;
  }

  static Vector3 AreaOf(const Triangle& t) { return 0.5 * Cross(t[1] - t[0], t[2] - t[0]); }
  static Vector3 MiddleOf(const Triangle& t)
  {
    return t[0] + (1.0 / 3.0) * ((t[1] - t[0]) + (t[2] - t[0]));
  }

  /// Calls visit(middle, area) of the node's parts: triangles or nodes.
  template <class Visit>
  void ForEachPart(const Node<3>& node, Visit visit) const
  {
    for (std::uint32_t i = node.First; i < node.First + node.Count; ++i)
    {
      if (node.IsLeaf)
      {
        visit(i, MiddleOf(this->Triangles[i]), Norm(AreaOf(this->Triangles[i])));
      }
      else
      {
        visit(i, this->Moments[i].Centre, this->Moments[i].Area);
      }
    }
  }

  Moment MomentsOf(const Node<3>& node) const
  {
    Moment moment;
    this->SetCentre(node, moment);
    double radius = 0.0;
    this->ForEachPart(node,
      [&](std::uint32_t i, const Vector3& middle, double area)
      {
        const Vector3 offset = middle - moment.Centre;
        if (node.IsLeaf)
        {
          moment.Add(MomentOf(this->Triangles[i]), offset);
          for (const Vector3& corner : this->Triangles[i])
          {
            const double distance = Norm(corner - moment.Centre);
            radius = std::max(radius, distance);
            moment.ErrorBound3 +=
              area / 3.0 * distance * distance * distance; // convex: the mean is less
          }
          return;
        }
        moment.Add(this->Moments[i], offset);
        radius = std::max(radius, Norm(offset) + std::sqrt(this->Moments[i].Radius2));
        const double root =
          std::cbrt(this->Moments[i].ErrorBound3) + Norm(offset) * std::cbrt(area);
        moment.ErrorBound3 += root * root * root; // Minkowski's inequality
      });
    moment.Radius2 = radius * radius;
    moment.Radius = radius;
    return moment;
  }

  /// The mean position, by area; of parts without area the plain mean.
  void SetCentre(const Node<3>& node, Moment& moment) const
  {
    Vector3 first{ { 0.0, 0.0, 0.0 } }; // sums are made from here: they lose nothing far from 0
    bool isFirst = true;
    this->ForEachPart(node,
      [&](std::uint32_t, const Vector3& middle, double area)
      {
        first = isFirst ? middle : first;
        isFirst = false;
        moment.Area += area;
      });
    moment.Centre = first;
    this->ForEachPart(node,
      [&](std::uint32_t, const Vector3& middle, double area)
      {
        const double share = moment.Area > 0.0 ? area / moment.Area : 1.0 / node.Count;
        moment.Centre = moment.Centre + share * (middle - first);
      });
  }

  const Tree<3>& TheTree;
  std::vector<Triangle> Triangles; // in the order of the tree
  std::vector<Moment> Moments;     // one a node
  double Accuracy;
};

}

#endif
