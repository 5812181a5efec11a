"""Which drawings are logos of brands, though they are called as a thing is: told by eye.

The collection is built without the logos that names, categories and looks tell (``selection``). Of
what is left under the names that sets of logos have, these are logos: an apple with a bite taken,
the compass of a browser. Who looks for the thing does not mean them, so they are left out, too.
"""

from collections.abc import Mapping

_LOGOS: Mapping[str, str] = {
    "akar-icons": "linkedin-box-fill",
    "ant-design": "code-sandbox-circle-filled code-sandbox-square-filled medium-circle-filled "
    "medium-workmark-outlined perplexity-filled sketch-circle-filled sketch-square-filled "
    "wechat-work-filled wechat-work-outlined yahoo-outlined",
    "bi": "bootstrap browser-chrome browser-edge browser-firefox browser-safari perplexity "
    "threads-fill",
    "ei": "sc-telegram",
    "formkit": "stripe tether visa",
    "garden": "messenger-stroke-16",
    "gg": "sketch",
    "griddy-icons": "mastodon messenger notion telegram-filled twitch",
    "grommet-icons": "node pied-piper visa",
    "hugeicons": "apple-finder apple-intelligence apple-reminder apple-stocks blogger bluesky "
    "copilot java java-script kickstarter-01 kickstarter-02 mastodon medium notion-01 notion-02 "
    "periscope telegram threads-ellipse threads-rectangle vine vine-square wise",
    "ic": "baseline-adobe baseline-polymer",
    "iconoir": "apple-mac apple-shortcuts apple-shortcuts-solid apple-swift apple-wallet "
    "behance-tag mastercard-card mastodon medium pocket safari telegram",
    "icons8": "stripe visa",
    "ix": "java-script java-script-connection",
    "jam": "apple-circle apple-square blogger-circle blogger-square medium-circle opera-circle "
    "opera-square periscope periscope-circle periscope-square vine vine-circle vine-square yahoo "
    "yahoo-circle yahoo-square",
    "la": "blackberry black-tie blogger bootstrap buffer cuttlefish docker fly java kickstarter "
    "mix node opera periscope pied-piper rebel safari swift telegram yarn",
    "lineicons": "azure bootstrap-5-square canva copilot ford oculus yahoo zoom",
    "mage": "threads-square",
    "meteor-icons": "apple",
    "mingcute": "apple-intelligence-fill apple-intelligence-frame-fill "
    "apple-intelligence-frame-line copilot-fill copilot-line dogecoin-doge-fill medium-line "
    "perplexity-line telegram-line tether-usdt-fill tether-usdt-line trello-board-fill "
    "trello-board-line viber-messenger-fill viber-messenger-line visa-fill yahoo-fill yahoo-line",
    "mynaui": "pocket telegram",
    "raphael": "safari windows",
    "si": "apple-line",
    "stash": "pix telegram",
    "streamline": "adobe adobe-remix adobe-solid apple telegram windows",
    "streamline-cyber": "batman",
    "streamline-flex": "apple dribble-solid",
    "tdesign": "opera",
    "teenyicons": "apple-outline c-sharp-outline docker-outline edge-outline firebase-outline "
    "git-outline messenger-outline opera-outline ripple-outline rust-outline rust-solid "
    "safari-outline telegram-outline typescript-outline vim-outline vim-solid windows-outline",
    "wpf": "maestro",
}

LOGOS = frozenset(f"{prefix}:{name}" for prefix, names in _LOGOS.items() for name in names.split())
"""Their identifiers."""
