// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdSpreadCurves.h"

#include "Exchange/SkdCut.h"
#include "Solids/Surfaces/SkdVisitKeys.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace skdtree
{
/// About a segment or point that several processes may have.
struct SkdSpreadCurves::Question
{
  enum Kinds : std::uint16_t
  {
    Candidate, ///< it is to be output, once
    Other      ///< it says something about those of others alone
  };

  SkdContactKey Key;
  std::int64_t Cell; // of the lowest pair
  std::int32_t Block;
  std::uint16_t Kind;
  std::uint16_t Against; // two speak against any
};

/// A point of a chain that is sent, and the segment from there to the next one.
struct SkdSpreadCurves::Step
{
  enum Marks : std::uint64_t
  {
    Last = 1,
    LinkEnd = 2,
    LineEnd = 4
  };

  SkdContactKey Key;
  skd::Vector3 Position;
  SkdContactLabel Label; // of the last the one before
  std::uint64_t Mark;
};

//------------------------------------------------------------------------------
/// Of points that other processes may have.
struct SkdSpreadCurves::Ends
{
  std::vector<bool> AreEnds;          ///< more than two segments of all processes meet there
  std::vector<std::int32_t> Partners; ///< the process that goes on from there; -1: none
};

/// Lines that go on on other processes.
struct SkdSpreadCurves::Chains
{
  std::vector<std::size_t> Lines;
  std::vector<SkdChain> Chosen; ///< of each curve one of its chains, whose process joins it
};

namespace
{
template <class Row>
using ByProcess = SkdRowsByProcess<Row>;

std::size_t ProcessOf(const SkdContactKey& key, std::size_t processes)
{
  return static_cast<std::size_t>(key.Low % processes);
}

/// Instead of the number of a question: of a segment that no other process may have it is known.
constexpr std::size_t IsKept = ~std::size_t(0);
constexpr std::size_t IsLeftOut = IsKept - 1;

/// How many segments end at a point.
struct Degree
{
  SkdContactKey Key;
  std::int32_t Count;
};

/// The same of all processes; and if these are one of the process that asked and one of another,
/// this one, else -1.
struct TotalDegree
{
  std::int32_t Count = 0;
  std::int32_t Partner = -1;
};

ByProcess<TotalDegree> AddDegrees(const ByProcess<Degree>& questions)
{
  ByProcess<TotalDegree> answers;
  for (const std::vector<Degree>& some : questions)
  {
    answers.emplace_back(some.size());
  }
  SkdVisitKeys(
    questions, [](const Degree&, const Degree&) { return false; },
    [&](auto first, auto last)
    {
      std::int32_t sum = 0;
      std::for_each(first, last,
        [&](const SkdAsked& asked) { sum += questions[asked.Process][asked.Number].Count; });
      const bool areTwo = sum == 2 && last - first == 2;
      for (auto each = first; each != last; ++each)
      {
        const auto other = each == first ? first + 1 : first;
        answers[each->Process][each->Number] = { sum,
          areTwo ? static_cast<std::int32_t>(other->Process) : -1 };
      }
    });
  return answers;
}

/// The end of a chain at a point that a chain of another process goes on from.
struct Link
{
  SkdContactKey Key;
  std::uint32_t End;

  bool operator<(const Link& other) const { return this->Key < other.Key; }
};

std::vector<SkdEndPair>::iterator FindSides(
  std::vector<SkdEndPair>& sides, std::vector<SkdEndPair>::iterator from, const SkdEndPair& segment)
{
  return std::lower_bound(from, sides.end(), segment,
    [](const SkdEndPair& a, const SkdEndPair& b)
    { return std::tie(a.A, a.B) < std::tie(b.A, b.B); });
}
}

//------------------------------------------------------------------------------
SkdSpreadCurves::SkdSpreadCurves(
  SkdTransport& transport, const SkdSpreadPoints& points, std::vector<skd::Box3> triangles)
  : Transport(transport)
  , Points(points)
  , AreShared(points.Keys.size(), 0)
{
  const SkdCut cut(transport, std::move(triangles));
  const int own = transport.GetRank();
  std::vector<int> processes;
  for (std::size_t point = 0; point < this->AreShared.size(); ++point)
  {
    cut.FindOverlapping(points.Around[point], processes);
    this->AreShared[point] = std::any_of(
      processes.begin(), processes.end(), [own](int process) { return process != own; });
  }
}

// Of those with a key the lowest candidate is output, unless something speaks against all.
std::vector<unsigned char> SkdSpreadCurves::AskWhether(const std::vector<Question>& questions)
{
  const auto processes = static_cast<std::size_t>(this->Transport.GetNumber());
  ByProcess<Question> sent(processes);
  ByProcess<std::size_t> askers(processes);
  for (std::size_t i = 0; i < questions.size(); ++i)
  {
    const std::size_t to = ProcessOf(questions[i].Key, processes);
    sent[to].push_back(questions[i]);
    askers[to].push_back(i);
  }
  const auto isBefore = [](const Question& a, const Question& b)
  { return std::tie(a.Kind, a.Block, a.Cell) < std::tie(b.Kind, b.Block, b.Cell); };
  const auto answer = [&isBefore](const ByProcess<Question>& asked)
  {
    ByProcess<unsigned char> answers;
    for (const std::vector<Question>& some : asked)
    {
      answers.emplace_back(some.size(), static_cast<unsigned char>(0));
    }
    SkdVisitKeys(asked, isBefore,
      [&](auto first, auto last)
      {
        int against = 0;
        std::for_each(first, last,
          [&](const SkdAsked& each) { against += asked[each.Process][each.Number].Against; });
        answers[first->Process][first->Number] = against < 2 ? 1 : 0;
      });
    return answers;
  };
  const ByProcess<unsigned char> answers = SkdAsk<unsigned char>(this->Transport, sent, answer);
  std::vector<unsigned char> are(questions.size());
  for (std::size_t to = 0; to < processes; ++to)
  {
    for (std::size_t i = 0; i < askers[to].size(); ++i)
    {
      are[askers[to][i]] = answers[to][i];
    }
  }
  return are;
}

// Sides of polygons of overlap count for the segments of others, too.
void SkdSpreadCurves::LeaveOutSegments(SkdCurveParts& parts, const FindLabel& labelOf)
{
  std::vector<Question> questions;
  std::vector<std::size_t> asked(parts.Segments.size(), IsKept);
  const auto ask = [&](const SkdEndPair& ends, bool isCandidate, std::ptrdiff_t sides)
  {
    const SkdContactLabel label = labelOf(ends.Origin);
    questions.push_back(
      { SkdContactKey::OfSegment(this->Points.Keys[ends.A], this->Points.Keys[ends.B]),
        label.FirstCell, label.FirstBlock, isCandidate ? Question::Candidate : Question::Other,
        static_cast<std::uint16_t>(std::min<std::ptrdiff_t>(sides, 2)) });
  };
  auto side = parts.Sides.begin();
  const auto endOf = [&](std::vector<SkdEndPair>::iterator first)
  {
    return std::find_if(first, parts.Sides.end(),
      [&](const SkdEndPair& each) { return each.A != first->A || each.B != first->B; });
  };
  const auto askSidesBefore = [&](std::vector<SkdEndPair>::iterator last)
  {
    while (side != last)
    {
      const auto end = endOf(side);
      if (this->MayBeShared(*side))
      {
        ask(*side, false, end - side);
      }
      side = end;
    }
  };
  for (std::size_t i = 0; i < parts.Segments.size(); ++i)
  {
    const SkdEndPair& segment = parts.Segments[i];
    const auto first = FindSides(parts.Sides, side, segment);
    askSidesBefore(first);
    const bool hasSides =
      first != parts.Sides.end() && first->A == segment.A && first->B == segment.B;
    side = hasSides ? endOf(first) : first;
    if (this->MayBeShared(segment))
    {
      asked[i] = questions.size();
      ask(segment, true, side - first);
    }
    else if (side - first >= 2)
    {
      asked[i] = IsLeftOut;
    }
  }
  askSidesBefore(parts.Sides.end());
  const std::vector<unsigned char> are = this->AskWhether(questions);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < parts.Segments.size(); ++i)
  {
    if (asked[i] < are.size() ? are[asked[i]] != 0 : asked[i] == IsKept)
    {
      parts.Segments[kept++] = parts.Segments[i];
    }
  }
  parts.Segments.resize(kept);
}

void SkdSpreadCurves::LeaveOutPoints(SkdCurveParts& parts, const FindLabel& labelOf)
{
  std::vector<Question> questions;
  std::vector<SkdEndPair> kept;
  std::vector<SkdEndPair> asked;
  for (const SkdEndPair& lone : parts.Lone)
  {
    const bool isShared = this->AreShared[lone.A] != 0;
    (isShared ? asked : kept).push_back(lone);
    if (isShared)
    {
      const SkdContactLabel label = labelOf(lone.Origin);
      questions.push_back(
        { this->Points.Keys[lone.A], label.FirstCell, label.FirstBlock, Question::Candidate, 0 });
    }
  }
  for (std::size_t point = 0; point < parts.IsOther.size(); ++point)
  {
    if (parts.IsOther[point] && this->AreShared[point] != 0)
    {
      questions.push_back({ this->Points.Keys[point], 0, 0, Question::Other, 2 });
    }
  }
  const std::vector<unsigned char> are = this->AskWhether(questions);
  for (std::size_t i = 0; i < asked.size(); ++i)
  {
    if (are[i] != 0)
    {
      kept.push_back(asked[i]);
    }
  }
  std::sort(kept.begin(), kept.end(),
    [](const SkdEndPair& a, const SkdEndPair& b) { return a.Origin < b.Origin; });
  parts.Lone = std::move(kept);
}

//------------------------------------------------------------------------------
SkdSpreadCurves::Ends SkdSpreadCurves::CountAtEnds(const std::vector<SkdEndPair>& segments)
{
  std::vector<std::int32_t> counts(this->AreShared.size(), 0);
  for (const SkdEndPair& segment : segments)
  {
    ++counts[segment.A];
    ++counts[segment.B];
  }
  const auto processes = static_cast<std::size_t>(this->Transport.GetNumber());
  ByProcess<Degree> questions(processes);
  ByProcess<std::size_t> points(processes);
  for (std::size_t point = 0; point < counts.size(); ++point)
  {
    if (counts[point] > 0 && this->AreShared[point] != 0)
    {
      const std::size_t to = ProcessOf(this->Points.Keys[point], processes);
      questions[to].push_back({ this->Points.Keys[point], counts[point] });
      points[to].push_back(point);
    }
  }
  const ByProcess<TotalDegree> answers =
    SkdAsk<TotalDegree>(this->Transport, questions, AddDegrees);
  Ends ends{ std::vector<bool>(counts.size(), false),
    std::vector<std::int32_t>(counts.size(), -1) };
  for (std::size_t to = 0; to < processes; ++to)
  {
    for (std::size_t i = 0; i < points[to].size(); ++i)
    {
      ends.AreEnds[points[to][i]] = answers[to][i].Count > 2;
      ends.Partners[points[to][i]] = answers[to][i].Partner;
    }
  }
  return ends;
}

// Both processes of a link tell each other their ends of it.
std::vector<SkdChainEnd> SkdSpreadCurves::FindLinks(
  const std::vector<SkdPolyline>& lines, const std::vector<std::size_t>& chains, const Ends& ends)
{
  ByProcess<Link> own(static_cast<std::size_t>(this->Transport.GetNumber()));
  for (std::size_t chain = 0; chain < chains.size(); ++chain)
  {
    const std::vector<std::uint32_t>& points = lines[chains[chain]].Points;
    for (const std::uint32_t side : { 0u, 1u })
    {
      const std::uint32_t point = side == 0 ? points.front() : points.back();
      if (ends.Partners[point] >= 0)
      {
        own[static_cast<std::size_t>(ends.Partners[point])].push_back(
          { this->Points.Keys[point], static_cast<std::uint32_t>(2 * chain + side) });
      }
    }
  }
  std::vector<SkdChainEnd> links(2 * chains.size());
  ByProcess<Link> others = SkdExchangeRows(this->Transport, own);
  for (std::size_t process = 0; process < own.size(); ++process)
  {
    std::sort(own[process].begin(), own[process].end());
    for (const Link& other : others[process])
    {
      const auto at = std::lower_bound(own[process].begin(), own[process].end(), other);
      if (at != own[process].end() && at->Key == other.Key)
      {
        links[at->End] = { static_cast<std::int32_t>(process), other.End };
      }
    }
  }
  return links;
}

//------------------------------------------------------------------------------
/// Puts chains that came together with a process's own segments.
class SkdSpreadCurves::Receiver
{
public:
  Receiver(SkdCurves& curves, std::vector<SkdContactKey> keys, std::vector<bool> areEnds,
    std::size_t pairs)
    : Curves(curves)
    , Keys(std::move(keys))
    , AreEnds(std::move(areEnds))
    , Pairs(pairs)
  {
  }

  /// A point where a chain goes on, or where it ends.
  void AddLink(std::uint32_t point) { this->Links.emplace(this->Keys[point], point); }
  void AddEnd(std::uint32_t point) { this->AreEnds[point] = true; }

  void Take(const std::vector<Step>& steps)
  {
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      const std::uint32_t point = this->NumberOf(steps[i]);
      if (i > 0 && (steps[i - 1].Mark & Step::Last) == 0)
      {
        this->Curves.Segments.push_back(
          { this->Before, point, this->Pairs + this->Curves.ReceivedLabels.size() });
        this->Curves.ReceivedLabels.push_back(steps[i - 1].Label);
      }
      this->Before = point;
    }
  }

  const std::vector<SkdContactKey>& GetKeys() const { return this->Keys; }
  std::vector<bool> TakeEnds() { return std::move(this->AreEnds); }

private:
  std::uint32_t NumberOf(const Step& step)
  {
    const auto next = static_cast<std::uint32_t>(this->Keys.size());
    if ((step.Mark & Step::LinkEnd) != 0)
    {
      const auto [at, isNew] = this->Links.emplace(step.Key, next);
      if (!isNew)
      {
        return at->second;
      }
    }
    this->Keys.push_back(step.Key);
    this->AreEnds.push_back((step.Mark & Step::LineEnd) != 0);
    this->Curves.ReceivedPoints.push_back(step.Position);
    return next;
  }

  SkdCurves& Curves;
  std::vector<SkdContactKey> Keys;
  std::vector<bool> AreEnds;
  std::size_t Pairs;
  std::map<SkdContactKey, std::uint32_t> Links;
  std::uint32_t Before = 0;
};

// Removes the segments of chains that are joined elsewhere, and makes what is sent of them.
SkdRowsByProcess<SkdSpreadCurves::Step> SkdSpreadCurves::TakeAway(
  SkdCurves& curves, const Chains& chains, const Ends& ends, const FindLabel& labelOf)
{
  ByProcess<Step> sent(static_cast<std::size_t>(this->Transport.GetNumber()));
  std::vector<bool> areSent(curves.Segments.size(), false);
  for (std::size_t chain = 0; chain < chains.Lines.size(); ++chain)
  {
    const SkdPolyline& line = curves.Lines[chains.Lines[chain]];
    const std::int32_t to = chains.Chosen[chain].Process;
    const std::size_t n = line.Points.size();
    for (std::size_t i = 0; to != this->Transport.GetRank() && i < n; ++i)
    {
      const std::uint32_t point = line.Points[i];
      const std::size_t segment = line.Segments[std::min(i, n - 2)];
      const std::uint64_t end = ends.Partners[point] >= 0 ? Step::LinkEnd : Step::LineEnd;
      const std::uint64_t mark =
        (i == 0 ? end : 0) | (i + 1 == n ? end | static_cast<std::uint64_t>(Step::Last) : 0);
      sent[static_cast<std::size_t>(to)].push_back({ this->Points.Keys[point],
        this->Points.Positions[point], labelOf(curves.Segments[segment].Origin), mark });
      areSent[segment] = true;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < areSent.size(); ++i)
  {
    if (!areSent[i])
    {
      curves.Segments[kept++] = curves.Segments[i];
    }
  }
  curves.Segments.resize(kept);
  return sent;
}

// Lines end where they did before some of those that meet there were sent away.
void SkdSpreadCurves::Bring(SkdCurves& curves, const Chains& chains, const Ends& ends,
  std::size_t pairs, const FindLabel& labelOf)
{
  Receiver receiver(curves, this->Points.Keys, ends.AreEnds, pairs);
  for (const SkdPolyline& line : curves.Lines)
  {
    for (const std::uint32_t point : { line.Points.front(), line.Points.back() })
    {
      if (ends.Partners[point] >= 0)
      {
        receiver.AddLink(point);
      }
      else if (!line.IsClosed)
      {
        receiver.AddEnd(point);
      }
    }
  }
  const ByProcess<Step> sent = this->TakeAway(curves, chains, ends, labelOf);
  for (const std::vector<Step>& steps : SkdExchangeRows(this->Transport, sent))
  {
    receiver.Take(steps);
  }
  curves.Lines = this->Join(curves, receiver.GetKeys(), receiver.TakeEnds());
}

std::vector<SkdPolyline> SkdSpreadCurves::Join(
  const SkdCurves& curves, const std::vector<SkdContactKey>& keys, std::vector<bool> areEnds) const
{
  const std::size_t own = this->Points.Positions.size();
  const auto positionOf = [&](std::uint32_t point) -> const skd::Vector3&
  { return point < own ? this->Points.Positions[point] : curves.ReceivedPoints[point - own]; };
  const auto isBefore = [&](std::uint32_t a, std::uint32_t b)
  {
    const skd::Vector3& x = positionOf(a);
    const skd::Vector3& y = positionOf(b);
    return x == y ? keys[a] < keys[b] : x < y;
  };
  return SkdJoinSegments(
    curves.Segments, { static_cast<std::uint32_t>(keys.size()), isBefore, std::move(areEnds) });
}

//------------------------------------------------------------------------------
void SkdSpreadCurves::LeaveOutRepeated(SkdCurveParts& parts, const FindLabel& labelOf)
{
  this->LeaveOutSegments(parts, labelOf);
  if (SkdIsAny(this->Transport,
        std::any_of(parts.Lone.begin(), parts.Lone.end(),
          [this](const SkdEndPair& lone) { return this->AreShared[lone.A] != 0; })))
  {
    this->LeaveOutPoints(parts, labelOf);
  }
}

SkdCurves SkdSpreadCurves::Find(
  SkdCurveParts parts, std::size_t pairs, const FindLabel& labelOf, bool areJoined)
{
  const bool areAnyShared = SkdIsAny(this->Transport,
    std::any_of(
      this->AreShared.begin(), this->AreShared.end(), [](unsigned char is) { return is != 0; }));
  if (areAnyShared)
  {
    this->LeaveOutRepeated(parts, labelOf);
  }
  else
  {
    parts.LeaveOutInside();
  }
  SkdCurves curves;
  curves.Lone = std::move(parts.Lone);
  curves.Segments = std::move(parts.Segments);
  Ends ends;
  if (areAnyShared)
  {
    ends = this->CountAtEnds(curves.Segments);
  }
  curves.Lines = this->Join(curves, this->Points.Keys, ends.AreEnds);
  curves.Number = static_cast<vtkIdType>(curves.Lines.size());
  Chains chains;
  for (std::size_t i = 0; areAnyShared && i < curves.Lines.size(); ++i)
  {
    const std::vector<std::uint32_t>& points = curves.Lines[i].Points;
    if (ends.Partners[points.front()] >= 0 || ends.Partners[points.back()] >= 0)
    {
      chains.Lines.push_back(i);
    }
  }
  if (areAnyShared && SkdIsAny(this->Transport, !chains.Lines.empty()))
  {
    this->Choose(chains, curves, ends);
    if (areJoined)
    {
      this->Bring(curves, chains, ends, pairs, labelOf);
    }
  }
  return curves;
}

// A curve counts where the chain is that was chosen of all its chains.
void SkdSpreadCurves::Choose(Chains& chains, SkdCurves& curves, const Ends& ends)
{
  std::vector<std::uint32_t> lengths;
  for (const std::size_t line : chains.Lines)
  {
    lengths.push_back(static_cast<std::uint32_t>(curves.Lines[line].Segments.size()));
  }
  chains.Chosen =
    SkdChooseChains(this->Transport, lengths, this->FindLinks(curves.Lines, chains.Lines, ends));
  for (std::size_t chain = 0; chain < chains.Chosen.size(); ++chain)
  {
    const SkdChain& chosen = chains.Chosen[chain];
    const bool isThis = chosen.Process == this->Transport.GetRank() && chosen.Number == chain;
    curves.Number -= isThis ? 0 : 1;
  }
}
}
