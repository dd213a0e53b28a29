"""Compiled functions on the disk: what is loaded, and what is compiled again; tests/exact and tests/taylor run them."""

import ctypes
import math
import os
import subprocess
import sys

import numpy as np
import pytest
from llvmlite import binding, ir

from polhode._base.compiled import entries, images, linking, objects
from polhode._base.compiled.compiling import CompiledFunction
from polhode._base.compiled.entries import ENDING, Entry
from polhode._base.compiled.kernel_modules import can_compile
from polhode._base.seals import read_sealed, write_sealed

pytestmark = pytest.mark.skipif(not images.has_images(), reason="images are for Linux on x86-64")


def add_up(pair, scale, places, out):
    """Use what kernels use: tuples, numbers of both kinds, arrays of two axes, memory, and libm."""
    room = np.zeros(out.shape[1])
    for i in range(out.shape[0]):
        for j in range(out.shape[1]):
            room[j] += scale * pair[0][i, j]
            out[i, j] = room[j] + math.exp(pair[1]) + places[i]


def add_in_python(pair, scale, places, out):
    room = np.zeros(out.shape[1])
    for i in range(out.shape[0]):
        room += scale * pair[0][i]
        out[i] = room + math.exp(pair[1]) + places[i]


@pytest.fixture
def given():
    return (np.arange(6.0).reshape(2, 3), 0.3), 2, np.array([5, 7])


@pytest.fixture
def compiled(monkeypatch):
    """Return the list of what is compiled from now on."""
    names, own = [], objects.build_image
    monkeypatch.setattr(objects, "build_image", lambda *x: names.append(x[0].__name__) or own(*x))
    return names


def entry(folder, monkeypatch, name="add_up_1234"):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(folder))
    return Entry(name, "sums", folder / "module.py", lambda: CompiledFunction("sums", add_up))


def check(function, given):
    found, wanted = np.zeros((2, 3)), np.zeros((2, 3))
    function(*given, found)
    add_in_python(*given, wanted)
    assert (found == wanted).all()


def files(folder):
    return sorted(folder.rglob(f"*{ENDING}"))


def test_it_is_compiled_once_and_loaded_then(given, compiled, monkeypatch, tmp_path):
    first = entry(tmp_path, monkeypatch)
    assert not first.is_on_disk()
    check(first, given)
    check(first, given)
    again = entry(tmp_path, monkeypatch)
    assert again.is_on_disk()
    check(again, given)
    assert compiled == ["add_up"] and len(files(tmp_path)) == 1


def damage(path, monkeypatch):
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 1
    path.write_bytes(content)


def rename(path, monkeypatch):
    path.rename(path.with_name(path.name.replace("1234", "9999")))


def let_others_write(path, monkeypatch):
    path.chmod(0o666)


def change_processor(path, monkeypatch):
    monkeypatch.setattr(entries, "processors", lambda: ("another",))


def change_nothing(path, monkeypatch):
    pass


def ship(path, monkeypatch, level):
    """Have an image lie where a release has them, in the name of a class, in an environment of somebody else's."""
    shipped = path.parent / "shipped"
    monkeypatch.setattr(entries, "SHIPPED", shipped)
    place = shipped / f"{path.stem.rpartition('_')[0]}_{level}{ENDING}"
    write_sealed(place, read_sealed(path, 10**6))
    place.chmod(0o664)
    path.unlink()
    return place


@pytest.mark.parametrize(("classes", "count"), [(["x86-64-v3"], 1), (["x86-64-v4", "x86-64-v3"], 1), ([], 2)])
def test_what_came_with_a_release_is_loaded_on_its_class_of_processors(
    classes, count, given, compiled, monkeypatch, tmp_path
):
    check(entry(tmp_path, monkeypatch), given)
    place = ship(*files(tmp_path), monkeypatch, "x86-64-v3")
    monkeypatch.setattr(entries, "processors", lambda: ("another", *classes))
    function = entry(tmp_path, monkeypatch)
    assert function.is_on_disk() is (count == 1)
    check(function, given)
    assert len(compiled) == count
    if count == 1:
        damage(place, monkeypatch)
        check(entry(tmp_path, monkeypatch), given)
        assert len(compiled) == 2


@pytest.mark.parametrize(("change", "count"), [
    (damage, 2), (rename, 2), (let_others_write, 2), (change_processor, 2), (change_nothing, 1),
])  # fmt: skip
def test_what_is_not_what_was_written_is_compiled_again(change, count, given, compiled, monkeypatch, tmp_path):
    check(entry(tmp_path, monkeypatch), given)
    (path,) = files(tmp_path)
    change(path, monkeypatch)
    check(entry(tmp_path, monkeypatch), given)
    assert len(compiled) == count
    check(entry(tmp_path, monkeypatch), given)
    assert len(compiled) == count


def test_a_folder_that_cannot_be_written_changes_nothing(given, compiled, monkeypatch, tmp_path):
    (tmp_path / "polhode").write_text("")
    check(entry(tmp_path, monkeypatch), given)
    assert compiled == ["add_up"] and not files(tmp_path)


def test_without_a_home_nothing_is_kept(given, compiled, monkeypatch, tmp_path, without_home):
    """Where the package's own folder cannot be written either."""
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.chdir(tmp_path)
    with monkeypatch.context() as patch:
        patch.setattr(os, "access", lambda *given: False)
        function = Entry("add_up_1234", "sums", tmp_path / "module.py", lambda: CompiledFunction("sums", add_up))
    assert not function.is_on_disk()
    check(function, given)
    assert compiled == ["add_up"] and not list(tmp_path.iterdir())


def test_where_no_image_can_be_made_or_run_numba_does_it(given, monkeypatch, tmp_path):
    def refuse(*given):
        raise images.CannotLink

    def forbid(image):
        raise OSError

    for module, name, wrong in ((objects, "link", refuse), (entries, "load", forbid)):
        with monkeypatch.context() as patch:
            patch.setattr(module, name, wrong)
            function = entry(tmp_path / name, patch)
            check(function, given)
            assert function._without is not None and not function._runs


def test_each_form_of_arguments_has_an_image_of_its_own(given, compiled, monkeypatch, tmp_path):
    (values, x), _, places = given
    function = entry(tmp_path, monkeypatch)
    others = ((values, x), 2.0, places), ((values, x), 2, places.astype(float)), ((values[:1], x), 3, places)
    for form in (given, *others):
        check_rows = np.zeros((1, 3)), np.zeros((1, 3))
        function(*form, check_rows[0])
        add_in_python(*form, check_rows[1])
        assert (check_rows[0] == check_rows[1]).all()
    values.flags.writeable = False
    check(function, given)
    assert len(compiled) == len(files(tmp_path)) == 4


@pytest.mark.parametrize("strided", [
    np.zeros((3, 2)).T, np.zeros((2, 6))[:, ::2], np.zeros(49, np.int8)[1:].view(float),
])  # fmt: skip
def test_arrays_that_compiled_code_would_misread_are_refused(strided, given, monkeypatch, tmp_path):
    with pytest.raises(TypeError, match="order of C"):
        entry(tmp_path, monkeypatch)(*given, strided)


# ---------------------------------------------------------------------- objects of which no image can be made


def build(write):
    """Return the object code of a module with one function, as Numba has it written."""
    binding.initialize_native_target()
    binding.initialize_native_asmprinter()
    module = ir.Module()
    function = ir.Function(module, ir.FunctionType(ir.IntType(32), [ir.DoubleType().as_pointer()]), "run")
    builder = ir.IRBuilder(function.append_basic_block())
    write(module, builder, function.args[0])
    builder.ret(ir.IntType(32)(0))
    target = binding.Target.from_triple(binding.get_process_triple())
    machine = target.create_target_machine(opt=2, reloc="static", codemodel="large")
    return machine.emit_object(binding.parse_assembly(str(module)))


def call(name):
    def write(module, builder, place):
        kind = ir.FunctionType(ir.DoubleType(), [ir.DoubleType()])
        builder.store(builder.call(ir.Function(module, kind, name), [builder.load(place)]), place)

    return write


def keep(module, builder, place):
    kept = ir.GlobalVariable(module, ir.DoubleType(), "kept")
    kept.initializer = ir.DoubleType()(1.0)
    builder.store(builder.fadd(builder.load(kept), builder.load(place)), kept)


def test_a_function_of_libm_is_called():
    image, number = linking.link(build(call("sinh")), "run"), np.array([0.7])
    with_address = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)
    function = images.load(image)
    assert ctypes.cast(function, with_address)(number.ctypes.data) == 0
    assert image.outside.keys() == {"sinh"} and number[0] == math.sinh(0.7)


@pytest.mark.parametrize(("built", "why"), [
    (build(call("PyErr_Clear")), "PyErr_Clear"), (build(keep), "between two calls"), (b"MZ" + bytes(100), "no object"),
    (build(call("sinh")).replace(b"run\0", b"ran\0"), "no run"),
])  # fmt: skip
def test_what_needs_more_than_libm_or_keeps_something_is_refused(built, why):
    with pytest.raises(images.CannotLink, match=why):
        linking.link(built, "run")


def test_names_of_processors(monkeypatch, tmp_path):
    """A class is named where all that it may do is there: of the one below, too."""
    own, *classes = images.processors()
    assert len(own) == 8 and set(classes) <= set(images.LEVELS)
    below, above = sorted(images.LEVELS["x86-64-v3"]), sorted(images.LEVELS["x86-64-v4"])
    for flags, wanted in (
        (below + above, ["x86-64-v4", "x86-64-v3"]), (below, ["x86-64-v3"]), (below[1:] + above, []),
        (below + above[1:], ["x86-64-v3"]),
    ):  # fmt: skip
        monkeypatch.setattr(images, "read_processor", lambda flags=flags: {"model": "1", "flags": " ".join(flags)})
        assert images.processors.__wrapped__()[1:] == tuple(wanted)


FIRST_CALL = """
import sys
import numpy as np, polhode as ph
from polhode._base.compiled import entries
loaded, own = [], entries.Entry._load
def load(self, form):
    found = own(self, form)
    loaded.append((self.name.rpartition("_")[0], found is not None))
    return found
entries.Entry._load = load
times = np.linspace(0.0, 9.0, 6000)
attitude, momentum = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.ones((6000, 1)) * (0.3, 1.8, 1.5)).state(times)
print(sorted(loaded), "numba" in sys.modules, "llvmlite" in sys.modules, attitude[-1].tobytes().hex())
"""


@pytest.mark.long
def test_the_first_call_of_a_process_loads_what_is_on_the_disk(tmp_path):
    """Whatever its size was, Python did it until a third of a second had gone by, and then Numba was loaded."""
    forced = "from polhode.exact._closed_form import COMPILING\nCOMPILING.update(dict.fromkeys(COMPILING, 0.0))\n"
    environment, said = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path)}, []
    for code in (forced + FIRST_CALL, FIRST_CALL):
        command = [sys.executable, "-c", code]
        said.append(subprocess.run(command, env=environment, check=True, capture_output=True, text=True).stdout)
    wanted = [("set_up_free_body", True), ("states_of_many_free_body", True)]
    assert said[1].startswith(f"{wanted} False False") and said[1].split()[-1] == said[0].split()[-1]


DIGESTS = """
from polhode.exact.free_body._evaluation import FORM
from polhode.taylor import kernels
print(FORM._modules.kept_name, *(kernels._modules(width).kept_name for width in kernels.MODULES))
"""


def test_digests_are_the_same_in_every_process():
    """Sets have another order in each."""
    found = {subprocess.run([sys.executable, "-c", DIGESTS], env=os.environ | {"PYTHONHASHSEED": seed}, check=True,
                            capture_output=True, text=True).stdout for seed in "012"}  # fmt: skip
    assert len(found) == 1 and len(found.pop().split()) == 4


@pytest.fixture
def processors_anew():
    yield images.processors.cache_clear()
    images.processors.cache_clear()


@pytest.mark.parametrize("name", images.SETTINGS)
def test_what_is_set_for_the_compiler_is_in_the_name(name, monkeypatch, processors_anew):
    own, *classes = images.processors()
    images.processors.cache_clear()
    monkeypatch.setenv(name, "1")
    assert images.processors()[0] != own and images.processors()[1:] == tuple(classes)


def test_so_are_the_versions_of_the_compilers(monkeypatch, processors_anew):
    own = images.processors()[0]
    images.processors.cache_clear()
    monkeypatch.setattr(images, "read_version", lambda package: b"0.1")
    assert images.processors()[0] != own


@pytest.mark.parametrize("way", ["damaged", "no code may run"])
def test_without_numba_what_cannot_run_is_as_if_it_were_not_there(given, monkeypatch, tmp_path, way):
    check(entry(tmp_path, monkeypatch), given)
    if way == "damaged":
        damage(files(tmp_path)[0], monkeypatch)
    else:
        monkeypatch.setattr(entries, "load", refuse)
    bare = Entry("add_up_1234", "sums", tmp_path / "module.py", lambda: add_up, compiles=False)
    assert not bare.is_on_disk()
    check(bare, given)


def refuse(image):
    raise OSError("memory cannot be made executable")


def test_tuples_of_other_parts_are_other_forms(monkeypatch, tmp_path):
    def lengths(one, other, out):
        out[0], out[1] = len(one), len(other)

    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    function = Entry("lengths_1", "lengths", tmp_path / "m.py", lambda: CompiledFunction("lengths", lengths))
    for one, other in (((1.0, 2.0), (3.0,)), ((1.0,), (2.0, 3.0))):
        found = np.zeros(2)
        function(one, other, found)
        assert found.tolist() == [len(one), len(other)]


def test_other_numbers_and_arrays_are_refused_by_name(given, monkeypatch, tmp_path):
    function, (pair, scale, places) = entry(tmp_path, monkeypatch), given
    with pytest.raises(TypeError, match=r"whole numbers and tuples of these; got .*0\.5"):
        function(pair, np.float32(0.5), places, np.zeros((2, 3)))
    with pytest.raises(TypeError, match=r"shape \(2, 3\) with strides .*ascontiguousarray"):
        function(pair, scale, places, np.zeros((3, 2)).T)


def test_old_images_go(given, monkeypatch, tmp_path):
    monkeypatch.setattr(entries, "LIMITS", entries.LIMITS._replace(max_images=2))
    for digest in ("a", "b", "c"):
        check(entry(tmp_path, monkeypatch, f"add_up_{digest}"), given)
    assert len(files(tmp_path)) == 2


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
def test_a_forked_process_does_not_wait_for_a_thread_that_it_does_not_have(given, monkeypatch, tmp_path):
    function = entry(tmp_path, monkeypatch)
    with function._lock:  # as while a thread compiles
        child = os.fork()
        if not child:
            os._exit(function._lock.locked())
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0


def test_nothing_compiled_runs_where_that_is_switched_off(monkeypatch):
    images.has_images.cache_clear()
    monkeypatch.setenv("NUMBA_DISABLE_JIT", "1")
    assert not images.has_images() and not can_compile()
    monkeypatch.setattr(images, "read_processor", dict)
    monkeypatch.setenv("NUMBA_DISABLE_JIT", "0")
    images.has_images.cache_clear()
    assert not images.has_images() and can_compile()
    images.has_images.cache_clear()
