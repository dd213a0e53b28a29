"""Boxes, and meshes put together, and turned inside out."""

import numpy as np
import trimesh


def box(at=(0.0, 0.0, 0.0), size=(1.0, 2.0, 3.0)):
    mesh = trimesh.creation.box(size)
    return np.array(mesh.vertices) + np.asarray(at), np.array(mesh.faces)


def joined(*meshes):
    offsets = np.cumsum([0] + [len(v) for v, _ in meshes[:-1]])
    return np.vstack([v for v, _ in meshes]), np.vstack([f + o for (_, f), o in zip(meshes, offsets, strict=True)])


def inside_out(mesh):
    return mesh[0], mesh[1][:, ::-1]
