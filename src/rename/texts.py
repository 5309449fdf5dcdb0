#!/usr/bin/env python3
"""Renames in text what Rename.java renamed in code: strings, comments, documents, scripts, configuration.

texts.py ROOT MAP.tsv [--write]; MAP as Rename.java takes it (kind, old, new). Run it after Rename.java.

- qualified names are replaced everywhere;
- a simple name of two words or more (LegPursuit) that no type has any more is replaced everywhere;
- a simple name of one word (Helm) only between backticks, and in {@code ...} and {@link ...};
- NewType.member and NewType#member follow the members' renames.
Recorded results (benchmarks/*.csv), NOTICE, LICENSE and this folder stay as they are.
"""
import os, re, subprocess, sys

root, table = sys.argv[1], sys.argv[2]
write = '--write' in sys.argv
types, packages, members = {}, {}, {}
for line in open(table):
    cell = line.rstrip('\n').split('\t')
    if len(cell) < 3 or line.startswith('#'):
        continue
    kind, old, new = (c.strip() for c in cell[:3])
    if kind in ('type', 'nested'):
        types[old] = new if '.' in new else old.rsplit('.', 1)[0] + '.' + new
    elif kind == 'package':
        packages[old] = new
    elif kind in ('method', 'field', 'enum', 'component') and '#' in old:
        members[tuple(old.split('#', 1))] = new

files = subprocess.run(['git', '-C', root, 'ls-files', '-z'], capture_output=True, text=True).stdout.split('\0')
skip = re.compile(r'^(benchmarks/.*\.csv|NOTICE|LICENSE|src/rename/.*|docs/reference/renamed\.md|.*\.(png|svg|log|bin))$')
files = [f for f in files if f and not skip.match(f) and os.path.isfile(os.path.join(root, f))]

declared = set()
for f in files:
    if f.endswith('.java'):
        for m in re.finditer(r'\b(?:class|interface|enum|record)\s+(\w+)', open(os.path.join(root, f)).read()):
            declared.add(m.group(1))


def moved(fqn):
    """The new qualified name, with its package's rename."""
    for old, new in packages.items():
        if fqn.startswith(old + '.'):
            return new + fqn[len(old):]
    return fqn


qualified = {}
for old, new in types.items():
    qualified[old] = moved(new)
    outer, name = old.rsplit('.', 1)
    qualified[outer + '$' + name] = moved(new).rsplit('.', 1)[0] + '$' + new.rsplit('.', 1)[1]
for old, new in packages.items():
    qualified[old] = new
simple = {}
for old, new in types.items():
    o, n = old.rsplit('.', 1)[1], new.rsplit('.', 1)[1]
    if o != n and o not in declared:
        simple.setdefault(o, set()).add(n)
for o in [o for o, n in simple.items() if len(n) > 1]:
    print('AMBIGUOUS', o, sorted(simple.pop(o)))
simple = {o: n.pop() for o, n in simple.items()}
many = {o: n for o, n in simple.items() if re.fullmatch(r'[A-Z][a-z0-9]+(?:[A-Z][A-Za-z0-9]*)', o)}
single = {o: n for o, n in simple.items() if o not in many}
FQN = re.compile(r'(?<![\w.])(' + '|'.join(sorted(map(re.escape, qualified), key=len, reverse=True)) + r')(?![\w])') if qualified else None
MANY = re.compile(r'\b(' + '|'.join(sorted(many, key=len, reverse=True)) + r')\b') if many else None
SINGLE = re.compile(r'\b(' + '|'.join(sorted(single, key=len, reverse=True)) + r')\b') if single else None
SPAN = re.compile(r'`[^`\n]+`|\{@(?:code|link|linkplain) [^}]*\}')
by_type = {}
for (owner, name), new in members.items():
    t = types.get(owner, owner).rsplit('.', 1)[1]
    by_type.setdefault((t, name), new)
MEMBER = re.compile(r'\b([A-Z]\w*)([.#])([a-z]\w*)\b')
count = 0
for f in files:
    path = os.path.join(root, f)
    try:
        text = open(path, encoding='utf-8', newline='').read()
    except UnicodeDecodeError:
        continue
    new = text
    if FQN:
        new = FQN.sub(lambda m: qualified[m.group(1)], new)
    if MANY:
        new = MANY.sub(lambda m: many[m.group(1)], new)
    if SINGLE:
        new = SPAN.sub(lambda s: SINGLE.sub(lambda m: single[m.group(1)], s.group()), new)
    new = MEMBER.sub(lambda m: m.group(1) + m.group(2) + by_type.get((m.group(1), m.group(3)), m.group(3)), new)
    if new != text:
        count += 1
        print('TEXT', f, sum(a != b for a, b in zip(text.splitlines(), new.splitlines())))
        if write:
            open(path, 'w', encoding='utf-8', newline='').write(new)
print(count, 'files')
