"""Reading meshes that hair grows on."""

import unittest

import numpy as np

from lancret import InputError

from .support import HAS_USD, needs_usd

if HAS_USD:
    from pxr import Gf, Sdf, Usd, UsdGeom

    from lancret import usd


@needs_usd
class Meshes(unittest.TestCase):
    def square(self, orientation):
        stage = Usd.Stage.CreateInMemory()
        mesh = UsdGeom.Mesh.Define(stage, "/plane")
        mesh.CreatePointsAttr([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0)])
        mesh.CreateFaceVertexCountsAttr([4, 3])
        mesh.CreateFaceVertexIndicesAttr([0, 1, 2, 3, 1, 4, 2])
        mesh.CreateOrientationAttr(orientation)
        return stage, mesh

    def normals(self, mesh):
        a, b, c = (mesh.positions[mesh.corners[:, k]] for k in range(3))
        return np.cross(b - a, c - a)[:, 2]

    def test_faces_are_cut_into_triangles(self):
        read = usd.read_mesh(self.square("rightHanded")[0])
        self.assertEqual(read.corners.tolist(), [[0, 1, 2], [0, 2, 3], [1, 4, 2]])
        self.assertTrue((self.normals(read) > 0).all())

    def test_left_handed_meshes_and_mirrors_flip_faces(self):
        stage, mesh = self.square("leftHanded")
        self.assertTrue((self.normals(usd.read_mesh(stage)) < 0).all())
        mesh.AddScaleOp().Set(Gf.Vec3f(-1, 1, 1))
        read = usd.read_mesh(stage)  # the mirror keeps z, so the outside is the same
        np.testing.assert_allclose(read.positions[1], [-1, 0, 0])
        self.assertTrue((self.normals(read) < 0).all())

    def test_texture_coordinates_are_per_corner(self):
        stage, mesh = self.square("rightHanded")
        primvar = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(
            "UVMap", Sdf.ValueTypeNames.TexCoord2fArray, "faceVarying"
        )
        primvar.Set([(i, 0) for i in range(7)])
        uvs = usd.read_mesh(stage).uvs
        self.assertEqual(uvs[:, :, 0].tolist(), [[0, 1, 2], [0, 2, 3], [4, 5, 6]])
        primvar.Set([(0, 0)])
        self.assertIsNone(usd.read_mesh(stage).uvs)
        with self.assertRaisesRegex(InputError, "no primvar UVMap"):
            usd.read_mesh(stage, uv="UVMap")

    def test_holes_are_left_out(self):
        stage, mesh = self.square("rightHanded")
        mesh.CreateHoleIndicesAttr([0])
        self.assertEqual(usd.read_mesh(stage).corners.tolist(), [[1, 4, 2]])

    def test_invisible_meshes_do_not_count(self):
        stage, _ = self.square("rightHanded")
        other = UsdGeom.Mesh.Define(stage, "/cage")
        with self.assertRaisesRegex(InputError, "2 meshes"):
            usd.read_mesh(stage)
        other.CreatePurposeAttr("guide")
        self.assertEqual(len(usd.read_mesh(stage).corners), 3)

    def test_indices_beyond_the_points_are_refused(self):
        stage, mesh = self.square("rightHanded")
        mesh.CreateFaceVertexIndicesAttr([0, 1, 2, 3, 1, 5, 2])
        with self.assertRaisesRegex(InputError, "from 0 to 4"):
            usd.read_mesh(stage)
