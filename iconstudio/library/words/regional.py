"""How a word is spelt on the other side of the Atlantic: *colour* and *color*.

The rules yield words that nobody writes as well: who asks keeps those that icons are called by.
"""

import re
from collections.abc import Iterator

_PAIRS = (
    "grey gray", "tyre tire", "aluminium aluminum", "pyjama pajama", "pyjamas pajamas",
    "moustache mustache", "plough plow", "doughnut donut", "jewellery jewelry", "kerb curb",
    "mould mold", "programme program", "axe ax", "draught draft", "disc disk", "cosy cozy",
    "yoghurt yogurt", "omelette omelet", "manoeuvre maneuver", "sulphur sulfur", "chilli chili",
    "judgement judgment", "ageing aging", "aeroplane airplane", "whisky whiskey", "mum mom",
    "foetus fetus", "oesophagus esophagus", "diarrhoea diarrhea", "oestrogen estrogen",
    "practise practice", "artefact artifact", "enrol enroll", "enrolment enrollment",
    "fulfil fulfill", "fulfilment fulfillment", "instalment installment", "woollen woolen",
    "speciality specialty", "sceptic skeptic", "storey story",
)  # fmt: skip
"""British and American spellings that follow no rule."""

_RULES = (
    (r"(?<=[a-z]{3})our(s|ed|ing|ful|ite|ites|er)?$", r"or\1"),
    (r"(?<=[a-z]{3})or(s|ed|ing|ful|ite|ites|er)?$", r"our\1"),
    (r"(?<=[a-z][^aeiou])re(s|d)?$", r"er\1"),
    (r"(?<=[a-z][^aeiou])er(s|d)?$", r"re\1"),
    (r"(?<=[iy])s(e|es|ed|er|ers|ing|ation|ations)$", r"z\1"),
    (r"(?<=[iy])z(e|es|ed|er|ers|ing|ation|ations)$", r"s\1"),
    (r"(?<=[a-z]{2})ogue(s?)$", r"og\1"),
    (r"(?<=[a-z]{2})og(s?)$", r"ogue\1"),
    (r"(?<=[a-z]{2}en)ce(s?)$", r"se\1"),
    (r"(?<=[a-z]{2}en)se(s?)$", r"ce\1"),
    (r"([aeiouy].*[^aeiou][aeio])ll(ing|ed|er|ers|or|ors)$", r"\1l\2"),
    (r"([aeiouy].*[^aeiou][aeio])l(ing|ed|er|ers|or|ors)$", r"\1ll\2"),
    (r"ae(?=[a-z])", "e"),
)
"""*Colour*, *centre*, *organise*, *catalogue*, *licence*, *labelled*, *anaesthesia*; and back."""

_LONGEST = 24
"""Most letters of a word that is spelt in several ways."""

_OTHER: dict[str, str] = {}
for _pair in _PAIRS:
    _british, _american = _pair.split()
    _OTHER |= {_british: _american, _american: _british}


def other_spellings(word: str) -> Iterator[str]:
    """Yield how else a word may be spelt, British or American."""
    if word in _OTHER:
        yield _OTHER[word]
    for written, other in _RULES if len(word) <= _LONGEST else ():
        if (spelt := re.sub(written, other, word)) != word:
            yield spelt
