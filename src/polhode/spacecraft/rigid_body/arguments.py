"""From the arguments that a torque, mount or control law names to a table of a spec, and back to the object."""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import BeforeValidator, Field, create_model

from polhode.errors import InvalidInput, shown
from polhode.spec.fields import Attitude, Direction, Plain, mark_unit, one_of, quantity, three, three_rows
from polhode.spec.models import Strict

if TYPE_CHECKING:
    from polhode.spacecraft.systems.attachments import AbstractAttachment, Argument

FROM_ELSEWHERE = ("orbit", "field")
TEXT, ATTITUDE = "text", "attitude"


class Chosen(Strict):
    """One torque, mount or law of a spec.

    Attributes:
        type: its name.
        values: its arguments, in SI.
    """

    type: str
    values: dict[str, Any]


@lru_cache(maxsize=256)  # as pydantic takes milliseconds for a model, and a sweep would make it for each sample
def make_model(
    part: type[AbstractAttachment], name: str, key: str, base: type[Strict] = Strict
) -> type[Strict]:
    """Return the model of a table that names a part and gives its arguments.

    Args:
        part: the class.
        name: of it.
        key: that names it.
        base: the table's other keys.

    Raises:
        InvalidInput: for a part whose constructor has an argument that no spec can give.
    """
    fields: dict[str, Any] = {key: (str, ...)}
    parameters = _parameters(part)
    for argument, start in part.start_arguments.items():
        fields[argument] = (_field_type(start) | None, None)
    for argument, parameter in parameters.items():
        needed = parameter.default is inspect.Parameter.empty
        if argument in part.arguments:
            kind = _field_type(part.arguments[argument])
            description = Field(description=_example(part.arguments[argument]))
            fields[argument] = (Annotated[kind, description], ...) if needed else (kind | None, None)
        elif needed and argument not in FROM_ELSEWHERE:
            raise InvalidInput(
                f"the constructor of {part.__name__} has the argument {argument}, which a spec cannot give; name it "
                f"in `arguments` of the class, or let it have a default."
            )
    return create_model(f"{part.__name__}Table", __base__=base, **fields)


def needs(part: type[AbstractAttachment], what: str) -> bool:
    """Return whether the constructor of a part requires an argument that the spec gives elsewhere."""
    parameter = None if what in part.arguments else _parameters(part).get(what)
    return parameter is not None and parameter.default is inspect.Parameter.empty


def make_part(part: type[AbstractAttachment], values: Mapping[str, Any], elsewhere: Mapping[str, Any]) -> Any:
    """Return the object.

    Args:
        part: the class.
        values: arguments as ``make_model`` reads them; None where left out.
        elsewhere: values of ``FROM_ELSEWHERE``, as far as given.

    Raises:
        InvalidInput: for values that it refuses.
    """
    given = {name: value for name, value in values.items() if value is not None and name not in part.start_arguments}
    more = {name: value for name, value in elsewhere.items()
            if name in _parameters(part) and name not in part.arguments and value is not None}
    return part.from_table(**given, **more)


def _parameters(part: type[AbstractAttachment]) -> dict[str, inspect.Parameter]:
    own = inspect.signature(part.from_table).parameters
    if any(parameter.kind is inspect.Parameter.VAR_KEYWORD for parameter in own.values()):
        own = inspect.signature(part.__init__).parameters
    return {name: parameter for name, parameter in own.items() if name != "self"}


def _field_type(argument: Argument) -> Any:
    """Return the type of a field for an argument."""
    if argument.unit == TEXT:
        return Annotated[Literal[argument.choices], one_of(*argument.choices)]
    if argument.unit == ATTITUDE:
        return Attitude
    if argument.shape == (3, 3):
        row = _vector_type(argument.unit)
        return Annotated[tuple[row, row, row], three_rows]
    if argument.shape == (3,):
        one = _vector_type(argument.unit)
        return Annotated[list[one], BeforeValidator(_as_rows)] if argument.many else one
    number = Annotated[float, quantity(argument.unit)] if argument.unit else Plain
    return _one_or_many(argument.unit, number) if argument.many else number


def _as_rows(value: Any) -> Any:
    """Return one vector as a list of one."""
    return [value] if isinstance(value, list) and value and not any(isinstance(row, list) for row in value) else value


def _example(argument: Argument) -> str:
    """Return how to give an argument, for a message on one that is missing."""
    if argument.unit == TEXT:
        return f"give one of {', '.join(argument.choices)}"
    if argument.unit == ATTITUDE:
        return "give it in one of the forms that spin.attitude takes"
    if argument.shape and not argument.unit:
        return "give it like [0.0, 0.0, 1.0], along the given axes"
    one = f'"1 {argument.unit}"' if argument.unit else "1.0"
    row = f"[{one}, {one}, {one}]" if argument.shape else one
    return f"give it like {f'[{row}, {row}, {row}]' if argument.shape == (3, 3) else row}"


def _vector_type(unit: str) -> Any:
    if not unit:
        return Direction
    number = Annotated[float, quantity(unit)]
    return Annotated[tuple[number, number, number], three(unit)]


def _one_or_many(unit: str, number: Any) -> Any:
    """Return the type of a number, or of a list of them."""
    from pydantic import TypeAdapter

    reader = TypeAdapter(number)

    @mark_unit(unit)
    def read(value: Any) -> Any:
        if not isinstance(value, list):
            return _validate(reader, value)
        if not value:
            raise ValueError(f"must have at least one entry; got {shown(value)}")
        return tuple(_validate(reader, item) for item in value)

    return Annotated[Any, BeforeValidator(read)]


def _validate(reader: Any, value: Any) -> float:
    from pydantic import ValidationError

    try:
        return reader.validate_python(value)
    except ValidationError as error:
        raise ValueError(error.errors()[0]["msg"].removeprefix("Value error, ")) from None
