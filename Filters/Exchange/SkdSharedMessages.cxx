// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdSharedMessages.h"

#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdProcesses.h"
#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkCommunicator.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkOutputWindow.h"
#include "vtkType.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>

namespace skdtree
{
namespace
{
/// Before observers of others, who get a message when it is said.
constexpr float First = std::numeric_limits<float>::max();

/// How warnings begin that are of no interest if another process has what this one lacks.
constexpr const char* OfPieces = "Input has no ";

vtkMultiProcessController* ControllerOf(vtkInformationVector* outputs)
{
  vtkMultiProcessController* controller = nullptr;
  for (int port = 0; port < outputs->GetNumberOfInformationObjects() && !controller; ++port)
  {
    controller = SkdControllerOf(outputs->GetInformationObject(port));
  }
  return controller;
}

/// What comes before `end`, and leaves the rest in `text`; nothing if `end` is not there.
std::string TakeUntil(const char* end, std::string& text)
{
  const std::size_t at = text.find(end);
  if (at == std::string::npos)
  {
    return "";
  }
  std::string taken = text.substr(0, at);
  text.erase(0, at + std::strlen(end));
  return taken;
}

std::string ListOf(const std::vector<std::size_t>& processes)
{
  std::string list = processes.size() > 1 ? "processes " : "process ";
  for (std::size_t i = 0; i < processes.size(); ++i)
  {
    list += (i == 0 ? "" : i + 1 < processes.size() ? ", " : " and ");
    list += std::to_string(processes[i]);
  }
  return list + (processes.size() > 1 ? " have" : " has");
}
}

SkdSharedMessages::SkdSharedMessages(vtkAlgorithm* filter, vtkInformationVector* outputs)
  : Filter(filter)
  , Controller(ControllerOf(outputs))
{
  if (this->Controller)
  {
    this->Observers[0] =
      filter->AddObserver(vtkCommand::WarningEvent, this, &SkdSharedMessages::Keep, First);
    this->Observers[1] =
      filter->AddObserver(vtkCommand::ErrorEvent, this, &SkdSharedMessages::Keep, First);
  }
}

SkdSharedMessages::~SkdSharedMessages()
{
  this->StopKeeping();
  for (const Message& message : this->Waiting)
  {
    this->Say(message);
  }
}

void SkdSharedMessages::StopKeeping()
{
  for (unsigned long& observer : this->Observers)
  {
    if (observer != 0)
    {
      this->Filter->RemoveObserver(observer);
      observer = 0;
    }
  }
}

// VTK's macros make "Warning: In file, line 1\nclass (address): text\n\n". True: no other observer
// gets it.
bool SkdSharedMessages::Keep(vtkObject*, unsigned long event, void* given)
{
  Message message;
  message.IsError = event == vtkCommand::ErrorEvent;
  std::string text = given ? static_cast<const char*>(given) : "";
  TakeUntil(": In ", text);
  message.File = TakeUntil(", line ", text);
  message.Line = std::atoi(TakeUntil("\n", text).c_str());
  TakeUntil("): ", text);
  text.erase(text.find_last_not_of('\n') + 1);
  message.Text = text;
  this->Waiting.push_back(message);
  return true;
}

void SkdSharedMessages::Say(const Message& message) const
{
  std::ostringstream whole; // as VTK's macros put it
  whole << this->Filter->GetClassName() << " (" << this->Filter << "): " << message.Text;
  const std::string text = whole.str();
  if (message.IsError)
  {
    vtkOutputWindowDisplayErrorText(message.File.c_str(), message.Line, text.c_str(), this->Filter);
  }
  else
  {
    vtkOutputWindowDisplayWarningText(
      message.File.c_str(), message.Line, text.c_str(), this->Filter);
  }
}

// Where it is from, and its text up to a number: after that words depend on numbers, too.
std::string SkdSharedMessages::KeyOf(const Message& message)
{
  const auto isDigit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto first = std::find_if_not(message.Text.begin(), message.Text.end(), isDigit);
  const std::string words(first, std::find_if(first, message.Text.end(), isDigit));
  return message.File + ":" + std::to_string(message.Line) + ":" + words;
}

std::string SkdSharedMessages::Pack(const Messages& messages)
{
  std::string packed;
  for (const Message& message : messages)
  {
    packed += message.IsError ? 'E' : 'W';
    for (const std::string& part : { message.File, std::to_string(message.Line), message.Text })
    {
      packed += part;
      packed += '\0';
    }
  }
  return packed;
}

SkdSharedMessages::Messages SkdSharedMessages::Unpack(const std::string& packed)
{
  Messages messages;
  for (const char* at = packed.data(); at < packed.data() + packed.size();)
  {
    const auto next = [&at]()
    {
      std::string part = at;
      at += part.size() + 1;
      return part;
    };
    Message message;
    message.IsError = *at++ == 'E';
    message.File = next();
    message.Line = std::atoi(next().c_str());
    message.Text = next();
    messages.push_back(message);
  }
  return messages;
}

std::vector<SkdSharedMessages::Messages> SkdSharedMessages::Gather() const
{
  const auto count = static_cast<std::size_t>(this->Controller->GetNumberOfProcesses());
  const std::string own = Pack(this->Waiting);
  const auto length = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(count);
  this->Controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(count + 1, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    offsets[i + 1] = offsets[i] + lengths[i];
  }
  std::vector<Messages> all(count);
  if (offsets.back() > 0)
  {
    std::vector<char> packed(static_cast<std::size_t>(offsets.back()));
    this->Controller->AllGatherV(own.data(), packed.data(), length, lengths.data(), offsets.data());
    for (std::size_t i = 0; i < count; ++i)
    {
      all[i] = Unpack(std::string(packed.data() + offsets[i], packed.data() + offsets[i + 1]));
    }
  }
  return all;
}

std::vector<SkdSharedMessages::Speaker> SkdSharedMessages::FindSpeakers(
  const std::vector<Messages>& all)
{
  std::vector<Speaker> speakers;
  std::map<std::string, std::size_t> byKey;
  for (std::size_t process = 0; process < all.size(); ++process)
  {
    std::map<std::string, int> times; // a process has each, all of which are said
    for (const Message& message : all[process])
    {
      const std::string key = KeyOf(message);
      const std::string itsKey = key + std::to_string(times[key]++);
      const auto [at, isNew] = byKey.insert({ itsKey, speakers.size() });
      if (isNew)
      {
        speakers.push_back({ process, message, {}, 1 });
        continue;
      }
      Speaker& speaker = speakers[at->second];
      ++speaker.Processes;
      if (message.Text != speaker.Said.Text)
      {
        speaker.Others.push_back(process);
      }
    }
  }
  return speakers;
}

SkdSharedMessages::Outcome SkdSharedMessages::SayOnce(bool isInPieces)
{
  Outcome outcome;
  if (!this->Controller)
  {
    return outcome;
  }
  this->StopKeeping();
  outcome.IsErrorHere = std::any_of(this->Waiting.begin(), this->Waiting.end(),
    [](const Message& message) { return message.IsError; });
  const int isAborted = SkdIsAborted(this->Filter) ? 1 : 0;
  int isAnyAborted = 0;
  this->Controller->AllReduce(&isAborted, &isAnyAborted, 1, vtkCommunicator::MAX_OP);
  outcome.IsAbortedAnywhere = isAnyAborted != 0;
  const std::vector<Speaker> speakers = FindSpeakers(this->Gather());
  this->Waiting.clear();
  const auto own = static_cast<std::size_t>(this->Controller->GetLocalProcessId());
  const auto processes = static_cast<std::size_t>(this->Controller->GetNumberOfProcesses());
  for (const Speaker& speaker : speakers)
  {
    outcome.IsErrorAnywhere = outcome.IsErrorAnywhere || speaker.Said.IsError;
    const bool isOfPiece =
      isInPieces && !speaker.Said.IsError && speaker.Said.Text.rfind(OfPieces, 0) == 0;
    if (speaker.Process == own && (!isOfPiece || speaker.Processes == processes))
    {
      Message message = speaker.Said;
      if (!speaker.Others.empty())
      {
        message.Text += " (So it is on process " + std::to_string(own) + "; " +
          ListOf(speaker.Others) + " the like.)";
      }
      this->Say(message);
    }
  }
  return outcome;
}
}
