// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_IntersectionSearch_h
#define skd_Curves_IntersectionSearch_h

#include "../Geometry/Segment.h"
#include "Tolerances.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace skd
{

/// What the solvers of two curves and of a curve and a patch share: cells that are examined, halved
/// and examined again until none is left, and what is put down on the way. One a thread: it keeps
/// its memory.
template <class Cell, class Hit, class Contact>
class IntersectionSearch
{
protected:
  static constexpr int CellBudget = 20000; ///< what is left then may touch: see ResolveContacts

  void Clear()
  {
    this->Hits.clear();
    this->Contacts.clear();
    this->Stack.clear();
    this->Resolved = 0;
  }

  /// All that a pair has in common: nothing if the hulls of the whole are apart; intervals if the
  /// curve is within the other; else what is found below the whole. Calls examine(cell, whether it
  /// may be halved) for it and for what is put on the stack then.
  template <class Hulls, class Within, class Pair, class Examine>
  const std::vector<Hit>& Search(const Cell& whole, const Pair& pair, Examine examine)
  {
    if (Hulls(whole).AreApart(pair.Tolerance) || Within(pair).Find(this->Hits))
    {
      return this->Hits;
    }
    this->Stack.push_back(whole);
    for (int budget = CellBudget; !this->Stack.empty(); --budget)
    {
      const Cell cell = this->Stack.back();
      this->Stack.pop_back();
      examine(cell, budget > 0);
    }
    this->ResolveContacts(pair);
    this->Unite(pair);
    return this->Hits;
  }

  /// Puts together the contacts that follow each other along the curve, and lets the pair resolve
  /// each of them: from its middle, over the whole range. Long ones, of what the budget has left,
  /// may hold several points: they are resolved bit by bit.
  template <class Pair>
  void ResolveContacts(const Pair& pair)
  {
    std::sort(this->Contacts.begin(), this->Contacts.end(),
      [](const Contact& a, const Contact& b) { return a.T.Min < b.T.Min; });
    for (std::size_t first = 0; first < this->Contacts.size();)
    {
      Interval range = this->Contacts[first].T;
      std::size_t last = first + 1;
      while (last < this->Contacts.size() &&
        this->Contacts[last].T.Min <= range.Max + tolerances::ContactStep)
      {
        range.Max = std::max(range.Max, this->Contacts[last++].T.Max);
      }
      this->ResolveRange(pair, range, first, last);
      first = last;
    }
  }

  /// Makes one of those that are one point: a root on the border of cells was found from each of
  /// them, and one that is not simple may have been found as several. What these are together, the
  /// pair decides.
  template <class Pair>
  void Unite(const Pair& pair)
  {
    this->MakeOneOfEqual(pair);
    bool isMoved = false;
    for (std::size_t i = 0; i < this->Hits.size(); ++i)
    {
      isMoved = TellWhatItIs(pair, this->Ranges[i], this->Hits[i]) || isMoved;
    }
    if (isMoved)
    {
      this->MakeOneOfEqual(pair);
    }
  }

  /// Whether a root is of a cell, or rounding, which it may be off by, has pushed it out.
  static bool Holds(const Interval& interval, double value, double rounding)
  {
    const double slack =
      tolerances::CellShare * (interval.Max - interval.Min) + tolerances::ContactStep + rounding;
    return value >= interval.Min - slack && value <= interval.Max + slack;
  }

private:
  template <class Pair>
  static bool IsSame(const Pair& pair, const Hit& a, const Interval& range, const Hit& b)
  {
    constexpr double longest = 1.0 / 16;
    const bool isDoubtful =
      a.IsResolved || b.IsResolved || pair.IsDoubtful(a) || pair.IsDoubtful(b);
    return pair.IsSameIntersection(a, b) ||
      (b.T - range.Max <= (isDoubtful ? longest : tolerances::SimpleGap) &&
        pair.IsOneContact(a, b));
  }

  /// Keeps the first of those that are the same, and what range they take.
  template <class Pair>
  void MakeOneOfEqual(const Pair& pair)
  {
    std::sort(this->Hits.begin(), this->Hits.end(), Pair::IsBefore);
    this->Ranges.clear();
    std::size_t retained = 0;
    for (const Hit& hit : this->Hits)
    {
      std::size_t same = 0;
      while (same < retained && !IsSame(pair, this->Hits[same], this->Ranges[same], hit))
      {
        ++same;
      }
      if (same == retained)
      {
        this->Hits[retained++] = hit;
        this->Ranges.push_back({ hit.T, hit.T });
      }
      this->Ranges[same].Max = hit.T;
    }
    this->Hits.resize(retained);
  }

  /// Whether it was anything but a simple root, and may have been moved.
  template <class Pair>
  static bool TellWhatItIs(const Pair& pair, const Interval& range, Hit& hit)
  {
    const bool isSimple =
      range.Max - range.Min <= tolerances::SameParameter && !pair.IsDoubtful(hit);
    const auto resolved =
      isSimple ? std::optional<Hit>() : pair.Resolve(pair.ContactAt(range, hit));
    hit = resolved ? *resolved : hit;
    return resolved.has_value();
  }

  /// The range that contacts from `first` to before `last` make up.
  template <class Pair>
  void ResolveRange(const Pair& pair, const Interval& range, std::size_t first, std::size_t last)
  {
    constexpr double longest = 1.0 / 256;
    const double length = range.Max - range.Min;
    const int bits = 1 + static_cast<int>(length / longest);
    for (int i = 0; i < bits; ++i)
    {
      const Interval bit{ range.Min + i * length / bits, range.Min + (i + 1) * length / bits };
      Contact contact = bits == 1 ? this->Contacts[(first + last) / 2]
                                  : this->NearestContact(0.5 * (bit.Min + bit.Max), first, last);
      contact.T = bit;
      const auto hit = pair.Resolve(contact);
      if (hit && (this->Resolved == 0 || !pair.IsOneContact(this->Hits.back(), *hit)))
      {
        this->Hits.push_back(*hit);
        ++this->Resolved;
      }
    }
  }

  const Contact& NearestContact(double t, std::size_t first, std::size_t last) const
  {
    const auto distance = [t](const Contact& contact)
    { return std::abs(0.5 * (contact.T.Min + contact.T.Max) - t); };
    return *std::min_element(this->Contacts.begin() + static_cast<std::ptrdiff_t>(first),
      this->Contacts.begin() + static_cast<std::ptrdiff_t>(last),
      [&](const Contact& a, const Contact& b) { return distance(a) < distance(b); });
  }

protected:
  std::vector<Hit> Hits;
  std::vector<Contact> Contacts;
  std::vector<Cell> Stack;

private:
  std::vector<Interval> Ranges; ///< of what is one of the hits
  std::size_t Resolved = 0;     ///< of the hits, how many were contacts
};

}

#endif
