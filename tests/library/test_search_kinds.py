"""Search by inflected words, by symbols, by styles; near things for what has no drawings; hints."""

import re

import pytest
from small_world import icon_set, shape

from iconstudio.library.search import RELEVANT
from iconstudio.library.words import query, symbols
from iconstudio.library.words.decency import UNKIND
from iconstudio.model import IconstudioError


def small(*names):
    return icon_set("a", {name: shape(number) for number, name in enumerate(names)})


def ids(collection, keyword):
    return [found.id.partition(":")[2] for found in collection.search(keyword)]


@pytest.fixture
def world(opened):
    return opened(
        small(
            "child", "children-toy", "dog", "dog-face", "dog-fill", "dog-outline", "fish", "run",
            "person-running", "wed", "wedding-cake", "lizard", "swing", "die", "game-die",
            "germany",
        ),
        icon_set("b", {"mouse": shape(16), "horse": shape(17), "shore": shape(18)}),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("keyword", "first", "never"),
    [
        ("children", {"child"}, set()),
        ("mice", {"mouse"}, set()),
        ("running", {"run"}, set()),
        ("ran", {"run"}, set()),
        ("\U0001f436", {"dog-face", "dog", "dog-fill", "dog-outline"}, set()),
        ("\U0001f3b2", {"game-die", "die"}, set()),
        ("\U0001f1e9\U0001f1ea", {"germany"}, set()),
        ("crocodile", {"lizard"}, set()),
        ("swing set", {"swing"}, set()),
        ("b:dog", {"dog", "dog-fill", "dog-outline"}, {"shore"}),
        ("b-dog", {"dog", "dog-fill", "dog-outline"}, {"shore"}),
        ("unheardof:dog", {"dog", "dog-fill", "dog-outline"}, set()),
    ],
)
def test_what_a_word_means(world, keyword, first, never):
    found = ids(world, keyword)
    assert set(found[: len(first)]) == first
    assert not never.intersection(found)


def test_a_child_is_found_by_its_plural_as_by_its_own_word(world):
    assert set(ids(world, "child")) == set(ids(world, "children"))


def test_a_wedding_is_no_form_of_to_wed_and_fishing_no_fish(world):
    assert ids(world, "wedding") == ["wedding-cake"]
    with pytest.raises(IconstudioError, match="'fishing'"):
        world.search("fishing")


@pytest.mark.parametrize(
    ("keyword", "order"),
    [
        ("dog filled", ["dog-fill", "dog", "dog-outline"]),
        ("line dog", ["dog-outline", "dog", "dog-fill"]),
        ("solid dogs", ["dog-fill", "dog", "dog-outline"]),
    ],
)
def test_drawings_of_the_style_that_is_asked_for_come_first(world, keyword, order):
    assert [name for name in ids(world, keyword) if name in order] == order


@pytest.mark.parametrize("keyword", ["heart", "house", "cat", "star"])
def test_the_ink_tells_the_style_of_drawings_whose_names_do_not(bundled, keyword):
    def ink(style):
        found = [one.id for one in bundled.search(f"{style} {keyword}")[:20]]
        silent = (one for one in found if query.style((style, keyword)).distance(one) == 3)
        return bundled._blackness[bundled._identifiers.numbers(silent)]

    assert all(ink("solid") >= 41) and all(ink("outline") < 60)


def test_dark_is_a_style_unless_it_is_a_thing_of_the_night(bundled):
    assert ids(bundled, "dark dog") == ids(bundled, "solid dog")
    assert bundled.remark("dark dog") == ""
    assert all("dark-mode" in name for name in ids(bundled, "dark mode")[:5])


@pytest.mark.parametrize("keyword", ["heart", "house", "star"])
def test_bold_and_thin_are_told_by_the_ink_where_names_are_silent(bundled, keyword):
    def ink(style):
        found = [one.id for one in bundled.search(f"{style} {keyword}")[:15]]
        return bundled._blackness[bundled._identifiers.numbers(found)].mean()

    assert ink("bold") > 50 and ink("thin") < 35


@pytest.mark.parametrize(("keyword", "first"), [("solid heart", "heart-solid")])
def test_of_a_style_the_thing_alone_comes_first(bundled, keyword, first):
    assert ids(bundled, keyword)[0] == first


@pytest.mark.parametrize(
    ("keyword", "never"),
    [
        ("rounded star", "moon"),
        ("rounded camera", "control|mobile"),
        ("sharp phone", "contact"),
        ("sharp cloud", "moon|rain"),
        ("duotone sun", "thermometer|cloud"),
        ("bold heart", "arrow"),
        ("rounded key", "action|keyboard"),
    ],
)
def test_of_a_style_no_other_thing_comes_before_the_thing_alone(bundled, keyword, never):
    assert not re.search(never, " ".join(ids(bundled, keyword)[:8]))


def test_a_style_that_only_other_things_have_is_told(bundled):
    assert "called “rounded”" in bundled.remark("rounded camera")
    assert bundled.remark("rounded star") == ""


def test_an_unknown_icon_whose_name_is_a_word_is_told_by_icons_of_the_word(world):
    with pytest.raises(IconstudioError) as caught:
        world.get("b:dog")
    assert "a:dog" in str(caught.value) and "b:shore" not in str(caught.value)


def test_of_several_words_the_known_ones_are_told(world):
    with pytest.raises(IconstudioError, match=r"Alone, these words find icons: child, lizard\."):
        world.search("child lizard")


@pytest.mark.parametrize(
    "typed", ["Hund", "perro", "chien", "\u0441\u043e\u0431\u0430\u043a\u0430"]
)
def test_another_language_is_told_the_english_word(world, typed):
    with pytest.raises(IconstudioError, match=r"Did you mean dog\? Icons have English names"):
        world.search(typed)


@pytest.mark.parametrize(
    ("typed", "words"),
    [
        ("\u72ac", ["dog"]),
        ("\u82b1", ["flower"]),
        ("\u6708", ["moon"]),
        ("\u9ce5", ["bird"]),
        ("\u732b", ["cat"]),
        ("\u306d\u3053", ["cat"]),
        ("\uac15\uc544\uc9c0", ["dog"]),
        ("\u30b3\u30fc\u30d2\u30fc", ["coffee"]),
        ("\u306e", []),
        ("nd", []),
    ],
)
def test_a_word_that_names_end_in_is_what_they_are_kinds_of(typed, words):
    assert symbols.english(typed) == words


@pytest.mark.parametrize(
    ("inflected", "word"),
    [
        ("children", "child"), ("mice", "mouse"), ("geese", "goose"), ("knives", "knife"),
        ("wolves", "wolf"), ("feet", "foot"), ("men", "man"), ("people", "person"),
        ("dice", "die"), ("leaves", "leaf"), ("running", "run"), ("swam", "swim"),
        ("foxes", "fox"), ("policemen", "policeman"), ("cacti", "cactus"),
    ],
)  # fmt: skip
def test_an_inflected_word_finds_what_the_word_finds(bundled, inflected, word):
    lookup = bundled._lookup
    near = {icon for icon, score in lookup.scores(word).items() if score <= RELEVANT}
    assert near and near <= set(lookup.scores(inflected))


@pytest.mark.parametrize(
    ("symbol", "word"),
    [
        ("\U0001f436", "dog"), ("\U0001f415", "dog"), ("\U0001f431", "cat"),
        ("\u2764\ufe0f", "heart"), ("\u2764", "heart"), ("\U0001f34e", "apple"),
        ("\u2615", "coffee"), ("\U0001f3b2", "die"), ("\U0001f697", "automobile"),
        ("\U0001f44d\U0001f3fd", "thumbs up"), ("\U0001f469\u200d\U0001f680", "astronaut"),
        ("\U0001fabf", "goose"), ("\u2702\ufe0f", "scissors"),
    ],
)  # fmt: skip
def test_an_emoji_finds_what_its_word_finds(bundled, symbol, word):
    lookup = bundled._lookup
    assert set(lookup.plainly(word)) <= set(lookup.scores(symbol))


@pytest.mark.parametrize(
    ("symbol", "first", "never"),
    [
        ("\U0001f3f3\ufe0f\u200d\U0001f308", "flag", "rainbow"),
        ("\U0001f3f3\ufe0f\u200d\u26a7\ufe0f", "flag", "transgender"),
        ("\U0001f3f4\u200d\u2620\ufe0f", "pirate-flag|black-flag", "rainbow"),
        ("\U0001f3c1", "flag-chequered", "checkbox"),
        ("\U0001f6a9", "triangular-flag", "ruler"),
        ("\U0001f469\u200d\U0001f692", "firefighter", "miss"),
        ("\U0001f468\u200d\U0001f469\u200d\U0001f467", "family", "miss"),
        ("\U0001f469\u200d\u2764\ufe0f\u200d\U0001f468", "couple", "miss"),
        ("\U0001f468\u200d\U0001f9bd", "wheelchair", "hand"),
        ("\U0001f469\u200d\u2695\ufe0f", "doctor|health-worker", "domestic"),
        ("\U0001f9d1\u200d\U0001f384", "father-christmas", "socket"),
        ("\U0001f9d8\u200d\u2642\ufe0f", "yoga", "position"),
    ],
)
def test_emoji_joined_of_several_find_what_they_show_together(bundled, symbol, first, never):
    found = ids(bundled, symbol)
    assert all(re.search(first, name) for name in found[:2])
    assert not [name for name in found if never in name]


def test_beside_what_the_flag_of_a_country_finds_it_is_told_that_flags_are_left_out(bundled):
    assert ids(bundled, "\U0001f1eb\U0001f1f7")
    assert bundled.remark("\U0001f1eb\U0001f1f7").startswith("Flags of countries are left out")


@pytest.mark.parametrize("symbol", ["\U0001f3a0", "merry go round", "merry-go-round"])
def test_a_merry_go_round_is_a_carousel(bundled, symbol):
    found = bundled._lookup.scores(symbol)
    assert set(bundled._lookup.plainly("carousel")) <= set(found)
    assert all("carousel" in name for name in ids(bundled, symbol)[:3])


@pytest.mark.parametrize("flag", ["\U0001f1e9\U0001f1ea", "\U0001f1f2\U0001f1e8"])
def test_of_the_flag_of_a_country_it_is_told_that_there_are_none(bundled, flag):
    with pytest.raises(IconstudioError, match=r"\)\. Flags of countries are left out: in one"):
        bundled.search(flag)


@pytest.mark.parametrize(
    ("keyword", "name"),
    [
        ("crocodile", "reptile"), ("toe", "foot"), ("bulldog", "dog"), ("puffin", "bird"),
        ("mackerel", "fish"), ("celery", "vegetable"), ("tarantula", "spider"),
        ("blouse", "shirt"), ("tricycle", "bicycle"), ("cr\u00e8che", "nursery"),
    ],
)  # fmt: skip
def test_near_things_stand_in_for_what_has_no_drawings(bundled, keyword, name):
    assert any(name in found for found in ids(bundled, keyword))


@pytest.mark.parametrize(
    ("keyword", "never"),
    [
        ("CR\u00c8CHE", "hospital"), ("waiter", "server"), ("surgeon", "docs"), ("judge", "doge"),
        ("stapler", "machine"), ("walnut", "bolt"), ("person", "ruler"), ("pilot", "copilot"),
        ("salamander", "unlink"), ("wedding", "wednesday"),
        ("\U0001f1fa\U0001f1f8", "state"),
    ],
)  # fmt: skip
def test_nothing_far_fetched(bundled, keyword, never):
    try:
        found = ids(bundled, keyword)
    except IconstudioError:
        found = []
    assert not [name for name in found if never in name]


@pytest.mark.parametrize("typed", ["\xe9lectricit\xe9", "microskope", "heart2y"])
def test_hints_are_plain_words(bundled, typed):
    hints = bundled.suggest(typed)
    assert hints and all(one.replace(" ", "").isalpha() for one in hints)


@pytest.mark.parametrize("name", ["Levi", "levi", "Devlin", "Deth", "Piet", "Fooly", "Zombi"])
def test_no_hint_turns_a_name_into_something_bad(bundled, name):
    assert UNKIND.isdisjoint(bundled.suggest(name))


def test_a_name_beside_a_thing_is_not_read_as_something_bad(bundled):
    assert len(bundled.search("Levi minion")) > 1
    assert bundled.remark("Levi minion").endswith("“levi” was left out.")


def test_a_plain_mistake_in_a_word_for_something_bad_is_told(bundled):
    assert "monster" in bundled.suggest("monstr")


@pytest.mark.parametrize("keyword", ["ass", "boob", "hell", "asses", "jew", "squaw", "damn"])
def test_in_place_of_a_rude_word_nothing_is_proposed(bundled, keyword):
    assert bundled.suggest(keyword) == ()
    with pytest.raises(IconstudioError) as error:
        bundled.search(keyword)
    assert not re.search("Did you mean|Of its kind", str(error.value))
    with pytest.raises(IconstudioError, match="Search for what it shows"):
        bundled.get(f"lucide:{keyword}")


def test_a_rude_word_among_others_is_not_read_as_another(bundled):
    assert bundled.remark("boob house").endswith("“boob” was left out.")


@pytest.mark.parametrize("keyword", ["sex", "Sexes", "sex icon"])
def test_who_is_no_sex_is_not_shown_as_one(bundled, keyword):
    assert not [name for name in ids(bundled, keyword) if "worker" in name]
    assert bundled.remark(keyword).endswith("was read as “gender”.")
    assert all("sex-worker" in name for name in ids(bundled, "sex worker"))


def test_no_hint_hurts(bundled):
    hurtful = {"bum", "rape", "slave", "suicide", "swastika", "eskimo", "anus", "penis"}
    assert hurtful.isdisjoint(bundled._lookup._terms.proposals())


@pytest.mark.parametrize(
    ("keyword", "name"),
    [
        ("car", "auto"),
        ("automobile", "auto"),
        ("screen", "cover"),
        ("soap", "max"),
        ("earth", "land"),
    ],
)
def test_a_word_that_is_rarely_drawn_alone_does_not_stand_for_a_common_thing(
    bundled, keyword, name
):
    named = [one.split("-") for one in ids(bundled, keyword)]
    said = {keyword, "car"}  # *car-auto* says by itself that it is a car
    assert not [one for one in named if name in one[1:] and said.isdisjoint(one)]


@pytest.mark.parametrize(
    ("keyword", "name"),
    [("airplane", "paper-plane"), ("trash", "recycle-bin"), ("chapeau", "cowboy-hat")],
)
def test_a_word_that_is_drawn_alone_as_well_still_does(bundled, keyword, name):
    numbers = bundled._lookup.plainly(keyword)
    assert any(name in one for one in bundled._lookup.identifiers(numbers).values())


@pytest.mark.parametrize("keyword", ["merry go home", "old merry go"])
def test_the_last_word_does_not_stand_for_all_if_it_names_nothing(bundled, keyword):
    with pytest.raises(IconstudioError, match="Alone, these words find icons"):
        bundled.search(keyword)


@pytest.mark.parametrize("keyword", ["merry go-kart", "an old stop sign", "red house", "go"])
def test_the_things_of_the_last_words_still_do(bundled, keyword):
    assert ids(bundled, keyword)


@pytest.mark.parametrize(
    "keyword",
    [
        "slut",
        "Retard",
        "bitches",
        "faggot",
        "fuck",
        "whore",
        "black bitch",
        "mdi:slut",
        "dick",
        "tits",
        "hitler",
        "Hooters",
    ],
)
def test_for_a_word_that_offends_nothing_is_shown_or_proposed(bundled, keyword):
    with pytest.raises(IconstudioError, match=rf"called '{keyword}'\. Name the thing to draw"):
        bundled.search(keyword)
    assert bundled.suggest(keyword) == ()
    with pytest.raises(IconstudioError, match="Search for what it shows"):
        bundled.get(f"nope:{keyword.rpartition(':')[2]}")


@pytest.mark.parametrize("keyword", ["an", "the", "is"])
def test_what_names_nothing_leads_to_no_guess(bundled, keyword):
    with pytest.raises(IconstudioError) as error:
        bundled.search(keyword)
    assert "Did you mean" not in str(error.value)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("bycicle", "bicycle"),
        ("hosue", "house"),
        ("umbrlela", "umbrella"),
        ("girafe", "giraffe"),
        ("ombrella", "umbrella"),
    ],
)
def test_a_misspelt_word_is_told(bundled, typed, meant):
    assert bundled.suggest(typed)[0] == meant


@pytest.mark.parametrize(
    ("keyword", "logos"),
    [
        ("apple", {"si:apple-line", "streamline:apple", "jam:apple-circle", "iconoir:apple-mac"}),
        ("windows", {"streamline:windows", "raphael:windows", "teenyicons:windows-outline"}),
        ("opera", {"tdesign:opera", "jam:opera-square", "la:opera", "teenyicons:opera-outline"}),
        ("edge", {"teenyicons:edge-outline", "bi:browser-edge"}),
        ("pocket", {"iconoir:pocket", "mynaui:pocket"}),
        ("yarn", {"la:yarn"}),
    ],
)
def test_a_thing_that_a_brand_is_called_by_is_no_logo(bundled, keyword, logos):
    found = [one.id for one in bundled.search(keyword)]
    assert found and logos.isdisjoint(found)
    for logo in logos:
        with pytest.raises(IconstudioError, match="has no icon"):
            bundled.get(logo)


@pytest.mark.parametrize("brand", ["safari", "Telegram", "mastodon"])
def test_of_what_only_logos_are_called_it_is_told_that_they_are_left_out(bundled, brand):
    with pytest.raises(IconstudioError, match=rf"'{brand}'\. Icons have.* logos of brands"):
        bundled.search(brand)


@pytest.mark.parametrize("brand", ["github", "Instagram", "twitter", "paypal"])
def test_of_brands_it_is_told_that_there_are_none(bundled, brand):
    with pytest.raises(IconstudioError, match=rf"'{brand}'\. Icons have.* logos of brands"):
        bundled.search(brand)


@pytest.mark.parametrize("keyword", ["x" * 5000, "unheardof:" + "x" * 5000, "zzq qqz " * 999])
def test_a_keyword_that_is_very_long_is_not_repeated_whole(bundled, keyword):
    for ask in (bundled.search, bundled.get):
        with pytest.raises(IconstudioError) as error:
            ask(keyword)
        assert len(str(error.value)) < 400


@pytest.mark.parametrize(
    ("identifier", "told"),
    [("lucide:nosuch", "Search for"), ("lucide:xyzzy", "Search for"), ("lucide:anchr", "anchor?")],
)
def test_of_an_unknown_icon_only_what_is_near_is_told(bundled, identifier, told):
    with pytest.raises(IconstudioError) as error:
        bundled.get(identifier)
    assert told in str(error.value)
    assert "mouth" not in str(error.value) and "pizza" not in str(error.value)


@pytest.mark.parametrize(
    ("typed", "told"),
    [
        ("heroicons:trsh", "Did you mean heroicons:trash?"),
        ("carbon:settigns", "Did you mean carbon:settings"),
        ("ph:hous", "Did you mean ph:house"),
        ("lucide:cammera", "Did you mean lucide:"),
    ],
)
def test_of_an_unknown_icon_that_is_looked_for_near_ones_of_its_set_are_told(bundled, typed, told):
    with pytest.raises(IconstudioError) as error:
        bundled.search(typed)
    assert told in str(error.value)


@pytest.mark.parametrize(
    ("typed", "told"),
    [
        ("mdi:acount", "The collection has no icon 'mdi:acount'. Did you mean mdi:account?"),
        ("mdi-home", "The collection has no icon 'mdi:home'. Of icons that look alike it has one."),
        ("tabler:acess-point", "Did you mean tabler:access-point? “acess” was read as “access”."),
        ("ion:camera", "The collection has no icon 'ion:camera'. Those of other sets are shown."),
        ("twemoji:cat", "The collection has no set “twemoji”: icons of other sets are shown."),
        ("fluent-emoji:cat", "The collection has no set “fluent-emoji”: icons of other sets"),
        ("gis:map", ""),
        ("solar panel", ""),
        ("fas fa-house", ""),
    ],
)
def test_beside_what_an_unknown_icon_finds_it_is_told_that_it_is_not_there(bundled, typed, told):
    assert bundled.search(typed)
    remark = bundled.remark(typed)
    assert told in remark and bool(remark) == bool(told)
    assert remark.count("Did you mean") <= 1


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("abbrechen", "cancel"),
        ("zurück", "back"),
        ("siguiente", "next"),
        ("imprimer", "print"),
        ("aiuto", "help"),
        ("キャンセル", "cancel"),
    ],
)
def test_words_of_buttons_elsewhere_are_told_in_english(bundled, typed, meant):
    with pytest.raises(IconstudioError, match=rf"Did you mean (\w+, )*{meant}\b"):
        bundled.search(typed)


def test_of_an_unknown_icon_without_a_like_it_is_told_what_to_do(bundled):
    with pytest.raises(IconstudioError, match=r"no icon 'qqq:qqzzq'\. Search for what it shows"):
        bundled.get("qqq:qqzzq")


@pytest.mark.parametrize(
    ("keyword", "told", "never"),
    [
        ("telefone", "telephone", "zzz"),
        ("facebook", "", "macbook"),
        ("Nike", "", "mean"),
        ("Sony", "", "mean"),
        ("Audi", "", "mean"),
        ("Levi's", "", "mean"),
        ("hous", "hours, house", "zzz"),
        ("sadness", "sad", "sharpness"),
        ("happiness", "happy", "harness"),
        ("hapiness", "", "harness"),
        ("loneliness", "lonely", "zzz"),
        (".net", "", "Did you mean"),
        ("ASP.NET", "", "Did you mean"),
        ("Fu\u00dfball", "soccer ball", "zzz"),
        ("f\u00fatbol", "soccer", "zzz"),
        ("\u0628\u064a\u062a", "house", "zzz"),
    ],
)
def test_a_hint_is_near_or_none(bundled, keyword, told, never):
    with pytest.raises(IconstudioError) as error:
        bundled.search(keyword)
    assert never not in str(error.value)
    assert not told or f"Did you mean {told}" in str(error.value)


@pytest.mark.parametrize(
    ("typed", "named"),
    [
        ("plane taking off", "takeoff"),
        ("logging in", "log-?in"),
        ("thanksgiving", "turkey"),
    ],
)
def test_words_find_what_names_call_otherwise(bundled, typed, named):
    found = ids(bundled, typed)
    assert sum(re.search(named, name) is not None for name in found[:3]) >= min(2, len(found))
    assert not bundled.remark(typed)


@pytest.mark.parametrize("keyword", ["usb c", "USB-C", "bi-house-fill", "home 3"])
def test_of_no_word_that_icons_found_bear_it_is_said_that_it_was_left_out(bundled, keyword):
    assert "left out" not in bundled.remark(keyword)
