# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plugin/inline_xml.py: files with appended arrays, of every encoding, hold the same inline."""

import glob
import os
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import (vtkXMLImageDataReader, vtkXMLImageDataWriter,
    vtkXMLPolyDataReader, vtkXMLPolyDataWriter)

import skdtesting

sys.path.append(os.path.join(skdtesting.SOURCE_DIR, "Plugin"))
import inline_xml


def sphere():
    """With a long array, one of no tuple, and one whose element has elements of its own."""
    mesh = skdtesting.sphere_mesh(100)
    random = numpy.random.default_rng(5)
    for name, values in (("Noise", random.random(mesh.GetNumberOfPoints())), ("None", [])):
        array = numpy_to_vtk(numpy.asarray(values, dtype=float), deep=True)
        array.SetName(name)
        (mesh.GetPointData() if len(values) else mesh.GetFieldData()).AddArray(array)
    mesh.GetPoints().GetData().GetRange(-1)
    return mesh


def written(writer, data, name):
    path = skdtesting.temporary(name)
    writer.SetInputData(data)
    writer.SetFileName(path)
    assert writer.Write()
    with open(path, "rb") as file:
        assert b"<AppendedData" in file.read()
    return path


def read(reader, path):
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def inlined(path):
    result = path + ".inline"
    inline_xml.main(path, result)
    with open(result, "rb") as file:
        text = file.read()
    assert b"appended" not in text and b"AppendedData" not in text
    return result


def test_every_encoding_is_read_back():
    mesh = sphere()
    for is_encoded in (False, True):
        for compress in ("SetCompressorTypeToNone", "SetCompressorTypeToZLib"):
            for header in ("SetHeaderTypeToUInt32", "SetHeaderTypeToUInt64"):
                for order in ("SetByteOrderToLittleEndian", "SetByteOrderToBigEndian"):
                    writer = vtkXMLPolyDataWriter()
                    writer.SetDataModeToAppended()
                    writer.SetEncodeAppendedData(is_encoded)
                    writer.SetBlockSize(8192)
                    for choice in (compress, header, order):
                        getattr(writer, choice)()
                    path = written(writer, mesh, "inline.vtp")
                    with open(path, "rb") as file:
                        assert b"<InformationKey" in file.read()
                    path = inlined(path)
                    back = read(vtkXMLPolyDataReader(), path)
                    for of in (lambda m: m.GetPoints().GetData(),
                            lambda m: m.GetPolys().GetConnectivityArray(),
                            lambda m: m.GetPolys().GetOffsetsArray(),
                            lambda m: m.GetPointData().GetArray("Noise")):
                        skdtesting.assert_same(vtk_to_numpy(of(back)), vtk_to_numpy(of(mesh)))
                    assert back.GetFieldData().GetArray("None").GetNumberOfTuples() == 0


def test_without_a_second_name_the_file_is_replaced():
    image = vtkImageData()
    image.SetDimensions(20, 30, 40)
    image.AllocateScalars(5, 1) # VTK_UNSIGNED_SHORT
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    values[:] = numpy.arange(len(values))
    writer = vtkXMLImageDataWriter()
    writer.SetDataModeToAppended()
    path = written(writer, image, "inline.vti")
    inline_xml.main(path)
    once = open(path, "rb").read()
    inline_xml.main(path)
    assert open(path, "rb").read() == once, "what is inline stays as it is"
    back = read(vtkXMLImageDataReader(), path)
    skdtesting.assert_same(vtk_to_numpy(back.GetPointData().GetScalars()), values)
    assert glob.glob(path + ".*") == []


def test_no_file_of_ours_has_appended_arrays():
    for path in glob.glob(os.path.join(skdtesting.DATA_DIR, "*.vt?")):
        with open(path, "rb") as file:
            assert b"<AppendedData" not in file.read(), path


skdtesting.run_tests(globals())
