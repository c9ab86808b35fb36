// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdMeetingJoints_h
#define SkdMeetingJoints_h

#include "Curves/SkdCurveSet.h"
#include "Curves/SkdSurfaceHit.h"
#include "Curves/SkdSurfaceSet.h"

#include <tuple>

/// Where curves that go on as each other meet a surface in the joint, it is one place.
class SkdMeetingJoints
{
public:
  SkdMeetingJoints(const SkdCurveSet& curves, const std::vector<SkdSurfaceElement>& elements)
    : Curves(curves)
    , Elements(elements)
  {
  }

  /// The meetings with those at joints told once a part, of the curve of the lowest number.
  std::vector<SkdSurfaceMeeting> Unite(std::vector<SkdSurfaceMeeting> meetings) const;

private:
  struct AtJoint
  {
    std::size_t Joint;
    int Part;
    std::size_t Meeting;
    bool AtEnd; ///< of its curve

    bool operator<(const AtJoint& other) const
    {
      return std::tie(this->Joint, this->Part, this->Meeting) <
        std::tie(other.Joint, other.Part, other.Meeting);
    }
  };

  std::vector<AtJoint> Find(const std::vector<SkdSurfaceMeeting>& meetings) const;
  static void Add(SkdSurfaceMeeting& to, bool toAtEnd, const SkdSurfaceMeeting& other, bool atEnd);

  const SkdCurveSet& Curves;
  const std::vector<SkdSurfaceElement>& Elements;
};

#endif
