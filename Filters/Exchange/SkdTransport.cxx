// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdTransport.h"

#include "vtkMultiProcessController.h"

#include <algorithm>
#include <array>
#include <utility>

#if VTK_MODULE_ENABLE_VTK_ParallelDIY
#include "vtkDIYUtilities.h"
#endif

namespace skdtree
{
namespace
{
/// Bytes of a message that others may pass on, and of those that wait to be sent.
constexpr std::size_t LargestSmall = 4096;
constexpr std::size_t MostStored = std::size_t(1) << 26;

/// The first few messages as one, each after its size.
SkdBytes Join(const std::vector<SkdBytes>& messages, int number)
{
  SkdBytes joined;
  for (int i = 0; i < number; ++i)
  {
    const SkdBytes& message = messages[static_cast<std::size_t>(i)];
    const SkdBytes size = SkdToBytes(std::vector<std::uint64_t>{ message.size() });
    joined.insert(joined.end(), size.begin(), size.end());
    joined.insert(joined.end(), message.begin(), message.end());
  }
  return joined;
}

/// The reverse; adds them to others.
void Split(const SkdBytes& joined, std::vector<SkdBytes>& messages)
{
  auto at = joined.begin();
  while (at != joined.end())
  {
    std::uint64_t size = 0;
    std::memcpy(&size, &*at, sizeof(size));
    at += sizeof(size);
    messages.emplace_back(at, at + static_cast<std::ptrdiff_t>(size));
    at += static_cast<std::ptrdiff_t>(size);
  }
}
}

void SkdTransport::Append(const Packet& packet, SkdBytes& joined)
{
  const std::vector<std::uint64_t> head{ packet.From, packet.To, packet.Size,
    packet.Message.size() };
  const SkdBytes bytes = SkdToBytes(head);
  joined.insert(joined.end(), bytes.begin(), bytes.end());
  joined.insert(joined.end(), packet.Message.begin(), packet.Message.end());
}

void SkdTransport::Unpack(const SkdBytes& joined, std::vector<Packet>& packets)
{
  auto at = joined.begin();
  while (at != joined.end())
  {
    std::array<std::uint64_t, 4> head{};
    std::memcpy(head.data(), &*at, sizeof(head));
    at += sizeof(head);
    const auto end = at + static_cast<std::ptrdiff_t>(head[3]);
    packets.push_back({ static_cast<std::uint32_t>(head[0]), static_cast<std::uint32_t>(head[1]),
      head[2], SkdBytes(at, end) });
    at = end;
  }
}

// Passes packets on to the processes that they are for, by Bruck's other algorithm (as below): what
// is for the process d ranks further on makes a step of 2^k ranks for each bit k of d, and all
// that makes the same step goes together.
void SkdTransport::Route(std::vector<Packet>& packets)
{
  const int number = this->GetNumber();
  const int rank = this->GetRank();
  for (int step = 1; step < number; step *= 2)
  {
    SkdBytes joined;
    std::vector<Packet> rest;
    for (Packet& packet : packets)
    {
      const int distance = (static_cast<int>(packet.To) + number - rank) % number;
      if ((distance & step) != 0)
      {
        Append(packet, joined);
      }
      else
      {
        rest.push_back(std::move(packet));
      }
    }
    Unpack(this->Shift(joined, (rank + step) % number, (rank + number - step) % number), rest);
    packets = std::move(rest);
  }
}

// Makes the message to each other process, and keeps those that are large as long as there is room.
SkdTransport::Outgoing SkdTransport::Prepare(const std::function<SkdBytes(int to)>& make) const
{
  const int number = this->GetNumber();
  const int rank = this->GetRank();
  Outgoing out;
  out.Large.resize(static_cast<std::size_t>(number));
  out.IsLarge.resize(static_cast<std::size_t>(number), false);
  std::size_t stored = 0;
  for (int step = 1; step < number; ++step)
  {
    const int to = (rank + step) % number;
    SkdBytes message = make(to);
    const std::size_t size = message.size();
    const bool isLarge = size > LargestSmall;
    out.IsLarge[static_cast<std::size_t>(to)] = isLarge;
    if (size > 0)
    {
      out.Packets.push_back({ static_cast<std::uint32_t>(rank), static_cast<std::uint32_t>(to),
        size, isLarge ? SkdBytes() : message });
    }
    if (isLarge && stored + size <= MostStored)
    {
      stored += size;
      out.Large[static_cast<std::size_t>(to)] = std::move(message);
    }
  }
  return out;
}

// Large messages in step s to the process s after this one, from the one s before: no process gets
// from two at a time.
void SkdTransport::Exchange(const std::function<SkdBytes(int to)>& make,
  const std::function<void(int from, SkdBytes message)>& take)
{
  const int number = this->GetNumber();
  const int rank = this->GetRank();
  take(rank, make(rank));
  Outgoing out = this->Prepare(make);
  this->Route(out.Packets);
  std::vector<Packet> arrived(static_cast<std::size_t>(number), Packet{ 0, 0, 0, {} });
  for (Packet& packet : out.Packets)
  {
    arrived[packet.From] = std::move(packet);
  }
  for (int step = 1; step < number; ++step)
  {
    const int to = (rank + step) % number;
    const int from = (rank + number - step) % number;
    SkdBytes message = std::move(out.Large[static_cast<std::size_t>(to)]);
    if (message.empty() && out.IsLarge[static_cast<std::size_t>(to)])
    {
      message = make(to);
    }
    Packet& in = arrived[static_cast<std::size_t>(from)];
    const std::size_t size = in.Size > LargestSmall ? static_cast<std::size_t>(in.Size) : 0;
    this->Count(message);
    SkdBytes received = this->Move(message, to, from, size);
    take(from, size > 0 ? std::move(received) : std::move(in.Message));
  }
}

// Of a size that the other tells first.
SkdBytes SkdTransport::Shift(const SkdBytes& message, int to, int from)
{
  std::uint64_t size = message.size();
  const SkdBytes told =
    this->Move(SkdToBytes(std::vector<std::uint64_t>{ size }), to, from, sizeof(size));
  std::memcpy(&size, told.data(), sizeof(size));
  this->Count(message);
  return this->Move(message, to, from, static_cast<std::size_t>(size));
}

void SkdTransport::Count(const SkdBytes& message)
{
  this->Traffic.Messages += message.empty() ? 0 : 1;
  this->Traffic.Bytes += message.size();
}

// By Bruck's algorithm (IEEE Trans. Parallel Distrib. Syst. 8 (1997) 1143): in each step a process
// hands all that it has to the one as many ranks further on, so what each has doubles.
std::vector<SkdBytes> SkdTransport::GatherAll(const SkdBytes& own)
{
  const int number = this->GetNumber();
  const int rank = this->GetRank();
  std::vector<SkdBytes> backwards{ own }; // of this process, the one before, ...
  while (static_cast<int>(backwards.size()) < number)
  {
    const int have = static_cast<int>(backwards.size());
    const SkdBytes joined = Join(backwards, std::min(have, number - have));
    Split(this->Shift(joined, (rank + have) % number, (rank + number - have) % number), backwards);
  }
  std::vector<SkdBytes> all(backwards.size());
  for (int i = 0; i < number; ++i)
  {
    all[static_cast<std::size_t>((rank + number - i) % number)] =
      std::move(backwards[static_cast<std::size_t>(i)]);
  }
  return all;
}

#if VTK_MODULE_ENABLE_VTK_ParallelDIY
namespace
{
class DIYTransport : public SkdTransport
{
public:
  explicit DIYTransport(const diy::mpi::communicator& communicator)
    : Communicator(communicator)
  {
  }

  int GetRank() const override { return this->Communicator.rank(); }
  int GetNumber() const override { return this->Communicator.size(); }

protected:
  // In rounds: MPI counts in int, and copies what it has not sent yet.
  SkdBytes Move(const SkdBytes& message, int to, int from, std::size_t size) override
  {
    SkdBytes received(size);
    std::size_t sent = 0;
    std::size_t got = 0;
    while (sent < message.size() || got < received.size())
    {
      const SkdBytes out = RoundOf(message, sent);
      SkdBytes in = RoundOf(received, got);
      std::vector<diy::mpi::request> requests;
      if (!in.empty())
      {
        requests.push_back(this->Communicator.irecv(from, Tag, in));
      }
      if (!out.empty())
      {
        requests.push_back(this->Communicator.isend(to, Tag, out));
      }
      std::for_each(
        requests.begin(), requests.end(), [](diy::mpi::request& request) { request.wait(); });
      std::copy(in.begin(), in.end(), received.begin() + static_cast<std::ptrdiff_t>(got));
      sent += out.size();
      got += in.size();
    }
    return received;
  }

private:
  static constexpr int Tag = 27182; // VTK's own are small, or above 1'000'000
  static constexpr std::size_t RoundSize = std::size_t(1) << 26;

  static SkdBytes RoundOf(const SkdBytes& all, std::size_t done)
  {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(done);
    return SkdBytes(
      first, first + static_cast<std::ptrdiff_t>(std::min(RoundSize, all.size() - done)));
  }

  diy::mpi::communicator Communicator;
};
}

std::unique_ptr<SkdTransport> SkdMakeTransport(vtkMultiProcessController* controller)
{
  if (!controller || controller->GetNumberOfProcesses() < 2 || !controller->IsA("vtkMPIController"))
  {
    return nullptr;
  }
  vtkDIYUtilities::InitializeEnvironmentForDIY();
  return std::make_unique<DIYTransport>(vtkDIYUtilities::GetCommunicator(controller));
}
#else
std::unique_ptr<SkdTransport> SkdMakeTransport(vtkMultiProcessController*)
{
  return nullptr;
}
#endif
}
