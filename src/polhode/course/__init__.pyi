from .exercises import Choice as Choice
from .exercises import Exercise as Exercise
from .exercises import Question as Question
from .exercises import chapter_names as chapter_names
from .exercises import read_chapter as read_chapter
from .site import built_course as built_course
from .worksheets import worksheet as worksheet
