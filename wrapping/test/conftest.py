import os
import pathlib

import itk
import numpy as np
import pytest

BRAIN = pathlib.Path("/usr/share/mricron/templates/ch2bet.nii.gz")


def make_image(values, spacing=(1.0, 1.0, 1.0), origin=(0.0, 0.0, 0.0), direction=None):
    """An image of the values [z, y, x]; spacing and origin in the order x, y, z."""
    image = itk.image_from_array(np.ascontiguousarray(values))
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    if direction is not None:
        image.SetDirection(np.asarray(direction, dtype=float))
    return image


def ball_values(size=24, radius=8.0, value=1, dtype=np.uint8):
    grid = np.indices((size, size, size)) - (size - 1) / 2.0
    return (np.sqrt((grid**2).sum(axis=0)) <= radius).astype(dtype) * np.array(value, dtype)


def ball(size=24, radius=8.0, value=1, dtype=np.uint8, **geometry):
    return make_image(ball_values(size, radius, value, dtype), **geometry)


@pytest.fixture(scope="session")
def brain():
    assert BRAIN.exists(), "Debian's package mricron-data is missing"
    return itk.imread(str(BRAIN))


def needed(variable):
    """A path that CI passes by an environment variable; without it a test is skipped, in CI it fails."""
    path = os.environ.get(variable)
    if path is None:
        if os.environ.get("CI"):
            pytest.fail(f"{variable} is not set")
        pytest.skip(f"{variable} is not set")
    return path
