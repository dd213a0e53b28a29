"""From a function of Numba's to an image: its object code, with a way in that needs neither Numba nor Python."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count
from typing import Any

from llvmlite import binding, ir
from numba import typeof
from numba.core import cgutils, types
from numba.np.arrayobj import make_array, populate_array

from polhode._base.compiled.compiling import compile_part
from polhode._base.compiled.images import Image
from polhode._base.compiled.linking import link

ENTRY = "polhode_entry"
WORD, BYTE = ir.IntType(64), ir.IntType(8)
ADDRESS = BYTE.as_pointer()
DATA, SHAPE, STRIDES = 16, 32, 40  # bytes into an array of NumPy, behind the head of every object of Python
RECORD = ir.LiteralStructType([WORD, ADDRESS, ADDRESS, ADDRESS, WORD, ADDRESS])  # of memory that Numba counts
ALIGNMENT = 64  # bytes to a multiple of which its numbers begin


def build_image(function: Any, arguments: tuple[Any, ...]) -> Image:
    """Return the image of a function for arguments of these types.

    Raises:
        CannotLink: of what cannot be in one.
    """
    part = compile_part(function, inlined=False)
    part.compile(tuple(map(typeof, arguments)))
    (compiled,) = part.overloads.values()
    library, target = compiled.library, compiled.target_context
    module = library._final_module.clone()
    module.link_in(_parse(_write_entry(target, compiled.fndesc, library.name)))
    return link(target.codegen()._tm.emit_object(module), ENTRY)


def _parse(module: Any) -> Any:
    parsed = binding.parse_assembly(cgutils.normalize_ir_text(str(module)))
    parsed.verify()
    return parsed


def _write_entry(target: Any, named: Any, name: str) -> Any:
    """Return a module with a function that is given a row of words: see ``entries``."""
    module = ir.Module(f"{name}.entry")
    module.triple, module.data_layout = target.codegen()._llvm_module.triple, target.codegen()._data_layout
    function = ir.Function(module, ir.FunctionType(ir.IntType(32), [WORD.as_pointer()]), ENTRY)
    builder = ir.IRBuilder(function.append_basic_block())
    words = (builder.load(builder.gep(function.args[0], [WORD(k)])) for k in count())
    values = [_read(target, builder, kind, words) for kind in named.argtypes]
    callee = target.declare_function(module, named)
    status, _ = target.call_conv.call_function(builder, callee, named.restype, named.argtypes, values)
    builder.ret(builder.zext(status.is_error, ir.IntType(32)))
    _write_memory(module)
    return module


def _read(target: Any, builder: Any, kind: Any, words: Iterator[Any]) -> Any:
    """Return an argument of a function, from the next words."""
    if isinstance(kind, types.BaseTuple):
        of: Any = kind  # whose types do not know that it has parts
        return target.make_tuple(builder, kind, [_read(target, builder, part, words) for part in of])
    word = next(words)
    if isinstance(kind, types.Array):
        return _read_array(target, builder, kind, builder.inttoptr(word, ADDRESS))
    return builder.bitcast(word, ir.DoubleType()) if kind == types.float64 else word


def _read_array(target: Any, builder: Any, kind: Any, whole: Any) -> Any:
    def at(place: int, of: Any) -> Any:
        return builder.load(builder.bitcast(builder.gep(whole, [WORD(place)]), of.as_pointer()))

    def row(place: int) -> list[Any]:
        first = at(place, WORD.as_pointer())
        return [builder.load(builder.gep(first, [WORD(k)])) for k in range(kind.ndim)]

    array = make_array(kind)(target, builder)
    data = at(DATA, target.get_data_type(kind.dtype).as_pointer())
    size = target.get_constant(types.intp, target.get_abi_sizeof(target.get_data_type(kind.dtype)))
    populate_array(array, data, row(SHAPE), row(STRIDES), size, None)
    return array._getvalue()


def _write_memory(module: Any) -> None:
    """Write the two functions by which Numba takes memory and gives it back, which count nothing."""
    whole, none = ir.IntType(32), ADDRESS(None)
    malloc = ir.Function(module, ir.FunctionType(ADDRESS, [WORD]), "malloc")
    free = ir.Function(module, ir.FunctionType(ir.VoidType(), [ADDRESS]), "free")
    take = ir.Function(module, ir.FunctionType(ADDRESS, [WORD, whole]), "NRT_MemInfo_alloc_aligned")
    builder = ir.IRBuilder(take.append_basic_block())
    size = builder.add(take.args[0], WORD(2 * ALIGNMENT))
    record = builder.call(malloc, [size])
    with builder.if_then(builder.icmp_unsigned("==", record, none)):
        builder.ret(none)
    begin = builder.and_(builder.add(builder.ptrtoint(record, WORD), WORD(2 * ALIGNMENT - 1)), WORD(-ALIGNMENT))
    values = WORD(1), none, none, builder.inttoptr(begin, ADDRESS), take.args[0], none
    row = builder.bitcast(record, RECORD.as_pointer())
    for k, value in enumerate(values):
        builder.store(value, builder.gep(row, [whole(0), whole(k)]))
    builder.ret(record)
    give = ir.Function(module, ir.FunctionType(ir.VoidType(), [ADDRESS]), "NRT_MemInfo_call_dtor")
    builder = ir.IRBuilder(give.append_basic_block())
    builder.call(free, [give.args[0]])
    builder.ret_void()
