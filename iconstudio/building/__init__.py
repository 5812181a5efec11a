"""Building the collection that comes with the program; nothing else imports this."""
