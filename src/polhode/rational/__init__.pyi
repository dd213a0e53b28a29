from .numbers import exact_number as exact_number
from .numbers import exact_numbers as exact_numbers
