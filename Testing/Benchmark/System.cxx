// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "System.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"
#include "vtkVersion.h"

#include <algorithm>
#include <chrono>
#include <fstream>

namespace skdbench
{
namespace
{

constexpr int Size = 24;

/// A diagonally dominant matrix, by rows.
struct Matrix
{
  Matrix()
  {
    for (int i = 0; i < Size; ++i)
    {
      for (int j = 0; j < Size; ++j)
      {
        this->Values[i][j] = (i == j ? Size : 0) + 1.0 / (1 + i + j);
      }
      this->Rows[i] = this->Values[i];
    }
  }

  double Values[Size][Size];
  double* Rows[Size];
};

/// The loops of vtkMath::LUFactorLinearSystem, compiled as this program is.
void Factor(Matrix& matrix)
{
  double** a = matrix.Rows;
  for (int j = 0; j < Size; ++j)
  {
    for (int i = 0; i < Size; ++i)
    {
      double sum = a[i][j];
      for (int k = 0; k < std::min(i, j); ++k)
      {
        sum -= a[i][k] * a[k][j];
      }
      a[i][j] = sum;
    }
    for (int i = j + 1; i < Size; ++i)
    {
      a[i][j] /= a[j][j];
    }
  }
}

void FactorByVtk(Matrix& matrix)
{
  int pivots[Size];
  double scratch[Size];
  vtkMath::LUFactorLinearSystem(matrix.Rows, pivots, Size, scratch);
}

/// Nanoseconds, the least of a few tries. The pointer is volatile: no try is left out.
double TimeOf(void (*factor)(Matrix&))
{
  void (*volatile hidden)(Matrix&) = factor;
  double least = 1e9;
  for (int attempt = 0; attempt < 50; ++attempt)
  {
    Matrix matrix;
    const auto start = std::chrono::steady_clock::now();
    hidden(matrix);
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
    least = std::min(least, spent.count());
  }
  return least;
}

/// No VTK reports how it was compiled, so one of its loops is raced: 1.3 times ours where it is
/// optimised, 7 times where it is not.
bool IsVtkOptimised()
{
  return TimeOf(FactorByVtk) < 3.0 * TimeOf(Factor);
}

}

std::string DescribeVtk()
{
  return std::string("VTK ") + vtkVersion::GetVTKVersion() +
    (IsVtkOptimised() ? ", built with optimisation"
                      : ", built WITHOUT optimisation (its locators pay two to four times)") +
    "; vtkSMPTools: " + vtkSMPTools::GetBackend();
}

std::string DescribeBuild()
{
  std::string text = "this program: ";
#ifdef __VERSION__
  text += std::string("compiler ") + __VERSION__;
#else
  text += "another compiler";
#endif
#ifdef __OPTIMIZE__
  return text + ", optimised";
#else
  return text + ", NOT optimised: these numbers mean nothing";
#endif
}

std::string DescribeMachine()
{
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  while (std::getline(info, line))
  {
    if (line.rfind("model name", 0) == 0)
    {
      return line.substr(line.find(':') + 2);
    }
  }
  return "processor unknown";
}

}
