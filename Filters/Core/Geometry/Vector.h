// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Vector_h
#define skd_Geometry_Vector_h

#include <algorithm>
#include <cmath>

namespace skd
{

/// A point or a direction of D coordinates. An aggregate: Vector<3>{ { x, y, z } }.
template <int D>
struct Vector
{
  double X[D];

  double& operator[](int axis) { return this->X[axis]; }
  double operator[](int axis) const { return this->X[axis]; }
};

using Vector3 = Vector<3>;

template <int D>
Vector<D> operator+(Vector<D> a, const Vector<D>& b)
{
  for (int axis = 0; axis < D; ++axis)
  {
    a[axis] += b[axis];
  }
  return a;
}

template <int D>
Vector<D> operator-(Vector<D> a, const Vector<D>& b)
{
  for (int axis = 0; axis < D; ++axis)
  {
    a[axis] -= b[axis];
  }
  return a;
}

template <int D>
Vector<D> operator*(double factor, Vector<D> a)
{
  for (int axis = 0; axis < D; ++axis)
  {
    a[axis] *= factor;
  }
  return a;
}

template <int D>
bool operator==(const Vector<D>& a, const Vector<D>& b)
{
  for (int axis = 0; axis < D; ++axis)
  {
    if (!(a[axis] == b[axis]))
    {
      return false;
    }
  }
  return true;
}

/// Lexicographic order: the same for the same coordinates, whatever ids they bear.
template <int D>
bool operator<(const Vector<D>& a, const Vector<D>& b)
{
  for (int axis = 0; axis < D; ++axis)
  {
    if (a[axis] != b[axis])
    {
      return a[axis] < b[axis];
    }
  }
  return false;
}

template <int D>
double Dot(const Vector<D>& a, const Vector<D>& b)
{
  double sum = 0.0;
  for (int axis = 0; axis < D; ++axis)
  {
    sum += a[axis] * b[axis];
  }
  return sum;
}

/// Of each coordinate the less, or the greater.
template <int D>
Vector<D> Least(Vector<D> a, const Vector<D>& b)
{
  for (int axis = 0; axis < D; ++axis)
  {
    a[axis] = std::min(a[axis], b[axis]);
  }
  return a;
}
template <int D>
Vector<D> Greatest(Vector<D> a, const Vector<D>& b)
{
  for (int axis = 0; axis < D; ++axis)
  {
    a[axis] = std::max(a[axis], b[axis]);
  }
  return a;
}

template <int D>
double Norm2(const Vector<D>& a)
{
  return Dot(a, a);
}

template <int D>
double Norm(const Vector<D>& a)
{
  return std::sqrt(Norm2(a));
}

template <int D>
double Distance2(const Vector<D>& a, const Vector<D>& b)
{
  return Norm2(a - b);
}

/// The point a + t (b - a).
template <int D>
Vector<D> Lerp(const Vector<D>& a, const Vector<D>& b, double t)
{
  return a + t * (b - a);
}

// In space the same once more, written out: compilers keep these in registers, and so are two to
// three times as fast with them as with the loops above.

inline Vector3 operator+(const Vector3& a, const Vector3& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}

inline Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

inline Vector3 operator*(double factor, const Vector3& a)
{
  return { { factor * a[0], factor * a[1], factor * a[2] } };
}

inline Vector3 Least(const Vector3& a, const Vector3& b)
{
  return { { std::min(a[0], b[0]), std::min(a[1], b[1]), std::min(a[2], b[2]) } };
}

inline Vector3 Greatest(const Vector3& a, const Vector3& b)
{
  return { { std::max(a[0], b[0]), std::max(a[1], b[1]), std::max(a[2], b[2]) } };
}

inline double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

/// The axis of the largest component by its amount, the first of equal ones.
inline int LargestAxis(const Vector3& a)
{
  const int axis = std::abs(a[1]) > std::abs(a[0]) ? 1 : 0;
  return std::abs(a[2]) > std::abs(a[axis]) ? 2 : axis;
}

/// False when a coordinate is NaN or infinite.
template <int D>
bool IsFinite(const Vector<D>& a)
{
  for (int axis = 0; axis < D; ++axis)
  {
    if (!std::isfinite(a[axis]))
    {
      return false;
    }
  }
  return true;
}

}

#endif
