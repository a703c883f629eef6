from html import escape
from pathlib import Path

from IPython.display import HTML

# two-cuts.html lies beside the notebook; afterwards it is part of it.
page = escape(Path("two-cuts.html").read_text(encoding="utf-8"))
HTML(f'<iframe srcdoc="{page}" sandbox="allow-scripts" width="100%" height="760"></iframe>')
