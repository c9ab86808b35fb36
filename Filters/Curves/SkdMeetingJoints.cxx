// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdMeetingJoints.h"

#include <algorithm>
#include <limits>

//------------------------------------------------------------------------------
std::vector<SkdMeetingJoints::AtJoint> SkdMeetingJoints::Find(
  const std::vector<SkdSurfaceMeeting>& meetings) const
{
  std::vector<AtJoint> found;
  for (std::size_t i = 0; i < meetings.size(); ++i)
  {
    const SkdSurfaceHit& hit = meetings[i].Hit;
    const double slack = hit.IsExact ? 0.0 : hit.Slack;
    std::size_t joint = SkdCurveJoints::None;
    if (this->Curves.IsAtEnd(hit.Curve, hit.U, slack, joint) && joint != SkdCurveJoints::None)
    {
      const bool atEnd = hit.U > slack;
      found.push_back({ joint, this->Elements[hit.Element].Part, i, atEnd });
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

//------------------------------------------------------------------------------
// Along the first of the two: what the other tells is turned if it runs against it.
void SkdMeetingJoints::Add(
  SkdSurfaceMeeting& to, bool toAtEnd, const SkdSurfaceMeeting& other, bool atEnd)
{
  const int sum = to.Sense + (toAtEnd != atEnd ? other.Sense : -other.Sense);
  const int coming = toAtEnd ? to.Before : to.After;
  const int going = atEnd ? other.Before : other.After;
  to.Sense = (sum > 0) - (sum < 0);
  if (coming != 0 && going != 0)
  {
    to.Sense = coming == going ? 0 : (toAtEnd ? coming : going);
  }
  to.Hit.Kind = to.Sense != 0 ? skd::MeetingKind::Crossing : skd::MeetingKind::Touching;
}

//------------------------------------------------------------------------------
std::vector<SkdSurfaceMeeting> SkdMeetingJoints::Unite(
  std::vector<SkdSurfaceMeeting> meetings) const
{
  const std::vector<AtJoint> found = this->Find(meetings);
  std::vector<char> isLeftOut(meetings.size(), 0);
  for (std::size_t i = 0; i + 1 < found.size(); ++i)
  {
    const AtJoint& one = found[i];
    const AtJoint& other = found[i + 1];
    if (one.Joint != other.Joint || one.Part != other.Part)
    {
      continue;
    }
    SkdSurfaceMeeting& first = meetings[one.Meeting];
    const SkdSurfaceMeeting& second = meetings[other.Meeting];
    const bool endsStretch = first.Hit.Kind == skd::MeetingKind::OverlapEnd;
    if (!endsStretch && second.Hit.Kind != skd::MeetingKind::OverlapEnd)
    {
      Add(first, one.AtEnd, second, other.AtEnd);
    }
    if (second.Hit.Kind != skd::MeetingKind::OverlapEnd)
    {
      isLeftOut[other.Meeting] = 1;
    }
    else if (!endsStretch)
    {
      isLeftOut[one.Meeting] = 1;
    }
    ++i; // no more than two curves share a joint
  }
  std::vector<SkdSurfaceMeeting> left;
  for (std::size_t i = 0; i < meetings.size(); ++i)
  {
    if (!isLeftOut[i])
    {
      left.push_back(meetings[i]);
    }
  }
  return left;
}
