"""Names for the annotations of arrays: their numbers and shapes, in jaxtyping's notation, which the tests enforce.

``Float64[Array, "*batch 3"]`` is an array of doubles whose last axis has length 3, in NumPy, JAX, traced or not, or
another array-API library. A name for an axis means one length, and a starred name one run of axes, in all arguments and
the result of a call; ``*#batch`` marks arguments that broadcast to ``*batch``.

``Real[ArrayLike, "*#batch 3"]`` is what a user may give: an array, a number, or nested lists of numbers. The function
itself refuses wrong input with a message, so that the check lets it pass, and names the axes of the rest.

Annotations cost nothing outside the tests: jaxtyping is used only where it has been imported before.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import jax
    import numpy as np

    Array = np.ndarray[Any, Any] | jax.Array
    ArrayOrFloat = Any
    FloatOrArray = float | Array
    from typing import Self as Self

    from typing_extensions import TypeVar

    Answer = TypeVar("Answer", bound=FloatOrArray, default=FloatOrArray, covariant=True)
else:
    Self = Any  # which beartype takes on methods of classes alone that it decorates itself
    Array = Any
    """An array of any shape and type of number.

    For type checkers it is NumPy's or JAX's. Those of other array-API libraries go in as well, and what comes out of
    most functions is then one of these two. At run time it is ``Any``, as naming the types would import JAX.
    """
    ArrayOrFloat = Any | float
    """An array, or one float of Python's, as elementwise functions take it."""
    FloatOrArray = Any | float
    """The value of a motion's property: a float of one body, an array of a batch or of traced numbers."""
    from typing import TypeVar

    Answer = TypeVar("Answer", bound=FloatOrArray, covariant=True)
    """``FloatOrArray`` where a type checker can decide by the arguments: three plain numbers are of one body."""

ArrayLike = Any
"""Input that a function turns into an array: an array, a number, or nested lists or tuples of these."""

if TYPE_CHECKING:
    from typing import Annotated as Bool
    from typing import Annotated as Complex128
    from typing import Annotated as Double
    from typing import Annotated as Float64
    from typing import Annotated as Integer
    from typing import Annotated as Real
    from typing import Annotated as Shaped
elif "jaxtyping" in sys.modules:
    from typing import no_type_check

    import numpy as np
    from jaxtyping import AbstractDtype, Bool, Complex128, Float64, Integer, Shaped

    class Double(AbstractDtype):
        """float64 or complex128."""

        dtypes = ("float64", "complex128")

    class _NamesAxes(type):
        """The type of types that everything belongs to; belonging names the axes of a value of the expected shape."""

        @no_type_check  # the check of this call would keep the names for itself
        def __instancecheck__(cls, value):
            if value is not None:
                try:
                    shape = np.shape(value)
                except Exception:  # rows of different lengths, traced numbers in a list, an object that is not a number
                    return True
                isinstance(np.broadcast_to(0.0, shape), cls.expected)
            return True

    class Real:
        """Numbers that the function checks itself."""

        def __class_getitem__(cls, item):
            expected = Shaped[Any, item[1]]
            return _NamesAxes(f"Real[{item[1]}]", (), {"expected": expected})

else:

    class _Unchecked:
        """Stands for jaxtyping's types where nothing is checked."""

        def __class_getitem__(cls, item):
            return item[0]

    Bool = Complex128 = Double = Float64 = Integer = Real = Shaped = _Unchecked
