// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file QuietWindow.h
 * @brief no messages in tests that provoke thousands
 */
#ifndef skdtest_QuietWindow_h
#define skdtest_QuietWindow_h

#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"

namespace skdtest
{

/// As long as it lives nothing is written that nobody observes.
class QuietWindow
{
public:
  QuietWindow() { vtkOutputWindow::SetInstance(this->Quiet); }
  ~QuietWindow() { vtkOutputWindow::SetInstance(this->Usual); }

  QuietWindow(const QuietWindow&) = delete;
  QuietWindow& operator=(const QuietWindow&) = delete;

private:
  vtkSmartPointer<vtkOutputWindow> Usual = vtkOutputWindow::GetInstance();
  vtkNew<vtkStringOutputWindow> Quiet;
};

}

#endif
