"""What is shown only to who asks for it by name, and never proposed: private parts and rude words.

WordNet says which words are rude, and what lies under the few meanings that are listed here. A
collection that is opened knows only the words listed here.
"""

from iconstudio.library.words.inflections import singulars
from iconstudio.library.words.nearness import is_one_mistake
from iconstudio.library.words.vocabulary import words as word_set
from iconstudio.library.words.wordnet import WordNet

_PRIVATE = (
    "reproductive organ", "gonad", "erectile organ", "vagina", "scrotum", "mammary gland", "breast",
    "buttocks", "anus", "sperm", "body waste", "sexual activity", "contraceptive", "vibrator",
    "prostitute",
)  # fmt: skip
"""Words for what one would not show, or say aloud, unasked; their first meaning, and its kinds."""

_BESIDES = word_set(
    """
    boob boobs bum crap damn eskimo genocide gypsy holocaust incest jackass jew lynch molest noose
    poo pussy rape slave suicide swastika tit
    """
)
"""Words that hurt, or are rude, and that WordNet does not mark."""

INSULTS = word_set(
    """
    arse arsehole asshole bastard bimbo bitch blowjob bollocks boobs bugger bullshit chink clit
    coon cretin cum cunt darkie darky dick dickhead dildo dumbass fag faggot fuck fucked fucker
    fucking gestapo goebbels golliwog gook halfwit harlot heil himmler hitler honky hooker
    hooters idiot imbecile jizz kaffir kike kkk klan lesbo milf mongoloid moron
    motherfucker nazi negress negro nigga nigger nutter paki pedo pedophile pervert pickaninny
    pimp piss porn porno raghead rape raper rapist redskin retard sambo shemale shit
    shitty skank slut slutty spastic spic squaw stalin strumpet thot tits titties titty
    tosser towelhead tranny turd twat wank wanker wetback whore wog wop yid
    """
)
"""Words that offend and name no thing to draw: nothing is shown, or proposed, in their place."""

UNKIND = word_set(
    """
    addict ass beggar clown corpse criminal dead death demon devil dumb drunk enemy evil fat fool
    ghoul hag hate hell hoe killer leech liar loser monster murder murderer nasty ogre pest pig
    plague poop prisoner robber satan sin stupid swine terrorist thief traitor troll ugly vermin
    victim villain wicked zombie
    """
)
"""Words that are no hint for what may be a name: nobody is told to be meant by one of them."""

_RUDE = ("obscenity", "ethnic slur", "disparagement")
"""Words by which WordNet marks how others are used."""


MEANT = {"sex": "gender"}
"""What is shown for words that name something private only together with others: *sex worker*."""


def is_insult(words: str) -> bool:
    """Whether plain words, or one of them, only offend."""
    return _has(words, INSULTS)


def is_rude(words: str) -> bool:
    """Whether plain words, or one of them, are such that nothing is proposed in their place."""
    return _has(words, INSULTS | UNKIND | _BESIDES)


def _has(words: str, listed: frozenset[str]) -> bool:
    return any(
        not listed.isdisjoint((word, word.removesuffix("s"), *singulars(word)))
        for word in words.split()
    )


def is_unkind(keyword: str, word: str) -> bool:
    """Whether to propose a word for a keyword as typed might turn a name into something bad.

    What begins with a capital letter may be a name. Other keywords are misspelt if one letter is
    wrong, but not the first.
    """
    if word not in UNKIND:
        return False
    return keyword[:1].isupper() or keyword[:1] != word[:1] or not is_one_mistake(keyword, word)


class Decency:
    """Tells which words are not for saying unasked."""

    def __init__(self, wordnet: WordNet) -> None:
        self._wordnet = wordnet
        self._rude = {key for word in _RUDE for key in wordnet.senses.get(word, ())}
        roots = {wordnet.senses[word][0] for word in _PRIVATE if word in wordnet.senses}
        self._private = _descendants(wordnet, roots)

    def is_private(self, key: int) -> bool:
        """Whether the meaning ``key`` is not for showing unasked."""
        return key in self._private or bool(
            self._rude.intersection(self._wordnet.synsets[key].usages)
        )

    def is_unspoken(self, word: str) -> bool:
        """Whether ``word``, or a part of it, is not for saying: by what it means first."""
        return not _BESIDES.isdisjoint(word.split()) or any(
            self.is_private(key)
            for part in {word, *word.split()}
            for key in self._wordnet.senses.get(self._wordnet.lemma(part), ())[:1]
        )


def _descendants(wordnet: WordNet, roots: set[int]) -> frozenset[int]:
    found: set[int] = set()
    open_ = list(roots)
    while open_:
        key = open_.pop()
        if key not in found:
            found.add(key)
            open_ += wordnet.children.get(key, ())
    return frozenset(found)
