// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MessageCounter.h
 * @brief counts the errors and warnings of an object that have a text, and keeps the last of them
 */
#ifndef skdtest_MessageCounter_h
#define skdtest_MessageCounter_h

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <string>

namespace skdtest
{

class MessageCounter
{
public:
  MessageCounter(vtkObject* watched, const std::string& text)
    : Text(text)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(&MessageCounter::Count);
    watched->AddObserver(vtkCommand::WarningEvent, this->Command);
    watched->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }

  int Messages = 0;
  std::string Last;

private:
  static void Count(vtkObject*, unsigned long, void* self, void* text)
  {
    auto* counter = static_cast<MessageCounter*>(self);
    const std::string message = static_cast<const char*>(text);
    if (message.find(counter->Text) != std::string::npos)
    {
      ++counter->Messages;
      counter->Last = message;
    }
  }

  std::string Text;
  vtkNew<vtkCallbackCommand> Command;
};

}

#endif
