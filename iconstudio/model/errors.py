"""The one exception that a user gets to read."""


class IconstudioError(Exception):
    """A mistake in the input or a limit of the machine, said in a sentence for the user.

    ``str(error)`` says what is wrong and what to do about it. The command line
    prints it and exits with code 2; the window shows it and goes on.
    """
