"""The part of a documentation page that a program writes: between <!-- begin: NAME --> and <!-- end: NAME -->."""


def write(page, name, text):
    begin, end = f"<!-- begin: {name} -->\n", f"<!-- end: {name} -->\n"
    with open(page) as file:
        whole = file.read()
    before, rest = whole.split(begin)
    _, after = rest.split(end)
    with open(page, "w") as file:
        file.write(before + begin + text + end + after)
