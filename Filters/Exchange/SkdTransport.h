// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdTransport.h
 * @brief Messages between the processes that have the pieces of a mesh, each to each.
 */

#ifndef SkdTransport_h
#define SkdTransport_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

class vtkMultiProcessController;

namespace skdtree
{
using SkdBytes = std::vector<char>;

/// What a process has sent to others.
struct SkdTraffic
{
  std::uint64_t Messages = 0; // that are not empty
  std::uint64_t Bytes = 0;

  void Add(const SkdTraffic& other)
  {
    this->Messages += other.Messages;
    this->Bytes += other.Bytes;
  }
};

/// All processes must call each of its functions together.
class SkdTransport
{
public:
  virtual ~SkdTransport() = default;

  virtual int GetRank() const = 0;
  virtual int GetNumber() const = 0;

  /// Sends make(to) to each process, also to this one, and calls take(from, message) for what comes
  /// from each, empty messages, too. Small messages are passed on by others, together, in
  /// ceil(log2(n)) messages; of the others each goes by itself, one after the other. Those that do
  /// not fit in 64 MB together are made again when they are sent: memory for two of them.
  void Exchange(const std::function<SkdBytes(int to)>& make,
    const std::function<void(int from, SkdBytes message)>& take);

  /// The messages of all processes, in their order. It takes each process ceil(log2(n)) messages,
  /// which pass on those of others.
  std::vector<SkdBytes> GatherAll(const SkdBytes& own);

  const SkdTraffic& GetTraffic() const { return this->Traffic; }

protected:
  /// Sends a message to one process, and returns the one of a size that another sends to this.
  /// Nothing is sent of an empty message, and nothing waited for where the size is 0.
  virtual SkdBytes Move(const SkdBytes& message, int to, int from, std::size_t size) = 0;

private:
  /// A message that others pass on; of one that is not small only its size.
  struct Packet
  {
    std::uint32_t From;
    std::uint32_t To;
    std::uint64_t Size;
    SkdBytes Message;
  };

  /// What is sent to each process: small messages and sizes, and by process the others.
  struct Outgoing
  {
    std::vector<Packet> Packets;
    std::vector<SkdBytes> Large;
    std::vector<bool> IsLarge;
  };

  static void Append(const Packet& packet, SkdBytes& joined);
  static void Unpack(const SkdBytes& joined, std::vector<Packet>& packets);
  Outgoing Prepare(const std::function<SkdBytes(int to)>& make) const;
  void Route(std::vector<Packet>& packets);
  SkdBytes Shift(const SkdBytes& message, int to, int from);
  void Count(const SkdBytes& message);

  SkdTraffic Traffic;
};

/// By DIY over the processes of a controller; nullptr if VTK was built without its module
/// ParallelDIY, or the controller is not one of MPI.
std::unique_ptr<SkdTransport> SkdMakeTransport(vtkMultiProcessController* controller);

//------------------------------------------------------------------------------
// Rows of plain values.

template <class Row>
SkdBytes SkdToBytes(const std::vector<Row>& rows)
{
  static_assert(std::is_trivially_copyable<Row>::value, "sent as it lies in memory");
  SkdBytes bytes(rows.size() * sizeof(Row));
  if (!rows.empty())
  {
    std::memcpy(bytes.data(), rows.data(), bytes.size());
  }
  return bytes;
}

template <class Row>
std::vector<Row> SkdFromBytes(const SkdBytes& bytes)
{
  std::vector<Row> rows(bytes.size() / sizeof(Row));
  if (!rows.empty())
  {
    std::memcpy(rows.data(), bytes.data(), rows.size() * sizeof(Row));
  }
  return rows;
}

/// By process.
template <class Row>
using SkdRowsByProcess = std::vector<std::vector<Row>>;

/// Sends rows to each process; returns those that came from each.
template <class Row>
SkdRowsByProcess<Row> SkdExchangeRows(SkdTransport& transport, const SkdRowsByProcess<Row>& rows)
{
  SkdRowsByProcess<Row> received(rows.size());
  transport.Exchange([&](int to) { return SkdToBytes(rows[static_cast<std::size_t>(to)]); },
    [&](int from, const SkdBytes& message)
    { received[static_cast<std::size_t>(from)] = SkdFromBytes<Row>(message); });
  return received;
}

/// The rows of all processes.
template <class Row>
SkdRowsByProcess<Row> SkdGatherRows(SkdTransport& transport, const std::vector<Row>& own)
{
  SkdRowsByProcess<Row> all;
  for (const SkdBytes& message : transport.GatherAll(SkdToBytes(own)))
  {
    all.push_back(SkdFromBytes<Row>(message));
  }
  return all;
}

/// Whether it is so on any process. All must call it together.
inline bool SkdIsAny(SkdTransport& transport, bool here)
{
  const auto all = SkdGatherRows(transport, std::vector<unsigned char>(1, here ? 1 : 0));
  return std::any_of(all.begin(), all.end(), [](const auto& one) { return one.front() != 0; });
}

/// Sends questions to each process, and returns the answers to them, in the order of the questions.
/// `answer` gets all that came, by process, and returns an answer to each.
template <class Answer, class Question, class Function>
SkdRowsByProcess<Answer> SkdAsk(
  SkdTransport& transport, const SkdRowsByProcess<Question>& questions, const Function& answer)
{
  const SkdRowsByProcess<Answer> answers = answer(SkdExchangeRows(transport, questions));
  return SkdExchangeRows(transport, answers);
}
}

#endif
