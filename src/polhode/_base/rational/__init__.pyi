from .numbers import read_number as read_number
