"""The exceptions that a user gets to read."""


class IconstudioError(Exception):
    """A mistake in the input or a limit of the machine, said in a sentence for the user.

    ``str(error)`` says what is wrong and what to do about it. The command line
    prints it and exits with code 2; the window shows it and goes on.
    """


class SpriteError(IconstudioError):
    """A file holds several drawings and shows none by itself: one is to be chosen by its name."""

    def __init__(self, message: str, names: tuple[str, ...]) -> None:
        super().__init__(message, names)
        self.names = names

    def __str__(self) -> str:
        return str(self.args[0])
