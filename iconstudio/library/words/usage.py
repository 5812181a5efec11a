"""What collections of icons mean by words, and designers, where WordNet says something else."""

from iconstudio.library.words.vocabulary import words


def _listed(text: str) -> dict[str, tuple[str, ...]]:
    """Return word: terms, of a text of "word: term other_term, word: term, ..."."""
    pairs = (pair.strip().partition(": ") for pair in text.split(","))
    return {
        word: tuple(term.replace("_", " ") for term in terms.split()) for word, _, terms in pairs
    }


USAGE = {
    "bike": "bicycle",
    "plane": "airplane",
    "chicken": "hen",
    "mouse": "rodent",
    "glass": "drinking glass",
    "lamb": "sheep",
    "turkey": "fowl",
    "apple": "fruit",
    "boot": "footwear",
    "crane": "lifting device",
    "crepe": "pancake",
    "tank": "vehicle",
}
"""What collections of icons mean by a word, where WordNet puts another meaning first."""

SYNONYMS = (
    "home house", "bike bicycle", "motorbike motorcycle", "plane airplane aeroplane aircraft",
    "couch sofa settee", "puppy dog", "kitten cat", "bunny rabbit", "hare rabbit",
    "phone telephone", "tv television", "car automobile auto", "truck lorry", "hen chicken",
    "pc computer", "ship boat", "cup mug", "cow cattle", "pony horse", "lamp lantern",
    "flashlight torch", "glasses eyeglasses spectacles", "bulb lightbulb", "rocket spaceship",
    "present gift", "bag handbag", "purse handbag", "photo photograph", "film movie",
    "cactus cacti", "helicopter chopper", "ax axe", "donut doughnut", "airplane airliner",
    "sneaker trainer", "trashcan bin", "bin trash", "trash garbage", "sailboat boat",
    "eggplant aubergine", "biscuit cookie",
    "subway metro", "shop store", "mailbox postbox", "suitcase luggage", "gear cog cogwheel",
    "pitcher jug", "tap faucet", "t_rex tyrannosaurus dinosaur",
)  # fmt: skip
"""Words that collections of icons use for the same drawing."""

STAND_INS = _listed(
    """
    alligator: lizard reptile, ankle: foot, antelope: deer, armpit: arm, baker: chef cook,
    bangs: hair, barrette: hair_clip, basil: herb leaf, beak: bird, belly: stomach body,
    big toe: foot, blouse: shirt, bobsled: sled sledge, bonfire: campfire fire, braid: hair,
    brow: eyebrow, calf: cow leg, casket: coffin, cheek: face, chickpea: bean,
    chimpanzee: monkey gorilla, chin: face, christmas tree: pine_tree, coat of arms: shield,
    cod: fish, cooler: refrigerator, courgette: cucumber vegetable, creche: nursery,
    crocodile: lizard reptile, cub: bear,
    eardrum: ear, earlobe: ear, eyelid: eye, feast: meal dinner, ferret: otter badger, fig: fruit,
    forehead: head face, freckle: face, fringe: hair, galoshes: boot, gazelle: deer,
    great dane: dog, gymnast: gymnastics, hairpin: hair_clip, hermit crab: crab,
    hip: waist, hornet: wasp bee, hovercraft: boat, jackal: wolf dog, jade: gem gemstone,
    jaw: face, jockey: horse, jungle: forest tree, kilt: skirt, knuckle: fist, lamb: sheep,
    lampshade: lamp, lemur: monkey, lentil: bean, lifeboat: boat, lioness: lion, little toe: foot,
    locket: necklace, lute: guitar, meadow: grass, merry go round: amusement_ride,
    mink: otter badger, mint: leaf herb, moth: butterfly, mud: puddle, mule: donkey horse,
    navel: stomach, nectarine: fruit, nostril: nose, oboe: clarinet flute, ointment: medicine,
    omelette: egg, opal: gem gemstone, orca: whale, oregano: herb leaf, ovary: uterus,
    ox: cow cattle, papaya: fruit, parachutist: parachute, paragliding: parachute,
    parsley: herb leaf, photocopier: printer, pigtail: hair, plank: wood, pomegranate: fruit,
    porch: house, potty: toilet, pouch: bag, princess: queen, pupil: eye, raisin: fruit,
    ravioli: pasta, retina: eye, rosemary: herb leaf, rye: wheat, sage: herb leaf,
    saint bernard: dog, salmon: fish, samosa: dumpling, sardine: fish, seashell: shell,
    shawl: scarf, shin: leg, shoelace: shoe, sideburns: beard, sidewalk: footpath,
    sieve: strainer filter, snout: nose, snowball: snow, sole: foot, spacesuit: astronaut,
    stingray: fish, stirrup: saddle, tablecloth: table, tailor: sewing, tendon: muscle, thigh: leg,
    thimble: sewing, thistle: flower, thyme: herb leaf, toe: foot, toenail: foot, toupee: wig,
    trapdoor: door, tricycle: bicycle, tuna: fish, underground: subway,
    verandah: house, warrior: knight, warthog: pig,
    washbasin: sink, wasp: bee, weasel: otter badger, whirlpool: spiral, yak: ox cow,
    zither: harp guitar, zucchini: cucumber vegetable
    """
)
"""What is taken for a thing that has no drawings, or few."""

FEELINGS = _listed(
    """
    afraid: fearful, amazed: astonished, anger: angry, ashamed: flushed, bored: unamused,
    boredom: unamused, cheerful: happy, content: happy, curious: thinking, delighted: happy,
    depressed: sad, disgust: nauseated, disgusted: nauseated, drunk: woozy, embarrassed: flushed,
    excited: star struck, exhausted: tired, fear: fearful, frustrated: persevering,
    furious: angry, glad: happy, grumpy: angry, guilty: pensive, hungry: face savoring food,
    ill: face with thermometer, inlove: heart eyes, joy: happy, joyful: happy, lonely: sad,
    mad: angry, melancholy: pensive, nervous: anxious, pleased: happy, proud: happy,
    relaxed: relieved, satisfied: happy, scared: fearful, shocked: astonished, shy: flushed,
    sick: face with thermometer, smug: happy, stressed: anxious, suspicious: raised eyebrow,
    thoughtful: thinking, upset: sad, unhappy: sad
    """
)
"""How people feel, and how names of icons call a face like that."""

UNDRAWN = _listed(
    """
    accommodation: hotel, committee: meeting, mortgage: loan, parliament: government
    """
)
"""Words for what has no drawings, and what shows the same."""

INFORMAL = (
    UNDRAWN
    | FEELINGS
    | _listed(
        """
    247: 24 hours, 24h: 24 hours, 24hr: 24 hours, abomb: atomic bomb, ac: air conditioner,
    acct: account, addon: plugin, addr: address, admin: administrator, advert: ad,
    aircon: air conditioner, approx: approximately equal, appt: appointment, apt: apartment,
    attn: attention, auth: authentication, autumnleaf: fallen leaf, autumnleave: fallen leaf,
    avg: average, avo: avocado, bathers: swimsuit, bauble: christmas ball, bball: basketball,
    bday: birthday, bellybutton: navel, bestie: friend, bff: friend, bg: background,
    bickie: biscuit, bigwheel: ferris wheel, bikkie: biscuit, bino: binoculars, binocs: binoculars,
    bio: biology, birdie: bird, biz: business, bkmk: bookmark, bldg: building, bobsleigh: bobsled,
    booboo: bandage, bowwow: dog, bp: blood pressure, brekkie: breakfast, brekky: breakfast,
    btc: bitcoin, btn: button, byebye: waving hand, caff: cafe, cal: calendar, calc: calculator,
    cam: camera, cardi: cardigan, carouselhorse: carousel, catsup: ketchup, cclamp: clamp,
    cfg: settings, champers: champagne, char: character, chem: chemistry, chimp: chimpanzee,
    chinesenewyear: firecracker, chk: check, choc: chocolate, choccy: chocolate, choochoo: train,
    chook: chicken, cig: cigarette, ciggie: cigarette, ciggy: cigarette, claus: father christmas,
    cmd: command, cny: yuan, col: column, comp: computer, condo: apartment, conf: settings,
    config: settings, coord: coordinates, copter: helicopter, cornflakes: cereal, cossie: swimsuit,
    cozzie: swimsuit, croc: crocodile, ctrl: control, culdesac: dead end, cuppa: tea cup,
    curr: currency, cv: resume, daddylonglegs: spider, db: database, del: delete,
    dest: destination, dev: developer, dict: dictionary, dingdong: bell, dino: dinosaur,
    dir: directory, dist: distance, diwali: oil lamp, diy: tools, dl: download, doggo: dog,
    dorm: dormitory, duckie: duck, ducky: duck, dunny: toilet, dup: duplicate,
    ebike: electric bike, ebook: e reader, ecar: electric car, ecig: vape, ecigarette: vape,
    edu: education, ekg: ecg, emt: ambulance, eng: engine, env: environment, er: emergency,
    err: error, escooter: electric scooter, eticket: ticket, eur: euro, ewallet: wallet,
    ext: extension, fav: favorite, fave: favorite, ffwd: fast forward, fireman: firefighter,
    firewoman: firefighter, fishy: fish, footie: football, footy: football, foto: photo,
    freq: frequency, froggie: frog, froggy: frog, fwd: forward, gbp: pound, gclamp: clamp,
    geegee: horse, geoloc: location, gocart: go kart, gov: government, govt: government,
    grad: graduate, grandad: grandparent, granddad: grandparent, grp: group, guac: avocado,
    gumboot: rubber boot, haha: laughing, hankie: handkerchief, hanky: handkerchief,
    hanukkah: menorah, happynewyear: fireworks, hbomb: atomic bomb, healthworker: doctor,
    heli: helicopter, hgv: truck, hifive: high five, hist: history, hivis: vest, hols: holiday,
    hoolahoop: hula hoop, hoover: vacuum cleaner, horsey: horse, horsie: horse, hosp: hospital,
    hq: headquarters, hr: hour, hwy: highway, img: image, inr: rupee, intl: globe, inv: invoice,
    ipad: tablet, jab: syringe, jackolantern: pumpkin, jpy: yen, k9: dog, kb: keyboard,
    kittycat: cat, lang: language, lappy: laptop, lashes: eyelash, lcd: screen, lib: library,
    lic: license, loc: location, loco: locomotive, lotusposition: yoga, lp: vinyl record,
    lvl: level, maths: math, max: maximize, medic: doctor, meds: medicine, mem: memory, memo: note,
    merrygoround: carousel, mgmt: management, mgr: manager, min: minimize, mob: mobile,
    moggie: cat, moggy: cat, moto: motorcycle, mozzie: mosquito, msg: message, mtg: meeting,
    mtn: mountain, mum: mother, mushie: mushroom, nan: grandparent, nana: grandparent,
    nanna: grandparent, newyear: fireworks, newyearseve: fireworks, notif: notification,
    num: number, oj: orange juice, opt: option, org: organization, papa: father, param: parameter,
    perc: percent, perf: performance, perm: permission, phot: photo, phys: physics, pic: picture,
    piccy: picture, piggie: pig, pinkie: little finger, pinky: little finger, pkg: package,
    pref: settings, prev: previous, prod: product, prof: teacher, promo: promotion,
    pushchair: stroller, pussycat: cat, pw: password, pwd: password, qtip: cotton swab,
    qty: quantity, rec: record, reg: register, req: request, resp: response,
    rew: rewind, rip: gravestone, roach: cockroach, roo: kangaroo, rubbish: trash, rugger: rugby,
    sammie: sandwich, santa: father christmas, santaclaus: father christmas, sarnie: sandwich,
    sched: schedule, sec: security, sel: select, sess: session, shades: sunglasses,
    shroom: mushroom, sig: signature, sneaks: sneaker, spag: spaghetti, spagbol: spaghetti,
    spud: potato, src: source, stat: statistics, steamyroom: sauna, sub: submarine,
    sunnies: sunglasses, synth: synthesizer, sys: system, tater: potato, tbl: table, tbone: steak,
    tech: technology, tee: t shirt, teeshirt: t shirt, tel: telephone, tele: television,
    telly: television, temp: temperature, thanksgiving: turkey, ticktacktoe: tic tac toe,
    ticktock: clock, tix: ticket, tjunction: junction, tmp: temperature, tnt: dynamite,
    togs: swimsuit, tp: toilet paper, trackies: trousers, trex: tyrannosaurus, trike: tricycle,
    tsquare: set square, tuktuk: auto rickshaw, tum: stomach, tummy: stomach, twopiece: bikini,
    tx: transaction, txn: transaction, txt: text, uboat: submarine, uke: ukulele,
    undies: underwear, uni: university, url: link, usd: dollar, usr: user, ute: pickup truck,
    util: tools, vac: vacuum cleaner, vacc: vaccine, valentineday: heart, valentinesday: heart,
    vax: vaccine, vcr: cassette, ver: version, vid: video, vino: wine, vol: volume,
    vsign: victory hand, walkietalky: walkie talkie, wellie: rubber boot, wellington: rubber boot,
    wellingtonboot: rubber boot, welly: rubber boot, wknd: weekend, womb: uterus, www: globe,
    xmas: christmas, yfront: underwear
    """
    )
)
"""What people type for short, or as they talk at home, in one word: two words are read as one."""

OTHER_IN_PLURAL = frozenset({"boxers", "glasses", "greens", "news"})
"""What is not several of what it is the plural of."""

BRANDS = words(
    """
    acer adidas adobe airbnb aldi asus audi bluesky bmw bosch canon chanel citroen colgate discord
    docker dotnet ebay etsy facebook fanta ferrari fiat firefox flickr github gitlab gucci
    google heineken honda huawei
    hulu hyundai ikea instagram intel jira kia lenovo levis lidl linkedin mastodon mercedes nestle
    netflix nike nikon nintendo nissan nokia nvidia opel paypal pepsi philips pinterest porsche
    prada reddit renault rolex safari samsung shein shopify siemens skoda skype slack snapchat sony
    spotify starbucks subaru telegram temu tesla threads tiktok toyota trello tumblr twitter
    uber vimeo volkswagen volvo walmart wechat weibo whatsapp xiaomi youtube zara zoom
    """
)
"""Brands: another word that is spelt like one is no hint."""

EVERYDAY = _listed(
    """
    花: flower, 꽃: flower, 車: car, 车: car, 차: car, 水: water, 물: water, 人: person, 月: moon,
    달: moon, 日: sun, 해: sun, 手: hand, 손: hand, 雪: snow, 茶: tea, 酒: wine, 肉: meat, 米: rice,
    石: stone, 川: river, 海: sea, 空: sky, 牛: cow, 豚: pig, 鶏: chicken, 虎: tiger, 竜: dragon,
    刀: sword, 靴: shoe, 鞋: shoe, 門: gate, 窗: window, 机: desk, 桌: table, 椅: chair, 灯: lamp,
    花火: fireworks, 筆: brush, 紙: paper, 纸: paper, 時計: clock, 電話: telephone, 葉: leaf,
    男: man, 女: woman, 孩子: child, うさぎ: rabbit, りんご: apple, 象: elephant, 책: book,
    بيت: house, buch: book, libro: book, livro: book, книга: book, كتاب: book, kitap: book,
    کتاب: book, macchina: car, машина: car, ماشین: car, baum: tree, arbol: tree, arbre: tree,
    albero: tree, arvore: tree, شجرة: tree, agac: tree, درخت: tree, pohon: tree, blume: flower,
    fleur: flower, cicek: flower, گل: flower, bunga: flower, stern: star, estrela: star,
    звезда: star, نجمة: star, ستاره: star, bintang: star, corazon: heart, cuore: heart,
    coracao: heart, сердце: heart, mao: hand, рука: hand, يد: hand, دست: hand, tangan: hand,
    mata: eye, ballon: ball, palla: ball, bola: ball, мяч: ball, توپ: ball, 球: ball, ボール: ball,
    공: ball, futbol: soccer, calcio: soccer, futebol: soccer, فوتبال: soccer, sepakbola: soccer,
    축구: soccer, apfel: apple, manzana: apple, pomme: apple, mela: apple, яблоко: apple,
    تفاحة: apple, elma: apple, سیب: apple, apel: apple, 사과: apple, strasse: road, carretera: road,
    route: road, strada: road, дорога: road, طريق: road, جاده: road, jalan: road, 路: road,
    道: road, 길: road, mond: moon, lua: moon, луна: moon, قمر: moon, ماه: moon, bulan: moon,
    月亮: moon, パン: bread, bateau: ship, aereo: plane, wasser: water, agua: water, acqua: water,
    вода: water, آب: water, livre: book, lune: moon, mano: hand, كرة القدم: soccer, eau: water,
    ねこ: cat, いぬ: dog, 小犬: dog, こいぬ: dog, 강아지: dog, とり: bird, さかな: fish,
    くるま: car, いえ: house, はな: flower, みず: water, つき: moon, ほし: star,
    やま: mountain, うみ: sea, 바다: sea, ほん: book, くつ: shoe, 신발: shoe,
    かさ: umbrella, とけい: clock, でんわ: telephone, 전화: telephone, じてんしゃ: bicycle,
    でんしゃ: train, ひこうき: airplane, ふね: ship, うま: horse, うし: cow, ぶた: pig,
    くま: bear, 곰: bear, さる: monkey, 아이: child, 커피: coffee, コーヒー: coffee,
    テーブル: table, ぞう: elephant, らいおん: lion, ライオン: lion, 사자: lion, とら: tiger,
    むし: insect, くも: cloud, ゆき: snow, 비: rain, あめ: rain, たいよう: sun, かぎ: key,
    えんぴつ: pencil, たまご: egg, おちゃ: tea, 개구리: frog, かえる: frog, へび: snake,
    かめ: turtle, ケーキ: cake, 케이크: cake, トラック: truck, 트럭: truck, ロボット: robot,
    로봇: robot, 手紙: letter, てがみ: letter, 편지: letter,
    einstellungen: settings, ajustes: settings, configuracion: settings, parametres: settings,
    reglages: settings, impostazioni: settings, configuracoes: settings, 設定: settings,
    设置: settings, 설정: settings, настроики: settings, instellingen: settings,
    ustawienia: settings, ayarlar: settings, installningar: settings, suche: search,
    suchen: search, buscar: search, busqueda: search, recherche: search, chercher: search,
    cerca: search, ricerca: search, pesquisar: search, busca: search, 検索: search, 搜索: search,
    검색: search, поиск: search, zoeken: search, szukaj: search, ara: search, sok: search,
    lupe: magnifying_glass, lupa: magnifying_glass, benutzer: user, nutzer: user, usuario: user,
    utilisateur: user, utente: user, ユーザー: user, 用户: user, 사용자: user, пользователь: user,
    gebruiker: user, uzytkownik: user, kullanici: user, kalender: calendar, プリンター: printer,
    プリンタ: printer, warenkorb: shopping_cart, carrito: shopping_cart, carrinho: shopping_cart,
    panier: shopping_cart, carrello: shopping_cart, カート: shopping_cart, 장바구니: shopping_cart,
    winkelwagen: shopping_cart, koszyk: shopping_cart, pfeil: arrow, flecha: arrow, fleche: arrow,
    freccia: arrow, 화살표: arrow, стрелка: arrow, pijl: arrow, strzalka: arrow, seta: arrow,
    nachricht: message, mensaje: message, messaggio: message, сообщение: message, bericht: message,
    correo: mail, courrier: mail, posta: mail, correio: mail, メール: mail, 邮件: mail, 메일: mail,
    почта: mail, herunterladen: download, descargar: download, telecharger: download,
    scaricare: download, baixar: download, 下载: download, ダウンロード: download,
    다운로드: download, скачать: download, hochladen: upload, subir: upload, televerser: upload,
    caricare: upload, speichern: save, guardar: save, enregistrer: save, salva: save, salvar: save,
    salvare: save, 保存: save, 저장: save, сохранить: save, loschen: trash, borrar: trash,
    eliminar: trash, supprimer: trash, elimina: trash, 削除: trash, 删除: trash, 삭제: trash,
    удалить: trash, mulleimer: trash, mull: trash, poubelle: trash, basura: trash, lixo: trash,
    spazzatura: trash, anmelden: log_in, connexion: log_in, accedi: log_in, entrar: log_in,
    startseite: home, accueil: home, inicio: home, ホーム: home, 홈: home, главная: home,
    huis: house, hus: house, dom: house, hogar: house, werkzeug: tool, herramienta: tool,
    outil: tool, attrezzo: tool, ferramenta: tool, 工具: tool, 도구: tool, инструмент: tool,
    candado: lock, cadenas: lock, lucchetto: lock, cadeado: lock, замок: lock, slot: lock,
    landkarte: map, mapa: map, mappa: map, carte: map, 地図: map, 地图: map, 지도: map, карта: map,
    kaart: map, standort: location, ubicacion: location, emplacement: location,
    posizione: location, localizacao: location, rechner: computer, ordenador: computer,
    ordinateur: computer, コンピューター: computer, 电脑: computer, 컴퓨터: computer,
    компьютер: computer, sleutel: key, klucz: key, nyckel: key, anahtar: key, fiets: bicycle,
    rower: bicycle, cykel: bicycle, bil: car, coche: car, teller: plate, vis: screw,
    schraube: screw, lit: bed, abbrechen: cancel, annuler: cancel, annulla: cancel,
    取消: cancel, キャンセル: cancel, отмена: cancel, zuruck: back, volver: back, retour: back,
    indietro: back, voltar: back, 戻る: back, 返回: back, назад: back, weiter: next,
    siguiente: next, suivant: next, avanti: next, 次へ: next, далее: next, drucken: print,
    imprimir: print, imprimer: print, stampa: print, 印刷: print, 打印: print, печать: print,
    hilfe: help, ayuda: help, aide: help, aiuto: help, ajuda: help, ヘルプ: help, 帮助: help,
    schliessen: close, cerrar: close, fermer: close, chiudi: close, fechar: close,
    rechercher: search
    """
)
"""Words of other languages, without accents, that no emoji is called by, or something else."""
