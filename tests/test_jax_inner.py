"""What JAX does not promise to keep is imported in one file, and is there in the JAX that is installed."""

import re
from pathlib import Path

import pytest

import polhode
from polhode._base import jax_inner

SOURCES = Path(polhode.__file__).parent
INNER = re.compile(r"\bjax\.(core|extend|interpreters|_src)\b")


def outside(texts):
    """Return the files that name what JAX keeps to itself."""
    return [name for name, text in texts.items() if INNER.search(text)]


def test_one_file_alone_names_what_is_inside():
    texts = {path.relative_to(SOURCES).as_posix(): path.read_text("utf-8") for path in SOURCES.rglob("*.py")}
    assert outside(texts) == ["_base/jax_inner.py"]
    assert outside({"a.py": "from jax.extend.core import Literal", "b.py": "import jax.numpy"}) == ["a.py"]


@pytest.mark.parametrize(("module", "names"), [
    ("ad", ["Zero", "primitive_jvps", "primitive_transposes", "instantiate_zeros", "is_undefined_primal"]),
    ("batching", ["primitive_batchers"]), ("mlir", ["register_lowering", "lower_fun", "emit_python_callback"]),
    ("compilation_cache", ["get_file_cache"]),
])  # fmt: skip
def test_what_is_used_is_there(module, names):
    """A name that a new JAX has not would be a traceback in the middle of a derivative."""
    assert [name for name in names if not hasattr(getattr(jax_inner, module), name)] == []
