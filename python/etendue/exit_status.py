"""What the command line ends with, besides 0; 1 is an error, 2 wrong usage."""

#: Pictures differ, or a prediction fails: the command worked, and this is what it found.
DIFFERENT = 3
#: 128 + SIGINT, as shells have it.
INTERRUPTED = 130
