"""What registries have found: of other packages, to be forgotten; of wings, to be gone through."""

import importlib
import inspect


def public_classes(package, *bases):
    """Return the public classes of a package, and those of wings that derive from one of its base classes."""
    from polhode._base.plugins.wings import wing_names

    here = {getattr(package, name) for name in package.__all__}
    wings = [importlib.import_module(f"polhode.{name}") for name in wing_names()]
    there = {getattr(wing, name) for wing in wings for name in getattr(wing, "__all__", ())}
    return here | {kind for kind in there if inspect.isclass(kind) and issubclass(kind, bases)}


def every_command():
    """Return the commands of the application and of wings by name, as Typer has them."""
    from typer.main import get_command

    from polhode._base.plugins.wings import wing_points
    from polhode.cli.commands import app

    group = get_command(app)
    return {name: group.get_command(None, name) for name in [*group.commands, *wing_points("polhode.commands")]}


def forget_entry_points():
    """Have registries look for entry points again, and let changed code count as never imported."""
    from polhode._base import plugins
    from polhode.formats import form_registry
    from polhode.kinds import added_figures, registry
    from polhode.proving.symbolic import registry as derivations
    from polhode.spacecraft.rigid_body import named
    from polhode.spec import body_files
    from polhode.studies import fit_request

    for room in (registry, derivations, named, body_files, fit_request, form_registry):
        room._others.cache_clear()
    added_figures.added_figures.cache_clear()
    plugins._loaded.clear()
    plugins._warned.clear()
