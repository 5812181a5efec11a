"""What somebody types, made plain; and the spellings of identifiers."""

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from iconstudio.library.words import query


@pytest.mark.parametrize(
    ("typed", "words"),
    [
        (" Tea_Pots ", "tea pots"),
        ("Coffee-Cup", "coffee cup"),
        ("caf\u00e9", "cafe"),
        ("cafe\u0301", "cafe"),
        ("PI\u00d1ATA", "pinata"),
        ("pin\u0303ata", "pinata"),
        ("Stra\u00dfe", "strasse"),
        ("sm\u00f8rrebr\u00f8d", "smorrebrod"),
        ("bird\u2019s nest", "birds nest"),
        ("salt & pepper", "salt and pepper"),
        ("Two-tone folder", "twotone folder"),
        ("\uff24\uff2f\uff27", "dog"),
        ("\U0001f415", "dog"),
        ("\u2764\ufe0f", "red heart"),
        ("\u2764", "red heart"),
        ("\U0001f468\u200d\U0001f692", "man firefighter"),
        ("\U0001f469\U0001f3ff\u200d\U0001f692", "woman firefighter"),
        ("\U0001f44d\U0001f3fd", "thumbs up"),
        ("\U0001fabf", "goose"),
        ("\u2605", "black star"),
        ("my \U0001f415!", "my dog"),
        ("\U0001f1e9\U0001f1ea", "germany"),
        ("\U0001f3f4\U000e0067\U000e0062\U000e0065\U000e006e\U000e0067\U000e007f", "england"),
        ("1\ufe0f\u20e3", "1"),
        ("\U0001f1e9", ""),
        ("\U0001f3fb", ""),
        ("!?", ""),
        ("IconHome", "home"),
        ("ArrowLeftIcon", "arrow left"),
        ("\u2192", "arrow right"),
        ("\u221e", "infinity"),
        ("Iconic", "iconic"),
        ("Icon", "icon"),
        ("fas fa-house", "house"),
        ("ph-bold ph-house", "bold house"),
        ("bx bxs-home", "home"),
        ("feather icon-home", "home"),
        ("dashicons dashicons-admin-home", "home"),
        ("material-icons home", "home"),
        ("nf-fa-home", "home"),
        ("AiOutlineHome", "outline home"),
        ("FaHouse", "house"),
        ("mdiHome", "home"),
        ("WiFi router", "wifi router"),
        ("Tiger", "tiger"),
        ("tea tea-cup", "tea cup"),
        ("feather duster", "feather duster"),
        ("<MdHome/>", "home"),
        ('<MdHome size={24} color="red" />', "home"),
        ('<i class="bi bi-house"></i>', "house"),
        ('<i class="bi bi-house">', "house"),
        ('<iconify-icon icon="mdi:home" width="24"></iconify-icon>', "mdi home"),
        ('<span class="material-symbols-outlined">home</span>', "home"),
        ('<svg class="icon"><use xlink:href="sprite.svg#icon-home"></use></svg>', "icon home"),
        ("<FontAwesomeIcon icon={faHouse} />", "house"),
        ("<font-awesome-icon :icon=\"['fas', 'house']\" />", "house"),
        ('<font-awesome-icon icon="fa-solid fa-house" />', "solid house"),
        ('<ion-icon name="home-outline"></ion-icon>', "home outline"),
        ("<mat-icon>home</mat-icon>", "home"),
        ('<HomeIcon className="h-5 w-5" />', "home"),
        ('<PhHouse :size="32" />', "house"),
        ("import HomeIcon from '@mui/icons-material/Home';", "home"),
        ('Image(systemName: "house.fill")', "house fill"),
        ("Icons.home_outlined", "home outlined"),
        ("Icons.Default.Home", "home"),
        ("R.drawable.ic_home_black_24dp", "home"),
        ("icons/home.svg", "home"),
        ("~icons/mdi/home", "home"),
        ("fa-solid fa-house fa-2x", "solid house"),
        ("mdi mdi-24px mdi-home", "home"),
        ("octicon octicon-home", "home"),
        ("ion-ios-home", "home"),
        ("fi fi-rr-home", "home"),
        ("TrashIcon24Filled", "trash icon 24 filled"),
        ("HomeOutlined", "home outlined"),
        ("Home24Regular", "home 24 regular"),
        ("HomeTwoTone", "home twotone"),
        ("heroHome", "home"),
        ("FaRegHeart", "heart"),
        ("IoMdHome", "home"),
        ("GitHubIcon", "github"),
        ("<3", "3"),
        ("import export", "import export"),
        ("a < b", "a b"),
        ("pi", "pi"),
    ],
)
def test_plain(typed, words):
    assert query.plain(typed) == words


@given(st.text(max_size=30))
def test_plain_words_stay_plain_however_their_accents_are_composed(text):
    plain = query.plain(text)
    assert query.plain(plain) == plain == " ".join(plain.split())
    assert query.plain(unicodedata.normalize("NFD", text)) == plain


@pytest.mark.parametrize(
    ("typed", "bare"),
    [
        ("dog filled", "dog"),
        ("house outline", "house"),
        ("solid heart", "heart"),
        ("bold line dog", "dog"),
        ("dog 24 filled", "dog"),
        ("traffic light", "traffic light"),
        ("outline", "outline"),
    ],
)
def test_words_for_a_style_are_told_from_the_thing(typed, bare):
    assert " ".join(query.without_style(tuple(typed.split()))) == bare


@pytest.mark.parametrize(
    ("typed", "near", "far"),
    [
        ("dog filled", "dog-solid", "dog-outline"),
        ("outline house", "house-line", "house-fill"),
        ("line car", "car-outline-24", "car-duotone"),
        ("dog thin", "dog-light", "dog-bold"),
        ("sharp star", "star-sharp", "star-rounded"),
    ],
)
def test_a_style_that_is_asked_for(typed, near, far):
    style = query.style(tuple(typed.split()))
    name = query.without_style(tuple(typed.split()))[0]
    assert [style.distance(one) for one in (near, name, far)] == [0, query.SILENT, 2]


@pytest.mark.parametrize("typed", ["dog", "outline", "traffic light", "clothes line"])
def test_a_word_for_a_style_may_belong_to_the_thing(typed):
    words = tuple(typed.split())
    assert query.style(words) == query.Style(thing=frozenset(words))


@pytest.mark.parametrize(
    "typed",
    [
        "mdi:home-roof", "mdi-home-roof", "mdi/home-roof", "i-mdi-home-roof", "MDI:Home-Roof",
        "icon-[mdi--home-roof]", "i-mdi:home-roof", "mdi:home_roof", "mdiHomeRoof",
        " mdi home roof",
    ],
)  # fmt: skip
def test_spellings_of_an_identifier(typed):
    assert list(query.identifiers(typed, frozenset({"mdi", "ph"}))) == ["mdi:home-roof"]


def test_an_identifier_of_a_set_whose_name_begins_like_another():
    sets = frozenset({"fluent", "fluent-emoji"})
    assert list(query.identifiers("fluent-emoji-dog", sets)) == [
        "fluent-emoji:dog",
        "fluent:emoji-dog",
    ]
    assert list(query.identifiers("solar-panel", sets)) == []


def test_which_letters_are_latin():
    assert query.is_latin("caf\u00e9 3!") and query.is_latin("")
    assert not query.is_latin("\u0434\u043e\u043c") and not query.is_latin("\u5bb6")
