// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EventCounter.h
 * @brief counts the errors and warnings of an object, and keeps the last text of each
 */
#ifndef skdtest_EventCounter_h
#define skdtest_EventCounter_h

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <string>

namespace skdtest
{

class EventCounter
{
public:
  explicit EventCounter(vtkObject* watched)
    : Watched(watched)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(&EventCounter::Count);
    watched->AddObserver(vtkCommand::ErrorEvent, this->Command);
    watched->AddObserver(vtkCommand::WarningEvent, this->Command);
  }

  ~EventCounter() { this->Watched->RemoveObserver(this->Command); }

  EventCounter(const EventCounter&) = delete;
  EventCounter& operator=(const EventCounter&) = delete;

  int Errors = 0;
  int Warnings = 0;
  std::string Error;
  std::string Warning;

private:
  static void Count(vtkObject*, unsigned long event, void* self, void* text)
  {
    auto* counter = static_cast<EventCounter*>(self);
    const bool isError = event == vtkCommand::ErrorEvent;
    ++(isError ? counter->Errors : counter->Warnings);
    (isError ? counter->Error : counter->Warning) = text ? static_cast<const char*>(text) : "";
  }

  vtkObject* Watched;
  vtkNew<vtkCallbackCommand> Command;
};

}

#endif
