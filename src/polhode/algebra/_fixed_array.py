"""Arrays that stay plain numbers inside functions that JAX traces, such as the constants of an algebra."""

from __future__ import annotations

import numpy as np

from polhode.types import ArrayLike


class FixedArray:
    """An array that does not change, compared and hashed by its contents.

    As a static field of a module it stays numbers where JAX traces the module's other arrays, so that NumPy may be
    called on it, and code may decide by it.

    Args:
        values: of any shape and type; copied.

    >>> FixedArray([1.0, 2.0]) == FixedArray(np.array([1.0, 2.0])), FixedArray([1.0]) == FixedArray([2.0])
    (True, False)
    """

    def __init__(self, values: ArrayLike) -> None:
        self.values = np.array(values)
        self.values.flags.writeable = False
        self._key = (self.values.shape, self.values.dtype.str, self.values.tobytes())
        self._hash = hash(self._key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, FixedArray) and self._hash == other._hash and self._key == other._key

    def __hash__(self) -> int:
        return self._hash

    def __repr__(self) -> str:
        return f"FixedArray({' × '.join(map(str, self.values.shape))})"
