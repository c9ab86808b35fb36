// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Compare/SkdDistanceSamples.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Relative: what rounding takes from a sum of 2^24 weights, at random (the square root of their
/// number times 2^-53 is 4.5e-13). Without it a quantile of equal weights may be the next sample's.
constexpr double WeightRounding = 1e-12;

/// The elements of a set and where their samples begin.
class Sampling
{
public:
  Sampling(const SkdComparedSet& set, double spacing)
    : Set(set)
    , Spacing(spacing)
  {
    constexpr double most = 1 << 24;
    while (this->Spacing > 0.0 && this->CountAll() > most)
    {
      this->Spacing *= 1.5;
    }
    for (vtkIdType i = 0; i < this->GetNumberOfElements(); ++i)
    {
      const vtkIdType n = this->GetDivisions(i);
      this->Firsts.push_back(this->Firsts.back() + n * n);
    }
  }

  vtkIdType GetNumberOfElements() const
  {
    return static_cast<vtkIdType>(this->Set.GetElements().size());
  }
  vtkIdType GetFirst(vtkIdType element) const { return this->Firsts[element]; }
  vtkIdType GetNumberOfSamples() const { return this->Firsts.back(); }

  /// 1 of a point.
  double GetWeight(vtkIdType element) const;

  /// Calls visit(sample, its place).
  template <class Visit>
  void ForEachSample(vtkIdType element, const Visit& visit) const;

private:
  vtkIdType GetDivisions(vtkIdType element) const;
  double CountAll() const;

  const SkdComparedSet& Set;
  double Spacing;
  std::vector<vtkIdType> Firsts{ 0 };
};

vtkIdType Sampling::GetDivisions(vtkIdType element) const
{
  double longest2 = 0.0;
  for (int corner = 0; corner < 3; ++corner)
  {
    longest2 = std::max(longest2,
      skd::Distance2(
        this->Set.GetCorner(element, corner), this->Set.GetCorner(element, (corner + 1) % 3)));
  }
  const double divisions = this->Spacing > 0.0 ? std::ceil(std::sqrt(longest2) / this->Spacing) : 1;
  return static_cast<vtkIdType>(std::clamp(divisions, 1.0, 4096.0));
}

double Sampling::CountAll() const
{
  double count = 0.0;
  for (vtkIdType i = 0; i < this->GetNumberOfElements(); ++i)
  {
    count += std::pow(static_cast<double>(this->GetDivisions(i)), 2);
  }
  return std::max(0.0, count - this->GetNumberOfElements());
}

double Sampling::GetWeight(vtkIdType element) const
{
  if (!this->Set.IsSurface())
  {
    return 1.0;
  }
  const skd::Vector3& a = this->Set.GetCorner(element, 0);
  const skd::Vector3 normal =
    skd::Cross(this->Set.GetCorner(element, 1) - a, this->Set.GetCorner(element, 2) - a);
  const vtkIdType samples = this->GetFirst(element + 1) - this->GetFirst(element);
  return 0.5 * skd::Norm(normal) / static_cast<double>(samples);
}

// Triangles that stand, and between them those on their heads.
template <class Visit>
void Sampling::ForEachSample(vtkIdType element, const Visit& visit) const
{
  const skd::Vector3& a = this->Set.GetCorner(element, 0);
  const skd::Vector3 u = this->Set.GetCorner(element, 1) - a;
  const skd::Vector3 v = this->Set.GetCorner(element, 2) - a;
  const vtkIdType n = this->GetDivisions(element);
  vtkIdType sample = this->GetFirst(element);
  for (const int third : { 1, 2 })
  {
    const vtkIdType rows = n + 1 - third;
    for (vtkIdType i = 0; i < rows; ++i)
    {
      for (vtkIdType j = 0; i + j < rows; ++j)
      {
        const double r = (static_cast<double>(i) + third / 3.0) / static_cast<double>(n);
        const double s = (static_cast<double>(j) + third / 3.0) / static_cast<double>(n);
        visit(sample++, a + r * u + s * v);
      }
    }
  }
}
}

bool SkdDistanceSamples::Add(
  const SkdComparedSet& from, const SkdComparedSet& to, double spacing, SkdLoop& loop)
{
  const Sampling sampling(from, spacing);
  this->Samples.assign(static_cast<std::size_t>(sampling.GetNumberOfSamples()), { 0.0, 0.0 });
  loop.SetTotal(sampling.GetNumberOfElements());
  return loop.For(sampling.GetNumberOfElements(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double weight = sampling.GetWeight(i);
        double reach = std::numeric_limits<double>::max();
        sampling.ForEachSample(i,
          [&](vtkIdType sample, const skd::Vector3& x)
          {
            if (const auto nearest = to.FindNearest(x, reach))
            {
              const double distance = std::sqrt(nearest->Distance2);
              this->Samples[sample] = { to.IsInside(x) ? -distance : distance, weight };
            }
          });
      }
    });
}

void SkdDistanceSamples::Add(const SkdDistanceSamples& other)
{
  this->Samples.insert(this->Samples.end(), other.Samples.begin(), other.Samples.end());
}

SkdDistanceStatistics SkdDistanceSamples::GetStatistics() const
{
  SkdDistanceStatistics statistics;
  double sums[3] = { 0.0, 0.0, 0.0 };
  for (const Sample& sample : this->Samples)
  {
    statistics.Measure += sample.Weight;
    sums[0] += sample.Weight * std::abs(sample.Distance);
    sums[1] += sample.Weight * sample.Distance;
    sums[2] += sample.Weight * sample.Distance * sample.Distance;
  }
  if (!(statistics.Measure > 0.0))
  {
    return statistics;
  }
  statistics.Mean = sums[0] / statistics.Measure;
  statistics.SignedMean = sums[1] / statistics.Measure;
  statistics.RootMeanSquare = std::sqrt(sums[2] / statistics.Measure);

  std::vector<Sample> sorted = this->Samples;
  std::sort(sorted.begin(), sorted.end(),
    [](const Sample& a, const Sample& b)
    {
      const double nearer = std::abs(a.Distance);
      const double farther = std::abs(b.Distance);
      return nearer != farther ? nearer < farther : a.Weight < b.Weight;
    });
  double below = 0.0;
  std::size_t share = 0;
  for (const Sample& sample : sorted)
  {
    below += sample.Weight;
    while (share < SkdQuantileShares.size() &&
      below >= SkdQuantileShares[share] * statistics.Measure * (1.0 - WeightRounding))
    {
      statistics.Quantiles[share++] = std::abs(sample.Distance);
    }
  }
  return statistics;
}
