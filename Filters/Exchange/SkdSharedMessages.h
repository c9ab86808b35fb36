// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSharedMessages.h
 * @brief Warnings and errors of a filter that several processes execute together, said once.
 */

#ifndef SkdSharedMessages_h
#define SkdSharedMessages_h

#include <cstddef>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkObject;

namespace skdtree
{
/// While it lives, what the filter itself warns of or reports as an error is kept back if several
/// processes each execute it for their own piece of these outputs. Observers of the filter get it
/// when it is said.
class SkdSharedMessages
{
public:
  SkdSharedMessages(vtkAlgorithm* filter, vtkInformationVector* outputs);

  /// What is still kept back is said, by each process for itself.
  ~SkdSharedMessages();

  SkdSharedMessages(const SkdSharedMessages&) = delete;
  SkdSharedMessages& operator=(const SkdSharedMessages&) = delete;

  /// What came of it on all processes.
  struct Outcome
  {
    bool IsErrorAnywhere = false;
    bool IsErrorHere = false;
    bool IsAbortedAnywhere = false;
  };

  /// All processes must call it together: each message is said by the first process that has it.
  /// Those that differ in numbers, and what follows these, are one, which says that other processes
  /// have the like.
  /// Where the Input is in pieces, warnings of what "Input has no ..." are said if all have them:
  /// the pieces of some may be empty.
  Outcome SayOnce(bool isInPieces);

private:
  struct Message
  {
    bool IsError = false;
    std::string File;
    int Line = 0;
    std::string Text;
  };
  using Messages = std::vector<Message>;
  struct Speaker
  {
    std::size_t Process;
    Message Said;
    std::vector<std::size_t> Others; // which have it with other numbers
    std::size_t Processes;           // which have it
  };

  bool Keep(vtkObject* filter, unsigned long event, void* text);
  void StopKeeping();
  std::vector<Messages> Gather() const;
  void Say(const Message& message) const;

  static std::vector<Speaker> FindSpeakers(const std::vector<Messages>& all);
  static std::string KeyOf(const Message& message);
  static std::string Pack(const Messages& messages);
  static Messages Unpack(const std::string& packed);

  vtkAlgorithm* Filter;
  vtkMultiProcessController* Controller;
  unsigned long Observers[2] = { 0, 0 };
  Messages Waiting;
};
}

#endif
