// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdTransport.h"

#include "vtkMultiProcessController.h"

#include <algorithm>

#if VTK_MODULE_ENABLE_VTK_ParallelDIY
#include "vtkDIYUtilities.h"
#endif

namespace skdtree
{
namespace
{
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

// In step s to the process s after this one, from the one s before: no process gets from two at a
// time.
void SkdTransport::Exchange(const std::function<SkdBytes(int to)>& make,
  const std::function<void(int from, SkdBytes message)>& take)
{
  const int number = this->GetNumber();
  const int rank = this->GetRank();
  take(rank, make(rank));
  for (int step = 1; step < number; ++step)
  {
    const int to = (rank + step) % number;
    const int from = (rank + number - step) % number;
    const SkdBytes message = make(to);
    this->Traffic.Messages += message.empty() ? 0 : 1;
    this->Traffic.Bytes += message.size();
    take(from, this->Shift(message, to, from));
  }
}

// By Bruck's algorithm (IEEE Trans. Parallel Distrib. Syst. 8 (1997) 1143): in each step a process
// hands all that it has to the one as many places further on, so what each has doubles.
std::vector<SkdBytes> SkdTransport::GatherAll(const SkdBytes& own)
{
  const int number = this->GetNumber();
  const int rank = this->GetRank();
  std::vector<SkdBytes> backwards{ own }; // of this process, the one before, ...
  while (static_cast<int>(backwards.size()) < number)
  {
    const int have = static_cast<int>(backwards.size());
    const SkdBytes joined = Join(backwards, std::min(have, number - have));
    ++this->Traffic.Messages;
    this->Traffic.Bytes += joined.size();
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
  SkdBytes Shift(const SkdBytes& message, int to, int from) override
  {
    SkdBytes received(this->ShiftSize(message.size(), to, from));
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

  std::size_t ShiftSize(std::size_t own, int to, int from)
  {
    unsigned long long size = own;
    unsigned long long others = 0;
    diy::mpi::request get = this->Communicator.irecv(from, Tag, others);
    diy::mpi::request put = this->Communicator.isend(to, Tag, size);
    put.wait();
    get.wait();
    return static_cast<std::size_t>(others);
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
