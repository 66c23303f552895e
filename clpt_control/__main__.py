"""`python -m clpt_control` is `clpt`."""

from .app.cli import main

if __name__ == "__main__":
    main()
