"""The exceptions that a user gets to read."""


class IconstudioError(Exception):
    """A mistake in the input or a limit of the machine, said in a sentence for the user.

    ``str(error)`` says what is wrong and what to do about it. The command line
    prints it and exits with code 2; the window shows it and goes on.
    """


class SpriteError(IconstudioError):
    """A file holds several drawings and shows none by itself: one is to be chosen by its name.

    ``what`` says so; ``advice``, how to choose one where files are named in words.
    """

    def __init__(self, what: str, names: tuple[str, ...], advice: str = "") -> None:
        super().__init__(what, names, advice)
        self.what, self.names, self.advice = what, names, advice

    def __str__(self) -> str:
        return f"{self.what} {self.advice}".strip()


class BitmapError(IconstudioError):
    """A drawing shows nothing but bitmaps that it holds, which can be read in its place.

    ``what`` says so; ``bitmap`` are the bytes of a file, and ``remark`` says that it was read.
    """

    def __init__(self, what: str, bitmap: bytes, remark: str) -> None:
        super().__init__(what, bitmap, remark)
        self.what, self.bitmap, self.remark = what, bitmap, remark

    def __str__(self) -> str:
        return self.what
