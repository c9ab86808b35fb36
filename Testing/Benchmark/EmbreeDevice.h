// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skdbench_EmbreeDevice_h
#define skdbench_EmbreeDevice_h

#include <embree3/rtcore.h>

namespace skdbench
{

/// One device for all, of one thread.
inline RTCDevice EmbreeDevice()
{
  static const RTCDevice device = rtcNewDevice("threads=1");
  return device;
}

}

#endif
