// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkSkdTreeSetWithin.h
 * @brief Setters that reject numbers out of a property's range.
 *
 * NaN, infinities and values out of the property's range are rejected with an error that names the
 * property, the value and the range, and the previous value is kept. Filters therefore need not
 * check their own properties. (VTK's own macros clamp values silently and accept NaN.)
 */

#ifndef vtkSkdTreeSetWithin_h
#define vtkSkdTreeSetWithin_h

#include "vtkObject.h"         // For vtkErrorWithObjectMacro
#include "vtkSkdTreeVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <algorithm> // For std::copy
#include <limits>    // For std::numeric_limits

VTK_ABI_NAMESPACE_BEGIN

/// Whether all values are in [least, most], which is false for NaN; if not, reports an error of
/// `self`.
template <class T>
bool vtkSkdTreeIsWithin(
  vtkObject* self, const char* name, const T* wanted, int size, T least, T most)
{
  for (int i = 0; i < size; ++i)
  {
    if (!(wanted[i] >= least && wanted[i] <= most))
    {
      vtkErrorWithObjectMacro(self, << name << " cannot be " << wanted[i]
                                    << ": it must be a number from " << least << " to " << most
                                    << ". The previous value is kept.");
      return false;
    }
  }
  return true;
}

/// Sets values if all are within the range.
template <class T>
void vtkSkdTreeSetWithin(
  vtkObject* self, const char* name, const T* wanted, int size, T least, T most, T* member)
{
  if (vtkSkdTreeIsWithin(self, name, wanted, size, least, most) &&
    !std::equal(wanted, wanted + size, member))
  {
    std::copy(wanted, wanted + size, member);
    self->Modified();
  }
}

/// Sets values if all are finite.
inline void vtkSkdTreeSetFinite(
  vtkObject* self, const char* name, const double* wanted, int size, double* member)
{
  vtkSkdTreeSetWithin(self, name, wanted, size, std::numeric_limits<double>::lowest(),
    std::numeric_limits<double>::max(), member);
}

/// In place of vtkSetClampMacro.
#define vtkSkdTreeSetWithinMacro(name, type, least, most)                                          \
  virtual void Set##name(type wanted)                                                              \
  {                                                                                                \
    vtkSkdTreeSetWithin<type>(this, #name, &wanted, 1, least, most, &this->name);                  \
  }                                                                                                \
  virtual type Get##name##MinValue() const                                                         \
  {                                                                                                \
    return least;                                                                                  \
  }                                                                                                \
  virtual type Get##name##MaxValue() const                                                         \
  {                                                                                                \
    return most;                                                                                   \
  }

//@{
/// In place of vtkSetVector2Macro and so on: all finite.
#define vtkSkdTreeSetFinite2Macro(name)                                                            \
  virtual void Set##name(double a, double b)                                                       \
  {                                                                                                \
    const double wanted[2] = { a, b };                                                             \
    vtkSkdTreeSetFinite(this, #name, wanted, 2, this->name);                                       \
  }                                                                                                \
  void Set##name(const double wanted[2])                                                           \
  {                                                                                                \
    this->Set##name(wanted[0], wanted[1]);                                                         \
  }

#define vtkSkdTreeSetFinite3Macro(name)                                                            \
  virtual void Set##name(double a, double b, double c)                                             \
  {                                                                                                \
    const double wanted[3] = { a, b, c };                                                          \
    vtkSkdTreeSetFinite(this, #name, wanted, 3, this->name);                                       \
  }                                                                                                \
  void Set##name(const double wanted[3])                                                           \
  {                                                                                                \
    this->Set##name(wanted[0], wanted[1], wanted[2]);                                              \
  }

#define vtkSkdTreeSetFinite6Macro(name)                                                            \
  virtual void Set##name(double a, double b, double c, double d, double e, double f)               \
  {                                                                                                \
    const double wanted[6] = { a, b, c, d, e, f };                                                 \
    vtkSkdTreeSetFinite(this, #name, wanted, 6, this->name);                                       \
  }                                                                                                \
  void Set##name(const double wanted[6])                                                           \
  {                                                                                                \
    this->Set##name(wanted[0], wanted[1], wanted[2], wanted[3], wanted[4], wanted[5]);             \
  }
//@}

//@{
/// A whole property each, its Set and its Get: a number within a range, numbers that are finite, a
/// switch (with On and Off), and one of a few whole numbers, the nearest of which is taken.
#define vtkSkdTreeWithinMacro(name, type, least, most)                                             \
  vtkSkdTreeSetWithinMacro(name, type, least, most);                                               \
  vtkGetMacro(name, type)

#define vtkSkdTreeFinite2Macro(name)                                                               \
  vtkSkdTreeSetFinite2Macro(name);                                                                 \
  vtkGetVector2Macro(name, double)

#define vtkSkdTreeFinite3Macro(name)                                                               \
  vtkSkdTreeSetFinite3Macro(name);                                                                 \
  vtkGetVector3Macro(name, double)

#define vtkSkdTreeFinite6Macro(name)                                                               \
  vtkSkdTreeSetFinite6Macro(name);                                                                 \
  vtkGetVector6Macro(name, double)

#define vtkSkdTreeSwitchMacro(name)                                                                \
  vtkSetMacro(name, bool);                                                                         \
  vtkGetMacro(name, bool);                                                                         \
  vtkBooleanMacro(name, bool)

#define vtkSkdTreeChoiceMacro(name, least, most)                                                   \
  vtkSetClampMacro(name, int, least, most);                                                        \
  vtkGetMacro(name, int)
//@}

VTK_ABI_NAMESPACE_END
#endif
